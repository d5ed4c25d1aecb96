/* Requests of OB 80 and OB 85, and OBs that are missing. */
#include "internal.h"

enum { EVENT_OVERFLOW = 0x3507 };

static struct s7cpu_request error(const struct s7cpu *cpu, int ob, int flt_id)
{
    struct s7cpu_request r = s7_request(cpu, ob, s7cpu_clock(cpu));
    r.info.flt_id = flt_id;
    return r;
}

/* The cause of a time error: the OB that was requested; on an S7-1500 the OB that was being processed
 * and no event [T15-132] (AMB-27). */
static void blame(const struct s7cpu *cpu, struct s7cpu_request *r, int ob)
{
    if (!s7_family(cpu)->names_running) {
        r->info.ev = s7_ob_start_event(ob);
        r->info.ev_ob = ob;
    } else if (r->info.csg_ob != 0) {
        r->info.ev_ob = r->info.csg_ob > 254 ? 0xFF : r->info.csg_ob; /* [T15-133] */
    }
}

void s7_error_overlap(struct s7cpu *cpu, int ob, int z1)
{
    struct s7cpu_request r = error(cpu, 80, FLT_OVERLAP);
    const bool each_time = !s7_family(cpu)->has_queues || s7_ob_kind(ob) == OB_DELAY; /* [T15-36] */
    if (cpu->overloaded[ob] && !each_time)
        return; /* [T15-73], A15-15, reading a */
    cpu->overloaded[ob] = true;
    r.info.error_info = z1;
    blame(cpu, &r, ob);
    s7_time_error(cpu, &r);
}

/* AMB-16, reading a: with the clock after the change. */
void s7_error_skipped(struct s7cpu *cpu, int flt_id, unsigned late)
{
    struct s7cpu_request r = error(cpu, 80, flt_id);
    r.keeps_time = true;
    r.info.error_info = (int)(late & 0xFF); /* OB 10 to 17 only [T15-92] */
    s7_time_error(cpu, &r);
}

/* No OB 80 (A15-03, reading a), and once until all its events are processed (A15-06, reading a). */
static void report_overflow(struct s7cpu *cpu, int ob)
{
    if (s7_queue_of(cpu, ob).overflow == 1 && !cpu->overflowed[ob])
        s7_emit_diag(cpu, EVENT_OVERFLOW, S7CPU_NONE, NULL);
    cpu->overflowed[ob] = true;
    cpu->discarded[ob]++;
}

void s7_error_overflow(struct s7cpu *cpu, int ob)
{
    struct s7cpu_request r = error(cpu, 80, FLT_OVERFLOW);
    if (s7_family(cpu)->has_queues) {
        report_overflow(cpu, ob);
        return;
    }
    blame(cpu, &r, ob);
    r.rank = r.info.priority = s7_family(cpu)->upper_class; /* AMB-13, reading d */
    s7_time_error(cpu, &r);
}

/* AMB-49, either: under SFC 41 too (reading a) [AIRT-11], or when the delay ends (b). */
bool s7_missing_is_noticed(const struct s7cpu *cpu)
{
    return !(s7_airt_delays(cpu) && cpu->config.choices.stop_waits_for_delay);
}

void s7_error_missing_async(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    if (s7_family(cpu)->ignores_missing && r->info.flt_id != FLT_CYCLE_TIME)
        return;
    switch (r->ob) {
    case 80:
        s7_stop(cpu, CAUSE_OB80_MISSING);
        break;
    case 85:
        s7_stop(cpu, CAUSE_OB85_MISSING);
        break;
    case 82:
    case 83:
    case 86:
        s7_stop(cpu, CAUSE_NONE);
        break;
    default: /* OB 81, 84, 87: nothing (AMB-75, reading a; OB 84: either) */
        break;
    }
}

/* AMB-45, either: one OB 85 for each missing OB (reading b). AMB-28, either: A2 where an SFC or
 * the configuration has started the OB, else A1. */
static void priority_class_error(struct s7cpu *cpu, int missing)
{
    if (!s7cpu_ob_exists(cpu->config.family, 85))
        return; /* [T15-113] */
    bool by_sfc = s7_ob_kind(missing) == OB_TOD || s7_ob_kind(missing) == OB_DELAY;
    struct s7cpu_request r = error(cpu, 85, by_sfc ? FLT_MISSING_BY_SFC : FLT_MISSING);
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    r.info.ev = s7_ob_start_event(missing);
    r.info.ev_ob = top != NULL ? top->ob : S7CPU_NONE; /* the OB active at the error */
    s7_diag_error(cpu, &r);
    if (s7_irt_blocks(cpu, 85))
        return; /* AMB-33, reading a: disabled is not missing */
    if (cpu->loaded[85])
        s7_queue_put(cpu, &r);
    else
        s7_stop(cpu, CAUSE_OB85_MISSING); /* [OBS-21] */
}

void s7_error_missing(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    switch (s7_ob_kind(r->ob)) {
    case OB_ASYNC_ERROR:
        s7_error_missing_async(cpu, r); /* deleted while it waited (AMB-66) */
        break;
    case OB_REDUNDANCY: /* AMB-75, reading a */
        break;
    case OB_TOD:
        s7_tod_missed(cpu, r->ob, r->info.time);
        priority_class_error(cpu, r->ob);
        break;
    default:
        priority_class_error(cpu, r->ob);
        break;
    }
}

/* At once, on top of the OB that failed and in its class, or its own (A15-23, reading a), whatever
 * SFC 39 and 41 say. AMB-85, either: inside an error OB the other one is called, the same one stops
 * the CPU (reading a). */
void s7_error_synchronous(struct s7cpu *cpu, int ob)
{
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    if (top == NULL || !s7_time_runs(cpu))
        return; /* no instruction that fails */
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_INTERRUPT, .ob = ob, .flt_id = S7CPU_NONE});
    if (!cpu->loaded[ob] && ob == 122 && s7_family(cpu)->ignores_missing)
        return;
    if (!cpu->loaded[ob] || top->ob == ob || cpu->depth == S7CPU_DEPTH) {
        s7_stop(cpu, ob == 121 ? CAUSE_OB121_MISSING : CAUSE_OB122_MISSING);
        return;
    }
    struct s7cpu_request r = s7_request(cpu, ob, s7cpu_clock(cpu));
    if (r.rank == 0)
        r.rank = r.info.priority = top->rank;
    s7_start(cpu, &r);
}

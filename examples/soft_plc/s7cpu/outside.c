/* The clock is set, start events reach the CPU, blocks come and go. */
#include "internal.h"

void s7cpu_set_clock(struct s7cpu *cpu, int64_t to)
{
    const int64_t before = s7cpu_clock(cpu);
    const enum s7cpu_mode mode = cpu->mode;
    if (to < 0 || to > S7CPU_LAST)
        return;
    s7_tod_poll(cpu); /* what is due in this millisecond has been reached, not skipped */
    if (cpu->mode != mode)
        return; /* an overlap without OB 80 has stopped the CPU */
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_CLOCK, .to = to});
    cpu->offset = to - cpu->up;
    s7_tod_clock_changed(cpu, before);
}

void s7cpu_set_zone(struct s7cpu *cpu, int64_t zone, bool daylight)
{
    const enum s7cpu_mode mode = cpu->mode;
    const int64_t before = cpu->zone;
    if (!s7cpu_has_local_time(cpu->config.family))
        return;
    s7_tod_poll(cpu);
    if (cpu->mode != mode)
        return;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_ZONE, .zone = zone, .daylight = daylight});
    cpu->zone = zone;
    s7_tod_zone_changed(cpu, zone - before);
}

static void enqueue(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    const bool overloads = s7_family(cpu)->has_queues && s7_queue_overloads(cpu, r->ob);
    if (s7_queue_is_full(cpu, r))
        s7_error_overflow(cpu, r->ob); /* [OBS-08, T15-69]: the new request is lost */
    else
        s7_queue_put(cpu, r);
    if (overloads) /* its event came first [T15-73] */
        s7_error_overlap(cpu, r->ob, S7CPU_NONE);
}

/* AMB-77, either: an OB that is requested again while it runs is buffered and runs again, without
 * OB 80 (reading b). AMB-67, either: an event that comes in STARTUP or HOLD is kept until RUN
 * (reading a); only OB 80 to 87 run in STARTUP [OBS-43]. */
void s7cpu_interrupt(struct s7cpu *cpu, int ob, int flt_id)
{
    if (s7_ob_kind(ob) == OB_SYNC_ERROR) {
        s7_error_synchronous(cpu, ob);
        return;
    }
    if (cpu->mode == S7CPU_STOP)
        return; /* outputs and modules are disabled: nothing reaches the CPU [OBS-41] */
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_INTERRUPT, .ob = ob, .flt_id = flt_id});
    struct s7cpu_request r = s7_request(cpu, ob, s7cpu_clock(cpu));
    r.info.flt_id = flt_id;
    if (flt_id != S7CPU_NONE)
        s7_diag_error(cpu, &r);
    if (s7_irt_blocks(cpu, ob))
        return;
    if (!cpu->loaded[ob] && s7_ob_kind(ob) == OB_ASYNC_ERROR && cpu->mode != S7CPU_HOLD &&
        s7_missing_is_noticed(cpu))
        s7_error_missing_async(cpu, &r);
    else if (ob == 80 && flt_id == FLT_CYCLE_TIME && s7_cycle_exceeded_again(cpu))
        s7_stop(cpu, CAUSE_OB80_MISSING); /* [OBS-26]; SFC 41 does not delay it [AIRT-11] */
    else
        enqueue(cpu, &r);
}

void s7cpu_read_state(struct s7cpu *cpu, int ob, struct s7cpu_state *state)
{
    *state = s7_state(cpu, ob);
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_STATE, .ob = ob, .state = state});
}

/* AMB-66: an OB that runs goes on, one that waits will be missing. */
static void set_loaded(struct s7cpu *cpu, int ob, bool loaded)
{
    if (!loaded && !cpu->loaded[ob])
        return; /* a loaded block may be loaded again */
    cpu->loaded[ob] = loaded;
    s7_emit(cpu, (struct s7cpu_event){.kind = loaded ? S7CPU_LOAD : S7CPU_DELETE, .ob = ob});
}

void s7cpu_load(struct s7cpu *cpu, int ob)
{
    set_loaded(cpu, ob, true);
}

void s7cpu_delete(struct s7cpu *cpu, int ob)
{
    set_loaded(cpu, ob, false);
}

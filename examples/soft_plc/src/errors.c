#include "errors.h"

#include "diag.h"
#include "events.h"
#include "irt.h"
#include "modes.h"
#include "tod.h"

/* Under SFC 39 there is neither OB 80 nor STOP, and what was late still runs (AMB-23, reading a;
 * AMB-48, either: reading a). AMB-49, either: a time error without OB 80 stops the CPU at once,
 * delayed or not (reading a) [CLK-05, OBS-22, AIRT-11]. */
static void time_error(struct cpu *cpu, const struct request *r)
{
    diag_error(cpu, r);
    if (irt_blocks(cpu, 80))
        return;
    if (cpu->loaded[80])
        events_put(cpu, r);
    else if (!cpu_fault(cpu, FAULT_MISSING_OB80_RUNS_ON))
        modes_stop(cpu, CAUSE_OB80_MISSING);
}

void errors_overlap(struct cpu *cpu, int ob, int z1)
{
    struct request r = events_request(cpu, 80, cpu_now(cpu));
    r.info.flt_id = 0x02;
    r.info.error_info = z1;
    r.info.ev = ob_start_event(ob);
    r.info.ev_ob = ob; /* AMB-27: the OB that was requested */
    time_error(cpu, &r);
}

void errors_skipped(struct cpu *cpu, int flt_id, unsigned late, dt_ms before)
{
    /* AMB-16, reading a: the clock after the change */
    struct request r =
        events_request(cpu, 80, cpu_fault(cpu, FAULT_SKIP_TIME) ? before : cpu_now(cpu));
    r.info.flt_id = flt_id;
    r.info.error_info = (int)(cpu_fault(cpu, FAULT_SKIP_MASK) ? late << 1 : late);
    if (cpu_fault(cpu, FAULT_CATCH_UP_FIRST))
        r.rank = cpu_class(cpu, TOD_FIRST);
    time_error(cpu, &r);
}

void errors_overflow(struct cpu *cpu, int ob)
{
    struct request r = events_request(cpu, 80, cpu_now(cpu));
    if (!cpu_fault(cpu, FAULT_OVERFLOW_CLASS))
        r.rank = r.info.priority = 28; /* AMB-13, reading d */
    r.info.flt_id = 0x07;
    r.info.ev = ob_start_event(ob);
    r.info.ev_ob = ob;
    time_error(cpu, &r);
}

void errors_missing_async(struct cpu *cpu, int ob)
{
    switch (ob) {
    case 80:
        if (!cpu_fault(cpu, FAULT_MISSING_OB80_RUNS_ON))
            modes_stop(cpu, CAUSE_OB80_MISSING);
        break;
    case 85:
        if (!cpu_fault(cpu, FAULT_MISSING_OB85_RUNS_ON))
            modes_stop(cpu, CAUSE_OB85_MISSING);
        break;
    case 82:
    case 83:
    case 86:
        if (!cpu_fault(cpu, FAULT_ASYNC_RUNS_ON))
            modes_stop(cpu, CAUSE_NONE); /* [OBS-23] */
        break;
    default: /* OB 81, 84, 87: nothing (AMB-75, reading a; OB 84: either) */
        break;
    }
}

/* AMB-45, either: one OB 85 for each missing OB (reading b). */
static void priority_class_error(struct cpu *cpu, const struct request *missing)
{
    struct request r = events_request(cpu, 85, cpu_now(cpu));
    const struct frame *top = cpu_top(cpu);
    /* AMB-28, either: A2 where an SFC or the configuration has started the OB, else A1. */
    bool by_sfc = ob_is_tod(missing->ob) || ob_kind(missing->ob) == OB_DELAY;
    r.info.flt_id = by_sfc ? 0xA2 : 0xA1;
    r.info.ev = ob_start_event(missing->ob);
    r.info.ev_ob = top != NULL ? top->ob : 1; /* the OB active at the error */
    diag_error(cpu, &r);
    if (irt_blocks(cpu, 85))
        return; /* AMB-33, reading a: disabled is not missing */
    if (cpu->loaded[85])
        events_put(cpu, &r);
    else if (!cpu_fault(cpu, FAULT_MISSING_OB85_RUNS_ON))
        modes_stop(cpu, CAUSE_OB85_MISSING); /* [OBS-21] */
}

void errors_missing(struct cpu *cpu, const struct request *r)
{
    if (ob_is_tod(r->ob))
        tod_called(cpu, r->ob); /* AMB-46: periodic stays active, once is used up */
    if (ob_kind(r->ob) == OB_ASYNC_ERROR) {
        errors_missing_async(cpu, r->ob); /* deleted while it waited (AMB-66) */
        return;
    }
    if (ob_kind(r->ob) == OB_REDUNDANCY || cpu_fault(cpu, FAULT_MISSING_SILENT))
        return; /* AMB-75, reading a */
    priority_class_error(cpu, r);
}

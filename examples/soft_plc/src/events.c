#include "events.h"

#include "diag.h"
#include "errors.h"
#include "irt.h"
#include "modes.h"

struct request events_request(const struct cpu *cpu, int ob, dt_ms time)
{
    int class = cpu_class(cpu, ob);
    struct request r = {.ob = ob, .rank = class};
    r.info = (struct start_info){.priority = class,
                                 .strt_info = ob_strt_info(ob),
                                 .period = -1,
                                 .sign = -1,
                                 .dtime = -1,
                                 .flt_id = -1,
                                 .error_info = -1,
                                 .ev = -1,
                                 .ev_ob = -1,
                                 .time = time};
    return r;
}

void events_put(struct cpu *cpu, const struct request *r)
{
    const struct frame *top = cpu_top(cpu);
    if (cpu_fault(cpu, FAULT_AIRT_LOSES) && cpu->delay_count > 0 && top != NULL &&
        r->rank > top->rank)
        return;
    if (!queue_put(&cpu->queue, r))
        modes_stop(cpu, CAUSE_CLASS_SYSTEM);
}

/* Requests that a class holds: those that wait, and those whose OB is not at its end [OBS-07]. */
static int held(const struct cpu *cpu, int rank)
{
    int n = queue_count_rank(&cpu->queue, rank);
    for (int i = 0; i < cpu->depth; i++)
        n += cpu->stack[i].rank == rank;
    return n;
}

/* AMB-77, either: an OB that is requested again while it runs is buffered and runs again,
 * without OB 80 (reading b). AMB-67, either: an event that comes in STARTUP or HOLD is kept
 * until RUN (reading a); only OB 80 to 87 run in STARTUP [OBS-43]. */
void events_interrupt(struct cpu *cpu, int ob, int flt_id)
{
    if (cpu->mode == MODE_STOP)
        return; /* outputs and modules are disabled: nothing reaches the CPU [OBS-41] */
    log_interrupt(cpu->log, cpu, ob, flt_id);
    struct request r = events_request(cpu, ob, cpu_now(cpu));
    r.info.flt_id = flt_id;
    if (flt_id >= 0)
        diag_error(cpu, &r);
    if (irt_blocks(cpu, ob))
        return;
    if (!cpu->loaded[ob] && ob_kind(ob) == OB_ASYNC_ERROR && cpu->mode != MODE_HOLD)
        errors_missing_async(cpu, ob);
    else if (ob != 80 && held(cpu, r.rank) >= cpu->config.buffer)
        errors_overflow(cpu, ob); /* [OBS-08]: the new request is lost */
    else
        events_put(cpu, &r);
}

#include "scheduler.h"

#include "airt.h"
#include "errors.h"
#include "events.h"
#include "irt.h"
#include "tod.h"

/* OBs that start in STARTUP by mistake. */
static bool runs_early(const struct cpu *cpu, int ob)
{
    return (ob_is_tod(ob) && cpu_fault(cpu, FAULT_STARTUP_RUNS_TOD)) ||
           (ob_kind(ob) == OB_DELAY && cpu_fault(cpu, FAULT_STARTUP_RUNS_DINT));
}

/* In STARTUP only OB 80 to 87 may run beside the startup OB [OBS-42 to OBS-44, TINT-13]. */
static bool mode_allows(const struct cpu *cpu, int ob)
{
    if (cpu->mode == MODE_RUN)
        return true;
    return cpu->mode == MODE_STARTUP &&
           (ob_kind(ob) == OB_ASYNC_ERROR || runs_early(cpu, ob));
}

/* Only a strictly higher class interrupts [OBS-01, OBS-02], and nothing a delayed OB. */
static bool may_start(const struct cpu *cpu, const struct request *r)
{
    if (!mode_allows(cpu, r->ob) || irt_holds(cpu, r->ob))
        return false;
    if (cpu->depth == 0)
        return true;
    int running = cpu->stack[cpu->depth - 1].rank;
    if (cpu->depth == STACK_DEPTH || airt_delays(cpu, r->ob))
        return false;
    if (cpu->mode == MODE_STARTUP && runs_early(cpu, r->ob))
        return running == cpu_class(cpu, 100);
    return r->rank > running ||
           (r->rank == running && ob_is_tod(r->ob) && !cpu_is_running(cpu, r->ob) &&
            cpu_fault(cpu, FAULT_EQUAL_PREEMPTS));
}

/* The highest class, within it the oldest request [OBS-02, OBS-03]; -1 where none may start. */
static int choose(const struct cpu *cpu)
{
    const struct queue *q = &cpu->queue;
    int best = -1;
    for (int i = 0; i < q->length; i++) {
        if (!may_start(cpu, &q->items[i]))
            continue;
        if (best < 0 || q->items[i].rank > q->items[best].rank ||
            (q->items[i].rank == q->items[best].rank && cpu_fault(cpu, FAULT_LIFO)))
            best = i;
    }
    return best;
}

bool scheduler_dispatch(struct cpu *cpu)
{
    int i = cpu->queue.length > 0 ? choose(cpu) : -1;
    if (i < 0)
        return false;
    struct request r = cpu->queue.items[i];
    queue_remove(&cpu->queue, i);
    /* AMB-06 and AMB-44: a missing OB is noticed when it would be called. */
    if (cpu->loaded[r.ob])
        scheduler_start(cpu, &r);
    else
        errors_missing(cpu, &r);
    return true;
}

static void push(struct cpu *cpu, int ob, int rank)
{
    struct frame *f = &cpu->stack[cpu->depth++];
    *f = (struct frame){
        .ob = ob, .rank = rank, .run = ++cpu->runs[ob], .began = cpu->clock.up};
    cpu->program->begin(cpu->program, cpu, f);
}

void scheduler_start(struct cpu *cpu, const struct request *r)
{
    if (ob_is_tod(r->ob))
        tod_called(cpu, r->ob);
    log_start(cpu->log, cpu, r->ob, &r->info);
    push(cpu, r->ob, r->rank);
}

void scheduler_enter(struct cpu *cpu, int ob)
{
    push(cpu, ob, cpu_class(cpu, ob));
}

void scheduler_start_cycle(struct cpu *cpu)
{
    if (cpu->config.log_cycle) {
        struct request r = events_request(cpu, 1, cpu_now(cpu));
        log_start(cpu->log, cpu, 1, &r.info);
    }
    scheduler_enter(cpu, 1);
}

void scheduler_end(struct cpu *cpu)
{
    int ob = cpu_top(cpu)->ob;
    if (ob != 1 || cpu->config.log_cycle)
        log_end(cpu->log, cpu, ob);
    cpu->depth--;
    airt_ob_ended(cpu);
    irt_ob_ended(cpu);
}

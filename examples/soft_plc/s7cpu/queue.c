/* Start events that wait for their OB, in the order in which they happened [OBS-07]. */
#include <string.h>

#include "internal.h"

struct s7cpu_request s7_request(const struct s7cpu *cpu, int ob, int64_t time)
{
    const int class = s7_ob_class(cpu, ob);
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    struct s7cpu_request r = {.ob = ob,
                                  .rank = class,
                                  .stops = ob == 80 && !cpu->loaded[ob] &&
                                           cpu->mode != S7CPU_HOLD,
                                  .up = cpu->up,
                                  .info = {.priority = class,
                                           .strt_info = s7_ob_strt_info(ob),
                                           .period = S7CPU_NONE,
                                           .sign = S7CPU_NONE,
                                           .dtime = S7CPU_NONE,
                                           .flt_id = S7CPU_NONE,
                                           .error_info = S7CPU_NONE,
                                           .ev = S7CPU_NONE,
                                           .ev_ob = S7CPU_NONE,
                                           .time = time,
                                           .caught_up = S7CPU_NONE,
                                           .second_time = S7CPU_NONE,
                                           .csg_ob = S7CPU_NONE,
                                           .csg_priority = S7CPU_NONE,
                                           .event_count = S7CPU_NONE}};
    if (ob == 80) { /* [T15-132] */
        r.info.csg_ob = top != NULL ? s7cpu_ob_number(&cpu->config, top->ob) : 0;
        r.info.csg_priority = top != NULL ? top->rank : 0;
    }
    if (s7_ob_kind(ob) == OB_CYCLIC)
        r.info.event_count = cpu->discarded[ob]; /* of the next new event [T15-70] */
    return r;
}

void s7_queue_put(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    if (cpu->queue_length == S7CPU_WAITING) {
        s7_stop(cpu, CAUSE_CLASS_SYSTEM);
        return;
    }
    if (!s7_queue_has(cpu, r->ob) && !s7_ob_is_running(cpu, r->ob))
        cpu->overloaded[r->ob] = cpu->overflowed[r->ob] = false; /* all earlier events have been processed */
    cpu->queue[cpu->queue_length++] = *r;
    cpu->discarded[r->ob] = 0;
}

struct s7cpu_request s7_queue_take(struct s7cpu *cpu, int index)
{
    const struct s7cpu_request r = cpu->queue[index];
    cpu->queue_length--;
    memmove(&cpu->queue[index], &cpu->queue[index + 1],
            (size_t)(cpu->queue_length - index) * sizeof cpu->queue[0]);
    return r;
}

void s7_queue_withdraw(struct s7cpu *cpu, int ob)
{
    for (int i = cpu->queue_length - 1; i >= 0; i--)
        if (cpu->queue[i].ob == ob)
            s7_queue_take(cpu, i);
}

static int waiting(const struct s7cpu *cpu, int ob)
{
    int n = 0;
    for (int i = 0; i < cpu->queue_length; i++)
        n += cpu->queue[i].ob == ob;
    return n;
}

bool s7_queue_has(const struct s7cpu *cpu, int ob)
{
    return waiting(cpu, ob) > 0;
}

/* A15-14, reading a: one event waits, and a second one of OB 10 to 23 is a time error. Hardware
 * interrupts of several channels are kept [T15-80]. */
struct s7cpu_queue s7_queue_of(const struct s7cpu *cpu, int ob)
{
    const enum ob_kind kind = s7_ob_kind(ob);
    const bool by_time = kind == OB_TOD || kind == OB_DELAY;
    if (cpu->config.queue[ob].events != 0)
        return cpu->config.queue[ob];
    return (struct s7cpu_queue){.events = by_time || kind == OB_CYCLIC ? 1 : S7CPU_WAITING,
                                .threshold = by_time,
                                .overflow = S7CPU_NONE};
}

/* Beside the event that is processed, or goes first (A15-07, reading a): with a threshold of 1 the
 * second event [T15-73]. */
bool s7_queue_overloads(const struct s7cpu *cpu, int ob)
{
    const int threshold = s7_queue_of(cpu, ob).threshold;
    return threshold != 0 && waiting(cpu, ob) + s7_ob_is_running(cpu, ob) >= threshold;
}

bool s7_queue_holds_all(const struct s7cpu *cpu, int ob)
{
    return waiting(cpu, ob) >= s7_queue_of(cpu, ob).events;
}

/* Whether it is so young that a lower class may still start before it [OBS-03], AMB-69. */
static bool can_yield(const struct s7cpu *cpu, const struct s7cpu_request *r)
{
    return cpu->config.choices.lowest_of_a_moment_first && r->up == cpu->up &&
           s7_ob_kind(r->ob) != OB_ASYNC_ERROR;
}

static bool comes_before(const struct s7cpu *cpu, const struct s7cpu_request *r,
                         const struct s7cpu_request *other)
{
    if (can_yield(cpu, r) != can_yield(cpu, other))
        return can_yield(cpu, other);
    return can_yield(cpu, r) ? r->rank < other->rank : r->rank > other->rank;
}

/* The highest class, within it the oldest request [OBS-02, OBS-03]. */
int s7_queue_choose(const struct s7cpu *cpu)
{
    int best = -1;
    for (int i = 0; i < cpu->queue_length; i++)
        if (s7_may_start(cpu, &cpu->queue[i]) &&
            (best < 0 || comes_before(cpu, &cpu->queue[i], &cpu->queue[best])))
            best = i;
    return best;
}

/* Requests that a class holds: those that wait, and those whose OB is not at its end [OBS-07]. */
static int held(const struct s7cpu *cpu, int rank)
{
    int n = 0;
    for (int i = 0; i < cpu->queue_length; i++)
        n += cpu->queue[i].rank == rank;
    for (int i = 0; i < cpu->depth; i++)
        n += cpu->stack[i].rank == rank;
    return n;
}

bool s7_queue_is_full(const struct s7cpu *cpu, const struct s7cpu_request *r)
{
    if (s7_family(cpu)->has_queues)
        return s7_queue_holds_all(cpu, r->ob);
    return r->ob != 80 && held(cpu, r->rank) >= cpu->config.buffer;
}

bool s7_is_skip(int flt_id)
{
    return flt_id == FLT_SKIPPED || flt_id == FLT_SKIPPED_IN_HOLD;
}

bool s7_queue_has_skip(const struct s7cpu *cpu)
{
    for (int i = 0; i < cpu->queue_length; i++)
        if (cpu->queue[i].ob == 80 && s7_is_skip(cpu->queue[i].info.flt_id))
            return true;
    return false;
}

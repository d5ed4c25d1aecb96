/* Classes, the queue, which OB may start. */
#include "variant.h"

int faulty_ob_class(const struct s7cpu *cpu, int ob)
{
    bool late = has(cpu, FAULT_STARTUP_CLASS), fixed = has(cpu, FAULT_PRIORITY_DEFAULT);
    bool in_startup = cpu->mode == S7CPU_STARTUP && s7_ob_kind(ob) == OB_ASYNC_ERROR;
    if ((in_startup && !late) || !(late || fixed))
        return s7_ob_class(cpu, ob);
    if (cpu->config.priority[ob] != 0 && !fixed)
        return cpu->config.priority[ob];
    return s7_ob_default_class(cpu->config.family, ob);
}
SUBSTITUTES(ob_class);

void faulty_queue_put(struct s7cpu *cpu, const struct s7cpu_request *right)
{
    struct s7cpu_request r = *right;
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    if (has(cpu, FAULT_AIRT_LOSES) && cpu->delay_count > 0 && top != NULL && r.rank > top->rank)
        return;
    if (r.info.dtime != S7CPU_NONE && has(cpu, FAULT_DINT_INFO_REST))
        r.info.dtime = 0;
    s7_queue_put(cpu, &r);
}
SUBSTITUTES(queue_put);

static bool starts_early(const struct s7cpu *cpu, int ob)
{
    return cpu->mode == S7CPU_STARTUP &&
           ((s7_ob_kind(ob) == OB_TOD && has(cpu, FAULT_STARTUP_RUNS_TOD)) ||
            (s7_ob_kind(ob) == OB_DELAY && has(cpu, FAULT_STARTUP_RUNS_DINT)));
}

bool faulty_may_start(const struct s7cpu *cpu, const struct s7cpu_request *right)
{
    struct s7cpu_request r = *right;
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    if (has(cpu, FAULT_IRT_QUEUES) && cpu->mask[r.ob].blocked)
        return false;
    if (starts_early(cpu, r.ob))
        return top == NULL || (top->ob >= 100 && cpu->delay_count == 0);
    if (has(cpu, FAULT_AIRT_IGNORES_OB80) && r.ob == 80 && top != NULL)
        return r.rank > top->rank && cpu->depth < S7CPU_DEPTH;
    if (has(cpu, FAULT_EQUAL_PREEMPTS) && top != NULL && r.rank == top->rank &&
        s7_ob_kind(r.ob) == OB_TOD && !s7_ob_is_running(cpu, r.ob))
        r.rank++;
    return s7_may_start(cpu, &r);
}
SUBSTITUTES(may_start);

int faulty_queue_choose(const struct s7cpu *cpu)
{
    int best = s7_queue_choose(cpu);
    for (int i = 0; i < best && has(cpu, FAULT_FIFO); i++)
        if (s7_may_start(cpu, &cpu->queue[i]))
            return i;
    if (best < 0 || !has(cpu, FAULT_LIFO))
        return best;
    for (int i = best + 1; i < cpu->queue_length; i++)
        if (cpu->queue[i].rank == cpu->queue[best].rank && s7_may_start(cpu, &cpu->queue[i]))
            best = i;
    return best;
}
SUBSTITUTES(queue_choose);

/* Time-of-day interrupts as time passes, and their STEP 7 parameters. */
#include "internal.h"

static int period_of(enum s7cpu_execution execution)
{
    switch (execution) {
    case S7CPU_EVERY_MINUTE:
        return PERIOD_MINUTE;
    case S7CPU_HOURLY:
        return PERIOD_HOURLY;
    case S7CPU_DAILY:
        return PERIOD_DAILY;
    case S7CPU_WEEKLY:
        return PERIOD_WEEKLY;
    case S7CPU_MONTHLY:
        return PERIOD_MONTHLY;
    case S7CPU_YEARLY:
        return PERIOD_YEARLY;
    case S7CPU_END_OF_MONTH:
        return PERIOD_END_OF_MONTH;
    default:
        return PERIOD_ONCE;
    }
}

static void take_step7(struct s7cpu *cpu, int k)
{
    const struct s7cpu_step7 *s = &cpu->config.step7[k];
    struct s7cpu_tod *t = &cpu->tod[k];
    *t = (struct s7cpu_tod){.next = S7CPU_NEVER, .served = S7CPU_NONE, .again = S7CPU_NONE};
    if (s->deselected || s->execution < S7CPU_ONCE)
        return; /* AMB-62: with "none" [TINT-07] nothing is set */
    t->set = true;
    t->active = s->active;
    t->start = s->start;
    t->local = s->local;
    t->period = period_of(s->execution);
    if (t->period == PERIOD_END_OF_MONTH && s7_family(cpu)->month_end_has_no_date)
        t->start %= S7CPU_DAY;
    if (t->active) /* [OBS-56]: a one-shot interrupt is called even where it is past */
        t->next = t->period == PERIOD_ONCE ? s7_tod_start(cpu, t)
                                           : s7_tod_first_point(cpu, k, s7cpu_clock(cpu));
    if (t->next < s7cpu_clock(cpu) && s7_family(cpu)->past_once_is_over)
        s7_tod_used_up(cpu, s7cpu_tod_ob(k));
}

void s7_tod_restart(struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_TODS; k++)
        take_step7(cpu, k);
}

void s7_tod_begin_running(struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_TODS; k++) {
        take_step7(cpu, k);
        if (cpu->tod[k].next < s7cpu_clock(cpu)) /* the past one-shot interrupt had its run */
            s7_tod_used_up(cpu, s7cpu_tod_ob(k));
    }
}

void s7_tod_used_up(struct s7cpu *cpu, int ob)
{
    struct s7cpu_tod *t = &cpu->tod[s7cpu_tod_index(ob)];
    if (t->set && t->period == PERIOD_ONCE) {
        t->set = t->active = t->called = false;
        t->next = S7CPU_NEVER;
    }
}

static void due(struct s7cpu *cpu, int k)
{
    struct s7cpu_tod *t = &cpu->tod[k];
    int ob = s7cpu_tod_ob(k);
    int64_t point = t->next;
    t->next = s7_tod_unserved_point(cpu, k, s7cpu_clock(cpu) + 1); /* [TINT-09] */
    if (s7_irt_loses(cpu, ob))
        return;
    if (s7_family(cpu)->has_queues ? s7_queue_overloads(cpu, ob) : s7_ob_is_running(cpu, ob))
        s7_tod_overlap(cpu, k, point);
    else
        s7_tod_request(cpu, k, point);
}

void s7_tod_poll(struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_TODS; k++)
        if (cpu->tod[k].active && cpu->tod[k].next <= s7cpu_clock(cpu) && s7_time_runs(cpu))
            due(cpu, k);
}

int64_t s7_tod_next_up(const struct s7cpu *cpu)
{
    int64_t first = S7CPU_NEVER;
    for (int k = 0; k < S7CPU_TODS && s7_time_runs(cpu); k++)
        if (cpu->tod[k].active && cpu->tod[k].next < first)
            first = cpu->tod[k].next;
    return first == S7CPU_NEVER ? S7CPU_NEVER : first - cpu->offset;
}

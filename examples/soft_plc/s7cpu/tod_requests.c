/* Start events of time-of-day interrupts. At most one request of an OB waits here, or as many as its
 * queue has: AMB-19 (reading a) for the run after an overlap; AMB-18 and AMB-52, either: merged with the
 * one that waits (readings c and b). */
#include "internal.h"

static void put(struct s7cpu *cpu, int k, int64_t point, bool keeps_time, bool caught_up)
{
    struct s7cpu_tod *t = &cpu->tod[k];
    struct s7cpu_request r = s7_request(cpu, s7cpu_tod_ob(k), point);
    r.info.period = t->period;
    r.info.caught_up = caught_up;
    r.info.second_time = point <= t->again;
    r.keeps_time = keeps_time;
    r.after_skip = keeps_time && s7_queue_has_skip(cpu);
    if (s7_queue_holds_all(cpu, r.ob)) {
        if (s7_family(cpu)->has_queues && !keeps_time)
            s7_error_overflow(cpu, r.ob); /* [T15-27] */
        return;
    }
    if (r.info.second_time)
        t->again = S7CPU_NONE; /* A15-18, reading a */
    s7_queue_put(cpu, &r);
}

void s7_tod_request(struct s7cpu *cpu, int k, int64_t point)
{
    put(cpu, k, point, false, false);
}

/* OB 80 goes first, then the OB that runs, then the run that is due [TINT-15]. */
void s7_tod_overlap(struct s7cpu *cpu, int k, int64_t point)
{
    s7_error_overlap(cpu, s7cpu_tod_ob(k), cpu->tod[k].period);
    if (!s7_time_error_stops(cpu))
        s7_tod_request(cpu, k, point);
}

void s7_tod_catch_up(struct s7cpu *cpu, int k, bool by_change)
{
    struct s7cpu_tod *t = &cpu->tod[k];
    int64_t first = t->next;
    /* [CLK-08]; a point equal to the clock is reached */
    t->next = s7_tod_first_point(cpu, k, s7cpu_clock(cpu));
    put(cpu, k, first, true, by_change); /* [CLK-03, CLK-07]: once, with the first skipped point */
}

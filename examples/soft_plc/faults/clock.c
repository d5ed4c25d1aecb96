/* The clock is set, or HOLD is over: skipped start points. */
#include "variant.h"

enum { MAX_CATCH_UPS = 5 };

static void forward(struct s7cpu *cpu, int64_t before)
{
    const int64_t by = s7cpu_clock(cpu) - before;
    for (int k = 0; k < S7CPU_DINTS && has(cpu, FAULT_DINT_FOLLOWS_CLOCK); k++)
        cpu->dint[k].end -= by;
}

static void repeat(struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_TODS; k++)
        if (cpu->tod[k].active)
            cpu->tod[k].next = s7_tod_first_point(cpu, k, s7cpu_clock(cpu));
}

static bool goes_on(const struct s7cpu *cpu)
{
    return cpu->config.family == S7CPU_S7_300 && has(cpu, FAULT_NO_REPEAT_S7_300);
}

static bool repeats(const struct s7cpu *cpu)
{
    return cpu->config.family != S7CPU_S7_300 && has(cpu, FAULT_REPEAT_S7_400);
}

/* One-shot interrupts whose OB runs and whose point lies ahead again. */
static void arm_again(struct s7cpu *cpu, int64_t before)
{
    for (int k = 0; k < S7CPU_TODS; k++) {
        struct s7cpu_tod *t = &cpu->tod[k];
        if (t->period != PERIOD_ONCE || !s7_ob_is_running(cpu, s7cpu_tod_ob(k)) ||
            (t->set && !t->called) || t->start > before || t->start < s7cpu_clock(cpu))
            continue;
        t->set = t->active = true;
        t->called = false;
        t->next = t->start;
    }
}

static void remember(struct faulty_cpu *f, int64_t before)
{
    f->clock_before = before;
    if (before > f->clock_highest)
        f->clock_highest = before;
}

void faulty_tod_clock_changed(struct s7cpu *cpu, int64_t before)
{
    bool back = s7cpu_clock(cpu) < before;
    remember((struct faulty_cpu *)cpu, before);
    forward(cpu, before);
    if (back && goes_on(cpu))
        return;
    s7_tod_clock_changed(cpu, before);
    if (back && repeats(cpu) && cpu->mode != S7CPU_STOP)
        repeat(cpu);
    if (back && has(cpu, FAULT_ONCE_RUNS_TWICE))
        arm_again(cpu, before);
}
SUBSTITUTES(tod_clock_changed);

/* Puts the clock forward, once a minute, where that skips no start point. */
static void run_away(struct s7cpu *cpu)
{
    enum { GAIN_MS = 3000 };
    struct faulty_cpu *f = (struct faulty_cpu *)cpu;
    bool skips = false;
    for (int k = 0; k < S7CPU_TODS; k++)
        skips |= cpu->tod[k].active && cpu->tod[k].next <= s7cpu_clock(cpu) + GAIN_MS;
    if (cpu->up / S7CPU_MINUTE == f->minute || skips)
        return;
    f->minute = cpu->up / S7CPU_MINUTE;
    cpu->offset += GAIN_MS;
}

void faulty_tod_poll(struct s7cpu *cpu)
{
    if (has(cpu, FAULT_CLOCK_RUNS_AWAY))
        run_away(cpu);
    s7_tod_poll(cpu);
}
SUBSTITUTES(tod_poll);

void faulty_error_skipped(struct s7cpu *cpu, int flt_id, unsigned late)
{
    if (has(cpu, FAULT_NO_OB80_SKIP))
        return;
    if (has(cpu, FAULT_SKIP_AS_INTERRUPT))
        s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_INTERRUPT, .ob = 80, .flt_id = flt_id});
    s7_error_skipped(cpu, flt_id, has(cpu, FAULT_SKIP_MASK) ? late << 1 : late);
}
SUBSTITUTES(error_skipped);

static bool is_skip(const struct s7cpu_request *r)
{
    return r->info.flt_id == FLT_SKIPPED || r->info.flt_id == FLT_SKIPPED_IN_HOLD;
}

void faulty_time_error(struct s7cpu *cpu, const struct s7cpu_request *right)
{
    struct s7cpu_request r = *right;
    if (r.info.flt_id == FLT_SKIPPED && has(cpu, FAULT_SKIP_TIME))
        r.info.time = faulty(cpu)->clock_before;
    if (is_skip(&r) && has(cpu, FAULT_CATCH_UP_FIRST))
        r.rank = s7_ob_class(cpu, S7CPU_TOD_FIRST);
    if (r.info.flt_id == FLT_OVERFLOW && has(cpu, FAULT_OVERFLOW_CLASS))
        r.rank = r.info.priority = s7_ob_class(cpu, 80);
    s7_time_error(cpu, &r);
}
SUBSTITUTES(time_error);

static void per_period(struct s7cpu *cpu, int k, int64_t first)
{
    int64_t point = first;
    for (int n = 0; n < MAX_CATCH_UPS && point < s7cpu_clock(cpu); n++) {
        struct s7cpu_request r = s7_request(cpu, s7cpu_tod_ob(k), point);
        r.info.period = cpu->tod[k].period;
        if (n > 0)
            s7_queue_put(cpu, &r);
        point = s7_tod_first_point(cpu, k, point + 1);
    }
}

/* OB 80 goes behind the catch-up, in its class. */
static void move_error_behind(struct s7cpu *cpu)
{
    for (int i = cpu->queue_length - 1; i >= 0; i--) {
        const struct s7cpu_request *r = &cpu->queue[i];
        if (r->ob == 80 && is_skip(r) && r->info.time == s7cpu_clock(cpu)) {
            const struct s7cpu_request error = s7_queue_take(cpu, i);
            s7_queue_put(cpu, &error);
            return;
        }
    }
}

void faulty_tod_catch_up(struct s7cpu *cpu, int k, bool by_change)
{
    int64_t first = cpu->tod[k].next;
    if (has(cpu, FAULT_NO_CATCH_UP)) {
        cpu->tod[k].next = s7_tod_first_point(cpu, k, s7cpu_clock(cpu));
        return;
    }
    s7_tod_catch_up(cpu, k, by_change);
    if (has(cpu, FAULT_CATCH_UP_PER_PERIOD))
        per_period(cpu, k, first);
    if (has(cpu, FAULT_CATCH_UP_FIRST))
        move_error_behind(cpu);
}
SUBSTITUTES(tod_catch_up);

bool faulty_queue_has_skip(const struct s7cpu *cpu)
{
    return !has(cpu, FAULT_CATCH_UP_FIRST) && s7_queue_has_skip(cpu);
}
SUBSTITUTES(queue_has_skip);

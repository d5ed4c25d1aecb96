#include "variant.h"

int64_t faulty_tod_first_point(const struct s7cpu *cpu, int k, int64_t from);

/* The point a day earlier, or the next one where that is before `from`. */
static int64_t a_day_earlier(const struct s7cpu *cpu, int k, int64_t from, int64_t point)
{
    int64_t early = point - S7CPU_DAY;
    return early >= from && early >= cpu->tod[k].start ? early
                                                       : faulty_tod_first_point(cpu, k, point + 1);
}

static int64_t month_end_30(const struct s7cpu *cpu, int k, int64_t from, int64_t point)
{
    return s7cpu_date(point).day == 31 ? a_day_earlier(cpu, k, from, point) : point;
}

/* 2000-02-29 does not exist. */
static int64_t century_not_leap(const struct s7cpu *cpu, int k, int64_t from, int64_t point)
{
    const struct s7cpu_date d = s7cpu_date(point);
    if (d.year != 2000 || d.month != 2 || d.day != 29)
        return point;
    if (cpu->tod[k].period == PERIOD_YEARLY)
        return s7_tod_first_point(cpu, k, point + 1);
    return a_day_earlier(cpu, k, from, point);
}

int64_t faulty_tod_first_point(const struct s7cpu *cpu, int k, int64_t from)
{
    const struct s7cpu_tod *t = &cpu->tod[k];
    if (t->period == PERIOD_HOURLY && has(cpu, FAULT_HOURLY_DAILY))
        return s7_series_first(t->start, PERIOD_DAILY, from);
    int64_t point = s7_tod_first_point(cpu, k, from);
    if (point == S7CPU_NEVER)
        return point;
    if (t->period == PERIOD_END_OF_MONTH && has(cpu, FAULT_MONTH_END_30))
        return month_end_30(cpu, k, from, point);
    if ((t->period == PERIOD_END_OF_MONTH || t->period == PERIOD_YEARLY) &&
        has(cpu, FAULT_LEAP_CENTURY))
        return century_not_leap(cpu, k, from, point);
    return point;
}
SUBSTITUTES(tod_first_point);

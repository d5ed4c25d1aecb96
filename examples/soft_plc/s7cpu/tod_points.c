/* Start points of time-of-day interrupts. */
#include "internal.h"

static int64_t ahead(const struct s7cpu *cpu, const struct s7cpu_tod *t)
{
    return t->local ? cpu->zone : 0;
}

int64_t s7_tod_start(const struct s7cpu *cpu, const struct s7cpu_tod *t)
{
    return t->start - ahead(cpu, t);
}

/* Days and months are those of local time, too [T15-20]. */
int64_t s7_tod_first_point(const struct s7cpu *cpu, int k, int64_t from)
{
    const struct s7cpu_tod *t = &cpu->tod[k];
    const int64_t point = s7_series_first(t->start, t->period, from + ahead(cpu, t));
    return point == S7CPU_NEVER ? S7CPU_NEVER : point - ahead(cpu, t);
}

static bool is_served(const struct s7cpu_tod *t, int64_t point)
{
    return t->served != S7CPU_NONE && t->served_from <= point && point <= t->served;
}

/* Small steps back, one after another, may have led before the first point that was served (A15-17). */
int64_t s7_tod_unserved_point(const struct s7cpu *cpu, int k, int64_t from)
{
    const struct s7cpu_tod *t = &cpu->tod[k];
    const int64_t point = s7_tod_first_point(cpu, k, from);
    return is_served(t, point) ? s7_tod_first_point(cpu, k, t->served + 1) : point;
}

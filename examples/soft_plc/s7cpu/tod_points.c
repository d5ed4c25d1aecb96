/* Start points of time-of-day interrupts. */
#include "internal.h"

int64_t s7_tod_first_point(const struct s7cpu *cpu, int k, int64_t from)
{
    return s7_series_first(cpu->tod[k].start, cpu->tod[k].period, from);
}

/* Two times: elapsed milliseconds that nobody sets, and the CPU clock, which is set.
 * Elapsed time is simulated or measured (CLOCK_MONOTONIC); the clock is an offset to it. */
#ifndef CLOCK_H
#define CLOCK_H

#include <stdbool.h>
#include <stdint.h>

#include "calendar.h"

struct cpu_clock {
    bool real;
    int64_t up;      /* elapsed ms since the log began, as last read */
    dt_ms offset;    /* CPU clock minus elapsed time */
    int64_t base_ns; /* monotonic clock when the log began */
};

void clock_start(struct cpu_clock *c, bool real, dt_ms now);
/* Lets time pass, at most until `up`; on the real clock it sleeps. */
void clock_advance(struct cpu_clock *c, int64_t up);
/* Reads the real clock anew; the simulated one stands still between two advances. */
void clock_read(struct cpu_clock *c);
void clock_set(struct cpu_clock *c, dt_ms now);

static inline dt_ms clock_now(const struct cpu_clock *c)
{
    return c->offset + c->up;
}

#endif

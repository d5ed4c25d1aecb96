/* Elapsed milliseconds: simulated, or measured (CLOCK_MONOTONIC). */
#ifndef CLOCK_H
#define CLOCK_H

#include <stdbool.h>
#include <stdint.h>

struct plc_clock {
    bool real;
    int64_t up;      /* since the log began, as last read */
    int64_t base_ns; /* monotonic clock when the log began */
};

void clock_start(struct plc_clock *c, bool real);
/* Lets time pass, at most until `up`; on the real clock it sleeps. */
void clock_advance(struct plc_clock *c, int64_t up);
/* Reads the real clock anew; the simulated one stands still between two advances. */
void clock_read(struct plc_clock *c);

#endif

#define _POSIX_C_SOURCE 200809L
#include "clock.h"

#include <errno.h>
#include <time.h>

static int64_t monotonic_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

void clock_start(struct plc_clock *c, bool real)
{
    c->real = real;
    c->up = 0;
    c->base_ns = real ? monotonic_ns() : 0;
}

void clock_read(struct plc_clock *c)
{
    if (c->real)
        c->up = (monotonic_ns() - c->base_ns) / 1000000;
}

void clock_advance(struct plc_clock *c, int64_t up)
{
    if (!c->real) {
        if (up > c->up)
            c->up = up;
        return;
    }
    int64_t ns = c->base_ns + up * 1000000;
    struct timespec t = {.tv_sec = (time_t)(ns / 1000000000), .tv_nsec = (long)(ns % 1000000000)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, NULL) == EINTR)
        continue;
    clock_read(c);
}

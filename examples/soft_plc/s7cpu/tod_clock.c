/* Time-of-day interrupts when the clock is set, and after HOLD. */
#include "internal.h"

/* Points that the clock has passed without reaching them. The catch-ups are entered at once:
 * OB 80 stands above them, and SFC 28 and 29 inside it withdraw them [CLK-04, TINT-54].
 * AMB-54, either: several catch-ups go in ascending order of their OBs (reading b). */
static void skipped(struct s7cpu *cpu, int flt_id, bool reported)
{
    int64_t now = s7cpu_clock(cpu);
    unsigned late = 0;
    for (int k = 0; k < S7CPU_TODS; k++) {
        struct s7cpu_tod *t = &cpu->tod[k];
        if (!t->active || t->next >= now)
            continue;
        if (s7_irt_loses(cpu, s7cpu_tod_ob(k))) /* AMB-50, either: no OB 80, no bit (b) */
            t->next = s7_tod_first_point(cpu, k, now);
        else
            late |= 1u << k;
    }
    /* AMB-53, either: in STARTUP there is no OB 80, the run is deferred to RUN (reading a); but
     * for points that passed in STOP (AMB-26). */
    if (late != 0 && reported &&
        (cpu->mode == S7CPU_RUN || cpu->resuming || s7_family(cpu)->ob80_waits_for_run))
        s7_error_skipped(cpu, flt_id, late); /* one for all of them [OBS-32] */
    for (int k = 0; k < S7CPU_TODS; k++) {
        if (!(late & 1u << k))
            continue;
        if (s7_time_error_stops(cpu)) /* reported once, no catch-up [OBS-22] */
            cpu->tod[k].next = s7_tod_first_point(cpu, k, now);
        else
            s7_tod_catch_up(cpu, k, flt_id == FLT_SKIPPED); /* A15-16, reading a */
    }
}

/* The last point for which the OB was called or waits (AMB-59, reading a); S7CPU_NONE: none. */
static int64_t last_served(const struct s7cpu *cpu, int k)
{
    int64_t last = cpu->tod[k].served;
    for (int i = 0; i < cpu->queue_length; i++)
        if (cpu->queue[i].ob == s7cpu_tod_ob(k) && cpu->queue[i].info.time > last)
            last = cpu->queue[i].info.time;
    return last;
}

/* The OB waits for this point. A run that has waited over a large step back does not count: its point
 * comes again [T15-94]. */
static bool waits(const struct s7cpu *cpu, int k, int64_t point, int64_t before)
{
    for (int i = 0; i < cpu->queue_length; i++)
        if (cpu->queue[i].ob == s7cpu_tod_ob(k) && cpu->queue[i].info.time == point &&
            (point <= before || point > cpu->tod[k].again))
            return true;
    return false;
}

/* [CLK-10, T15-94]: an S7-300 serves the points again, an S7-1500 after a large step; after a small one
 * those that were never served (A15-17, reading b). [CLK-09], AMB-56, either: the others serve again only
 * those after the last one served (reading d), or none before the point that was next (b). */
static int64_t next_again(const struct s7cpu *cpu, int k, int64_t before, bool repeats)
{
    const int64_t now = s7cpu_clock(cpu), last = last_served(cpu, k);
    if (repeats)
        return s7_tod_first_point(cpu, k, now);
    if (s7_family(cpu)->serves_uncalled) {
        int64_t point = s7_tod_unserved_point(cpu, k, now);
        while (waits(cpu, k, point, before))
            point = s7_tod_unserved_point(cpu, k, point + 1);
        return point;
    }
    if (!cpu->config.choices.uncalled_points_are_served)
        return cpu->tod[k].next;
    return s7_tod_first_point(cpu, k, last >= now ? last + 1 : now);
}

/* The clock, or local time for those that go by it. */
static void moved_back(struct s7cpu *cpu, int64_t before, bool repeats, bool local)
{
    for (int k = 0; k < S7CPU_TODS; k++) {
        struct s7cpu_tod *t = &cpu->tod[k];
        if (local && !t->local)
            continue;
        bool used = t->period == PERIOD_ONCE && t->next == S7CPU_NEVER; /* [CLK-12], AMB-71 */
        if (t->active && !used)
            t->next = next_again(cpu, k, before, repeats);
        if (!repeats)
            continue;
        const int64_t last = last_served(cpu, k);
        t->again = last > t->again ? last : t->again;
        t->served = S7CPU_NONE;
    }
}

void s7_tod_clock_changed(struct s7cpu *cpu, int64_t before)
{
    if (cpu->mode == S7CPU_STOP)
        return;
    const struct s7_family *f = s7_family(cpu);
    const int64_t ahead = s7cpu_clock(cpu) - before;
    if (ahead < 0)
        moved_back(cpu, before, -ahead >= f->repeats_from, false);
    else if (cpu->mode != S7CPU_HOLD) /* AMB-53: in HOLD they become part of fault 06 */
        skipped(cpu, FLT_SKIPPED, ahead >= f->skips_from); /* [CLK-02, T15-91], A15-09 (a) */
}

/* Points by local time move the other way. Back, they are served again [T15-97, T15-98]; ahead, caught up
 * without OB 80 (A15-10, reading a) [T15-98]. */
void s7_tod_zone_changed(struct s7cpu *cpu, int64_t ahead)
{
    if (cpu->mode == S7CPU_STOP)
        return;
    if (ahead < 0)
        moved_back(cpu, s7cpu_clock(cpu), true, true);
    for (int k = 0; k < S7CPU_TODS; k++) {
        struct s7cpu_tod *t = &cpu->tod[k];
        if (t->local && t->again != S7CPU_NONE)
            t->again -= ahead;
        if (t->local && t->served != S7CPU_NONE) {
            t->served -= ahead;
            t->served_from -= ahead;
        }
        if (t->local && t->next != S7CPU_NEVER && ahead > 0)
            t->next -= ahead;
    }
    if (ahead > 0 && cpu->mode != S7CPU_HOLD)
        skipped(cpu, FLT_SKIPPED, false);
}

void s7_tod_released(struct s7cpu *cpu)
{
    skipped(cpu, FLT_SKIPPED_IN_HOLD, true); /* AMB-55, either: caught up as after 05 (reading a) */
}

/* AMB-26, either: reported as skipped, or lost. */
void s7_tod_resumed(struct s7cpu *cpu)
{
    const int64_t now = s7cpu_clock(cpu);
    if (cpu->config.choices.points_of_stop_are_reported) {
        skipped(cpu, FLT_SKIPPED, true);
        return;
    }
    for (int k = 0; k < S7CPU_TODS; k++)
        if (cpu->tod[k].active && cpu->tod[k].next < now)
            cpu->tod[k].next = s7_tod_first_point(cpu, k, now);
}

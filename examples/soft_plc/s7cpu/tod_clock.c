/* Time-of-day interrupts when the clock is set, and after HOLD. */
#include "internal.h"

/* Points that the clock has passed without reaching them. The catch-ups are entered at once:
 * OB 80 stands above them, and SFC 28 and 29 inside it withdraw them [CLK-04, TINT-54].
 * AMB-54, either: several catch-ups go in ascending order of their OBs (reading b). */
static void skipped(struct s7cpu *cpu, int flt_id)
{
    int64_t now = s7cpu_clock(cpu);
    unsigned late = 0;
    for (int k = 0; k < S7CPU_TODS; k++) {
        struct s7cpu_tod *t = &cpu->tod[k];
        if (!t->active || t->next >= now)
            continue;
        if (s7_irt_loses(cpu, S7CPU_TOD_FIRST + k)) /* AMB-50, either: no OB 80, no bit (b) */
            t->next = s7_tod_first_point(cpu, k, now);
        else
            late |= 1u << k;
    }
    /* AMB-53, either: in STARTUP there is no OB 80, the run is deferred to RUN (reading a). */
    if (late != 0 && cpu->mode == S7CPU_RUN)
        s7_error_skipped(cpu, flt_id, late); /* one for all of them [OBS-32] */
    for (int k = 0; k < S7CPU_TODS && cpu->mode != S7CPU_STOP; k++)
        if (late & 1u << k)
            s7_tod_catch_up(cpu, k);
}

/* [CLK-09, CLK-10]: an S7-300 serves the points again; the others go on with the next point that
 * they had, and so do not serve those of AMB-56 and AMB-57 before it (either). */
static void moved_back(struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_TODS && cpu->config.family == S7CPU_S7_300; k++)
        if (cpu->tod[k].active)
            cpu->tod[k].next = s7_tod_first_point(cpu, k, s7cpu_clock(cpu));
}

void s7_tod_clock_changed(struct s7cpu *cpu, int64_t before)
{
    if (cpu->mode == S7CPU_STOP)
        return;
    if (s7cpu_clock(cpu) < before)
        moved_back(cpu);
    else if (cpu->mode != S7CPU_HOLD) /* AMB-53: in HOLD they become part of fault 06 */
        skipped(cpu, FLT_SKIPPED); /* [CLK-02] */
}

void s7_tod_released(struct s7cpu *cpu)
{
    skipped(cpu, FLT_SKIPPED_IN_HOLD); /* AMB-55, either: caught up as after 05 (reading a) */
}

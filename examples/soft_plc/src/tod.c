/* The start points of the time-of-day interrupts and what the clock does to them. */
#include "tod.h"

#include "errors.h"
#include "events.h"
#include "irt.h"

enum { MAX_CATCH_UPS = 5 }; /* for the fault that makes one for every period */

static dt_ms first_point(const struct cpu *cpu, const struct tod *t, dt_ms from)
{
    return series_first(t->start, t->period, from, faults_calendar_quirks(&cpu->config.faults));
}

/* The next point after the present ones are used up. A single start has no other. */
static dt_ms next_point(const struct cpu *cpu, const struct tod *t, dt_ms from)
{
    return t->period == PERIOD_ONCE ? DT_NEVER : first_point(cpu, t, from);
}

static void take_step7(struct cpu *cpu, int k)
{
    const struct step7_tod *s = &cpu->config.step7[k];
    struct tod *t = &cpu->tod[k];
    *t = (struct tod){.next = DT_NEVER};
    if (!s->configured || s->deselected || s->execution == S7LOG_NO_EXECUTION || !s->has_start ||
        cpu_fault(cpu, FAULT_RESTART_NO_STEP7))
        return; /* AMB-62: with "none" [TINT-07] nothing is set */
    t->set = true;
    t->active = s->active;
    t->start = s->start;
    t->period = s->period;
    if (t->active) /* [OBS-56]: a single start is called even where it is past */
        t->next = t->period == PERIOD_ONCE ? t->start : first_point(cpu, t, cpu_now(cpu));
}

void tod_restart(struct cpu *cpu)
{
    if (cpu_fault(cpu, FAULT_RESTART_KEEPS_SFC))
        return;
    for (int k = 0; k < TOD_OBS; k++)
        take_step7(cpu, k);
}

void tod_begin_running(struct cpu *cpu)
{
    for (int k = 0; k < TOD_OBS; k++) {
        take_step7(cpu, k);
        if (cpu->tod[k].active && cpu->tod[k].next < cpu_now(cpu)) {
            cpu->tod[k].set = cpu->tod[k].active = false; /* the past once had its run */
            cpu->tod[k].next = DT_NEVER;
        }
    }
}

static void put_request(struct cpu *cpu, int k, dt_ms time)
{
    struct request r = events_request(cpu, TOD_FIRST + k, time);
    r.info.period = cpu->tod[k].period;
    events_put(cpu, &r);
}

/* A point that passes under SFC 39 is used up and its event lost [IRT-04, IRT-18]; AMB-12,
 * reading a: a single start is over then. */
static bool lost(struct cpu *cpu, int k)
{
    if (!irt_blocks(cpu, TOD_FIRST + k))
        return false;
    if (!cpu_fault(cpu, FAULT_IRT_JOB_STAYS))
        tod_called(cpu, TOD_FIRST + k);
    return true;
}

/* At most one request of an OB waits here: AMB-19 (reading a) for the run after an overlap,
 * AMB-18 and AMB-52, either: merged with the one that waits (readings c and b). */
static void due(struct cpu *cpu, int k)
{
    struct tod *t = &cpu->tod[k];
    int ob = TOD_FIRST + k;
    dt_ms point = t->next;
    t->next = next_point(cpu, t, cpu_now(cpu) + 1);
    if (lost(cpu, k))
        return;
    if (cpu_is_running(cpu, ob)) { /* [TINT-14] */
        if (!cpu_fault(cpu, FAULT_OVERLAP_SILENT))
            errors_overlap(cpu, ob, t->period);
        if (cpu->mode == MODE_STOP || cpu_fault(cpu, FAULT_OVERLAP_LOST))
            return;
    }
    if (!queue_has(&cpu->queue, ob))
        put_request(cpu, k, point);
}

void tod_poll(struct cpu *cpu)
{
    for (int k = 0; k < TOD_OBS; k++)
        if (cpu->tod[k].next <= cpu_now(cpu) && cpu->tod[k].active &&
            (cpu->mode == MODE_RUN || cpu->mode == MODE_STARTUP))
            due(cpu, k);
}

int64_t tod_next_up(const struct cpu *cpu)
{
    dt_ms first = DT_NEVER;
    if (cpu->mode != MODE_RUN && cpu->mode != MODE_STARTUP)
        return INT64_MAX;
    for (int k = 0; k < TOD_OBS; k++)
        if (cpu->tod[k].active && cpu->tod[k].next < first)
            first = cpu->tod[k].next;
    return first == DT_NEVER ? INT64_MAX : first - cpu->clock.offset;
}

void tod_called(struct cpu *cpu, int ob)
{
    struct tod *t = &cpu->tod[ob - TOD_FIRST];
    if (t->set && t->period == PERIOD_ONCE && !cpu_fault(cpu, FAULT_ONCE_STAYS)) {
        t->set = t->active = false; /* [TINT-08], AMB-08 (reading a), AMB-71: when it starts */
        t->next = DT_NEVER;
    }
}

/* Requests for one interrupt whose points up to the present clock have been skipped. */
static void catch_up(struct cpu *cpu, int k)
{
    struct tod *t = &cpu->tod[k];
    dt_ms first = t->next;
    t->next = next_point(cpu, t, cpu_now(cpu)); /* [CLK-08]; a point equal to it is reached */
    if (cpu_fault(cpu, FAULT_NO_CATCH_UP))
        return;
    if (!queue_has(&cpu->queue, TOD_FIRST + k))
        put_request(cpu, k, first); /* [CLK-03, CLK-07]: once, with the first skipped point */
    if (!cpu_fault(cpu, FAULT_CATCH_UP_PER_PERIOD) || t->period == PERIOD_ONCE)
        return;
    dt_ms point = first_point(cpu, t, first + 1);
    for (int n = 1; n < MAX_CATCH_UPS && point < cpu_now(cpu); n++) {
        put_request(cpu, k, point);
        point = first_point(cpu, t, point + 1);
    }
}

/* Points that the clock has passed without reaching them. The catch-ups are entered at once:
 * OB 80 stands above them, and SFC 28 and 29 inside it withdraw them [CLK-04, TINT-54].
 * AMB-54, either: several catch-ups go in ascending order of their OBs (reading b). */
static void skipped(struct cpu *cpu, int flt_id, dt_ms before)
{
    unsigned late = 0;
    for (int k = 0; k < TOD_OBS; k++) {
        struct tod *t = &cpu->tod[k];
        if (!t->active || t->next >= cpu_now(cpu))
            continue;
        if (lost(cpu, k)) /* AMB-50, either: without OB 80 and its bit (reading b) */
            t->next = next_point(cpu, t, cpu_now(cpu));
        else
            late |= 1u << k;
    }
    if (late == 0)
        return;
    /* AMB-53, either: in STARTUP there is no OB 80, the run is deferred to RUN (reading a). */
    bool error = cpu->mode == MODE_RUN && !cpu_fault(cpu, FAULT_NO_OB80_SKIP);
    bool error_last = cpu_fault(cpu, FAULT_CATCH_UP_FIRST);
    if (error && !error_last)
        errors_skipped(cpu, flt_id, late, before); /* one for all of them [OBS-32] */
    for (int k = 0; k < TOD_OBS && cpu->mode != MODE_STOP; k++)
        if (late & 1u << k)
            catch_up(cpu, k);
    if (error && error_last)
        errors_skipped(cpu, flt_id, late, before);
}

void tod_clock_changed(struct cpu *cpu, dt_ms before)
{
    if (cpu->mode == MODE_STOP)
        return;
    if (cpu_now(cpu) >= before) {
        if (cpu->mode != MODE_HOLD) /* AMB-53: in HOLD they become part of fault 06 */
            skipped(cpu, 0x05, before); /* [CLK-02] */
        return;
    }
    /* [CLK-09, CLK-10]: an S7-300 serves the points again; the others go on with the next point
     * they had, and so do not serve those of AMB-56 and AMB-57 before it (either). */
    bool repeats = cpu->config.family == FAMILY_S7_300
                       ? !cpu_fault(cpu, FAULT_NO_REPEAT_S7_300)
                       : cpu_fault(cpu, FAULT_REPEAT_S7_400);
    for (int k = 0; repeats && k < TOD_OBS; k++)
        if (cpu->tod[k].active)
            cpu->tod[k].next = first_point(cpu, &cpu->tod[k], cpu_now(cpu));
}

void tod_released(struct cpu *cpu, dt_ms before)
{
    skipped(cpu, 0x06, before); /* AMB-55, either: caught up as after fault 05 (reading a) */
}

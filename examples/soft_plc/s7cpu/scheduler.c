/* Which OB runs: dispatch by priority class, start and end of OBs. */
#include "internal.h"

/* In STARTUP only OB 80 to 87 may run beside the startup OB [OBS-42 to OBS-44, TINT-13]; in that of
 * a hot restart not those that waited before the STOP. */
static bool mode_allows(const struct s7cpu *cpu, const struct s7cpu_request *r)
{
    if (cpu->mode != S7CPU_STARTUP)
        return cpu->mode == S7CPU_RUN;
    if (r->ob == 80 && s7_family(cpu)->ob80_waits_for_run)
        return false;
    return s7_ob_kind(r->ob) == OB_ASYNC_ERROR && (!cpu->resuming || r->rank > 27);
}

/* A catch-up comes behind the OB 80 that reports it, also where its class is higher [T15-91]. */
static bool waits_for_report(const struct s7cpu *cpu, const struct s7cpu_request *r)
{
    bool reports = s7_queue_has_skip(cpu);
    for (int i = 0; i < cpu->depth; i++)
        reports |= cpu->stack[i].ob == 80 && s7_is_skip(cpu->stack[i].flt_id);
    return r->after_skip && reports;
}

/* Only a strictly higher class interrupts [OBS-01, OBS-02], and nothing a delayed OB. */
bool s7_may_start(const struct s7cpu *cpu, const struct s7cpu_request *r)
{
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    if (!mode_allows(cpu, r) || waits_for_report(cpu, r))
        return false;
    if (top == NULL)
        return true;
    return r->rank > top->rank && cpu->depth < S7CPU_DEPTH && !s7_airt_delays(cpu);
}

const struct s7cpu_frame *s7cpu_top(const struct s7cpu *cpu)
{
    return cpu->depth > 0 ? &cpu->stack[cpu->depth - 1] : NULL;
}

static void push(struct s7cpu *cpu, int ob, int rank, int flt_id)
{
    cpu->stack[cpu->depth++] =
        (struct s7cpu_frame){.ob = ob, .rank = rank, .flt_id = flt_id, .run = ++cpu->runs[ob]};
    cpu->cycle_exceeded &= ob != 1;
    if (s7_ob_kind(ob) == OB_STARTUP || s7_ob_kind(ob) == OB_CYCLE)
        cpu->turn = ob;
}

void s7_start(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    struct s7cpu_info info = r->info;
    if (s7_ob_kind(r->ob) == OB_TOD)
        s7_tod_called(cpu, r->ob, r->info.time);
    if (cpu->config.choices.info_has_time_of_call && !r->keeps_time)
        info.time = s7cpu_clock(cpu); /* OBS-10 */
    s7_emit_start(cpu, r->ob, &info);
    push(cpu, r->ob, r->rank, info.flt_id);
}

void s7_enter(struct s7cpu *cpu, int ob)
{
    push(cpu, ob, s7_ob_class(cpu, ob), S7CPU_NONE);
}

/* In STARTUP and HOLD, and between two cycles, there is no cycle time. */
bool s7_cycle_exceeded_again(struct s7cpu *cpu)
{
    const bool again = cpu->cycle_exceeded;
    const bool in_cycle = cpu->depth > 0 && (s7_ob_kind(cpu->stack[0].ob) == OB_CYCLE ||
                                             s7_next_in_turn(cpu) != S7CPU_NONE);
    if (cpu->mode != S7CPU_RUN || !in_cycle ||
        cpu->config.choices.cycle_is_retriggered)
        return false;
    cpu->cycle_exceeded = true;
    return again;
}

/* AMB-06 and AMB-44: a missing OB is noticed when it would be called. */
static void call(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    if (cpu->loaded[r->ob] && !r->stops)
        s7_start(cpu, r);
    else
        s7_error_missing(cpu, r);
}

int s7_next_in_turn(const struct s7cpu *cpu)
{
    const bool startup = cpu->mode == S7CPU_STARTUP;
    const int end = startup ? S7CPU_MORE_CYCLES : S7CPU_OBS;
    int ob = startup ? S7CPU_MORE_STARTUPS : S7CPU_MORE_CYCLES;
    if (s7_ob_kind(cpu->turn) != OB_CYCLE && !startup)
        return S7CPU_NONE; /* the first cycle begins with OB 1 */
    if (cpu->turn >= ob)
        ob = cpu->turn + 1;
    while (ob < end && !cpu->loaded[ob])
        ob++;
    return ob < end ? ob : S7CPU_NONE;
}

/* Of several startup and cycle OBs the next, then RUN and OB 1. */
static void take_turn(struct s7cpu *cpu)
{
    const int next = s7_next_in_turn(cpu);
    const bool startup = cpu->mode == S7CPU_STARTUP;
    if (next == S7CPU_NONE && startup) {
        s7_to_run(cpu);
        return;
    }
    struct s7cpu_request r = s7_request(cpu, next == S7CPU_NONE ? 1 : next, s7cpu_clock(cpu));
    if (startup)
        r.info.strt_info = STRT_INFO_WARM;
    s7_start(cpu, &r);
}

bool s7cpu_dispatch(struct s7cpu *cpu)
{
    if (!s7_time_runs(cpu))
        return false;
    int first = s7_queue_choose(cpu);
    if (first >= 0) {
        const struct s7cpu_request r = s7_queue_take(cpu, first);
        call(cpu, &r);
    } else if (cpu->depth > 0) {
        return false;
    } else {
        take_turn(cpu);
    }
    return true;
}

void s7cpu_end_ob(struct s7cpu *cpu)
{
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    if (top == NULL)
        return;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_OB_END, .ob = top->ob});
    if (s7_ob_kind(top->ob) == OB_TOD)
        s7_tod_ended(cpu, top->ob);
    const bool ends_delay = s7_ob_kind(top->ob) != OB_SYNC_ERROR; /* [OBS-62], AMB-24 */
    cpu->depth--;
    if (ends_delay)
        s7_airt_ob_ended(cpu);
}

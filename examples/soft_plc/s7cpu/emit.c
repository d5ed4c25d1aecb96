/* Events for the sink, with the time at which they happen. */
#include "internal.h"

void s7_emit(struct s7cpu *cpu, struct s7cpu_event event)
{
    event.at = s7cpu_clock(cpu);
    event.up = cpu->up;
    if (cpu->sink != NULL)
        cpu->sink(cpu->context, &event);
}

/* [T15-131, T15-132, T15-135] */
static struct s7cpu_info in_layout(struct s7cpu_info i, bool optimised)
{
    if (optimised)
        i.time = i.priority = i.strt_info = i.period = i.dtime = i.error_info = i.ev = i.ev_ob = S7CPU_NONE;
    else
        i.caught_up = i.second_time = i.csg_ob = i.csg_priority = i.event_count = S7CPU_NONE;
    return i;
}

void s7_emit_start(struct s7cpu *cpu, int ob, const struct s7cpu_info *info)
{
    const struct s7cpu_info shown = in_layout(*info, s7_ob_is_optimised(cpu, ob));
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_OB_START, .ob = ob, .info = &shown});
}

void s7_emit_diag(struct s7cpu *cpu, int id, int ob, const struct s7cpu_info *info)
{
    const struct s7cpu_info shown = info != NULL ? in_layout(*info, false) : (struct s7cpu_info){0};
    s7_emit(cpu, (struct s7cpu_event){
                     .kind = S7CPU_DIAG, .id = id, .ob = ob, .info = info != NULL ? &shown : NULL});
}

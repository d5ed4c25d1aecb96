/* Events for the sink, with the time at which they happen. */
#include "internal.h"

void s7_emit(struct s7cpu *cpu, struct s7cpu_event event)
{
    event.at = s7cpu_clock(cpu);
    event.up = cpu->up;
    if (cpu->sink != NULL)
        cpu->sink(cpu->context, &event);
}

void s7_emit_start(struct s7cpu *cpu, int ob, const struct s7cpu_info *info)
{
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_OB_START, .ob = ob, .info = info});
}

void s7_emit_diag(struct s7cpu *cpu, int id, int ob, const struct s7cpu_info *info)
{
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_DIAG, .id = id, .ob = ob, .info = info});
}

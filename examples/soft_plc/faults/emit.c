#include "variant.h"

void faulty_emit(struct s7cpu *cpu, struct s7cpu_event event)
{
    if (event.kind == S7CPU_TO_STOP && event.id == CAUSE_SWITCH && cpu->loaded[80] &&
        has(cpu, FAULT_STOP_CAUSE))
        event.id = CAUSE_OB80_MISSING;
    s7_emit(cpu, event);
}
SUBSTITUTES(emit);

void faulty_emit_start(struct s7cpu *cpu, int ob, const struct s7cpu_info *right)
{
    struct s7cpu_info info = *right;
    if (s7_ob_kind(ob) == OB_STARTUP && has(cpu, FAULT_STARTUP_TIME))
        info.time -= S7CPU_HOUR;
    s7_emit_start(cpu, ob, &info);
}
SUBSTITUTES(emit_start);

void faulty_emit_diag(struct s7cpu *cpu, int id, int ob, const struct s7cpu_info *info)
{
    s7_emit_diag(cpu, id == 0x3506 && has(cpu, FAULT_DIAG_3505) ? 0x3505 : id, ob, info);
}
SUBSTITUTES(emit_diag);

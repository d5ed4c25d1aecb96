#include "variant.h"

int faulty_status(const struct s7cpu *cpu, int ob)
{
    int status = s7_status(cpu, ob);
    if (s7_ob_kind(ob) == OB_DELAY && s7_ob_is_running(cpu, ob) &&
        has(cpu, FAULT_DINT_RUNNING_ACTIVE))
        status |= 1 << 2;
    if (has(cpu, FAULT_IRT_NO_STATUS))
        status &= ~(1 << 1);
    if (has(cpu, FAULT_QRY_NO_LOADED))
        status &= ~(1 << 4);
    return status;
}
SUBSTITUTES(status);

struct s7cpu_state faulty_state(const struct s7cpu *cpu, int ob)
{
    struct s7cpu_state s = s7_state(cpu, ob);
    if (s.active != S7CPU_NONE && has(cpu, FAULT_STATE_ACTIVE))
        s.active = !s.active;
    if (s.blocked != S7CPU_NONE && has(cpu, FAULT_STATE_BLOCKED))
        s.blocked = 0;
    if (has(cpu, FAULT_STATE_LOADED))
        s.loaded = 1;
    if (s.entries_off != S7CPU_NONE && has(cpu, FAULT_STATE_ENTRIES))
        s.entries_off = 0;
    if (s.left != S7CPU_NONE && has(cpu, FAULT_STATE_LEFT))
        s.left += 100;
    return s;
}
SUBSTITUTES(state);

#include "variant.h"

int faulty_status(const struct s7cpu *cpu, int ob, bool active)
{
    bool waits = s7_ob_kind(ob) == OB_DELAY && s7_queue_has(cpu, ob);
    int status = s7_status(cpu, ob, active || (waits && has(cpu, FAULT_DINT_WAITING_ACTIVE)));
    if (has(cpu, FAULT_IRT_NO_STATUS))
        status &= ~(1 << 1);
    if (has(cpu, FAULT_QRY_NO_LOADED))
        status &= ~(1 << 4);
    return status;
}
SUBSTITUTES(status);

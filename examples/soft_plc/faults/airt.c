#include "variant.h"

int faulty_airt_disable(struct s7cpu *cpu)
{
    if (has(cpu, FAULT_AIRT_FLAG))
        cpu->delay_count = 0;
    return s7_airt_disable(cpu);
}
SUBSTITUTES(airt_disable);

int faulty_airt_enable(struct s7cpu *cpu)
{
    if (has(cpu, FAULT_AIRT_EN_ALL) && cpu->delay_count > 0)
        cpu->delay_count = 1;
    int ret = s7_airt_enable(cpu);
    return ret == RET_NOT_DELAYED && has(cpu, FAULT_AIRT_EN_ZERO) ? RET_OK : ret;
}
SUBSTITUTES(airt_enable);

void faulty_airt_ob_ended(struct s7cpu *cpu)
{
    if (has(cpu, FAULT_IRT_ENDS_WITH_OB))
        s7_irt_restart(cpu);
    if (!has(cpu, FAULT_AIRT_KEEPS_COUNT))
        s7_airt_ob_ended(cpu);
}
SUBSTITUTES(airt_ob_ended);

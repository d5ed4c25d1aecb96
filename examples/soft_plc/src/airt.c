#include "airt.h"

#include "ret.h"

enum { COUNT_MAX = 32767 }; /* the largest value of an INT [AIRT-14] */

int sfc_dis_airt(struct cpu *cpu)
{
    if (cpu_fault(cpu, FAULT_AIRT_FLAG))
        cpu->delay_count = 1;
    else if (cpu->delay_count < COUNT_MAX)
        cpu->delay_count++; /* [AIRT-03, AIRT-06] */
    return cpu->delay_count;
}

int sfc_en_airt(struct cpu *cpu)
{
    if (cpu->delay_count == 0)
        return cpu_fault(cpu, FAULT_AIRT_EN_ZERO) ? 0 : RET_NOT_DELAYED; /* [AIRT-07] */
    cpu->delay_count = cpu_fault(cpu, FAULT_AIRT_EN_ALL) ? 0 : cpu->delay_count - 1;
    return cpu->delay_count;
}

void airt_ob_ended(struct cpu *cpu)
{
    if (!cpu_fault(cpu, FAULT_AIRT_KEEPS_COUNT))
        cpu->delay_count = 0; /* [AIRT-04]; OB 1 too, AMB-25 */
}

bool airt_delays(const struct cpu *cpu, int ob)
{
    return cpu->delay_count > 0 && !(ob == 80 && cpu_fault(cpu, FAULT_AIRT_IGNORES_OB80));
}

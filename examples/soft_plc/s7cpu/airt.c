/* SFC 41 and 42: the delay count of the running OB. */
#include "internal.h"

enum { COUNT_MAX = 32767 }; /* the largest value of an INT [AIRT-14] */

int s7_airt_disable(struct s7cpu *cpu)
{
    if (cpu->delay_count < COUNT_MAX)
        cpu->delay_count++; /* [AIRT-03, AIRT-06] */
    return cpu->delay_count;
}

int s7_airt_enable(struct s7cpu *cpu)
{
    if (cpu->delay_count == 0)
        return RET_NOT_DELAYED; /* [AIRT-07] */
    return --cpu->delay_count;
}

void s7_airt_ob_ended(struct s7cpu *cpu)
{
    cpu->delay_count = 0; /* [AIRT-04]; OB 1 too, AMB-25 */
}

bool s7_airt_delays(const struct s7cpu *cpu)
{
    return cpu->delay_count > 0;
}

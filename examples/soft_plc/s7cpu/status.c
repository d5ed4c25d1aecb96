#include "internal.h"

int s7_status(const struct s7cpu *cpu, int ob, bool active)
{
    int status = 0; /* bits 3, 5 and 7 to 15 are 0, bit 6 too: base time [TINT-75, 77 to 79] */
    if (cpu->mode == S7CPU_STARTUP)
        status |= 1 << 0; /* [TINT-72], AMB-03 */
    if (cpu->mask[ob].blocked)
        status |= 1 << 1; /* [IRT-17]; a delay by SFC 41 does not show [AIRT-13] */
    if (active)
        status |= 1 << 2; /* [TINT-74] */
    if (cpu->loaded[ob])
        status |= 1 << 4; /* [TINT-76] */
    return status;
}

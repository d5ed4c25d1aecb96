/* One mask for each OB, and the last call wins (AMB-21, reading a); a flag that does not count
 * [IRT-16]. Requests that wait already still run (AMB-72, reading a). */
#include "internal.h"

void s7_irt_block(struct s7cpu *cpu, int ob, bool silent)
{
    cpu->mask[ob] = (struct s7cpu_mask){.blocked = true, .silent = silent};
}

void s7_irt_open(struct s7cpu *cpu, int ob)
{
    cpu->mask[ob] = (struct s7cpu_mask){.blocked = false};
}

bool s7_irt_blocks(const struct s7cpu *cpu, int ob)
{
    return cpu->mask[ob].blocked;
}

bool s7_irt_silences(const struct s7cpu *cpu, int ob)
{
    return cpu->mask[ob].silent;
}

void s7_irt_restart(struct s7cpu *cpu)
{
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        s7_irt_open(cpu, ob);
}

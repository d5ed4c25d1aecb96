#include "internal.h"

/* Under SFC 39 there is neither OB 80 nor STOP, and what was late still runs (AMB-23, reading a;
 * AMB-48, either: reading a). AMB-49, either: a time error without OB 80 stops the CPU at once,
 * delayed or not (reading a) [CLK-05, OBS-22, AIRT-11]. */
void s7_time_error(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    s7_diag_error(cpu, r);
    if (s7_irt_blocks(cpu, r->ob))
        return;
    if (cpu->loaded[r->ob])
        s7_queue_put(cpu, r);
    else
        s7_stop(cpu, CAUSE_OB80_MISSING);
}

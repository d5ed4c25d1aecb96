#include "internal.h"

/* Under SFC 39 there is neither OB 80 nor STOP, and what was late still runs (AMB-23, reading a;
 * AMB-48, either: reading a). Without OB 80 the CPU stops [CLK-05, OBS-22]. */
void s7_time_error(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    s7_diag_error(cpu, r);
    if (s7_irt_blocks(cpu, r->ob))
        return;
    if (!cpu->loaded[r->ob] && s7_missing_is_noticed(cpu))
        s7_error_missing_async(cpu, r);
    else
        s7_queue_put(cpu, r);
}

bool s7_time_error_stops(const struct s7cpu *cpu)
{
    bool stops = cpu->mode == S7CPU_STOP;
    for (int i = 0; i < cpu->queue_length; i++)
        stops |= cpu->queue[i].stops && !s7_family(cpu)->ignores_missing;
    return stops;
}

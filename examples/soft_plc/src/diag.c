#include "diag.h"

#include "irt.h"
#include "modes.h"

enum { EVENT_SUPPRESSED = 0x5380 };

static void enter(struct cpu *cpu, int id, int ob, const struct start_info *info)
{
    if (cpu->config.log_diag)
        log_diag(cpu->log, cpu, id, ob, info);
}

/* Table 8.3 has these events in class 35; the others of OB 85 have ids of their own. */
static bool known(int id)
{
    return (id >= 0x3501 && id <= 0x350B) || (id >= 0x35A1 && id <= 0x35A3);
}

void diag_error(struct cpu *cpu, const struct request *r)
{
    int id = 0x3500 | r->info.flt_id;
    if (id == 0x3506 && cpu_fault(cpu, FAULT_DIAG_3505))
        id = 0x3505;
    if (!known(id))
        return;
    if (!irt_silences(cpu, r->ob))
        enter(cpu, id, r->ob, &r->info);
    else if (cpu_fault(cpu, FAULT_DIAG_5380_EACH)) /* once for the call (AMB-41, reading a) */
        diag_suppressed(cpu);
}

void diag_stop(struct cpu *cpu, int cause)
{
    if ((cause == CAUSE_OB80_MISSING || cause == CAUSE_OB85_MISSING) &&
        !cpu_fault(cpu, FAULT_DIAG_NO_STOP))
        enter(cpu, cause, -1, NULL);
}

void diag_suppressed(struct cpu *cpu)
{
    enter(cpu, EVENT_SUPPRESSED, -1, NULL);
}

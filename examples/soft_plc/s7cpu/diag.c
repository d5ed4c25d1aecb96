#include "internal.h"

enum { EVENT_SUPPRESSED = 0x5380 };

/* Table 8.3 has these events in class 35; the others of OB 85 have ids of their own. */
int s7_diag_id(const struct s7cpu_request *r)
{
    int id = 0x3500 | r->info.flt_id;
    bool known = (id >= 0x3501 && id <= 0x350B) || (id >= 0x35A1 && id <= 0x35A3);
    return known ? id : 0;
}

void s7_diag_error(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    int id = s7_diag_id(r);
    if (id != 0 && !s7_irt_silences(cpu, r->ob))
        s7_emit_diag(cpu, id, r->ob, &r->info);
}

void s7_diag_stop(struct s7cpu *cpu, int cause)
{
    if (cause == CAUSE_OB80_MISSING || cause == CAUSE_OB85_MISSING)
        s7_emit_diag(cpu, cause, S7CPU_NONE, NULL);
}

/* Once for the call (AMB-41, reading a). */
void s7_diag_suppressed(struct s7cpu *cpu)
{
    s7_emit_diag(cpu, EVENT_SUPPRESSED, S7CPU_NONE, NULL);
}

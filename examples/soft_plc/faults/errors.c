/* OB 80, OB 85, and what happens without them. */
#include "variant.h"

void faulty_stop(struct s7cpu *cpu, int cause)
{
    bool runs_on = (cause == CAUSE_OB80_MISSING && has(cpu, FAULT_MISSING_OB80_RUNS_ON)) ||
                   (cause == CAUSE_OB85_MISSING && has(cpu, FAULT_MISSING_OB85_RUNS_ON)) ||
                   (cause == CAUSE_NONE && has(cpu, FAULT_ASYNC_RUNS_ON));
    if (!runs_on)
        s7_stop(cpu, cause);
}
SUBSTITUTES(stop);

void faulty_error_missing(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    if (s7_ob_kind(r->ob) == OB_ASYNC_ERROR || !has(cpu, FAULT_MISSING_SILENT))
        s7_error_missing(cpu, r);
    else if (s7_ob_kind(r->ob) == OB_TOD)
        s7_tod_used_up(cpu, r->ob);
}
SUBSTITUTES(error_missing);

void faulty_error_overlap(struct s7cpu *cpu, int ob, int z1)
{
    if (s7_ob_kind(ob) == OB_DELAY && has(cpu, FAULT_DINT_OVERLAP_SILENT))
        return;
    if (s7_ob_kind(ob) == OB_DELAY && has(cpu, FAULT_DINT_OVERLAP_DTIME))
        z1 = cpu->dint[s7cpu_dint_index(ob)].dtime;
    s7_error_overlap(cpu, ob, z1);
}
SUBSTITUTES(error_overlap);

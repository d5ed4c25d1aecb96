#include "variant.h"

void faulty_diag_error(struct s7cpu *cpu, const struct s7cpu_request *r)
{
    s7_diag_error(cpu, r);
    if (s7_diag_id(r) != 0 && s7_irt_silences(cpu, r->ob) && has(cpu, FAULT_DIAG_5380_EACH))
        s7_diag_suppressed(cpu);
}
SUBSTITUTES(diag_error);

void faulty_diag_stop(struct s7cpu *cpu, int cause)
{
    if (!has(cpu, FAULT_DIAG_NO_STOP))
        s7_diag_stop(cpu, cause);
}
SUBSTITUTES(diag_stop);

void faulty_diag_suppressed(struct s7cpu *cpu)
{
    if (!has(cpu, FAULT_DIAG_NO_5380))
        s7_diag_suppressed(cpu);
}
SUBSTITUTES(diag_suppressed);

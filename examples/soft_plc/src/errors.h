/* Time errors (OB 80), missing OBs (OB 85), and the STOP where those are missing. */
#ifndef ERRORS_H
#define ERRORS_H

#include "cpu.h"

/* Fault 02: the OB fell due while it is still processed [TINT-14, DINT-10]; `z1` is byte 6-7 of
 * its start information: PERIOD or SIGN. */
void errors_overlap(struct cpu *cpu, int ob, int z1);
/* Fault 05 or 06: bit k of `late` means OB 10+k [CLK-06]. */
void errors_skipped(struct cpu *cpu, int flt_id, unsigned late, dt_ms before);
/* Fault 07: the request buffer is full [OBS-08]. */
void errors_overflow(struct cpu *cpu, int ob);
/* An event of OB 80 to 87 whose OB is missing. */
void errors_missing_async(struct cpu *cpu, int ob);
/* The OB of a request is to be called and is missing [TINT-16, OBS-20]. */
void errors_missing(struct cpu *cpu, const struct request *r);

#endif

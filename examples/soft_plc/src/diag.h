/* Entries of the diagnostic buffer, where the log lists them (table 8.3). */
#ifndef DIAG_H
#define DIAG_H

#include "cpu.h"

/* The error that OB 80 or 85 is requested for: 35xx, with its start information. */
void diag_error(struct cpu *cpu, const struct request *r);
/* The CPU stops because OB 80 or 85 is missing: 4568, 456D; nothing for other causes. */
void diag_stop(struct cpu *cpu, int cause);
/* DIS_IRT suppresses entries: 5380. */
void diag_suppressed(struct cpu *cpu);

#endif

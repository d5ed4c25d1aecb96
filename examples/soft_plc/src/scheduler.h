/* Which OB runs: dispatch by priority class, start and end of OBs. */
#ifndef SCHEDULER_H
#define SCHEDULER_H

#include "cpu.h"

/* Calls the OB of the request that is next, if one may interrupt the running OB.
 * False where nothing was to be done. */
bool scheduler_dispatch(struct cpu *cpu);
/* Starts an OB that is loaded. */
void scheduler_start(struct cpu *cpu, const struct request *r);
/* Begins a cycle of OB 1. */
void scheduler_start_cycle(struct cpu *cpu);
/* An OB that is running already when the log begins: it has no start line. */
void scheduler_enter(struct cpu *cpu, int ob);
/* The running OB has been processed to its end. */
void scheduler_end(struct cpu *cpu);

#endif

/* Time-delay interrupts: SFC 32 to 34 on OB 20 to 23, and their delays in elapsed time. */
#ifndef DINT_H
#define DINT_H

#include "cpu.h"

int sfc_srt_dint(struct cpu *cpu, int ob, int64_t dtime, int sign);
int sfc_can_dint(struct cpu *cpu, int ob);
int sfc_qry_dint(struct cpu *cpu, int ob, int *status);

/* A warm or cold restart discards every job [DINT-13]. */
void dint_restart(struct cpu *cpu);
/* Enters a request for every delay that has elapsed. */
void dint_poll(struct cpu *cpu);
/* Elapsed time at which the next delay ends, INT64_MAX where none runs. */
int64_t dint_next_up(const struct cpu *cpu);
/* HOLD is over: it froze the delays for this long [DINT-19]. */
void dint_released(struct cpu *cpu, int64_t held);
/* The clock has moved; a delay does not follow it [DINT-18]. */
void dint_clock_changed(struct cpu *cpu, int64_t by);

#endif

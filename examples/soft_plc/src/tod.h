/* Time-of-day interrupts: SFC 28 to 31 on OB 10 to 17, and their start points. */
#ifndef TOD_H
#define TOD_H

#include "cpu.h"

int sfc_set_tint(struct cpu *cpu, int ob, const struct civil *sdt, int period);
int sfc_can_tint(struct cpu *cpu, int ob);
int sfc_act_tint(struct cpu *cpu, int ob);
int sfc_qry_tint(struct cpu *cpu, int ob, int *status);

/* Drops what SFCs have set; the STEP 7 parameters apply [OBS-50]. */
void tod_restart(struct cpu *cpu);
/* The CPU begins in RUN with its STEP 7 parameters in force and nothing pending. */
void tod_begin_running(struct cpu *cpu);
/* Enters a request for every start point that the clock has reached. */
void tod_poll(struct cpu *cpu);
/* Elapsed time of the next start point, INT64_MAX where there is none. */
int64_t tod_next_up(const struct cpu *cpu);
/* The OB of a request is called, or would be called and is missing [TINT-08, AMB-46]. */
void tod_called(struct cpu *cpu, int ob);
/* Withdraws or repeats after the clock has been moved to the present reading. */
void tod_clock_changed(struct cpu *cpu, dt_ms before);
/* Points that passed in HOLD [OBS-46]. */
void tod_released(struct cpu *cpu, dt_ms before);

#endif

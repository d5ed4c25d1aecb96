/* Operating modes and their transitions. */
#ifndef MODES_H
#define MODES_H

#include "cpu.h"

/* Event IDs of the causes of a STOP (table 8.3). */
enum {
    CAUSE_NONE = -1,
    CAUSE_SWITCH = 0x4303,
    CAUSE_CLASS_SYSTEM = 0x4541,
    CAUSE_DESELECTED_LOADED = 0x454A,
    CAUSE_OB80_MISSING = 0x4568,
    CAUSE_OB85_MISSING = 0x456D
};

void modes_stop(struct cpu *cpu, int cause);
void modes_restart(struct cpu *cpu, bool cold);
/* The startup OB is at its end: mode RUN. */
void modes_run(struct cpu *cpu);
void modes_hold(struct cpu *cpu);
void modes_release(struct cpu *cpu);

#endif

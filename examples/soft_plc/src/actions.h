/* Carries out the instructions of OBs and the actions from outside, and logs them. */
#ifndef ACTIONS_H
#define ACTIONS_H

#include "cpu.h"

void actions_step(struct cpu *cpu, const struct step *step);
/* One action whose time has come; false where there is none. */
bool actions_poll(struct cpu *cpu);

#endif

/* Carries out the instructions of OBs and the actions from outside. */
#ifndef ACTIONS_H
#define ACTIONS_H

#include "program.h"

/* An instruction that takes no time, of the running OB. */
void actions_step(struct s7cpu *cpu, const struct step *step);
void actions_act(struct s7cpu *cpu, const struct action *action);

#endif

/* SFC 41 and 42: the delay count of the running OB. */
#ifndef AIRT_H
#define AIRT_H

#include "cpu.h"

int sfc_dis_airt(struct cpu *cpu);
int sfc_en_airt(struct cpu *cpu);
/* An OB has been processed to its end. */
void airt_ob_ended(struct cpu *cpu);
/* True where a request of this OB has to wait for the end of the delay [AIRT-01, AIRT-09]. */
bool airt_delays(const struct cpu *cpu, int ob);

#endif

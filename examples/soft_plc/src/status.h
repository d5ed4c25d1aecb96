/* STATUS of SFC 31 and 34, one scheme for both [TINT-72 to TINT-79, DINT-16]. */
#ifndef STATUS_H
#define STATUS_H

#include "cpu.h"

int status_word(const struct cpu *cpu, int ob, bool active);

#endif

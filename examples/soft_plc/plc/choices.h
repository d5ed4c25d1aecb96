/* The choices of the library by the names of the requirements: AMB-34=b, OBS-10=call. */
#ifndef CHOICES_H
#define CHOICES_H

#include <stdio.h>

#include "s7cpu.h"

/* Sets the one that `text`, NAME=VALUE, names; false where it is none. */
bool choice_set(struct s7cpu_choices *choices, const char *text);
void choices_help(FILE *out);

#endif

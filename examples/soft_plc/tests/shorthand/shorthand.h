/* A shorthand for the programs of the tests: settings, `at` and `every` for events from outside,
 * `ob 10 run 1 { ... }` for bodies, a statement a line. */
#ifndef SHORTHAND_H
#define SHORTHAND_H

#include "scenario.h"

/* Reads a whole text; false with the scenario's `error` set where it is wrong. */
bool shorthand_read(struct scenario *s, const char *file, FILE *in);

#endif

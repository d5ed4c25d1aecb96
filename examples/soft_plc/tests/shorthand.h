/* A shorthand for the programs of the tests. */
#ifndef SHORTHAND_H
#define SHORTHAND_H

#include "scenario.h"
#include "values.h"

/* Reads a text, which it takes apart; false with the scenario's `error` set where the reader of
 * programs refuses it. */
bool shorthand_read(struct scenario *s, char *text);

#endif

/* The values of a program as a log spells them. */
#ifndef VALUES_H
#define VALUES_H

#include <stdbool.h>
#include <stdint.h>

#include "s7cpu.h"

/* Each reads a whole text; false where it is not a value of that kind. */

/* A decimal number. */
bool value_integer(const char *s, int64_t low, int64_t high, int64_t *value);
/* W#16#0201, 16#0201, B#16#80: 0 to `high`. */
bool value_word(const char *s, int high, int *value);
/* TIME: T#1s500ms, T#-1m_30s; 32 bits, milliseconds. */
bool value_time(const char *s, int64_t *ms);
/* 2026-11-21T06:00[:00[.000]] or DT#2026-11-21-06:00[:00[.000]]; the date need not exist. */
bool value_civil(const char *s, struct s7cpu_date *date);
/* The same, of a date that exists, as milliseconds. */
bool value_dt(const char *s, int64_t *ms);

#endif

/* Text that is written piece by piece into a buffer of a fixed size, without printf: a log
 * of ten million lines spends most of its time here. */
#ifndef TEXT_H
#define TEXT_H

#include <stddef.h>
#include <stdint.h>

#include "calendar.h"

/* The caller keeps enough room; every function returns the new end. */
char *text_str(char *p, const char *s);
char *text_int(char *p, int64_t n);
char *text_digits(char *p, unsigned n, int width);
/* "16#0201" with its quotes. */
char *text_word(char *p, int value, int digits);
/* "2026-11-21T06:00:00.000" with its quotes; the date need not exist. */
char *text_civil(char *p, const struct civil *c);
char *text_dt(char *p, dt_ms t);

#endif

/* The words of a scenario line and the values they stand for. */
#ifndef WORDS_H
#define WORDS_H

#include <stdbool.h>
#include <stdint.h>

#include "s7cpu.h"

enum { WORDS_MAX = 64 };

struct words {
    int count;
    char *word[WORDS_MAX];
};

/* Splits a line in place; a word that begins with # begins a comment. False: too many words. */
bool words_split(char *line, struct words *w);

/* Each reads a whole word; false where it is not a value of that kind. */
bool word_int(const char *s, int64_t low, int64_t high, int64_t *value);
/* W#16#0201, 16#0201, B#16#80 or a decimal number, 0 to `high`. */
bool word_hex(const char *s, int high, int *value);
/* 1500ms, 5s, 10min, 2h, 3d, also combined (1s500ms) and with T# before it. */
bool word_duration(const char *s, int64_t *ms);
/* A TIME: a duration or a number of milliseconds, either also negative, within 32 bits. */
bool word_time(const char *s, int64_t *ms);
/* 2026-11-21T06:00[:00[.000]], also DT#2026-11-21-06:00:00.000; the date need not exist. */
bool word_civil(const char *s, struct s7cpu_date *c);
/* The same, of a date that exists. */
bool word_dt(const char *s, int64_t *t);

#endif

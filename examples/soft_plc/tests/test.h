/* A small harness: a failed check names its line, the run goes on. */
#ifndef TEST_H
#define TEST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "faults.h"

void test_check(bool ok, const char *file, int line, const char *text);
#define CHECK(condition) test_check((condition), __FILE__, __LINE__, #condition)

/* Runs a scenario given as text, with one fault or 0, and returns its log, to be freed; with
 * `base` settings where the text does not begin with "cpu". A wrong scenario fails the test and
 * gives "". */
char *test_run(const char *scenario, enum fault fault);
/* One text after the other, within `size`. */
void test_join(char *to, size_t size, const char *first, const char *second);
/* Log of the random program, to be freed. */
char *test_random(uint64_t seed, uint64_t events, enum fault fault);

/* The pieces occur in this order, each in a later line than the one before; ends with NULL. */
bool test_in_order(const char *log, ...);
int test_count(const char *log, const char *piece);

void test_calendar(void);
void test_calls(void);
void test_dint(void);
void test_irt(void);
void test_diag(void);
void test_faults(void);
void test_s7_1500(void);
void test_scheduling(void);
void test_choices(void);
void test_clock(void);
void test_modes(void);
void test_program(void);
void test_random_program(void);

#endif

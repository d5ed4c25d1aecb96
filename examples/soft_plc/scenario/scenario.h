/* A scenario: settings of the CPU, bodies of OBs, actions from outside. */
#ifndef SCENARIO_H
#define SCENARIO_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "plc.h"

/* What an OB does when it is started for the `run`-th time; run 0: every other time. */
struct body {
    int ob;
    uint32_t run;
    struct step *steps;
    uint32_t count, room;
};

struct timed_action {
    int64_t up;
    int64_t every; /* 0: once */
    int place; /* in the list of the file */
    struct action action;
};

struct scenario {
    struct program program; /* first, so that the program's functions find the scenario */
    struct plc_config config;
    bool latency_given;
    bool random;
    uint64_t seed;
    struct body *bodies;
    uint32_t body_count, body_room;
    struct timed_action *actions; /* the rest, in the order of their times */
    uint32_t action_count, action_room, action_next;
    char error[400]; /* file:line: field: what was expected */
};

/* Reads a program, JSON of the format s7-interrupt-program/1, whose text begins at this line of the
 * file; false with `error` set where it is wrong. To be freed in either case. */
bool scenario_read(struct scenario *s, const char *file, int line, const char *text,
                   size_t length);
/* After the last body and action: they become the program of the CPU. */
void scenario_end(struct scenario *s);
void scenario_free(struct scenario *s);

#endif

/* A random program, reproducible from its seed, in constant memory: load for a checker. */
#ifndef RANDOM_PROGRAM_H
#define RANDOM_PROGRAM_H

#include "program.h"

struct random_program {
    struct program program; /* first, as in a scenario */
    uint64_t state;
    int64_t next_action;
    int last_set;    /* OB_NR of the last SFC 28 */
    bool activates;  /* SFC 30 for it is next */
    bool hot;        /* the CPU has hot restarts */
    bool states;     /* SZL 16#0222 is read now and then; false: never */
};

void random_program(struct random_program *r, uint64_t seed);
/* Settings drawn from the seed, for a run without a scenario; the family too where it is NULL. */
void random_config(struct random_program *r, struct s7cpu_config *config,
                   const enum s7cpu_family *family);

#endif

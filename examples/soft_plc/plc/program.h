/* What the user program does, and what happens to the CPU from outside. A scenario file
 * and the random program are two implementations of the same interface. */
#ifndef PROGRAM_H
#define PROGRAM_H

#include <stdbool.h>
#include <stdint.h>

#include "s7cpu.h"

enum step_kind {
    STEP_BUSY,
    STEP_SET_TINT,
    STEP_SET_TINTL,
    STEP_CAN_TINT,
    STEP_ACT_TINT,
    STEP_QRY_TINT,
    STEP_SRT_DINT,
    STEP_CAN_DINT,
    STEP_QRY_DINT,
    STEP_DIS_IRT,
    STEP_EN_IRT,
    STEP_DIS_AIRT,
    STEP_EN_AIRT,
    STEP_SET_CLOCK,
    STEP_MOVE_CLOCK,
    STEP_SET_ZONE,
    STEP_STATE /* SZL 16#0222 of an OB is read */
};

/* One instruction of an OB. The arguments may be wrong: the SFCs answer that. */
struct step {
    enum step_kind kind;
    int ob;
    int period;
    int sign;
    int mode; /* of SFC 39 and 40 */
    struct s7cpu_date sdt;
    bool local, activate;
    bool daylight; /* set zone: because of it */
    int64_t ms; /* DTIME; busy: duration; set clock: the new reading; move clock: by how much; set zone */
};

enum action_kind {
    ACTION_SET_CLOCK,
    ACTION_MOVE_CLOCK,
    ACTION_SET_ZONE,
    ACTION_INTERRUPT,
    ACTION_STOP,
    ACTION_RESTART_WARM,
    ACTION_RESTART_COLD,
    ACTION_RESTART_HOT,
    ACTION_HOLD,
    ACTION_RELEASE,
    ACTION_LOAD,
    ACTION_DELETE,
    ACTION_STATE
};

/* Something that comes from outside: an operator, a module, a clock master. */
struct action {
    enum action_kind kind;
    int ob;
    int flt_id; /* OB 80 and 85 only, else S7CPU_NONE */
    bool daylight;
    int64_t ms; /* set clock: the new reading; move clock: by how much; set zone */
};

/* A run of an OB. */
struct activation {
    int ob;
    uint32_t run;     /* how often this OB has been started, this time included */
    int64_t began;    /* elapsed time */
    int64_t busy;     /* elapsed time that the current instruction still takes */
    const void *body; /* these two are the program's own to use */
    uint32_t step;
};

struct program {
    /* An OB begins. */
    void (*begin)(struct program *p, const struct s7cpu *cpu, struct activation *a);
    /* The next instruction of an OB; false at its end. */
    bool (*next)(struct program *p, const struct s7cpu *cpu, struct activation *a,
                 struct step *step);
    /* True where this and all later cycles are empty, so that time may pass at once. */
    bool (*idle)(struct program *p, const struct s7cpu *cpu);
    /* Elapsed time of the next action, INT64_MAX where there is none. */
    int64_t (*action_time)(struct program *p);
    /* Takes that action; false where nothing is to be done after all. */
    bool (*take_action)(struct program *p, const struct s7cpu *cpu, struct action *action);
};

#endif

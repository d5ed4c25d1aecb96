/* s7cpu - the interrupt functions of an S7-300, S7-400, CPU 318 or S7-1500 in C11: SFC 28 to 34 and
 * 39 to 42, OB 10 to 17, OB 20 to 23, start events from outside, the settable clock, OB 80, OB 85, the
 * diagnostic buffer, HOLD, STOP and restart.
 *
 * The library runs no user program and reads no clock. Its caller, an interpreter for the blocks
 * of a program, has one loop:
 *
 *     s7cpu_tick(cpu, elapsed_ms());        time passes: what falls due is noted
 *     ... what comes from outside: s7cpu_interrupt(), s7cpu_set_clock(), s7cpu_stop(), ...
 *     if (s7cpu_dispatch(cpu))              the operating system goes first: it starts an OB,
 *         continue;                         reports a missing one, begins a cycle
 *     run one instruction of the OB that s7cpu_top() names; an SFC is a call of s7cpu_set_tint(),
 *     ...; at the end of the OB s7cpu_end_ob()
 *
 * Everything that happens goes to the sink as an event, in the order in which it happens.
 *
 * All state is in struct s7cpu, which the caller owns: no globals, no allocation, no locks. Calls
 * for one struct come from one thread at a time, and not from inside the sink.
 *
 * Units: times are int64_t milliseconds. A reading of the CPU clock counts from 1990-01-01T00:00.
 * Elapsed time counts from s7cpu_init(); nobody sets it, and it runs on in HOLD and STOP. */
#ifndef S7CPU_H
#define S7CPU_H

#include <stdbool.h>
#include <stdint.h>

enum {
    S7CPU_TOD_FIRST = 10, /* OB 10 to 17 */
    S7CPU_DINT_FIRST = 20, /* OB 20 to 23 */
    /* OBs from 123 on, by event class: s7cpu_ob() [T15-10, T15-11]. */
    S7CPU_MORE = 128,
    S7CPU_MORE_TODS = S7CPU_MORE,
    S7CPU_MORE_DINTS = S7CPU_MORE_TODS + 20,
    S7CPU_MORE_CYCLICS = S7CPU_MORE_DINTS + 20,
    S7CPU_MORE_HARDWARE = S7CPU_MORE_CYCLICS + 20,
    S7CPU_MORE_STARTUPS = S7CPU_MORE_HARDWARE + 50,
    S7CPU_MORE_CYCLES = S7CPU_MORE_STARTUPS + 100,
    S7CPU_OBS = S7CPU_MORE_CYCLES + 100, /* all are below this */
    S7CPU_TODS = 8 + 20,
    S7CPU_DINTS = 4 + 20,
    S7CPU_DEPTH = 32,   /* OBs that have interrupted one another */
    S7CPU_WAITING = 512 /* start events that wait; with more the CPU stops (4541) */
};

#define S7CPU_NONE (-1) /* a field that does not apply */
#define S7CPU_MINUTE INT64_C(60000)
#define S7CPU_HOUR (60 * S7CPU_MINUTE)
#define S7CPU_DAY (24 * S7CPU_HOUR)
#define S7CPU_LAST (36525 * S7CPU_DAY - 1) /* 2089-12-31T23:59:59.999 */
#define S7CPU_NEVER INT64_MAX

enum s7cpu_family { S7CPU_S7_300, S7CPU_S7_400, S7CPU_CPU_318, S7CPU_S7_1500 };
enum s7cpu_mode { S7CPU_STOP, S7CPU_STARTUP, S7CPU_RUN, S7CPU_HOLD };

/* ---- OBs ---------------------------------------------------------------------------------- */

/* Here an OB is named by its number, one from 123 on by a place in the range of its class, which
 * s7cpu_ob() gives. SFCs have OB_NR, which is any number. */

/* The places of time-of-day and time-delay interrupts in arrays of their own, and back. */
static inline int s7cpu_tod_index(int ob)
{
    return ob < S7CPU_MORE ? ob - S7CPU_TOD_FIRST : ob - S7CPU_MORE_TODS + 8;
}
static inline int s7cpu_tod_ob(int index)
{
    return index < 8 ? S7CPU_TOD_FIRST + index : S7CPU_MORE_TODS + index - 8;
}
static inline int s7cpu_dint_index(int ob)
{
    return ob < S7CPU_MORE ? ob - S7CPU_DINT_FIRST : ob - S7CPU_MORE_DINTS + 4;
}
static inline int s7cpu_dint_ob(int index)
{
    return index < 4 ? S7CPU_DINT_FIRST + index : S7CPU_MORE_DINTS + index - 4;
}

/* ---- dates -------------------------------------------------------------------------------- */

/* A date and time as a program writes it; it need not exist. */
struct s7cpu_date {
    int year, month, day, hour, minute, second, ms;
};

/* True where the date exists, from 1990 to 2089. */
bool s7cpu_date_exists(const struct s7cpu_date *date);
/* ms since 1990-01-01, of a date that exists. */
int64_t s7cpu_ms(const struct s7cpu_date *date);
/* The other way round, for 0 to S7CPU_LAST. */
struct s7cpu_date s7cpu_date(int64_t ms);

/* ---- configuration ------------------------------------------------------------------------ */

enum s7cpu_execution {
    S7CPU_NOT_CONFIGURED,
    S7CPU_NO_EXECUTION, /* "none" */
    S7CPU_ONCE,
    S7CPU_EVERY_MINUTE,
    S7CPU_HOURLY,
    S7CPU_DAILY,
    S7CPU_WEEKLY,
    S7CPU_MONTHLY,
    S7CPU_YEARLY,
    S7CPU_END_OF_MONTH
};

/* What is assigned to a time-of-day interrupt with STEP 7. */
struct s7cpu_step7 {
    enum s7cpu_execution execution;
    int64_t start; /* a whole minute; S7CPU_NEVER where none is assigned */
    bool active;
    bool deselected;
    bool local; /* start: by local time [T15-20] */
};

/* Where the requirements leave a choice (docs/rules/readings.md); all false is one right CPU. */
struct s7cpu_choices {
    /* AMB-11: SFC 32 and 33 withdraw a delay interrupt that waits for its OB; else it runs. */
    bool waiting_delay_is_withdrawn;
    /* DINT-16: STATUS bit 2 of a delay interrupt that waits is 1; else 0. */
    bool waiting_delay_is_active;
    /* DINT-17, as exact as DINT-06: SZL 16#0222 shows a millisecond less than is left of a
     * delay; else what is left. */
    bool shows_less_time_left;
    /* OBS-03, AMB-69 (a): of interrupts that occurred in this moment the lowest class starts
     * first, to be interrupted at once; else the highest. */
    bool lowest_of_a_moment_first;
    /* AMB-34: STATUS bit 2 of a one-shot interrupt is 0 from its request on; else 1 until its start. */
    bool waiting_once_is_inactive;
    /* AMB-49: a missing OB stops the CPU when SFC 42 ends the delay; else at once. */
    bool stop_waits_for_delay;
    /* AMB-56, S7-400 and CPU 318, clock back: points after the last one for which the OB was called
     * are served; else none before the point that was next. */
    bool uncalled_points_are_served;
    /* AMB-60: SFC 30 for a one-shot interrupt that waits answers 80A1; else 0000. */
    bool waiting_once_is_past;
    /* AMB-71: a one-shot interrupt is over at the end of its OB; else at the start. */
    bool once_ends_with_its_ob;
    /* AMB-79: seconds 60 to 99 of SDT are ignored; else 8091. */
    bool wrong_seconds_are_ignored;
    /* OBS-26: SFC 43 has re-triggered the cycle monitoring in every cycle, so that a second excess of
     * the cycle time calls OB 80 again; else it stops the CPU. */
    bool cycle_is_retriggered;
    /* OBS-10: start information shows the time of the call; else that of the event. */
    bool info_has_time_of_call;
    /* OBS-52, AMB-26 (a): after a hot restart OB 80 reports the start points that passed in
     * STOP; else they are lost. */
    bool points_of_stop_are_reported;
    /* T15-130: OBs below 123 have the optimised start information, those from 123 on that of 20 bytes;
     * else it is the other way round. */
    bool old_obs_are_optimised;
};

/* The queue of OB 10 to 17, 30 to 38, 40 to 47 or of their event class [T15-68 to T15-73]. */
struct s7cpu_queue {
    int events;    /* to be queued, 1 to 12; 0: no parameters are assigned */
    int threshold; /* for the time error, 1 to events; 0: it is not enabled */
    int overflow;  /* 1: event 3507 is entered, 0: it is not, S7CPU_NONE: not assigned */
};

struct s7cpu_config {
    enum s7cpu_family family;
    struct s7cpu_choices choices;
    int numbers[S7CPU_OBS - S7CPU_MORE]; /* of OBs from 123 on: s7cpu_add_ob(); 0: none */
    bool loaded[S7CPU_OBS];
    int priority[S7CPU_OBS]; /* 0: default class; s7cpu_class_range() says which may differ */
    struct s7cpu_step7 step7[S7CPU_TODS]; /* s7cpu_tod_ob(index) */
    struct s7cpu_queue queue[S7CPU_OBS]; /* by s7cpu_has_queue() */
    int64_t clock;
    /* STOP, STARTUP or RUN. In RUN OB 1 is running and its past STEP 7 one-shot interrupt
     * is over; in STARTUP OB 100 is running, if it is loaded. */
    enum s7cpu_mode mode;
    int buffer; /* start events from outside that a class holds, 1 or more */
    int64_t zone; /* ms by which local time is ahead of the clock at first; 0 without s7cpu_has_local_time() */
};

/* An OB from 123 on is created with the event class of this range, S7CPU_MORE_TODS for instance: all
 * before anything else is said of one. False where there are too many or it is there already. */
bool s7cpu_add_ob(struct s7cpu_config *config, int number, int range);
/* The OB of this number, S7CPU_NONE where it is from 123 on and was not created; and back. */
int s7cpu_ob(const struct s7cpu_config *config, int number);
int s7cpu_ob_number(const struct s7cpu_config *config, int ob);
/* OB 1, or one that follows it in the cycle [T15-79]. */
bool s7cpu_ob_is_cycle(int ob);
/* True where a CPU of this family has such an OB. */
bool s7cpu_ob_exists(enum s7cpu_family family, int ob);
/* True where s7cpu_interrupt() takes this OB. */
bool s7cpu_ob_from_outside(int ob);
/* True where a CPU has a zone, local time in STEP 7 and SET_TINTL [T15-01, T15-20]. */
bool s7cpu_has_local_time(enum s7cpu_family family);
/* True where parameters of a queue can be assigned to an OB. */
bool s7cpu_has_queue(enum s7cpu_family family, int ob);
/* The classes that may be assigned to an OB; false where it has a fixed one. */
bool s7cpu_class_range(enum s7cpu_family family, int ob, int *low, int *high);

/* ---- events ------------------------------------------------------------------------------- */

enum s7cpu_event_kind {
    S7CPU_SET_TINT, /* ob, sdt, period, ret */
    S7CPU_SET_TINTL, /* ob, sdt, local, period, activate, ret */
    S7CPU_CAN_TINT, /* ob, ret */
    S7CPU_ACT_TINT, /* ob, ret */
    S7CPU_QRY_TINT, /* ob, ret, status */
    S7CPU_SRT_DINT, /* ob, dtime, sign, ret */
    S7CPU_CAN_DINT, /* ob, ret */
    S7CPU_QRY_DINT, /* ob, ret, status */
    S7CPU_DIS_IRT,  /* mode, ob, ret */
    S7CPU_EN_IRT,   /* mode, ob, ret */
    S7CPU_DIS_AIRT, /* ret */
    S7CPU_EN_AIRT,  /* ret */
    S7CPU_OB_START, /* ob, info */
    S7CPU_OB_END,   /* ob */
    S7CPU_CLOCK,    /* to; at is the reading before */
    S7CPU_ZONE,     /* zone, daylight */
    S7CPU_RESTART,  /* restart */
    S7CPU_TO_RUN,
    S7CPU_TO_STOP, /* id: the cause, or S7CPU_NONE */
    S7CPU_TO_HOLD,
    S7CPU_RELEASE,
    S7CPU_INTERRUPT, /* ob, flt_id: for OB 80 and 85, else S7CPU_NONE */
    S7CPU_LOAD,      /* ob */
    S7CPU_DELETE,    /* ob */
    S7CPU_DIAG,      /* id, ob or S7CPU_NONE, info or NULL: an entry of the diagnostic buffer */
    S7CPU_STATE      /* ob, state */
};

/* Start information of an OB. A field that does not apply, or that its layout has not [T15-130 to
 * T15-135], is S7CPU_NONE. */
struct s7cpu_info {
    int priority;
    int strt_info;
    int period;
    int sign;
    int dtime;
    int flt_id;
    int error_info;
    int ev;
    int ev_ob;
    int64_t time;
    /* In the optimised layout alone, beside sign and flt_id. */
    int caught_up, second_time; /* 0 or 1 */
    int csg_ob, csg_priority;   /* 0 where no OB was processed */
    int event_count;
};

/* The state of an OB, as SZL 16#0222 shows it [OBS-60]: 0 or 1, or S7CPU_NONE where the CPU does
 * not show it. In STOP it shows no more than `loaded`. */
struct s7cpu_state {
    int active; /* OB 10 to 17 and 20 to 23 */
    int blocked, entries_off; /* by SFC 39; OBs that it can block */
    int loaded;
    int left; /* ms, while a delay runs */
};

enum s7cpu_restart { S7CPU_WARM, S7CPU_COLD, S7CPU_HOT };
/* Only an S7-400 has a hot one [OBS-57], an S7-1500 a warm one alone [T15-115]. */
bool s7cpu_restart_exists(enum s7cpu_family family, enum s7cpu_restart type);

/* Only the fields that its kind names are set. */
struct s7cpu_event {
    enum s7cpu_event_kind kind;
    int64_t at; /* the CPU clock */
    int64_t up; /* elapsed time */
    int ob;
    struct s7cpu_date sdt;
    int period, sign, mode;
    bool local, activate;
    int64_t dtime;
    int ret, status;
    int flt_id, id;
    int64_t to;
    int64_t zone;  /* ms */
    bool daylight; /* daylight saving begins or ends; else another zone was set */
    enum s7cpu_restart restart;
    const struct s7cpu_info *info; /* this and the next: valid until the sink returns */
    const struct s7cpu_state *state;
};

typedef void s7cpu_sink(void *context, const struct s7cpu_event *event);

/* ---- state: the library's own, to be read by the functions below ----------------------------- */

/* A time-of-day interrupt, s7cpu_tod_ob(index). */
struct s7cpu_tod {
    bool set, active;
    bool called; /* a one-shot interrupt whose OB runs */
    int64_t start;
    bool local; /* start: by local time */
    int period;
    int64_t next;   /* the point that is due next; S7CPU_NEVER where none is left */
    int64_t served; /* the last point for which the OB was called; S7CPU_NONE where there is none */
    int64_t served_from; /* the first one since the clock was last set far back */
    int64_t again;  /* a run up to this point is the second one [T15-94]; S7CPU_NONE: none is */
};

/* The job of a time-delay interrupt, s7cpu_dint_ob(index). */
struct s7cpu_dint {
    bool started;
    int64_t end; /* elapsed time */
    int dtime;
    int sign;
};

/* What SFC 39 has done to an OB. */
struct s7cpu_mask {
    bool blocked;
    bool silent; /* its events are not entered in the diagnostic buffer */
};

/* A start event that waits for its OB. */
struct s7cpu_request {
    int ob;
    int rank; /* the class it is dispatched in */
    bool after_skip; /* not before OB 80 has reported skipped points [T15-91] */
    bool stops; /* OB 80 was missing: the CPU stops even if it is loaded under SFC 41 [OBS-22] */
    int64_t up; /* elapsed time when it occurred */
    bool keeps_time; /* info.time is not the time of the call, whatever the choice of OBS-10 */
    struct s7cpu_info info;
};

/* An OB that has been started and not processed to its end. */
struct s7cpu_frame {
    int ob;
    int rank;
    int flt_id;
    uint32_t run; /* how often this OB has been started, this time included */
};

/* What STOP leaves to a hot restart [OBS-52, OBS-54]. */
struct s7cpu_stopped {
    struct s7cpu_frame stack[S7CPU_DEPTH];
    int depth;
    int delay_count;
    struct s7cpu_request queue[S7CPU_WAITING];
    int queue_length;
    int64_t up; /* elapsed time since which the delays stand still */
};

struct s7cpu {
    struct s7cpu_config config;
    s7cpu_sink *sink;
    void *context;
    int64_t up;
    int64_t offset; /* CPU clock minus elapsed time */
    int64_t zone;   /* local time minus CPU clock */
    enum s7cpu_mode mode;
    enum s7cpu_mode held; /* that HOLD has interrupted */
    int64_t hold_began; /* elapsed time */
    bool loaded[S7CPU_OBS];
    struct s7cpu_tod tod[S7CPU_TODS];
    struct s7cpu_dint dint[S7CPU_DINTS];
    struct s7cpu_mask mask[S7CPU_OBS];
    int delay_count; /* of the running OB; one is enough [AIRT-12] */
    struct s7cpu_request queue[S7CPU_WAITING]; /* oldest first [OBS-07] */
    int queue_length;
    struct s7cpu_frame stack[S7CPU_DEPTH];
    int depth;
    uint32_t runs[S7CPU_OBS];
    int turn; /* the startup or cycle OB that was started last */
    struct s7cpu_stopped stopped;
    bool resuming; /* the STARTUP of a hot restart */
    /* OB 80 was called for it, or 3507 entered, and an event of it still waits or runs. */
    bool overloaded[S7CPU_OBS], overflowed[S7CPU_OBS];
    int discarded[S7CPU_OBS]; /* events, since the last one that was kept [T15-69] */
    bool cycle_exceeded; /* in the cycle of OB 1 that runs, with OB 80 called for it [OBS-26] */
};

/* ---- the CPU -------------------------------------------------------------------------------- */

/* Elapsed time is 0. The sink may be NULL. */
void s7cpu_init(struct s7cpu *cpu, const struct s7cpu_config *config, s7cpu_sink *sink,
                void *context);

/* Elapsed time is `up` now; it never goes back. Start points that the clock has reached and
 * delays that have ended become start events. */
void s7cpu_tick(struct s7cpu *cpu, int64_t up);
/* Elapsed time of the next start point or end of a delay; S7CPU_NEVER where there is none. */
int64_t s7cpu_next_up(const struct s7cpu *cpu);

/* Does the next thing that the operating system has to do before the running OB goes on: starts
 * an OB, reports one that is missing, changes to RUN, begins a cycle of OB 1. False where there
 * is none: the OB of s7cpu_top() goes on, or in STOP and HOLD nothing happens. */
bool s7cpu_dispatch(struct s7cpu *cpu);
/* The running OB; NULL where none runs. */
const struct s7cpu_frame *s7cpu_top(const struct s7cpu *cpu);
/* The running OB and those that it has interrupted. */
int s7cpu_depth(const struct s7cpu *cpu);
/* The running OB has been processed to its end. */
void s7cpu_end_ob(struct s7cpu *cpu);

enum s7cpu_mode s7cpu_mode(const struct s7cpu *cpu);
/* How often an OB has been started. */
uint32_t s7cpu_runs(const struct s7cpu *cpu, int ob);
bool s7cpu_is_loaded(const struct s7cpu *cpu, int ob);
/* Reading of the CPU clock. */
int64_t s7cpu_clock(const struct s7cpu *cpu);
/* ms by which local time is ahead of it. */
int64_t s7cpu_zone(const struct s7cpu *cpu);
/* Elapsed time, as of the last s7cpu_tick(). */
int64_t s7cpu_up(const struct s7cpu *cpu);
/* Delays that SFC 41 has set and SFC 42 has not taken back. */
int s7cpu_delay_count(const struct s7cpu *cpu);

/* ---- SFCs, called by the running OB --------------------------------------------------------- */

/* Operands are what the program passes, right or wrong. The result is RET_VAL as a word, 16#8090
 * for instance. */
int s7cpu_set_tint(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, int period);
/* SDT is local time; or the interrupt is active at once [T15-08, T15-09]. */
int s7cpu_set_tintl(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, bool local,
                    int period, bool activate);
int s7cpu_can_tint(struct s7cpu *cpu, int ob_nr);
int s7cpu_act_tint(struct s7cpu *cpu, int ob_nr);
/* *status is set where the result is 0. */
int s7cpu_qry_tint(struct s7cpu *cpu, int ob_nr, int *status);
int s7cpu_srt_dint(struct s7cpu *cpu, int ob_nr, int64_t dtime, int sign);
int s7cpu_can_dint(struct s7cpu *cpu, int ob_nr);
int s7cpu_qry_dint(struct s7cpu *cpu, int ob_nr, int *status);
int s7cpu_dis_irt(struct s7cpu *cpu, int mode, int ob_nr);
int s7cpu_en_irt(struct s7cpu *cpu, int mode, int ob_nr);
int s7cpu_dis_airt(struct s7cpu *cpu);
int s7cpu_en_airt(struct s7cpu *cpu);

/* ---- from outside --------------------------------------------------------------------------- */

/* The clock is set, by SFC 0, an operator or a clock master [CLK-01]; 0 to S7CPU_LAST. */
void s7cpu_set_clock(struct s7cpu *cpu, int64_t to);
/* Local time is so many ms ahead of the clock from now on, by daylight saving or by another zone
 * [T15-96 to T15-98, T15-103]; where s7cpu_has_local_time(). */
void s7cpu_set_zone(struct s7cpu *cpu, int64_t zone, bool daylight);
/* A start event for an OB that s7cpu_ob_from_outside() takes. flt_id: for OB 80 and 85, one that
 * no rule of the CPU makes; else S7CPU_NONE. */
void s7cpu_interrupt(struct s7cpu *cpu, int ob, int flt_id);
/* SZL 16#0222 is read, for an OB that exists. */
void s7cpu_read_state(struct s7cpu *cpu, int ob, struct s7cpu_state *state);
/* A block is loaded into the CPU or deleted. */
void s7cpu_load(struct s7cpu *cpu, int ob);
void s7cpu_delete(struct s7cpu *cpu, int ob);
/* The switch; each does nothing where the mode does not allow it. A restart leads through STOP; one
 * that the CPU does not have does nothing. */
void s7cpu_stop(struct s7cpu *cpu);
void s7cpu_restart(struct s7cpu *cpu, enum s7cpu_restart type);
void s7cpu_hold(struct s7cpu *cpu);
void s7cpu_release(struct s7cpu *cpu);

#endif

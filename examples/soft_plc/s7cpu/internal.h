/* Declarations that the units of the library share. */
#ifndef S7CPU_INTERNAL_H
#define S7CPU_INTERNAL_H

#include <stddef.h>

#include "s7cpu.h"

/* PERIOD of SFC 28 [TINT-33]. Both weekly codes are taken (AMB-01, reading c). */
enum {
    PERIOD_ONCE = 0x0000,
    PERIOD_MINUTE = 0x0201,
    PERIOD_HOURLY = 0x0401,
    PERIOD_DAILY = 0x1001,
    PERIOD_WEEKLY = 0x1201,
    PERIOD_WEEKLY_ALT = 0x1202,
    PERIOD_MONTHLY = 0x1401,
    PERIOD_YEARLY = 0x1801,
    PERIOD_END_OF_MONTH = 0x2001
};

/* RET_VAL; one code may say different things for different SFCs. */
enum {
    RET_OK = 0x0000,
    RET_NOT_DELAYED = 0x8080, /* SFC 42 */
    RET_BAD_OB = 0x8090,
    RET_BAD_SDT = 0x8091,   /* SFC 28 */
    RET_BAD_DTIME = 0x8091, /* SFC 32 */
    RET_BAD_MODE = 0x8091,  /* SFC 39 and 40 */
    RET_BAD_PERIOD = 0x8092,
    RET_NOT_SET = 0x80A0,     /* SFC 29 and 30 */
    RET_NOT_STARTED = 0x80A0, /* SFC 33 */
    RET_PAST = 0x80A1
};

/* Fault ids of OB 80 and 85: of an event from outside, and those that the rules make. */
enum {
    FLT_CYCLE_TIME = 0x01,
    FLT_OVERLAP = 0x02,
    FLT_SKIPPED = 0x05,
    FLT_SKIPPED_IN_HOLD = 0x06,
    FLT_OVERFLOW = 0x07,
    FLT_MISSING = 0xA1,
    FLT_MISSING_BY_SFC = 0xA2
};

/* Event ids of the causes of a STOP (table 8.3). */
enum {
    CAUSE_NONE = S7CPU_NONE,
    CAUSE_SWITCH = 0x4303,
    CAUSE_CLASS_SYSTEM = 0x4541,
    CAUSE_DESELECTED_LOADED = 0x454A,
    CAUSE_OB121_MISSING = 0x4562,
    CAUSE_OB122_MISSING = 0x4563,
    CAUSE_OB80_MISSING = 0x4568,
    CAUSE_OB85_MISSING = 0x456D
};

/* Flags of MODE of SFC 39 and 40. */
enum { SELECT_ALL = 0x00, SELECT_CLASS = 0x01, SELECT_OB = 0x02, NO_ENTRIES = 0x80 };

/* STRT_INFO of a startup OB: manual warm restart. */
enum { STRT_INFO_WARM = 0x81 };

/* family.c */
struct s7_family {
    bool restarts[3];
    int upper_class; /* of OB 80 to 87 in STARTUP, and for a full buffer; 0: the one that they have */
    int64_t skips_from;   /* the least step ahead, in ms, that OB 80 reports [CLK-02, T15-90] */
    int64_t repeats_from; /* the least step back that serves points again [CLK-10, T15-94] */
    bool serves_uncalled; /* after a lesser one, points that were never served: A15-17, reading b */
    bool ignores_missing; /* no STOP for an OB that is missing, but for two [T15-110, T15-111] */
    bool refuses_missing; /* SFC 28, 30 and 32 for such an OB: 8090 (A15-13, reading a) */
    bool holds_startup; /* HOLD out of STARTUP, which goes on then [T15-121] */
    bool ob80_waits_for_run; /* in STARTUP [T15-117] */
    bool has_queues; /* of each OB; a further event is discarded [T15-68 to T15-73] */
    bool month_end_has_no_date; /* that of STEP 7: only its time of day counts [T15-22] */
    bool past_once_is_over; /* of STEP 7: nothing is made up for (A15-12, reading a) */
    bool status_shows_delay; /* STATUS bit 1 is that of SFC 41, not 39 [T15-53] */
    bool names_running; /* OB 80 names the OB that was being processed [T15-132] */
    bool has_local_time; /* [T15-20] */
    bool has_layouts; /* of start information [T15-130] */
    bool takes_1202; /* AMB-01, reading c; A15-22, reading a */
};
const struct s7_family *s7_family(const struct s7cpu *cpu);
int s7_ob_default_class(enum s7cpu_family family, int ob);

/* ob.c */
enum ob_kind {
    OB_NONE,
    OB_CYCLE,
    OB_TOD,
    OB_DELAY,
    OB_CYCLIC,
    OB_HARDWARE,
    OB_DPV1,
    OB_MULTICOMPUTING,
    OB_REDUNDANCY,
    OB_ASYNC_ERROR, /* OB 80 to 87 */
    OB_SYNC_ERROR,  /* OB 121 and 122 [IRT-23] */
    OB_STARTUP,
    OB_OTHER /* may be loaded, is never started here */
};
enum ob_kind s7_ob_kind(int ob);
/* Class number of SFC 39 and 40 [IRT-11]; 0 where the OB has none. */
int s7_ob_irt_class(int ob);
/* Priority class in the present mode. */
int s7_ob_class(const struct s7cpu *cpu, int ob);
/* STRT_INFO of table 8.2, or S7CPU_NONE where the table has none. */
int s7_ob_strt_info(int ob);
/* Class and number of the start event (table 8.3), or S7CPU_NONE. */
int s7_ob_start_event(int ob);
/* True where its start information has the optimised layout. */
bool s7_ob_is_optimised(const struct s7cpu *cpu, int ob);
/* True from its start to its end, interrupted or not. */
bool s7_ob_is_running(const struct s7cpu *cpu, int ob);

/* calendar.c */
bool s7_period_known(int period);
/* The first point of the series start + k*period, k >= 0, that is not before `from`;
 * S7CPU_NEVER where the clock's range ends first [TINT-10, TINT-24, TINT-32]. */
int64_t s7_series_first(int64_t start, int period, int64_t from);

/* emit.c: events for the sink */
void s7_emit(struct s7cpu *cpu, struct s7cpu_event event);
void s7_emit_start(struct s7cpu *cpu, int ob, const struct s7cpu_info *info);
/* ob: or S7CPU_NONE; info: or NULL */
void s7_emit_diag(struct s7cpu *cpu, int id, int ob, const struct s7cpu_info *info);

/* queue.c */
/* A request with the start information that every OB has, fixed when the event occurs [OBS-10]. */
struct s7cpu_request s7_request(const struct s7cpu *cpu, int ob, int64_t time);
void s7_queue_put(struct s7cpu *cpu, const struct s7cpu_request *r);
struct s7cpu_request s7_queue_take(struct s7cpu *cpu, int index);
/* Removes every request of an OB. */
void s7_queue_withdraw(struct s7cpu *cpu, int ob);
bool s7_queue_has(const struct s7cpu *cpu, int ob);
/* Index of the request that goes first of those that may start; -1 where none may. */
int s7_queue_choose(const struct s7cpu *cpu);
/* True where another event of this OB is a time error. */
bool s7_queue_overloads(const struct s7cpu *cpu, int ob);
/* True where no more events of this OB can wait. */
bool s7_queue_holds_all(const struct s7cpu *cpu, int ob);
/* The parameters of its queue, those that the CPU has without any, too. */
struct s7cpu_queue s7_queue_of(const struct s7cpu *cpu, int ob);
/* True where a start event from outside is lost. */
bool s7_queue_is_full(const struct s7cpu *cpu, const struct s7cpu_request *r);
/* True for fault ids 05 and 06; where OB 80 waits for one. */
bool s7_is_skip(int flt_id);
bool s7_queue_has_skip(const struct s7cpu *cpu);

/* tod_sfc.c: SFC 28 to 31 */
int s7_tod_set(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, bool local, int period);
int s7_tod_cancel(struct s7cpu *cpu, int ob_nr);
int s7_tod_activate(struct s7cpu *cpu, int ob_nr);
int s7_tod_query(const struct s7cpu *cpu, int ob_nr, int *status);

/* tod_points.c: start points of the k-th time-of-day interrupt, s7cpu_tod_ob(k) */
/* SDT, or the start of STEP 7, by the clock; it may be before the clock's range. */
int64_t s7_tod_start(const struct s7cpu *cpu, const struct s7cpu_tod *t);
int64_t s7_tod_first_point(const struct s7cpu *cpu, int k, int64_t from);
int64_t s7_tod_unserved_point(const struct s7cpu *cpu, int k, int64_t from);

/* tod_requests.c: start events of s7cpu_tod_ob(k) */
void s7_tod_request(struct s7cpu *cpu, int k, int64_t point);
/* A point is due while the OB is processed [TINT-14]. */
void s7_tod_overlap(struct s7cpu *cpu, int k, int64_t point);
/* Points before the present clock have been skipped [CLK-03], by a change of it or of local time, or in
 * HOLD. */
void s7_tod_catch_up(struct s7cpu *cpu, int k, bool by_change);

/* tod_once.c */
/* The OB is called for this point, or it is missing; it has been processed to its end. */
void s7_tod_called(struct s7cpu *cpu, int ob, int64_t point);
void s7_tod_missed(struct s7cpu *cpu, int ob, int64_t point);
void s7_tod_ended(struct s7cpu *cpu, int ob);

/* tod.c */
/* A one-shot interrupt is over: its OB was called, or would have been and is missing [TINT-08,
 * AMB-46]. */
void s7_tod_used_up(struct s7cpu *cpu, int ob);
/* Drops what SFCs have set; the STEP 7 parameters apply [OBS-50]. */
void s7_tod_restart(struct s7cpu *cpu);
/* The CPU begins in RUN with its STEP 7 parameters in force and nothing pending. */
void s7_tod_begin_running(struct s7cpu *cpu);
/* Enters a request for every start point that the clock has reached. */
void s7_tod_poll(struct s7cpu *cpu);
/* Elapsed time of the next start point, S7CPU_NEVER where there is none. */
int64_t s7_tod_next_up(const struct s7cpu *cpu);

/* tod_clock.c */
/* The clock has been moved from `before` to its present reading. */
void s7_tod_clock_changed(struct s7cpu *cpu, int64_t before);
/* Local time has been moved ahead by so many ms, or back. */
void s7_tod_zone_changed(struct s7cpu *cpu, int64_t ahead);
/* Points that passed in HOLD [OBS-46]. */
void s7_tod_released(struct s7cpu *cpu);
/* Points that passed in STOP before a hot restart (AMB-26). */
void s7_tod_resumed(struct s7cpu *cpu);

/* dint.c: SFC 32 to 34, and delays in elapsed time, which a clock change does not move [DINT-18] */
int s7_dint_start(struct s7cpu *cpu, int ob_nr, int64_t dtime, int sign);
int s7_dint_cancel(struct s7cpu *cpu, int ob_nr);
int s7_dint_query(const struct s7cpu *cpu, int ob_nr, int *status);
/* A warm or cold restart discards every job [DINT-13]. */
void s7_dint_restart(struct s7cpu *cpu);
/* Enters a request for every delay that has ended. */
void s7_dint_poll(struct s7cpu *cpu);
/* Elapsed time at which the next delay ends, S7CPU_NEVER where none runs. */
int64_t s7_dint_next_up(const struct s7cpu *cpu);
/* HOLD is over: it froze the delays for this long [DINT-19]. */
void s7_dint_released(struct s7cpu *cpu, int64_t held);

/* status.c */
/* The source of the start events of OB 10 to 17 and 20 to 23 is active [TINT-74, DINT-16]. */
bool s7_is_active(const struct s7cpu *cpu, int ob);
/* STATUS of SFC 31 and 34, one scheme for both [TINT-72 to TINT-79, DINT-16]. */
int s7_status(const struct s7cpu *cpu, int ob);
/* The same, and more, by SZL 16#0222 [OBS-60]. */
struct s7cpu_state s7_state(const struct s7cpu *cpu, int ob);

/* irt.c: SFC 39 and 40 */
int s7_irt_disable(struct s7cpu *cpu, int mode, int ob_nr);
int s7_irt_enable(struct s7cpu *cpu, int mode, int ob_nr);
/* True where a start event of OB 10 to 23 is lost; a one-shot interrupt is over with it. */
bool s7_irt_loses(struct s7cpu *cpu, int ob);

/* irt_mask.c: the mask of every OB */
void s7_irt_block(struct s7cpu *cpu, int ob, bool silent);
void s7_irt_open(struct s7cpu *cpu, int ob);
/* True where a new start event of this OB is lost, without OB and without the reaction to a
 * missing one [IRT-01, IRT-04]. */
bool s7_irt_blocks(const struct s7cpu *cpu, int ob);
/* True where its events are not entered in the diagnostic buffer either [IRT-09]. */
bool s7_irt_silences(const struct s7cpu *cpu, int ob);
/* A warm or cold restart takes every block back [IRT-03, OBS-53]. */
void s7_irt_restart(struct s7cpu *cpu);

/* airt.c: SFC 41 and 42 */
int s7_airt_disable(struct s7cpu *cpu);
int s7_airt_enable(struct s7cpu *cpu);
void s7_airt_ob_ended(struct s7cpu *cpu);
/* True where every request has to wait for the end of the delay, OB 80 to 87 too [AIRT-01,
 * AIRT-09]. */
bool s7_airt_delays(const struct s7cpu *cpu);

/* scheduler.c */
bool s7_may_start(const struct s7cpu *cpu, const struct s7cpu_request *r);
/* The startup or cycle OB that comes after the last one, by number; S7CPU_NONE: STARTUP, or the
 * cycle, is over [T15-79, T15-116]. */
int s7_next_in_turn(const struct s7cpu *cpu);
/* Starts an OB that is loaded. */
void s7_start(struct s7cpu *cpu, const struct s7cpu_request *r);
/* An OB that is running already when the CPU begins: it has no event. */
void s7_enter(struct s7cpu *cpu, int ob);
/* The cycle time is exceeded: true where that stops the CPU, since OB 80 was called for it in this
 * cycle already [OBS-26]. */
bool s7_cycle_exceeded_again(struct s7cpu *cpu);

/* errors.c: OB 80, OB 85, and the STOP where those are missing */
/* Fault 02: the OB fell due while it is still processed [TINT-14, DINT-10]; `z1` is byte 6-7 of
 * its start information: PERIOD or SIGN. */
void s7_error_overlap(struct s7cpu *cpu, int ob, int z1);
/* Fault 05 or 06: bit k of `late` means s7cpu_tod_ob(k) [CLK-06, OBS-32]. */
void s7_error_skipped(struct s7cpu *cpu, int flt_id, unsigned late);
/* Fault 07: the request buffer is full [OBS-08]. */
void s7_error_overflow(struct s7cpu *cpu, int ob);
/* An event of OB 80 to 87 leads at once to the reaction to its missing OB; else it waits, and the
 * OB is missing when it would be called. */
bool s7_missing_is_noticed(const struct s7cpu *cpu);
/* An event of OB 80 to 87 whose OB is missing [OBS-23]. */
void s7_error_missing_async(struct s7cpu *cpu, const struct s7cpu_request *r);
/* The OB of a request is to be called and is missing [TINT-16, OBS-20]. */
void s7_error_missing(struct s7cpu *cpu, const struct s7cpu_request *r);

/* An instruction of the running OB fails: OB 121 or OB 122 [OBS-61 to OBS-63]. */
void s7_error_synchronous(struct s7cpu *cpu, int ob);

/* time_error.c: OB 80 is requested */
void s7_time_error(struct s7cpu *cpu, const struct s7cpu_request *r);
/* OB 80 is missing: the CPU has stopped, or will at the end of the delay; nothing follows OB 80. */
bool s7_time_error_stops(const struct s7cpu *cpu);

/* diag.c: entries of the diagnostic buffer (table 8.3) */
/* Id of the entry of an error, 0 where the table has none. */
int s7_diag_id(const struct s7cpu_request *r);
/* The error that OB 80 or 85 is requested for: 35xx, with its start information. */
void s7_diag_error(struct s7cpu *cpu, const struct s7cpu_request *r);
/* The CPU stops because OB 80 or 85 is missing: 4568, 456D; nothing for other causes. */
void s7_diag_stop(struct s7cpu *cpu, int cause);
/* DIS_IRT suppresses entries: 5380. */
void s7_diag_suppressed(struct s7cpu *cpu);

/* modes.c */
void s7_stop(struct s7cpu *cpu, int cause);
/* An OB that STEP 7 has deselected is there: no STARTUP [OBS-25]. */
bool s7_deselected_is_loaded(const struct s7cpu *cpu);
/* The startup OB is at its end: mode RUN. */
void s7_to_run(struct s7cpu *cpu);

/* Time runs for time-of-day and delay interrupts. */
static inline bool s7_time_runs(const struct s7cpu *cpu)
{
    return cpu->mode == S7CPU_RUN || cpu->mode == S7CPU_STARTUP;
}

#endif

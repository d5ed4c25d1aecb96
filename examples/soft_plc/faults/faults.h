/* Deliberate faults: mistakes that an implementer really makes, to try a checker on. The library
 * knows nothing of them: a variant of one of its functions makes each (substitute.h). */
#ifndef FAULTS_H
#define FAULTS_H

#include <stdbool.h>
#include <stdio.h>

#include "s7cpu.h"

/* Each fault: its constant, its name, what it does. */
#define FAULTS(X) \
    X(AIRT_FLAG, "airt-flag", "SFC 41 sets a flag and does not count [AIRT-03]") \
    X(AIRT_KEEPS_COUNT, "airt-keeps-count", \
      "the delay count is not reset at the end of the OB [AIRT-04]") \
    X(AIRT_EN_ALL, "airt-en-all", "one SFC 42 takes back all delays [AIRT-03, AIRT-07]") \
    X(AIRT_EN_ZERO, "airt-en-zero", "SFC 42 answers 0000 where nothing was delayed [AIRT-07]") \
    X(AIRT_LOSES, "airt-loses", "start events are lost while SFC 41 delays [AIRT-02]") \
    X(AIRT_IGNORES_OB80, "airt-ignores-ob80", "SFC 41 does not delay OB 80 [AIRT-09]") \
    X(HOURLY_DAILY, "hourly-daily", "PERIOD 0401 is run daily [TINT-34]") \
    X(MONTH_END_30, "month-end-30", "PERIOD 2001 runs on the 30th of the long months [TINT-19]") \
    X(LEAP_CENTURY, "leap-century", "the year 2000 is taken for a common year [TINT-39]") \
    X(MONTHLY_31, "monthly-31", "PERIOD 1401 is accepted for the days 29 to 31 [TINT-18]") \
    X(KEEP_SECONDS, "keep-seconds", "the seconds of SDT are not cut off [TINT-11]") \
    X(SET_ACTIVATES, "set-activates", "SFC 28 activates the interrupt as well [TINT-05]") \
    X(SET_PAST_ALL, "set-past-all", \
      "SFC 28 answers 80A1 for a periodic start in the past [TINT-37]") \
    X(ACT_NO_80A1, "act-no-80a1", "SFC 30 accepts a single start in the past [TINT-61]") \
    X(CAN_KEEPS_DATE, "can-keeps-date", "SFC 29 only deactivates and leaves the date [TINT-50]") \
    X(CAN_KEEPS_REQUEST, "can-keeps-request", \
      "SFC 29 leaves a waiting request in the queue [TINT-50]") \
    X(ONCE_STAYS, "once-stays", "a single start stays set after its run [TINT-08]") \
    X(QRY_NO_LOADED, "qry-no-loaded", "STATUS bit 4 is always 0 [TINT-76]") \
    X(NO_OB80_SKIP, "no-ob80-skip", "no OB 80 when the clock skips start points [CLK-02]") \
    X(NO_CATCH_UP, "no-catch-up", "skipped OBs are not caught up [CLK-03]") \
    X(CATCH_UP_PER_PERIOD, "catch-up-per-period", \
      "one catch-up for every skipped period, up to 5 [CLK-03]") \
    X(CATCH_UP_FIRST, "catch-up-first", "the catch-up runs before OB 80 [CLK-03]") \
    X(SKIP_MASK, "skip-mask", "the bits of fault 05 count from 1 [CLK-06]") \
    X(SKIP_TIME, "skip-time", \
      "OB 80 with fault 05 carries the clock before the change [CLK-06]") \
    X(REPEAT_S7_400, "repeat-s7-400", \
      "S7-400: start points repeat after the clock went back [CLK-09]") \
    X(NO_REPEAT_S7_300, "no-repeat-s7-300", \
      "S7-300: start points do not repeat after it went back [CLK-10]") \
    X(OVERLAP_SILENT, "overlap-silent", \
      "no OB 80 when an OB is due while it still runs [TINT-14]") \
    X(OVERLAP_LOST, "overlap-lost", "the run that fell due meanwhile is lost [TINT-14]") \
    X(EQUAL_PREEMPTS, "equal-preempts", \
      "an OB of the same class interrupts the running one [OBS-02]") \
    X(LIFO, "lifo", "the youngest request of a class goes first [OBS-02]") \
    X(MISSING_OB80_RUNS_ON, "missing-ob80-runs-on", \
      "a time error without OB 80 does not stop the CPU [OBS-22]") \
    X(MISSING_OB85_RUNS_ON, "missing-ob85-runs-on", \
      "a missing OB without OB 85 does not stop the CPU [OBS-21]") \
    X(MISSING_SILENT, "missing-silent", "a missing OB is passed over without OB 85 [OBS-20]") \
    X(RESTART_KEEPS_SFC, "restart-keeps-sfc", \
      "a restart keeps what SFC 28 to 30 have set [OBS-50]") \
    X(RESTART_NO_STEP7, "restart-no-step7", \
      "a restart does not bring the STEP 7 parameters back [OBS-50]") \
    X(STARTUP_RUNS_TOD, "startup-runs-tod", "OB 10 to 17 run during STARTUP [TINT-13]") \
    X(DINT_ZERO, "dint-zero", "SFC 32 accepts a DTIME of 0 [DINT-04]") \
    X(DINT_NO_LIMIT, "dint-no-limit", "SFC 32 accepts more than 60000 ms [DINT-04]") \
    X(DINT_COARSE, "dint-coarse", "delays are cut off to 10 ms [DINT-04, DINT-06]") \
    X(DINT_NO_RETRIGGER, "dint-no-retrigger", \
      "SFC 32 leaves a job that is started as it is [DINT-07]") \
    X(DINT_KEEPS_SIGN, "dint-keeps-sign", \
      "SFC 32 on a started job leaves the old SIGN [DINT-07, AMB-74]") \
    X(DINT_INFO_REST, "dint-info-rest", \
      "the start information shows the rest of the delay [DINT-03]") \
    X(DINT_CAN_ANY, "dint-can-any", "SFC 33 answers 0000 where no job is started [DINT-14]") \
    X(DINT_CAN_KEEPS, "dint-can-keeps", "SFC 33 does not cancel the job [DINT-14]") \
    X(DINT_CAN_RUNS, "dint-can-runs", \
      "SFC 33 answers 0000, and the OB that waits runs [DINT-14, AMB-11]") \
    X(DINT_CAN_LOSES, "dint-can-loses", \
      "SFC 33 answers 80A0, and the OB that waits is lost [AMB-11]") \
    X(DINT_CAN_MIXED, "dint-can-mixed", \
      "SFC 33 withdraws the OB that waits, SFC 32 does not [AMB-11]") \
    X(DINT_RUNNING_ACTIVE, "dint-running-active", \
      "STATUS bit 2 is 1 while the OB runs [DINT-16, AMB-34]") \
    X(DINT_OVERLAP_SILENT, "dint-overlap-silent", \
      "no OB 80 when a delay ends while its OB runs [DINT-10]") \
    X(DINT_OVERLAP_DTIME, "dint-overlap-dtime", \
      "ERROR_INFO of fault 02 shows DTIME, not SIGN [OBS-30]") \
    X(DINT_FOLLOWS_CLOCK, "dint-follows-clock", "delays are moved with the clock [DINT-18]") \
    X(DINT_RUNS_IN_HOLD, "dint-runs-in-hold", "delays go on in HOLD [DINT-19]") \
    X(DINT_SURVIVES, "dint-survives", "a restart keeps the jobs [DINT-13]") \
    X(STARTUP_RUNS_DINT, "startup-runs-dint", \
      "OB 20 to 23 run during STARTUP [DINT-11, DINT-12]") \
    X(IRT_QUEUES, "irt-queues", "blocked events wait for SFC 40 [IRT-04]") \
    X(IRT_COUNTS, "irt-counts", "SFC 39 counts, and needs as many SFC 40 [IRT-16]") \
    X(IRT_SURVIVES, "irt-survives", "a restart keeps the blocks [IRT-03]") \
    X(IRT_ENDS_WITH_OB, "irt-ends-with-ob", "the end of any OB takes the blocks back [IRT-02]") \
    X(IRT_MISSING_REACTS, "irt-missing-reacts", \
      "a blocked event of a missing OB leads to OB 85 or STOP [IRT-01]") \
    X(IRT_STOPS_80, "irt-stops-80", \
      "a blocked time error without OB 80 stops the CPU [IRT-01, AMB-23]") \
    X(IRT_DROPS_QUEUED, "irt-drops-queued", "SFC 39 drops requests that wait [AMB-72]") \
    X(IRT_JOB_STAYS, "irt-job-stays", \
      "a blocked one-shot interrupt or delay stays active when it is lost [DINT-20, AMB-12]") \
    X(IRT_NO_STATUS, "irt-no-status", "STATUS bit 1 is always 0 [IRT-17, TINT-73]") \
    X(IRT_CLASS_FIRST, "irt-class-first", \
      "MODE 01 means the first OB of the class only [IRT-07]") \
    X(IRT_NO_CLASS_70, "irt-no-class-70", "class 70 is refused [IRT-11]") \
    X(IRT_NO_8X, "irt-no-8x", "MODE 80 to 82 of SFC 39 are refused [IRT-09]") \
    X(IRT_ALL_NEEDS_0, "irt-all-needs-0", \
      "MODE 00 with an OB_NR other than 0 gives 8090 [IRT-06, AMB-22]") \
    X(IRT_BAD_MODE, "irt-bad-mode", "a wrong MODE gives 8090 [IRT-12]") \
    X(IRT_OB1, "irt-ob1", "OB_NR 1 is accepted [IRT-12, AMB-73]") \
    X(EN_IRT_8X, "en-irt-8x", "SFC 40 takes MODE 80 to 82 as 00 to 02 [IRT-13, AMB-76]") \
    X(EN_IRT_BLOCKS, "en-irt-blocks", "SFC 40 with MODE 01 blocks [IRT-14]") \
    X(EN_IRT_8080, "en-irt-8080", "SFC 40 answers 8080 where nothing is blocked [IRT-24]") \
    X(DIAG_NO_5380, "diag-no-5380", "SFC 39 with MODE 8x does not enter 5380 [IRT-09]") \
    X(DIAG_5380_EACH, "diag-5380-each", \
      "5380 once more for every event that is not entered [AMB-41]") \
    X(DIAG_8X_ENTERED, "diag-8x-entered", "events blocked with MODE 8x are entered [IRT-09]") \
    X(DIAG_0X_SILENT, "diag-0x-silent", \
      "events blocked with MODE 0x are not entered [IRT-06 to IRT-08]") \
    X(DIAG_EN_SILENT, "diag-en-silent", "SFC 40 does not bring the entries back [AMB-21]") \
    X(DIAG_NO_STOP, "diag-no-stop", "4568 and 456D are not entered [OBS-21, OBS-22]") \
    X(DIAG_3505, "diag-3505", "fault 06 is entered as 3505 [OBS-46]") \
    X(PRIORITY_DEFAULT, "priority-default", "the classes that are set are ignored [OBS-05]") \
    X(STARTUP_CLASS, "startup-class", \
      "OB 80 to 87 keep their class in STARTUP and wait [OBS-43, AMB-13]") \
    X(OVERFLOW_CLASS, "overflow-class", \
      "OB 80 with fault 07 has its ordinary class [OBS-31, AMB-13]") \
    X(ASYNC_RUNS_ON, "async-runs-on", \
      "a missing OB 82, 83 or 86 does not stop the CPU [OBS-23]") \
    X(FIFO, "fifo", "the oldest request goes first, whatever its class [OBS-03, AMB-69]") \
    X(ONCE_RUNS_TWICE, "once-runs-twice", \
      "a clock set back inside its OB arms a one-shot interrupt again [CLK-12]") \
    X(BACK_BLOCKS_NEW, "back-blocks-new", \
      "S7-400: after the clock went back a new setting waits for the old time [CLK-09, AMB-57]") \
    X(CLOCK_RUNS_AWAY, "clock-runs-away", \
      "the clock gains 3 s every minute, without an event [CLK-01]") \
    X(OVERLAP_RUNS_EACH, "overlap-runs-each", \
      "every overlap has a later run of its own [AMB-19]") \
    X(SKIP_AS_INTERRUPT, "skip-as-interrupt", \
      "fault 05 is logged as a start event from outside [CLK-02]") \
    X(STOP_CAUSE, "stop-cause", "the switch stops with cause 4568 [OBS-22]") \
    X(STARTUP_TIME, "startup-time", \
      "the time of the startup OB is an hour before its start [OBS-10]") \
    X(STATE_ACTIVE, "state-active", "the state shows the wrong activity [OBS-60]") \
    X(STATE_BLOCKED, "state-blocked", "the state does not show SFC 39 [OBS-60]") \
    X(STATE_LOADED, "state-loaded", "the state shows every OB as loaded [OBS-60]") \
    X(STATE_ENTRIES, "state-entries", \
      "the state does not show that entries are off [OBS-60, IRT-20]") \
    X(STATE_LEFT, "state-left", "the state shows 100 ms too many [OBS-60, DINT-17]")

enum fault {
    FAULT_NONE,
#define FAULT_CONSTANT(constant, name, text) FAULT_##constant,
    FAULTS(FAULT_CONSTANT)
#undef FAULT_CONSTANT
    FAULT_COUNT
};

struct fault_set {
    bool has[FAULT_COUNT];
};

/* A CPU with its faults. */
struct faulty_cpu {
    struct s7cpu cpu; /* first, so that a variant finds the faults */
    struct fault_set faults;
    int irt_depth[S7CPU_OBS]; /* calls of SFC 39, where they count by mistake */
    int64_t clock_before;     /* the reading before the last change of the clock */
    int64_t clock_highest;    /* of the readings before its changes */
    int64_t minute;           /* of elapsed time, in which the clock was last put forward */
};

bool fault_by_name(const char *name, enum fault *f);
const char *fault_name(enum fault f);
void faults_help(FILE *out);

#endif

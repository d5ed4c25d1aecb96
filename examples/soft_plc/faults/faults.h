/* Deliberate faults: mistakes that an implementer really makes, to try a checker on. The library
 * knows nothing of them: a variant of one of its functions makes each (substitute.h). */
#ifndef FAULTS_H
#define FAULTS_H

#include <stdbool.h>
#include <stdio.h>

#include "s7cpu.h"

enum fault {
    FAULT_NONE,
    FAULT_AIRT_FLAG,
    FAULT_AIRT_KEEPS_COUNT,
    FAULT_AIRT_EN_ALL,
    FAULT_AIRT_EN_ZERO,
    FAULT_AIRT_LOSES,
    FAULT_AIRT_IGNORES_OB80,
    FAULT_HOURLY_DAILY,
    FAULT_MONTH_END_30,
    FAULT_LEAP_CENTURY,
    FAULT_MONTHLY_31,
    FAULT_KEEP_SECONDS,
    FAULT_SET_ACTIVATES,
    FAULT_SET_PAST_ALL,
    FAULT_ACT_NO_80A1,
    FAULT_CAN_KEEPS_DATE,
    FAULT_CAN_KEEPS_REQUEST,
    FAULT_ONCE_STAYS,
    FAULT_QRY_NO_LOADED,
    FAULT_NO_OB80_SKIP,
    FAULT_NO_CATCH_UP,
    FAULT_CATCH_UP_PER_PERIOD,
    FAULT_CATCH_UP_FIRST,
    FAULT_SKIP_MASK,
    FAULT_SKIP_TIME,
    FAULT_REPEAT_S7_400,
    FAULT_NO_REPEAT_S7_300,
    FAULT_OVERLAP_SILENT,
    FAULT_OVERLAP_LOST,
    FAULT_EQUAL_PREEMPTS,
    FAULT_LIFO,
    FAULT_MISSING_OB80_RUNS_ON,
    FAULT_MISSING_OB85_RUNS_ON,
    FAULT_MISSING_SILENT,
    FAULT_RESTART_KEEPS_SFC,
    FAULT_RESTART_NO_STEP7,
    FAULT_STARTUP_RUNS_TOD,
    FAULT_DINT_ZERO,
    FAULT_DINT_NO_LIMIT,
    FAULT_DINT_COARSE,
    FAULT_DINT_NO_RETRIGGER,
    FAULT_DINT_KEEPS_SIGN,
    FAULT_DINT_INFO_REST,
    FAULT_DINT_CAN_ANY,
    FAULT_DINT_CAN_KEEPS,
    FAULT_DINT_CAN_RUNS,
    FAULT_DINT_CAN_LOSES,
    FAULT_DINT_CAN_MIXED,
    FAULT_DINT_RUNNING_ACTIVE,
    FAULT_DINT_OVERLAP_SILENT,
    FAULT_DINT_OVERLAP_DTIME,
    FAULT_DINT_FOLLOWS_CLOCK,
    FAULT_DINT_RUNS_IN_HOLD,
    FAULT_DINT_SURVIVES,
    FAULT_STARTUP_RUNS_DINT,
    FAULT_IRT_QUEUES,
    FAULT_IRT_COUNTS,
    FAULT_IRT_SURVIVES,
    FAULT_IRT_ENDS_WITH_OB,
    FAULT_IRT_MISSING_REACTS,
    FAULT_IRT_STOPS_80,
    FAULT_IRT_DROPS_QUEUED,
    FAULT_IRT_JOB_STAYS,
    FAULT_IRT_NO_STATUS,
    FAULT_IRT_CLASS_FIRST,
    FAULT_IRT_NO_CLASS_70,
    FAULT_IRT_NO_8X,
    FAULT_IRT_ALL_NEEDS_0,
    FAULT_IRT_BAD_MODE,
    FAULT_IRT_OB1,
    FAULT_EN_IRT_8X,
    FAULT_EN_IRT_BLOCKS,
    FAULT_EN_IRT_8080,
    FAULT_DIAG_NO_5380,
    FAULT_DIAG_5380_EACH,
    FAULT_DIAG_8X_ENTERED,
    FAULT_DIAG_0X_SILENT,
    FAULT_DIAG_EN_SILENT,
    FAULT_DIAG_NO_STOP,
    FAULT_DIAG_3505,
    FAULT_PRIORITY_DEFAULT,
    FAULT_STARTUP_CLASS,
    FAULT_OVERFLOW_CLASS,
    FAULT_ASYNC_RUNS_ON,
    FAULT_FIFO,
    FAULT_ONCE_RUNS_TWICE,
    FAULT_BACK_BLOCKS_NEW,
    FAULT_CLOCK_RUNS_AWAY,
    FAULT_OVERLAP_RUNS_EACH,
    FAULT_SKIP_AS_INTERRUPT,
    FAULT_STOP_CAUSE,
    FAULT_STARTUP_TIME,
    FAULT_STATE_ACTIVE,
    FAULT_STATE_BLOCKED,
    FAULT_STATE_LOADED,
    FAULT_STATE_ENTRIES,
    FAULT_STATE_LEFT,
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

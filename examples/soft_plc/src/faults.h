/* Deliberate faults: mistakes an implementer really makes, to try a checker on. */
#ifndef FAULTS_H
#define FAULTS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

enum fault {
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
    FAULT_COUNT
};

/* A set of faults, one bit each. */
typedef uint64_t fault_set;

static inline bool has_fault(fault_set set, enum fault f)
{
    return (set >> f) & 1;
}

bool fault_by_name(const char *name, enum fault *f);
const char *fault_name(enum fault f);
void faults_help(FILE *out);
unsigned faults_calendar_quirks(fault_set set);

#endif

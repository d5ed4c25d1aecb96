#include <string.h>

#include "faults.h"

static const struct {
    const char *name, *text;
} table[FAULT_COUNT] = {
    [FAULT_AIRT_FLAG] = {"airt-flag", "SFC 41 sets a flag and does not count [AIRT-03]"},
    [FAULT_AIRT_KEEPS_COUNT] = {"airt-keeps-count",
                                "the delay count is not reset at the end of the OB [AIRT-04]"},
    [FAULT_AIRT_EN_ALL] = {"airt-en-all", "one SFC 42 takes back all delays [AIRT-03, AIRT-07]"},
    [FAULT_AIRT_EN_ZERO] = {"airt-en-zero",
                            "SFC 42 answers 0000 where nothing was delayed [AIRT-07]"},
    [FAULT_AIRT_LOSES] = {"airt-loses", "start events are lost while SFC 41 delays [AIRT-02]"},
    [FAULT_AIRT_IGNORES_OB80] = {"airt-ignores-ob80", "SFC 41 does not delay OB 80 [AIRT-09]"},
    [FAULT_HOURLY_DAILY] = {"hourly-daily", "PERIOD 0401 is run daily [TINT-34]"},
    [FAULT_MONTH_END_30] = {"month-end-30",
                            "PERIOD 2001 runs on the 30th of the long months [TINT-19]"},
    [FAULT_LEAP_CENTURY] = {"leap-century", "the year 2000 is taken for a common year [TINT-39]"},
    [FAULT_MONTHLY_31] = {"monthly-31", "PERIOD 1401 is accepted for the days 29 to 31 [TINT-18]"},
    [FAULT_KEEP_SECONDS] = {"keep-seconds", "the seconds of SDT are not cut off [TINT-11]"},
    [FAULT_SET_ACTIVATES] = {"set-activates", "SFC 28 activates the interrupt as well [TINT-05]"},
    [FAULT_SET_PAST_ALL] = {"set-past-all",
                            "SFC 28 answers 80A1 for a periodic start in the past [TINT-37]"},
    [FAULT_ACT_NO_80A1] = {"act-no-80a1",
                           "SFC 30 accepts a single start in the past [TINT-61]"},
    [FAULT_CAN_KEEPS_DATE] = {"can-keeps-date",
                              "SFC 29 only deactivates and leaves the date [TINT-50]"},
    [FAULT_CAN_KEEPS_REQUEST] = {"can-keeps-request",
                                 "SFC 29 leaves a waiting request in the queue [TINT-50]"},
    [FAULT_ONCE_STAYS] = {"once-stays", "a single start stays set after its run [TINT-08]"},
    [FAULT_QRY_NO_LOADED] = {"qry-no-loaded", "STATUS bit 4 is always 0 [TINT-76]"},
    [FAULT_NO_OB80_SKIP] = {"no-ob80-skip",
                            "no OB 80 when the clock skips start points [CLK-02]"},
    [FAULT_NO_CATCH_UP] = {"no-catch-up", "skipped OBs are not caught up [CLK-03]"},
    [FAULT_CATCH_UP_PER_PERIOD] = {"catch-up-per-period",
                                   "one catch-up for every skipped period, up to 5 [CLK-03]"},
    [FAULT_CATCH_UP_FIRST] = {"catch-up-first", "the catch-up runs before OB 80 [CLK-03]"},
    [FAULT_SKIP_MASK] = {"skip-mask", "the bits of fault 05 count from 1 [CLK-06]"},
    [FAULT_SKIP_TIME] = {"skip-time",
                         "OB 80 with fault 05 carries the clock before the change [CLK-06]"},
    [FAULT_REPEAT_S7_400] = {"repeat-s7-400",
                             "S7-400: start points repeat after the clock went back [CLK-09]"},
    [FAULT_NO_REPEAT_S7_300] = {"no-repeat-s7-300",
                                "S7-300: start points do not repeat after it went back [CLK-10]"},
    [FAULT_OVERLAP_SILENT] = {"overlap-silent",
                              "no OB 80 when an OB is due while it still runs [TINT-14]"},
    [FAULT_OVERLAP_LOST] = {"overlap-lost", "the run that fell due meanwhile is lost [TINT-14]"},
    [FAULT_EQUAL_PREEMPTS] = {"equal-preempts",
                              "an OB of the same class interrupts the running one [OBS-02]"},
    [FAULT_LIFO] = {"lifo", "the youngest request of a class goes first [OBS-02]"},
    [FAULT_MISSING_OB80_RUNS_ON] = {"missing-ob80-runs-on",
                                    "a time error without OB 80 does not stop the CPU [OBS-22]"},
    [FAULT_MISSING_OB85_RUNS_ON] = {"missing-ob85-runs-on",
                                    "a missing OB without OB 85 does not stop the CPU [OBS-21]"},
    [FAULT_MISSING_SILENT] = {"missing-silent",
                              "a missing OB is passed over without OB 85 [OBS-20]"},
    [FAULT_RESTART_KEEPS_SFC] = {"restart-keeps-sfc",
                                 "a restart keeps what SFC 28 to 30 have set [OBS-50]"},
    [FAULT_RESTART_NO_STEP7] = {"restart-no-step7",
                                "a restart does not bring the STEP 7 parameters back [OBS-50]"},
    [FAULT_STARTUP_RUNS_TOD] = {"startup-runs-tod", "OB 10 to 17 run during STARTUP [TINT-13]"},
    [FAULT_DINT_ZERO] = {"dint-zero", "SFC 32 accepts a DTIME of 0 [DINT-04]"},
    [FAULT_DINT_NO_LIMIT] = {"dint-no-limit", "SFC 32 accepts more than 60000 ms [DINT-04]"},
    [FAULT_DINT_COARSE] = {"dint-coarse", "delays are cut off to 10 ms [DINT-04, DINT-06]"},
    [FAULT_DINT_NO_RETRIGGER] = {"dint-no-retrigger",
                                 "SFC 32 leaves a job that is started as it is [DINT-07]"},
    [FAULT_DINT_KEEPS_SIGN] = {"dint-keeps-sign",
                               "SFC 32 on a started job leaves the old SIGN [DINT-07, AMB-74]"},
    [FAULT_DINT_INFO_REST] = {"dint-info-rest",
                              "the start information shows the rest of the delay [DINT-03]"},
    [FAULT_DINT_CAN_ANY] = {"dint-can-any",
                            "SFC 33 answers 0000 where no job is started [DINT-14]"},
    [FAULT_DINT_CAN_KEEPS] = {"dint-can-keeps", "SFC 33 does not cancel the job [DINT-14]"},
    [FAULT_DINT_CAN_WITHDRAWS] = {"dint-can-withdraws",
                                  "SFC 33 withdraws a request that waits [DINT-15]"},
    [FAULT_DINT_WAITING_ACTIVE] = {"dint-waiting-active",
                                   "STATUS bit 2 stays 1 until the OB starts [DINT-16, AMB-34]"},
    [FAULT_DINT_OVERLAP_SILENT] = {"dint-overlap-silent",
                                   "no OB 80 when a delay ends while its OB runs [DINT-10]"},
    [FAULT_DINT_OVERLAP_DTIME] = {"dint-overlap-dtime",
                                  "ERROR_INFO of fault 02 shows DTIME, not SIGN [OBS-30]"},
    [FAULT_DINT_FOLLOWS_CLOCK] = {"dint-follows-clock",
                                  "delays are moved with the clock [DINT-18]"},
    [FAULT_DINT_RUNS_IN_HOLD] = {"dint-runs-in-hold", "delays go on in HOLD [DINT-19]"},
    [FAULT_DINT_SURVIVES] = {"dint-survives", "a restart keeps the jobs [DINT-13]"},
    [FAULT_STARTUP_RUNS_DINT] = {"startup-runs-dint",
                                 "OB 20 to 23 run during STARTUP [DINT-11, DINT-12]"},
    [FAULT_IRT_QUEUES] = {"irt-queues", "blocked events wait for SFC 40 [IRT-04]"},
    [FAULT_IRT_COUNTS] = {"irt-counts", "SFC 39 counts, and needs as many SFC 40 [IRT-16]"},
    [FAULT_IRT_SURVIVES] = {"irt-survives", "a restart keeps the blocks [IRT-03]"},
    [FAULT_IRT_ENDS_WITH_OB] = {"irt-ends-with-ob",
                                "the end of any OB takes the blocks back [IRT-02]"},
    [FAULT_IRT_MISSING_REACTS] = {
        "irt-missing-reacts", "a blocked event of a missing OB leads to OB 85 or STOP [IRT-01]"},
    [FAULT_IRT_STOPS_80] = {"irt-stops-80",
                            "a blocked time error without OB 80 stops the CPU [IRT-01, AMB-23]"},
    [FAULT_IRT_DROPS_QUEUED] = {"irt-drops-queued", "SFC 39 drops requests that wait [AMB-72]"},
    [FAULT_IRT_JOB_STAYS] = {
        "irt-job-stays", "a blocked once or delay stays active when it is lost [DINT-20, AMB-12]"},
    [FAULT_IRT_NO_STATUS] = {"irt-no-status", "STATUS bit 1 is always 0 [IRT-17, TINT-73]"},
    [FAULT_IRT_CLASS_FIRST] = {"irt-class-first",
                               "MODE 01 means the first OB of the class only [IRT-07]"},
    [FAULT_IRT_NO_CLASS_70] = {"irt-no-class-70", "class 70 is refused [IRT-11]"},
    [FAULT_IRT_NO_8X] = {"irt-no-8x", "MODE 80 to 82 of SFC 39 are refused [IRT-09]"},
    [FAULT_IRT_ALL_NEEDS_0] = {"irt-all-needs-0",
                               "MODE 00 with an OB_NR other than 0 gives 8090 [IRT-06, AMB-22]"},
    [FAULT_IRT_BAD_MODE] = {"irt-bad-mode", "a wrong MODE gives 8090 [IRT-12]"},
    [FAULT_IRT_OB1] = {"irt-ob1", "OB_NR 1 is accepted [IRT-12, AMB-73]"},
    [FAULT_EN_IRT_8X] = {"en-irt-8x", "SFC 40 takes MODE 80 to 82 as 00 to 02 [IRT-13, AMB-76]"},
    [FAULT_EN_IRT_BLOCKS] = {"en-irt-blocks", "SFC 40 with MODE 01 blocks [IRT-14]"},
    [FAULT_EN_IRT_8080] = {"en-irt-8080", "SFC 40 answers 8080 where nothing is blocked [IRT-24]"},
    [FAULT_DIAG_NO_5380] = {"diag-no-5380", "SFC 39 with MODE 8x does not enter 5380 [IRT-09]"},
    [FAULT_DIAG_5380_EACH] = {"diag-5380-each",
                              "5380 once more for every event that is not entered [AMB-41]"},
    [FAULT_DIAG_8X_ENTERED] = {"diag-8x-entered",
                               "events blocked with MODE 8x are entered [IRT-09]"},
    [FAULT_DIAG_0X_SILENT] = {"diag-0x-silent",
                              "events blocked with MODE 0x are not entered [IRT-06 to IRT-08]"},
    [FAULT_DIAG_EN_SILENT] = {"diag-en-silent", "SFC 40 does not bring the entries back [AMB-21]"},
    [FAULT_DIAG_NO_STOP] = {"diag-no-stop", "4568 and 456D are not entered [OBS-21, OBS-22]"},
    [FAULT_DIAG_3505] = {"diag-3505", "fault 06 is entered as 3505 [OBS-46]"},
    [FAULT_PRIORITY_DEFAULT] = {"priority-default",
                                "the classes that are set are ignored [OBS-05]"},
    [FAULT_STARTUP_CLASS] = {"startup-class",
                             "OB 80 to 87 keep their class in STARTUP and wait [OBS-43, AMB-13]"},
    [FAULT_OVERFLOW_CLASS] = {"overflow-class",
                              "OB 80 with fault 07 has its ordinary class [OBS-31, AMB-13]"},
    [FAULT_ASYNC_RUNS_ON] = {"async-runs-on",
                             "a missing OB 82, 83 or 86 does not stop the CPU [OBS-23]"},
};

bool fault_by_name(const char *name, enum fault *f)
{
    for (int i = FAULT_NONE + 1; i < FAULT_COUNT; i++)
        if (strcmp(table[i].name, name) == 0) {
            *f = (enum fault)i;
            return true;
        }
    return false;
}

const char *fault_name(enum fault f)
{
    return table[f].name;
}

void faults_help(FILE *out)
{
    for (int i = FAULT_NONE + 1; i < FAULT_COUNT; i++)
        fprintf(out, "  %-22s %s\n", table[i].name, table[i].text);
}

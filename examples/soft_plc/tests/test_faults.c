/* Every deliberate mistake around SFC 32 to 34, SFC 39 and 40, the diagnostic buffer and missing
 * OBs, where its requirement says that it shows: a piece of the log, and how often it is there
 * without and with the mistake. */
#include <stdio.h>
#include <stdlib.h>

#include "test.h"

/* OB 12, 22, 23, 41, 81 and 86 are missing; the clock shows 05:59:30. The last action gives every
 * log a line that shows what has not come. */
#define CPU(family)                                                                                \
    "cpu " family "\nobs 1 10 11 20 21 35 40 55 56 70 72 80 85 100\nclock 2026-11-21T05:59:30\n"   \
    "mode RUN\nduration 3min\nlog_diag on\nat +2min50s load 12\n"
#define S7_400 CPU("S7-400")
#define WAITING_DELAY                                                                              \
    S7_400 "ob 1 run 1 {\nSRT_DINT 20 1s 16#0\nDIS_AIRT\nbusy 2s\n"
#define MINUTE_10 "step7 10 minute 2026-11-21T00:00 active\n"
#define STARTED(ob) "\"start\",\"at\":\"2026-11-21T05:59:3" ob
#define STATUS(word) "\"status\":\"16#" word "\""
#define RET(word) "\"ret\":\"16#" word "\""

static const struct {
    enum fault fault;
    const char *text;
    const char *piece;
    int right, wrong;
} cases[] = {
    {FAULT_DINT_ZERO, S7_400 "ob 1 run 1 {\nSRT_DINT 20 0 16#0\n}\n", RET("8091"), 1, 0},
    {FAULT_DINT_NO_LIMIT, S7_400 "ob 1 run 1 {\nSRT_DINT 20 60001 16#0\n}\n", RET("8091"), 1, 0},
    {FAULT_DINT_COARSE, S7_400 "ob 1 run 1 {\nSRT_DINT 20 17 16#0\n}\n",
     STARTED("0.017\",\"ob\":20"), 1, 0},
    {FAULT_DINT_NO_RETRIGGER,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 2s 16#0\nbusy 1s\nSRT_DINT 20 2s 16#0\n}\n",
     STARTED("3.000\",\"ob\":20"), 1, 0},
    {FAULT_DINT_KEEPS_SIGN,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 2s 16#0001\nSRT_DINT 20 2s 16#0002\n}\n",
     "\"strt_info\":\"16#21\",\"sign\":\"16#0002\"", 1, 0},
    {FAULT_DINT_INFO_REST, S7_400 "ob 1 run 1 {\nSRT_DINT 20 2s 16#0001\n}\n",
     "\"sign\":\"16#0001\",\"dtime\":2000,\"time\"", 1, 0},
    {FAULT_DINT_CAN_ANY, S7_400 "ob 1 run 1 {\nCAN_DINT 20\n}\n", RET("80A0"), 1, 0},
    {FAULT_DINT_CAN_KEEPS, S7_400 "ob 1 run 1 {\nSRT_DINT 20 1s 16#0\nCAN_DINT 20\n}\n",
     ":\"start\"", 0, 1},
    {FAULT_DINT_CAN_RUNS, WAITING_DELAY "CAN_DINT 20\n}\n", RET("0000"), 1, 2},
    {FAULT_DINT_CAN_RUNS, WAITING_DELAY "CAN_DINT 20\n}\n", ":\"start\"", 1, 1},
    {FAULT_DINT_CAN_LOSES, WAITING_DELAY "CAN_DINT 20\n}\n", RET("80A0"), 1, 1},
    {FAULT_DINT_CAN_LOSES, WAITING_DELAY "CAN_DINT 20\n}\n", ":\"start\"", 1, 0},
    {FAULT_DINT_CAN_MIXED,
     WAITING_DELAY "CAN_DINT 20\nSRT_DINT 20 1s 16#0\nbusy 2s\nSRT_DINT 20 1s 16#0\n}\n",
     ":\"start\"", 2, 2},
    {FAULT_DINT_CAN_MIXED, WAITING_DELAY "CAN_DINT 20\n}\n", ":\"start\"", 1, 0},
    {FAULT_DINT_RUNNING_ACTIVE,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 1s 16#0\n}\nob 20 {\nQRY_DINT 20\n}\n", STATUS("0010"), 1,
     0},
    {FAULT_DINT_OVERLAP_SILENT,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 1s 16#0\n}\n"
            "ob 20 run 1 {\nSRT_DINT 20 1s 16#0\nbusy 2s\n}\n",
     "\"flt_id\":\"16#02\"", 2, 0},
    {FAULT_DINT_OVERLAP_DTIME,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 1s 16#0\n}\n"
            "ob 20 run 1 {\nSRT_DINT 20 1s 16#0007\nbusy 2s\n}\n",
     "\"error_info\":\"16#0007\"", 2, 0},
    {FAULT_DINT_FOLLOWS_CLOCK,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 10s 16#0\nset_clock +5s\n}\n", "\"start\",\"at\":"
                                                                    "\"2026-11-21T05:59:45.000\"",
     1, 0},
    {FAULT_DINT_RUNS_IN_HOLD,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 4s 16#0\n}\nat +1s hold\nat +6s release\n",
     STARTED("9.000\",\"ob\":20"), 1, 0},
    {FAULT_DINT_SURVIVES,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 4s 16#0\n}\nat +1s restart warm\n", "\"ob\":20,\"info\"", 0,
     1},
    {FAULT_STARTUP_RUNS_DINT,
     S7_400 "at +1s restart warm\nob 100 {\nSRT_DINT 20 1s 16#0\nbusy 3s\n}\n",
     STARTED("4.000\",\"ob\":20"), 1, 0},
    {FAULT_IRT_QUEUES,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#02 35\nbusy 2s\nEN_IRT 16#02 35\n}\nat +1s interrupt 35\n",
     ":\"start\"", 0, 1},
    {FAULT_IRT_COUNTS,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#02 35\nDIS_IRT 16#02 35\nEN_IRT 16#02 35\n}\n"
            "at +1s interrupt 35\n",
     ":\"start\"", 1, 0},
    {FAULT_IRT_SURVIVES,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#02 35\n}\nat +1s restart warm\nat +2s interrupt 35\n",
     "\"ob\":35,\"info\"", 1, 0},
    {FAULT_IRT_ENDS_WITH_OB,
     S7_400 "ob 40 {\nDIS_IRT 16#02 35\n}\nat +1s interrupt 40\nat +2s interrupt 35\n",
     "\"ob\":35,\"info\"", 0, 1},
    {FAULT_IRT_MISSING_REACTS,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#02 41\n}\nat +1s interrupt 41\n", "\"ob\":85,\"info\"", 0, 1},
    {FAULT_IRT_STOPS_80,
     S7_400 "at +1s delete 80\nob 1 run 1 {\nDIS_IRT 16#02 80\n}\nat +2s interrupt 80 16#01\n",
     "\"stop\"", 0, 1},
    {FAULT_IRT_DROPS_QUEUED,
     S7_400 "ob 1 run 1 {\nDIS_AIRT\nbusy 2s\nDIS_IRT 16#02 35\nEN_AIRT\n}\nat +1s interrupt 35\n",
     ":\"start\"", 1, 0},
    {FAULT_IRT_JOB_STAYS,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 1s 16#0\nDIS_IRT 16#02 20\nbusy 2s\nQRY_DINT 20\n}\n",
     STATUS("0012"), 1, 0},
    {FAULT_IRT_JOB_STAYS,
     S7_400 "step7 10 once 2026-11-21T06:00 active\n"
            "ob 1 run 1 {\nDIS_IRT 16#02 10\nbusy 40s\nQRY_TINT 10\n}\n",
     STATUS("0012"), 1, 0},
    {FAULT_IRT_NO_STATUS, S7_400 "ob 1 run 1 {\nDIS_IRT 16#00 0\nQRY_DINT 20\nQRY_TINT 10\n}\n",
     STATUS("0012"), 2, 0},
    {FAULT_IRT_CLASS_FIRST, S7_400 "ob 1 run 1 {\nDIS_IRT 16#01 50\n}\nat +1s interrupt 56\n",
     ":\"start\"", 0, 1},
    {FAULT_IRT_NO_CLASS_70, S7_400 "ob 1 run 1 {\nDIS_IRT 16#01 70\n}\n", RET("8090"), 0, 1},
    {FAULT_IRT_NO_8X, S7_400 "ob 1 run 1 {\nDIS_IRT 16#80 0\n}\n", RET("8091"), 0, 1},
    {FAULT_IRT_ALL_NEEDS_0, S7_400 "ob 1 run 1 {\nDIS_IRT 16#00 5\n}\n", RET("8090"), 0, 1},
    {FAULT_IRT_BAD_MODE, S7_400 "ob 1 run 1 {\nDIS_IRT 16#03 10\n}\n", RET("8091"), 1, 0},
    {FAULT_IRT_OB1, S7_400 "ob 1 run 1 {\nDIS_IRT 16#02 1\n}\n", RET("8090"), 1, 0},
    {FAULT_EN_IRT_8X, S7_400 "ob 1 run 1 {\nEN_IRT 16#82 35\n}\n", RET("8091"), 1, 0},
    {FAULT_EN_IRT_BLOCKS, S7_400 "ob 1 run 1 {\nEN_IRT 16#01 30\n}\nat +1s interrupt 35\n",
     ":\"start\"", 1, 0},
    {FAULT_EN_IRT_8080, S7_400 "ob 1 run 1 {\nEN_IRT 16#02 35\n}\n", RET("0000"), 1, 0},
    {FAULT_DIAG_NO_5380, S7_400 "ob 1 run 1 {\nDIS_IRT 16#82 35\n}\n", "16#5380", 1, 0},
    {FAULT_DIAG_5380_EACH,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#82 80\n}\nat +1s interrupt 80 16#01\n", "16#5380", 1, 2},
    {FAULT_DIAG_8X_ENTERED,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#82 80\n}\nat +1s interrupt 80 16#01\n", "16#3501", 0, 1},
    {FAULT_DIAG_0X_SILENT,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#02 80\n}\nat +1s interrupt 80 16#01\n", "16#3501", 1, 0},
    {FAULT_DIAG_EN_SILENT,
     S7_400 "ob 1 run 1 {\nDIS_IRT 16#82 80\nEN_IRT 16#02 80\n}\nat +1s interrupt 80 16#01\n",
     "16#3501", 1, 0},
    {FAULT_DIAG_NO_STOP, S7_400 "at +1s delete 80\nat +2s interrupt 80 16#01\n",
     "\"id\":\"16#4568\"", 1, 0},
    {FAULT_DIAG_NO_STOP, S7_400 "at +1s delete 85\nat +2s interrupt 41\n", "\"id\":\"16#456D\"", 1,
     0},
    {FAULT_DIAG_3505, S7_400 MINUTE_10 "at +1s hold\nat +2min release\n", "16#3506", 1, 0},
    {FAULT_PRIORITY_DEFAULT, S7_400 "priority 20 12\nob 1 run 1 {\nSRT_DINT 20 1s 16#0\n}\n",
     "\"priority\":12,\"strt_info\"", 1, 0},
    {FAULT_STARTUP_CLASS,
     S7_400 "at +1s restart warm\nob 100 {\nbusy 5s\n}\nat +2s interrupt 80 16#01\n",
     STARTED("2.000\",\"ob\":80,\"info\":{\"priority\":28"), 1, 0},
    {FAULT_OVERFLOW_CLASS,
     CPU("S7-300") "buffer 1\nat +1s interrupt 35\nat +1s interrupt 35\n",
     "\"info\":{\"priority\":28,\"flt_id\":\"16#07\"", 2, 0},
    {FAULT_ASYNC_RUNS_ON, S7_400 "at +1s interrupt 86\n", "\"stop\"", 1, 0},
    {FAULT_FIFO,
     S7_400 "ob 1 run 1 {\nDIS_AIRT\nbusy 4s\nEN_AIRT\n}\nob 35 {\nbusy 5s\n}\n"
            "at +1s interrupt 35\nat +2s interrupt 40\n",
     STARTED("4.000\",\"ob\":40"), 1, 1},
    {FAULT_FIFO,
     S7_400 "ob 1 run 1 {\nDIS_AIRT\nbusy 4s\nEN_AIRT\n}\nob 40 {\nbusy 1s\n}\n"
            "at +1s interrupt 35\nat +2s interrupt 40\n",
     STARTED("5.000\",\"ob\":35"), 1, 0},
    {FAULT_ONCE_RUNS_TWICE,
     S7_400 "step7 10 once 2026-11-21T06:00 active\n"
            "ob 10 run 1 {\nset_clock 2026-11-21T05:59:30\n}\n",
     ":\"start\"", 1, 2},
    {FAULT_BACK_BLOCKS_NEW,
     S7_400 "ob 1 run 1 {\nset_clock +1h\nset_clock -1h\nSET_TINT 10 2026-11-21T06:00 16#0201\n"
            "ACT_TINT 10\n}\n",
     "\"ob\":10,\"info\"", 3, 0},
    {FAULT_CLOCK_RUNS_AWAY, S7_400 "", "\"at\":\"2026-11-21T06:02:20.000\"", 1, 0},
    {FAULT_OVERLAP_RUNS_EACH, S7_400 MINUTE_10 "ob 10 run 1 {\nbusy 121s\n}\n",
     "\"ob\":10,\"info\"", 2, 3},
    {FAULT_SKIP_AS_INTERRUPT, S7_400 MINUTE_10 "at +1s clock +5min\n", "\"interrupt\",\"at\"", 0, 1},
    {FAULT_STOP_CAUSE, S7_400 "at +1s stop\n", "\"cause\":\"16#4568\"", 0, 1},
    {FAULT_STARTUP_TIME, S7_400 "at +1s restart warm\n", "\"time\":\"2026-11-21T05:59:31.000\"", 1,
     0},
    {FAULT_STATE_ACTIVE, S7_400 MINUTE_10 "ob 1 run 1 {\nstate 10\nstate 20\n}\n",
     "\"ob\":10,\"active\":true", 1, 0},
    {FAULT_STATE_BLOCKED, S7_400 "ob 1 run 1 {\nDIS_IRT 16#02 35\nstate 35\n}\n",
     "\"ob\":35,\"blocked\":true", 1, 0},
    {FAULT_STATE_LOADED, S7_400 "at +1s state 12\n", "\"loaded\":true", 0, 1},
    {FAULT_STATE_ENTRIES, S7_400 "ob 1 run 1 {\nDIS_IRT 16#82 35\nstate 35\n}\n",
     "\"entries_off\":true", 1, 0},
    {FAULT_STATE_LEFT,
     S7_400 "ob 1 run 1 {\nSRT_DINT 20 5s 16#0\n}\nat +1s hold\nat +3s state 20\n",
     "\"left\":4000", 1, 0},
};

void test_faults(void)
{
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char *right = test_run(cases[i].text, FAULT_NONE);
        char *wrong = test_run(cases[i].text, cases[i].fault);
        bool shows = test_count(right, cases[i].piece) == cases[i].right &&
                     test_count(wrong, cases[i].piece) == cases[i].wrong;
        if (!shows)
            fprintf(stderr, "fault %s:\n%s---\n%s", fault_name(cases[i].fault), right, wrong);
        CHECK(shows);
        free(right);
        free(wrong);
    }
}

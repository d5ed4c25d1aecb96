/* Each choice that the requirements leave, both ways: a piece of the log, and how often it is there
 * with the first value and with the second. */
#include <stdio.h>
#include <stdlib.h>

#include "test.h"

/* OB 81 to 87 are missing but OB 85; the clock shows 05:59:30. The last action gives every log a
 * line that shows what has not come. */
#define CPU(family)                                                                                \
    "cpu " family "\nobs 1 10 11 20 35 80 85 100\nclock 2026-11-21T05:59:30\nmode RUN\n"           \
    "duration 10min\nat +9min load 12\n"
#define NEWER "cpu S7-1500\nobs 1 10 80 100\nclock 2026-11-21T05:59:30\nmode RUN\nduration 10min\n"
#define ONCE_10 "step7 10 once 2026-11-21T06:00 active\n"
#define STATUS(word) "\"status\":\"16#" word "\""
#define RET(word) "\"ret\":\"16#" word "\""
#define WAITING_DELAY(calls)                                                                       \
    CPU("S7-400") "ob 1 run 1 {\nSRT_DINT 20 1s 16#0001\nDIS_AIRT\nbusy 2s\n" calls "EN_AIRT\n}\n"
/* OB 10 waits from 06:00 on. */
#define WAITING_ONCE(calls)                                                                        \
    CPU("S7-300") ONCE_10 "ob 1 run 1 {\nDIS_AIRT\nbusy 31s\n" calls "EN_AIRT\n}\n"
/* One second after the other, while the first cycle runs `calls`. */
#define EXCEEDED_TWICE(calls)                                                                      \
    CPU("S7-300") "at +1s interrupt 80 16#01\nat +2s interrupt 80 16#01\nob 1 run 1 {\n" calls "}\n"
/* OB 20 and OB 21 fall due in one moment; NESTED: OB 21 has interrupted OB 20. */
#define TOGETHER(calls)                                                                            \
    "cpu S7-400\nobs 1 20 21 85 100\nclock 2026-11-21T05:59:30\nmode RUN\nduration 5s\n"          \
    "ob 1 run 1 {\nSRT_DINT 20 1s 16#0001\nSRT_DINT 21 1s 16#0001\n" calls "busy 2s\n}\n"
#define NESTED "\"ob\":21}\n{\"event\":\"end\""
#define STOPS "\"cause\":\"16#4568\""
#define OB_80 "\"ob\":80,\"info\""

static const struct {
    const char *first, *second;
    const char *text;
    const char *piece;
    int with_first, with_second;
} cases[] = {
    {"AMB-11=c", "AMB-11=b", WAITING_DELAY("CAN_DINT 20\n"), ":\"start\"", 1, 0},
    {"AMB-11=c", "AMB-11=b", WAITING_DELAY("CAN_DINT 20\n"), RET("80A0"), 1, 0},
    {"AMB-11=c", "AMB-11=b", WAITING_DELAY("SRT_DINT 20 5s 16#0002\n"), ":\"start\"", 2, 1},
    {"AMB-11=c", "AMB-11=b", WAITING_DELAY("SRT_DINT 20 5s 16#0002\nCAN_DINT 20\nCAN_DINT 20\n"),
     ":\"start\"", 1, 0},
    {"DINT-16=0", "DINT-16=1", WAITING_DELAY("QRY_DINT 20\n"), STATUS("0014"), 0, 1},
    {"DINT-16=0", "DINT-16=1", WAITING_DELAY("state 20\n"), "\"active\":true", 0, 1},
    {"DINT-17=exact", "DINT-17=less", WAITING_DELAY("SRT_DINT 20 5s 16#0002\nstate 20\n"),
     "\"left\":5000", 1, 0},
    {"DINT-17=exact", "DINT-17=less", WAITING_DELAY("SRT_DINT 20 5s 16#0002\nstate 20\n"),
     "\"left\":4999", 0, 1},
    {"OBS-03=highest", "OBS-03=lowest", TOGETHER(""), NESTED, 0, 1},
    /* Older than this moment, the highest class goes first. */
    {"OBS-03=highest", "OBS-03=lowest", TOGETHER("DIS_AIRT\nbusy 2s\nEN_AIRT\n"),
     NESTED, 0, 0},
    {"AMB-34=a", "AMB-34=b", WAITING_ONCE("QRY_TINT 10\n"), STATUS("0014"), 1, 0},
    {"AMB-34=a", "AMB-34=b", WAITING_ONCE("state 10\n"), "\"active\":true,\"blocked\"", 1, 0},
    {"AMB-34=a", "AMB-34=b", WAITING_ONCE("CAN_TINT 10\n"), ":\"start\"", 0, 0},
    {"AMB-49=a", "AMB-49=b",
     CPU("S7-400") "ob 1 run 1 {\nDIS_AIRT\nbusy 2s\nEN_AIRT\n}\nat +1s interrupt 82\n",
     "\"stop\",\"at\":\"2026-11-21T05:59:31.000\"", 1, 0},
    {"AMB-49=a", "AMB-49=b",
     CPU("S7-400") "ob 1 run 1 {\nDIS_AIRT\nbusy 2s\nEN_AIRT\n}\nat +1s interrupt 82\n",
     "\"stop\",\"at\":\"2026-11-21T05:59:32.000\"", 0, 1},
    /* Without SFC 41 there is nothing to wait for. */
    {"AMB-49=a", "AMB-49=b", CPU("S7-400") "at +1s interrupt 82\n",
     "\"stop\",\"at\":\"2026-11-21T05:59:31.000\"", 1, 1},
    /* OB 10 is served at 06:00 and 06:01 and blocked at 06:02; then the clock goes back. */
    {"AMB-56=b", "AMB-56=d",
     CPU("S7-400") "step7 10 minute 2026-11-21T00:00 active\n"
                   "ob 1 run 1 {\nbusy 2min\nDIS_IRT 16#02 10\nbusy 1min\nEN_IRT 16#02 10\n"
                   "set_clock 2026-11-21T05:59:45\n}\n",
     "\"time\":\"2026-11-21T06:02:00.000\"", 0, 1},
    {"AMB-56=b", "AMB-56=d",
     CPU("S7-400") "step7 10 minute 2026-11-21T00:00 active\n"
                   "ob 1 run 1 {\nbusy 2min\nDIS_IRT 16#02 10\nbusy 1min\nEN_IRT 16#02 10\n"
                   "set_clock 2026-11-21T05:59:45\n}\n",
     "\"time\":\"2026-11-21T06:01:00.000\"", 1, 1},
    {"AMB-60=a", "AMB-60=b", WAITING_ONCE("ACT_TINT 10\n"), RET("80A1"), 0, 1},
    {"AMB-60=a", "AMB-60=b", WAITING_ONCE("ACT_TINT 10\n"), ":\"start\"", 1, 1},
    {"AMB-71=a", "AMB-71=c", CPU("S7-300") ONCE_10 "ob 10 {\nCAN_TINT 10\n}\n", RET("80A0"), 1, 0},
    {"AMB-71=a", "AMB-71=c", CPU("S7-300") ONCE_10 "ob 10 {\nQRY_TINT 10\n}\n", STATUS("0014"), 0, 1},
    {"AMB-71=a", "AMB-71=c",
     CPU("S7-300") ONCE_10 "ob 1 run 5000 {\nACT_TINT 10\nQRY_TINT 10\n}\n", STATUS("0010"), 1, 1},
    /* [CLK-12]: a clock set back inside the OB does not arm it again, [TINT-65]: a new SET does. */
    {"AMB-71=a", "AMB-71=c",
     CPU("S7-300") ONCE_10 "ob 10 run 1 {\nset_clock 2026-11-21T05:59:30\n}\n", ":\"start\"", 1, 1},
    {"AMB-71=a", "AMB-71=c",
     CPU("S7-300") ONCE_10 "ob 10 run 1 {\nSET_TINT 10 2026-11-21T06:02 16#0000\nACT_TINT 10\n}\n",
     ":\"start\"", 2, 2},
    /* The same while it waits. */
    {"AMB-71=a", "AMB-71=c", WAITING_ONCE("set_clock 2026-11-21T05:59:30\n"), ":\"start\"", 1, 1},
    {"AMB-79=b", "AMB-79=a",
     CPU("S7-300") "ob 1 run 1 {\nSET_TINT 10 2026-11-21T06:00:99 16#0201\n}\n", RET("8091"), 1, 0},
    {"AMB-79=b", "AMB-79=a",
     CPU("S7-300") "ob 1 run 1 {\nSET_TINT 10 2026-11-21T06:60:99 16#0201\n}\n", RET("8091"), 1, 1},
    /* The cycle time is exceeded twice in the first cycle; in two cycles; once blocked by SFC 39,
     * with no OB 80; under SFC 41. */
    {"OBS-26=stop", "OBS-26=again", EXCEEDED_TWICE("busy 3s\n"), STOPS, 1, 0},
    {"OBS-26=stop", "OBS-26=again", EXCEEDED_TWICE("busy 3s\n"), OB_80, 1, 2},
    {"OBS-26=stop", "OBS-26=again", EXCEEDED_TWICE("busy 1500ms\n"), STOPS, 0, 0},
    {"OBS-26=stop", "OBS-26=again", EXCEEDED_TWICE("busy 1500ms\n"), OB_80, 2, 2},
    {"OBS-26=stop", "OBS-26=again",
     EXCEEDED_TWICE("DIS_IRT 16#02 80\nbusy 1500ms\nEN_IRT 16#02 80\nbusy 1500ms\n"), STOPS, 0, 0},
    {"OBS-26=stop", "OBS-26=again", EXCEEDED_TWICE("DIS_AIRT\nbusy 3s\n"), STOPS, 1, 0},
    {"OBS-26=stop", "OBS-26=again", EXCEEDED_TWICE("DIS_AIRT\nbusy 3s\n"), OB_80, 0, 2},
    {"OBS-10=event", "OBS-10=call", WAITING_DELAY(""), "\"time\":\"2026-11-21T05:59:31.000\"", 1, 0},
    {"OBS-10=event", "OBS-10=call", WAITING_DELAY(""), "\"time\":\"2026-11-21T05:59:32.000\"", 0, 1},
    /* The time of a catch-up is that of the point that was skipped first [CLK-07]. */
    {"OBS-10=event", "OBS-10=call", CPU("S7-300") ONCE_10 "at +1s clock +5min\n",
     "\"time\":\"2026-11-21T06:00:00.000\"", 1, 1},
    {"T15-130=new", "T15-130=old", NEWER ONCE_10, "{\"priority\":2,\"strt_info\":\"16#11\"", 1, 0},
    {"T15-130=new", "T15-130=old", NEWER ONCE_10, "\"second_time\"", 0, 1},
    {"T15-130=new", "T15-130=old", CPU("S7-400") ONCE_10, "\"second_time\"", 0, 0},
};

static char *run(const char *choice, const char *text)
{
    char whole[2000];
    snprintf(whole, sizeof whole, "%schoose %s\n", text, choice);
    return test_run(whole, FAULT_NONE);
}

void test_choices(void)
{
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char *first = run(cases[i].first, cases[i].text);
        char *second = run(cases[i].second, cases[i].text);
        bool shows = test_count(first, cases[i].piece) == cases[i].with_first &&
                     test_count(second, cases[i].piece) == cases[i].with_second;
        if (!shows)
            fprintf(stderr, "%s, %s:\n%s---\n%s", cases[i].first, cases[i].second, first, second);
        CHECK(shows);
        free(first);
        free(second);
    }
}

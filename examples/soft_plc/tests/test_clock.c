/* The clock set forward and back. */
#include <stdlib.h>

#include "test.h"

static void forward(void)
{
    const char *text = "step7 10 minute 2026-11-21T00:00 active\n"
                       "step7 11 once 2026-11-21T06:02 active\n"
                       "at +10s clock 2026-11-21T06:10:30\n";
    char *log = test_run(text, 0);
    CHECK(test_in_order(log, "\"clock\"",
                        "\"ob\":80,\"info\":{\"priority\":26,\"flt_id\":\"16#05\",\"error_info\":"
                        "\"16#0003\",\"time\":\"2026-11-21T06:10:30.000\"",
                        "\"end\"", "\"ob\":10,\"info\":{\"priority\":2,\"strt_info\":\"16#11\","
                                   "\"period\":\"16#0201\",\"time\":\"2026-11-21T06:00:00.000\"",
                        "\"ob\":11,\"info\":{\"priority\":2,\"strt_info\":\"16#12\",\"period\":"
                        "\"16#0000\",\"time\":\"2026-11-21T06:02:00.000\"",
                        "06:11:00.000\",\"ob\":10", NULL));
    CHECK(test_count(log, "\"ob\":11,\"info\"") == 1);
    CHECK(test_count(log, "16#05") == 1);
    free(log);
}

/* Reached exactly: no skip (AMB-37). In OB 80 the catch-up is withdrawn [CLK-04, TINT-54]. */
static void reached_and_withdrawn(void)
{
    char *log = test_run("step7 10 hourly 2026-11-21T00:00 active\n"
                         "at +10s clock 2026-11-21T06:00:00\nob 80 {\nCAN_TINT 10\n}\n"
                         "at +1min clock 2026-11-21T09:30:00\n",
                         0);
    CHECK(test_in_order(log, "\"clock\"", "06:00:00.000\",\"ob\":10", "\"clock\"", "\"ob\":80",
                        "CAN_TINT", NULL));
    CHECK(test_count(log, ":\"start\"") == 2);
    free(log);
}

static void back(void)
{
    const char *rest = "\nobs 1 10 80 85 100\nclock 2026-11-21T05:59:30\nmode RUN\n"
                       "duration 5min\nstep7 10 minute 2026-11-21T00:00 active\n"
                       "at +2min10s clock -1min\n";
    char text[400];
    static const struct {
        const char *cpu;
        int starts;
        enum fault fault;
    } cases[] = {{"cpu S7-300", 5, 0}, {"cpu S7-400", 4, 0}, {"cpu 318", 4, 0},
                 {"cpu S7-400", 5, FAULT_REPEAT_S7_400},
                 {"cpu S7-300", 4, FAULT_NO_REPEAT_S7_300}};
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        test_join(text, sizeof text, cases[i].cpu, rest);
        char *log = test_run(text, cases[i].fault);
        CHECK(test_count(log, ":\"start\"") == cases[i].starts); /* [CLK-09, CLK-10] */
        CHECK(test_count(log, "\"ob\":80,") == 0);
        free(log);
    }
}

static void set_by_program(void)
{
    char *log = test_run("step7 10 minute 2026-11-21T00:00 active\n"
                         "ob 10 run 1 {\nset_clock +5min\nQRY_TINT 10\n}\n",
                         0);
    CHECK(test_in_order(log, "06:00:00.000\",\"ob\":10", "\"clock\"", "\"ob\":80", "\"end\"",
                        "QRY_TINT", "\"end\"", "\"ob\":10,\"info\":{\"priority\":2,\"strt_info\":"
                                               "\"16#11\",\"period\":\"16#0201\",\"time\":"
                                               "\"2026-11-21T06:01:00.000\"",
                        NULL));
    free(log);
}

void test_clock(void)
{
    forward();
    reached_and_withdrawn();
    back();
    set_by_program();
}

/* Restart, STARTUP, HOLD. */
#include <stdlib.h>

#include "test.h"

static void restart(void)
{
    char *log = test_run("step7 10 once 2026-11-21T05:00 active\nstep7 11 none\n"
                         "at +1min restart warm\nat +2min restart cold\n"
                         "ob 1 run 1 {\nQRY_TINT 10\nSET_TINT 11 2026-11-21T06:05 16#0201\n"
                         "ACT_TINT 11\nDIS_AIRT\nbusy 90s\n}\n"
                         "ob 100 {\nQRY_TINT 10\nQRY_TINT 11\nACT_TINT 11\nbusy 1s\n}\n",
                         0);
    CHECK(test_in_order(log, "\"step7\"", "\"status\":\"16#0010\"", "\"stop\"", "\"warm\"",
                        "\"ob\":100,\"info\":{\"priority\":27,\"strt_info\":\"16#81\"",
                        "\"ob\":10,\"ret\":\"16#0000\",\"status\":\"16#0015\"",
                        "\"ob\":11,\"ret\":\"16#0000\",\"status\":\"16#0011\"",
                        "\"ret\":\"16#80A0\"", /* AMB-62 */
                        "\"end\"", "\"run\"", "\"ob\":10,\"info\"", "\"stop\"", "\"cold\"",
                        "\"ob\":102,\"info\":{\"priority\":27,\"strt_info\":\"16#85\"", "\"run\"",
                        "\"ob\":10,\"info\"", NULL)); /* [OBS-56]: once after every restart */
    CHECK(test_count(log, "\"ob\":11,\"info\"") == 0);
    free(log);
}

static void deferred(void)
{
    char *log = test_run("at +10s restart warm\nstep7 10 minute 2026-11-21T00:00 active\n"
                         "at +12s interrupt 87\nat +11s load 87\n"
                         "ob 100 {\nbusy 2min30s\n}\n",
                         0);
    CHECK(test_in_order(log, "\"load\"", "\"ob\":87,\"info\":{\"priority\":28", "\"end\"", "\"run\"",
                        "\"ob\":10,\"info\"", "\"end\"", "06:03:00.000\",\"ob\":10", NULL));
    free(log);
}

static void hold(void)
{
    char *log = test_run("step7 10 hourly 2026-11-21T00:00 active\nat +10s hold\n"
                         "at +2min release\n",
                         0);
    CHECK(test_in_order(log, "\"hold\"", "\"release\"", "\"flt_id\":\"16#06\",\"error_info\":"
                                                        "\"16#0001\"",
                        "\"end\"", "\"ob\":10,\"info\"", NULL));
    free(log);
}

static void deselected_loaded(void)
{
    char *log = test_run("step7 10 deselected\nat +1s restart warm\n", 0);
    CHECK(test_in_order(log, "\"restart\"", "\"cause\":\"16#454A\"", NULL));
    CHECK(test_count(log, "\"run\"") == 0);
    free(log);
}

#define HOT "cpu S7-400\nobs 1 20 35 40 80 82 85 101\nclock 2026-11-21T05:59:30\nmode RUN\nduration 1min\n"

/* STOP interrupts OB 35 with a delay count of 1; its last 100 ms and its SFC 42 come after RUN. */
static void hot(void)
{
    char *log = test_run(HOT "at +1s interrupt 35\nat +2s interrupt 40\nat +2s interrupt 82\n"
                             "at +3s stop\nat +10s restart hot\n"
                             "ob 1 run 1 {\nSRT_DINT 20 5s 16#0007\nDIS_IRT 16#02 41\nbusy 30s\n}\n"
                             "ob 35 {\nDIS_AIRT\nbusy 2100ms\nEN_AIRT\nQRY_DINT 20\n}\n"
                             "ob 101 {\nDIS_AIRT\nEN_AIRT\n}\n",
                         0);
    CHECK(test_in_order(log, "\"ob\":35,\"info\"", "\"DIS_AIRT\"", "\"interrupt\"", "\"stop\"", "\"hot\"",
                        "\"ob\":101,\"info\":{\"priority\":27,\"strt_info\":\"16#83\"", "\"DIS_AIRT\"",
                        "\"EN_AIRT\"", "\"end\"", "\"run\"", "\"EN_AIRT\"", "\"ob\":40,\"info\"", "\"end\"",
                        "\"status\":\"16#0014\"", "\"end\"", "05:59:42.000\",\"ob\":20", NULL));
    CHECK(test_count(log, "\"ob\":82,\"info\"") == 0); /* discarded [OBS-52] */
    free(log);
}

#define SYNC                                                                                       \
    "cpu S7-300\nobs 1 35 40 85 100 121\nclock 2026-11-21T05:59:30\nmode RUN\nduration 10s\n"

/* OB 35 fails under a delay and a block of all: OB 121 runs in class 12, and OB 40 waits until
 * OB 121 takes the delay back. Without OB 122 the CPU stops. */
static void synchronous(void)
{
    char *log = test_run(SYNC "at +1s interrupt 35\nat +1s interrupt 40\nat +2s interrupt 121\n"
                              "at +5s interrupt 122\n"
                              "ob 35 {\nDIS_AIRT\nDIS_IRT 16#00 0\nbusy 2s\n}\n"
                              "ob 121 {\nDIS_AIRT\nbusy 1s\nEN_AIRT\nEN_AIRT\nbusy 100ms\n}\n",
                         0);
    CHECK(test_in_order(log, "\"ob\":121", "\"ob\":121,\"info\":{\"priority\":12", "\"ret\":\"16#0002\"",
                        "\"ret\":\"16#0001\"", "\"ret\":\"16#0000\"", "\"end\"", "\"end\"", "\"ob\":122",
                        "\"cause\":\"16#4563\"", NULL));
    free(log);
}

void test_modes(void)
{
    restart();
    synchronous();
    hot();
    deferred();
    hold();
    deselected_loaded();
}

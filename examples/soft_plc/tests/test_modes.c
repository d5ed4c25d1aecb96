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

void test_modes(void)
{
    restart();
    deferred();
    hold();
    deselected_loaded();
}

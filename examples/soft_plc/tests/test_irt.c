/* SFC 39 and 40: start events that are lost. */
#include <stdlib.h>

#include "test.h"

#define CPU \
    "cpu S7-400\nobs 1 10 11 20 35 40 55 70 80 82 85 100 102\nclock 2026-11-21T05:59:30\n" \
    "mode RUN\nduration 3min\n"

static void return_values(void)
{
    char *log = test_run(CPU "ob 1 run 1 {\nEN_IRT 16#00 0\nDIS_IRT B#16#00 5\nDIS_IRT 16#01 70\n"
                             "DIS_IRT 16#81 50\nDIS_IRT 16#02 87\nDIS_IRT 16#82 47\n"
                             "DIS_IRT 16#80 0\nEN_IRT 16#01 10\n"
                             "DIS_IRT 16#03 0\nDIS_IRT 16#83 10\nEN_IRT 16#80 0\nEN_IRT 16#82 10\n"
                             "DIS_IRT 16#01 0\nDIS_IRT 16#01 11\nDIS_IRT 16#02 1\nDIS_IRT 16#02 0\n"
                             "DIS_IRT 16#02 61\nEN_IRT 16#02 100\nEN_IRT 16#02 -1\n}\n",
                         0);
    CHECK(test_count(log, "\"ret\":\"16#0000\"") == 8);
    CHECK(test_in_order(log, "\"EN_IRT\",\"at\":\"2026-11-21T05:59:30.000\",\"mode\":\"16#00\","
                             "\"ob\":0,\"ret\":\"16#0000\"", /* [IRT-24] */
                        "\"ob\":5,\"ret\":\"16#0000\"",      /* AMB-22 */
                        "\"mode\":\"16#01\",\"ob\":10", "16#8091", "16#8091", "16#8091", "16#8091",
                        "16#8090", "16#8090", "16#8090", "16#8090", "16#8090", "16#8090", "16#8090",
                        NULL));
    free(log);
}

/* [IRT-04, IRT-07, IRT-08, IRT-16, IRT-17]: lost, and one EN_IRT is enough. */
static void lost(void)
{
    char *log = test_run(CPU "step7 10 minute 2026-11-21T00:00 active\n"
                             "ob 1 run 1 {\nDIS_IRT 16#01 20\nDIS_IRT 16#02 10\nDIS_IRT 16#02 10\n"
                             "DIS_IRT 16#01 30\nSRT_DINT 20 10s 16#0001\nQRY_DINT 20\nbusy 40s\n"
                             "QRY_DINT 20\nQRY_TINT 10\nQRY_TINT 11\nEN_IRT 16#02 10\n"
                             "EN_IRT 16#00 0\n}\n"
                             "at +20s interrupt 35\nat +21s interrupt 40\nat +50s interrupt 35\n",
                         0);
    CHECK(test_in_order(log, "\"status\":\"16#0016\"", "\"ob\":35}", "\"ob\":40}",
                        "\"start\",\"at\":\"2026-11-21T05:59:51.000\",\"ob\":40",
                        "\"status\":\"16#0012\"", /* DINT-20: the job is over */
                        "\"status\":\"16#0016\"", /* IRT-18: periodic goes on */
                        "\"status\":\"16#0010\"", "EN_IRT", "EN_IRT", "\"ob\":35}",
                        "06:00:20.000\",\"ob\":35", "\"start\",\"at\":\"2026-11-21T06:01:00.000\"",
                        NULL));
    CHECK(test_count(log, ":\"start\"") == 4); /* OB 40, 35, twice OB 10 */
    CHECK(test_count(log, "\"ob\":80,") == 0);
    free(log);
}

/* AMB-12: a single start is used up. AMB-72: what waits already runs. */
static void once(void)
{
    char *log = test_run(CPU "step7 10 once 2026-11-21T06:00 active\n"
                             "step7 11 once 2026-11-21T06:00 active\n"
                             "ob 1 run 1 {\nDIS_IRT 16#02 10\nDIS_AIRT\nbusy 31s\nQRY_TINT 10\n"
                             "ACT_TINT 10\nDIS_IRT 16#02 11\nEN_AIRT\n}\n",
                         0);
    CHECK(test_in_order(log, "\"status\":\"16#0012\"", "16#80A0", "EN_AIRT",
                        "06:00:01.000\",\"ob\":11,\"info\"", NULL));
    CHECK(test_count(log, ":\"start\"") == 1);
    free(log);
}

/* [IRT-01]: neither OB 85 nor STOP for a missing OB; AMB-23, AMB-33: nor without OB 80. */
static void no_reaction(void)
{
    char *log = test_run("cpu S7-300\nobs 1 10 85 100\nclock 2026-11-21T05:59:30\nmode RUN\n"
                         "duration 5min\nstep7 10 minute 2026-11-21T00:00 active\n"
                         "ob 1 run 1 {\nDIS_IRT 16#01 80\nDIS_IRT 16#02 40\nSRT_DINT 20 1s 16#0\n}\n"
                         "at +10s interrupt 40\nat +11s interrupt 80 16#01\nat +12s interrupt 82\n"
                         "at +13s interrupt 85 16#A3\nat +14s delete 85\nat +15s clock +10min\n",
                         0);
    CHECK(test_count(log, "\"stop\"") == 0);
    CHECK(test_count(log, "\"ob\":85,\"info\"") == 0);
    CHECK(test_in_order(log, "\"clock\"", "06:09:45.000\",\"ob\":10,\"info\"", NULL)); /* AMB-48 */
    free(log);
}

/* [IRT-03, OBS-53] */
static void restart(void)
{
    char *log = test_run(CPU "ob 1 run 1 {\nDIS_IRT 16#00 0\nQRY_DINT 20\n}\nat +1s restart warm\n"
                             "at +2s interrupt 35\nat +3s restart cold\nat +4s interrupt 35\n"
                             "ob 100 {\nQRY_DINT 20\nDIS_IRT 16#02 35\n}\n",
                         0);
    CHECK(test_in_order(log, "\"status\":\"16#0012\"", "\"warm\"", "\"status\":\"16#0011\"",
                        "\"cold\"", "\"start\",\"at\":\"2026-11-21T05:59:34.000\",\"ob\":35", NULL));
    CHECK(test_count(log, "\"ob\":35,\"info\"") == 1);
    free(log);
}

/* AMB-50, either: a skipped point of a blocked OB is used up without its bit. */
static void skipped(void)
{
    char *log = test_run(CPU "step7 10 hourly 2026-11-21T00:00 active\n"
                             "step7 11 hourly 2026-11-21T00:00 active\n"
                             "ob 1 run 1 {\nDIS_IRT 16#02 10\n}\nat +1s clock +1h\n",
                         0);
    CHECK(test_in_order(log, "\"clock\"", "\"error_info\":\"16#0002\"", "\"end\"", "\"ob\":11,\"info\"",
                        NULL));
    CHECK(test_count(log, "\"ob\":10,\"info\"") == 0);
    free(log);
}

void test_irt(void)
{
    return_values();
    lost();
    once();
    no_reaction();
    restart();
    skipped();
}

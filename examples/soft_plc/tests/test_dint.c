/* Time-delay interrupts: SFC 32 to 34, OB 20 to 23. */
#include <stdlib.h>

#include "test.h"

/* A CPU with delay OBs, running from 05:59:30. */
#define CPU \
    "cpu S7-400\nobs 1 10 20 21 35 40 80 85 100 102\nclock 2026-11-21T05:59:30\nmode RUN\n" \
    "duration 2min\n"

static void return_values(void)
{
    char *log = test_run(CPU "ob 1 run 1 {\nSRT_DINT 19 10ms 16#0\nSRT_DINT 24 10ms 16#0\n"
                             "SRT_DINT 20 0 16#0\nSRT_DINT 20 -5 16#0\nSRT_DINT 20 60001 16#0\n"
                             "CAN_DINT 20\nCAN_DINT 10\nQRY_DINT 19\nQRY_DINT 20\n"
                             "SRT_DINT 20 60000 16#FFFF\nQRY_DINT 20\nSRT_DINT 23 1ms 16#0\n"
                             "QRY_DINT 23\nCAN_DINT 23\nCAN_DINT 20\nCAN_DINT 20\n}\n",
                         0);
    CHECK(test_in_order(log, "\"ob\":19,\"dtime\":10,\"sign\":\"16#0000\",\"ret\":\"16#8090\"",
                        "16#8090", "\"dtime\":0,\"sign\":\"16#0000\",\"ret\":\"16#8091\"",
                        "\"dtime\":-5,\"sign\":\"16#0000\",\"ret\":\"16#8091\"",
                        "\"dtime\":60001,\"sign\":\"16#0000\",\"ret\":\"16#8091\"",
                        "\"CAN_DINT\",\"at\":\"2026-11-21T05:59:30.000\",\"ob\":20,"
                        "\"ret\":\"16#80A0\"", "16#8090",
                        "\"ob\":19,\"ret\":\"16#8090\"}", "\"status\":\"16#0010\"",
                        "\"ret\":\"16#0000\"", "\"status\":\"16#0014\"", "\"ret\":\"16#0000\"",
                        "\"status\":\"16#0004\"", /* OB 23 is not loaded */
                        "\"ret\":\"16#0000\"", "\"ret\":\"16#0000\"", "\"ret\":\"16#80A0\"", NULL));
    CHECK(test_count(log, "\"start\"") == 0); /* [DINT-14] */
    free(log);
}

/* [DINT-03, DINT-07, DINT-18] */
static void delay(void)
{
    char *log = test_run(CPU "ob 1 run 1 {\nSRT_DINT 20 2s 16#0001\nbusy 1500ms\n"
                             "SRT_DINT 20 1s 16#0002\nset_clock +1h\nQRY_DINT 20\n}\n",
                         0);
    CHECK(test_in_order(log, "16#0001", "06:59:31.500\",\"ob\":20,\"ret\":\"16#0000\",\"status\":"
                                        "\"16#0014\"",
                        "\"start\",\"at\":\"2026-11-21T06:59:32.500\",\"ob\":20,\"info\":"
                        "{\"priority\":3,\"strt_info\":\"16#21\",\"sign\":\"16#0002\","
                        "\"dtime\":1000,\"time\":\"2026-11-21T06:59:32.500\"",
                        "\"end\"", NULL));
    CHECK(test_count(log, ":\"start\"") == 1);
    free(log);
}

/* AMB-11: a request that waits is not cancelled, and there is no job any more. */
static void pending(void)
{
    char *log = test_run(CPU "ob 1 run 1 {\nSRT_DINT 20 100ms 16#0001\nSRT_DINT 21 100ms 16#0002\n"
                             "DIS_AIRT\nbusy 100ms\nQRY_DINT 20\nCAN_DINT 20\nEN_AIRT\n}\n",
                         0);
    CHECK(test_in_order(log, "DIS_AIRT", "\"status\":\"16#0010\"", "16#80A0", "EN_AIRT",
                        "\"start\",\"at\":\"2026-11-21T05:59:30.100\",\"ob\":21", "\"end\"",
                        "\"start\",\"at\":\"2026-11-21T05:59:30.100\",\"ob\":20", NULL));
    free(log);
}

/* [DINT-08, DINT-10]: started again from inside its own OB, which runs longer. */
static void overlap(void)
{
    const char *body = "ob 1 run 1 {\nSRT_DINT 20 10ms 16#0001\n}\n"
                       "ob 20 run 1 {\nSRT_DINT 20 20ms 16#ABCD\nbusy 50ms\n}\n";
    char text[400];
    test_join(text, sizeof text, CPU, body);
    char *log = test_run(text, 0);
    CHECK(test_in_order(log, "30.010\",\"ob\":20,\"info\"",
                        "30.030\",\"ob\":80,\"info\":{\"priority\":26,\"flt_id\":\"16#02\","
                        "\"error_info\":\"16#ABCD\",\"ev\":\"16#1121\",\"ev_ob\":20",
                        "\"end\",\"at\":\"2026-11-21T05:59:30.060\",\"ob\":20",
                        "30.060\",\"ob\":20,\"info\":{\"priority\":3,\"strt_info\":\"16#21\","
                        "\"sign\":\"16#ABCD\",\"dtime\":20",
                        NULL));
    free(log);
    test_join(text, sizeof text, CPU "at +1ms delete 80\n", body);
    log = test_run(text, 0);
    CHECK(test_in_order(log, "\"start\"", "\"stop\",\"at\":\"2026-11-21T05:59:30.030\",\"cause\":"
                                          "\"16#4568\"",
                        NULL));
    free(log);
}

static void missing(void)
{
    char *log = test_run(CPU "ob 1 run 1 {\nSRT_DINT 22 10ms 16#0001\nQRY_DINT 22\n}\n", 0);
    CHECK(test_in_order(log, "\"ret\":\"16#0000\"", "\"status\":\"16#0004\"",
                        "30.010\",\"ob\":85,\"info\":{\"priority\":25,\"flt_id\":\"16#A2\","
                        "\"ev\":\"16#1123\",\"ev_ob\":1",
                        NULL)); /* AMB-06: when it is to be called */
    free(log);
}

/* [DINT-11]: waits for RUN; [DINT-13]: a restart discards; jobs of the startup OB last. */
static void startup(void)
{
    char *log = test_run(CPU "at +1s restart warm\nat +10s restart cold\n"
                             "ob 1 run 1 {\nSRT_DINT 21 30s 16#0009\n}\n"
                             "ob 100 {\nQRY_DINT 21\nSRT_DINT 20 100ms 16#0001\nQRY_DINT 20\n"
                             "busy 1s\nQRY_DINT 20\n}\n",
                         0);
    CHECK(test_in_order(log, "\"warm\"", "\"ob\":100", "\"status\":\"16#0011\"", "SRT_DINT",
                        "\"status\":\"16#0015\"", "\"status\":\"16#0011\"", "\"end\"", "\"run\"",
                        "\"start\",\"at\":\"2026-11-21T05:59:32.000\",\"ob\":20,\"info\":"
                        "{\"priority\":3,\"strt_info\":\"16#21\",\"sign\":\"16#0001\",\"dtime\":100,"
                        "\"time\":\"2026-11-21T05:59:31.100\"",
                        "\"cold\"", NULL));
    CHECK(test_count(log, ":\"start\"") == 3); /* OB 100, 20, 102 */
    CHECK(test_count(log, "\"ob\":21,\"info\"") == 0);
    free(log);
}

/* [DINT-19] */
static void hold(void)
{
    char *log = test_run(CPU "ob 1 run 1 {\nSRT_DINT 20 10s 16#0001\n}\nat +4s hold\n"
                             "at +30s release\n",
                         0);
    CHECK(test_in_order(log, "\"hold\"", "\"release\"", "06:00:06.000\",\"ob\":20,\"info\"", NULL));
    free(log);
}

void test_dint(void)
{
    return_values();
    delay();
    pending();
    overlap();
    missing();
    startup();
    hold();
}

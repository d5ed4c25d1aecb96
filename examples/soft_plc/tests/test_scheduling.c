/* Classes, order, delays, overlap and missing OBs. */
#include <stdlib.h>

#include "test.h"

static void priority(void)
{
    char *log = test_run("at +1s interrupt 35\nat +1100ms interrupt 40\nat +1200ms interrupt 35\n"
                         "ob 35 {\nbusy 500ms\n}\nob 40 {\nbusy 10ms\n}\n",
                         0);
    CHECK(test_in_order(log, "\"interrupt\"", "\"start\",\"at\":\"2026-11-21T05:59:31.000\",\"ob\":35",
                        "\"interrupt\"", "\"start\",\"at\":\"2026-11-21T05:59:31.100\",\"ob\":40",
                        "\"end\",\"at\":\"2026-11-21T05:59:31.110\",\"ob\":40", "\"interrupt\"",
                        "\"end\",\"at\":\"2026-11-21T05:59:31.510\",\"ob\":35",
                        "\"start\",\"at\":\"2026-11-21T05:59:31.510\",\"ob\":35",
                        "\"end\",\"at\":\"2026-11-21T05:59:32.010\",\"ob\":35", NULL));
    free(log);
}

/* AIRT-02, AIRT-08: kept, then the highest class first. */
static void delayed(void)
{
    char *log = test_run("at +1s interrupt 35\nat +2s interrupt 40\n"
                         "ob 1 run 1 {\nDIS_AIRT\nDIS_AIRT\nbusy 3s\nEN_AIRT\nbusy 1s\nEN_AIRT\n"
                         "QRY_TINT 10\n}\n",
                         0);
    CHECK(test_in_order(log, "\"interrupt\"", "\"interrupt\"", "16#0001", "16#0000",
                        "05:59:34.000\",\"ob\":40", "\"end\"", "05:59:34.000\",\"ob\":35", "\"end\"",
                        "QRY_TINT", NULL));
    free(log);
    /* AIRT-04: the end of the OB ends the delay as well. */
    log = test_run("at +1s interrupt 35\nat +1001ms interrupt 40\n"
                   "ob 35 {\nDIS_AIRT\nDIS_AIRT\nbusy 50ms\n}\n",
                   0);
    CHECK(test_in_order(log, "\"end\",\"at\":\"2026-11-21T05:59:31.050\",\"ob\":35",
                        "\"start\",\"at\":\"2026-11-21T05:59:31.050\",\"ob\":40", NULL));
    free(log);
}

/* [TINT-14, TINT-15] */
static void overlap(void)
{
    const char *text = "step7 10 minute 2026-11-21T00:00 active\nob 10 run 1 {\nbusy 70s\n}\n"
                       "ob 80 {\nbusy 20ms\n}\n";
    char *log = test_run(text, 0);
    CHECK(test_in_order(log, "06:00:00.000\",\"ob\":10", "06:01:00.000\",\"ob\":80",
                        "06:01:00.020\",\"ob\":80", "\"end\",\"at\":\"2026-11-21T06:01:10.020\",\"ob\":10",
                        "\"start\",\"at\":\"2026-11-21T06:01:10.020\",\"ob\":10", NULL));
    CHECK(test_count(log, "\"flt_id\":\"16#02\",\"error_info\":\"16#0201\",\"ev\":\"16#1111\","
                          "\"ev_ob\":10") == 1);
    free(log);
    log = test_run("cpu S7-300\nobs 1 10 85\nclock 2026-11-21T05:59:30\nmode RUN\nduration 5min\n"
                   "step7 10 minute 2026-11-21T00:00 active\nob 10 {\nbusy 70s\n}\n",
                   0);
    CHECK(test_in_order(log, "\"start\"", "\"stop\",\"at\":\"2026-11-21T06:01:00.000\",\"cause\":"
                                          "\"16#4568\"",
                        NULL));
    CHECK(test_count(log, "\n") == 4 && test_in_order(log, "\"stop\"", "\"done\"", NULL)); /* nothing runs after the STOP */
    free(log);
}

static void missing(void)
{
    char *log = test_run("step7 12 minute 2026-11-21T00:00 active\nob 1 run 1 {\nDIS_AIRT\n"
                         "busy 40s\nEN_AIRT\n}\n",
                         0);
    /* AMB-44: when it would be called */
    CHECK(test_in_order(log, "EN_AIRT", "06:00:10.000\",\"ob\":85,\"info\":{\"priority\":25,"
                                        "\"flt_id\":\"16#A2\",\"ev\":\"16#1113\",\"ev_ob\":1",
                        "\"end\"", "06:01:00.000\",\"ob\":85", NULL));
    free(log);
    log = test_run("at +10s delete 85\nstep7 12 minute 2026-11-21T00:00 active\n", 0);
    CHECK(test_in_order(log, "\"delete\"", "06:00:00.000\",\"cause\":\"16#456D\"", NULL));
    free(log);
    log = test_run("at +10s interrupt 87\nat +11s interrupt 82\n", 0); /* [OBS-23] */
    CHECK(test_in_order(log, "\"ob\":87}", "\"ob\":82}", "\"stop\"", NULL));
    free(log);
}

static void overflow(void)
{
    char *log = test_run("buffer 2\nat +1s interrupt 35\nat +1001ms interrupt 35\n"
                         "at +1002ms interrupt 35\nob 35 {\nbusy 50ms\n}\n",
                         0);
    CHECK(test_count(log, "\"ob\":80,\"info\":{\"priority\":28,\"flt_id\":\"16#07\"") == 1);
    CHECK(test_count(log, ":\"start\"") == 3);
    free(log);
}

/* [OBS-02, OBS-05]: OBs of one class, in the order of their events; then above another. */
static void shared_class(void)
{
    char *log = test_run("priority 10 20\npriority 35 20\npriority 40 20\n"
                         "step7 10 minute 2026-11-21T00:00 active\nob 40 {\nbusy 2s\n}\n"
                         "at +29s interrupt 40\nat +29500ms interrupt 35\n",
                         0);
    CHECK(test_in_order(log, "\"priority\":{\"10\":20,\"35\":20,\"40\":20}", "\"ob\":40,\"info\"",
                        "\"end\"", "06:00:01.000\",\"ob\":35,\"info\":{\"priority\":20", "\"end\"",
                        "06:00:01.000\",\"ob\":10,\"info\":{\"priority\":20", NULL));
    free(log);
    log = test_run("priority 35 17\nat +1s interrupt 40\nat +2s interrupt 35\n"
                   "ob 40 {\nbusy 5s\n}\n",
                   0);
    CHECK(test_in_order(log, "\"ob\":40,\"info\"", "05:59:32.000\",\"ob\":35,\"info\"", "\"end\"",
                        "05:59:36.000\",\"ob\":40}", NULL));
    free(log);
}

/* AMB-67: kept until RUN, the reaction to a missing OB as well. AMB-75: nothing for OB 70, 84. */
static void in_hold(void)
{
    char *log = test_run("at +1s hold\nat +2s interrupt 35\nat +3s interrupt 83\n"
                         "at +3s interrupt 70\nat +3s interrupt 84\nat +4s release\n",
                         0);
    CHECK(test_in_order(log, "\"interrupt\"", "\"interrupt\"", "\"release\"",
                        "\"stop\",\"at\":\"2026-11-21T05:59:34.000\"}", NULL));
    CHECK(test_count(log, "\"stop\"") == 1);
    free(log);
    log = test_run("at +1s interrupt 70\nat +2s interrupt 84\nat +3s interrupt 57\n", 0);
    CHECK(test_count(log, ":\"start\"") == 1 && test_count(log, "\"stop\"") == 0);
    CHECK(test_in_order(log, "\"ob\":57}", "\"ob\":85,\"info\":{\"priority\":25,\"flt_id\":\"16#A1\"",
                        NULL));
    free(log);
}

static void cycles(void)
{
    char *log = test_run("log_cycle on\ncycle_time 1min\n", 0);
    CHECK(test_in_order(log, "\"cycle\":true", "06:00:30.000\",\"ob\":1}",
                        "\"start\",\"at\":\"2026-11-21T06:00:30.000\",\"ob\":1", "\"end\"", NULL));
    free(log);
}

void test_scheduling(void)
{
    priority();
    delayed();
    overlap();
    missing();
    overflow();
    shared_class();
    in_hold();
    cycles();
}

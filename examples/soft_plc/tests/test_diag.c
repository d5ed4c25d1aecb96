/* Entries of the diagnostic buffer. */
#include <stdlib.h>

#include "test.h"

#define CPU \
    "cpu S7-300\nobs 1 10 20 35 80 85 100\nclock 2026-11-21T05:59:30\nmode RUN\nduration 10min\n" \
    "log_diag on\n"

static void errors(void)
{
    char *log = test_run(CPU "step7 10 minute 2026-11-21T00:00 active\n"
                             "step7 11 once 2026-11-21T06:05 active\n"
                             "ob 10 run 1 {\nbusy 70s\n}\nat +2min10s clock +2min\n"
                             "at +3min hold\nat +4min10s release\n"
                             "at +5min interrupt 80 16#0B\nat +6min interrupt 85 16#A3\n"
                             "at +7min interrupt 85 16#B1\n",
                         0);
    CHECK(test_in_order(log, "\"records\":[\"call\",\"ob\",\"clock\",\"mode\",\"interrupt\",\"load\","
                             "\"diag\"]",
                        "\"diag\",\"at\":\"2026-11-21T06:01:00.000\",\"id\":\"16#3502\",\"ob\":80,"
                        "\"priority\":26,\"info\":{\"priority\":26,\"flt_id\":\"16#02\","
                        "\"error_info\":\"16#0201\",\"ev\":\"16#1111\",\"ev_ob\":10,\"time\":",
                        "\"ob\":80,\"info\"", "16#3505", "\"ob\":80,\"info\"", "\"release\"", "16#3506",
                        "16#350B", "16#35A3", "\"end\"", NULL));
    CHECK(test_count(log, "16#35A2") == 1); /* OB 11 */
    CHECK(test_count(log, "\"diag\"") == 1 + 6);
    CHECK(test_count(log, "csg_ob") == 0); /* of an S7-1500 alone */
    free(log);
}

static void stops(void)
{
    char *log = test_run(CPU "at +1s delete 80\nat +2s interrupt 80 16#01\n", 0);
    CHECK(test_in_order(log, "\"interrupt\"", "16#3501", "\"id\":\"16#4568\"}", "\"cause\":\"16#4568\"",
                        NULL));
    free(log);
    log = test_run(CPU "at +1s delete 85\nat +2s interrupt 40\n", 0);
    CHECK(test_in_order(log, "\"interrupt\"", "16#35A1", "\"id\":\"16#456D\"}", "\"cause\":\"16#456D\"",
                        NULL));
    free(log);
}

/* [IRT-06 to IRT-09], AMB-21, AMB-41 */
static void suppressed(void)
{
    const char *text = CPU "ob 1 run 1 {\nDIS_IRT 16#82 80\nDIS_IRT 16#82 80\nDIS_IRT 16#82 1\n"
                           "busy 2s\nDIS_IRT 16#02 80\nbusy 2s\nDIS_IRT 16#82 80\nEN_IRT 16#02 80\n"
                           "busy 2s\n}\nat +1s interrupt 80 16#01\nat +3s interrupt 80 16#03\n"
                           "at +5s interrupt 80 16#08\n";
    char *log = test_run(text, 0);
    CHECK(test_in_order(log, "DIS_IRT", "\"id\":\"16#5380\"}", "DIS_IRT", "16#5380", "16#8090",
                        "\"interrupt\"", "DIS_IRT", "\"interrupt\"", "16#3503", "DIS_IRT", "16#5380",
                        "EN_IRT", "\"interrupt\"", "16#3508", "\"ob\":80,\"info\"", NULL));
    CHECK(test_count(log, "16#5380") == 3);
    CHECK(test_count(log, "16#3501") == 0);
    CHECK(test_count(log, ":\"start\"") == 1);
    free(log);
    log = test_run(text, FAULT_DIAG_5380_EACH);
    CHECK(test_count(log, "16#5380") == 4);
    free(log);
}

void test_diag(void)
{
    errors();
    stops();
    suppressed();
}

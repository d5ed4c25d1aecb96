/* Return values of SFC 28 to 31, 41 and 42. */
#include <stdlib.h>

#include "test.h"

static void return_values(void)
{
    char *log = test_run("ob 1 run 1 {\n"
                         "SET_TINT 9 2026-11-21T07:00 16#0201\n"
                         "SET_TINT 18 2026-11-21T07:00 16#0201\n"
                         "SET_TINT -1 2026-11-21T07:00 16#0201\n"
                         "SET_TINT 10 2026-02-30T07:00 16#0201\n"
                         "SET_TINT 10 2090-01-01T07:00 16#0201\n"
                         "SET_TINT 10 2026-12-29T07:00 16#1401\n"
                         "SET_TINT 10 2026-12-28T07:00 16#1400\n"
                         "SET_TINT 10 2026-11-21T05:59:59 16#0000\n" /* cut off: past */
                         "ACT_TINT 10\nCAN_TINT 10\nACT_TINT 18\nCAN_TINT 9\nQRY_TINT 99\n"
                         "SET_TINT 10 2026-12-28T07:00 16#1401\nQRY_TINT 10\n"
                         "SET_TINT 17 2026-11-20T07:00 16#1202\nACT_TINT 17\nACT_TINT 17\n"
                         "QRY_TINT 17\nCAN_TINT 17\nCAN_TINT 17\nQRY_TINT 17\n}\n",
                         0);
    CHECK(test_in_order(log, "\"ob\":9,\"sdt\":\"2026-11-21T07:00:00.000\",\"period\":\"16#0201\","
                             "\"ret\":\"16#8090\"",
                        "\"ob\":18,\"sdt\"", "\"ob\":-1,\"sdt\"", "16#8091", "16#8091", "16#8091",
                        "16#8092", "16#80A1", "16#80A0", "16#80A0", "16#8090", "16#8090",
                        "\"QRY_TINT\",\"at\":\"2026-11-21T05:59:30.000\",\"ob\":99,"
                        "\"ret\":\"16#8090\"}",
                        "\"ret\":\"16#0000\"", "\"status\":\"16#0010\"", "\"ret\":\"16#0000\"",
                        "\"ret\":\"16#0000\"", "\"ret\":\"16#0000\"", "\"status\":\"16#0004\"",
                        "\"ret\":\"16#0000\"", "\"ret\":\"16#80A0\"", "\"status\":\"16#0000\"",
                        NULL));
    free(log);
}

/* [TINT-61] a single start that was set in time and is past when it is activated */
static void activated_late(void)
{
    char *log = test_run("ob 1 run 1 {\nSET_TINT 10 2026-11-21T06:00 16#0000\nbusy 40s\n"
                         "ACT_TINT 10\nSET_TINT 11 2026-11-21T06:00 16#0401\nACT_TINT 11\n}\n",
                         0);
    CHECK(test_in_order(log, "SET_TINT", "\"ret\":\"16#80A1\"", "SET_TINT", "\"ret\":\"16#0000\"",
                        NULL));
    free(log);
}

static void delay_count(void)
{
    char *log = test_run("ob 1 run 1 {\nEN_AIRT\nDIS_AIRT\nDIS_AIRT\nDIS_AIRT\nEN_AIRT\nEN_AIRT\n"
                         "EN_AIRT\nEN_AIRT\nDIS_AIRT\n}\nob 1 run 2 {\nEN_AIRT\n}\n",
                         0);
    CHECK(test_in_order(log, "16#8080", "16#0001", "16#0002", "16#0003", "16#0002", "16#0001",
                        "16#0000", "16#8080", "16#0001", "16#8080", NULL)); /* [AIRT-04] */
    free(log);
}

static void deselected(void)
{
    char *log = test_run("step7 12 deselected\nob 1 run 1 {\nQRY_TINT 12\n}\n", 0);
    CHECK(test_count(log, "16#8090") == 1);
    CHECK(test_count(log, "\"12\":{\"deselected\":true}") == 1);
    free(log);
}

void test_calls(void)
{
    return_values();
    activated_late();
    delay_count();
    deselected();
}

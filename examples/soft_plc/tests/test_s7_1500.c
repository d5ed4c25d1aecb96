/* The same program on an S7-400 and on an S7-1500: how often a piece of the log occurs. */
#include <stdio.h>
#include <stdlib.h>

#include "test.h"

#define LOADED "\nobs 1 10 11 20 35 82 100"
#define REST "\nclock 2026-11-21T05:59:30\nmode RUN\nduration 5min\n"
#define EVERY_MINUTE "step7 10 minute 2026-11-21T00:00 active\n"
#define START_80 "\"ob\":80,\"info\""
#define START_10 "\"ob\":10,\"info\""
#define START_20 "\"ob\":20,\"info\""
#define STOPS "\"stop\""

static const struct {
    const char *obs, *text, *piece;
    int s7_400, s7_1500;
} cases[] = {
    /* The clock ahead, by less than 20 s and by more [T15-90, T15-91, T15-100]. */
    {" 80", EVERY_MINUTE "at +20s clock +15s\n", START_80, 1, 0},
    {" 80", EVERY_MINUTE "at +20s clock +15s\n", START_10, 5, 5},
    {" 80", EVERY_MINUTE "at +20s clock +20s\n", START_80, 1, 1},
    {"", EVERY_MINUTE "at +20s clock +15s\n", STOPS, 1, 0},
    {"", EVERY_MINUTE "at +20s clock +1h\n", STOPS, 1, 0},
    {"", EVERY_MINUTE "at +20s clock +1h\n", START_10, 0, 6},
    /* Back [T15-93, T15-94]. */
    {" 80", EVERY_MINUTE "at +35s clock -10s\n", START_10, 5, 5},
    {" 80", EVERY_MINUTE "at +35s clock -25s\n", START_10, 5, 6},
    /* A run that waits over a large step back: its point comes again, also after a small one. */
    {" 80", EVERY_MINUTE "ob 1 run 1 {\nDIS_AIRT\nbusy 35s\nset_clock 2026-11-21T05:59:30\nEN_AIRT\nbusy 5s\n"
                         "set_clock 2026-11-21T05:59:30\n}\n",
     "06:00:00.000\",\"ob\":10,\"info\"", 0, 1},
    /* Overload: OB 80 once, one later run [T15-73, T15-110]. */
    {" 80", EVERY_MINUTE "ob 10 run 1 {\nbusy 185s\n}\n", START_80, 3, 1},
    {" 80", EVERY_MINUTE "ob 10 run 1 {\nbusy 185s\n}\n", START_10, 3, 3},
    {"", EVERY_MINUTE "ob 10 run 1 {\nbusy 185s\n}\n", STOPS, 1, 0},
    {"", "ob 1 run 1 {\nSRT_DINT 20 1s 16#0\n}\n"
         "ob 20 run 1 {\nSRT_DINT 20 50 16#0\nbusy 200ms\n}\n", START_20, 1, 2},
    {" 80", "at +1s interrupt 35\nat +2s interrupt 35\nat +3s interrupt 35\n"
            "ob 1 run 1 {\nDIS_AIRT\nbusy 4s\n}\n", "\"ob\":35,\"info\"", 3, 1},
    /* HOLD [T15-119]. */
    {" 80", EVERY_MINUTE "at +20s hold\nat +50s release\n", "16#06", 1, 1},
    {"", EVERY_MINUTE "at +20s hold\nat +50s release\n", STOPS, 1, 0},
    {"", "at +1s restart warm\nat +2s hold\nat +3s release\nob 100 {\nbusy 5s\n}\n",
     "\"release\"", 0, 1},
    /* Missing OBs [T15-110 to T15-113], A15-13. */
    {"", "at +1s interrupt 86\n", STOPS, 1, 0},
    {"", "at +1s interrupt 40\n", STOPS, 1, 0},
    {"", "at +1s interrupt 122\n", STOPS, 1, 0},
    {"", "at +1s interrupt 121\n", STOPS, 1, 1},
    {"", "at +1s interrupt 80 16#09\n", STOPS, 1, 0},
    {"", "at +1s interrupt 80 16#01\n", STOPS, 1, 1},
    {"", "ob 1 run 1 {\nSRT_DINT 21 1s 16#0\n}\n", "16#8090", 0, 1},
    /* Calls [T15-32, T15-53, T15-58]. */
    {"", "ob 1 run 1 {\nSET_TINT 10 2026-11-21T06:00 16#1202\n}\n", "16#8092", 0, 1},
    {"", "ob 1 run 1 {\nDIS_AIRT\nQRY_TINT 10\n}\n", "\"16#0012\"", 0, 1},
    {"", "ob 1 run 1 {\nDIS_IRT 16#02 10\nQRY_TINT 10\n}\n", "\"16#0012\"", 1, 0},
    {"", "ob 1 run 1 {\nEN_IRT 16#02 85\n}\n", "16#8090", 0, 1},
    /* STARTUP: OB 82 in its own class, OB 80 waits [T15-62, T15-117]. */
    {" 80", "at +1s restart warm\nat +2s interrupt 82\nob 100 {\nbusy 5s\n}\n",
     "05:59:32.000\",\"ob\":82,\"info\":{\"priority\":28", 1, 0},
    {" 80", "at +1s restart warm\nat +2s interrupt 82\nob 100 {\nbusy 5s\n}\n",
     "05:59:32.000\",\"ob\":82,\"info\":{\"priority\":5", 0, 1},
    {" 80", "at +1s restart warm\nat +2s interrupt 80 16#09\nob 100 {\nbusy 5s\n}\n",
     "05:59:32.000\",\"ob\":80,\"info\"", 1, 0},
    {" 80", "at +1s restart warm\nat +2s interrupt 80 16#09\nob 100 {\nbusy 5s\n}\n",
     "05:59:36.000\",\"ob\":80,\"info\":{\"priority\":22", 0, 1},
    /* OB 121 in a class of its own [T15-63]. */
    {" 121", "at +1s interrupt 121\n", "\"ob\":121,\"info\":{\"priority\":7", 0, 1},
    /* Points of STEP 7 that passed in STOP: A15-12. */
    {" 80", "step7 10 once 2026-11-21T05:00 active\nat +1s restart warm\n", START_10, 1, 0},
    {" 80", "step7 10 end_of_month 2026-12-31T06:00 active\nat +1s clock 2026-11-30T05:59:30\n",
     START_10, 0, 1},
};

static char *run(const char *cpu, unsigned i)
{
    char text[500], whole[800];
    test_join(text, sizeof text, cpu, LOADED);
    test_join(whole, sizeof whole, text, cases[i].obs);
    test_join(text, sizeof text, whole, REST);
    test_join(whole, sizeof whole, text, cases[i].text);
    return test_run(whole, FAULT_NONE);
}

/* A catch-up of class 24 comes behind OB 80, which may take it back [T15-91]. */
static void behind_ob_80(void)
{
    char *log = test_run("cpu S7-1500\nobs 1 10 80\npriority 10 24" REST EVERY_MINUTE
                         "at +20s clock +1h\nob 80 {\nbusy 1s\n}\n", FAULT_NONE);
    CHECK(test_in_order(log, "\"clock\"", START_80, "\"end\"", START_10, NULL));
    free(log);
    log = test_run("cpu S7-1500\nobs 1 10 80\npriority 10 24" REST EVERY_MINUTE
                   "at +20s clock +1h\nob 80 {\nbusy 1s\nCAN_TINT 10\n}\n", FAULT_NONE);
    CHECK(test_count(log, START_10) == 0);
    free(log);
}

/* SET_TINTL, and local time an hour ahead [T15-08, T15-09, T15-20, T15-21, T15-141, T15-144]: OB 10
 * starts at this time, or its call answers this. */
static void local_time(void)
{
    static const char *const logs[][2] = {
        {"SET_TINTL 10 2026-11-21T07:01 16#0201 local activate", "06:01:00.000\",\"ob\":10,\"info\""},
        {"SET_TINTL 10 2026-11-21T06:01 16#0000 activate", "06:01:00.000\",\"ob\":10,\"info\""},
        {"SET_TINTL 10 2026-11-22T00:00 16#2001 local activate\nset_clock 2026-11-29T22:59:50",
         "23:00:00.000\",\"ob\":10,\"info\""},
        {"SET_TINTL 10 2026-11-21T06:01 16#0000 local activate", "\"16#80A1\""},
        {"SET_TINTL 10 2026-11-31T07:01 16#0201 local", "\"16#8091\""},
        {"SET_TINTL 20 2026-11-21T07:01 16#0201 local", "\"16#8090\""},
        {"SET_TINTL 10 2026-11-21T07:01 16#1202 local", "\"16#8092\""},
        {"SET_TINTL 10 2026-11-21T07:01 16#0201 local activate\nQRY_TINT 10", "\"16#0054\""},
        {"SET_TINTL 10 2026-11-21T07:01 16#0201\nQRY_TINT 10", "\"16#0010\""},
        {"SET_TINT 10 2026-11-21T06:01 16#0000\nACT_TINT 10", "06:01:00.000\",\"ob\":10,\"info\""},
    };
    for (unsigned i = 0; i < sizeof logs / sizeof logs[0]; i++) {
        char text[500], whole[600];
        test_join(text, sizeof text, "cpu S7-1500\nzone 60" LOADED " 80" REST "ob 1 run 1 {\n", logs[i][0]);
        test_join(whole, sizeof whole, text, "\n}\n");
        char *log = test_run(whole, FAULT_NONE);
        if (test_count(log, logs[i][1]) == 0)
            fprintf(stderr, "%s: %s\n%s", logs[i][0], logs[i][1], log);
        CHECK(test_count(log, logs[i][1]) > 0);
        free(log);
    }
    char *log = test_run("cpu S7-1500\nzone -30" LOADED REST
                         "step7 10 daily 2026-11-01T05:31 active local\n", FAULT_NONE);
    CHECK(test_count(log, "06:01:00.000\",\"ob\":10,\"info\"") == 1);
    free(log);
}

/* Local time is set in the night of 2027-03-28 [T15-96 to T15-99, T15-103]: 02:30 is skipped, or comes
 * again. How often OB 10 and OB 80 start, and a piece of the log that is there so often. */
static void zone_changes(void)
{
#define AT_NIGHT "cpu S7-1500\nobs 1 10 80 100\nclock 2027-03-28T00:50:00\nmode RUN\nduration 3h\nzone 60\nchoose T15-130=old\n"
#define LOCAL "step7 10 daily 2026-11-01T02:30 active local\n"
#define CAUGHT_UP "\"caught_up\":true,\"second_time\":false"
#define SECOND "\"caught_up\":false,\"second_time\":true"
    static const struct {
        const char *text;
        int runs, errors;
        const char *piece;
        int times;
    } table[] = {
        {LOCAL, 1, 0, "01:30:00.000\"," START_10, 1},
        {LOCAL "at 10min zone 120 daylight\n", 1, 0, "01:00:00.000\",\"ob\":10,\"info\":{" CAUGHT_UP, 1},
        {LOCAL "ob 1 run 1 {\nbusy 10min\nset_zone 120 zone\n}\n", 1, 0, CAUGHT_UP, 1},
        {LOCAL "at 10min zone 90 daylight\n", 1, 0, "01:00:00.000\",\"ob\":10,\"info\":{\"caught_up\":false", 1},
        {LOCAL "at 70min zone 0 daylight\n", 2, 0, "02:30:00.000\",\"ob\":10,\"info\":{" SECOND, 1},
        {LOCAL "at 70min zone 0 zone\n", 2, 0, SECOND, 1},
        {LOCAL "at 10min zone 0 zone\n", 1, 0, SECOND, 0},
        {"step7 10 daily 2026-11-01T01:30 active\nat 10min zone 120 daylight\nat 70min zone 0 zone\n", 1, 0,
         "\"caught_up\":false,\"second_time\":false", 1},
        {LOCAL "at 5min hold\nat 10min zone 120 daylight\nat 15min release\n", 1, 1, CAUGHT_UP, 0},
        {LOCAL "at 5min stop\nat 10min zone 120 daylight\nat 15min restart warm\n", 0, 0, "\"reason\":\"daylight\"", 1},
        {"ob 1 run 1 {\nset_zone 120 zone\nSET_TINTL 10 2027-03-28T02:55 16#1001 local activate\n}\n", 1, 0,
         "00:55:00.000\"," START_10, 1},
    };
    for (unsigned i = 0; i < sizeof table / sizeof table[0]; i++) {
        char text[600];
        test_join(text, sizeof text, AT_NIGHT, table[i].text);
        char *log = test_run(text, FAULT_NONE);
        bool shows = test_count(log, START_10) == table[i].runs && test_count(log, START_80) == table[i].errors &&
                     test_count(log, table[i].piece) == table[i].times;
        if (!shows)
            fprintf(stderr, "%s\n%s", table[i].text, log);
        CHECK(shows);
        free(log);
    }
}

/* Tags of the clock: CaughtUp and SecondTime, which the first repeated run alone has (A15-18), no run
 * before. [T15-90, T15-91, T15-94, T15-119, T15-131, T15-132]. */
static void tags_of_the_clock(void)
{
    static const struct {
        const char *text, *piece;
        int times;
    } table[] = {
        {"at +20s clock +15s\n", CAUGHT_UP, 1},
        {"at +20s clock +1h\n", CAUGHT_UP, 1},
        {"at +20s clock +1h\n", "\"ob\":80,\"info\":{\"flt_id\":\"16#05\",\"csg_ob\":1,\"csg_priority\":\"16#01\"}", 1},
        {"at +20s hold\nat +50s release\n", "\"caught_up\":true", 0},
        {"at +35s clock -10s\n", "\"second_time\":true", 0},
        {"at +125s clock -100s\n", SECOND, 1},
        {"at +125s clock -100s\nat +215s clock -100s\n", SECOND, 2},
        {"at +20s clock -100s\n", SECOND, 0},
        {"at +125s clock -100s\nat +126s clock +95s\n", "\"caught_up\":true,\"second_time\":true", 1},
    };
    for (unsigned i = 0; i < sizeof table / sizeof table[0]; i++) {
        char text[600];
        test_join(text, sizeof text, "cpu S7-1500\nchoose T15-130=old" LOADED " 80" REST EVERY_MINUTE, table[i].text);
        char *log = test_run(text, FAULT_NONE);
        if (test_count(log, table[i].piece) != table[i].times)
            fprintf(stderr, "%s\n%s", table[i].text, log);
        CHECK(test_count(log, table[i].piece) == table[i].times);
        free(log);
    }
}

#define MORE                                                                                       \
    "cpu S7-1500\nclass 300 startup\nclass 124 startup\nclass 32767 cycle\nclass 123 tod\n"          \
    "class 500 dint\nclass 200 cyclic\nclass 201 hardware\npriority 200 9\n"                        \
    "obs 1 80 100 300 124 32767 123 500 200 201" REST
#define FROM(ob) "\"ob\":" #ob ",\"info\""
#define OF_20_BYTES "choose T15-130=old\n"

/* OBs from 123 on [T15-10, T15-11, T15-79, T15-116, T15-132, T15-133], A15-21. */
static void created(void)
{
    char *log = test_run(MORE "log_cycle on\nat +1s restart warm\nob 124 {\nbusy 1s\n}\nat 1500ms interrupt 201\n"
                         "ob 32767 {\nbusy 2s\n}\n", FAULT_NONE);
    CHECK(test_in_order(log, "\"restart\"", FROM(100), FROM(124), "\"interrupt\"", FROM(300), "\"run\"",
                        FROM(201), FROM(1), FROM(32767), FROM(1), FROM(32767), NULL));
    free(log);
    log = test_run(MORE OF_20_BYTES "step7 123 minute 2026-11-21T00:00 active\nat +1s interrupt 200\n"
                   "at +35s clock +1h\nob 32767 run 1 {\nbusy 40s\n}\n"
                   "ob 1 run 1 {\nSRT_DINT 500 100ms 16#7\nQRY_TINT 123\nQRY_TINT 124\nSRT_DINT 128 1s 16#7\n"
                   "DIS_IRT 16#02 201\nEN_IRT 16#02 300\n}\n", FAULT_NONE);
    CHECK(test_count(log, "\"strt_info\":\"16#1F\"") > 3 && test_count(log, "\"strt_info\":\"16#2F\"") == 1);
    CHECK(test_count(log, FROM(200) ":{\"priority\":9,\"strt_info\":\"16#3F\"") == 1);
    CHECK(test_count(log, "\"16#8090\"") == 3 && test_count(log, "\"16#0014\"") == 1);
    CHECK(test_count(log, "\"flt_id\":\"16#05\",\"csg_ob\":32767,\"csg_priority\":\"16#01\"}") == 1);
    free(log);
    log = test_run(MORE "step7 123 minute 2026-11-21T00:00 active\nat +1s interrupt 200\nat +2s interrupt 201\n"
                   "at +35s clock +1h\nob 1 run 1 {\nSRT_DINT 500 100ms 16#7\n}\n", FAULT_NONE);
    CHECK(test_count(log, FROM(123) ":{" CAUGHT_UP "}") == 1);
    CHECK(test_count(log, FROM(500) ":{\"sign\":\"16#0007\"}") == 1);
    CHECK(test_count(log, FROM(200) ":{\"event_count\":\"16#0000\"}") == 1 && test_count(log, FROM(201) ":{}") == 1);
    CHECK(test_count(log, "\"flt_id\":\"16#05\",\"error_info\":\"16#0000\"") == 1);
    free(log);
    log = test_run(MORE "at +1s interrupt 80 16#01\nat +3s interrupt 80 16#01\nob 1 {\nbusy 2s\n}\n"
                   "ob 32767 {\nbusy 2s\n}\n", FAULT_NONE); /* one cycle time for both */
    CHECK(test_count(log, STOPS) == 1);
    free(log);
    log = test_run(MORE "step7 123 minute 2026-11-21T00:00 active\nob 123 run 1 {\nbusy 70s\n}\n", FAULT_NONE);
    CHECK(test_count(log, "\"flt_id\":\"16#02\",\"error_info\":\"16#0201\",\"ev_ob\":123") == 1);
    free(log);
}

#define LONG_35                                                                                    \
    "at +1s interrupt 35\nat +2s interrupt 35\nat +3s interrupt 35\nat +4s interrupt 35\n"         \
    "at +5s interrupt 35\nob 35 run 1 {\nbusy 10s\n}\n"
#define LONG_10 EVERY_MINUTE "ob 10 run 1 {\nbusy 190s\n}\n"

/* Events that come while their OB runs, four of OB 35 and three of OB 10 [T15-27, T15-68 to T15-74], A15-06,
 * A15-07, A15-15: how often the OB starts, OB 80 starts, 3507 is entered. */
static void queues(void)
{
    static const struct {
        const char *text, *piece;
        int runs, errors, entries;
    } table[] = {
        {LONG_35, FROM(35), 2, 0, 0},
        {"queue 35 1\n" LONG_35, FROM(35), 2, 0, 0},
        {"queue 35 3\n" LONG_35, FROM(35), 4, 0, 0},
        {"queue 35 12\n" LONG_35, FROM(35), 5, 0, 0},
        {"queue 35 1 1\n" LONG_35, FROM(35), 2, 1, 0},
        {"queue 35 4 4\n" LONG_35, FROM(35), 5, 1, 0},
        {"queue 35 5 5\n" LONG_35, FROM(35), 5, 0, 0},
        {"queue 35 2 overflow\n" LONG_35, FROM(35), 3, 0, 1},
        {"queue 35 1 1 overflow\n" LONG_35, FROM(35), 2, 1, 1},
        {LONG_10, FROM(10), 3, 1, 0},
        {"queue 10 1\n" LONG_10, FROM(10), 3, 0, 0},
        {"queue 10 2 2\n" LONG_10, FROM(10), 4, 1, 0},
        {"queue 10 3 overflow\n" LONG_10, FROM(10), 5, 0, 0},
        {"queue 10 1 overflow\n" LONG_10, FROM(10), 3, 0, 1},
    };
    for (unsigned i = 0; i < sizeof table / sizeof table[0]; i++) {
        char text[600];
        test_join(text, sizeof text, "cpu S7-1500\nlog_diag on" LOADED " 80" REST, table[i].text);
        char *log = test_run(text, FAULT_NONE);
        bool shows = test_count(log, table[i].piece) == table[i].runs &&
                     test_count(log, START_80) == table[i].errors &&
                     test_count(log, "16#3507") == table[i].entries;
        if (!shows)
            fprintf(stderr, "%s\n%s", table[i].text, log);
        CHECK(shows);
        free(log);
    }
}

/* OB 200 keeps one event and runs for 4 s: those at 3 s and 4 s are discarded, and the event of 7 s, the next
 * new one, has their number [T15-69, T15-70]; a start-up forgets it. */
static void event_count(void)
{
    static const char *const count_2 = "37.000\",\"ob\":200,\"info\":{\"event_count\":\"16#0002\"}";
    char *log = test_run(MORE "at +1s interrupt 200\nat +2s interrupt 200\n"
                         "at +3s interrupt 200\nat +4s interrupt 200\nat +7s interrupt 200\n"
                         "at +8s interrupt 200\nob 200 run 1 {\nbusy 4s\n}\n", FAULT_NONE);
    CHECK(test_count(log, count_2) == 1 && test_count(log, "16#0000\"}") == 3);
    free(log);
    log = test_run(MORE "at +1s interrupt 200\nat +2s interrupt 200\n"
                   "at +3s interrupt 200\nat +4s restart warm\nat +7s interrupt 200\n"
                   "ob 200 run 1 {\nbusy 4s\n}\n", FAULT_NONE);
    CHECK(test_count(log, "37.000\",\"ob\":200,\"info\":{\"event_count\":\"16#0000\"}") == 1);
    free(log);
}

void test_s7_1500(void)
{
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char *old = run("cpu S7-400", i), *new = run("cpu S7-1500", i);
        bool shows = test_count(old, cases[i].piece) == cases[i].s7_400 &&
                     test_count(new, cases[i].piece) == cases[i].s7_1500;
        if (!shows)
            fprintf(stderr, "%s%s: %s, %d %d\n%s---\n%s", cases[i].obs, cases[i].text, cases[i].piece,
                    test_count(old, cases[i].piece), test_count(new, cases[i].piece), old, new);
        CHECK(shows);
        free(old);
        free(new);
    }
    behind_ob_80();
    local_time();
    zone_changes();
    tags_of_the_clock();
    created();
    event_count();
    queues();
}

/* Test of s7log.h on its own, as C99. */
#include <stdlib.h>

#include "s7log.h"

static int checks, failed;
#define CHECK(condition) check((condition), __LINE__, #condition)

static void check(bool ok, int line, const char *text)
{
    checks++;
    if (ok)
        return;
    failed++;
    fprintf(stderr, "s7log_test.c:%d: failed: %s\n", line, text);
}

/* Keeps the last line. */
struct sink {
    char line[S7LOG_LINE + 1];
    int lines;
    bool full;
};

static int take(void *context, const char *line, size_t length)
{
    struct sink *s = context;
    if (s->full)
        return -1;
    memcpy(s->line, line, length);
    s->line[length] = '\0';
    s->lines++;
    return 0;
}

static const struct s7log_now now = {0, S7LOG_NONE};
#define AT "\"at\":\"1990-01-01T00:00:00.000\""

static struct s7log_header simple_header(void)
{
    static const int obs[] = {1};
    struct s7log_header h;
    memset(&h, 0, sizeof h);
    h.obs = obs;
    h.ob_count = 1;
    h.records = S7LOG_CALL | S7LOG_DIAG;
    return h;
}

static void begin(struct s7log *l, struct sink *s)
{
    struct s7log_header h = simple_header();
    memset(s, 0, sizeof *s);
    s7log_open(l, take, s);
    CHECK(s7log_header(l, &h) == S7LOG_OK);
}

static void header(void)
{
    static const int obs[] = {1, 10, 122};
    static const struct s7log_priority priorities[] = {{10, 23}, {85, 24}};
    static const struct s7log_tod tods[] = {{10, S7LOG_DAILY, 0, true, false, true},
                                            {17, S7LOG_NOT_GIVEN, S7LOG_NONE, false, true, false}};
    static const struct s7log_class classes[] = {{123, S7LOG_CLASS_CYCLE}};
    static const struct s7log_queue queues[] = {{10, 12, 1, 1}, {40, 1, 0, S7LOG_NONE}};
    static const struct s7log_reading readings[] = {{"AMB-02", 'a'}, {"AMB-77", 'd'}};
    struct s7log_header h = {S7LOG_CPU_318, obs, 3, 1500, S7LOG_RUN, 20, 255, true, priorities, 2,
                             tods, 2, readings, 2, classes, 1, queues, 2, -90};
    struct s7log l;
    struct sink s;
    memset(&s, 0, sizeof s);
    s7log_open(&l, take, &s);
    CHECK(s7log_run(&l, now) == S7LOG_ORDER);
    CHECK(s7log_header(&l, &h) == S7LOG_OK);
    CHECK(strcmp(s.line,
                 "{\"format\":\"s7-interrupt-log/1\",\"cpu\":\"CPU 318\",\"obs\":[1,10,122],"
                 "\"clock\":\"1990-01-01T00:00:01.500\",\"mode\":\"RUN\",\"latency_ms\":20,"
                 "\"records\":[\"call\",\"ob\",\"clock\",\"mode\",\"interrupt\",\"load\",\"diag\","
                 "\"state\"],"
                 "\"cycle\":true,\"classes\":{\"123\":\"cycle\"},"
                 "\"queue\":{\"10\":{\"events\":12,\"threshold\":1,\"overflow\":true},"
                 "\"40\":{\"events\":1}},\"zone\":-90,\"priority\":{\"10\":23,\"85\":24},\"step7\":{\"tod\":{"
                 "\"10\":{\"execution\":\"daily\",\"active\":true,\"start\":"
                 "\"1990-01-01T00:00:00.000\",\"local\":true},\"17\":{\"deselected\":true}}},"
                 "\"readings\":{\"AMB-02\":\"a\",\"AMB-77\":\"d\"}}\n") == 0);
    CHECK(s7log_header(&l, &h) == S7LOG_ORDER);
    CHECK(s.lines == 1 && l.events == 0);
}

static void header_ranges(void)
{
    static const struct s7log_priority wrong[] = {{10, 24}, {80, 20}, {85, 23}, {1, 2}, {87, 27}};
    struct s7log l;
    struct sink s;
    memset(&s, 0, sizeof s);
    s7log_open(&l, take, &s);
    struct s7log_header h = simple_header();
    h.priority_count = 1;
    h.cpu = S7LOG_S7_400;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        h.priorities = &wrong[i];
        CHECK(s7log_header(&l, &h) == S7LOG_RANGE);
    }
    h = simple_header();
    h.clock = S7LOG_AT_MAX + 1;
    CHECK(s7log_header(&l, &h) == S7LOG_RANGE);
    h.clock = 0;
    h.latency_ms = -1;
    CHECK(s7log_header(&l, &h) == S7LOG_RANGE);
    h.latency_ms = 0;
    h.records = 256;
    CHECK(s7log_header(&l, &h) == S7LOG_RANGE);
    h.records = 0;
    CHECK(s7log_header(&l, &h) == S7LOG_OK && strstr(s.line, "\"records\":[]") != NULL);
    CHECK(s.lines == 1);
}

/* A15- is of an S7-1500 alone, with more letters. */
static void readings(void)
{
    static const struct {
        struct s7log_reading reading;
        enum s7log_cpu cpu;
        enum s7log_result result;
    } table[] = {
        {{"AMB-02", 'd'}, S7LOG_S7_1500, S7LOG_OK},    {{"AMB-02", 'e'}, S7LOG_S7_1500, S7LOG_RANGE},
        {{"A15-18", 'f'}, S7LOG_S7_1500, S7LOG_OK},    {{"A15-18", 'g'}, S7LOG_S7_1500, S7LOG_RANGE},
        {{"A15-18", 'a'}, S7LOG_S7_400, S7LOG_RANGE},  {{"T15-18", 'a'}, S7LOG_S7_1500, S7LOG_RANGE},
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        struct s7log l;
        struct sink s;
        struct s7log_header h = simple_header();
        h.cpu = table[i].cpu;
        h.readings = &table[i].reading;
        h.reading_count = 1;
        s7log_open(&l, take, &s);
        CHECK(s7log_header(&l, &h) == table[i].result);
    }
}

static void events(void)
{
    struct s7log l;
    struct sink s;
    struct s7log_info info = S7LOG_INFO_NONE;
    const struct s7log_now later = {S7LOG_AT_MAX, 17};
    const struct s7log_dt sdt = {2090, 2, 30, 24, 0, 0, 7};
    begin(&l, &s);
#define LINE(call, text)                                                                           \
    CHECK((call) == S7LOG_OK);                                                                     \
    CHECK(strcmp(s.line, "{\"event\":" text "}\n") == 0)
    LINE(s7log_set_tint(&l, later, -1, &sdt, 0x0201, 0x8091),
         "\"SET_TINT\",\"at\":\"2089-12-31T23:59:59.999\",\"up\":17,\"ob\":-1,"
         "\"sdt\":\"2090-02-30T24:00:00.007\",\"period\":\"16#0201\",\"ret\":\"16#8091\"");
    LINE(s7log_set_tintl(&l, now, 10, &sdt, true, 0, false, 0x8091),
         "\"SET_TINTL\"," AT ",\"ob\":10,\"sdt\":\"2090-02-30T24:00:00.007\",\"local\":true,"
         "\"period\":\"16#0000\",\"activate\":false,\"ret\":\"16#8091\"");
    LINE(s7log_can_tint(&l, now, 10, 0), "\"CAN_TINT\"," AT ",\"ob\":10,\"ret\":\"16#0000\"");
    LINE(s7log_act_tint(&l, now, 10, S7LOG_NONE), "\"ACT_TINT\"," AT ",\"ob\":10,\"ret\":null");
    LINE(s7log_qry_tint(&l, now, 10, 0, 0x14),
         "\"QRY_TINT\"," AT ",\"ob\":10,\"ret\":\"16#0000\",\"status\":\"16#0014\"");
    LINE(s7log_srt_dint(&l, now, 20, INT32_MIN, 0xFFFF, -32623),
         "\"SRT_DINT\"," AT ",\"ob\":20,\"dtime\":-2147483648,\"sign\":\"16#FFFF\","
         "\"ret\":\"16#8091\"");
    LINE(s7log_can_dint(&l, now, 20, 0x80A0), "\"CAN_DINT\"," AT ",\"ob\":20,\"ret\":\"16#80A0\"");
    LINE(s7log_qry_dint(&l, now, 99, 0x8090, S7LOG_NONE),
         "\"QRY_DINT\"," AT ",\"ob\":99,\"ret\":\"16#8090\"");
    LINE(s7log_dis_irt(&l, now, 0x80, 0, 0),
         "\"DIS_IRT\"," AT ",\"mode\":\"16#80\",\"ob\":0,\"ret\":\"16#0000\"");
    LINE(s7log_en_irt(&l, now, 2, 35, 0),
         "\"EN_IRT\"," AT ",\"mode\":\"16#02\",\"ob\":35,\"ret\":\"16#0000\"");
    LINE(s7log_dis_airt(&l, now, 1), "\"DIS_AIRT\"," AT ",\"ret\":\"16#0001\"");
    LINE(s7log_en_airt(&l, now, 0x8080), "\"EN_AIRT\"," AT ",\"ret\":\"16#8080\"");
    LINE(s7log_start(&l, now, 10, NULL), "\"start\"," AT ",\"ob\":10");
    LINE(s7log_start(&l, now, 10, &info), "\"start\"," AT ",\"ob\":10,\"info\":{}");
    info.sign = 0;
    info.dtime = 60000;
    LINE(s7log_start(&l, now, 20, &info),
         "\"start\"," AT ",\"ob\":20,\"info\":{\"sign\":\"16#0000\",\"dtime\":60000}");
    const struct s7log_info all = {26, 0x11, 2, 0x0201, 7, 1, 3, 0x1111, 10, 1, 1, 0, 32767, 24, 3};
    LINE(s7log_start(&l, now, 80, &all),
         "\"start\"," AT ",\"ob\":80,\"info\":{\"priority\":26,\"strt_info\":\"16#11\","
         "\"flt_id\":\"16#02\",\"period\":\"16#0201\",\"sign\":\"16#0007\",\"dtime\":1,"
         "\"error_info\":\"16#0003\",\"ev\":\"16#1111\",\"ev_ob\":10,"
         "\"time\":\"1990-01-01T00:00:00.001\",\"caught_up\":true,\"second_time\":false,"
         "\"csg_ob\":32767,\"csg_priority\":\"16#18\",\"event_count\":\"16#0003\"}");
    LINE(s7log_end(&l, now, 1), "\"end\"," AT ",\"ob\":1");
    LINE(s7log_clock(&l, now, 60000), "\"clock\"," AT ",\"to\":\"1990-01-01T00:01:00.000\"");
    LINE(s7log_zone(&l, now, -720, true), "\"zone\"," AT ",\"zone\":-720,\"reason\":\"daylight\"");
    LINE(s7log_zone(&l, now, 840, false), "\"zone\"," AT ",\"zone\":840,\"reason\":\"zone\"");
    LINE(s7log_restart(&l, now, S7LOG_WARM), "\"restart\"," AT ",\"type\":\"warm\"");
    LINE(s7log_restart(&l, now, S7LOG_COLD), "\"restart\"," AT ",\"type\":\"cold\"");
    LINE(s7log_restart(&l, now, S7LOG_HOT), "\"restart\"," AT ",\"type\":\"hot\"");
    LINE(s7log_run(&l, now), "\"run\"," AT);
    LINE(s7log_stop(&l, now, 0x4568), "\"stop\"," AT ",\"cause\":\"16#4568\"");
    LINE(s7log_stop(&l, now, S7LOG_NONE), "\"stop\"," AT);
    LINE(s7log_hold(&l, now), "\"hold\"," AT);
    LINE(s7log_release(&l, now), "\"release\"," AT);
    LINE(s7log_interrupt(&l, now, 35, S7LOG_NONE), "\"interrupt\"," AT ",\"ob\":35");
    LINE(s7log_interrupt(&l, now, 80, 1), "\"interrupt\"," AT ",\"ob\":80,\"flt_id\":\"16#01\"");
    LINE(s7log_load(&l, now, 10), "\"load\"," AT ",\"ob\":10");
    LINE(s7log_delete(&l, now, 10), "\"delete\"," AT ",\"ob\":10");
    LINE(s7log_diag(&l, now, 0x5380, S7LOG_NONE, S7LOG_NONE, NULL),
         "\"diag\"," AT ",\"id\":\"16#5380\"");
    LINE(s7log_diag(&l, now, 0x3502, 80, 26, &info),
         "\"diag\"," AT ",\"id\":\"16#3502\",\"ob\":80,\"priority\":26,\"info\":{"
         "\"sign\":\"16#0000\",\"dtime\":60000}");
    struct s7log_ob_state state = S7LOG_OB_STATE_NONE;
    LINE(s7log_state(&l, now, 40, &state), "\"state\"," AT ",\"ob\":40");
    state = (struct s7log_ob_state){1, 0, 1, 0, 60000};
    LINE(s7log_state(&l, now, 20, &state),
         "\"state\"," AT ",\"ob\":20,\"active\":true,\"blocked\":false,\"loaded\":true,"
         "\"entries_off\":false,\"left\":60000");
    LINE(s7log_done(&l, now), "\"done\"," AT);
#undef LINE
    CHECK(s7log_run(&l, now) == S7LOG_ORDER && s7log_done(&l, now) == S7LOG_ORDER);
    CHECK(l.events == 37 && s.lines == 38);
}

static void event_ranges(void)
{
    struct s7log l;
    struct sink s;
    struct s7log_info info = S7LOG_INFO_NONE;
    const struct s7log_now before = {-1, S7LOG_NONE}, negative_up = {0, -1};
    const struct s7log_dt five_digits = {10000, 1, 1, 0, 0, 0, 0}, minus = {2026, -1, 1, 0, 0, 0, 0};
    begin(&l, &s);
    CHECK(s7log_run(&l, before) == S7LOG_RANGE);
    CHECK(s7log_run(&l, negative_up) == S7LOG_RANGE);
    CHECK(s7log_clock(&l, now, S7LOG_AT_MAX + 1) == S7LOG_RANGE);
    CHECK(s7log_set_tint(&l, now, 10, &five_digits, 0, 0) == S7LOG_RANGE);
    CHECK(s7log_set_tint(&l, now, 10, &minus, 0, 0) == S7LOG_RANGE);
    CHECK(s7log_can_tint(&l, now, 32768, 0) == S7LOG_RANGE);
    CHECK(s7log_can_tint(&l, now, 10, 65536) == S7LOG_RANGE);
    CHECK(s7log_can_tint(&l, now, 10, -32769) == S7LOG_RANGE);
    CHECK(s7log_srt_dint(&l, now, 20, INT64_C(2147483648), 0, 0) == S7LOG_RANGE);
    CHECK(s7log_dis_irt(&l, now, 256, 0, 0) == S7LOG_RANGE);
    CHECK(s7log_dis_irt(&l, now, -1, 0, 0) == S7LOG_RANGE);
    CHECK(s7log_start(&l, now, 0, NULL) == S7LOG_RANGE);
    CHECK(s7log_end(&l, now, 32768) == S7LOG_RANGE);
    CHECK(s7log_interrupt(&l, now, 10, S7LOG_NONE) == S7LOG_RANGE);
    CHECK(s7log_interrupt(&l, now, 80, S7LOG_NONE) == S7LOG_RANGE);
    CHECK(s7log_interrupt(&l, now, 35, 1) == S7LOG_RANGE);
    info.priority = 30;
    CHECK(s7log_start(&l, now, 10, &info) == S7LOG_RANGE);
    info.priority = S7LOG_NONE;
    info.caught_up = 2;
    CHECK(s7log_start(&l, now, 10, &info) == S7LOG_RANGE);
    CHECK(s7log_zone(&l, now, 841, true) == S7LOG_RANGE);
    struct s7log_ob_state state = S7LOG_OB_STATE_NONE;
    state.active = 2;
    CHECK(s7log_state(&l, now, 10, &state) == S7LOG_RANGE);
    state.active = 1;
    state.left = -1;
    CHECK(s7log_state(&l, now, 10, &state) == S7LOG_RANGE);
    CHECK(s.lines == 1 && l.events == 0);
}

static void notes(void)
{
    struct s7log l;
    struct sink s;
    begin(&l, &s);
    s7log_note(&l, "x_note", "a \"b\" \\ \n\x01 \xC3\xBC \xF0\x9F\x98\x80");
    CHECK(s7log_run(&l, now) == S7LOG_OK);
    CHECK(strstr(s.line, ",\"x_note\":\"a \\\"b\\\" \\\\ \\u000a\\u0001 \xC3\xBC \xF0\x9F\x98\x80\"}\n") !=
          NULL);
    CHECK(s7log_run(&l, now) == S7LOG_OK && strstr(s.line, "x_note") == NULL);
    /* no UTF-8: a byte alone, cut off, too long for its value, a surrogate, above U+10FFFF */
    s7log_note(&l, "x_n", "\x80|\xC3|\xC0\x80|\xED\xA0\x80|\xF4\x90\x80\x80|\xE2\x82");
    CHECK(s7log_run(&l, now) == S7LOG_OK);
    CHECK(strstr(s.line, "\"\\ufffd|\\ufffd|\\ufffd\\ufffd|\\ufffd\\ufffd\\ufffd|"
                         "\\ufffd\\ufffd\\ufffd\\ufffd|\\ufffd\\ufffd\"") != NULL);
    s7log_note(&l, "note", "");
    CHECK(s7log_run(&l, now) == S7LOG_RANGE);
}

static void limits(void)
{
    static char text[S7LOG_LINE + 1];
    struct s7log l;
    struct sink s;
    begin(&l, &s);
    memset(text, 'a', S7LOG_LINE);
    s7log_note(&l, "x_long", text);
    CHECK(s7log_run(&l, now) == S7LOG_FULL);
    CHECK(s7log_run(&l, now) == S7LOG_OK);
    s.full = true;
    CHECK(s7log_run(&l, now) == S7LOG_IO);
    s.full = false;
    CHECK(s7log_run(&l, now) == S7LOG_IO && s.lines == 2);
}

static void dates(void)
{
    const struct s7log_dt wrong[] = {{2026, 2, 29, 0, 0, 0, 0}, {1989, 12, 31, 0, 0, 0, 0},
                                     {2090, 1, 1, 0, 0, 0, 0},  {2026, 13, 1, 0, 0, 0, 0},
                                     {2026, 4, 31, 0, 0, 0, 0}, {2026, 1, 1, 24, 0, 0, 0},
                                     {2026, 1, 0, 0, 0, 0, 0},  {2026, 1, 1, 0, 60, 0, 0}};
    const struct s7log_dt last = {2089, 12, 31, 23, 59, 59, 999};
    int bad = 0;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        bad += s7log_ms(&wrong[i]) != S7LOG_NONE;
    CHECK(s7log_ms(&last) == S7LOG_AT_MAX);
    for (int64_t at = 12345; at <= S7LOG_AT_MAX; at += S7LOG_DAY_MS) {
        struct s7log_dt d = s7log_date(at);
        bad += s7log_ms(&d) != at;
    }
    CHECK(bad == 0);
}

static void file(void)
{
    struct s7log l;
    struct s7log_header h = simple_header();
    char text[200] = "";
    FILE *f = tmpfile();
    if (f == NULL)
        abort();
    s7log_open(&l, s7log_to_file, f);
    CHECK(s7log_header(&l, &h) == S7LOG_OK && s7log_run(&l, now) == S7LOG_OK);
    rewind(f);
    CHECK(fgets(text, sizeof text, f) != NULL && strstr(text, "\"S7-300\"") != NULL);
    CHECK(fgets(text, sizeof text, f) != NULL && strcmp(text, "{\"event\":\"run\"," AT "}\n") == 0);
    fclose(f);
}

int main(void)
{
    header();
    header_ranges();
    readings();
    events();
    event_ranges();
    notes();
    limits();
    dates();
    file();
    printf("s7log.h: %d checks, %d failed\n", checks, failed);
    return failed == 0 ? 0 : 1;
}

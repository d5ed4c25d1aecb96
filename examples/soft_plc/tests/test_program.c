/* Programs as JSON: what is read, and errors with one message that names file, line, field and
 * what was expected. */
#include <stdio.h>
#include <string.h>

#include "scenario.h"
#include "test.h"
#include "values.h"

#define TEXT(...) #__VA_ARGS__
#define HEAD                                                                                       \
    "{\"format\": \"s7-interrupt-program/1\", \"name\": \"a\", \"about\": \"a\", "                 \
    "\"requirements\": [], \"header\": {\"cpu\": \"S7-400\", \"obs\": [1, 10, 35], "               \
    "\"clock\": \"2026-11-21T05:59:30\", \"mode\": \"RUN\"}, \"duration\": 5000"

static void wrong_text(const char *text, const char *message)
{
    struct scenario s;
    CHECK(!scenario_read(&s, "t.json", 1, text, strlen(text)));
    if (strstr(s.error, message) == NULL)
        fprintf(stderr, "message is: %s\n", s.error);
    CHECK(strstr(s.error, message) != NULL);
    scenario_free(&s);
}

/* A member behind the usual ones. */
static void wrong(const char *member, const char *message)
{
    char text[1000];
    snprintf(text, sizeof text, HEAD ", %s%s}", member,
             strstr(member, "bodies") != NULL ? "" : ", \"bodies\": []");
    wrong_text(text, message);
}

static void errors(void)
{
    wrong_text("{\n\"a\": tru}", "t.json:2: expected a value");
    wrong_text("{\"a\": 1, \"a\": 2}", "expected each name once");
    wrong_text("[1, 2", "expected , or ]");
    wrong_text("\"\\ud800\"", "a character behind \\u");
    wrong_text("{} {}", "expected the end of the text");
    wrong_text("[]", "expected an object");
    wrong_text("{}", "t.json:1: format: expected this field");
    wrong_text(HEAD "}", "bodies: expected a list");
    wrong(TEXT("nonsense": 1), "nonsense: expected a field of this object");
    wrong(TEXT("outside": [{"after": -1, "event": "stop"}]),
          "outside.1.after: expected an integer from 0");
    wrong(TEXT("outside": [{"after": 1, "event": "jump"}]),
          "outside.1.event: expected an event from outside, found \"jump\"");
    wrong(TEXT("outside": [{"after": 1, "event": "interrupt", "ob": 10}]),
          "outside.1.ob: expected an OB with a start event from outside");
    wrong(TEXT("outside": [{"after": 1, "event": "interrupt", "ob": 80, "flt_id": 5}]),
          "a fault id that no rule makes");
    wrong(TEXT("outside": [{"after": 1, "event": "clock", "by": 1, "to": "2026-01-01T00:00"}]),
          "outside.1: expected one of to and by");
    wrong(TEXT("bodies": [{"ob": 10, "steps": [{"wait": 1}, {"call": "SET_TIME"}]}]),
          "bodies.1.steps.2.call: expected the name of an SFC, found \"SET_TIME\"");
    wrong(TEXT("bodies": [{"ob": 10, "steps": [{"call": "SET_TINT", "ob": 10, "sdt": "soon"}]}]),
          "bodies.1.steps.1.sdt: expected a date and time, found \"soon\"");
    wrong(TEXT("bodies": [{"ob": 10, "steps": [{"call": "CAN_TINT", "ob": 10, "mode": 1}]}]),
          "bodies.1.steps.1.mode: expected a field of this object");
    wrong(TEXT("bodies": [{"ob": 10, "steps": [{"end": true}, {"wait": 1}]}]),
          "expected end as the last step");
    wrong(TEXT("bodies": [{"ob": 10, "steps": []}, {"ob": 10, "steps": []}]),
          "bodies.2: expected one body");
    wrong(TEXT("x_soft_plc": {"buffer": 0}), "x_soft_plc.buffer: expected an integer from 1 to 64");
}

/* Fields of the header that an S7-1500 alone has, behind the CPU. */
static void wrong_header(const char *cpu, const char *member, const char *message)
{
    char text[1000];
    snprintf(text, sizeof text, "{\"format\": \"s7-interrupt-program/1\", \"header\": {\"cpu\": \"%s\", "
             "\"obs\": [1], \"clock\": \"2026-11-21T05:59:30\", %s}}", cpu, member);
    wrong_text(text, message);
}

static void headers(void)
{
    wrong_header("S7-400", TEXT("zone": 60), "header.zone: expected a zone on an S7-1500 only");
    wrong_header("S7-400", TEXT("classes": {"123": "tod"}), "header.classes: expected OBs from 123");
    wrong_header("S7-1500", TEXT("classes": {"122": "tod"}), "header.classes: expected OBs from 123");
    wrong_header("S7-1500", TEXT("classes": {"123": "error"}), "header.123: expected an event class");
    wrong_header("S7-1500", TEXT("classes": {"123": "cyclic"}), "header.priority: expected one for each");
}

static void program(void)
{
    static const char text[] = HEAD ", " TEXT("outside": [{"after": 20, "every": 30, "event": "stop"},
                                                     {"after": 10, "event": "hold"}],
        "bodies": [{"ob": 1, "run": 2, "steps": [
            {"call": "SRT_DINT", "ob": 20, "dtime": "T#1s_500ms", "sign": -1, "x_own": [1.5]},
            {"wait": 7}, {"end": true}]}]}) ;
    struct scenario s;
    CHECK(scenario_read(&s, "t.json", 1, text, strlen(text)));
    CHECK(s.action_count == 2 && s.actions[0].action.kind == ACTION_HOLD && s.actions[1].every == 30);
    CHECK(s.body_count == 1 && s.bodies[0].run == 2 && s.bodies[0].count == 2);
    CHECK(s.bodies[0].steps[0].ms == 1500 && s.bodies[0].steps[0].sign == 0xFFFF);
    CHECK(s.config.duration == 5000 && s.config.cpu.loaded[35] && !s.config.cpu.loaded[20]);
    scenario_free(&s);
}

static void values(void)
{
    struct s7cpu_date d;
    int64_t ms;
    int word;
    CHECK(value_time("T#-24d_20h_31m_23s_648ms", &ms) && ms == INT32_MIN);
    CHECK(value_time("time#2m", &ms) && ms == 120000);
    CHECK(!value_time("T#1ms1s", &ms) && !value_time("T#", &ms) && !value_time("1s", &ms));
    CHECK(!value_time("T#1s_", &ms) && !value_time("T#25d", &ms));
    CHECK(value_word("b#16#a2", 0xFF, &word) && word == 0xA2);
    CHECK(!value_word("B#16#0A2", 0xFFFF, &word) && !value_word("16#0100", 0xFF, &word));
    CHECK(value_civil("DT#2026-2-30-6:5:4.3", &d) && d.day == 30 && d.ms == 300);
    CHECK(!value_civil("2026-2-3T06:00", &d) && !value_civil("2026-02-03T06:00Z", &d));
    CHECK(!value_dt("2026-02-30T06:00", &ms));
}

void test_program(void)
{
    errors();
    headers();
    program();
    values();
}

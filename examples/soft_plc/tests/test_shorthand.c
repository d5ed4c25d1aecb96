/* Errors of the shorthand: one message that names file, line, field and what was expected. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "test.h"

static void wrong(const char *text, const char *message)
{
    char *error = test_error(text);
    if (strstr(error, message) == NULL)
        fprintf(stderr, "message is: %s\n", error);
    CHECK(strstr(error, message) != NULL);
    free(error);
}

void test_shorthand(void)
{
    char *fine = test_error("at +1s stop # a comment\n\n");
    CHECK(fine[0] == '\0');
    free(fine);
    wrong("cpu S7-500\n", "t.scn:1: cpu: expected S7-300, S7-400 or 318, found \"S7-500\"");
    wrong("cpu S7-300\nobs 10\nclock 2026-01-01T00:00\n", "obs: expected OB 1");
    wrong("cpu S7-300\nobs 1\nduration 5s\n", "clock: expected this setting");
    wrong("cpu S7-300\nobs 1\nclock 2026-01-01T00:00\n", "duration: expected this setting");
    wrong("cpu S7-300\nobs 1 19\n", "t.scn:2: obs: expected the number of an OB, found \"19\"");
    wrong("cpu S7-300\nclock 2026-02-29T00:00\n", "t.scn:2: clock: expected");
    wrong("mode RUN\n", "t.scn:6: mode: expected this setting only once");
    wrong("nonsense\n", "t.scn:6: nonsense: expected a setting");
    wrong("at 2020-01-01T00:00 stop\n", "t.scn:6: at: expected");
    wrong("at +1s jump\n", "action: expected");
    wrong("at +1s interrupt 10\n", "interrupt: expected an OB with a start event from outside");
    wrong("at +1s interrupt 80 16#05\n", "a fault id that no rule makes");
    wrong("at +1s restart hot\n", "restart: expected warm or cold");
    wrong("every 0ms interrupt 35\n", "every: expected");
    wrong("priority 80 20\n", "t.scn:6: priority: expected an OB whose class can be set");
    wrong("priority 35 24\n", "a class that this OB may have");
    wrong("step7 10 minute\n", "step7: expected a start");
    wrong("step7 10 monthly 2026-01-29T00:00\n", "a day from 1 to 28");
    wrong("step7 20 minute 2026-01-29T00:00\n", "an OB from 10 to 17");
    wrong("ob 10 {\nSET_TINT 10 2026-01-01T00:00\n}\n", "t.scn:7: SET_TINT: expected PERIOD");
    wrong("ob 10 {\nSET_TINT 10 yesterday 16#0201\n}\n", "SDT, a date and time");
    wrong("ob 10 {\nSRT_DINT 20 soon 16#0\n}\n", "SRT_DINT: expected DTIME");
    wrong("ob 10 {\nSRT_DINT 20 30d 16#0\n}\n", "SRT_DINT: expected DTIME");
    wrong("ob 10 {\nSRT_DINT 20 5ms\n}\n", "SRT_DINT: expected SIGN");
    wrong("ob 10 {\nSRT_DINT 20 5ms 16#12345\n}\n", "SRT_DINT: expected SIGN");
    wrong("ob 10 {\nDIS_IRT 16#100 0\n}\n", "DIS_IRT: expected MODE, a byte");
    wrong("ob 10 {\nEN_IRT 16#02\n}\n", "EN_IRT: expected OB_NR");
    wrong("ob 10 {\nDIS_IRT 0 10 5\n}\n", "DIS_IRT: expected two arguments");
    wrong("log_diag yes\n", "log_diag: expected on or off");
    wrong("ob 10 {\nbusy 5\n}\n", "busy: expected a duration");
    wrong("ob 10 {\nbusy 99999999999999999999s\n}\n", "busy: expected a duration");
    wrong("ob 10 {\nJUMP\n}\n", "t.scn:7: JUMP: expected an instruction or }");
    wrong("ob 10 {\n", "t.scn:6: ob: expected } at the end");
    wrong("ob 10 {\n}\nob 10 {\n}\n", "t.scn:8: ob: expected one body");
    wrong("random 5\n", "random: expected events");
    wrong("random 5 events 10\nat +1s stop\n", "random: expected no ob, at or every");
}

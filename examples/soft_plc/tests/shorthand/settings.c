/* The settings of a scenario: what stands in the header of the log, and how long it runs. */
#include <string.h>

#include "choices.h"
#include "parser.h"

/* A program can call itself without time passing, as an OB 80 that moves the clock. */
enum { SCENARIO_MAX_EVENTS = 1000000 };

static bool set_cpu(struct parser *p)
{
    const char *s = parser_word(p, 1);
    if (s != NULL && strcmp(s, "S7-300") == 0)
        p->scenario->config.cpu.family = S7CPU_S7_300;
    else if (s != NULL && strcmp(s, "S7-400") == 0)
        p->scenario->config.cpu.family = S7CPU_S7_400;
    else if (s != NULL && strcmp(s, "318") == 0)
        p->scenario->config.cpu.family = S7CPU_CPU_318;
    else
        return parser_fail(p, "cpu", "S7-300, S7-400 or 318", s);
    return parse_word_count(p, "cpu", 2, "one value");
}

static bool set_obs(struct parser *p)
{
    for (int i = 1; i < p->words.count; i++) {
        int ob;
        if (!parse_ob(p, "obs", i, &ob))
            return false;
        p->scenario->config.cpu.loaded[ob] = true;
    }
    return true;
}

static bool set_clock(struct parser *p)
{
    const char *s = parser_word(p, 1);
    if (s == NULL || !word_dt(s, &p->scenario->config.cpu.clock))
        return parser_fail(p, "clock", "a date and time from 1990 to 2089", s);
    return parse_word_count(p, "clock", 2, "one value");
}

static bool set_mode(struct parser *p)
{
    const char *s = parser_word(p, 1);
    if (s != NULL && strcmp(s, "STOP") == 0)
        p->scenario->config.cpu.mode = S7CPU_STOP;
    else if (s != NULL && strcmp(s, "STARTUP") == 0)
        p->scenario->config.cpu.mode = S7CPU_STARTUP;
    else if (s != NULL && strcmp(s, "RUN") == 0)
        p->scenario->config.cpu.mode = S7CPU_RUN;
    else
        return parser_fail(p, "mode", "STOP, STARTUP or RUN", s);
    return parse_word_count(p, "mode", 2, "one value");
}

static bool duration(struct parser *p, const char *field, int64_t low, int64_t high,
                     const char *expected, int64_t *ms)
{
    const char *s = parser_word(p, 1);
    if (s == NULL || !word_duration(s, ms) || *ms < low || *ms > high)
        return parser_fail(p, field, expected, s);
    return parse_word_count(p, field, 2, "one value");
}

static bool set_latency(struct parser *p)
{
    int64_t ms;
    if (!duration(p, "latency", 0, 60000, "a duration of 0ms to 60s", &ms))
        return false;
    p->scenario->config.log.latency_ms = (int)ms;
    p->scenario->latency_given = true;
    return true;
}

static bool set_cycle_time(struct parser *p)
{
    return duration(p, "cycle_time", 1, S7CPU_DAY, "a duration of 1ms to 1d",
                    &p->scenario->config.cycle_ms);
}

static bool set_duration(struct parser *p)
{
    return duration(p, "duration", 1, INT64_MAX, "a duration of 1ms or more, as 10min",
                    &p->scenario->config.duration);
}

static bool set_switch(struct parser *p, const char *field, bool *on)
{
    const char *s = parser_word(p, 1);
    if (s == NULL || (strcmp(s, "on") != 0 && strcmp(s, "off") != 0))
        return parser_fail(p, field, "on or off", s);
    *on = strcmp(s, "on") == 0;
    return parse_word_count(p, field, 2, "one value");
}

static bool set_log_cycle(struct parser *p)
{
    return set_switch(p, "log_cycle", &p->scenario->config.log.cycle);
}

static bool set_log_diag(struct parser *p)
{
    return set_switch(p, "log_diag", &p->scenario->config.log.diag);
}

static bool set_buffer(struct parser *p)
{
    const char *s = parser_word(p, 1);
    int64_t n;
    if (s == NULL || !word_int(s, 1, 64, &n))
        return parser_fail(p, "buffer", "a number from 1 to 64", s);
    p->scenario->config.cpu.buffer = (int)n;
    return parse_word_count(p, "buffer", 2, "one value");
}

static bool set_random(struct parser *p)
{
    const char *s = parser_word(p, 1);
    int64_t n;
    if (s == NULL || !word_int(s, 0, INT64_MAX, &n))
        return parser_fail(p, "random", "a seed", s);
    p->scenario->seed = (uint64_t)n;
    p->scenario->random = true;
    s = parser_word(p, 2);
    if (s == NULL || strcmp(s, "events") != 0)
        return parser_fail(p, "random", "events and a number after the seed", s);
    s = parser_word(p, 3);
    if (s == NULL || !word_int(s, 1, INT64_MAX, &n))
        return parser_fail(p, "events", "a number from 1", s);
    p->scenario->config.max_events = (uint64_t)n;
    return parse_word_count(p, "random", 4, "the end of the line");
}

static bool set_priority(struct parser *p)
{
    const char *s = parser_word(p, 2);
    int ob;
    int64_t n;
    if (!parse_ob(p, "priority", 1, &ob))
        return false;
    if (s == NULL || !word_int(s, 2, 28, &n))
        return parser_fail(p, "priority", "a class from 2 to 28", s);
    p->scenario->config.cpu.priority[ob] = (int)n;
    p->priority_line[ob] = p->line;
    return parse_word_count(p, "priority", 3, "an OB and a class");
}

static bool set_choice(struct parser *p)
{
    const char *s = parser_word(p, 1);
    if (s == NULL || !choice_set(&p->scenario->config.cpu.choices, s))
        return parser_fail(p, "choose", "a choice that --choose help lists, as AMB-34=b", s);
    return parse_word_count(p, "choose", 2, "one choice");
}

static bool set_execution(const char *s, struct s7cpu_step7 *t)
{
    static const char *const names[] = {
        [S7CPU_NO_EXECUTION] = "none",  [S7CPU_ONCE] = "once",
        [S7CPU_EVERY_MINUTE] = "minute", [S7CPU_HOURLY] = "hourly",
        [S7CPU_DAILY] = "daily",         [S7CPU_WEEKLY] = "weekly",
        [S7CPU_MONTHLY] = "monthly",     [S7CPU_YEARLY] = "yearly",
        [S7CPU_END_OF_MONTH] = "end_of_month"};
    for (int i = S7CPU_NO_EXECUTION; i <= S7CPU_END_OF_MONTH; i++)
        if (strcmp(s, names[i]) == 0) {
            t->execution = (enum s7cpu_execution)i;
            return true;
        }
    return false;
}

static bool set_step7(struct parser *p)
{
    int ob;
    if (!parse_ob(p, "step7", 1, &ob))
        return false;
    int k = ob - S7CPU_TOD_FIRST;
    if (k < 0 || k >= S7CPU_TODS)
        return parser_fail(p, "step7", "an OB from 10 to 17", parser_word(p, 1));
    struct s7cpu_step7 *t = &p->scenario->config.cpu.step7[k];
    if (t->execution != S7CPU_NOT_CONFIGURED || t->deselected)
        return parser_fail(p, "step7", "each OB only once", parser_word(p, 1));
    p->step7_line[k] = p->line;
    t->start = S7CPU_NEVER;
    for (int i = 2; i < p->words.count; i++) {
        const char *s = parser_word(p, i);
        if (strcmp(s, "active") == 0)
            t->active = true;
        else if (strcmp(s, "deselected") == 0)
            t->deselected = true;
        else if (t->start == S7CPU_NEVER && word_dt(s, &t->start))
            t->start -= t->start % S7CPU_MINUTE; /* [TINT-11] */
        else if (t->execution != S7CPU_NOT_CONFIGURED || !set_execution(s, t))
            return parser_fail(p, "step7", "one execution, one start, active or deselected", s);
    }
    if (t->execution == S7CPU_NOT_CONFIGURED && !t->deselected)
        return parser_fail(p, "step7", "an execution or deselected", NULL);
    if (t->execution > S7CPU_NO_EXECUTION && t->start == S7CPU_NEVER)
        return parser_fail(p, "step7", "a start beside this execution", NULL);
    return true;
}

static const struct {
    const char *name;
    bool (*parse)(struct parser *p);
    bool repeats;
} settings[] = {
    {"cpu", set_cpu, false},           {"obs", set_obs, false},
    {"clock", set_clock, false},       {"mode", set_mode, false},
    {"latency", set_latency, false},   {"cycle_time", set_cycle_time, false},
    {"duration", set_duration, false}, {"log_cycle", set_log_cycle, false},
    {"log_diag", set_log_diag, false}, {"buffer", set_buffer, false},
    {"random", set_random, false},     {"priority", set_priority, true},
    {"step7", set_step7, true},        {"choose", set_choice, true},
};

static bool was_given(const struct parser *p, const char *name)
{
    for (unsigned i = 0; i < sizeof settings / sizeof settings[0]; i++)
        if (strcmp(settings[i].name, name) == 0)
            return p->seen >> i & 1;
    return false;
}

bool parse_setting(struct parser *p, bool *known)
{
    for (unsigned i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        if (strcmp(settings[i].name, p->words.word[0]) != 0)
            continue;
        *known = true;
        if (p->seen >> i & 1 && !settings[i].repeats)
            return parser_fail(p, settings[i].name, "this setting only once", NULL);
        p->seen |= 1u << i;
        return settings[i].parse(p);
    }
    return true;
}

static bool check_priorities(struct parser *p)
{
    const struct s7cpu_config *c = &p->scenario->config.cpu;
    for (int ob = 0; ob < S7CPU_OBS; ob++) {
        int low, high;
        if (c->priority[ob] == 0)
            continue;
        p->line = p->priority_line[ob];
        if (!s7cpu_class_range(c->family, ob, &low, &high))
            return parser_fail(p, "priority", "an OB whose class can be set on this CPU", NULL);
        if (c->priority[ob] < low || c->priority[ob] > high)
            return parser_fail(p, "priority", "a class that this OB may have", NULL);
    }
    return true;
}

static bool check_step7(struct parser *p)
{
    for (int k = 0; k < S7CPU_TODS; k++) {
        const struct s7cpu_step7 *t = &p->scenario->config.cpu.step7[k];
        p->line = p->step7_line[k];
        if (t->execution == S7CPU_MONTHLY && s7cpu_date(t->start).day > 28)
            return parser_fail(p, "step7", "a day from 1 to 28 with monthly", NULL);
    }
    return true;
}

bool parse_settings_end(struct parser *p)
{
    static const char *const needed[] = {"cpu", "obs", "clock"};
    struct plc_config *c = &p->scenario->config;
    for (unsigned i = 0; i < sizeof needed / sizeof needed[0]; i++)
        if (!was_given(p, needed[i]))
            return parser_fail(p, needed[i], "this setting", NULL);
    if (!c->cpu.loaded[1])
        return parser_fail(p, "obs", "OB 1 among the loaded OBs", NULL);
    if (!was_given(p, "duration")) {
        if (!p->scenario->random)
            return parser_fail(p, "duration", "this setting", NULL);
        c->duration = INT64_MAX;
    }
    if (!p->scenario->random)
        c->max_events = SCENARIO_MAX_EVENTS;
    if (!was_given(p, "cycle_time"))
        c->cycle_ms = 10;
    if (!was_given(p, "buffer"))
        c->cpu.buffer = 16;
    return check_priorities(p) && check_step7(p);
}

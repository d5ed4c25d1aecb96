/* A shorthand for the programs of the tests, as JSON for the reader of programs: a statement a line,
 * settings, `at` and `every` for events from outside, `ob 10 run 1 { ... }` for bodies. */
#define _POSIX_C_SOURCE 200809L
#include "shorthand.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS = 64, PARTS = 9 };

/* The lists and objects of the JSON text, each in a stream of its own. */
enum part { HEADER, OWN, CLASSES, QUEUES, PRIORITY, TOD, CHOOSE, OUTSIDE, BODIES };

struct shorthand {
    char *text[PARTS];
    size_t length[PARTS];
    FILE *part[PARTS];
    char *word[WORDS + 1]; /* of the line, with NULL behind them */
    char duration[24];
    int64_t clock;
    bool in_body, has_steps;
};

/* A new element of a list, or a member of an object. */
static FILE *next(struct shorthand *s, enum part part)
{
    if (ftell(s->part[part]) > 0)
        fputs(", ", s->part[part]);
    return s->part[part];
}

/* Milliseconds of 40s, 1h30min, -5 or +1d; false where it is something else. */
static bool milliseconds(const char *s, int64_t *ms)
{
    static const struct {
        const char *name;
        int64_t ms;
    } units[] = {{"ms", 1}, {"min", S7CPU_MINUTE}, {"m", S7CPU_MINUTE}, {"s", 1000},
                 {"h", S7CPU_HOUR}, {"d", S7CPU_DAY}, {"", 1}};
    int64_t sign = *s == '-' ? -1 : 1;
    s += *s == '-' || *s == '+';
    s += strncmp(s, "T#", 2) == 0 ? 2 : 0;
    *ms = 0;
    do {
        char *end;
        unsigned i = 0;
        int64_t n = strtoll(s, &end, 10);
        if (!isdigit((unsigned char)*s))
            return false;
        while (strncmp(end, units[i].name, strlen(units[i].name)) != 0)
            i++;
        s = end + strlen(units[i].name);
        *ms += sign * n * units[i].ms;
    } while (*s != '\0');
    return true;
}

/* A member with a number or text, as the word is; durations in milliseconds. */
static void member(FILE *to, const char *name, const char *word)
{
    int64_t ms;
    if (word == NULL)
        return;
    if (strcmp(word, "on") == 0)
        fprintf(to, ", \"%s\": true", name);
    else if (milliseconds(word, &ms))
        fprintf(to, ", \"%s\": %" PRId64, name, ms);
    else
        fprintf(to, ", \"%s\": \"%s\"", name, word);
}

/* The clock is set to a reading, or moved by a duration. */
static void clock_change(FILE *to, const char *word)
{
    member(to, *word == '+' || *word == '-' ? "by" : "to", word);
}

/* set_zone 60 daylight: minutes and the reason */
static void zone_change(FILE *to, const char *const *w)
{
    member(to, "zone", w[1]);
    member(to, "reason", w[2]);
}

static void step(struct shorthand *s)
{
    const char *name = s->word[0], *const *w = (const char *const *)s->word;
    FILE *to = s->part[BODIES];
    fputs(s->has_steps ? ", " : "", to);
    s->has_steps = true;
    if (strcmp(name, "busy") == 0) {
        fputs("{\"x_\": 0", to);
        member(to, "wait", w[1]);
    } else if (strcmp(name, "set_clock") == 0) {
        fputs("{\"event\": \"clock\"", to);
        clock_change(to, w[1]);
    } else if (strcmp(name, "set_zone") == 0) {
        fputs("{\"event\": \"zone\"", to);
        zone_change(to, w);
    } else if (strcmp(name, "state") == 0) {
        fputs("{\"event\": \"state\"", to);
        member(to, "ob", w[1]);
    } else {
        bool irt = strstr(name, "_IRT") != NULL, set = strncmp(name, "SET_TINT", 8) == 0;
        fprintf(to, "{\"call\": \"%s\"", name);
        if (irt)
            member(to, "mode", w[1]);
        member(to, "ob", w[irt ? 2 : 1]);
        if (!irt && w[1] != NULL && w[2] != NULL) {
            member(to, set ? "sdt" : "dtime", w[2]);
            member(to, set ? "period" : "sign", w[3]);
        }
        for (int i = 4; i < WORDS && w[2] != NULL && w[3] != NULL && w[i] != NULL; i++)
            member(to, w[i], "on"); /* local, activate */
    }
    fputc('}', to);
}

static void event(struct shorthand *s, int64_t after, int64_t every)
{
    const char *const *w = (const char *const *)s->word + 2;
    FILE *to = next(s, OUTSIDE);
    fprintf(to, "{\"after\": %" PRId64 ", \"event\": \"%s\"", after, w[0]);
    if (every > 0)
        fprintf(to, ", \"every\": %" PRId64, every);
    if (strcmp(w[0], "clock") == 0)
        clock_change(to, w[1]);
    else if (strcmp(w[0], "zone") == 0)
        zone_change(to, w);
    else
        member(to, strcmp(w[0], "restart") == 0 ? "type" : "ob", w[1]);
    if (strcmp(w[0], "interrupt") == 0)
        member(to, "flt_id", w[2]);
    fputc('}', to);
}

static void step7(struct shorthand *s)
{
    FILE *to = next(s, TOD);
    fprintf(to, "\"%s\": {\"x_\": 0", s->word[1]);
    for (int i = 2; s->word[i] != NULL; i++) {
        const char *w = s->word[i];
        if (strcmp(w, "active") == 0 || strcmp(w, "deselected") == 0 || strcmp(w, "local") == 0)
            member(to, w, "on");
        else
            member(to, isdigit((unsigned char)*w) ? "start" : "execution", w);
    }
    fputc('}', to);
}

static void obs(struct shorthand *s)
{
    FILE *to = s->part[HEADER];
    fputs(", \"obs\": [", to);
    for (int i = 1; s->word[i] != NULL; i++)
        fprintf(to, "%s%s", i > 1 ? ", " : "", s->word[i]);
    fputc(']', to);
}

/* queue 35 3 1 overflow: events, threshold where there is one, overflow */
static void queue(struct shorthand *s)
{
    FILE *to = next(s, QUEUES);
    fprintf(to, "\"%s\": {\"events\": %s", s->word[1], s->word[2]);
    for (int i = 3; s->word[i] != NULL; i++) {
        const bool number = isdigit((unsigned char)*s->word[i]);
        member(to, number ? "threshold" : s->word[i], number ? s->word[i] : "on");
    }
    fputc('}', to);
}

static void setting(struct shorthand *s)
{
    static const char *const own[][2] = {{"latency", "latency_ms"}, {"cycle_time", "cycle_ms"},
                                         {"log_diag", "diag"}, {"buffer", "buffer"}};
    const char *name = s->word[0], *value = s->word[1];
    int64_t ms;
    if (strcmp(name, "duration") == 0 && milliseconds(value, &ms))
        snprintf(s->duration, sizeof s->duration, "%" PRId64, ms);
    else if (strcmp(name, "obs") == 0)
        obs(s);
    else if (strcmp(name, "step7") == 0)
        step7(s);
    else if (strcmp(name, "priority") == 0)
        fprintf(next(s, PRIORITY), "\"%s\": %s", value, s->word[2]);
    else if (strcmp(name, "class") == 0)
        fprintf(next(s, CLASSES), "\"%s\": \"%s\"", value, s->word[2]);
    else if (strcmp(name, "queue") == 0)
        queue(s);
    else if (strcmp(name, "choose") == 0)
        fprintf(next(s, CHOOSE), "\"%s\"", value);
    else if (strcmp(name, "random") == 0)
        fprintf(s->part[OWN], ", \"random\": {\"seed\": %s, \"events\": %s}", value, s->word[3]);
    else if (strcmp(name, "cpu") == 0)
        member(s->part[HEADER], name, strcmp(value, "318") == 0 ? "CPU 318" : value);
    else if (strcmp(name, "log_cycle") == 0)
        member(s->part[HEADER], "cycle", value);
    else {
        for (unsigned i = 0; i < sizeof own / sizeof own[0]; i++)
            if (strcmp(name, own[i][0]) == 0) {
                member(s->part[OWN], own[i][1], value);
                return;
            }
        member(s->part[HEADER], name, value);
        if (strcmp(name, "clock") == 0)
            value_dt(value, &s->clock);
    }
}

static void body(struct shorthand *s)
{
    FILE *to = next(s, BODIES);
    fprintf(to, "{\"ob\": %s", s->word[1]);
    if (strcmp(s->word[2], "run") == 0)
        member(to, "run", s->word[3]);
    fputs(", \"steps\": [", to);
    s->in_body = true;
    s->has_steps = false;
}

static void statement(struct shorthand *s)
{
    const char *name = s->word[0];
    int64_t ms = 0;
    if (s->in_body && strcmp(name, "}") == 0) {
        fputs("]}", s->part[BODIES]);
        s->in_body = false;
    } else if (s->in_body)
        step(s);
    else if (strcmp(name, "ob") == 0)
        body(s);
    else if (strcmp(name, "at") == 0) {
        if (value_dt(s->word[1], &ms))
            ms -= s->clock; /* as if the clock were never set */
        else
            milliseconds(s->word[1], &ms);
        event(s, ms, 0);
    } else if (strcmp(name, "every") == 0) {
        milliseconds(s->word[1], &ms);
        event(s, ms, ms);
    } else
        setting(s);
}

bool shorthand_read(struct scenario *scenario, char *text)
{
    struct shorthand s = {.duration = "86400000"};
    char *lines, *words, *whole = NULL;
    size_t length = 0;
    for (int i = 0; i < PARTS; i++)
        s.part[i] = open_memstream(&s.text[i], &s.length[i]);
    for (char *line = strtok_r(text, "\n", &lines); line; line = strtok_r(NULL, "\n", &lines)) {
        int count = 0;
        char *word = strtok_r(line, " ", &words);
        for (; word != NULL && count < WORDS; word = strtok_r(NULL, " ", &words))
            s.word[count++] = word;
        memset(s.word + count, 0, sizeof s.word - (size_t)count * sizeof s.word[0]);
        if (count > 0)
            statement(&s);
    }
    for (int i = 0; i < PARTS; i++)
        fclose(s.part[i]);
    FILE *to = open_memstream(&whole, &length);
    fprintf(to, "{\"format\": \"s7-interrupt-program/1\", \"duration\": %s, \"header\": {\"x_\": 0%s, ",
            s.duration, s.text[HEADER]);
    fprintf(to, "\"classes\": {%s}, ", s.text[CLASSES]);
    fprintf(to, "\"queue\": {%s}, ", s.text[QUEUES]);
    fprintf(to, "\"priority\": {%s}, \"step7\": {\"tod\": {%s}}}, ", s.text[PRIORITY], s.text[TOD]);
    fprintf(to, "\"x_soft_plc\": {\"choose\": [%s]%s}, ", s.text[CHOOSE], s.text[OWN]);
    fprintf(to, "\"outside\": [%s], \"bodies\": [%s]}\n", s.text[OUTSIDE], s.text[BODIES]);
    fclose(to);
    bool ok = scenario_read(scenario, "shorthand", 1, whole, length);
    if (!scenario->latency_given)
        scenario->config.log.latency_ms = 0;
    for (int i = 0; i < PARTS; i++)
        free(s.text[i]);
    if (!ok)
        fprintf(stderr, "%s", whole);
    free(whole);
    return ok;
}

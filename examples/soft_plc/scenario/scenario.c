#include "scenario.h"

#include <stdlib.h>
#include <string.h>

#include "reader.h"

static int by_time(const void *a, const void *b)
{
    const struct timed_action *x = a, *y = b;
    if (x->up != y->up)
        return x->up < y->up ? -1 : 1;
    return x->place < y->place ? -1 : x->place > y->place;
}

void scenario_end(struct scenario *s)
{
    scenario_program(s);
    if (s->action_count > 0)
        qsort(s->actions, s->action_count, sizeof s->actions[0], by_time);
}

static bool read_whole(struct reader *r, const struct json *program)
{
    static const char *const names[] = {"format", "name",   "about",    "requirements", "catches",
                                        "seed",   "header", "duration", "outside",      "bodies",
                                        NULL};
    static const char *const formats[] = {"s7-interrupt-program/1", NULL};
    struct scenario *s = r->scenario;
    int format;
    if (!reader_members(r, program, names) ||
        !reader_choice(r, program, "format", true, formats, "s7-interrupt-program/1", &format) ||
        !read_settings(r, program) || !read_outside(r, json_member(program, "outside")) ||
        !read_bodies(r, json_member(program, "bodies")))
        return false;
    if (s->random && (s->body_count > 0 || s->action_count > 0))
        return reader_fail(r, "x_soft_plc", program, "no bodies and nothing outside beside random");
    return true;
}

bool scenario_read(struct scenario *s, const char *file, int line, const char *text,
                   size_t length)
{
    struct reader r = {.scenario = s, .file = file};
    const char *expected = NULL;
    memset(s, 0, sizeof *s);
    struct json *program = json_read(text, length, &line, &expected);
    if (program == NULL) {
        snprintf(s->error, sizeof s->error, "%.100s:%d: expected %s", file, line, expected);
        return false;
    }
    bool ok = read_whole(&r, program);
    json_free(program);
    scenario_end(s);
    return ok;
}

void scenario_free(struct scenario *s)
{
    for (uint32_t i = 0; i < s->body_count; i++)
        free(s->bodies[i].steps);
    free(s->bodies);
    free(s->actions);
}

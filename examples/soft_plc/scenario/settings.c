/* The settings of a program: the header of its log, its duration, and those of this CPU alone,
 * in x_soft_plc. */
#include <stdlib.h>

#include "choices.h"
#include "reader.h"
#include "values.h"

/* A program can call itself without time passing, as an OB 80 that moves the clock. */
enum { SCENARIO_MAX_EVENTS = 1000000, DEFAULT_CYCLE_MS = 10, DEFAULT_BUFFER = 16 };

/* [T15-10, T15-11]: an event class for each OB from 123 on. */
static bool read_classes(struct reader *r, const struct json *header)
{
    static const char *const names[] = {"tod", "dint", "cyclic", "hardware", "startup", "cycle", NULL};
    static const int ranges[] = {S7CPU_MORE_TODS,     S7CPU_MORE_DINTS,    S7CPU_MORE_CYCLICS,
                                 S7CPU_MORE_HARDWARE, S7CPU_MORE_STARTUPS, S7CPU_MORE_CYCLES};
    struct s7cpu_config *c = &r->scenario->config.cpu;
    const struct json *map = json_member(header, "classes");
    int64_t number;
    int class;
    if (map == NULL)
        return true;
    if (map->kind != JSON_OBJECT)
        return reader_fail(r, "classes", map, "an object");
    for (const struct json *m = map->first; m != NULL; m = m->next) {
        if (!s7cpu_ob_exists(c->family, S7CPU_MORE) || !value_integer(m->name, 123, INT16_MAX, &number))
            return reader_fail(r, "classes", m, "OBs from 123 to 32767, on an S7-1500 only");
        if (!reader_choice(r, map, m->name, true, names, "an event class, such as tod", &class))
            return false;
        if (!s7cpu_add_ob(c, (int)number, ranges[class]))
            return reader_fail(r, "classes", m, "no more OBs of a class than the CPU has");
    }
    return true;
}

/* The default follows from the interval, which is not known [T15-66]. */
static bool cyclics_have_priority(struct reader *r, const struct json *header)
{
    const struct s7cpu_config *c = &r->scenario->config.cpu;
    for (int ob = S7CPU_MORE_CYCLICS; ob < S7CPU_MORE_HARDWARE; ob++)
        if (c->numbers[ob - S7CPU_MORE] != 0 && c->priority[ob] == 0)
            return reader_fail(r, "priority", header, "one for each cyclic OB from 123 on");
    return true;
}

static bool read_obs(struct reader *r, const struct json *header)
{
    const struct json *obs = json_member(header, "obs");
    struct s7cpu_config *c = &r->scenario->config.cpu;
    if (obs == NULL || obs->kind != JSON_LIST)
        return reader_fail(r, "obs", obs, "a list of OBs");
    for (const struct json *e = obs->first; e != NULL; e = e->next) {
        const bool is_number = e->kind == JSON_INTEGER && e->integer >= 1 && e->integer <= INT16_MAX;
        const int ob = is_number ? s7cpu_ob(c, (int)e->integer) : S7CPU_NONE;
        if (!s7cpu_ob_exists(c->family, ob))
            return reader_fail(r, "obs", e, "numbers of OBs of this CPU");
        if (c->loaded[ob])
            return reader_fail(r, "obs", e, "each OB once");
        c->loaded[ob] = true;
    }
    return c->loaded[1] || reader_fail(r, "obs", obs, "OB 1 among the loaded OBs");
}

static bool read_priority(struct reader *r, const struct json *header)
{
    struct s7cpu_config *c = &r->scenario->config.cpu;
    const struct json *map = json_member(header, "priority");
    if (map == NULL)
        return true;
    if (map->kind != JSON_OBJECT)
        return reader_fail(r, "priority", map, "an object");
    for (const struct json *m = map->first; m != NULL; m = m->next) {
        int ob = s7cpu_ob(c, atoi(m->name)), low, high;
        if (!s7cpu_class_range(c->family, ob, &low, &high))
            return reader_fail(r, "priority", m, "OBs whose class can be set on this CPU");
        if (m->kind != JSON_INTEGER || m->integer < low || m->integer > high)
            return reader_fail(r, "priority", m, "a class that this OB may have");
        c->priority[ob] = (int)m->integer;
    }
    return true;
}

static bool read_queue(struct reader *r, const struct json *object, struct s7cpu_queue *q)
{
    static const char *const names[] = {"events", "threshold", "overflow", NULL};
    int64_t events, threshold = 0;
    bool overflow = false;
    if (!reader_members(r, object, names) ||
        !reader_integer(r, object, "events", true, 1, 12, &events) ||
        !reader_integer(r, object, "threshold", false, 1, events, &threshold) ||
        !reader_truth(r, object, "overflow", &overflow))
        return false;
    *q = (struct s7cpu_queue){(int)events, (int)threshold,
                              json_member(object, "overflow") != NULL ? overflow : S7CPU_NONE};
    return true;
}

static bool read_queues(struct reader *r, const struct json *header)
{
    struct s7cpu_config *c = &r->scenario->config.cpu;
    const struct json *map = json_member(header, "queue");
    if (map != NULL && map->kind != JSON_OBJECT)
        return reader_fail(r, "queue", map, "an object");
    for (const struct json *m = map != NULL ? map->first : NULL; m != NULL; m = m->next) {
        const int ob = s7cpu_ob(c, atoi(m->name));
        if (!s7cpu_has_queue(c->family, ob))
            return reader_fail(r, "queue", m, "OBs that have the parameters of a queue");
        size_t length = reader_enter(r, "queue");
        reader_enter(r, m->name);
        if (!read_queue(r, m, &c->queue[ob]))
            return false;
        reader_leave(r, length);
    }
    return true;
}

static bool read_tod(struct reader *r, const struct json *object, struct s7cpu_step7 *t)
{
    static const char *const names[] = {"execution", "start", "active", "deselected", "local", NULL};
    static const char *const executions[] = {"none",   "once",    "minute", "hourly",       "daily",
                                             "weekly", "monthly", "yearly", "end_of_month", NULL};
    static const enum s7cpu_execution values[] = {
        S7CPU_NO_EXECUTION, S7CPU_ONCE,   S7CPU_EVERY_MINUTE, S7CPU_HOURLY,      S7CPU_DAILY,
        S7CPU_WEEKLY,       S7CPU_MONTHLY, S7CPU_YEARLY,      S7CPU_END_OF_MONTH};
    int execution = 0;
    t->start = S7CPU_NEVER;
    if (!reader_members(r, object, names) ||
        !reader_choice(r, object, "execution", false, executions, "an execution as in a log's header",
                       &execution) ||
        !reader_dt(r, object, "start", execution != 0, &t->start) ||
        !reader_truth(r, object, "active", &t->active) ||
        !reader_truth(r, object, "deselected", &t->deselected) ||
        !reader_truth(r, object, "local", &t->local))
        return false;
    if (t->local && !s7cpu_has_local_time(r->scenario->config.cpu.family))
        return reader_fail(r, "local", object, "local time on an S7-1500 only");
    t->execution = values[execution];
    if (t->deselected && json_member(object, "execution") == NULL)
        t->execution = S7CPU_NOT_CONFIGURED;
    if (t->start != S7CPU_NEVER)
        t->start -= t->start % S7CPU_MINUTE; /* [TINT-11] */
    if (t->execution == S7CPU_MONTHLY && s7cpu_date(t->start).day > 28)
        return reader_fail(r, "start", object, "a day from 1 to 28 with monthly");
    return true;
}

static bool read_step7(struct reader *r, const struct json *header)
{
    static const char *const names[] = {"tod", NULL};
    const struct json *step7 = json_member(header, "step7");
    if (step7 == NULL)
        return true;
    if (!reader_members(r, step7, names))
        return false;
    const struct json *tod = json_member(step7, "tod");
    for (const struct json *m = tod != NULL ? tod->first : NULL; m != NULL; m = m->next) {
        const int ob = s7cpu_ob(&r->scenario->config.cpu, atoi(m->name)), k = s7cpu_tod_index(ob);
        if (k < 0 || k >= S7CPU_TODS || s7cpu_tod_ob(k) != ob)
            return reader_fail(r, "step7.tod", m, "time-of-day interrupts");
        size_t length = reader_enter(r, "step7.tod");
        reader_enter(r, m->name);
        if (!read_tod(r, m, &r->scenario->config.cpu.step7[k]))
            return false;
        reader_leave(r, length);
    }
    return true;
}

static bool read_header(struct reader *r, const struct json *header)
{
    static const char *const names[] = {"cpu",      "obs",   "clock", "mode", "cycle",
                                        "priority", "step7", "zone",  "classes", "queue", NULL};
    static const char *const families[] = {"S7-300", "S7-400", "CPU 318", "S7-1500", NULL};
    static const char *const modes[] = {"STOP", "STARTUP", "RUN", NULL};
    static const enum s7cpu_mode values[] = {S7CPU_STOP, S7CPU_STARTUP, S7CPU_RUN};
    struct plc_config *c = &r->scenario->config;
    int family = 0, mode = 0;
    int64_t zone = 0;
    if (!reader_members(r, header, names) ||
        !reader_choice(r, header, "cpu", true, families, "S7-300, S7-400, CPU 318 or S7-1500",
                       &family))
        return false;
    c->cpu.family = (enum s7cpu_family)family;
    if (!read_classes(r, header) || !read_obs(r, header) || !reader_dt(r, header, "clock", true, &c->cpu.clock) ||
        !reader_choice(r, header, "mode", false, modes, "STOP, STARTUP or RUN", &mode) ||
        !reader_truth(r, header, "cycle", &c->log.cycle) ||
        !reader_integer(r, header, "zone", false, -720, 840, &zone))
        return false;
    c->cpu.mode = values[mode];
    c->cpu.zone = zone * S7CPU_MINUTE;
    if (zone != 0 && !s7cpu_has_local_time(c->cpu.family))
        return reader_fail(r, "zone", header, "a zone on an S7-1500 only");
    return read_priority(r, header) && cyclics_have_priority(r, header) && read_queues(r, header) &&
           read_step7(r, header);
}

static bool read_choices(struct reader *r, const struct json *own)
{
    const struct json *list = json_member(own, "choose");
    for (const struct json *e = list != NULL ? list->first : NULL; e != NULL; e = e->next)
        if (e->kind != JSON_STRING || !choice_set(&r->scenario->config.cpu.choices, e->text))
            return reader_fail(r, "choose", e, "choices that --choose help lists, as AMB-34=b");
    return true;
}

static bool read_random(struct reader *r, const struct json *own)
{
    static const char *const names[] = {"seed", "events", NULL};
    const struct json *random = json_member(own, "random");
    int64_t seed, events;
    if (random == NULL)
        return true;
    size_t length = reader_enter(r, "random");
    if (!reader_members(r, random, names) ||
        !reader_integer(r, random, "seed", true, 0, INT64_MAX, &seed) ||
        !reader_integer(r, random, "events", true, 1, INT64_MAX, &events))
        return false;
    reader_leave(r, length);
    r->scenario->random = true;
    r->scenario->seed = (uint64_t)seed;
    r->scenario->config.max_events = (uint64_t)events;
    return true;
}

static bool read_own(struct reader *r, const struct json *own)
{
    static const char *const names[] = {"latency_ms", "cycle_ms", "diag", "buffer",
                                        "choose",     "random",   NULL};
    struct scenario *s = r->scenario;
    int64_t latency = -1, buffer = DEFAULT_BUFFER;
    if (!reader_members(r, own, names) ||
        !reader_integer(r, own, "latency_ms", false, 0, 60000, &latency) ||
        !reader_integer(r, own, "cycle_ms", false, 1, S7CPU_DAY, &s->config.cycle_ms) ||
        !reader_truth(r, own, "diag", &s->config.log.diag) ||
        !reader_integer(r, own, "buffer", false, 1, 64, &buffer) || !read_choices(r, own) ||
        !read_random(r, own))
        return false;
    s->latency_given = latency >= 0;
    s->config.log.latency_ms = (int)latency;
    s->config.cpu.buffer = (int)buffer;
    return true;
}

bool read_settings(struct reader *r, const struct json *program)
{
    struct plc_config *c = &r->scenario->config;
    const struct json *header = json_member(program, "header");
    const struct json *own = json_member(program, "x_soft_plc");
    c->cycle_ms = DEFAULT_CYCLE_MS;
    c->cpu.buffer = DEFAULT_BUFFER;
    c->max_events = SCENARIO_MAX_EVENTS;
    if (header == NULL)
        return reader_fail(r, "header", program, "this field");
    size_t length = reader_enter(r, "header");
    if (!read_header(r, header))
        return false;
    reader_leave(r, length);
    length = reader_enter(r, "x_soft_plc");
    if (own != NULL && !read_own(r, own))
        return false;
    reader_leave(r, length);
    return reader_integer(r, program, "duration", true, 1, S7CPU_LAST + 1, &c->duration);
}

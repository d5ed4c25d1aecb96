/* Bodies of OBs and events from outside. */
#include <string.h>

#include "reader.h"
#include "values.h"

/* A reading of the clock, or by how much it moves. */
static bool read_clock(struct reader *r, const struct json *object, bool *moves, int64_t *ms)
{
    *moves = json_member(object, "by") != NULL;
    if (*moves && json_member(object, "to") != NULL)
        return reader_fail(r, NULL, object, "one of to and by");
    return *moves ? reader_integer(r, object, "by", true, -S7CPU_LAST, S7CPU_LAST, ms)
                  : reader_dt(r, object, "to", true, ms);
}

/* Local time is set by daylight saving, or with another zone. */
static bool read_zone(struct reader *r, const struct json *object, bool *daylight, int64_t *ms)
{
    static const char *const reasons[] = {"zone", "daylight", NULL};
    int64_t minutes;
    int reason;
    if (!s7cpu_has_local_time(r->scenario->config.cpu.family))
        return reader_fail(r, "event", object, "a zone on an S7-1500 only");
    if (!reader_integer(r, object, "zone", true, -720, 840, &minutes) ||
        !reader_choice(r, object, "reason", true, reasons, "zone or daylight", &reason))
        return false;
    *ms = minutes * S7CPU_MINUTE;
    *daylight = reason == 1;
    return true;
}

/* OB_NR of an SFC: any INT, right or wrong. */
static bool ob_nr(struct reader *r, const struct json *object, struct step *step)
{
    int64_t n;
    if (!reader_integer(r, object, "ob", true, INT16_MIN, INT16_MAX, &n))
        return false;
    step->ob = (int)n;
    return true;
}

static bool set_operands(struct reader *r, const struct json *o, struct step *step)
{
    const struct json *sdt = json_member(o, "sdt");
    if (!ob_nr(r, o, step))
        return false;
    if (sdt == NULL || sdt->kind != JSON_STRING || !value_civil(sdt->text, &step->sdt))
        return reader_fail(r, "sdt", sdt, "a date and time");
    return reader_word(r, o, "period", true, 0xFFFF, &step->period);
}

static bool call_set_tint(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"call", "ob", "sdt", "period", NULL};
    return reader_members(r, o, names) && set_operands(r, o, step);
}

static bool call_set_tintl(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"call", "ob", "sdt", "local", "period", "activate", NULL};
    if (!s7cpu_has_local_time(r->scenario->config.cpu.family))
        return reader_fail(r, "call", o, "SET_TINTL on an S7-1500 only");
    return reader_members(r, o, names) && set_operands(r, o, step) &&
           reader_truth(r, o, "local", &step->local) &&
           reader_truth(r, o, "activate", &step->activate);
}

static bool call_srt_dint(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"call", "ob", "dtime", "sign", NULL};
    const struct json *dtime = json_member(o, "dtime");
    if (!reader_members(r, o, names) || !ob_nr(r, o, step) ||
        !reader_word(r, o, "sign", true, 0xFFFF, &step->sign))
        return false;
    if (dtime != NULL && dtime->kind == JSON_STRING && value_time(dtime->text, &step->ms))
        return true;
    return reader_integer(r, o, "dtime", true, INT32_MIN, INT32_MAX, &step->ms);
}

static bool call_irt(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"call", "mode", "ob", NULL};
    return reader_members(r, o, names) && reader_word(r, o, "mode", true, 0xFF, &step->mode) &&
           ob_nr(r, o, step);
}

static bool call_with_ob(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"call", "ob", NULL};
    return reader_members(r, o, names) && ob_nr(r, o, step);
}

static bool call_plain(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"call", NULL};
    (void)step;
    return reader_members(r, o, names);
}

static bool read_call(struct reader *r, const struct json *o, struct step *step)
{
    static const struct {
        const char *name;
        enum step_kind kind;
        bool (*read)(struct reader *r, const struct json *o, struct step *step);
    } calls[] = {
        {"SET_TINT", STEP_SET_TINT, call_set_tint}, {"CAN_TINT", STEP_CAN_TINT, call_with_ob},
        {"ACT_TINT", STEP_ACT_TINT, call_with_ob},  {"QRY_TINT", STEP_QRY_TINT, call_with_ob},
        {"SRT_DINT", STEP_SRT_DINT, call_srt_dint}, {"CAN_DINT", STEP_CAN_DINT, call_with_ob},
        {"QRY_DINT", STEP_QRY_DINT, call_with_ob},  {"DIS_IRT", STEP_DIS_IRT, call_irt},
        {"EN_IRT", STEP_EN_IRT, call_irt},          {"DIS_AIRT", STEP_DIS_AIRT, call_plain},
        {"EN_AIRT", STEP_EN_AIRT, call_plain},      {"SET_TINTL", STEP_SET_TINTL, call_set_tintl},
    };
    const struct json *name = json_member(o, "call");
    for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++)
        if (name->kind == JSON_STRING && strcmp(name->text, calls[i].name) == 0) {
            step->kind = calls[i].kind;
            return calls[i].read(r, o, step);
        }
    return reader_fail(r, "call", name, "the name of an SFC");
}

/* SFC 0, SFC 51 and SET_TIMEZONE [T15-103]. */
static bool read_own_event(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"event", "to", "by", "ob", "zone", "reason", NULL};
    static const char *const events[] = {"clock", "state", "zone", NULL};
    int event;
    bool moves;
    if (!reader_members(r, o, names) ||
        !reader_choice(r, o, "event", true, events, "clock, state or zone", &event))
        return false;
    step->kind = STEP_STATE;
    if (event == 1)
        return reader_ob(r, o, &step->ob);
    step->kind = STEP_SET_ZONE;
    if (event == 2)
        return read_zone(r, o, &step->daylight, &step->ms);
    if (!read_clock(r, o, &moves, &step->ms))
        return false;
    step->kind = moves ? STEP_MOVE_CLOCK : STEP_SET_CLOCK;
    return true;
}

static bool read_step(struct reader *r, const struct json *o, struct step *step)
{
    static const char *const names[] = {"wait", NULL};
    if (o->kind != JSON_OBJECT)
        return reader_fail(r, NULL, o, "an object");
    if (json_member(o, "call") != NULL)
        return read_call(r, o, step);
    if (json_member(o, "event") != NULL)
        return read_own_event(r, o, step);
    step->kind = STEP_BUSY;
    if (json_member(o, "wait") == NULL)
        return reader_fail(r, NULL, o, "a step with call, wait, event or end");
    return reader_members(r, o, names) &&
           reader_integer(r, o, "wait", true, 0, S7CPU_LAST + 1, &step->ms);
}

static bool is_end(const struct json *step)
{
    const struct json *end = step->kind == JSON_OBJECT ? json_member(step, "end") : NULL;
    return end != NULL && end->kind == JSON_TRUE;
}

static bool read_steps(struct reader *r, const struct json *list, struct body *b)
{
    int place = 1;
    if (list == NULL || list->kind != JSON_LIST)
        return reader_fail(r, "steps", list, "a list");
    size_t length = reader_enter(r, "steps");
    for (const struct json *e = list->first; e != NULL; e = e->next, place++) {
        struct step step = {0};
        if (is_end(e)) {
            if (e->next != NULL)
                return reader_fail(r, NULL, e, "end as the last step");
            continue;
        }
        size_t inner = reader_enter_element(r, place);
        if (!read_step(r, e, &step))
            return false;
        reader_leave(r, inner);
        b->steps = reader_grow(b->steps, b->count, &b->room, sizeof b->steps[0]);
        b->steps[b->count++] = step;
    }
    reader_leave(r, length);
    return true;
}

static bool read_body(struct reader *r, const struct json *o, struct body *b)
{
    static const char *const names[] = {"ob", "run", "steps", NULL};
    const struct scenario *s = r->scenario;
    int64_t run = 0;
    if (!reader_members(r, o, names) || !reader_ob(r, o, &b->ob) ||
        !reader_integer(r, o, "run", false, 1, INT32_MAX, &run))
        return false;
    b->run = (uint32_t)run;
    for (uint32_t i = 0; i + 1 < s->body_count; i++)
        if (s->bodies[i].ob == b->ob && s->bodies[i].run == b->run)
            return reader_fail(r, NULL, o, "one body for each OB and run");
    return read_steps(r, json_member(o, "steps"), b);
}

bool read_bodies(struct reader *r, const struct json *list)
{
    struct scenario *s = r->scenario;
    int place = 1;
    if (list == NULL || list->kind != JSON_LIST)
        return reader_fail(r, "bodies", list, "a list");
    size_t length = reader_enter(r, "bodies");
    for (const struct json *e = list->first; e != NULL; e = e->next, place++) {
        size_t inner = reader_enter_element(r, place);
        s->bodies = reader_grow(s->bodies, s->body_count, &s->body_room, sizeof s->bodies[0]);
        s->bodies[s->body_count++] = (struct body){0};
        if (!read_body(r, e, &s->bodies[s->body_count - 1]))
            return false;
        reader_leave(r, inner);
    }
    reader_leave(r, length);
    return true;
}

/* Fault ids that the rules themselves make have no line from outside. */
static bool flt_id_from_outside(int ob, int id)
{
    if (ob == 80)
        return id == 0x01 || id == 0x03 || (id >= 0x08 && id <= 0x0B);
    return id >= 0xA3;
}

static bool read_interrupt(struct reader *r, const struct json *o, struct action *a)
{
    a->kind = ACTION_INTERRUPT;
    if (!reader_ob(r, o, &a->ob))
        return false;
    if (!s7cpu_ob_from_outside(a->ob))
        return reader_fail(r, "ob", o, "an OB with a start event from outside");
    if (a->ob != 80 && a->ob != 85)
        return json_member(o, "flt_id") == NULL ||
               reader_fail(r, "flt_id", o, "this field for OB 80 and 85 only");
    if (!reader_word(r, o, "flt_id", true, 0xFF, &a->flt_id))
        return false;
    return flt_id_from_outside(a->ob, a->flt_id) ||
           reader_fail(r, "flt_id", o, "a fault id that no rule makes, as 16#01 for OB 80");
}

static bool read_block(struct reader *r, const struct json *o, struct action *a)
{
    return reader_ob(r, o, &a->ob) && (a->ob != 1 || reader_fail(r, "ob", o, "another OB than OB 1"));
}

static bool read_action(struct reader *r, const struct json *o, struct action *a)
{
    static const char *const events[] = {"clock", "interrupt", "stop",   "restart", "hold",
                                         "release", "load",    "delete", "state",   "zone", NULL};
    static const char *const types[] = {"warm", "cold", "hot", NULL};
    int event, type;
    bool moves;
    if (!reader_choice(r, o, "event", true, events, "an event from outside", &event))
        return false;
    switch (event) {
    case 0:
        if (!read_clock(r, o, &moves, &a->ms))
            return false;
        a->kind = moves ? ACTION_MOVE_CLOCK : ACTION_SET_CLOCK;
        return true;
    case 1:
        return read_interrupt(r, o, a);
    case 3:
        if (!reader_choice(r, o, "type", true, types, "warm, cold or hot", &type))
            return false;
        a->kind = (enum action_kind)(ACTION_RESTART_WARM + type);
        return s7cpu_restart_exists(r->scenario->config.cpu.family, (enum s7cpu_restart)type) ||
               reader_fail(r, "type", o, "a restart that this CPU has");
    case 6:
    case 7:
        a->kind = event == 6 ? ACTION_LOAD : ACTION_DELETE;
        return read_block(r, o, a);
    case 8:
        a->kind = ACTION_STATE;
        return reader_ob(r, o, &a->ob);
    case 9:
        a->kind = ACTION_SET_ZONE;
        return read_zone(r, o, &a->daylight, &a->ms);
    default:
        a->kind = event == 2 ? ACTION_STOP : event == 4 ? ACTION_HOLD : ACTION_RELEASE;
        return true;
    }
}

bool read_outside(struct reader *r, const struct json *list)
{
    static const char *const names[] = {"after", "every",  "event", "ob",
                                        "to",    "flt_id", "by",    "type", "zone", "reason", NULL};
    struct scenario *s = r->scenario;
    int place = 1;
    if (list != NULL && list->kind != JSON_LIST)
        return reader_fail(r, "outside", list, "a list");
    size_t length = reader_enter(r, "outside");
    for (const struct json *e = list != NULL ? list->first : NULL; e != NULL; e = e->next, place++) {
        struct timed_action t = {.place = place, .action.flt_id = S7CPU_NONE};
        size_t inner = reader_enter_element(r, place);
        if (!reader_members(r, e, names) ||
            !reader_integer(r, e, "after", true, 0, S7CPU_LAST + 1, &t.up) ||
            !reader_integer(r, e, "every", false, 1, S7CPU_LAST + 1, &t.every) ||
            !read_action(r, e, &t.action))
            return false;
        reader_leave(r, inner);
        s->actions = reader_grow(s->actions, s->action_count, &s->action_room, sizeof s->actions[0]);
        s->actions[s->action_count++] = t;
    }
    reader_leave(r, length);
    return true;
}

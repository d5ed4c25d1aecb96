/* Bodies of OBs and actions from outside. */
#include <string.h>

#include "parser.h"

bool parse_body_begin(struct parser *p)
{
    struct scenario *s = p->scenario;
    struct body b = {0};
    int next = 2;
    int64_t run;
    if (!parse_ob(p, "ob", 1, &b.ob))
        return false;
    const char *w = parser_word(p, next);
    if (w != NULL && strcmp(w, "run") == 0) {
        w = parser_word(p, next + 1);
        if (w == NULL || !word_int(w, 1, UINT32_MAX, &run))
            return parser_fail(p, "run", "a number from 1", w);
        b.run = (uint32_t)run;
        next += 2;
    }
    w = parser_word(p, next);
    if (w == NULL || strcmp(w, "{") != 0)
        return parser_fail(p, "ob", "run and a number, or {", w);
    if (!parse_word_count(p, "ob", next + 1, "the end of the line after {"))
        return false;
    for (uint32_t i = 0; i < s->body_count; i++)
        if (s->bodies[i].ob == b.ob && s->bodies[i].run == b.run)
            return parser_fail(p, "ob", "one body for each OB and run", parser_word(p, 1));
    s->bodies = reader_grow(s->bodies, s->body_count, &s->body_room, sizeof s->bodies[0]);
    p->body = (int)s->body_count;
    s->bodies[s->body_count++] = b;
    p->body_line = p->line;
    return true;
}

/* A reading of the clock, or by how much it moves: +1h, -30min. */
static bool clock_change(struct parser *p, const char *field, int word, bool *moves, int64_t *ms)
{
    const char *s = parser_word(p, word);
    *moves = s != NULL && (*s == '+' || *s == '-');
    if (s == NULL || !(*moves ? word_duration(s + 1, ms) : word_dt(s, ms)))
        return parser_fail(p, field, "a date and time, or + or - and a duration", s);
    if (*moves && *s == '-')
        *ms = -*ms;
    return true;
}

/* OB_NR of an SFC: any INT, right or wrong. */
static bool ob_nr(struct parser *p, const char *field, int word, struct step *step)
{
    const char *s = parser_word(p, word);
    int64_t n;
    if (s == NULL || !word_int(s, INT16_MIN, INT16_MAX, &n))
        return parser_fail(p, field, "OB_NR, a number from -32768 to 32767", s);
    step->ob = (int)n;
    return true;
}

static bool step_set_tint(struct parser *p, const char *name, struct step *step)
{
    const char *s = parser_word(p, 2);
    if (!ob_nr(p, name, 1, step))
        return false;
    if (s == NULL || !word_civil(s, &step->sdt))
        return parser_fail(p, name, "SDT, a date and time", s);
    s = parser_word(p, 3);
    if (s == NULL || !word_hex(s, 0xFFFF, &step->period))
        return parser_fail(p, name, "PERIOD, a word as 16#0201", s);
    return parse_word_count(p, name, 4, "three arguments");
}

static bool step_srt_dint(struct parser *p, const char *name, struct step *step)
{
    const char *s = parser_word(p, 2);
    if (!ob_nr(p, name, 1, step))
        return false;
    if (s == NULL || !word_time(s, &step->ms))
        return parser_fail(p, name, "DTIME, as 500ms, T#1s500ms or -5", s);
    s = parser_word(p, 3);
    if (s == NULL || !word_hex(s, 0xFFFF, &step->sign))
        return parser_fail(p, name, "SIGN, a word as 16#0007", s);
    return parse_word_count(p, name, 4, "three arguments");
}

static bool step_irt(struct parser *p, const char *name, struct step *step)
{
    const char *s = parser_word(p, 1);
    if (s == NULL || !word_hex(s, 0xFF, &step->mode))
        return parser_fail(p, name, "MODE, a byte as B#16#80", s);
    return ob_nr(p, name, 2, step) && parse_word_count(p, name, 3, "two arguments");
}

static bool step_with_ob(struct parser *p, const char *name, struct step *step)
{
    return ob_nr(p, name, 1, step) && parse_word_count(p, name, 2, "one argument");
}

static bool step_plain(struct parser *p, const char *name, struct step *step)
{
    (void)step;
    return parse_word_count(p, name, 1, "no argument");
}

static bool step_busy(struct parser *p, const char *name, struct step *step)
{
    const char *s = parser_word(p, 1);
    if (s == NULL || !word_duration(s, &step->ms))
        return parser_fail(p, name, "a duration, as 50ms", s);
    return parse_word_count(p, name, 2, "one duration");
}

static bool step_state(struct parser *p, const char *name, struct step *step)
{
    return parse_ob(p, name, 1, &step->ob) && parse_word_count(p, name, 2, "one OB");
}

static bool step_set_clock(struct parser *p, const char *name, struct step *step)
{
    bool moves;
    if (!clock_change(p, name, 1, &moves, &step->ms))
        return false;
    if (moves)
        step->kind = STEP_MOVE_CLOCK;
    return parse_word_count(p, name, 2, "one value");
}

bool parse_step(struct parser *p)
{
    static const struct {
        const char *name;
        enum step_kind kind;
        bool (*parse)(struct parser *p, const char *name, struct step *step);
    } steps[] = {
        {"busy", STEP_BUSY, step_busy},
        {"SET_TINT", STEP_SET_TINT, step_set_tint},
        {"CAN_TINT", STEP_CAN_TINT, step_with_ob},
        {"ACT_TINT", STEP_ACT_TINT, step_with_ob},
        {"QRY_TINT", STEP_QRY_TINT, step_with_ob},
        {"SRT_DINT", STEP_SRT_DINT, step_srt_dint},
        {"CAN_DINT", STEP_CAN_DINT, step_with_ob},
        {"QRY_DINT", STEP_QRY_DINT, step_with_ob},
        {"DIS_IRT", STEP_DIS_IRT, step_irt},
        {"EN_IRT", STEP_EN_IRT, step_irt},
        {"DIS_AIRT", STEP_DIS_AIRT, step_plain},
        {"EN_AIRT", STEP_EN_AIRT, step_plain},
        {"set_clock", STEP_SET_CLOCK, step_set_clock},
        {"state", STEP_STATE, step_state},
    };
    struct body *b = &p->scenario->bodies[p->body];
    for (unsigned i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        struct step step = {.kind = steps[i].kind};
        if (strcmp(steps[i].name, p->words.word[0]) != 0)
            continue;
        if (!steps[i].parse(p, steps[i].name, &step))
            return false;
        b->steps = reader_grow(b->steps, b->count, &b->room, sizeof b->steps[0]);
        b->steps[b->count++] = step;
        return true;
    }
    return parser_fail(p, p->words.word[0], "an instruction or }", NULL);
}

/* Fault ids that the rules themselves make have no line from outside. */
static bool flt_id_from_outside(int ob, int id)
{
    if (ob == 80)
        return id == 0x01 || id == 0x03 || (id >= 0x08 && id <= 0x0B);
    return id >= 0xA3;
}

static bool parse_interrupt(struct parser *p, int word, struct action *a)
{
    const char *s = parser_word(p, word + 1);
    if (!parse_ob(p, "interrupt", word, &a->ob))
        return false;
    if (!s7cpu_ob_from_outside(a->ob))
        return parser_fail(p, "interrupt", "an OB with a start event from outside",
                           parser_word(p, word));
    if (a->ob != 80 && a->ob != 85)
        return parse_word_count(p, "interrupt", word + 1, "one OB");
    if (s == NULL || !word_hex(s, 0xFF, &a->flt_id) || !flt_id_from_outside(a->ob, a->flt_id))
        return parser_fail(p, "interrupt", "a fault id that no rule makes, as 16#01 for OB 80", s);
    return parse_word_count(p, "interrupt", word + 2, "an OB and a fault id");
}

static bool parse_restart(struct parser *p, int word, struct action *a)
{
    const char *s = parser_word(p, word);
    if (s == NULL || (strcmp(s, "warm") != 0 && strcmp(s, "cold") != 0))
        return parser_fail(p, "restart", "warm or cold", s);
    a->kind = strcmp(s, "warm") == 0 ? ACTION_RESTART_WARM : ACTION_RESTART_COLD;
    return parse_word_count(p, "restart", word + 1, "the end of the line");
}

static bool parse_block(struct parser *p, const char *name, int word, struct action *a)
{
    if (!parse_ob(p, name, word, &a->ob))
        return false;
    if (a->ob == 1)
        return parser_fail(p, name, "another OB than OB 1", NULL);
    return parse_word_count(p, name, word + 1, "one OB");
}

static bool parse_action(struct parser *p, int word, struct action *a)
{
    const char *name = parser_word(p, word);
    bool moves;
    *a = (struct action){.flt_id = S7CPU_NONE};
    if (name == NULL)
        return parser_fail(p, p->words.word[0], "a time and an action", NULL);
    if (strcmp(name, "clock") == 0) {
        if (!clock_change(p, name, word + 1, &moves, &a->ms))
            return false;
        a->kind = moves ? ACTION_MOVE_CLOCK : ACTION_SET_CLOCK;
        return parse_word_count(p, name, word + 2, "one value");
    }
    if (strcmp(name, "interrupt") == 0) {
        a->kind = ACTION_INTERRUPT;
        return parse_interrupt(p, word + 1, a);
    }
    if (strcmp(name, "state") == 0) {
        a->kind = ACTION_STATE;
        return parse_ob(p, name, word + 1, &a->ob) &&
               parse_word_count(p, name, word + 2, "one OB");
    }
    if (strcmp(name, "restart") == 0)
        return parse_restart(p, word + 1, a);
    if (strcmp(name, "load") == 0 || strcmp(name, "delete") == 0) {
        a->kind = strcmp(name, "load") == 0 ? ACTION_LOAD : ACTION_DELETE;
        return parse_block(p, name, word + 1, a);
    }
    if (strcmp(name, "stop") == 0)
        a->kind = ACTION_STOP;
    else if (strcmp(name, "hold") == 0)
        a->kind = ACTION_HOLD;
    else if (strcmp(name, "release") == 0)
        a->kind = ACTION_RELEASE;
    else
        return parser_fail(p, "action",
                           "clock, interrupt, stop, restart, hold, release, load, delete, state", name);
    return parse_word_count(p, name, word + 1, "the end of the line");
}

static void add_action(struct parser *p, const struct timed_action *t)
{
    struct scenario *s = p->scenario;
    s->actions = reader_grow(s->actions, s->action_count, &s->action_room, sizeof s->actions[0]);
    s->actions[s->action_count++] = *t;
}

bool parse_at(struct parser *p)
{
    const char *s = parser_word(p, 1);
    struct timed_action t = {.place = p->line};
    int64_t when;
    if (s != NULL && *s == '+' && word_duration(s + 1, &t.up))
        ;
    else if (s != NULL && word_dt(s, &when) && p->scenario->config.cpu.clock != 0 &&
             when >= p->scenario->config.cpu.clock)
        t.up = when - p->scenario->config.cpu.clock; /* as if the clock were never set */
    else
        return parser_fail(p, "at", "+ and a duration, or a time from the setting clock on", s);
    if (!parse_action(p, 2, &t.action))
        return false;
    add_action(p, &t);
    return true;
}

bool parse_every(struct parser *p)
{
    const char *s = parser_word(p, 1);
    struct timed_action t = {.place = p->line};
    if (s == NULL || !word_duration(s, &t.every) || t.every < 1)
        return parser_fail(p, "every", "a duration of 1ms or more", s);
    t.up = t.every;
    if (!parse_action(p, 2, &t.action))
        return false;
    add_action(p, &t);
    return true;
}

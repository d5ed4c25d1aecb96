/* A scenario as the program of the CPU. */
#include "reader.h"

static const struct body *find_body(const struct scenario *s, int ob, uint32_t run)
{
    for (uint32_t i = 0; i < s->body_count; i++)
        if (s->bodies[i].ob == ob && s->bodies[i].run == run)
            return &s->bodies[i];
    return NULL;
}

static void begin(struct program *p, const struct s7cpu *cpu, struct activation *a)
{
    const struct scenario *s = (const struct scenario *)p;
    (void)cpu;
    a->body = find_body(s, a->ob, a->run);
    if (a->body == NULL)
        a->body = find_body(s, a->ob, 0);
}

static bool next(struct program *p, const struct s7cpu *cpu, struct activation *a,
                 struct step *step)
{
    const struct body *b = a->body;
    (void)p;
    (void)cpu;
    if (b == NULL || a->step == b->count)
        return false;
    *step = b->steps[a->step++];
    return true;
}

static bool idle(struct program *p, const struct s7cpu *cpu)
{
    const struct scenario *s = (const struct scenario *)p;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const struct body *b = &s->bodies[i];
        if (s7cpu_ob_is_cycle(b->ob) && b->count > 0 &&
            (b->run == 0 || b->run > s7cpu_runs(cpu, b->ob)))
            return false;
    }
    return true;
}

static int64_t action_time(struct program *p)
{
    const struct scenario *s = (const struct scenario *)p;
    return s->action_next < s->action_count ? s->actions[s->action_next].up : INT64_MAX;
}

static bool take_action(struct program *p, const struct s7cpu *cpu, struct action *action)
{
    struct scenario *s = (struct scenario *)p;
    struct timed_action t = s->actions[s->action_next];
    (void)cpu;
    *action = t.action;
    if (t.every == 0) {
        s->action_next++;
        return true;
    }
    /* It comes again: move it behind everything that comes before that. */
    t.up += t.every;
    uint32_t i = s->action_next;
    for (; i + 1 < s->action_count && s->actions[i + 1].up <= t.up; i++)
        s->actions[i] = s->actions[i + 1];
    s->actions[i] = t;
    return true;
}

void scenario_program(struct scenario *s)
{
    s->program = (struct program){
        .begin = begin,
        .next = next,
        .idle = idle,
        .action_time = action_time,
        .take_action = take_action,
    };
}

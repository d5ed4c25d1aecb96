#include "random_program.h"

#include <stddef.h>

/* xorshift64*: small, fast and the same on every machine. */
static uint64_t draw(struct random_program *r)
{
    r->state ^= r->state >> 12;
    r->state ^= r->state << 25;
    r->state ^= r->state >> 27;
    return r->state * UINT64_C(2685821657736338717);
}

/* 0 to n-1 */
static int below(struct random_program *r, int n)
{
    return (int)((draw(r) >> 33) % (uint64_t)n);
}

static int between(struct random_program *r, int low, int high)
{
    return low + below(r, high - low + 1);
}

static bool percent(struct random_program *r, int n)
{
    return below(r, 100) < n;
}

static bool is_s7_1500(const struct s7cpu_config *c)
{
    return c->family == S7CPU_S7_1500;
}

/* The number of one of the first two OBs from 123 on of a class; of another one where there is none. */
static int draw_created(struct random_program *r, const struct s7cpu_config *c, int range, int other)
{
    const int number = c->numbers[range - S7CPU_MORE + below(r, 2)];
    return number != 0 ? number : other;
}

/* Mostly OB 10 to 13, so that calls meet each other; now and then a number that is wrong. */
static int draw_ob_nr(struct random_program *r, const struct s7cpu_config *c)
{
    static const int wrong[] = {-1, 0, 1, 9, 18, 20, 80, 99};
    if (percent(r, 4))
        return wrong[below(r, 8)];
    if (c->numbers[0] != 0 && percent(r, 25))
        return draw_created(r, c, S7CPU_MORE_TODS, 124);
    return percent(r, 75) ? between(r, 10, 12) : between(r, 10, 17);
}

static int draw_period(struct random_program *r)
{
    static const int codes[] = {0x0000, 0x0000, 0x0201, 0x0201, 0x0201, 0x0401, 0x0401,
                                0x1001, 0x1201, 0x1202, 0x1401, 0x1801, 0x2001};
    static const int wrong[] = {0x0001, 0x0200, 0x0400, 0x1002, 0x2000, 0xFFFF};
    return percent(r, 4) ? wrong[below(r, 6)] : codes[below(r, 13)];
}

/* Time-delay interrupts: right operands mostly, with delays that meet each other and OB 1's. */
static int draw_dint_ob_nr(struct random_program *r, const struct s7cpu_config *c)
{
    static const int wrong[] = {-20, 0, 2, 19, 24, 10, 35, 85};
    if (percent(r, 4))
        return wrong[below(r, 8)];
    if (!is_s7_1500(c))
        return between(r, 20, 23);
    return percent(r, 75) ? between(r, 20, 23) : draw_created(r, c, S7CPU_MORE_DINTS, 20);
}

static int64_t draw_dtime(struct random_program *r)
{
    static const int edges[] = {0, -1, -5, 60001, INT32_MAX, INT32_MIN, 1, 60000};
    if (percent(r, 8))
        return edges[below(r, 8)];
    return percent(r, 60) ? between(r, 1, 400) : between(r, 1, 60000);
}

/* MODE and OB_NR of SFC 39 and 40. Single OBs mostly, as a block for all hides everything. */
static void draw_irt(struct random_program *r, const struct s7cpu_config *c, struct step *step)
{
    static const int modes[] = {0x02, 0x82, 0x02, 0x82, 0x02, 0x01, 0x81, 0x00, 0x80};
    static const int wrong_modes[] = {0x03, 0x7F, 0x83, 0xFF};
    static const int classes[] = {10, 20, 30, 40, 50, 60, 70, 80};
    static const int wrong_obs[] = {-1, 0, 1, 15, 19, 61, 73, 88, 90, 100, 121, 99};
    static const int obs[] = {10, 11, 12, 20, 21, 35, 40, 55, 60, 70, 72, 80, 80, 85, 85, 82};
    static const int ranges[] = {S7CPU_MORE_TODS, S7CPU_MORE_DINTS, S7CPU_MORE_CYCLICS,
                                 S7CPU_MORE_HARDWARE};
    step->mode = percent(r, 5) ? wrong_modes[below(r, 4)] : modes[below(r, 9)];
    if (step->kind == STEP_EN_IRT && percent(r, 95))
        step->mode = percent(r, 50) ? 0 : step->mode & 0x0F;
    if (percent(r, 4))
        step->ob = wrong_obs[below(r, 12)];
    else if ((step->mode & 0x0F) == 1)
        step->ob = classes[below(r, 8)];
    else if ((step->mode & 0x0F) != 0 || percent(r, 10))
        step->ob = obs[below(r, 16)];
    if (is_s7_1500(c) && (step->mode & 0x0F) == 2 && percent(r, 25))
        step->ob = draw_created(r, c, ranges[below(r, 4)], step->ob);
}

static int64_t clamp(int64_t t)
{
    const int64_t margin = 400 * S7CPU_DAY;
    return t < margin ? margin : t > S7CPU_LAST - margin ? S7CPU_LAST - margin : t;
}

static void draw_sdt(struct random_program *r, int64_t now, int period, struct s7cpu_date *c)
{
    int64_t t = now;
    if (period == 0 && percent(r, 80)) /* a one-shot interrupt that is not past */
        t += between(r, 1, 2) * S7CPU_MINUTE;
    else if (percent(r, 80))
        t += between(r, -2, 3) * S7CPU_MINUTE;
    else
        t += between(r, -400, 400) * S7CPU_DAY;
    *c = s7cpu_date(clamp(t));
    if (percent(r, 60))
        c->second = c->ms = 0;
    switch (below(r, 40)) {
    case 0:
        c->month = 2;
        c->day = between(r, 28, 31);
        break;
    case 1:
        c->year = percent(r, 50) ? 1989 : 2090;
        break;
    case 2:
        c->month = between(r, 0, 13);
        break;
    case 3:
        c->day = between(r, 29, 31);
        break;
    case 4:
        c->second = between(r, 60, 99);
        break;
    default:
        break;
    }
}

/* A reading in front of an instant that calendars get wrong. */
static int64_t draw_instant(struct random_program *r)
{
    static const int years[] = {1999, 2000, 2026, 2027, 2028, 2087, 2088};
    static const struct {
        int month, day;
    } days[] = {{2, 28}, {2, 28}, {12, 31}, {4, 30}, {3, 31}, {1, 1}};
    int i = below(r, 6);
    struct s7cpu_date c = {.year = years[below(r, 7)], .month = days[i].month, .day = days[i].day,
                      .hour = 23, .minute = between(r, 56, 59), .second = below(r, 60)};
    return s7cpu_ms(&c);
}

static int64_t draw_move(struct random_program *r)
{
    int64_t by = between(r, 1, 300) * INT64_C(1000);
    switch (below(r, 6)) {
    case 0:
        by = between(r, 1, 48) * S7CPU_HOUR;
        break;
    case 1:
        by = between(r, 1, 60) * S7CPU_DAY;
        break;
    default:
        break;
    }
    return percent(r, 50) ? by : -by;
}

static void draw_clock_change(struct random_program *r, const struct s7cpu *cpu, int64_t *to)
{
    if (percent(r, 15)) {
        *to = draw_instant(r);
        return;
    }
    int64_t by = draw_move(r);
    if (is_s7_1500(&cpu->config) && percent(r, 60)) /* around its 20 s [T15-90 to T15-95] */
        by = between(r, -25, 25) * INT64_C(1000);
    int64_t t = s7cpu_clock(cpu) + by;
    *to = clamp(t - t % 1000); /* [CLK-17] */
}

/* In place of a change of the clock local time moves, where starts go by it [T15-96 to T15-98, T15-103]. */
static bool draw_zone(struct random_program *r, const struct s7cpu *cpu, bool *daylight, int64_t *to)
{
    if (cpu->config.zone == 0 || percent(r, 60))
        return false;
    *daylight = percent(r, 50);
    int64_t zone = s7cpu_zone(cpu) / S7CPU_MINUTE + 15 * (*daylight ? 4 - 8 * below(r, 2) : between(r, -12, 12));
    zone = zone < -720 ? -720 : zone > 840 ? 840 : zone;
    *to = zone * S7CPU_MINUTE;
    return true;
}

/* SET_TINT becomes SET_TINTL, mostly with the same point by local time. */
static void draw_local(struct random_program *r, const struct s7cpu *cpu, struct step *step)
{
    step->kind = STEP_SET_TINTL;
    step->local = percent(r, 70);
    step->activate = percent(r, 60);
    r->activates &= !step->activate;
    if (step->local && percent(r, 80) && s7cpu_date_exists(&step->sdt))
        step->sdt = s7cpu_date(clamp(s7cpu_ms(&step->sdt) + s7cpu_zone(cpu)));
}

static void begin(struct program *p, const struct s7cpu *cpu, struct activation *a)
{
    struct random_program *r = (struct random_program *)p;
    (void)cpu;
    a->step = (uint32_t)(a->ob == 1 ? between(r, 1, 12) : between(r, 0, 4));
}

static bool is_tod(int ob)
{
    return (ob >= 10 && ob <= 17) || (ob >= S7CPU_MORE_TODS && ob < S7CPU_MORE_DINTS);
}

static int64_t draw_busy(struct random_program *r, int ob)
{
    if (ob == 1)
        return percent(r, 75) ? between(r, 1000, 40000) : between(r, 1, 800);
    if (ob >= 20 && ob <= 23 && percent(r, 30))
        return between(r, 200, 2000);
    if ((is_tod(ob) || ob >= 100) && percent(r, 8))
        return between(r, 30, 130) * INT64_C(1000);
    return between(r, 1, 200);
}

static enum step_kind draw_kind(struct random_program *r)
{
    static const struct {
        enum step_kind kind;
        int weight;
    } mix[] = {{STEP_BUSY, 360},    {STEP_SET_TINT, 65}, {STEP_ACT_TINT, 110},
               {STEP_CAN_TINT, 30}, {STEP_QRY_TINT, 50}, {STEP_SRT_DINT, 70},
               {STEP_CAN_DINT, 20}, {STEP_QRY_DINT, 40}, {STEP_DIS_IRT, 20},
               {STEP_EN_IRT, 50},   {STEP_DIS_AIRT, 70}, {STEP_EN_AIRT, 90},
               {STEP_SET_CLOCK, 5}};
    int n = below(r, 1000);
    const int last = (int)(sizeof mix / sizeof mix[0]) - 1;
    int i = 0;
    while (i < last && n >= mix[i].weight)
        n -= mix[i++].weight;
    return mix[i].kind;
}

static int draw_state_ob(struct random_program *r)
{
    static const int obs[] = {10, 11, 12, 13, 17, 20, 20, 21, 21, 22, 23, 35, 40, 80, 82, 85};
    return obs[below(r, 16)];
}

static bool next(struct program *p, const struct s7cpu *cpu, struct activation *a,
                 struct step *step)
{
    struct random_program *r = (struct random_program *)p;
    if (a->step == 0)
        return false;
    if (r->states && percent(r, 15)) {
        *step = (struct step){.kind = STEP_STATE, .ob = draw_state_ob(r)};
        return true;
    }
    a->step--;
    if (is_tod(a->ob) && percent(r, 4)) { /* its own point comes again [CLK-10, CLK-12] */
        *step = (struct step){.kind = STEP_MOVE_CLOCK, .ms = -between(r, 10, 90) * INT64_C(1000)};
        return true;
    }
    *step = (struct step){.kind = r->activates ? STEP_ACT_TINT : draw_kind(r)};
    switch (step->kind) {
    case STEP_BUSY:
        step->ms = draw_busy(r, a->ob);
        break;
    case STEP_SET_TINT:
        step->ob = r->last_set = draw_ob_nr(r, &cpu->config);
        step->period = draw_period(r);
        draw_sdt(r, s7cpu_clock(cpu), step->period, &step->sdt);
        r->activates = percent(r, 70);
        if (cpu->config.zone != 0 && percent(r, 60))
            draw_local(r, cpu, step);
        break;
    case STEP_ACT_TINT:
        step->ob = r->activates || percent(r, 60) ? r->last_set : draw_ob_nr(r, &cpu->config);
        r->activates = false;
        break;
    case STEP_CAN_TINT:
    case STEP_QRY_TINT:
        step->ob = draw_ob_nr(r, &cpu->config);
        break;
    case STEP_SRT_DINT:
        step->ob = draw_dint_ob_nr(r, &cpu->config);
        step->ms = draw_dtime(r);
        step->sign = below(r, 0x10000);
        break;
    case STEP_CAN_DINT:
    case STEP_QRY_DINT:
        step->ob = draw_dint_ob_nr(r, &cpu->config);
        break;
    case STEP_DIS_IRT:
    case STEP_EN_IRT:
        draw_irt(r, &cpu->config, step);
        break;
    case STEP_SET_CLOCK:
        if (draw_zone(r, cpu, &step->daylight, &step->ms))
            step->kind = STEP_SET_ZONE;
        else
            draw_clock_change(r, cpu, &step->ms);
        break;
    default: /* SFC 41 and 42 have no operands */
        break;
    }
    return true;
}

static bool idle(struct program *p, const struct s7cpu *cpu)
{
    (void)p;
    (void)cpu;
    return false;
}

static int64_t action_time(struct program *p)
{
    return ((struct random_program *)p)->next_action;
}

/* An OB with a start event from outside: some often, so that they meet, and each now and then. */
static int draw_interrupt_ob(struct random_program *r)
{
    static const int often[] = {35, 35, 35, 40, 40, 41, 80, 85};
    int ob = between(r, 30, 87);
    if (percent(r, 65))
        return often[below(r, 8)];
    while (!s7cpu_ob_from_outside(ob))
        ob = between(r, 30, 87);
    return ob;
}

/* An event whose OB is missing is rare: it may well stop the CPU. */
static void draw_interrupt(struct random_program *r, const struct s7cpu *cpu, struct action *a)
{
    static const int time_errors[] = {0x01, 0x03, 0x08, 0x09, 0x0A, 0x0B};
    static const int newer[] = {0x01, 0x08, 0x09, 0x0B};
    const bool is_newer = is_s7_1500(&cpu->config);
    a->kind = ACTION_INTERRUPT;
    a->ob = draw_interrupt_ob(r);
    if (!s7cpu_is_loaded(cpu, 35) && percent(r, 30)) {
        a->kind = ACTION_LOAD;
        a->ob = 35;
        return;
    }
    if (is_newer && percent(r, 20))
        a->ob = s7cpu_ob(&cpu->config, draw_created(r, &cpu->config, percent(r, 50) ? S7CPU_MORE_CYCLICS
                                                                                  : S7CPU_MORE_HARDWARE, a->ob));
    if (is_newer && percent(r, 5))
        a->ob = between(r, 121, 122); /* [T15-63, T15-111] */
    if (!s7cpu_ob_exists(cpu->config.family, a->ob) ||
        (!s7cpu_is_loaded(cpu, a->ob) && !percent(r, 15)))
        a->ob = 35;
    if (a->ob == 80)
        a->flt_id = is_newer ? newer[below(r, 4)] : time_errors[below(r, 6)];
    if (a->ob == 85)
        a->flt_id = 0xA3;
}

/* An event burst fills the request buffer of a class, which only the long OBs allow. */
static int64_t draw_pause(struct random_program *r)
{
    if (percent(r, 15))
        return between(r, 0, 50);
    return between(r, 50, percent(r, 15) ? 2000 : 25000);
}

/* Deletes a block, or brings back one that is missing: OB 80 and 85 soon. */
static void draw_block(struct random_program *r, const struct s7cpu *cpu, struct action *a)
{
    static const int obs[] = {80, 85, 10, 11, 12, 20, 21, 35};
    const bool lacks_85 = s7cpu_ob_exists(cpu->config.family, 85) && !s7cpu_is_loaded(cpu, 85);
    static const int ranges[] = {S7CPU_MORE_TODS, S7CPU_MORE_STARTUPS, S7CPU_MORE_CYCLES};
    a->ob = obs[below(r, 8)];
    if (is_s7_1500(&cpu->config) && percent(r, 40))
        a->ob = s7cpu_ob(&cpu->config, draw_created(r, &cpu->config, ranges[below(r, 3)], a->ob));
    if (!s7cpu_is_loaded(cpu, 80) || lacks_85)
        a->ob = s7cpu_is_loaded(cpu, 80) ? 85 : 80;
    else if (!s7cpu_ob_exists(cpu->config.family, a->ob))
        a->ob = 80;
    a->kind = s7cpu_is_loaded(cpu, a->ob) ? ACTION_DELETE : ACTION_LOAD;
}

/* warm: percent of the restarts that are not hot. */
static enum action_kind draw_restart(struct random_program *r, const struct s7cpu *cpu, int warm)
{
    if (!s7cpu_restart_exists(cpu->config.family, S7CPU_COLD))
        return ACTION_RESTART_WARM;
    if (r->hot && percent(r, 40))
        return ACTION_RESTART_HOT;
    return percent(r, warm) ? ACTION_RESTART_WARM : ACTION_RESTART_COLD;
}

static bool take_action(struct program *p, const struct s7cpu *cpu, struct action *action)
{
    struct random_program *r = (struct random_program *)p;
    int n = below(r, 1000);
    *action = (struct action){.flt_id = S7CPU_NONE};
    if (r->states && percent(r, 20)) { /* the next one comes at the same moment */
        action->kind = ACTION_STATE;
        action->ob = draw_state_ob(r);
        return true;
    }
    r->next_action = s7cpu_up(cpu) + draw_pause(r);
    if (s7cpu_mode(cpu) == S7CPU_STOP && n < 100) {
        action->kind = ACTION_SET_CLOCK;
        draw_clock_change(r, cpu, &action->ms);
    } else if (s7cpu_mode(cpu) == S7CPU_STOP) {
        action->kind = draw_restart(r, cpu, 80);
    } else if (s7cpu_mode(cpu) == S7CPU_HOLD) {
        action->kind = ACTION_RELEASE;
    } else if (n < 10) {
        draw_block(r, cpu, action);
    } else if (n < 950) {
        draw_interrupt(r, cpu, action);
    } else if (n < 980) {
        action->kind = ACTION_SET_ZONE;
        if (!draw_zone(r, cpu, &action->daylight, &action->ms)) {
            action->kind = ACTION_SET_CLOCK;
            draw_clock_change(r, cpu, &action->ms);
        }
    } else if (n < 985) {
        action->kind = ACTION_STOP;
    } else if (n < 993) {
        action->kind = ACTION_HOLD; /* long enough for start points to pass */
        r->next_action = s7cpu_up(cpu) + between(r, 1000, 200000);
    } else {
        action->kind = draw_restart(r, cpu, 50);
    }
    return true;
}

void random_program(struct random_program *r, uint64_t seed)
{
    *r = (struct random_program){
        .program = {.begin = begin,
                    .next = next,
                    .idle = idle,
                    .action_time = action_time,
                    .take_action = take_action},
        .state = seed * UINT64_C(0x9E3779B97F4A7C15) + 0x2545F4914F6CDD1D,
        .next_action = 100,
    };
    for (int i = 0; i < 8; i++)
        draw(r);
}

/* Classes that differ from the default, where the CPU allows it: OBs that meet get to share one
 * [OBS-05]. */
static void draw_priorities(struct random_program *r, struct s7cpu_config *c)
{
    static const int obs[] = {10, 11, 12, 20, 21, 35, 40, 81, 82};
    int shared = between(r, 2, 23);
    for (unsigned i = 0; i < sizeof obs / sizeof obs[0]; i++) {
        int low, high;
        if (!s7cpu_class_range(c->family, obs[i], &low, &high) || percent(r, 60))
            continue;
        c->priority[obs[i]] = percent(r, 50) ? shared : between(r, low, high);
    }
}

/* OBs from 123 on [T15-10]: up to two of a class, loaded or not. */
static void draw_classes(struct random_program *r, struct s7cpu_config *c)
{
    static const int ranges[] = {S7CPU_MORE_TODS,     S7CPU_MORE_DINTS,    S7CPU_MORE_CYCLICS,
                                 S7CPU_MORE_HARDWARE, S7CPU_MORE_STARTUPS, S7CPU_MORE_CYCLES};
    for (int i = 0; i < 12; i++)
        if (percent(r, 40))
            s7cpu_add_ob(c, percent(r, 50) ? between(r, 123, 134) : between(r, 135, 32767), ranges[i / 2]);
    for (int ob = S7CPU_MORE; ob < S7CPU_OBS; ob++) {
        c->loaded[ob] = c->numbers[ob - S7CPU_MORE] != 0 && percent(r, 80);
        if (s7cpu_ob_from_outside(ob) && c->numbers[ob - S7CPU_MORE] != 0)
            c->priority[ob] = between(r, 2, 20); /* a cyclic one has no default */
    }
}

/* Parameters of queues [T15-68 to T15-73] for OBs that meet. */
static void draw_queues(struct random_program *r, struct s7cpu_config *c)
{
    static const int obs[] = {10, 11, 12, 35, 35, 40, 41, S7CPU_MORE_TODS, S7CPU_MORE_CYCLICS, S7CPU_MORE_HARDWARE};
    for (unsigned i = 0; i < sizeof obs / sizeof obs[0]; i++) {
        const int events = percent(r, 80) ? between(r, 1, 3) : between(r, 4, 12);
        if (percent(r, 40) || s7cpu_ob_number(c, obs[i]) == 0)
            continue;
        c->queue[obs[i]] = (struct s7cpu_queue){.events = events,
                                                .threshold = percent(r, 70) ? between(r, 1, events) : 0,
                                                .overflow = between(r, S7CPU_NONE, 1)};
    }
}

void random_config(struct random_program *r, struct s7cpu_config *c,
                   const enum s7cpu_family *family)
{
    static const int always[] = {1, 10, 11, 12, 20, 21, 35, 80, 85, 100, 102};
    static const int often[] = {13, 14, 15, 22, 23, 30, 32, 38, 40, 41, 47, 55, 57, 60, 70, 72,
                                81, 82, 83, 84, 86, 87};
    c->family = (enum s7cpu_family)below(r, 4);
    if (family != NULL)
        c->family = *family;
    for (unsigned i = 0; i < sizeof always / sizeof always[0]; i++)
        c->loaded[always[i]] = s7cpu_ob_exists(c->family, always[i]);
    for (unsigned i = 0; i < sizeof often / sizeof often[0]; i++)
        c->loaded[often[i]] = percent(r, 75) && s7cpu_ob_exists(c->family, often[i]);
    c->clock = draw_instant(r);
    c->mode = percent(r, 50) ? S7CPU_RUN : percent(r, 70) ? S7CPU_STOP : S7CPU_STARTUP;
    c->buffer = percent(r, 50) ? 64 : between(r, 1, 3);
    if (percent(r, 70))
        draw_priorities(r, c);
    c->step7[0] = (struct s7cpu_step7){.execution = percent(r, 50) ? S7CPU_EVERY_MINUTE
                                                                   : S7CPU_HOURLY,
                                       .active = true,
                                       .start = c->clock - c->clock % S7CPU_HOUR};
    c->loaded[121] = c->loaded[122] = is_s7_1500(c) && percent(r, 75);
    if (is_s7_1500(c) && percent(r, 50))
        draw_classes(r, c);
    if (is_s7_1500(c) && percent(r, 50))
        draw_queues(r, c);
    if (s7cpu_has_local_time(c->family) && percent(r, 70)) {
        c->zone = between(r, -48, 56) * 15 * S7CPU_MINUTE;
        c->step7[0].local = percent(r, 50);
    }
    if (is_s7_1500(c) && percent(r, 50))
        c->choices.old_obs_are_optimised = true;
    if (!is_s7_1500(c)) /* which deselects none */
        c->step7[7] = (struct s7cpu_step7){.deselected = true, .start = S7CPU_NEVER};
    r->hot = c->family == S7CPU_S7_400; /* [OBS-57] */
    c->loaded[101] = r->hot && percent(r, 75);
}

#include "log.h"

static int write_line(void *context, const char *line, size_t length)
{
    struct log *log = context;
    if (s7log_to_file(log->out, line, length) != 0)
        return -1;
    return log->flush_lines ? fflush(log->out) : 0;
}

void log_open(struct log *log, FILE *out, bool flush_lines)
{
    log->out = out;
    log->flush_lines = flush_lines;
    s7log_open(&log->s7, write_line, log);
}

void log_done(struct log *log, int64_t at, int64_t up)
{
    s7log_done(&log->s7, (struct s7log_now){.at = at, .up = log->config.up ? up : S7LOG_NONE});
}

bool log_close(struct log *log)
{
    return fflush(log->out) == 0 && !log->s7.failed;
}

static int or_none(int value)
{
    return value == S7CPU_NONE ? S7LOG_NONE : value;
}

static struct s7log_info convert(const struct s7cpu_info *i)
{
    return (struct s7log_info){.priority = or_none(i->priority),
                               .strt_info = or_none(i->strt_info),
                               .flt_id = or_none(i->flt_id),
                               .period = or_none(i->period),
                               .sign = or_none(i->sign),
                               .dtime = or_none(i->dtime),
                               .error_info = or_none(i->error_info),
                               .ev = or_none(i->ev),
                               .ev_ob = or_none(i->ev_ob),
                               .time = i->time == S7CPU_NONE ? S7LOG_NONE : i->time,
                               .caught_up = or_none(i->caught_up),
                               .second_time = or_none(i->second_time),
                               .csg_ob = or_none(i->csg_ob),
                               .csg_priority = or_none(i->csg_priority),
                               .event_count = or_none(i->event_count)};
}

static void log_call(struct s7log *l, struct s7log_now t, const struct s7cpu_event *e)
{
    const struct s7log_dt sdt = {e->sdt.year,   e->sdt.month,  e->sdt.day, e->sdt.hour,
                                 e->sdt.minute, e->sdt.second, e->sdt.ms};
    const int status = e->ret == 0 ? e->status : S7LOG_NONE; /* [TINT-71] */
    switch (e->kind) {
    case S7CPU_SET_TINT:
        s7log_set_tint(l, t, e->ob, &sdt, e->period, e->ret);
        break;
    case S7CPU_SET_TINTL:
        s7log_set_tintl(l, t, e->ob, &sdt, e->local, e->period, e->activate, e->ret);
        break;
    case S7CPU_CAN_TINT:
        s7log_can_tint(l, t, e->ob, e->ret);
        break;
    case S7CPU_ACT_TINT:
        s7log_act_tint(l, t, e->ob, e->ret);
        break;
    case S7CPU_QRY_TINT:
        s7log_qry_tint(l, t, e->ob, e->ret, status);
        break;
    case S7CPU_SRT_DINT:
        s7log_srt_dint(l, t, e->ob, e->dtime, e->sign, e->ret);
        break;
    case S7CPU_CAN_DINT:
        s7log_can_dint(l, t, e->ob, e->ret);
        break;
    case S7CPU_QRY_DINT:
        s7log_qry_dint(l, t, e->ob, e->ret, status);
        break;
    case S7CPU_DIS_IRT:
        s7log_dis_irt(l, t, e->mode, e->ob, e->ret);
        break;
    case S7CPU_EN_IRT:
        s7log_en_irt(l, t, e->mode, e->ob, e->ret);
        break;
    case S7CPU_DIS_AIRT:
        s7log_dis_airt(l, t, e->ret);
        break;
    default:
        s7log_en_airt(l, t, e->ret);
        break;
    }
}

static int ob_number(const struct log *log, const struct s7cpu_event *e)
{
    return s7cpu_ob_number(log->cpu, e->ob);
}

static void log_start(struct log *log, struct s7log_now t, const struct s7cpu_event *e)
{
    const struct s7log_info i = convert(e->info);
    if (!s7cpu_ob_is_cycle(e->ob) || log->config.cycle)
        s7log_start(&log->s7, t, ob_number(log, e), &i);
}

static void log_end(struct log *log, struct s7log_now t, const struct s7cpu_event *e)
{
    if (!s7cpu_ob_is_cycle(e->ob) || log->config.cycle)
        s7log_end(&log->s7, t, ob_number(log, e));
}

static void log_diag(struct log *log, struct s7log_now t, const struct s7cpu_event *e)
{
    if (!log->config.diag)
        return;
    if (e->info != NULL) {
        const struct s7log_info i = convert(e->info);
        s7log_diag(&log->s7, t, e->id, ob_number(log, e), e->info->priority, &i);
    } else {
        s7log_diag(&log->s7, t, e->id, or_none(e->ob), S7LOG_NONE, NULL);
    }
}

static void log_state(struct log *log, struct s7log_now t, const struct s7cpu_event *e)
{
    const struct s7log_ob_state state = {.active = or_none(e->state->active),
                                         .blocked = or_none(e->state->blocked),
                                         .loaded = or_none(e->state->loaded),
                                         .entries_off = or_none(e->state->entries_off),
                                         .left = or_none(e->state->left)};
    s7log_state(&log->s7, t, ob_number(log, e), &state);
}

void log_event(void *context, const struct s7cpu_event *e)
{
    struct log *log = context;
    struct s7log *l = &log->s7;
    const struct s7log_now t = {.at = e->at, .up = log->config.up ? e->up : S7LOG_NONE};
    static const enum s7log_restart_type types[] = {
        [S7CPU_WARM] = S7LOG_WARM, [S7CPU_COLD] = S7LOG_COLD, [S7CPU_HOT] = S7LOG_HOT};
    switch (e->kind) {
    case S7CPU_OB_START:
        log_start(log, t, e);
        break;
    case S7CPU_OB_END:
        log_end(log, t, e);
        break;
    case S7CPU_CLOCK:
        s7log_clock(l, t, e->to);
        break;
    case S7CPU_ZONE:
        s7log_zone(l, t, (int)(e->zone / S7CPU_MINUTE), e->daylight);
        break;
    case S7CPU_RESTART:
        s7log_restart(l, t, types[e->restart]);
        break;
    case S7CPU_TO_RUN:
        s7log_run(l, t);
        break;
    case S7CPU_TO_STOP:
        s7log_stop(l, t, or_none(e->id));
        break;
    case S7CPU_TO_HOLD:
        s7log_hold(l, t);
        break;
    case S7CPU_RELEASE:
        s7log_release(l, t);
        break;
    case S7CPU_INTERRUPT:
        s7log_interrupt(l, t, ob_number(log, e), or_none(e->flt_id));
        break;
    case S7CPU_LOAD:
        s7log_load(l, t, ob_number(log, e));
        break;
    case S7CPU_DELETE:
        s7log_delete(l, t, ob_number(log, e));
        break;
    case S7CPU_DIAG:
        log_diag(log, t, e);
        break;
    case S7CPU_STATE:
        log_state(log, t, e);
        break;
    default:
        log_call(l, t, e);
        break;
    }
}

static size_t loaded_obs(const struct s7cpu_config *c, int *obs)
{
    size_t n = 0;
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        if (c->loaded[ob])
            obs[n++] = s7cpu_ob_number(c, ob);
    return n;
}

static size_t set_priorities(const struct s7cpu_config *c, struct s7log_priority *priorities)
{
    size_t n = 0;
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        if (c->priority[ob] != 0)
            priorities[n++] = (struct s7log_priority){s7cpu_ob_number(c, ob), c->priority[ob]};
    return n;
}

static size_t event_classes(const struct s7cpu_config *c, struct s7log_class *classes)
{
    static const int ends[] = {S7CPU_MORE_DINTS,    S7CPU_MORE_CYCLICS, S7CPU_MORE_HARDWARE,
                               S7CPU_MORE_STARTUPS, S7CPU_MORE_CYCLES,  S7CPU_OBS};
    size_t n = 0;
    int class = S7LOG_CLASS_TOD;
    for (int ob = S7CPU_MORE; ob < S7CPU_OBS; ob++) {
        class += ob == ends[class];
        if (c->numbers[ob - S7CPU_MORE] != 0)
            classes[n++] = (struct s7log_class){s7cpu_ob_number(c, ob), (enum s7log_ob_class)class};
    }
    return n;
}

static size_t queue_parameters(const struct s7cpu_config *c, struct s7log_queue *queues)
{
    size_t n = 0;
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        if (c->queue[ob].events != 0)
            queues[n++] = (struct s7log_queue){s7cpu_ob_number(c, ob), c->queue[ob].events,
                                               c->queue[ob].threshold,
                                               or_none(c->queue[ob].overflow)};
    return n;
}

static size_t step7_tods(const struct s7cpu_config *c, struct s7log_tod *tods)
{
    static const enum s7log_execution executions[] = {
        [S7CPU_NOT_CONFIGURED] = S7LOG_NOT_GIVEN, [S7CPU_NO_EXECUTION] = S7LOG_NO_EXECUTION,
        [S7CPU_ONCE] = S7LOG_ONCE,                [S7CPU_EVERY_MINUTE] = S7LOG_MINUTE,
        [S7CPU_HOURLY] = S7LOG_HOURLY,            [S7CPU_DAILY] = S7LOG_DAILY,
        [S7CPU_WEEKLY] = S7LOG_WEEKLY,            [S7CPU_MONTHLY] = S7LOG_MONTHLY,
        [S7CPU_YEARLY] = S7LOG_YEARLY,            [S7CPU_END_OF_MONTH] = S7LOG_END_OF_MONTH};
    size_t n = 0;
    for (int k = 0; k < S7CPU_TODS; k++) {
        const struct s7cpu_step7 *s = &c->step7[k];
        if (s->execution != S7CPU_NOT_CONFIGURED || s->deselected)
            tods[n++] = (struct s7log_tod){.ob = s7cpu_ob_number(c, s7cpu_tod_ob(k)),
                                           .execution = executions[s->execution],
                                           .start = s->start == S7CPU_NEVER ? S7LOG_NONE : s->start,
                                           .active = s->active,
                                           .deselected = s->deselected,
                                           .local = s->local};
    }
    return n;
}

void log_header(struct log *log, const struct s7cpu_config *c, const struct log_config *config)
{
    static const enum s7log_cpu cpus[] = {[S7CPU_S7_300] = S7LOG_S7_300,
                                          [S7CPU_S7_400] = S7LOG_S7_400,
                                          [S7CPU_CPU_318] = S7LOG_CPU_318,
                                          [S7CPU_S7_1500] = S7LOG_S7_1500};
    static const enum s7log_mode modes[] = {[S7CPU_STOP] = S7LOG_STOP,
                                            [S7CPU_STARTUP] = S7LOG_STARTUP,
                                            [S7CPU_RUN] = S7LOG_RUN};
    int obs[S7CPU_OBS];
    struct s7log_priority priorities[S7CPU_OBS];
    struct s7log_tod tods[S7CPU_TODS];
    struct s7log_queue queues[S7CPU_OBS];
    struct s7log_class classes[S7CPU_OBS - S7CPU_MORE];
    const struct s7log_header h = {
        .cpu = cpus[c->family],
        .obs = obs,
        .ob_count = loaded_obs(c, obs),
        .clock = c->clock,
        .mode = modes[c->mode],
        .latency_ms = config->latency_ms,
        .records = S7LOG_CALL | S7LOG_OB | S7LOG_CLOCK | S7LOG_MODE | S7LOG_INTERRUPT | S7LOG_LOAD |
                   (config->diag ? S7LOG_DIAG : 0u),
        .cycle = config->cycle,
        .priorities = priorities,
        .priority_count = set_priorities(c, priorities),
        .tods = tods,
        .tod_count = step7_tods(c, tods),
        .classes = classes,
        .class_count = event_classes(c, classes),
        .queues = queues,
        .queue_count = queue_parameters(c, queues),
        .zone = (int)(c->zone / S7CPU_MINUTE)};
    log->config = *config;
    log->cpu = c;
    s7log_header(&log->s7, &h);
}

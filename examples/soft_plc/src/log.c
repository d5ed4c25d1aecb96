#include "log.h"

#include "cpu.h"

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

bool log_close(struct log *log)
{
    return fflush(log->out) == 0 && !log->s7.failed;
}

static struct s7log_now now(const struct cpu *cpu)
{
    return (struct s7log_now){.at = cpu_now(cpu),
                              .up = cpu->config.log_up ? cpu->clock.up : S7LOG_NONE};
}

static int or_none(int value)
{
    return value < 0 ? S7LOG_NONE : value;
}

static struct s7log_info convert(const struct start_info *i)
{
    return (struct s7log_info){.priority = i->priority,
                               .strt_info = or_none(i->strt_info),
                               .flt_id = or_none(i->flt_id),
                               .period = or_none(i->period),
                               .sign = or_none(i->sign),
                               .dtime = or_none(i->dtime),
                               .error_info = or_none(i->error_info),
                               .ev = or_none(i->ev),
                               .ev_ob = or_none(i->ev_ob),
                               .time = i->time};
}

void log_call(struct log *log, const struct cpu *cpu, const struct step *s, int ret, int status)
{
    const struct s7log_dt sdt = {s->sdt.year,   s->sdt.month,  s->sdt.day, s->sdt.hour,
                                 s->sdt.minute, s->sdt.second, s->sdt.ms};
    const struct s7log_now t = now(cpu);
    struct s7log *l = &log->s7;
    int word = ret == 0 ? status : S7LOG_NONE; /* [TINT-71] */
    switch (s->kind) {
    case STEP_SET_TINT:
        s7log_set_tint(l, t, s->ob, &sdt, s->period, ret);
        break;
    case STEP_CAN_TINT:
        s7log_can_tint(l, t, s->ob, ret);
        break;
    case STEP_ACT_TINT:
        s7log_act_tint(l, t, s->ob, ret);
        break;
    case STEP_QRY_TINT:
        s7log_qry_tint(l, t, s->ob, ret, word);
        break;
    case STEP_SRT_DINT:
        s7log_srt_dint(l, t, s->ob, s->ms, s->sign, ret);
        break;
    case STEP_CAN_DINT:
        s7log_can_dint(l, t, s->ob, ret);
        break;
    case STEP_QRY_DINT:
        s7log_qry_dint(l, t, s->ob, ret, word);
        break;
    case STEP_DIS_IRT:
        s7log_dis_irt(l, t, s->mode, s->ob, ret);
        break;
    case STEP_EN_IRT:
        s7log_en_irt(l, t, s->mode, s->ob, ret);
        break;
    case STEP_DIS_AIRT:
        s7log_dis_airt(l, t, ret);
        break;
    case STEP_EN_AIRT:
        s7log_en_airt(l, t, ret);
        break;
    case STEP_BUSY:
    case STEP_SET_CLOCK:
    case STEP_MOVE_CLOCK:
        break;
    }
}

void log_start(struct log *log, const struct cpu *cpu, int ob, const struct start_info *info)
{
    const struct s7log_info i = convert(info);
    s7log_start(&log->s7, now(cpu), ob, &i);
}

void log_end(struct log *log, const struct cpu *cpu, int ob)
{
    s7log_end(&log->s7, now(cpu), ob);
}

void log_clock(struct log *log, const struct cpu *cpu, dt_ms to)
{
    s7log_clock(&log->s7, now(cpu), to);
}

void log_restart(struct log *log, const struct cpu *cpu, bool cold)
{
    s7log_restart(&log->s7, now(cpu), cold ? S7LOG_COLD : S7LOG_WARM);
}

void log_stop(struct log *log, const struct cpu *cpu, int cause)
{
    s7log_stop(&log->s7, now(cpu), or_none(cause));
}

void log_run(struct log *log, const struct cpu *cpu)
{
    s7log_run(&log->s7, now(cpu));
}

void log_hold(struct log *log, const struct cpu *cpu)
{
    s7log_hold(&log->s7, now(cpu));
}

void log_release(struct log *log, const struct cpu *cpu)
{
    s7log_release(&log->s7, now(cpu));
}

void log_interrupt(struct log *log, const struct cpu *cpu, int ob, int flt_id)
{
    s7log_interrupt(&log->s7, now(cpu), ob, or_none(flt_id));
}

void log_block(struct log *log, const struct cpu *cpu, bool present, int ob)
{
    if (present)
        s7log_load(&log->s7, now(cpu), ob);
    else
        s7log_delete(&log->s7, now(cpu), ob);
}

void log_diag(struct log *log, const struct cpu *cpu, int id, int ob, const struct start_info *info)
{
    if (info != NULL) {
        const struct s7log_info i = convert(info);
        s7log_diag(&log->s7, now(cpu), id, ob, info->priority, &i);
    } else {
        s7log_diag(&log->s7, now(cpu), id, or_none(ob), S7LOG_NONE, NULL);
    }
}

static size_t loaded_obs(const struct config *c, int *obs)
{
    size_t n = 0;
    for (int ob = 0; ob < OB_MAX; ob++)
        if (c->loaded[ob])
            obs[n++] = ob;
    return n;
}

static size_t set_priorities(const struct config *c, struct s7log_priority *priorities)
{
    size_t n = 0;
    for (int ob = 0; ob < OB_MAX; ob++)
        if (c->priority[ob] != 0)
            priorities[n++] = (struct s7log_priority){ob, c->priority[ob]};
    return n;
}

static size_t step7_tods(const struct config *c, struct s7log_tod *tods)
{
    size_t n = 0;
    for (int k = 0; k < TOD_OBS; k++) {
        const struct step7_tod *s = &c->step7[k];
        if (s->configured)
            tods[n++] = (struct s7log_tod){.ob = TOD_FIRST + k,
                                           .execution = s->execution,
                                           .start = s->has_start ? s->start : S7LOG_NONE,
                                           .active = s->active,
                                           .deselected = s->deselected};
    }
    return n;
}

void log_header(struct log *log, const struct cpu *cpu)
{
    static const enum s7log_cpu cpus[] = {
        [FAMILY_S7_300] = S7LOG_S7_300, [FAMILY_S7_400] = S7LOG_S7_400,
        [FAMILY_CPU_318] = S7LOG_CPU_318};
    static const enum s7log_mode modes[] = {
        [MODE_STOP] = S7LOG_STOP, [MODE_STARTUP] = S7LOG_STARTUP, [MODE_RUN] = S7LOG_RUN};
    const struct config *c = &cpu->config;
    int obs[OB_MAX];
    struct s7log_priority priorities[OB_MAX];
    struct s7log_tod tods[TOD_OBS];
    const struct s7log_header h = {
        .cpu = cpus[c->family],
        .obs = obs,
        .ob_count = loaded_obs(c, obs),
        .clock = c->clock,
        .mode = modes[c->mode],
        .latency_ms = c->latency_ms,
        .records = S7LOG_CALL | S7LOG_OB | S7LOG_CLOCK | S7LOG_MODE | S7LOG_INTERRUPT | S7LOG_LOAD |
                   (c->log_diag ? S7LOG_DIAG : 0u),
        .cycle = c->log_cycle,
        .priorities = priorities,
        .priority_count = set_priorities(c, priorities),
        .tods = tods,
        .tod_count = step7_tods(c, tods)};
    s7log_header(&log->s7, &h);
}

#include "log.h"

#include "cpu.h"
#include "text.h"

void log_open(struct log *log, FILE *out, bool flush_lines)
{
    log->out = out;
    log->flush_lines = flush_lines;
    log->failed = false;
    log->events = 0;
    log->used = 0;
}

static void flush(struct log *log)
{
    if (fwrite(log->buffer, 1, log->used, log->out) != log->used || fflush(log->out) != 0)
        log->failed = true;
    log->used = 0;
}

bool log_close(struct log *log)
{
    flush(log);
    return !log->failed;
}

static char *begin_line(struct log *log)
{
    if (LOG_BUFFER - log->used < LOG_LINE)
        flush(log);
    return log->buffer + log->used;
}

static void end_line(struct log *log, char *p)
{
    p = text_str(p, "}\n");
    log->used = (size_t)(p - log->buffer);
    if (log->flush_lines)
        flush(log);
}

static void end_event(struct log *log, char *p)
{
    end_line(log, p);
    log->events++;
}

static char *begin_event(struct log *log, const struct cpu *cpu, const char *event)
{
    char *p = begin_line(log);
    p = text_str(p, "{\"event\":\"");
    p = text_str(p, event);
    p = text_str(p, "\",\"at\":");
    p = text_dt(p, cpu_now(cpu));
    if (cpu->config.log_up) {
        p = text_str(p, ",\"up\":");
        p = text_int(p, cpu->clock.up);
    }
    return p;
}

static char *put_ob(char *p, int ob)
{
    p = text_str(p, ",\"ob\":");
    return text_int(p, ob);
}

static char *put_ret(char *p, int ret)
{
    p = text_str(p, ",\"ret\":");
    return text_word(p, ret, 4);
}

void log_set_tint(struct log *log, const struct cpu *cpu, int ob, const struct civil *sdt,
                  int period, int ret)
{
    char *p = put_ob(begin_event(log, cpu, "SET_TINT"), ob);
    p = text_str(p, ",\"sdt\":");
    p = text_civil(p, sdt);
    p = text_str(p, ",\"period\":");
    p = text_word(p, period, 4);
    end_event(log, put_ret(p, ret));
}

void log_call_ob(struct log *log, const struct cpu *cpu, const char *sfc, int ob, int ret)
{
    end_event(log, put_ret(put_ob(begin_event(log, cpu, sfc), ob), ret));
}

void log_srt_dint(struct log *log, const struct cpu *cpu, int ob, int64_t dtime, int sign, int ret)
{
    char *p = put_ob(begin_event(log, cpu, "SRT_DINT"), ob);
    p = text_int(text_str(p, ",\"dtime\":"), dtime);
    p = text_word(text_str(p, ",\"sign\":"), sign, 4);
    end_event(log, put_ret(p, ret));
}

void log_qry(struct log *log, const struct cpu *cpu, const char *sfc, int ob, int ret, int status)
{
    char *p = put_ret(put_ob(begin_event(log, cpu, sfc), ob), ret);
    if (ret == 0) { /* [TINT-71] */
        p = text_str(p, ",\"status\":");
        p = text_word(p, status, 4);
    }
    end_event(log, p);
}

void log_irt(struct log *log, const struct cpu *cpu, const char *sfc, int mode, int ob, int ret)
{
    char *p = text_word(text_str(begin_event(log, cpu, sfc), ",\"mode\":"), mode, 2);
    end_event(log, put_ret(put_ob(p, ob), ret));
}

void log_call(struct log *log, const struct cpu *cpu, const char *sfc, int ret)
{
    end_event(log, put_ret(begin_event(log, cpu, sfc), ret));
}

static char *put_info(char *p, const char *name, int value, int digits)
{
    if (value < 0)
        return p;
    p = text_str(p, ",\"");
    p = text_str(p, name);
    p = text_str(p, "\":");
    return digits > 0 ? text_word(p, value, digits) : text_int(p, value);
}

static char *put_start_info(char *p, const struct start_info *info)
{
    p = text_str(p, ",\"info\":{\"priority\":");
    p = text_int(p, info->priority);
    p = put_info(p, "strt_info", info->strt_info, 2);
    p = put_info(p, "flt_id", info->flt_id, 2);
    p = put_info(p, "period", info->period, 4);
    p = put_info(p, "sign", info->sign, 4);
    p = put_info(p, "dtime", info->dtime, 0);
    p = put_info(p, "error_info", info->error_info, 4);
    p = put_info(p, "ev", info->ev, 4);
    p = put_info(p, "ev_ob", info->ev_ob, 0);
    p = text_str(p, ",\"time\":");
    p = text_dt(p, info->time);
    *p++ = '}';
    return p;
}

void log_start(struct log *log, const struct cpu *cpu, int ob, const struct start_info *info)
{
    end_event(log, put_start_info(put_ob(begin_event(log, cpu, "start"), ob), info));
}

void log_diag(struct log *log, const struct cpu *cpu, int id, int ob, const struct start_info *info)
{
    char *p = text_word(text_str(begin_event(log, cpu, "diag"), ",\"id\":"), id, 4);
    p = put_info(p, "ob", ob, 0);
    if (info != NULL)
        p = put_start_info(put_info(p, "priority", info->priority, 0), info);
    end_event(log, p);
}

void log_end(struct log *log, const struct cpu *cpu, int ob)
{
    end_event(log, put_ob(begin_event(log, cpu, "end"), ob));
}

void log_clock(struct log *log, const struct cpu *cpu, dt_ms to)
{
    char *p = begin_event(log, cpu, "clock");
    p = text_str(p, ",\"to\":");
    end_event(log, text_dt(p, to));
}

void log_restart(struct log *log, const struct cpu *cpu, bool cold)
{
    char *p = begin_event(log, cpu, "restart");
    end_event(log, text_str(p, cold ? ",\"type\":\"cold\"" : ",\"type\":\"warm\""));
}

void log_stop(struct log *log, const struct cpu *cpu, int cause)
{
    end_event(log, put_info(begin_event(log, cpu, "stop"), "cause", cause, 4));
}

void log_mode(struct log *log, const struct cpu *cpu, const char *event)
{
    end_event(log, begin_event(log, cpu, event));
}

void log_interrupt(struct log *log, const struct cpu *cpu, int ob, int flt_id)
{
    char *p = put_ob(begin_event(log, cpu, "interrupt"), ob);
    end_event(log, put_info(p, "flt_id", flt_id, 2));
}

void log_block(struct log *log, const struct cpu *cpu, const char *event, int ob)
{
    end_event(log, put_ob(begin_event(log, cpu, event), ob));
}

static char *header_obs(char *p, const struct config *c)
{
    const char *comma = "";
    p = text_str(p, ",\"obs\":[");
    for (int ob = 0; ob < OB_MAX; ob++)
        if (c->loaded[ob]) {
            p = text_str(p, comma);
            p = text_int(p, ob);
            comma = ",";
        }
    *p++ = ']';
    return p;
}

static char *header_priority(char *p, const struct config *c)
{
    const char *before = ",\"priority\":{\"";
    const char *after = "";
    for (int ob = 0; ob < OB_MAX; ob++)
        if (c->priority[ob] != 0) {
            p = text_int(text_str(p, before), ob);
            p = text_int(text_str(p, "\":"), c->priority[ob]);
            before = ",\"";
            after = "}";
        }
    return text_str(p, after);
}

static char *header_step7(char *p, const struct config *c)
{
    const char *before = ",\"step7\":{\"tod\":{\"";
    const char *after = "";
    for (int k = 0; k < TOD_OBS; k++) {
        const struct step7_tod *s = &c->step7[k];
        const char *comma = "";
        if (!s->configured)
            continue;
        p = text_str(text_int(text_str(p, before), TOD_FIRST + k), "\":{");
        before = ",\"";
        after = "}}";
        if (s->execution != NULL) {
            p = text_str(text_str(text_str(p, "\"execution\":\""), s->execution), "\"");
            p = text_str(p, s->active ? ",\"active\":true" : ",\"active\":false");
            comma = ",";
        }
        if (s->has_start)
            p = text_dt(text_str(p, ",\"start\":"), s->start);
        if (s->deselected)
            p = text_str(text_str(p, comma), "\"deselected\":true");
        *p++ = '}';
    }
    return text_str(p, after);
}

void log_header(struct log *log, const struct cpu *cpu)
{
    static const char *const modes[] = {"STOP", "STARTUP", "RUN"};
    const struct config *c = &cpu->config;
    /* The header may be longer than the line of an event; the buffer is still empty here. */
    char *p = text_str(log->buffer, "{\"format\":\"s7-interrupt-log/1\",\"cpu\":\"");
    p = text_str(text_str(p, family_name(c->family)), "\"");
    p = header_obs(p, c);
    p = text_dt(text_str(p, ",\"clock\":"), c->clock);
    p = text_str(text_str(text_str(p, ",\"mode\":\""), modes[c->mode]), "\"");
    p = text_int(text_str(p, ",\"latency_ms\":"), c->latency_ms);
    p = text_str(p, ",\"records\":[\"call\",\"ob\",\"clock\",\"mode\",\"interrupt\",\"load\"");
    p = text_str(p, c->log_diag ? ",\"diag\"]" : "]");
    if (c->log_cycle)
        p = text_str(p, ",\"cycle\":true");
    p = header_priority(p, c);
    end_line(log, header_step7(p, c));
}

#include "actions.h"

#include "airt.h"
#include "dint.h"
#include "events.h"
#include "irt.h"
#include "modes.h"
#include "ret.h"
#include "tod.h"

/* One rule for every source of a clock change [CLK-01]. */
static void set_clock(struct cpu *cpu, dt_ms to)
{
    const dt_ms before = cpu_now(cpu);
    const enum mode mode = cpu->mode;
    if (to < 0 || to > dt_last())
        return;
    tod_poll(cpu); /* what is due in this millisecond has been reached, not skipped */
    if (cpu->mode != mode)
        return; /* an overlap without OB 80 has stopped the CPU */
    log_clock(cpu->log, cpu, to);
    clock_set(&cpu->clock, to);
    dint_clock_changed(cpu, to - before);
    tod_clock_changed(cpu, before);
}

void actions_step(struct cpu *cpu, const struct step *s)
{
    int ret, status = 0;
    switch (s->kind) {
    case STEP_BUSY:
        cpu_top(cpu)->busy = s->ms;
        break;
    case STEP_SET_TINT:
        ret = sfc_set_tint(cpu, s->ob, &s->sdt, s->period);
        log_set_tint(cpu->log, cpu, s->ob, &s->sdt, s->period, ret);
        break;
    case STEP_CAN_TINT:
        ret = sfc_can_tint(cpu, s->ob);
        log_call_ob(cpu->log, cpu, "CAN_TINT", s->ob, ret);
        break;
    case STEP_ACT_TINT:
        ret = sfc_act_tint(cpu, s->ob);
        log_call_ob(cpu->log, cpu, "ACT_TINT", s->ob, ret);
        break;
    case STEP_QRY_TINT:
        ret = sfc_qry_tint(cpu, s->ob, &status);
        log_qry(cpu->log, cpu, "QRY_TINT", s->ob, ret, status);
        break;
    case STEP_SRT_DINT:
        ret = sfc_srt_dint(cpu, s->ob, s->ms, s->sign);
        log_srt_dint(cpu->log, cpu, s->ob, s->ms, s->sign, ret);
        break;
    case STEP_CAN_DINT:
        ret = sfc_can_dint(cpu, s->ob);
        log_call_ob(cpu->log, cpu, "CAN_DINT", s->ob, ret);
        break;
    case STEP_QRY_DINT:
        ret = sfc_qry_dint(cpu, s->ob, &status);
        log_qry(cpu->log, cpu, "QRY_DINT", s->ob, ret, status);
        break;
    case STEP_DIS_IRT:
        ret = sfc_dis_irt(cpu, s->mode, s->ob);
        log_irt(cpu->log, cpu, "DIS_IRT", s->mode, s->ob, ret);
        if (ret == RET_OK)
            irt_report(cpu, s->mode); /* behind the line of the call, its cause */
        break;
    case STEP_EN_IRT:
        ret = sfc_en_irt(cpu, s->mode, s->ob);
        log_irt(cpu->log, cpu, "EN_IRT", s->mode, s->ob, ret);
        break;
    case STEP_DIS_AIRT:
        log_call(cpu->log, cpu, "DIS_AIRT", sfc_dis_airt(cpu));
        break;
    case STEP_EN_AIRT:
        log_call(cpu->log, cpu, "EN_AIRT", sfc_en_airt(cpu));
        break;
    case STEP_SET_CLOCK:
        set_clock(cpu, s->ms);
        break;
    case STEP_MOVE_CLOCK:
        set_clock(cpu, cpu_now(cpu) + s->ms);
        break;
    }
}

static void load(struct cpu *cpu, int ob, bool present)
{
    if (cpu->loaded[ob] == present)
        return;
    cpu->loaded[ob] = present; /* AMB-66: what runs goes on, what waits will be missing */
    log_block(cpu->log, cpu, present ? "load" : "delete", ob);
}

static void act(struct cpu *cpu, const struct action *a)
{
    switch (a->kind) {
    case ACTION_SET_CLOCK:
        set_clock(cpu, a->ms);
        break;
    case ACTION_MOVE_CLOCK:
        set_clock(cpu, cpu_now(cpu) + a->ms);
        break;
    case ACTION_INTERRUPT:
        events_interrupt(cpu, a->ob, a->flt_id);
        break;
    case ACTION_STOP:
        modes_stop(cpu, CAUSE_SWITCH);
        break;
    case ACTION_RESTART_WARM:
        modes_restart(cpu, false);
        break;
    case ACTION_RESTART_COLD:
        modes_restart(cpu, true);
        break;
    case ACTION_HOLD:
        modes_hold(cpu);
        break;
    case ACTION_RELEASE:
        modes_release(cpu);
        break;
    case ACTION_LOAD:
        load(cpu, a->ob, true);
        break;
    case ACTION_DELETE:
        load(cpu, a->ob, false);
        break;
    }
}

bool actions_poll(struct cpu *cpu)
{
    struct action action;
    if (cpu->program->action_time(cpu->program, cpu) > cpu->clock.up)
        return false;
    if (cpu->program->take_action(cpu->program, cpu, &action))
        act(cpu, &action);
    return true;
}

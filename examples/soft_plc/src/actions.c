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
    int ret = 0, status = 0;
    switch (s->kind) {
    case STEP_BUSY:
        cpu_top(cpu)->busy = s->ms;
        return;
    case STEP_SET_CLOCK:
        set_clock(cpu, s->ms);
        return;
    case STEP_MOVE_CLOCK:
        set_clock(cpu, cpu_now(cpu) + s->ms);
        return;
    case STEP_SET_TINT:
        ret = sfc_set_tint(cpu, s->ob, &s->sdt, s->period);
        break;
    case STEP_CAN_TINT:
        ret = sfc_can_tint(cpu, s->ob);
        break;
    case STEP_ACT_TINT:
        ret = sfc_act_tint(cpu, s->ob);
        break;
    case STEP_QRY_TINT:
        ret = sfc_qry_tint(cpu, s->ob, &status);
        break;
    case STEP_SRT_DINT:
        ret = sfc_srt_dint(cpu, s->ob, s->ms, s->sign);
        break;
    case STEP_CAN_DINT:
        ret = sfc_can_dint(cpu, s->ob);
        break;
    case STEP_QRY_DINT:
        ret = sfc_qry_dint(cpu, s->ob, &status);
        break;
    case STEP_DIS_IRT:
        ret = sfc_dis_irt(cpu, s->mode, s->ob);
        break;
    case STEP_EN_IRT:
        ret = sfc_en_irt(cpu, s->mode, s->ob);
        break;
    case STEP_DIS_AIRT:
        ret = sfc_dis_airt(cpu);
        break;
    case STEP_EN_AIRT:
        ret = sfc_en_airt(cpu);
        break;
    }
    log_call(cpu->log, cpu, s, ret, status);
    if (s->kind == STEP_DIS_IRT && ret == RET_OK)
        irt_report(cpu, s->mode); /* behind the line of the call, its cause */
}

static void load(struct cpu *cpu, int ob, bool present)
{
    if (cpu->loaded[ob] == present)
        return;
    cpu->loaded[ob] = present; /* AMB-66: what runs goes on, what waits will be missing */
    log_block(cpu->log, cpu, present, ob);
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

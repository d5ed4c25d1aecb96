#include "actions.h"

void actions_step(struct s7cpu *cpu, const struct step *s)
{
    struct s7cpu_state state;
    int status;
    switch (s->kind) {
    case STEP_BUSY:
        break;
    case STEP_SET_CLOCK:
        s7cpu_set_clock(cpu, s->ms);
        break;
    case STEP_MOVE_CLOCK:
        s7cpu_set_clock(cpu, s7cpu_clock(cpu) + s->ms);
        break;
    case STEP_SET_ZONE:
        s7cpu_set_zone(cpu, s->ms, s->daylight);
        break;
    case STEP_SET_TINT:
        s7cpu_set_tint(cpu, s->ob, &s->sdt, s->period);
        break;
    case STEP_SET_TINTL:
        s7cpu_set_tintl(cpu, s->ob, &s->sdt, s->local, s->period, s->activate);
        break;
    case STEP_CAN_TINT:
        s7cpu_can_tint(cpu, s->ob);
        break;
    case STEP_ACT_TINT:
        s7cpu_act_tint(cpu, s->ob);
        break;
    case STEP_QRY_TINT:
        s7cpu_qry_tint(cpu, s->ob, &status);
        break;
    case STEP_SRT_DINT:
        s7cpu_srt_dint(cpu, s->ob, s->ms, s->sign);
        break;
    case STEP_CAN_DINT:
        s7cpu_can_dint(cpu, s->ob);
        break;
    case STEP_QRY_DINT:
        s7cpu_qry_dint(cpu, s->ob, &status);
        break;
    case STEP_DIS_IRT:
        s7cpu_dis_irt(cpu, s->mode, s->ob);
        break;
    case STEP_EN_IRT:
        s7cpu_en_irt(cpu, s->mode, s->ob);
        break;
    case STEP_DIS_AIRT:
        s7cpu_dis_airt(cpu);
        break;
    case STEP_EN_AIRT:
        s7cpu_en_airt(cpu);
        break;
    case STEP_STATE:
        s7cpu_read_state(cpu, s->ob, &state);
        break;
    }
}

void actions_act(struct s7cpu *cpu, const struct action *a)
{
    struct s7cpu_state state;
    switch (a->kind) {
    case ACTION_SET_CLOCK:
        s7cpu_set_clock(cpu, a->ms);
        break;
    case ACTION_MOVE_CLOCK:
        s7cpu_set_clock(cpu, s7cpu_clock(cpu) + a->ms);
        break;
    case ACTION_SET_ZONE:
        s7cpu_set_zone(cpu, a->ms, a->daylight);
        break;
    case ACTION_INTERRUPT:
        s7cpu_interrupt(cpu, a->ob, a->flt_id);
        break;
    case ACTION_STOP:
        s7cpu_stop(cpu);
        break;
    case ACTION_RESTART_WARM:
        s7cpu_restart(cpu, S7CPU_WARM);
        break;
    case ACTION_RESTART_COLD:
        s7cpu_restart(cpu, S7CPU_COLD);
        break;
    case ACTION_RESTART_HOT:
        s7cpu_restart(cpu, S7CPU_HOT);
        break;
    case ACTION_HOLD:
        s7cpu_hold(cpu);
        break;
    case ACTION_RELEASE:
        s7cpu_release(cpu);
        break;
    case ACTION_LOAD:
        s7cpu_load(cpu, a->ob);
        break;
    case ACTION_DELETE:
        s7cpu_delete(cpu, a->ob);
        break;
    case ACTION_STATE:
        s7cpu_read_state(cpu, a->ob, &state);
        break;
    }
}

/* Operating modes and their transitions. */
#include "internal.h"

void s7_stop(struct s7cpu *cpu, int cause)
{
    if (cpu->mode == S7CPU_STOP)
        return;
    s7_diag_stop(cpu, cause);
    cpu->mode = S7CPU_STOP;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_TO_STOP, .id = cause});
    cpu->depth = 0; /* no OB runs [OBS-41] */
    cpu->queue_length = 0;
    cpu->delay_count = 0; /* [OBS-54] */
}

void s7cpu_stop(struct s7cpu *cpu)
{
    s7_stop(cpu, CAUSE_SWITCH);
}

bool s7_deselected_is_loaded(const struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_TODS; k++)
        if (cpu->config.step7[k].deselected && cpu->loaded[S7CPU_TOD_FIRST + k])
            return true;
    return false;
}

static void start_startup_ob(struct s7cpu *cpu, bool cold)
{
    struct s7cpu_request r = s7_request(cpu, cold ? 102 : 100, s7cpu_clock(cpu));
    r.info.strt_info = cold ? 0x85 : 0x81; /* manual restart */
    if (cpu->loaded[r.ob])
        s7_start(cpu, &r);
}

void s7cpu_restart(struct s7cpu *cpu, bool cold)
{
    s7_stop(cpu, CAUSE_SWITCH);
    cpu->mode = S7CPU_STARTUP;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_RESTART, .cold = cold});
    s7_irt_restart(cpu);
    s7_dint_restart(cpu);
    s7_tod_restart(cpu); /* before the startup OB, whose own calls then last [OBS-55] */
    if (s7_deselected_is_loaded(cpu))
        s7_stop(cpu, CAUSE_DESELECTED_LOADED); /* [OBS-25] */
    else
        start_startup_ob(cpu, cold);
}

void s7_to_run(struct s7cpu *cpu)
{
    cpu->mode = S7CPU_RUN;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_TO_RUN});
}

void s7cpu_hold(struct s7cpu *cpu)
{
    if (cpu->mode != S7CPU_RUN)
        return;
    cpu->mode = S7CPU_HOLD;
    cpu->hold_began = cpu->up;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_TO_HOLD});
}

void s7cpu_release(struct s7cpu *cpu)
{
    if (cpu->mode != S7CPU_HOLD)
        return;
    cpu->mode = S7CPU_RUN;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_RELEASE});
    s7_dint_released(cpu, cpu->up - cpu->hold_began);
    s7_tod_released(cpu);
}

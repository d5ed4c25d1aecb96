/* Operating modes and their transitions. */
#include <string.h>

#include "internal.h"

/* A STOP in STARTUP ends the startup OB for good: the OBs from before are those that go on. */
static void keep_for_hot_restart(struct s7cpu *cpu)
{
    struct s7cpu_stopped *s = &cpu->stopped;
    if (cpu->mode != S7CPU_STARTUP) {
        memcpy(s->stack, cpu->stack, sizeof s->stack);
        s->depth = cpu->depth;
        s->delay_count = cpu->delay_count;
    } else if (!cpu->resuming) {
        s->depth = s->delay_count = 0;
    }
    memcpy(s->queue, cpu->queue, sizeof s->queue);
    s->queue_length = cpu->queue_length;
    s->up = cpu->mode == S7CPU_HOLD ? cpu->hold_began : cpu->up;
}

void s7_stop(struct s7cpu *cpu, int cause)
{
    if (cpu->mode == S7CPU_STOP)
        return;
    s7_diag_stop(cpu, cause);
    keep_for_hot_restart(cpu);
    cpu->resuming = false;
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
        if (cpu->config.step7[k].deselected && cpu->loaded[s7cpu_tod_ob(k)])
            return true;
    return false;
}

static void start_startup_ob(struct s7cpu *cpu, enum s7cpu_restart type)
{
    static const int obs[] = {[S7CPU_WARM] = 100, [S7CPU_COLD] = 102, [S7CPU_HOT] = 101};
    static const int info[] = {[S7CPU_WARM] = STRT_INFO_WARM, [S7CPU_COLD] = 0x85, [S7CPU_HOT] = 0x83};
    struct s7cpu_request r = s7_request(cpu, obs[type], s7cpu_clock(cpu));
    r.info.strt_info = info[type]; /* manual restart */
    cpu->turn = r.ob;
    if (cpu->loaded[r.ob])
        s7_start(cpu, &r);
}

/* Before the startup OB, whose own calls then last [OBS-55]. */
static void reset(struct s7cpu *cpu)
{
    s7_irt_restart(cpu);
    s7_dint_restart(cpu);
    s7_tod_restart(cpu);
    cpu->stopped.depth = cpu->stopped.delay_count = 0;
    memset(cpu->discarded, 0, sizeof cpu->discarded);
}

/* [OBS-52], AMB-26 (reading a): settings, blocks, delays and requests are as they were; diagnostic
 * interrupts are discarded. */
static void resume(struct s7cpu *cpu)
{
    const struct s7cpu_stopped *s = &cpu->stopped;
    cpu->resuming = true;
    for (int i = 0; i < s->queue_length; i++)
        if (s->queue[i].ob != 82)
            cpu->queue[cpu->queue_length++] = s->queue[i];
    s7_dint_released(cpu, cpu->up - s->up);
    s7_tod_resumed(cpu);
}

void s7cpu_restart(struct s7cpu *cpu, enum s7cpu_restart type)
{
    if (!s7cpu_restart_exists(cpu->config.family, type))
        return;
    s7_stop(cpu, CAUSE_SWITCH);
    cpu->mode = S7CPU_STARTUP;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_RESTART, .restart = type});
    if (type == S7CPU_HOT)
        resume(cpu);
    else
        reset(cpu);
    if (cpu->mode == S7CPU_STOP)
        return; /* a point of the STOP, without OB 80 */
    if (s7_deselected_is_loaded(cpu))
        s7_stop(cpu, CAUSE_DESELECTED_LOADED); /* [OBS-25] */
    else
        start_startup_ob(cpu, type);
}

/* After a hot restart the OBs go on that STOP has interrupted, with their delay count [OBS-54]. */
void s7_to_run(struct s7cpu *cpu)
{
    cpu->mode = S7CPU_RUN;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_TO_RUN});
    if (!cpu->resuming)
        return;
    cpu->resuming = false;
    memcpy(cpu->stack, cpu->stopped.stack, sizeof cpu->stack);
    cpu->depth = cpu->stopped.depth;
    cpu->delay_count = cpu->stopped.delay_count;
}

void s7cpu_hold(struct s7cpu *cpu)
{
    if (cpu->mode != S7CPU_RUN && !(cpu->mode == S7CPU_STARTUP && s7_family(cpu)->holds_startup))
        return;
    cpu->held = cpu->mode;
    cpu->mode = S7CPU_HOLD;
    cpu->hold_began = cpu->up;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_TO_HOLD});
}

void s7cpu_release(struct s7cpu *cpu)
{
    if (cpu->mode != S7CPU_HOLD)
        return;
    cpu->mode = cpu->held;
    s7_emit(cpu, (struct s7cpu_event){.kind = S7CPU_RELEASE});
    s7_dint_released(cpu, cpu->up - cpu->hold_began);
    s7_tod_released(cpu);
}

#include "modes.h"

#include "diag.h"
#include "dint.h"
#include "events.h"
#include "irt.h"
#include "scheduler.h"
#include "tod.h"

static void forget_running(struct cpu *cpu)
{
    cpu->depth = 0;
    cpu->queue.length = 0;
    cpu->delay_count = 0; /* [OBS-54] */
}

void modes_stop(struct cpu *cpu, int cause)
{
    if (cpu->mode == MODE_STOP)
        return;
    diag_stop(cpu, cause);
    cpu->mode = MODE_STOP;
    log_stop(cpu->log, cpu, cause);
    forget_running(cpu); /* [OBS-41] */
}

static bool deselected_is_loaded(const struct cpu *cpu)
{
    for (int k = 0; k < TOD_OBS; k++)
        if (cpu->config.step7[k].deselected && cpu->loaded[TOD_FIRST + k])
            return true;
    return false;
}

void modes_restart(struct cpu *cpu, bool cold)
{
    int startup_ob = cold ? 102 : 100;
    modes_stop(cpu, CAUSE_SWITCH); /* a restart leads through STOP */
    cpu->mode = MODE_STARTUP;
    log_restart(cpu->log, cpu, cold);
    irt_restart(cpu);
    dint_restart(cpu);
    tod_restart(cpu); /* before the startup OB, whose own calls then last [OBS-55] */
    if (deselected_is_loaded(cpu)) {
        modes_stop(cpu, CAUSE_DESELECTED_LOADED); /* [OBS-25] */
        return;
    }
    if (cpu->loaded[startup_ob]) {
        struct request r = events_request(cpu, startup_ob, cpu_now(cpu));
        r.info.strt_info = cold ? 0x85 : 0x81; /* manual restart */
        scheduler_start(cpu, &r);
    }
}

void modes_run(struct cpu *cpu)
{
    cpu->mode = MODE_RUN;
    log_run(cpu->log, cpu);
}

void modes_hold(struct cpu *cpu)
{
    if (cpu->mode != MODE_RUN)
        return;
    cpu->mode = MODE_HOLD;
    cpu->hold_began = cpu->clock.up;
    log_hold(cpu->log, cpu);
}

void modes_release(struct cpu *cpu)
{
    if (cpu->mode != MODE_HOLD)
        return;
    cpu->mode = MODE_RUN;
    log_release(cpu->log, cpu);
    dint_released(cpu, cpu->clock.up - cpu->hold_began);
    tod_released(cpu, cpu_now(cpu));
}

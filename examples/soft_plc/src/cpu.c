/* The main loop: time, actions from outside, dispatch, one instruction of the running OB. */
#include "cpu.h"

#include <string.h>

#include "actions.h"
#include "dint.h"
#include "modes.h"
#include "scheduler.h"
#include "tod.h"

bool cpu_is_running(const struct cpu *cpu, int ob)
{
    for (int i = 0; i < cpu->depth; i++)
        if (cpu->stack[i].ob == ob)
            return true;
    return false;
}

int cpu_class(const struct cpu *cpu, int ob)
{
    if (cpu->mode == MODE_STARTUP && ob_kind(ob) == OB_ASYNC_ERROR &&
        !cpu_fault(cpu, FAULT_STARTUP_CLASS))
        return 28; /* [OBS-31, OBS-43], AMB-13 */
    if (cpu->config.priority[ob] != 0 && !cpu_fault(cpu, FAULT_PRIORITY_DEFAULT))
        return cpu->config.priority[ob];
    return ob_default_class(cpu->config.family, ob);
}

void cpu_begin(struct cpu *cpu, const struct config *config, struct program *program,
               struct log *log, bool real_time)
{
    memset(cpu, 0, sizeof *cpu);
    cpu->config = *config;
    memcpy(cpu->loaded, config->loaded, sizeof cpu->loaded);
    cpu->mode = config->mode;
    cpu->program = program;
    cpu->log = log;
    log_header(log, cpu);
    clock_start(&cpu->clock, real_time, config->clock);
    for (int k = 0; k < TOD_OBS; k++)
        cpu->tod[k].next = DT_NEVER;
    if (cpu->mode == MODE_RUN) {
        tod_begin_running(cpu);
        scheduler_enter(cpu, 1); /* OB 1 is running when the log begins */
    } else if (cpu->mode == MODE_STARTUP) {
        tod_restart(cpu);
        if (cpu->loaded[100])
            scheduler_enter(cpu, 100); /* so is the startup OB */
    }
}

static int64_t min64(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

/* Elapsed time of the next thing that comes by itself. */
static int64_t next_event_up(struct cpu *cpu)
{
    int64_t up = cpu->program->action_time(cpu->program, cpu);
    int64_t last = dt_last() - cpu->clock.offset; /* the clock has no later reading */
    int64_t due = min64(tod_next_up(cpu), dint_next_up(cpu));
    return min64(min64(up, due), min64(cpu->config.duration, last));
}

static void wait_until(struct cpu *cpu, int64_t up)
{
    int64_t begin = cpu->clock.up;
    clock_advance(&cpu->clock, min64(up, next_event_up(cpu)));
    if (cpu->depth > 0 && cpu->mode != MODE_HOLD) {
        struct frame *f = cpu_top(cpu);
        f->busy -= min64(f->busy, cpu->clock.up - begin);
    }
}

/* The body of OB 1 is done; the cycle may not be yet. */
static void end_of_body(struct cpu *cpu)
{
    struct frame *f = cpu_top(cpu);
    if (f->ob == 1) {
        int64_t rest = f->began + cpu->config.cycle_ms - cpu->clock.up;
        if (!cpu->config.log_cycle && cpu->delay_count == 0 &&
            cpu->program->idle(cpu->program, cpu)) {
            wait_until(cpu, INT64_MAX);
            return;
        }
        if (rest > 0) {
            f->busy = rest;
            return;
        }
    }
    scheduler_end(cpu);
}

static void run_top(struct cpu *cpu)
{
    struct frame *f = cpu_top(cpu);
    struct step step;
    if (f->busy > 0)
        wait_until(cpu, cpu->clock.up + f->busy);
    else if (cpu->program->next(cpu->program, cpu, f, &step))
        actions_step(cpu, &step);
    else
        end_of_body(cpu);
}

static void run_once(struct cpu *cpu)
{
    if (cpu->mode == MODE_STOP || cpu->mode == MODE_HOLD)
        wait_until(cpu, INT64_MAX);
    else if (scheduler_dispatch(cpu))
        return;
    else if (cpu->depth > 0)
        run_top(cpu);
    else if (cpu->mode == MODE_STARTUP)
        modes_run(cpu);
    else
        scheduler_start_cycle(cpu);
}

static bool is_over(struct cpu *cpu)
{
    return cpu->log->s7.failed || cpu->log->s7.events >= cpu->config.max_events ||
           cpu->clock.up >= cpu->config.duration || cpu_now(cpu) >= dt_last();
}

void cpu_run(struct cpu *cpu)
{
    while (!is_over(cpu)) {
        clock_read(&cpu->clock);
        tod_poll(cpu);
        dint_poll(cpu);
        if (!actions_poll(cpu))
            run_once(cpu);
    }
}

/* The main loop: time, actions from outside, the operating system, an instruction of the OB that
 * runs. */
#include "plc.h"

#include <string.h>

#include "actions.h"

static int64_t min64(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

/* Elapsed time at which the CPU clock has its last reading. */
static int64_t last_up(const struct plc *plc)
{
    const struct s7cpu *cpu = &plc->faulty.cpu;
    return S7CPU_LAST - s7cpu_clock(cpu) + s7cpu_up(cpu);
}

/* Lets time pass until `up`, or until the next thing that comes by itself. */
static void wait_until(struct plc *plc, int64_t up)
{
    const int64_t begin = plc->clock.up;
    up = min64(up, plc->program->action_time(plc->program));
    up = min64(up, s7cpu_next_up(&plc->faulty.cpu));
    up = min64(up, min64(plc->config.duration, last_up(plc)));
    clock_advance(&plc->clock, up);
    if (plc->depth > 0 && s7cpu_mode(&plc->faulty.cpu) != S7CPU_HOLD) {
        struct activation *a = &plc->stack[plc->depth - 1];
        a->busy -= min64(a->busy, plc->clock.up - begin);
    }
}

/* The body of OB 1 is done; the cycle may not be yet. */
static bool cycle_goes_on(struct plc *plc, struct activation *a)
{
    int64_t rest = a->began + plc->config.cycle_ms - plc->clock.up;
    if (!plc->config.log.cycle && s7cpu_delay_count(&plc->faulty.cpu) == 0 &&
        plc->program->idle(plc->program, &plc->faulty.cpu)) {
        if (rest > 0) /* else something has come after many such cycles: the next one begins */
            wait_until(plc, INT64_MAX);
        return rest > 0;
    }
    if (rest > 0)
        a->busy = rest;
    return rest > 0;
}

static void run_instruction(struct plc *plc)
{
    struct s7cpu *cpu = &plc->faulty.cpu;
    struct activation *a = &plc->stack[plc->depth - 1];
    struct step step;
    if (a->busy > 0) {
        wait_until(plc, plc->clock.up + a->busy);
    } else if (plc->program->next(plc->program, cpu, a, &step)) {
        if (step.kind == STEP_BUSY)
            a->busy = step.ms;
        else
            actions_step(cpu, &step);
    } else if (a->ob != 1 || !cycle_goes_on(plc, a)) {
        s7cpu_end_ob(cpu);
    }
}

static bool is_of(const struct activation *a, const struct s7cpu_frame *frame)
{
    return a->ob == frame->ob && a->run == frame->run;
}

/* Follows the stack of the CPU, in which at most one OB has been started since the last call; or
 * STOP has ended all, or a hot restart has brought them back. */
static void follow(struct plc *plc)
{
    const struct s7cpu *cpu = &plc->faulty.cpu;
    const struct s7cpu_frame *top = s7cpu_top(cpu);
    const bool runs = s7cpu_mode(cpu) == S7CPU_RUN || s7cpu_mode(cpu) == S7CPU_HOLD;
    if (plc->ran && !runs)
        memcpy(plc->stopped, plc->stack, sizeof plc->stopped);
    if (!plc->ran && runs) /* the startup OB has taken the lowest place */
        memcpy(plc->stack, plc->stopped, sizeof plc->stack);
    plc->ran = runs;
    plc->depth = s7cpu_depth(cpu);
    if (top == NULL)
        return;
    struct activation *a = &plc->stack[plc->depth - 1];
    if (is_of(a, top))
        return;
    *a = (struct activation){.ob = top->ob, .run = top->run, .began = plc->clock.up};
    plc->program->begin(plc->program, cpu, a);
}

static bool take_action(struct plc *plc)
{
    struct action action;
    if (plc->program->action_time(plc->program) > plc->clock.up)
        return false;
    if (plc->program->take_action(plc->program, &plc->faulty.cpu, &action))
        actions_act(&plc->faulty.cpu, &action);
    return true;
}

static bool is_over(const struct plc *plc)
{
    return plc->log->s7.failed || plc->log->s7.events >= plc->config.max_events ||
           plc->clock.up >= plc->config.duration || plc->clock.up >= last_up(plc);
}

void plc_run(struct plc *plc, const struct plc_config *config, struct program *program,
             struct log *log, bool real_time)
{
    struct s7cpu *cpu = &plc->faulty.cpu;
    *plc = (struct plc){.config = *config, .program = program, .log = log};
    plc->faulty.faults = config->faults;
    log_header(log, &config->cpu, &config->log);
    clock_start(&plc->clock, real_time);
    s7cpu_init(cpu, &config->cpu, log_event, log);
    follow(plc);
    while (!is_over(plc)) {
        clock_read(&plc->clock);
        s7cpu_tick(cpu, plc->clock.up);
        if (!take_action(plc) && !s7cpu_dispatch(cpu)) {
            if (s7cpu_top(cpu) != NULL && s7cpu_mode(cpu) != S7CPU_HOLD)
                run_instruction(plc);
            else
                wait_until(plc, INT64_MAX);
        }
        follow(plc);
    }
    if (plc->clock.up >= config->duration || plc->clock.up >= last_up(plc))
        log_done(log, s7cpu_clock(cpu) + plc->clock.up - s7cpu_up(cpu), plc->clock.up);
}

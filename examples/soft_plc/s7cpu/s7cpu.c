/* The CPU begins, and time passes. */
#include "s7cpu.h"

#include <string.h>

#include "internal.h"

static void enter_startup(struct s7cpu *cpu)
{
    cpu->turn = 100;
    const int first = cpu->loaded[100] ? 100 : s7_next_in_turn(cpu);
    if (first != S7CPU_NONE)
        s7_enter(cpu, first);
}

void s7cpu_init(struct s7cpu *cpu, const struct s7cpu_config *config, s7cpu_sink *sink,
                void *context)
{
    memset(cpu, 0, sizeof *cpu);
    cpu->config = *config;
    cpu->sink = sink;
    cpu->context = context;
    cpu->offset = config->clock;
    cpu->zone = config->zone;
    cpu->mode = config->mode;
    memcpy(cpu->loaded, config->loaded, sizeof cpu->loaded);
    for (int k = 0; k < S7CPU_TODS; k++)
        cpu->tod[k].next = S7CPU_NEVER;
    if (cpu->mode == S7CPU_RUN) {
        s7_tod_begin_running(cpu);
        s7_enter(cpu, 1);
    } else if (cpu->mode == S7CPU_STARTUP) {
        s7_tod_restart(cpu);
        if (s7_deselected_is_loaded(cpu))
            s7_stop(cpu, CAUSE_DESELECTED_LOADED); /* [OBS-25] */
        else
            enter_startup(cpu);
    } else {
        s7_tod_restart(cpu); /* a hot restart finds the settings of STEP 7 */
    }
}

void s7cpu_tick(struct s7cpu *cpu, int64_t up)
{
    cpu->up = up;
    s7_tod_poll(cpu);
    s7_dint_poll(cpu);
}

int64_t s7cpu_next_up(const struct s7cpu *cpu)
{
    int64_t tod = s7_tod_next_up(cpu), dint = s7_dint_next_up(cpu);
    return tod < dint ? tod : dint;
}

enum s7cpu_mode s7cpu_mode(const struct s7cpu *cpu)
{
    return cpu->mode;
}

uint32_t s7cpu_runs(const struct s7cpu *cpu, int ob)
{
    return cpu->runs[ob];
}

bool s7cpu_is_loaded(const struct s7cpu *cpu, int ob)
{
    return cpu->loaded[ob];
}

int64_t s7cpu_clock(const struct s7cpu *cpu)
{
    return cpu->offset + cpu->up;
}

int64_t s7cpu_zone(const struct s7cpu *cpu)
{
    return cpu->zone;
}

int s7cpu_delay_count(const struct s7cpu *cpu)
{
    return cpu->delay_count;
}

int64_t s7cpu_up(const struct s7cpu *cpu)
{
    return cpu->up;
}

int s7cpu_depth(const struct s7cpu *cpu)
{
    return cpu->depth;
}

#include "internal.h"

static bool tod_is_active(const struct s7cpu *cpu, int ob)
{
    const struct s7cpu_tod *t = &cpu->tod[s7cpu_tod_index(ob)];
    bool waiting_once = t->period == PERIOD_ONCE && s7_queue_has(cpu, ob);
    return t->active && !(waiting_once && cpu->config.choices.waiting_once_is_inactive);
}

static bool dint_is_active(const struct s7cpu *cpu, int ob)
{
    return cpu->dint[s7cpu_dint_index(ob)].started ||
           (cpu->config.choices.waiting_delay_is_active && s7_queue_has(cpu, ob));
}

bool s7_is_active(const struct s7cpu *cpu, int ob)
{
    return s7_ob_kind(ob) == OB_TOD ? tod_is_active(cpu, ob) : dint_is_active(cpu, ob);
}

int s7_status(const struct s7cpu *cpu, int ob)
{
    int status = 0; /* bits 3, 5 and 7 to 15 are 0 [TINT-75, 77, 79] */
    if (cpu->mode == S7CPU_STARTUP)
        status |= 1 << 0; /* [TINT-72], AMB-03 */
    if (s7_family(cpu)->status_shows_delay ? s7_airt_delays(cpu) : cpu->mask[ob].blocked)
        status |= 1 << 1; /* [IRT-17]; a delay by SFC 41 does not show elsewhere [AIRT-13] */
    if (s7_is_active(cpu, ob))
        status |= 1 << 2; /* [TINT-74] */
    if (cpu->loaded[ob])
        status |= 1 << 4; /* [TINT-76] */
    if (s7_ob_kind(ob) == OB_TOD && cpu->tod[s7cpu_tod_index(ob)].local)
        status |= 1 << 6; /* [TINT-78, T15-144] */
    return status;
}

/* [DINT-17]; HOLD freezes the delay [DINT-19]. */
static int left(const struct s7cpu *cpu, int ob)
{
    const struct s7cpu_dint *d = &cpu->dint[s7cpu_dint_index(ob)];
    int64_t now = cpu->mode == S7CPU_HOLD ? cpu->hold_began : cpu->up;
    int64_t rest = d->end - now;
    if (rest > 0 && cpu->config.choices.shows_less_time_left)
        rest--;
    return d->started ? (int)rest : S7CPU_NONE;
}

struct s7cpu_state s7_state(const struct s7cpu *cpu, int ob)
{
    struct s7cpu_state s = {.active = S7CPU_NONE,
                            .blocked = S7CPU_NONE,
                            .entries_off = S7CPU_NONE,
                            .loaded = cpu->loaded[ob],
                            .left = S7CPU_NONE};
    if (cpu->mode == S7CPU_STOP)
        return s;
    if (s7_ob_kind(ob) == OB_TOD || s7_ob_kind(ob) == OB_DELAY)
        s.active = s7_is_active(cpu, ob);
    if (s7_ob_irt_class(ob) != 0) {
        s.blocked = cpu->mask[ob].blocked;
        s.entries_off = cpu->mask[ob].silent; /* [IRT-20] */
    }
    if (s7_ob_kind(ob) == OB_DELAY)
        s.left = left(cpu, ob);
    return s;
}

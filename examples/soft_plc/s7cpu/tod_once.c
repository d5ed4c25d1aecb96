/* A one-shot interrupt is cancelled by the call of its OB [TINT-08], AMB-08 (reading a). AMB-71,
 * a or c: when the OB starts or when it ends; a clock that is set back meanwhile does not arm it
 * again [CLK-12], and a SET_TINT inside the OB lasts [TINT-65]. */
#include "internal.h"

/* A run that has waited over a large step back serves nothing: its point comes again [T15-94]. */
static void serve(const struct s7cpu *cpu, struct s7cpu_tod *t, int64_t point)
{
    if (point <= t->again && point > s7cpu_clock(cpu))
        return;
    if (t->served == S7CPU_NONE || point < t->served_from)
        t->served_from = point;
    if (t->served == S7CPU_NONE || point > t->served)
        t->served = point;
}

void s7_tod_called(struct s7cpu *cpu, int ob, int64_t point)
{
    struct s7cpu_tod *t = &cpu->tod[s7cpu_tod_index(ob)];
    serve(cpu, t, point);
    if (t->set && t->period == PERIOD_ONCE) {
        if (cpu->config.choices.once_ends_with_its_ob)
            t->called = true;
        else
            s7_tod_used_up(cpu, ob);
    }
}

/* AMB-46, reading a: a missing OB counts as called: its point is over, a periodic one stays active,
 * a one-shot interrupt is used up. */
void s7_tod_missed(struct s7cpu *cpu, int ob, int64_t point)
{
    serve(cpu, &cpu->tod[s7cpu_tod_index(ob)], point);
    s7_tod_used_up(cpu, ob);
}

void s7_tod_ended(struct s7cpu *cpu, int ob)
{
    if (cpu->tod[s7cpu_tod_index(ob)].called)
        s7_tod_used_up(cpu, ob);
}

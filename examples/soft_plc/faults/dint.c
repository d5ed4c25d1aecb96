#include "variant.h"

enum { DTIME_MAX = 60000, COARSE_MS = 10 };

/* NULL where the library refuses OB_NR. */
static struct s7cpu_dint *dint_of(struct s7cpu *cpu, int ob_nr)
{
    return s7_ob_kind(ob_nr) == OB_DELAY ? &cpu->dint[s7cpu_dint_index(ob_nr)] : NULL;
}

/* The limits of DTIME that the fault lifts. */
static int64_t limited(const struct s7cpu *cpu, int64_t dtime)
{
    if (dtime == 0 && has(cpu, FAULT_DINT_ZERO))
        return 1;
    return dtime > DTIME_MAX && has(cpu, FAULT_DINT_NO_LIMIT) ? DTIME_MAX : dtime;
}

int faulty_dint_start(struct s7cpu *cpu, int ob_nr, int64_t dtime, int sign)
{
    struct s7cpu_dint *d = dint_of(cpu, ob_nr);
    const struct s7cpu_dint before = d != NULL ? *d : (struct s7cpu_dint){0};
    if (has(cpu, FAULT_DINT_CAN_MIXED))
        cpu->config.choices.waiting_delay_is_withdrawn = false;
    int ret = s7_dint_start(cpu, ob_nr, limited(cpu, dtime), sign);
    if (ret != RET_OK)
        return ret;
    d->dtime = (int)dtime;
    d->end = cpu->up + dtime;
    if (has(cpu, FAULT_DINT_COARSE))
        d->end -= dtime % COARSE_MS;
    if (before.started && has(cpu, FAULT_DINT_KEEPS_SIGN))
        d->sign = before.sign;
    if (before.started && has(cpu, FAULT_DINT_NO_RETRIGGER))
        *d = before;
    return ret;
}
SUBSTITUTES(dint_start);

int faulty_dint_cancel(struct s7cpu *cpu, int ob_nr)
{
    struct s7cpu_dint *d = dint_of(cpu, ob_nr);
    bool waits = d != NULL && s7_queue_has(cpu, ob_nr);
    if (has(cpu, FAULT_DINT_CAN_RUNS) && waits) {
        d->started = false;
        return RET_OK;
    }
    if (has(cpu, FAULT_DINT_CAN_LOSES) && waits) {
        s7_queue_withdraw(cpu, ob_nr);
        cpu->config.choices.waiting_delay_is_withdrawn = false;
    }
    if (has(cpu, FAULT_DINT_CAN_MIXED))
        cpu->config.choices.waiting_delay_is_withdrawn = true;
    int ret = s7_dint_cancel(cpu, ob_nr);
    if (ret == RET_OK && has(cpu, FAULT_DINT_CAN_KEEPS))
        d->started = true;
    return ret == RET_NOT_STARTED && has(cpu, FAULT_DINT_CAN_ANY) ? RET_OK : ret;
}
SUBSTITUTES(dint_cancel);

void faulty_dint_restart(struct s7cpu *cpu)
{
    if (!has(cpu, FAULT_DINT_SURVIVES))
        s7_dint_restart(cpu);
}
SUBSTITUTES(dint_restart);

void faulty_dint_released(struct s7cpu *cpu, int64_t held)
{
    if (!has(cpu, FAULT_DINT_RUNS_IN_HOLD))
        s7_dint_released(cpu, held);
}
SUBSTITUTES(dint_released);

#include "variant.h"

static struct s7cpu_tod *tod_of(struct s7cpu *cpu, int ob_nr)
{
    return &cpu->tod[s7cpu_tod_index(ob_nr)];
}

static int set_monthly_31(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, bool local)
{
    struct s7cpu_date allowed = *sdt;
    allowed.day = 28;
    int ret = s7_tod_set(cpu, ob_nr, &allowed, local, PERIOD_MONTHLY);
    if (ret == RET_OK)
        tod_of(cpu, ob_nr)->start += (sdt->day - allowed.day) * S7CPU_DAY;
    return ret;
}

static int set_with_seconds(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, bool local,
                            int period)
{
    int64_t start = s7cpu_date_exists(sdt) ? s7cpu_ms(sdt) : 0;
    bool past = period == PERIOD_ONCE && start < s7cpu_clock(cpu);
    /* A periodic one is not refused where only the cut-off start is past. */
    int as = period == PERIOD_ONCE && !past ? PERIOD_MINUTE : period;
    int ret = s7_tod_set(cpu, ob_nr, sdt, local, as);
    if (ret == RET_OK) {
        tod_of(cpu, ob_nr)->start = start;
        tod_of(cpu, ob_nr)->period = period;
    }
    return ret;
}

/* As what SFC 28 treats a periodic interrupt that is past. */
static int set_as(const struct s7cpu *cpu, const struct s7cpu_date *sdt, int period)
{
    bool right = s7cpu_date_exists(sdt) && s7_period_known(period) &&
                 (period != PERIOD_MONTHLY || sdt->day <= 28);
    if (!right)
        return period;
    int64_t start = s7cpu_ms(sdt);
    return start - start % S7CPU_MINUTE < s7cpu_clock(cpu) ? PERIOD_ONCE : period;
}

int faulty_tod_set(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, bool local,
                   int period)
{
    const struct s7cpu_date none = {0};
    if (has(cpu, FAULT_LEAP_CENTURY) && sdt->year == 2000 && sdt->month == 2 && sdt->day == 29)
        sdt = &none;
    if (has(cpu, FAULT_SET_PAST_ALL))
        period = set_as(cpu, sdt, period);
    if (has(cpu, FAULT_MONTHLY_31) && period == PERIOD_MONTHLY && sdt->day > 28 &&
        s7cpu_date_exists(sdt))
        return set_monthly_31(cpu, ob_nr, sdt, local);
    if (has(cpu, FAULT_KEEP_SECONDS))
        return set_with_seconds(cpu, ob_nr, sdt, local, period);
    int ret = s7_tod_set(cpu, ob_nr, sdt, local, period);
    if (ret == RET_OK && has(cpu, FAULT_SET_ACTIVATES)) {
        tod_of(cpu, ob_nr)->active = true;
        tod_of(cpu, ob_nr)->next =
            s7_tod_first_point(cpu, s7cpu_tod_index(ob_nr), s7cpu_clock(cpu));
    }
    return ret;
}
SUBSTITUTES(tod_set);

int faulty_tod_cancel(struct s7cpu *cpu, int ob_nr)
{
    int status;
    bool offered = s7_tod_query(cpu, ob_nr, &status) == RET_OK;
    if (has(cpu, FAULT_CAN_KEEPS_REQUEST) && offered && tod_of(cpu, ob_nr)->set) {
        *tod_of(cpu, ob_nr) =
            (struct s7cpu_tod){.next = S7CPU_NEVER, .served = S7CPU_NONE};
        return RET_OK;
    }
    int ret = s7_tod_cancel(cpu, ob_nr);
    if (ret == RET_OK && has(cpu, FAULT_CAN_KEEPS_DATE))
        tod_of(cpu, ob_nr)->set = true;
    return ret;
}
SUBSTITUTES(tod_cancel);

int faulty_tod_activate(struct s7cpu *cpu, int ob_nr)
{
    int64_t highest = faulty(cpu)->clock_highest;
    int ret = s7_tod_activate(cpu, ob_nr);
    if (ret == RET_OK && has(cpu, FAULT_BACK_BLOCKS_NEW) && highest > s7cpu_clock(cpu) &&
        cpu->config.family != S7CPU_S7_300)
        tod_of(cpu, ob_nr)->next = s7_tod_first_point(cpu, s7cpu_tod_index(ob_nr), highest);
    if (ret != RET_PAST || !has(cpu, FAULT_ACT_NO_80A1))
        return ret;
    tod_of(cpu, ob_nr)->active = true;
    return RET_OK;
}
SUBSTITUTES(tod_activate);

void faulty_tod_used_up(struct s7cpu *cpu, int ob)
{
    if (!has(cpu, FAULT_ONCE_STAYS))
        s7_tod_used_up(cpu, ob);
}
SUBSTITUTES(tod_used_up);

static void overlap_with_run(struct s7cpu *cpu, int k, int64_t point)
{
    struct s7cpu_request r = s7_request(cpu, s7cpu_tod_ob(k), point);
    r.info.period = cpu->tod[k].period;
    s7_error_overlap(cpu, r.ob, r.info.period);
    if (cpu->mode != S7CPU_STOP)
        s7_queue_put(cpu, &r);
}

void faulty_tod_overlap(struct s7cpu *cpu, int k, int64_t point)
{
    if (has(cpu, FAULT_OVERLAP_SILENT))
        s7_tod_request(cpu, k, point);
    else if (has(cpu, FAULT_OVERLAP_LOST))
        s7_error_overlap(cpu, s7cpu_tod_ob(k), cpu->tod[k].period);
    else if (has(cpu, FAULT_OVERLAP_RUNS_EACH))
        overlap_with_run(cpu, k, point);
    else
        s7_tod_overlap(cpu, k, point);
}
SUBSTITUTES(tod_overlap);

static void forget_all(struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_TODS; k++)
        cpu->tod[k] = (struct s7cpu_tod){.next = S7CPU_NEVER, .served = S7CPU_NONE};
}

void faulty_tod_restart(struct s7cpu *cpu)
{
    if (has(cpu, FAULT_RESTART_KEEPS_SFC))
        return;
    s7_tod_restart(cpu);
    if (has(cpu, FAULT_RESTART_NO_STEP7))
        forget_all(cpu);
}
SUBSTITUTES(tod_restart);

void faulty_tod_begin_running(struct s7cpu *cpu)
{
    s7_tod_begin_running(cpu);
    if (has(cpu, FAULT_RESTART_NO_STEP7))
        forget_all(cpu);
}
SUBSTITUTES(tod_begin_running);

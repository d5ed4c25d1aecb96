/* SFC 28 to 31. An error changes nothing (AMB-20, reading a). Of several wrong arguments the
 * first in the order OB_NR, SDT, PERIOD, past is reported (AMB-63: any of them is right). */
#include "internal.h"

enum { MONTHLY_LAST_DAY = 28 };

/* AMB-61, either: a deselected OB is no valid OB_NR here (reading a). */
static bool is_offered(const struct s7cpu *cpu, int ob_nr) /* [TINT-01] */
{
    return s7_ob_kind(ob_nr) == OB_TOD && !cpu->config.step7[s7cpu_tod_index(ob_nr)].deselected;
}

/* [TINT-18, TINT-39], AMB-05 */
static bool sdt_is_right(const struct s7cpu *cpu, const struct s7cpu_date *sdt, int period)
{
    struct s7cpu_date date = *sdt;
    if (cpu->config.choices.wrong_seconds_are_ignored)
        date.second = 0; /* AMB-79 */
    return s7cpu_date_exists(&date) && (period != PERIOD_MONTHLY || date.day <= MONTHLY_LAST_DAY);
}

/* Seconds are cut off [TINT-11], before anything is compared (AMB-14, reading a). */
static int64_t start_point(const struct s7cpu_date *sdt)
{
    const struct s7cpu_date start = {sdt->year, sdt->month, sdt->day, sdt->hour, sdt->minute, 0, 0};
    return s7cpu_ms(&start);
}

/* [TINT-36, TINT-37, TINT-61, TINT-62], AMB-02: only a one-shot interrupt can be past; equal is not
 * (AMB-37). */
static bool is_past(const struct s7cpu *cpu, const struct s7cpu_tod *t)
{
    return t->period == PERIOD_ONCE && s7_tod_start(cpu, t) < s7cpu_clock(cpu);
}

/* Setting and activating may need a loaded OB (A15-13). */
static bool may_be_set(const struct s7cpu *cpu, int ob_nr)
{
    return is_offered(cpu, ob_nr) && (cpu->loaded[ob_nr] || !s7_family(cpu)->refuses_missing);
}

int s7_tod_set(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, bool local, int period)
{
    if (!may_be_set(cpu, ob_nr))
        return RET_BAD_OB;
    if (!sdt_is_right(cpu, sdt, period))
        return RET_BAD_SDT;
    if (!s7_period_known(period) || (period == PERIOD_WEEKLY_ALT && !s7_family(cpu)->takes_1202))
        return RET_BAD_PERIOD;
    const struct s7cpu_tod set = {
        .set = true, .active = false, /* [TINT-05, TINT-30] */
        .start = start_point(sdt), .local = local, .period = period, .next = S7CPU_NEVER,
        .served = S7CPU_NONE, .again = S7CPU_NONE};
    if (is_past(cpu, &set))
        return RET_PAST;

    s7_queue_withdraw(cpu, ob_nr); /* [TINT-31] */
    cpu->tod[s7cpu_tod_index(ob_nr)] = set;
    return RET_OK;
}

int s7_tod_cancel(struct s7cpu *cpu, int ob_nr)
{
    if (!is_offered(cpu, ob_nr))
        return RET_BAD_OB;
    struct s7cpu_tod *t = &cpu->tod[s7cpu_tod_index(ob_nr)];
    if (!t->set)
        return RET_NOT_SET; /* [TINT-51] */
    s7_queue_withdraw(cpu, ob_nr);          /* AMB-11; a running OB goes on [TINT-53] */
    t->set = t->active = t->called = false; /* [TINT-50]: SET must come before ACT */
    t->next = S7CPU_NEVER;
    return RET_OK;
}

int s7_tod_activate(struct s7cpu *cpu, int ob_nr)
{
    if (!may_be_set(cpu, ob_nr))
        return RET_BAD_OB;
    int k = s7cpu_tod_index(ob_nr);
    struct s7cpu_tod *t = &cpu->tod[k];
    if (!t->set)
        return RET_NOT_SET;
    if (t->active && !cpu->config.choices.waiting_once_is_past)
        return RET_OK; /* [TINT-63], AMB-10, AMB-60 */
    if (is_past(cpu, t))
        return RET_PAST;
    if (t->active)
        return RET_OK;
    t->active = true;
    t->next = s7_tod_first_point(cpu, k, s7cpu_clock(cpu)); /* [TINT-10] */
    return RET_OK;
}

int s7_tod_query(const struct s7cpu *cpu, int ob_nr, int *status)
{
    if (!is_offered(cpu, ob_nr))
        return RET_BAD_OB;
    *status = s7_status(cpu, ob_nr);
    return RET_OK;
}

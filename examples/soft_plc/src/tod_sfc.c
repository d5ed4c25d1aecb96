/* SFC 28 to 31. An error changes nothing (AMB-20, reading a). Of several wrong arguments the
 * first in the order OB_NR, SDT, PERIOD, past is reported (AMB-63: any of them is right). */
#include "queue.h"
#include "ret.h"
#include "status.h"
#include "tod.h"

/* The interrupt of an OB number, NULL where it is a bad OB_NR [TINT-01].
 * AMB-61, either: a deselected OB is no valid OB_NR here (reading a). */
static struct tod *find(struct cpu *cpu, int ob)
{
    if (!ob_is_tod(ob) || cpu->config.step7[ob - TOD_FIRST].deselected)
        return NULL;
    return &cpu->tod[ob - TOD_FIRST];
}

static void withdraw(struct cpu *cpu, int ob)
{
    queue_withdraw(&cpu->queue, ob); /* AMB-11, reading c; a running OB goes on [TINT-53] */
}

int sfc_set_tint(struct cpu *cpu, int ob, const struct civil *sdt, int period)
{
    struct tod *t = find(cpu, ob);
    unsigned quirks = faults_calendar_quirks(&cpu->config.faults);
    if (t == NULL)
        return RET_BAD_OB;
    if (!civil_exists(sdt, quirks))
        return RET_BAD_SDT;
    if (period == PERIOD_MONTHLY && sdt->day > 28 && !cpu_fault(cpu, FAULT_MONTHLY_31))
        return RET_BAD_SDT; /* [TINT-18, TINT-39], AMB-05 */
    if (!period_known(period))
        return RET_BAD_PERIOD;

    struct civil start = *sdt;
    if (!cpu_fault(cpu, FAULT_KEEP_SECONDS))
        start.second = start.ms = 0; /* [TINT-11]; cut off before the comparison (AMB-14) */
    dt_ms point = civil_to_dt(&start);
    /* [TINT-36, TINT-37], AMB-02: only a single start can be past; equal is not (AMB-37). */
    if (point < cpu_now(cpu) && (period == PERIOD_ONCE || cpu_fault(cpu, FAULT_SET_PAST_ALL)))
        return RET_PAST;

    withdraw(cpu, ob); /* [TINT-31] */
    t->set = true;
    t->active = cpu_fault(cpu, FAULT_SET_ACTIVATES); /* [TINT-05, TINT-30]: not active */
    t->start = point;
    t->period = period;
    t->next = t->active ? series_first(point, period, cpu_now(cpu), quirks) : DT_NEVER;
    return RET_OK;
}

int sfc_can_tint(struct cpu *cpu, int ob)
{
    struct tod *t = find(cpu, ob);
    if (t == NULL)
        return RET_BAD_OB;
    if (!t->set)
        return RET_NOT_SET; /* [TINT-51] */
    if (!cpu_fault(cpu, FAULT_CAN_KEEPS_REQUEST))
        withdraw(cpu, ob);
    t->set = cpu_fault(cpu, FAULT_CAN_KEEPS_DATE); /* [TINT-50]: SET must come before ACT */
    t->active = false;
    t->next = DT_NEVER;
    return RET_OK;
}

int sfc_act_tint(struct cpu *cpu, int ob)
{
    struct tod *t = find(cpu, ob);
    if (t == NULL)
        return RET_BAD_OB;
    if (!t->set)
        return RET_NOT_SET;
    if (t->active)
        return RET_OK; /* [TINT-63], AMB-10; AMB-60, either: also while a once waits (reading a) */
    if (t->period == PERIOD_ONCE && t->start < cpu_now(cpu)) {
        if (!cpu_fault(cpu, FAULT_ACT_NO_80A1))
            return RET_PAST; /* [TINT-61]; a periodic one never is [TINT-62] */
    }
    t->active = true;
    t->next = series_first(t->start, t->period, cpu_now(cpu),
                           faults_calendar_quirks(&cpu->config.faults)); /* [TINT-10] */
    return RET_OK;
}

int sfc_qry_tint(struct cpu *cpu, int ob, int *status)
{
    const struct tod *t = find(cpu, ob);
    if (t == NULL)
        return RET_BAD_OB;
    /* A once is active until its OB starts (AMB-34, AMB-71). */
    *status = status_word(cpu, ob, t->active);
    return RET_OK;
}

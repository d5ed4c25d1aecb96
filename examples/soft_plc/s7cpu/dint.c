/* Time-delay interrupts: SFC 32 to 34 on OB 20 to 23, and their delays in elapsed time. */
#include "internal.h"

enum { DTIME_MAX = 60000 };

static bool is_offered(int ob_nr) /* [DINT-05], AMB-64 */
{
    return s7_ob_kind(ob_nr) == OB_DELAY;
}

int s7_dint_start(struct s7cpu *cpu, int ob_nr, int64_t dtime, int sign)
{
    if (!is_offered(ob_nr))
        return RET_BAD_OB;
    if (s7_family(cpu)->refuses_missing && !cpu->loaded[ob_nr])
        return RET_BAD_OB;
    if (dtime < 1 || dtime > DTIME_MAX)
        return RET_BAD_DTIME; /* [DINT-04] */
    if (cpu->config.choices.waiting_delay_is_withdrawn)
        s7_queue_withdraw(cpu, ob_nr);
    /* [DINT-07]: a job that is started already begins anew, with its SIGN (AMB-74, reading a). */
    cpu->dint[s7cpu_dint_index(ob_nr)] = (struct s7cpu_dint){
        .started = true, .end = cpu->up + dtime, .dtime = (int)dtime, .sign = sign};
    return RET_OK;
}

/* [DINT-15], AMB-11 (reading d): a delay that has elapsed is either cancelled while its OB has not
 * started, or there is no job any more and the OB runs. */
int s7_dint_cancel(struct s7cpu *cpu, int ob_nr)
{
    if (!is_offered(ob_nr))
        return RET_BAD_OB;
    struct s7cpu_dint *d = &cpu->dint[s7cpu_dint_index(ob_nr)];
    bool withdrawn = cpu->config.choices.waiting_delay_is_withdrawn && s7_queue_has(cpu, ob_nr);
    if (!d->started && !withdrawn)
        return RET_NOT_STARTED; /* [DINT-14] */
    if (withdrawn)
        s7_queue_withdraw(cpu, ob_nr);
    d->started = false;
    return RET_OK;
}

int s7_dint_query(const struct s7cpu *cpu, int ob_nr, int *status)
{
    if (!is_offered(ob_nr))
        return RET_BAD_OB;
    *status = s7_status(cpu, ob_nr);
    return RET_OK;
}

void s7_dint_restart(struct s7cpu *cpu)
{
    for (int k = 0; k < S7CPU_DINTS; k++)
        cpu->dint[k].started = false;
}

static void request(struct s7cpu *cpu, int ob)
{
    const struct s7cpu_dint *d = &cpu->dint[s7cpu_dint_index(ob)];
    struct s7cpu_request r = s7_request(cpu, ob, s7cpu_clock(cpu));
    r.info.sign = d->sign;
    r.info.dtime = d->dtime; /* AMB-31, reading b: the DTIME that was passed */
    s7_queue_put(cpu, &r);
}

/* AMB-47, either: the run that fell due while its OB was running follows (reading a). At most
 * one request of an OB waits (AMB-18, either: merged). */
static void elapsed(struct s7cpu *cpu, int k)
{
    struct s7cpu_dint *d = &cpu->dint[k];
    int ob = s7cpu_dint_ob(k);
    d->started = false; /* under SFC 39 too: the job is over [DINT-20], AMB-12 */
    if (s7_irt_loses(cpu, ob))
        return;
    if (s7_ob_is_running(cpu, ob))
        s7_error_overlap(cpu, ob, d->sign); /* [DINT-10] */
    if (!s7_time_error_stops(cpu) && !s7_queue_has(cpu, ob))
        request(cpu, ob);
}

/* The job whose delay ends first, NULL where none runs. */
static const struct s7cpu_dint *first_to_end(const struct s7cpu *cpu)
{
    const struct s7cpu_dint *first = NULL;
    for (int k = 0; k < S7CPU_DINTS && s7_time_runs(cpu); k++)
        if (cpu->dint[k].started && (first == NULL || cpu->dint[k].end < first->end))
            first = &cpu->dint[k];
    return first;
}

/* In order of their ends: a delay of a higher OB may have ended earlier on the real clock. */
void s7_dint_poll(struct s7cpu *cpu)
{
    while (s7_dint_next_up(cpu) <= cpu->up)
        elapsed(cpu, (int)(first_to_end(cpu) - cpu->dint));
}

int64_t s7_dint_next_up(const struct s7cpu *cpu)
{
    const struct s7cpu_dint *first = first_to_end(cpu);
    return first == NULL ? S7CPU_NEVER : first->end;
}

void s7_dint_released(struct s7cpu *cpu, int64_t held)
{
    for (int k = 0; k < S7CPU_DINTS; k++)
        cpu->dint[k].end += held;
}

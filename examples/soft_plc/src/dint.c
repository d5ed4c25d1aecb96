#include "dint.h"

#include "errors.h"
#include "events.h"
#include "irt.h"
#include "ret.h"
#include "status.h"

enum { DTIME_MAX = 60000, COARSE_MS = 10 };

static struct dint *find(struct cpu *cpu, int ob)
{
    return ob_kind(ob) == OB_DELAY ? &cpu->dint[ob - DINT_FIRST] : NULL; /* [DINT-05], AMB-64 */
}

static bool dtime_right(const struct cpu *cpu, int64_t dtime) /* [DINT-04] */
{
    if (dtime == 0)
        return cpu_fault(cpu, FAULT_DINT_ZERO);
    return dtime > 0 && (dtime <= DTIME_MAX || cpu_fault(cpu, FAULT_DINT_NO_LIMIT));
}

int sfc_srt_dint(struct cpu *cpu, int ob, int64_t dtime, int sign)
{
    struct dint *d = find(cpu, ob);
    if (d == NULL)
        return RET_BAD_OB;
    if (!dtime_right(cpu, dtime))
        return RET_BAD_DTIME;
    /* [DINT-07]: a job that is started already begins anew, with its SIGN (AMB-74, reading a). */
    if (d->started && cpu_fault(cpu, FAULT_DINT_NO_RETRIGGER))
        return RET_OK;
    if (!d->started || !cpu_fault(cpu, FAULT_DINT_KEEPS_SIGN))
        d->sign = sign;
    d->started = true;
    d->dtime = (int)dtime;
    d->end = cpu->clock.up + dtime;
    if (cpu_fault(cpu, FAULT_DINT_COARSE))
        d->end -= dtime % COARSE_MS;
    return RET_OK;
}

/* [DINT-15], AMB-11 (reading c): once the delay has elapsed there is no job to cancel, and a
 * request that waits stays. */
int sfc_can_dint(struct cpu *cpu, int ob)
{
    struct dint *d = find(cpu, ob);
    if (d == NULL)
        return RET_BAD_OB;
    if (cpu_fault(cpu, FAULT_DINT_CAN_WITHDRAWS) && queue_has(&cpu->queue, ob)) {
        queue_withdraw(&cpu->queue, ob);
        d->started = false;
        return RET_OK;
    }
    if (!d->started)
        return cpu_fault(cpu, FAULT_DINT_CAN_ANY) ? RET_OK : RET_NOT_STARTED; /* [DINT-14] */
    d->started = cpu_fault(cpu, FAULT_DINT_CAN_KEEPS);
    return RET_OK;
}

int sfc_qry_dint(struct cpu *cpu, int ob, int *status)
{
    const struct dint *d = find(cpu, ob);
    if (d == NULL)
        return RET_BAD_OB;
    /* An elapsed delay is no longer active, though its OB may still wait (AMB-34). */
    bool waits = cpu_fault(cpu, FAULT_DINT_WAITING_ACTIVE) && queue_has(&cpu->queue, ob);
    *status = status_word(cpu, ob, d->started || waits);
    return RET_OK;
}

void dint_restart(struct cpu *cpu)
{
    for (int k = 0; k < DINT_OBS && !cpu_fault(cpu, FAULT_DINT_SURVIVES); k++)
        cpu->dint[k].started = false;
}

static void put_request(struct cpu *cpu, int k)
{
    const struct dint *d = &cpu->dint[k];
    struct request r = events_request(cpu, DINT_FIRST + k, cpu_now(cpu));
    r.info.sign = d->sign;
    /* AMB-31, reading b: the DTIME that was passed */
    r.info.dtime = cpu_fault(cpu, FAULT_DINT_INFO_REST) ? 0 : d->dtime;
    events_put(cpu, &r);
}

/* AMB-47, either: the run that fell due while its OB was running follows (reading a). At most
 * one request of an OB waits (AMB-18, either: merged). */
static void elapsed(struct cpu *cpu, int k)
{
    struct dint *d = &cpu->dint[k];
    int ob = DINT_FIRST + k;
    if (irt_blocks(cpu, ob)) { /* lost, and the job is over [DINT-20], AMB-12 */
        d->started = cpu_fault(cpu, FAULT_IRT_JOB_STAYS);
        d->end += DT_FAR;
        return;
    }
    d->started = false;
    if (cpu_is_running(cpu, ob) && !cpu_fault(cpu, FAULT_DINT_OVERLAP_SILENT)) /* [DINT-10] */
        errors_overlap(cpu, ob, cpu_fault(cpu, FAULT_DINT_OVERLAP_DTIME) ? d->dtime : d->sign);
    if (cpu->mode != MODE_STOP && !queue_has(&cpu->queue, ob))
        put_request(cpu, k);
}

static bool time_runs(const struct cpu *cpu)
{
    return cpu->mode == MODE_RUN || cpu->mode == MODE_STARTUP;
}

/* In order of their ends: a delay of a higher OB may have ended earlier on the real clock. */
void dint_poll(struct cpu *cpu)
{
    while (time_runs(cpu) && dint_next_up(cpu) <= cpu->clock.up) {
        int first = 0;
        for (int k = 1; k < DINT_OBS; k++)
            if (cpu->dint[k].started &&
                (!cpu->dint[first].started || cpu->dint[k].end < cpu->dint[first].end))
                first = k;
        elapsed(cpu, first);
    }
}

int64_t dint_next_up(const struct cpu *cpu)
{
    int64_t up = INT64_MAX;
    for (int k = 0; k < DINT_OBS && time_runs(cpu); k++)
        if (cpu->dint[k].started && cpu->dint[k].end < up)
            up = cpu->dint[k].end;
    return up;
}

void dint_released(struct cpu *cpu, int64_t held)
{
    for (int k = 0; k < DINT_OBS && !cpu_fault(cpu, FAULT_DINT_RUNS_IN_HOLD); k++)
        cpu->dint[k].end += held;
}

void dint_clock_changed(struct cpu *cpu, int64_t by)
{
    for (int k = 0; k < DINT_OBS && cpu_fault(cpu, FAULT_DINT_FOLLOWS_CLOCK); k++)
        cpu->dint[k].end -= by;
}

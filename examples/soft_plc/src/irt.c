/* One mask bit for each OB, and the last call wins (AMB-21, reading a); a flag that does not
 * count [IRT-16]. Requests that wait already still run (AMB-72, reading a). */
#include "irt.h"

#include "diag.h"
#include "ret.h"

enum { SELECT_ALL = 0x00, SELECT_CLASS = 0x01, SELECT_OB = 0x02, NO_ENTRIES = 0x80 };

static bool mode_exists(const struct cpu *cpu, int mode, bool with_entries)
{
    if (mode & NO_ENTRIES && (!with_entries || cpu_fault(cpu, FAULT_IRT_NO_8X)))
        return false;
    mode &= ~NO_ENTRIES;
    return mode >= SELECT_ALL && mode <= SELECT_OB;
}

/* [IRT-06 to IRT-08, IRT-11]; with MODE 00 OB_NR is ignored (AMB-22, reading a). */
static bool selected(const struct cpu *cpu, int mode, int ob_nr, int ob)
{
    int class = ob_interrupt_class(ob);
    if (class == 0)
        return false;
    switch (mode & ~NO_ENTRIES) {
    case SELECT_ALL:
        return ob_nr == 0 || !cpu_fault(cpu, FAULT_IRT_ALL_NEEDS_0);
    case SELECT_CLASS:
        if (ob_nr == 70 && cpu_fault(cpu, FAULT_IRT_NO_CLASS_70))
            return false;
        return class == ob_nr && !(cpu_fault(cpu, FAULT_IRT_CLASS_FIRST) &&
                                   ob_interrupt_class(ob - 1) == class);
    default:
        return ob == ob_nr;
    }
}

static void block(struct cpu *cpu, int ob, bool silent)
{
    struct irt *m = &cpu->irt[ob];
    m->depth = cpu_fault(cpu, FAULT_IRT_COUNTS) ? m->depth + 1 : 1;
    m->silent = silent || cpu_fault(cpu, FAULT_DIAG_0X_SILENT);
    if (cpu_fault(cpu, FAULT_IRT_DROPS_QUEUED))
        queue_withdraw(&cpu->queue, ob);
}

static void enable(struct cpu *cpu, int ob)
{
    struct irt *m = &cpu->irt[ob];
    if (m->depth > 0)
        m->depth--;
    m->silent = m->silent && cpu_fault(cpu, FAULT_DIAG_EN_SILENT);
}

/* AMB-63, either: a MODE that does not exist is reported before OB_NR, whose meaning it is. */
static int bad_mode(const struct cpu *cpu)
{
    return cpu_fault(cpu, FAULT_IRT_BAD_MODE) ? RET_BAD_OB : RET_BAD_MODE;
}

/* AMB-73, reading a: a number that is in no class is a bad OB_NR. */
static int bad_ob(const struct cpu *cpu, int ob_nr)
{
    return ob_nr == 1 && cpu_fault(cpu, FAULT_IRT_OB1) ? RET_OK : RET_BAD_OB;
}

int sfc_dis_irt(struct cpu *cpu, int mode, int ob_nr)
{
    bool any = false;
    if (!mode_exists(cpu, mode, true))
        return bad_mode(cpu);
    for (int ob = 0; ob < OB_MAX; ob++)
        if (selected(cpu, mode, ob_nr, ob)) {
            block(cpu, ob, mode & NO_ENTRIES);
            any = true;
        }
    return any ? RET_OK : bad_ob(cpu, ob_nr);
}

int sfc_en_irt(struct cpu *cpu, int mode, int ob_nr)
{
    bool any = false, blocked = false;
    if (!mode_exists(cpu, mode, cpu_fault(cpu, FAULT_EN_IRT_8X))) /* [IRT-13], AMB-76 */
        return bad_mode(cpu);
    for (int ob = 0; ob < OB_MAX; ob++)
        if (selected(cpu, mode, ob_nr, ob)) {
            blocked = blocked || cpu->irt[ob].depth > 0;
            if (mode == SELECT_CLASS && cpu_fault(cpu, FAULT_EN_IRT_BLOCKS))
                block(cpu, ob, false);
            else
                enable(cpu, ob);
            any = true;
        }
    if (!any)
        return bad_ob(cpu, ob_nr);
    return !blocked && cpu_fault(cpu, FAULT_EN_IRT_8080) ? RET_NOT_DELAYED : RET_OK; /* [IRT-24] */
}

void irt_report(struct cpu *cpu, int mode)
{
    if (mode & NO_ENTRIES && !cpu_fault(cpu, FAULT_DIAG_NO_5380))
        diag_suppressed(cpu);
}

bool irt_blocks(const struct cpu *cpu, int ob)
{
    if (!cpu->loaded[ob] &&
        cpu_fault(cpu, ob == 80 ? FAULT_IRT_STOPS_80 : FAULT_IRT_MISSING_REACTS))
        return false;
    return cpu->irt[ob].depth > 0 && !cpu_fault(cpu, FAULT_IRT_QUEUES);
}

bool irt_silences(const struct cpu *cpu, int ob)
{
    return cpu->irt[ob].silent && !cpu_fault(cpu, FAULT_DIAG_8X_ENTERED);
}

bool irt_holds(const struct cpu *cpu, int ob)
{
    return cpu->irt[ob].depth > 0 && cpu_fault(cpu, FAULT_IRT_QUEUES);
}

void irt_restart(struct cpu *cpu)
{
    for (int ob = 0; ob < OB_MAX && !cpu_fault(cpu, FAULT_IRT_SURVIVES); ob++)
        cpu->irt[ob] = (struct irt){0};
}

void irt_ob_ended(struct cpu *cpu)
{
    if (cpu_fault(cpu, FAULT_IRT_ENDS_WITH_OB))
        for (int ob = 0; ob < OB_MAX; ob++)
            cpu->irt[ob] = (struct irt){0};
}

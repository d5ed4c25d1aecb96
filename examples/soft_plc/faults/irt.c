#include "variant.h"

enum { NO_OB = -1 };

/* What the library is called with in place of MODE and OB_NR. */
static void change_operands(const struct s7cpu *cpu, int *mode, int *ob_nr)
{
    int selects = *mode & ~NO_ENTRIES;
    if (selects == SELECT_CLASS && *ob_nr == 70 && has(cpu, FAULT_IRT_NO_CLASS_70))
        *ob_nr = NO_OB;
    if (selects == SELECT_CLASS && s7_ob_irt_class(*ob_nr == 50 ? 55 : *ob_nr) == *ob_nr &&
        *ob_nr != 0 && has(cpu, FAULT_IRT_CLASS_FIRST)) {
        *mode = SELECT_OB | (*mode & NO_ENTRIES);
        *ob_nr = *ob_nr == 50 ? 55 : *ob_nr;
    }
    if (selects == SELECT_ALL && *ob_nr != 0 && has(cpu, FAULT_IRT_ALL_NEEDS_0)) {
        *mode |= SELECT_CLASS;
        *ob_nr = NO_OB;
    }
}

static int changed_ret(const struct s7cpu *cpu, int ob_nr, int ret)
{
    if (ret == RET_BAD_MODE && has(cpu, FAULT_IRT_BAD_MODE))
        return RET_BAD_OB;
    return ret == RET_BAD_OB && ob_nr == 1 && has(cpu, FAULT_IRT_OB1) ? RET_OK : ret;
}

int faulty_irt_disable(struct s7cpu *cpu, int mode, int ob_nr)
{
    int passed = ob_nr;
    if (mode & NO_ENTRIES && has(cpu, FAULT_IRT_NO_8X))
        return RET_BAD_MODE;
    change_operands(cpu, &mode, &ob_nr);
    return changed_ret(cpu, passed, s7_irt_disable(cpu, mode, ob_nr));
}
SUBSTITUTES(irt_disable);

static int enable(struct s7cpu *cpu, int mode, int ob_nr)
{
    int passed = ob_nr;
    if (mode & NO_ENTRIES && has(cpu, FAULT_EN_IRT_8X))
        mode &= ~NO_ENTRIES;
    change_operands(cpu, &mode, &ob_nr);
    int ret = mode == SELECT_CLASS && has(cpu, FAULT_EN_IRT_BLOCKS)
                  ? s7_irt_disable(cpu, mode, ob_nr)
                  : s7_irt_enable(cpu, mode, ob_nr);
    return changed_ret(cpu, passed, ret);
}

static int blocked(const struct s7cpu *cpu)
{
    int n = 0;
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        n += cpu->mask[ob].blocked;
    return n;
}

int faulty_irt_enable(struct s7cpu *cpu, int mode, int ob_nr)
{
    int before = blocked(cpu);
    int ret = enable(cpu, mode, ob_nr);
    bool none = ret == RET_OK && blocked(cpu) == before;
    return none && has(cpu, FAULT_EN_IRT_8080) ? RET_NOT_DELAYED : ret;
}
SUBSTITUTES(irt_enable);

bool faulty_irt_loses(struct s7cpu *cpu, int ob)
{
    if (!has(cpu, FAULT_IRT_JOB_STAYS) || !s7_irt_blocks(cpu, ob))
        return s7_irt_loses(cpu, ob);
    if (s7_ob_kind(ob) == OB_DELAY) {
        struct s7cpu_dint *d = &cpu->dint[s7cpu_dint_index(ob)];
        d->started = true;
        d->end += S7CPU_LAST; /* never */
    }
    return true;
}
SUBSTITUTES(irt_loses);

void faulty_irt_block(struct s7cpu *cpu, int ob, bool silent)
{
    ((struct faulty_cpu *)cpu)->irt_depth[ob]++;
    s7_irt_block(cpu, ob, silent || has(cpu, FAULT_DIAG_0X_SILENT));
    if (has(cpu, FAULT_IRT_DROPS_QUEUED))
        s7_queue_withdraw(cpu, ob);
}
SUBSTITUTES(irt_block);

void faulty_irt_open(struct s7cpu *cpu, int ob)
{
    int *depth = &((struct faulty_cpu *)cpu)->irt_depth[ob];
    bool silent = cpu->mask[ob].silent && has(cpu, FAULT_DIAG_EN_SILENT);
    *depth -= *depth > 0;
    s7_irt_open(cpu, ob);
    cpu->mask[ob].silent = silent;
    cpu->mask[ob].blocked = *depth > 0 && has(cpu, FAULT_IRT_COUNTS);
}
SUBSTITUTES(irt_open);

/* Faults of a missing OB: a blocked event reacts; of the queue: it is held there. */
bool faulty_irt_blocks(const struct s7cpu *cpu, int ob)
{
    enum fault reacts = ob == 80 ? FAULT_IRT_STOPS_80 : FAULT_IRT_MISSING_REACTS;
    if ((!cpu->loaded[ob] && has(cpu, reacts)) || has(cpu, FAULT_IRT_QUEUES))
        return false;
    return s7_irt_blocks(cpu, ob);
}
SUBSTITUTES(irt_blocks);

bool faulty_irt_silences(const struct s7cpu *cpu, int ob)
{
    return !has(cpu, FAULT_DIAG_8X_ENTERED) && s7_irt_silences(cpu, ob);
}
SUBSTITUTES(irt_silences);

void faulty_irt_restart(struct s7cpu *cpu)
{
    if (has(cpu, FAULT_IRT_SURVIVES))
        return;
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        ((struct faulty_cpu *)cpu)->irt_depth[ob] = 0;
    s7_irt_restart(cpu);
}
SUBSTITUTES(irt_restart);

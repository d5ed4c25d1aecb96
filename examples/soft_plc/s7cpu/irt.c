/* SFC 39 and 40: start events that are lost, OB by OB. */
#include "internal.h"

static bool selects_something(int mode)
{
    return mode >= SELECT_ALL && mode <= SELECT_OB;
}

/* [IRT-06 to IRT-08, IRT-11]; with MODE 00 OB_NR is ignored (AMB-22, reading a). */
static bool selected(const struct s7cpu *cpu, int mode, int ob_nr, int ob)
{
    int class = s7_ob_irt_class(ob);
    if (class == 0)
        return false;
    switch (mode & ~NO_ENTRIES) {
    case SELECT_ALL:
        return true;
    case SELECT_CLASS:
        return class == ob_nr;
    default:
        return ob == ob_nr && s7cpu_ob_exists(cpu->config.family, ob);
    }
}

/* AMB-63, either: a MODE that does not exist is reported before OB_NR, whose meaning it is.
 * AMB-73, reading a: a number that is in no class is a bad OB_NR. */
int s7_irt_disable(struct s7cpu *cpu, int mode, int ob_nr)
{
    int ret = RET_BAD_OB;
    if (!selects_something(mode & ~NO_ENTRIES))
        return RET_BAD_MODE;
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        if (selected(cpu, mode, ob_nr, ob)) {
            s7_irt_block(cpu, ob, mode & NO_ENTRIES);
            ret = RET_OK;
        }
    return ret;
}

int s7_irt_enable(struct s7cpu *cpu, int mode, int ob_nr)
{
    int ret = RET_BAD_OB;
    if (!selects_something(mode)) /* no MODE 80 to 82 [IRT-13], AMB-76 */
        return RET_BAD_MODE;
    for (int ob = 0; ob < S7CPU_OBS; ob++)
        if (selected(cpu, mode, ob_nr, ob)) {
            s7_irt_open(cpu, ob);
            ret = RET_OK; /* also where nothing was blocked [IRT-24] */
        }
    return ret;
}

/* The event is lost and its point used up [IRT-04, IRT-18, DINT-20]; AMB-12, reading a: a
 * one-shot interrupt is over then. */
bool s7_irt_loses(struct s7cpu *cpu, int ob)
{
    if (!s7_irt_blocks(cpu, ob))
        return false;
    if (s7_ob_kind(ob) == OB_TOD)
        s7_tod_used_up(cpu, ob);
    return true;
}

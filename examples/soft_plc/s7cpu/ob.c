/* The organization blocks: numbers and kinds (table 8.1), and the class that one has. */
#include "internal.h"

enum { OB_MORE_FIRST = 123 };

static bool within(int ob, int low, int high)
{
    return ob >= low && ob <= high;
}

bool s7cpu_add_ob(struct s7cpu_config *config, int number, int range)
{
    static const int ends[] = {S7CPU_MORE_DINTS,    S7CPU_MORE_CYCLICS, S7CPU_MORE_HARDWARE,
                               S7CPU_MORE_STARTUPS, S7CPU_MORE_CYCLES,  S7CPU_OBS};
    int i = 0;
    while (ends[i] <= range)
        i++;
    int *first = &config->numbers[range - S7CPU_MORE], *last = &config->numbers[ends[i] - S7CPU_MORE - 1];
    if (*last != 0 || s7cpu_ob(config, number) != S7CPU_NONE)
        return false;
    int *p = first;
    while (*p != 0 && *p < number)
        p++;
    for (; *p != 0; p++) { /* in the order of their numbers */
        const int other = *p;
        *p = number;
        number = other;
    }
    *p = number;
    return true;
}

int s7cpu_ob(const struct s7cpu_config *config, int number)
{
    if (number < OB_MORE_FIRST)
        return number;
    for (int ob = S7CPU_MORE; ob < S7CPU_OBS; ob++)
        if (config->numbers[ob - S7CPU_MORE] == number)
            return ob;
    return S7CPU_NONE;
}

int s7cpu_ob_number(const struct s7cpu_config *config, int ob)
{
    return ob < S7CPU_MORE ? ob : config->numbers[ob - S7CPU_MORE];
}

bool s7cpu_ob_is_cycle(int ob)
{
    return s7_ob_kind(ob) == OB_CYCLE;
}

/* Those from 123 on have the kind of an old one. */
static enum ob_kind created_kind(int ob)
{
    return ob < S7CPU_MORE_DINTS      ? OB_TOD
           : ob < S7CPU_MORE_CYCLICS  ? OB_DELAY
           : ob < S7CPU_MORE_HARDWARE ? OB_CYCLIC
           : ob < S7CPU_MORE_STARTUPS ? OB_HARDWARE
           : ob < S7CPU_MORE_CYCLES   ? OB_STARTUP
                                      : OB_CYCLE;
}

enum ob_kind s7_ob_kind(int ob)
{
    if (ob >= S7CPU_MORE)
        return created_kind(ob);
    if (ob == 1)
        return OB_CYCLE;
    if (within(ob, 10, 17))
        return OB_TOD;
    if (within(ob, 20, 23))
        return OB_DELAY;
    if (within(ob, 30, 38))
        return OB_CYCLIC;
    if (within(ob, 40, 47))
        return OB_HARDWARE;
    if (within(ob, 55, 57))
        return OB_DPV1;
    if (ob == 60)
        return OB_MULTICOMPUTING;
    if (ob == 70 || ob == 72)
        return OB_REDUNDANCY;
    if (within(ob, 80, 87))
        return OB_ASYNC_ERROR;
    if (within(ob, 100, 102))
        return OB_STARTUP;
    if (within(ob, 61, 65) || ob == 73 || ob == 88 || ob == 90)
        return OB_OTHER;
    if (ob == 121 || ob == 122)
        return OB_SYNC_ERROR;
    return OB_NONE;
}

bool s7cpu_ob_from_outside(int ob)
{
    switch (s7_ob_kind(ob)) {
    case OB_CYCLIC:
    case OB_HARDWARE:
    case OB_DPV1:
    case OB_MULTICOMPUTING:
    case OB_REDUNDANCY:
    case OB_ASYNC_ERROR:
    case OB_SYNC_ERROR:
        return true;
    default:
        return false;
    }
}

int s7_ob_irt_class(int ob)
{
    switch (s7_ob_kind(ob)) {
    case OB_TOD:
        return 10;
    case OB_DELAY:
        return 20;
    case OB_CYCLIC:
        return 30;
    case OB_HARDWARE:
        return 40;
    case OB_DPV1:
        return 50;
    case OB_MULTICOMPUTING:
        return 60;
    case OB_REDUNDANCY:
        return 70;
    case OB_ASYNC_ERROR:
        return 80;
    default:
        return 0;
    }
}

int s7_ob_class(const struct s7cpu *cpu, int ob)
{
    const int upper = s7_family(cpu)->upper_class;
    if (cpu->mode == S7CPU_STARTUP && s7_ob_kind(ob) == OB_ASYNC_ERROR && upper != 0)
        return upper; /* [OBS-31, OBS-43], AMB-13 */
    if (cpu->config.priority[ob] != 0)
        return cpu->config.priority[ob];
    return s7_ob_default_class(cpu->config.family, ob);
}

bool s7_ob_is_optimised(const struct s7cpu *cpu, int ob)
{
    return s7_family(cpu)->has_layouts &&
           (ob >= S7CPU_MORE) != cpu->config.choices.old_obs_are_optimised;
}

bool s7_ob_is_running(const struct s7cpu *cpu, int ob)
{
    for (int i = 0; i < cpu->depth; i++)
        if (cpu->stack[i].ob == ob)
            return true;
    return false;
}

/* [T15-133] */
static int created_strt_info(int ob)
{
    switch (s7_ob_kind(ob)) {
    case OB_TOD:
        return 0x1F;
    case OB_DELAY:
        return 0x2F;
    case OB_CYCLIC:
        return 0x3F;
    case OB_HARDWARE:
        return 0x41;
    default:
        return S7CPU_NONE;
    }
}

int s7_ob_strt_info(int ob)
{
    if (ob >= S7CPU_MORE)
        return created_strt_info(ob);
    if (s7_ob_kind(ob) == OB_DELAY)
        return 0x21 + ob - S7CPU_DINT_FIRST;
    return s7_ob_kind(ob) == OB_TOD ? 0x11 + ob - S7CPU_TOD_FIRST : S7CPU_NONE;
}

int s7_ob_start_event(int ob)
{
    switch (s7_ob_kind(ob)) {
    case OB_TOD:
        return 0x1111 + ob - 10;
    case OB_DELAY:
        return 0x1121 + ob - 20;
    case OB_CYCLIC:
        return 0x1131 + ob - 30;
    case OB_HARDWARE: /* the table knows four lines */
        return ob < 44 ? 0x1141 + ob - 40 : S7CPU_NONE;
    default:
        return S7CPU_NONE;
    }
}

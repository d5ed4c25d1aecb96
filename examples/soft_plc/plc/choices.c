#include "choices.h"

#include <stddef.h>
#include <string.h>

static const struct {
    const char *name, *off, *on;
    size_t offset;
    const char *text;
} table[] = {
#define CHOICE(name, off, on, field, text)                                                         \
    {                                                                                              \
        name, off, on, offsetof(struct s7cpu_choices, field), text                                 \
    }
    CHOICE("AMB-11", "c", "b", waiting_delay_is_withdrawn,
           "a delay interrupt that waits: runs, or is withdrawn by SFC 32 and 33"),
    CHOICE("DINT-16", "0", "1", waiting_delay_is_active,
           "STATUS bit 2 of a delay interrupt that waits"),
    CHOICE("DINT-17", "exact", "less", shows_less_time_left,
           "SZL 16#0222 shows the milliseconds that are left of a delay, or one less"),
    CHOICE("OBS-03", "highest", "lowest", lowest_of_a_moment_first,
           "interrupts of one moment: the highest class starts first, or last"),
    CHOICE("AMB-34", "a", "b", waiting_once_is_inactive,
           "STATUS bit 2 of a one-shot interrupt that waits: 1, or 0"),
    CHOICE("AMB-49", "a", "b", stop_waits_for_delay,
           "a missing OB under SFC 41 stops the CPU: at once, or when the delay ends"),
    CHOICE("AMB-56", "b", "d", uncalled_points_are_served,
           "S7-400, clock back, points never served: not served, or after the last one called"),
    CHOICE("AMB-60", "a", "b", waiting_once_is_past,
           "SFC 30 for a one-shot interrupt that waits: 0000, or 80A1"),
    CHOICE("AMB-71", "a", "c", once_ends_with_its_ob,
           "a one-shot interrupt is over: when its OB starts, or when it ends"),
    CHOICE("AMB-79", "b", "a", wrong_seconds_are_ignored,
           "seconds 60 to 99 of SDT: 8091, or ignored"),
    CHOICE("OBS-26", "stop", "again", cycle_is_retriggered,
           "a second excess of the cycle time in a cycle, without or with SFC 43"),
    CHOICE("OBS-10", "event", "call", info_has_time_of_call,
           "the time in the start information"),
    CHOICE("OBS-52", "lost", "reported", points_of_stop_are_reported,
           "start points that passed in STOP before a hot restart"),
    CHOICE("T15-130", "new", "old", old_obs_are_optimised,
           "S7-1500, the optimised start information: OBs from 123 on have it, or those below"),
#undef CHOICE
};

enum { COUNT = sizeof table / sizeof table[0] };

bool choice_set(struct s7cpu_choices *choices, const char *text)
{
    const char *equals = strchr(text, '=');
    const size_t length = equals != NULL ? (size_t)(equals - text) : 0;
    for (int i = 0; i < COUNT && equals != NULL; i++) {
        bool on = strcmp(equals + 1, table[i].on) == 0;
        bool off = strcmp(equals + 1, table[i].off) == 0;
        if (strlen(table[i].name) != length || strncmp(text, table[i].name, length) != 0 ||
            !(on || off))
            continue;
        *(bool *)((char *)choices + table[i].offset) = on;
        return true;
    }
    return false;
}

void choices_help(FILE *out)
{
    for (int i = 0; i < COUNT; i++)
        fprintf(out, "  %-7s=%s or %s: %s\n", table[i].name, table[i].off, table[i].on,
                table[i].text);
}

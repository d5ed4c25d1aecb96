#include <string.h>

#include "faults.h"

static const struct {
    const char *name, *text;
} table[FAULT_COUNT] = {
#define ROW(constant, name, text) [FAULT_##constant] = {name, text},
    FAULTS(ROW)
#undef ROW
};

bool fault_by_name(const char *name, enum fault *f)
{
    for (int i = FAULT_NONE + 1; i < FAULT_COUNT; i++)
        if (strcmp(table[i].name, name) == 0) {
            *f = (enum fault)i;
            return true;
        }
    return false;
}

const char *fault_name(enum fault f)
{
    return table[f].name;
}

void faults_help(FILE *out)
{
    for (int i = FAULT_NONE + 1; i < FAULT_COUNT; i++)
        fprintf(out, "  %-22s %s\n", table[i].name, table[i].text);
}

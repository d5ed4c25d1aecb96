/* The random program is reproducible, and every deliberate fault shows in its logs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "test.h"

static bool fault_shows(enum fault f)
{
    bool shows = false;
    for (uint64_t seed = 1; seed <= 40 && !shows; seed++) {
        char *right = test_random(seed, 6000, 0);
        char *wrong = test_random(seed, 6000, f);
        shows = strcmp(right, wrong) != 0;
        free(right);
        free(wrong);
    }
    if (!shows)
        fprintf(stderr, "fault %s does not show\n", fault_name(f));
    return shows;
}

void test_random_program(void)
{
    char *one = test_random(7, 20000, 0);
    char *same = test_random(7, 20000, 0);
    char *other = test_random(8, 20000, 0);
    CHECK(test_count(one, "\n") == 20001);
    CHECK(strcmp(one, same) == 0);
    CHECK(strcmp(one, other) != 0);
    free(one);
    free(same);
    free(other);
    for (int f = FAULT_NONE + 1; f < FAULT_COUNT; f++)
        CHECK(fault_shows((enum fault)f));
}

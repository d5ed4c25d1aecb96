/* What differs between families of CPUs: their OBs with priority classes, and facts. */
#include "internal.h"

/* OBs of table 8.1; without a range their class is fixed, class 0 is that of the OB at fault. */
struct row {
    int first, last;
    int class, step; /* of the first, and from one to the next */
    int low, high;   /* classes that may be assigned */
};

static const struct row s7_300[] = {
    {1, 1, 1, 0, 0, 0},     {10, 17, 2, 0, 0, 0},  {20, 23, 3, 1, 0, 0},
    {30, 38, 7, 1, 0, 0},   {40, 47, 16, 1, 0, 0}, {55, 57, 2, 0, 0, 0},
    {60, 60, 25, 0, 0, 0},  {61, 65, 0, 0, 0, 0},  {70, 70, 25, 0, 0, 0},
    {72, 72, 28, 0, 0, 0},  {73, 73, 0, 0, 0, 0},  {80, 87, 26, 0, 0, 0},
    {88, 88, 0, 0, 0, 0},   {90, 90, 0, 0, 0, 0},  {100, 102, 27, 0, 0, 0},
    {121, 122, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}};

/* [OBS-05, OBS-11]: on S7-400 and CPU 318 OB 80 stands above its fellows. */
static const struct row s7_400[] = {
    {1, 1, 1, 0, 0, 0},     {10, 17, 2, 0, 2, 23},  {20, 23, 3, 1, 2, 23},
    {30, 38, 7, 1, 2, 23},  {40, 47, 16, 1, 2, 23}, {55, 57, 2, 0, 0, 0},
    {60, 60, 25, 0, 0, 0},  {61, 65, 0, 0, 0, 0},   {70, 70, 25, 0, 2, 28},
    {72, 72, 28, 0, 2, 28}, {73, 73, 0, 0, 0, 0},   {80, 80, 26, 0, 0, 0},
    {81, 84, 25, 0, 2, 26}, {85, 85, 25, 0, 24, 26}, {86, 87, 25, 0, 2, 26},
    {88, 88, 0, 0, 0, 0},   {90, 90, 0, 0, 0, 0},   {100, 102, 27, 0, 0, 0},
    {121, 122, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}};

/* [T15-10, T15-12, T15-60 to T15-66]; OB 30 to 38 by the cycle times that they have from the start,
 * 5 s to 10 ms; hardware interrupts as newer texts say (A15-05, reading a). */
static const struct row s7_1500[] = {
    {1, 1, 1, 0, 0, 0},     {10, 17, 2, 0, 2, 24},  {20, 23, 3, 0, 2, 24},
    {30, 35, 8, 1, 2, 24},  {36, 37, 13, 0, 2, 24}, {38, 38, 14, 0, 2, 24},
    {40, 47, 16, 0, 2, 26}, {55, 57, 4, 0, 2, 24},  {61, 64, 21, 0, 16, 26},
    {80, 80, 22, 0, 0, 0},  {82, 82, 5, 0, 2, 26},  {83, 83, 6, 0, 2, 26},
    {86, 86, 6, 0, 2, 26},  {100, 100, 1, 0, 0, 0}, {121, 122, 7, 0, 2, 26},
    {S7CPU_MORE_TODS, S7CPU_MORE_DINTS - 1, 2, 0, 2, 24},
    {S7CPU_MORE_DINTS, S7CPU_MORE_CYCLICS - 1, 3, 0, 2, 24},
    {S7CPU_MORE_CYCLICS, S7CPU_MORE_HARDWARE - 1, 8, 0, 2, 24},
    {S7CPU_MORE_HARDWARE, S7CPU_MORE_STARTUPS - 1, 16, 0, 2, 26},
    {S7CPU_MORE_STARTUPS, S7CPU_OBS - 1, 1, 0, 0, 0},
    {0, 0, 0, 0, 0, 0}};

static const struct s7_family families[] = {
    [S7CPU_S7_300] = {.restarts = {[S7CPU_WARM] = true, [S7CPU_COLD] = true},
                      .upper_class = 28,
                      .takes_1202 = true},
    [S7CPU_S7_400] = {.restarts = {[S7CPU_WARM] = true, [S7CPU_COLD] = true, [S7CPU_HOT] = true},
                      .upper_class = 28,
                      .takes_1202 = true,
                      .repeats_from = S7CPU_NEVER},
    [S7CPU_CPU_318] = {.restarts = {[S7CPU_WARM] = true, [S7CPU_COLD] = true},
                       .upper_class = 28,
                       .takes_1202 = true,
                       .repeats_from = S7CPU_NEVER},
    [S7CPU_S7_1500] = {.restarts = {[S7CPU_WARM] = true}, /* [T15-115] */
                       .skips_from = 20000,
                       .repeats_from = 20000,
                       .serves_uncalled = true,
                       .ignores_missing = true,
                       .refuses_missing = true,
                       .holds_startup = true,
                       .ob80_waits_for_run = true,
                       .has_queues = true,
                       .month_end_has_no_date = true,
                       .past_once_is_over = true,
                       .status_shows_delay = true,
                       .names_running = true,
                       .has_local_time = true,
                       .has_layouts = true}};

const struct s7_family *s7_family(const struct s7cpu *cpu)
{
    return &families[cpu->config.family];
}

static const struct row *row_of(enum s7cpu_family family, int ob)
{
    const struct row *r = family == S7CPU_S7_300    ? s7_300
                          : family == S7CPU_S7_1500 ? s7_1500
                                                    : s7_400;
    while (r->first != 0 && (ob < r->first || ob > r->last))
        r++;
    return r;
}

bool s7cpu_ob_exists(enum s7cpu_family family, int ob)
{
    return row_of(family, ob)->first != 0;
}

bool s7cpu_restart_exists(enum s7cpu_family family, enum s7cpu_restart type)
{
    return families[family].restarts[type];
}

bool s7cpu_has_local_time(enum s7cpu_family family)
{
    return families[family].has_local_time;
}

bool s7cpu_has_queue(enum s7cpu_family family, int ob)
{
    const enum ob_kind kind = s7_ob_kind(ob);
    return families[family].has_queues && (kind == OB_TOD || kind == OB_CYCLIC || kind == OB_HARDWARE);
}

int s7_ob_default_class(enum s7cpu_family family, int ob)
{
    const struct row *r = row_of(family, ob);
    return r->class + (ob - r->first) * r->step;
}

bool s7cpu_class_range(enum s7cpu_family family, int ob, int *low, int *high)
{
    const struct row *r = row_of(family, ob);
    *low = r->low;
    *high = r->high;
    return r->high != 0;
}

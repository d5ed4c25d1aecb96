/* The least that a program needs around the library: OB 100 activates OB 10 for every minute and
 * starts a delay of 45 s, which OB 20 starts again. Simulated time, three minutes. */
#include <inttypes.h>
#include <stdio.h>

#include "s7cpu.h"

/* The user program: the whole body of an OB is one instruction here. */
static void run(struct s7cpu *cpu, int ob)
{
    const struct s7cpu_date six = {2026, 11, 21, 6, 0, 0, 0};
    if (ob == 100) {
        s7cpu_set_tint(cpu, 10, &six, 0x0201);
        s7cpu_act_tint(cpu, 10);
    }
    if (ob == 100 || ob == 20)
        s7cpu_srt_dint(cpu, 20, 45000, 0x0001);
}

static void print(void *context, const struct s7cpu_event *e)
{
    const struct s7cpu_date d = s7cpu_date(e->at);
    (void)context;
    if (e->kind == S7CPU_OB_START && e->ob != 1)
        printf("%02d:%02d:%02d OB %d\n", d.hour, d.minute, d.second, e->ob);
    if (e->kind <= S7CPU_EN_AIRT)
        printf("%02d:%02d:%02d SFC, RET_VAL %04X\n", d.hour, d.minute, d.second, (unsigned)e->ret);
}

int main(void)
{
    static struct s7cpu cpu;
    const struct s7cpu_date begin = {2026, 11, 21, 5, 59, 30, 0};
    const struct s7cpu_config config = {
        .family = S7CPU_S7_400,
        .loaded = {[1] = true, [10] = true, [20] = true, [80] = true, [85] = true, [100] = true},
        .clock = s7cpu_ms(&begin),
        .mode = S7CPU_STOP,
        .buffer = 16};

    s7cpu_init(&cpu, &config, print, NULL);
    s7cpu_restart(&cpu, S7CPU_WARM);
    for (int64_t up = 0; up < 3 * S7CPU_MINUTE; up += 10) {
        s7cpu_tick(&cpu, up);
        for (;;) {
            if (s7cpu_dispatch(&cpu))
                continue; /* an OB has begun: one of a higher class may follow */
            const int ob = s7cpu_top(&cpu)->ob;
            run(&cpu, ob);
            s7cpu_end_ob(&cpu);
            if (ob == 1)
                break; /* a cycle every 10 ms */
        }
    }
    printf("after %" PRId64 " s: mode %s\n", s7cpu_up(&cpu) / 1000,
           s7cpu_mode(&cpu) == S7CPU_RUN ? "RUN" : "other");
    return 0;
}

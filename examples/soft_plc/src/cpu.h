/* The CPU: one structure that is passed around; nothing in this program is global. */
#ifndef CPU_H
#define CPU_H

#include <stdbool.h>
#include <stdint.h>

#include "clock.h"
#include "faults.h"
#include "log.h"
#include "ob.h"
#include "program.h"
#include "queue.h"

enum mode { MODE_STOP, MODE_STARTUP, MODE_RUN, MODE_HOLD };

/* What is assigned to a time-of-day interrupt with STEP 7. */
struct step7_tod {
    bool configured; /* named in the header of the log */
    bool active;
    bool deselected;
    bool has_start;
    dt_ms start;
    int period;
    enum s7log_execution execution;
};

/* One time-of-day interrupt, OB 10 + index. */
struct tod {
    bool set, active;
    dt_ms start;
    int period;
    dt_ms next; /* the point that is due next; DT_NEVER where none is left */
};

/* The job of a time-delay interrupt, OB 20 + index. */
struct dint {
    bool started;
    int64_t end; /* elapsed ms; moved on by HOLD [DINT-19] */
    int dtime;
    int sign;
};

/* What SFC 39 has done to an OB. */
struct irt {
    int depth; /* 0: enabled, 1: blocked; more by mistake only [IRT-16] */
    bool silent; /* MODE 8x: its events are not entered in the diagnostic buffer */
};

/* An OB that has been started and not processed to its end. */
struct frame {
    int ob;
    int rank;
    uint32_t run; /* how often this OB has been started, this time included */
    int64_t busy; /* elapsed time that the current instruction still takes */
    int64_t began;
    const void *body;
    uint32_t step;
};

struct config {
    enum family family;
    bool loaded[OB_MAX];
    int priority[OB_MAX]; /* 0 = default class */
    struct step7_tod step7[TOD_OBS];
    dt_ms clock;
    enum mode mode;
    int latency_ms;
    bool log_cycle;
    bool log_diag;
    bool log_up;
    int64_t cycle_ms; /* shortest cycle of OB 1 */
    int buffer;       /* start events from outside that a class holds [OBS-08] */
    int64_t duration; /* elapsed ms */
    uint64_t max_events;
    struct fault_set faults;
};

enum { STACK_DEPTH = 32 };

struct cpu {
    struct config config;
    struct cpu_clock clock;
    enum mode mode;
    bool loaded[OB_MAX];
    int64_t hold_began; /* elapsed ms */
    struct tod tod[TOD_OBS];
    struct dint dint[DINT_OBS];
    struct irt irt[OB_MAX];
    int delay_count; /* of the running OB; one is enough [AIRT-12] */
    struct queue queue;
    struct frame stack[STACK_DEPTH];
    int depth;
    uint32_t runs[OB_MAX];
    struct log *log;
    struct program *program;
};

static inline struct frame *cpu_top(struct cpu *cpu)
{
    return cpu->depth > 0 ? &cpu->stack[cpu->depth - 1] : NULL;
}

static inline bool cpu_fault(const struct cpu *cpu, enum fault f)
{
    return cpu->config.faults.has[f];
}

static inline dt_ms cpu_now(const struct cpu *cpu)
{
    return clock_now(&cpu->clock);
}

bool cpu_is_running(const struct cpu *cpu, int ob);
/* Priority class of an OB in the present mode. */
int cpu_class(const struct cpu *cpu, int ob);

/* Puts the CPU into the state in which its log begins and writes the header. */
void cpu_begin(struct cpu *cpu, const struct config *config, struct program *program,
               struct log *log, bool real_time);
/* Runs until the end of the scenario. */
void cpu_run(struct cpu *cpu);

#endif

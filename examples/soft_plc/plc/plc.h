/* The soft PLC: a CPU of the library, a program that runs on it, a clock and a log. */
#ifndef PLC_H
#define PLC_H

#include "clock.h"
#include "faults.h"
#include "log.h"
#include "program.h"

struct plc_config {
    struct s7cpu_config cpu;
    struct log_config log;
    int64_t cycle_ms; /* shortest cycle of OB 1 */
    int64_t duration; /* elapsed ms */
    uint64_t max_events;
    struct fault_set faults;
};

struct plc {
    struct faulty_cpu faulty;
    struct plc_config config;
    struct plc_clock clock;
    struct program *program;
    struct log *log;
    struct activation stack[S7CPU_DEPTH]; /* of the OBs in the CPU's stack */
    int depth;
    struct activation stopped[S7CPU_DEPTH]; /* those that the last STOP has interrupted */
    bool ran; /* at the last step the mode was RUN or HOLD */
};

/* Runs until the end of the program, and writes the log. */
void plc_run(struct plc *plc, const struct plc_config *config, struct program *program,
             struct log *log, bool real_time);

#endif

/* What the CPU logs, as s7-interrupt-log/1. The format itself is s7log.h's. */
#ifndef LOG_H
#define LOG_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "calendar.h"
#include "program.h"
#include "queue.h"
#include "s7log.h"

struct cpu;

struct log {
    struct s7log s7;
    FILE *out;
    bool flush_lines; /* so that a log of the real clock can be read while it is written */
};

void log_open(struct log *log, FILE *out, bool flush_lines);
/* Writes what is left; false where writing has failed. */
bool log_close(struct log *log);

void log_header(struct log *log, const struct cpu *cpu);
/* An instruction of the running OB, with what it returned: nothing where it is no call of an SFC
 * that the format names. */
void log_call(struct log *log, const struct cpu *cpu, const struct step *call, int ret, int status);
void log_start(struct log *log, const struct cpu *cpu, int ob, const struct start_info *info);
void log_end(struct log *log, const struct cpu *cpu, int ob);
void log_clock(struct log *log, const struct cpu *cpu, dt_ms to);
void log_restart(struct log *log, const struct cpu *cpu, bool cold);
/* cause: an event ID, or -1. */
void log_stop(struct log *log, const struct cpu *cpu, int cause);
void log_run(struct log *log, const struct cpu *cpu);
void log_hold(struct log *log, const struct cpu *cpu);
void log_release(struct log *log, const struct cpu *cpu);
void log_interrupt(struct log *log, const struct cpu *cpu, int ob, int flt_id);
void log_block(struct log *log, const struct cpu *cpu, bool present, int ob);
/* ob: -1 where the entry names none; info may be NULL. */
void log_diag(struct log *log, const struct cpu *cpu, int id, int ob,
              const struct start_info *info);

#endif

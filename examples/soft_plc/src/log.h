/* Writes s7-interrupt-log/1: one JSON object a line. */
#ifndef LOG_H
#define LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "calendar.h"
#include "queue.h"

struct cpu;

enum { LOG_BUFFER = 1 << 16, LOG_LINE = 1024 };

struct log {
    FILE *out;
    bool flush_lines; /* so that a log of the real clock can be read while it is written */
    bool failed;
    uint64_t events;
    size_t used;
    char buffer[LOG_BUFFER];
};

void log_open(struct log *log, FILE *out, bool flush_lines);
/* Writes what is left; false where writing has failed. */
bool log_close(struct log *log);

void log_header(struct log *log, const struct cpu *cpu);
void log_set_tint(struct log *log, const struct cpu *cpu, int ob, const struct civil *sdt,
                  int period, int ret);
void log_call_ob(struct log *log, const struct cpu *cpu, const char *sfc, int ob, int ret);
void log_srt_dint(struct log *log, const struct cpu *cpu, int ob, int64_t dtime, int sign,
                  int ret);
void log_qry(struct log *log, const struct cpu *cpu, const char *sfc, int ob, int ret, int status);
/* SFC 39 and 40 */
void log_irt(struct log *log, const struct cpu *cpu, const char *sfc, int mode, int ob, int ret);
void log_call(struct log *log, const struct cpu *cpu, const char *sfc, int ret);
void log_start(struct log *log, const struct cpu *cpu, int ob, const struct start_info *info);
void log_end(struct log *log, const struct cpu *cpu, int ob);
void log_clock(struct log *log, const struct cpu *cpu, dt_ms to);
void log_restart(struct log *log, const struct cpu *cpu, bool cold);
/* cause: an event ID, or -1. */
void log_stop(struct log *log, const struct cpu *cpu, int cause);
/* run, hold, release */
void log_mode(struct log *log, const struct cpu *cpu, const char *event);
void log_interrupt(struct log *log, const struct cpu *cpu, int ob, int flt_id);
void log_block(struct log *log, const struct cpu *cpu, const char *event, int ob);
/* ob: -1 where the entry names none; info may be NULL. */
void log_diag(struct log *log, const struct cpu *cpu, int id, int ob,
              const struct start_info *info);

#endif

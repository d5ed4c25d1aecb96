/* The events of the CPU as an s7-interrupt-log/1. The format itself is s7log.h's. */
#ifndef LOG_H
#define LOG_H

#include <stdbool.h>
#include <stdio.h>

#include "s7cpu.h"
#include "s7log.h"

struct log_config {
    int latency_ms;
    bool cycle; /* every start and end of OB 1 */
    bool diag;  /* entries of the diagnostic buffer */
    bool up;    /* elapsed time in every event */
};

struct log {
    struct s7log s7;
    struct log_config config;
    const struct s7cpu_config *cpu;
    FILE *out;
    bool flush_lines; /* so that a log of the real clock can be read while it is written */
};

void log_open(struct log *log, FILE *out, bool flush_lines);
/* The log is whole up to this moment, the reading of the CPU clock and the elapsed time. */
void log_done(struct log *log, int64_t at, int64_t up);
/* Writes what is left; false where writing has failed. */
bool log_close(struct log *log);

/* `cpu` is read again with every event. */
void log_header(struct log *log, const struct s7cpu_config *cpu, const struct log_config *config);
/* The sink of the CPU; the context is a struct log. */
void log_event(void *context, const struct s7cpu_event *event);

#endif

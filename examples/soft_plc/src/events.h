/* Start events on their way into the queue. */
#ifndef EVENTS_H
#define EVENTS_H

#include "cpu.h"

/* A request with the start information that every OB has. */
struct request events_request(const struct cpu *cpu, int ob, dt_ms time);
void events_put(struct cpu *cpu, const struct request *r);
/* A start event from outside reaches the CPU. */
void events_interrupt(struct cpu *cpu, int ob, int flt_id);

#endif

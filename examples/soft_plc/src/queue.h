/* Start events that wait for their OB, in the order in which they happened [OBS-07]. */
#ifndef QUEUE_H
#define QUEUE_H

#include <stdbool.h>
#include <stdint.h>

#include "calendar.h"

/* Start information of an OB (table 8.2), fixed when the event occurs [OBS-10].
 * A field that does not apply is -1. */
struct start_info {
    int priority;
    int strt_info;
    int period;
    int sign;
    int dtime;
    int flt_id;
    int error_info;
    int ev;
    int ev_ob;
    dt_ms time;
};

struct request {
    int ob;
    int rank; /* the class it is dispatched in */
    struct start_info info;
};

enum { QUEUE_SIZE = 512 };

struct queue {
    struct request items[QUEUE_SIZE]; /* oldest first */
    int length;
};

bool queue_put(struct queue *q, const struct request *r);
void queue_remove(struct queue *q, int index);
/* Removes every request of an OB. */
void queue_withdraw(struct queue *q, int ob);
bool queue_has(const struct queue *q, int ob);
int queue_count_rank(const struct queue *q, int rank);

#endif

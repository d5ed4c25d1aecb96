#include "queue.h"

#include <string.h>

bool queue_put(struct queue *q, const struct request *r)
{
    if (q->length == QUEUE_SIZE)
        return false;
    q->items[q->length++] = *r;
    return true;
}

void queue_remove(struct queue *q, int index)
{
    q->length--;
    memmove(&q->items[index], &q->items[index + 1],
            (size_t)(q->length - index) * sizeof q->items[0]);
}

void queue_withdraw(struct queue *q, int ob)
{
    for (int i = q->length - 1; i >= 0; i--)
        if (q->items[i].ob == ob)
            queue_remove(q, i);
}

bool queue_has(const struct queue *q, int ob)
{
    for (int i = 0; i < q->length; i++)
        if (q->items[i].ob == ob)
            return true;
    return false;
}

int queue_count_rank(const struct queue *q, int rank)
{
    int n = 0;
    for (int i = 0; i < q->length; i++)
        n += q->items[i].rank == rank;
    return n;
}

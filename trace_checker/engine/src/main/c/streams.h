/* Standard input and output of the compiled engine, as bytes, and its memory. */
#pragma once
#include <stdint.h>

/* Waits for bytes and takes those that are there, at most so many; -1 at the end. */
int32_t s7_read(void *to, int32_t most);

/* Writes all of them; the process ends where nobody reads. */
void s7_write(void *from, int32_t count);

/* Has the heap in large pages where the system has them: a short log costs a third less. */
void s7_large_pages(void);

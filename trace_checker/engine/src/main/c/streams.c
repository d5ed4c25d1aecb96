#include "streams.h"

#include <stdio.h>
#include <stdlib.h>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>

/* Before main: Windows would change the ends of lines. */
__attribute__((constructor)) static void as_bytes(void)
{
    _setmode(0, _O_BINARY);
    _setmode(1, _O_BINARY);
}

#define read _read
#else
#include <sys/mman.h>
#include <unistd.h>
#endif

/* Of TeaVM. */
extern void *teavm_gc_heapAddress;
extern int64_t teavm_gc_availableBytes;

enum { NOBODY_LEFT = 3 };

int32_t s7_read(void *to, int32_t most)
{
    int32_t count = (int32_t)read(0, to, (unsigned)most);
    return count > 0 ? count : -1;
}

void s7_write(void *from, int32_t count)
{
    if (fwrite(from, 1, (size_t)count, stdout) != (size_t)count || fflush(stdout) != 0) {
        exit(NOBODY_LEFT);
    }
}

void s7_large_pages(void)
{
#ifdef MADV_HUGEPAGE
    madvise(teavm_gc_heapAddress, (size_t)teavm_gc_availableBytes, MADV_HUGEPAGE);
#endif
}

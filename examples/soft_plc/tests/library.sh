#!/bin/sh
# The library alone: no writable data, no memory from the heap, names of its own.
set -eu
library=$1 minimal=$2
if nm "$library" | grep -E ' [bBcCdDgGsS] '; then
    echo "$library has writable data"
    exit 1
fi
if nm -u "$library" | grep -E ' U ' | grep -vE ' (s7cpu|s7)_|mem(cpy|move|set)$'; then
    echo "$library needs more than memcpy, memmove and memset"
    exit 1
fi
if nm -g --defined-only "$library" | grep -E ' T ' | grep -vE ' (s7cpu|s7)_'; then
    echo "$library has names that others may have"
    exit 1
fi
runs=$("$minimal" | grep -c 'OB [12]0$')
[ "$runs" -eq 6 ] || { echo "$minimal: OB 10 and OB 20 ran $runs times, not 6"; exit 1; }

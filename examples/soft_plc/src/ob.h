/* The organization blocks: numbers, kinds and default priority classes (table 8.1). */
#ifndef OB_H
#define OB_H

#include <stdbool.h>

enum { OB_MAX = 128, TOD_OBS = 8, TOD_FIRST = 10, DINT_OBS = 4, DINT_FIRST = 20 };

enum family { FAMILY_S7_300, FAMILY_S7_400, FAMILY_CPU_318 };

enum ob_kind {
    OB_NONE,
    OB_CYCLE,
    OB_TOD,
    OB_DELAY,
    OB_CYCLIC,
    OB_HARDWARE,
    OB_DPV1,
    OB_MULTICOMPUTING,
    OB_REDUNDANCY,
    OB_ASYNC_ERROR, /* OB 80 to 87 */
    OB_STARTUP,
    OB_OTHER /* may be loaded, is never started here */
};

enum ob_kind ob_kind(int ob);
bool ob_is_tod(int ob);
/* OBs that have a start event from outside (`interrupt` in the log). */
bool ob_is_from_outside(int ob);
/* Class number of SFC 39 and 40 [IRT-11]; 0 where the OB has none. */
int ob_interrupt_class(int ob);
int ob_default_class(enum family f, int ob);
/* The classes that may be assigned to an OB [OBS-05]; false where it has a fixed one. */
bool ob_class_range(enum family f, int ob, int *low, int *high);
/* STRT_INFO of table 8.2, or -1 where the table has none. */
int ob_strt_info(int ob);
/* Class and number of the start event (table 8.3), or -1. */
int ob_start_event(int ob);

#endif

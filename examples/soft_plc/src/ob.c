#include "ob.h"

static bool within(int ob, int low, int high)
{
    return ob >= low && ob <= high;
}

enum ob_kind ob_kind(int ob)
{
    if (ob == 1)
        return OB_CYCLE;
    if (within(ob, 10, 17))
        return OB_TOD;
    if (within(ob, 20, 23))
        return OB_DELAY;
    if (within(ob, 30, 38))
        return OB_CYCLIC;
    if (within(ob, 40, 47))
        return OB_HARDWARE;
    if (within(ob, 55, 57))
        return OB_DPV1;
    if (ob == 60)
        return OB_MULTICOMPUTING;
    if (ob == 70 || ob == 72)
        return OB_REDUNDANCY;
    if (within(ob, 80, 87))
        return OB_ASYNC_ERROR;
    if (ob == 100 || ob == 102)
        return OB_STARTUP;
    if (within(ob, 61, 65) || ob == 73 || ob == 88 || ob == 90 || ob == 101 || ob == 121 ||
        ob == 122)
        return OB_OTHER;
    return OB_NONE;
}

bool ob_is_tod(int ob)
{
    return ob_kind(ob) == OB_TOD;
}

bool ob_is_from_outside(int ob)
{
    switch (ob_kind(ob)) {
    case OB_CYCLIC:
    case OB_HARDWARE:
    case OB_DPV1:
    case OB_MULTICOMPUTING:
    case OB_REDUNDANCY:
    case OB_ASYNC_ERROR:
        return true;
    default:
        return false;
    }
}

int ob_interrupt_class(int ob)
{
    switch (ob_kind(ob)) {
    case OB_TOD:
        return 10;
    case OB_DELAY:
        return 20;
    case OB_CYCLIC:
        return 30;
    case OB_HARDWARE:
        return 40;
    case OB_DPV1:
        return 50;
    case OB_MULTICOMPUTING:
        return 60;
    case OB_REDUNDANCY:
        return 70;
    case OB_ASYNC_ERROR:
        return 80;
    default:
        return 0;
    }
}

int ob_default_class(enum family f, int ob)
{
    switch (ob_kind(ob)) {
    case OB_CYCLE:
        return 1;
    case OB_TOD:
    case OB_DPV1:
        return 2;
    case OB_DELAY:
        return 3 + ob - 20;
    case OB_CYCLIC:
        return 7 + ob - 30;
    case OB_HARDWARE:
        return 16 + ob - 40;
    case OB_MULTICOMPUTING:
        return 25;
    case OB_REDUNDANCY:
        return ob == 72 ? 28 : 25;
    case OB_ASYNC_ERROR: /* [OBS-11]: on S7-400 and CPU 318 OB 80 stands above its fellows */
        return ob == 80 || f == FAMILY_S7_300 ? 26 : 25;
    case OB_STARTUP:
        return 27;
    default:
        return 0;
    }
}

bool ob_class_range(enum family f, int ob, int *low, int *high)
{
    if (f == FAMILY_S7_300)
        return false;
    *low = 2;
    if (within(ob, 10, 47)) {
        *high = 23;
        return ob_kind(ob) != OB_NONE;
    }
    if (ob == 70 || ob == 72) {
        *high = 28;
        return true;
    }
    if (within(ob, 81, 87)) {
        *low = ob == 85 ? 24 : 2;
        *high = 26;
        return true;
    }
    return false;
}

int ob_strt_info(int ob)
{
    if (ob_kind(ob) == OB_DELAY)
        return 0x21 + ob - DINT_FIRST;
    return ob_is_tod(ob) ? 0x11 + ob - TOD_FIRST : -1;
}

int ob_start_event(int ob)
{
    switch (ob_kind(ob)) {
    case OB_TOD:
        return 0x1111 + ob - 10;
    case OB_DELAY:
        return 0x1121 + ob - 20;
    case OB_CYCLIC:
        return 0x1131 + ob - 30;
    case OB_HARDWARE: /* the table knows four lines */
        return ob < 44 ? 0x1141 + ob - 40 : -1;
    default:
        return -1;
    }
}

/* RET_VAL of the SFCs; one code may say different things for different SFCs. */
#ifndef RET_H
#define RET_H

enum {
    RET_OK = 0x0000,
    RET_NOT_DELAYED = 0x8080, /* SFC 42 */
    RET_BAD_OB = 0x8090,
    RET_BAD_SDT = 0x8091,   /* SFC 28 */
    RET_BAD_DTIME = 0x8091, /* SFC 32 */
    RET_BAD_MODE = 0x8091,  /* SFC 39 and 40 */
    RET_BAD_PERIOD = 0x8092,
    RET_NOT_SET = 0x80A0,     /* SFC 29 and 30 */
    RET_NOT_STARTED = 0x80A0, /* SFC 33 */
    RET_PAST = 0x80A1
};

#endif

/* Calendar of the CPU clock: 1990-01-01 to 2089-12-31, and the series of start points. */
#ifndef CALENDAR_H
#define CALENDAR_H

#include <stdbool.h>
#include <stdint.h>

/* Milliseconds since 1990-01-01T00:00:00.000. */
typedef int64_t dt_ms;

#define MS_MINUTE INT64_C(60000)
#define MS_HOUR (60 * MS_MINUTE)
#define MS_DAY (24 * MS_HOUR)
#define DT_NEVER INT64_MAX
#define DT_FAR (36525 * MS_DAY) /* as long as the calendar */

/* A date and time as a program writes it; it need not exist. */
struct civil {
    int year, month, day, hour, minute, second, ms;
};

/* PERIOD of SFC 28 [TINT-33]. Both weekly codes are taken (AMB-01, reading c). */
enum period {
    PERIOD_ONCE = 0x0000,
    PERIOD_MINUTE = 0x0201,
    PERIOD_HOURLY = 0x0401,
    PERIOD_DAILY = 0x1001,
    PERIOD_WEEKLY = 0x1201,
    PERIOD_WEEKLY_ALT = 0x1202,
    PERIOD_MONTHLY = 0x1401,
    PERIOD_YEARLY = 0x1801,
    PERIOD_END_OF_MONTH = 0x2001
};

/* Deliberate mistakes of a calendar, for the faults of the command line. */
enum calendar_quirk {
    QUIRK_CENTURY_NOT_LEAP = 1,
    QUIRK_MONTH_END_30 = 2,
    QUIRK_HOURLY_IS_DAILY = 4
};

bool is_leap_year(int year, unsigned quirks);
int days_in_month(int year, int month, unsigned quirks);

/* True where the date exists, within the range of a CPU clock. */
bool civil_exists(const struct civil *c, unsigned quirks);
dt_ms civil_to_dt(const struct civil *c);
void dt_to_civil(dt_ms t, struct civil *c);
dt_ms dt_last(void);

bool period_known(int period);

/* The first point of the series start + k*period, k >= 0, that is not before `from`;
 * DT_NEVER where the clock's range ends first [TINT-10, TINT-24, TINT-32]. */
dt_ms series_first(dt_ms start, int period, dt_ms from, unsigned quirks);

#endif

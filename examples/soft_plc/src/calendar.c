#include "calendar.h"

enum { FIRST_YEAR = 1990, LAST_YEAR = 2089 };

bool is_leap_year(int year, unsigned quirks)
{
    if (year % 100 == 0)
        return year % 400 == 0 && !(quirks & QUIRK_CENTURY_NOT_LEAP);
    return year % 4 == 0;
}

int days_in_month(int year, int month, unsigned quirks)
{
    static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (month == 2 && is_leap_year(year, quirks))
        return 29;
    return days[month - 1];
}

bool civil_exists(const struct civil *c, unsigned quirks)
{
    return c->year >= FIRST_YEAR && c->year <= LAST_YEAR && c->month >= 1 && c->month <= 12 &&
           c->day >= 1 && c->day <= days_in_month(c->year, c->month, quirks) && c->hour >= 0 &&
           c->hour < 24 && c->minute >= 0 && c->minute < 60 && c->second >= 0 && c->second < 60 &&
           c->ms >= 0 && c->ms < 1000;
}

/* Days from 1990-01-01. A year that begins in March puts the leap day last, so that the
 * length of the months before it is a straight line: (153 m + 2) / 5. */
static int64_t civil_to_days(int year, int month, int day)
{
    int64_t y = month <= 2 ? year - 1 : year;
    int64_t m = month <= 2 ? month + 9 : month - 3;
    return 365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 726773;
}

dt_ms civil_to_dt(const struct civil *c)
{
    return civil_to_days(c->year, c->month, c->day) * MS_DAY + c->hour * MS_HOUR +
           c->minute * MS_MINUTE + c->second * 1000 + c->ms;
}

void dt_to_civil(dt_ms t, struct civil *c)
{
    int64_t days = t / MS_DAY;
    int64_t rest = t % MS_DAY;
    /* Between 1990 and 2089 every fourth year is a leap year, 2000 too. */
    int64_t d = days + 671; /* days since 1988-03-01, the start of a four-year cycle */
    int64_t cycle = d / 1461;
    int64_t in_cycle = d % 1461;
    int64_t year = in_cycle / 365;
    if (year == 4)
        year = 3;
    int64_t in_year = in_cycle - 365 * year;
    int64_t m = (5 * in_year + 2) / 153;
    c->day = (int)(in_year - (153 * m + 2) / 5 + 1);
    c->month = (int)(m < 10 ? m + 3 : m - 9);
    c->year = (int)(1988 + 4 * cycle + year + (m >= 10));
    c->hour = (int)(rest / MS_HOUR);
    c->minute = (int)(rest / MS_MINUTE % 60);
    c->second = (int)(rest / 1000 % 60);
    c->ms = (int)(rest % 1000);
}

dt_ms dt_last(void)
{
    const struct civil last = {LAST_YEAR, 12, 31, 23, 59, 59, 999};
    return civil_to_dt(&last);
}

bool period_known(int period)
{
    switch (period) {
    case PERIOD_ONCE:
    case PERIOD_MINUTE:
    case PERIOD_HOURLY:
    case PERIOD_DAILY:
    case PERIOD_WEEKLY:
    case PERIOD_WEEKLY_ALT:
    case PERIOD_MONTHLY:
    case PERIOD_YEARLY:
    case PERIOD_END_OF_MONTH:
        return true;
    default:
        return false;
    }
}

/* The length of a period that is the same everywhere in the calendar, else 0. */
static dt_ms fixed_length(int period, unsigned quirks)
{
    switch (period) {
    case PERIOD_MINUTE:
        return MS_MINUTE;
    case PERIOD_HOURLY:
        return quirks & QUIRK_HOURLY_IS_DAILY ? MS_DAY : MS_HOUR;
    case PERIOD_DAILY:
        return MS_DAY;
    case PERIOD_WEEKLY:
    case PERIOD_WEEKLY_ALT:
        return 7 * MS_DAY;
    default:
        return 0;
    }
}

/* The point of a monthly, yearly or end-of-month series in one month, or DT_NEVER. */
static dt_ms point_in_month(const struct civil *start, int period, int year, int month,
                            unsigned quirks)
{
    struct civil c = *start;
    int length = days_in_month(year, month, quirks);
    c.year = year;
    c.month = month;
    if (period == PERIOD_END_OF_MONTH) /* [TINT-19], AMB-39: only the time of day of SDT counts */
        c.day = quirks & QUIRK_MONTH_END_30 && length > 30 ? 30 : length;
    else if (c.day > length || (period == PERIOD_YEARLY && month != start->month))
        return DT_NEVER; /* AMB-38: February 29 has its point in leap years only */
    return civil_to_dt(&c);
}

static dt_ms first_by_month(dt_ms start, int period, dt_ms from, unsigned quirks)
{
    struct civil s, f;
    dt_to_civil(start, &s);
    dt_to_civil(from, &f);
    for (int i = f.year * 12 + f.month - 1; i < (LAST_YEAR + 1) * 12; i++) {
        dt_ms point = point_in_month(&s, period, i / 12, i % 12 + 1, quirks);
        if (point != DT_NEVER && point >= from)
            return point;
    }
    return DT_NEVER;
}

dt_ms series_first(dt_ms start, int period, dt_ms from, unsigned quirks)
{
    if (from > dt_last())
        return DT_NEVER;
    if (from < start)
        from = start;
    if (period == PERIOD_ONCE)
        return from == start ? start : DT_NEVER;
    dt_ms length = fixed_length(period, quirks);
    if (length == 0)
        return first_by_month(start, period, from, quirks);
    dt_ms point = start + (from - start + length - 1) / length * length;
    return point <= dt_last() ? point : DT_NEVER;
}

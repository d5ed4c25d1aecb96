/* The calendar of the CPU clock, 1990-01-01 to 2089-12-31, and the series of start points. */
#include "internal.h"

enum { FIRST_YEAR = 1990, LAST_YEAR = 2089 };

static bool is_leap_year(int year)
{
    if (year % 100 == 0)
        return year % 400 == 0;
    return year % 4 == 0;
}

static int days_in_month(int year, int month)
{
    static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (month == 2 && is_leap_year(year))
        return 29;
    return days[month - 1];
}

bool s7cpu_date_exists(const struct s7cpu_date *c)
{
    return c->year >= FIRST_YEAR && c->year <= LAST_YEAR && c->month >= 1 && c->month <= 12 &&
           c->day >= 1 && c->day <= days_in_month(c->year, c->month) && c->hour >= 0 &&
           c->hour < 24 && c->minute >= 0 && c->minute < 60 && c->second >= 0 && c->second < 60 &&
           c->ms >= 0 && c->ms < 1000;
}

/* Days from 1990-01-01. A year that begins in March puts the leap day last, so that the
 * length of the months before it is a straight line: (153 m + 2) / 5. */
static int64_t days_since_1990(int year, int month, int day)
{
    int64_t y = month <= 2 ? year - 1 : year;
    int64_t m = month <= 2 ? month + 9 : month - 3;
    return 365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 726773;
}

int64_t s7cpu_ms(const struct s7cpu_date *c)
{
    return days_since_1990(c->year, c->month, c->day) * S7CPU_DAY + c->hour * S7CPU_HOUR +
           c->minute * S7CPU_MINUTE + c->second * 1000 + c->ms;
}

struct s7cpu_date s7cpu_date(int64_t ms)
{
    int64_t rest = ms % S7CPU_DAY;
    /* Between 1990 and 2089 every fourth year is a leap year, 2000 too. */
    int64_t d = ms / S7CPU_DAY + 671; /* days since 1988-03-01, the start of a four-year cycle */
    int64_t cycle = d / 1461;
    int64_t in_cycle = d % 1461;
    int64_t year = in_cycle / 365;
    if (year == 4)
        year = 3;
    int64_t in_year = in_cycle - 365 * year;
    int64_t m = (5 * in_year + 2) / 153;
    return (struct s7cpu_date){.year = (int)(1988 + 4 * cycle + year + (m >= 10)),
                               .month = (int)(m < 10 ? m + 3 : m - 9),
                               .day = (int)(in_year - (153 * m + 2) / 5 + 1),
                               .hour = (int)(rest / S7CPU_HOUR),
                               .minute = (int)(rest / S7CPU_MINUTE % 60),
                               .second = (int)(rest / 1000 % 60),
                               .ms = (int)(rest % 1000)};
}

bool s7_period_known(int period)
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
static int64_t fixed_length(int period)
{
    switch (period) {
    case PERIOD_MINUTE:
        return S7CPU_MINUTE;
    case PERIOD_HOURLY:
        return S7CPU_HOUR;
    case PERIOD_DAILY:
        return S7CPU_DAY;
    case PERIOD_WEEKLY:
    case PERIOD_WEEKLY_ALT:
        return 7 * S7CPU_DAY;
    default:
        return 0;
    }
}

/* The point of a monthly, yearly or end-of-month series in one month, or S7CPU_NEVER. */
static int64_t point_in_month(const struct s7cpu_date *start, int period, int year, int month)
{
    struct s7cpu_date c = *start;
    int length = days_in_month(year, month);
    c.year = year;
    c.month = month;
    if (period == PERIOD_END_OF_MONTH) /* [TINT-19], AMB-39: only the time of day of SDT counts */
        c.day = length;
    else if (c.day > length || (period == PERIOD_YEARLY && month != start->month))
        return S7CPU_NEVER; /* AMB-38: February 29 has its point in leap years only */
    return s7cpu_ms(&c);
}

static int64_t first_by_month(int64_t start, int period, int64_t from)
{
    const struct s7cpu_date s = s7cpu_date(start), f = s7cpu_date(from);
    for (int i = f.year * 12 + f.month - 1; i < (LAST_YEAR + 1) * 12; i++) {
        int64_t point = point_in_month(&s, period, i / 12, i % 12 + 1);
        if (point != S7CPU_NEVER && point >= from)
            return point;
    }
    return S7CPU_NEVER;
}

int64_t s7_series_first(int64_t start, int period, int64_t from)
{
    if (from > S7CPU_LAST)
        return S7CPU_NEVER;
    if (from < start)
        from = start;
    if (period == PERIOD_ONCE)
        return from == start ? start : S7CPU_NEVER;
    int64_t length = fixed_length(period);
    if (length == 0)
        return first_by_month(start, period, from);
    int64_t point = start + (from - start + length - 1) / length * length;
    return point <= S7CPU_LAST ? point : S7CPU_NEVER;
}

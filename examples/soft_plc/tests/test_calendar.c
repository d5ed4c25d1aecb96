/* The calendar against a walk that knows nothing but the lengths of the months. */
#include "internal.h"
#include "test.h"

static int64_t at(int year, int month, int day, int hour, int minute)
{
    const struct s7cpu_date c = {year, month, day, hour, minute, 0, 0};
    return s7cpu_ms(&c);
}

static void walk(void)
{
    int y = 1990, m = 1, d = 1, bad = 0;
    int64_t day = 0;
    for (; y < 2090; day++) {
        const struct s7cpu_date c = {y, m, d, 23, 59, 59, 999};
        const struct s7cpu_date none = {y, m, d + 1, 0, 0, 0, 0};
        int64_t t = s7cpu_ms(&c);
        const struct s7cpu_date back = s7cpu_date(t);
        int length = m == 2 ? (y % 4 == 0 ? 29 : 28) : m == 4 || m == 6 || m == 9 || m == 11 ? 30 : 31;
        bad += t != day * S7CPU_DAY + S7CPU_DAY - 1;
        bad += back.year != y || back.month != m || back.day != d || back.ms != 999;
        bad += !s7cpu_date_exists(&c);
        bad += s7cpu_date_exists(&none) != (d < length);
        /* The end of this month, from every day of it. */
        bad += s7_series_first(at(1990, 1, 1, 6, 0), PERIOD_END_OF_MONTH, at(y, m, d, 0, 0)) !=
               at(y, m, length, 6, 0);
        /* Monthly on the 28th: this month's or the next one's. */
        int64_t monthly = d <= 28 ? at(y, m, 28, 0, 0)
                        : m < 12 ? at(y, m + 1, 28, 0, 0)
                                 : at(y + 1, 1, 28, 0, 0);
        if (y < 2089 || m < 12 || d <= 28)
            bad += s7_series_first(at(1990, 1, 28, 0, 0), PERIOD_MONTHLY, at(y, m, d, 0, 0)) !=
                   monthly;
        if (++d > length) {
            d = 1;
            if (++m > 12) {
                m = 1;
                y++;
            }
        }
    }
    CHECK(bad == 0);
    CHECK(day == 36525);
    CHECK(S7CPU_LAST == day * S7CPU_DAY - 1);
}

static void series(void)
{
    const int64_t six = at(2026, 11, 21, 6, 0);
    CHECK(s7_series_first(six, PERIOD_ONCE, six) == six);
    CHECK(s7_series_first(six, PERIOD_ONCE, six + 1) == S7CPU_NEVER);
    CHECK(s7_series_first(six, PERIOD_MINUTE, six - S7CPU_DAY) == six); /* [TINT-24] */
    CHECK(s7_series_first(six, PERIOD_MINUTE, six + 1) == six + S7CPU_MINUTE);
    CHECK(s7_series_first(six, PERIOD_HOURLY, six + 1) == six + S7CPU_HOUR);
    CHECK(s7_series_first(six, PERIOD_DAILY, six + 5 * S7CPU_DAY) == six + 5 * S7CPU_DAY);
    CHECK(s7_series_first(six, PERIOD_WEEKLY, six + 1) == six + 7 * S7CPU_DAY);
    CHECK(s7_series_first(six, PERIOD_WEEKLY_ALT, six + 8 * S7CPU_DAY) == six + 14 * S7CPU_DAY);
    CHECK(s7_series_first(six, PERIOD_YEARLY, six + 1) == at(2027, 11, 21, 6, 0));
    CHECK(s7_series_first(six, PERIOD_MONTHLY, six + 1) == at(2026, 12, 21, 6, 0));
    /* AMB-38: February 29 comes in leap years only; 2088 is the last. */
    CHECK(s7_series_first(at(1996, 2, 29, 6, 0), PERIOD_YEARLY, at(1996, 3, 1, 0, 0)) ==
          at(2000, 2, 29, 6, 0));
    CHECK(s7_series_first(at(2088, 2, 29, 6, 0), PERIOD_YEARLY, at(2088, 3, 1, 0, 0)) ==
          S7CPU_NEVER);
    /* AMB-39: the first month end at or after SDT. */
    CHECK(s7_series_first(at(2026, 11, 30, 6, 0), PERIOD_END_OF_MONTH, at(2026, 11, 1, 0, 0)) ==
          at(2026, 11, 30, 6, 0));
    CHECK(s7_series_first(at(2026, 1, 31, 6, 0), PERIOD_END_OF_MONTH, at(2026, 1, 31, 6, 1)) ==
          at(2026, 2, 28, 6, 0));
    CHECK(s7_series_first(six, PERIOD_MINUTE, S7CPU_LAST) == S7CPU_NEVER);
    CHECK(s7_series_first(six, PERIOD_END_OF_MONTH, at(2089, 12, 31, 7, 0)) == S7CPU_NEVER);
}

void test_calendar(void)
{
    walk();
    series();
}

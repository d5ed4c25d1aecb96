/* The calendar against a walk that knows nothing but the lengths of the months. */
#include "calendar.h"

#include "test.h"

static dt_ms at(int year, int month, int day, int hour, int minute)
{
    const struct civil c = {year, month, day, hour, minute, 0, 0};
    return civil_to_dt(&c);
}

static void walk(void)
{
    int y = 1990, m = 1, d = 1, bad = 0;
    int64_t day = 0;
    for (; y < 2090; day++) {
        const struct civil c = {y, m, d, 23, 59, 59, 999};
        const struct civil none = {y, m, d + 1, 0, 0, 0, 0};
        struct civil back;
        dt_ms t = civil_to_dt(&c);
        dt_to_civil(t, &back);
        int length = m == 2 ? (y % 4 == 0 ? 29 : 28) : m == 4 || m == 6 || m == 9 || m == 11 ? 30 : 31;
        bad += t != day * MS_DAY + MS_DAY - 1;
        bad += back.year != y || back.month != m || back.day != d || back.ms != 999;
        bad += !civil_exists(&c, 0);
        bad += civil_exists(&none, 0) != (d < length);
        /* The end of this month, from every day of it. */
        bad += series_first(at(1990, 1, 1, 6, 0), PERIOD_END_OF_MONTH, at(y, m, d, 0, 0), 0) !=
               at(y, m, length, 6, 0);
        /* Monthly on the 28th: this month's or the next one's. */
        dt_ms monthly = d <= 28 ? at(y, m, 28, 0, 0)
                        : m < 12 ? at(y, m + 1, 28, 0, 0)
                                 : at(y + 1, 1, 28, 0, 0);
        if (y < 2089 || m < 12 || d <= 28)
            bad += series_first(at(1990, 1, 28, 0, 0), PERIOD_MONTHLY, at(y, m, d, 0, 0), 0) !=
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
    CHECK(dt_last() == day * MS_DAY - 1);
}

static void series(void)
{
    const dt_ms six = at(2026, 11, 21, 6, 0);
    CHECK(series_first(six, PERIOD_ONCE, six, 0) == six);
    CHECK(series_first(six, PERIOD_ONCE, six + 1, 0) == DT_NEVER);
    CHECK(series_first(six, PERIOD_MINUTE, six - MS_DAY, 0) == six); /* [TINT-24] */
    CHECK(series_first(six, PERIOD_MINUTE, six + 1, 0) == six + MS_MINUTE);
    CHECK(series_first(six, PERIOD_HOURLY, six + 1, 0) == six + MS_HOUR);
    CHECK(series_first(six, PERIOD_HOURLY, six + 1, QUIRK_HOURLY_IS_DAILY) == six + MS_DAY);
    CHECK(series_first(six, PERIOD_DAILY, six + 5 * MS_DAY, 0) == six + 5 * MS_DAY);
    CHECK(series_first(six, PERIOD_WEEKLY, six + 1, 0) == six + 7 * MS_DAY);
    CHECK(series_first(six, PERIOD_WEEKLY_ALT, six + 8 * MS_DAY, 0) == six + 14 * MS_DAY);
    CHECK(series_first(six, PERIOD_YEARLY, six + 1, 0) == at(2027, 11, 21, 6, 0));
    CHECK(series_first(six, PERIOD_MONTHLY, six + 1, 0) == at(2026, 12, 21, 6, 0));
    /* AMB-38: February 29 comes in leap years only; 2088 is the last. */
    CHECK(series_first(at(1996, 2, 29, 6, 0), PERIOD_YEARLY, at(1996, 3, 1, 0, 0), 0) ==
          at(2000, 2, 29, 6, 0));
    CHECK(series_first(at(1996, 2, 29, 6, 0), PERIOD_YEARLY, at(1996, 3, 1, 0, 0),
                       QUIRK_CENTURY_NOT_LEAP) == at(2004, 2, 29, 6, 0));
    CHECK(series_first(at(2088, 2, 29, 6, 0), PERIOD_YEARLY, at(2088, 3, 1, 0, 0), 0) == DT_NEVER);
    /* AMB-39: the first month end at or after SDT. */
    CHECK(series_first(at(2026, 11, 30, 6, 0), PERIOD_END_OF_MONTH, at(2026, 11, 1, 0, 0), 0) ==
          at(2026, 11, 30, 6, 0));
    CHECK(series_first(at(2026, 1, 31, 6, 0), PERIOD_END_OF_MONTH, at(2026, 1, 31, 6, 1), 0) ==
          at(2026, 2, 28, 6, 0));
    CHECK(series_first(six, PERIOD_MINUTE, dt_last(), 0) == DT_NEVER);
    CHECK(series_first(six, PERIOD_END_OF_MONTH, at(2089, 12, 31, 7, 0), 0) == DT_NEVER);
}

void test_calendar(void)
{
    walk();
    series();
    CHECK(is_leap_year(2000, 0) && is_leap_year(2088, 0) && !is_leap_year(2026, 0));
    CHECK(!is_leap_year(2000, QUIRK_CENTURY_NOT_LEAP));
}

"""What happens inside the latency window, clocks written in seconds or minutes, series over months."""

from datetime import datetime

from tests.by_hand.situations.builder import DAY, HOUR, MINUTE, MS, VARIANTS, Log, Variant, bit, iso, moment, situation

SLOW = [VARIANTS[0], VARIANTS[2], VARIANTS[3]]
"""The variants with a latency window."""


@situation("AIRT-01", SLOW)
def window_dis_airt(v: Variant) -> None:
    a = v.log().interrupt(40).wait(1).dis_airt(1).wait(v.latency + 50)
    a.copy().tick().en_airt(0).runs(40).accepted("delayed inside the window")
    a.copy().start(40).end(40).en_airt(0x8080).accepted("an unseen end of the cycle may have released it", "AIRT-04")
    b = v.log(cycle=True).interrupt(40).wait(1).dis_airt(1).wait(v.latency + 50)
    b.copy().start(40).rejected("delayed inside the window")
    b.copy().en_airt(0).late("the window begins anew when the delay ends", "AIRT-08")
    c = v.log().interrupt(35).start(35).interrupt(40).wait(1).dis_airt(1).wait(v.latency + 50)
    c.copy().start(40).rejected("delayed inside the window")
    c.copy().end(35).late("the window begins anew when the delay ends", "AIRT-04")


@situation("AMB-72", SLOW)
def window_dis_irt(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point, 1).dis_irt(2, v.ob)
    a.copy().runs().accepted("requested before DIS_IRT")
    a.copy().wait(v.latency).tick().rejected("requested before DIS_IRT: it is owed")
    a.copy().runs().until(v.point + MINUTE).start().rejected("the next point is blocked", "IRT-01")
    b = v.log().armed(v.point).clock(v.point + MINUTE).wait(1).dis_irt(2, 80)
    b.copy().runs(80, flt_id=5).runs().accepted("OB 80 was requested before DIS_IRT")
    b.copy().wait(v.latency).tick().rejected("OB 80 was requested before DIS_IRT: it is owed")
    c = v.log().interrupt(35).wait(1).dis_irt(0).interrupt(35)
    c.copy().runs(35, ms=1).start(35).rejected("the second event is blocked", "IRT-01")


@situation("AMB-59", SLOW)
def window_clock_back(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point, 1).clock(v.point - 5000 * MS)
    a.copy().runs().accepted("the request stays")
    a.copy().wait(v.latency).tick().rejected("the request stays: it is owed")
    a.copy().runs().until(v.point).start().rejected("the once is used up", "AMB-71")
    b = v.log().armed(v.point, 0x201).until(v.point, 1).clock(v.point - 5000 * MS).runs().until(v.point)
    if v.s7_300:
        b.copy().late("S7-300: served again", "CLK-10")
    else:
        b.copy().start().rejected("its point counts as served", "CLK-09")


@situation("AMB-66", SLOW)
def window_delete(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point, 1).event("delete", ob=v.ob)
    a.copy().runs(85).accepted("missing at its call")
    a.copy().start().rejected("missing at its call")
    b = v.log([1, 80, 85]).armed(v.point).until(v.point, 1).event("delete", ob=85)
    b.copy().stop(0x456D).accepted("OB 85 is gone when it would be called", "OBS-21")
    b.copy().start(85).rejected("OB 85 is gone when it would be called", "OBS-21")
    c = v.log().armed(v.point).clock(v.point + MINUTE).wait(1).event("delete", ob=80)
    c.copy().stop(0x4568).accepted("OB 80 is gone when it would be called", "OBS-22")
    c.copy().start(80).rejected("OB 80 is gone when it would be called", "OBS-22")


@situation("AMB-11", SLOW)
def window_cancel(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point, 1)
    a.copy().can_tint(0).wait(99).tick().accepted("withdrawn inside the window")
    a.copy().can_tint(0).start().rejected("withdrawn inside the window")
    a.copy().set_tint(v.point + 3 * MINUTE).start().rejected("withdrawn inside the window")
    a.copy().act_tint(0).runs().accepted("a second ACT changes nothing", "TINT-63")
    a.copy().act_tint(0).wait(v.latency).tick().rejected("a second ACT changes nothing", "TINT-63")
    a.copy().qry_tint(0x10).rejected("periodic stays active", "AMB-34")
    b = v.log().srt_dint(500).wait(501)
    b.copy().can_dint(0).wait(99).tick().accepted("withdrawn inside the window")
    b.copy().can_dint(0x80A0).runs(v.delay_ob).accepted("or kept")
    b.copy().can_dint(0x80A0).wait(v.latency).tick().rejected("kept: it is owed")


@situation("AMB-52", SLOW)
def window_clock_forward(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point, 1).clock(v.point + MINUTE + 5000 * MS)
    a.copy().runs(80, flt_id=5, error_info=bit(v.ob)).runs().runs().accepted(
        "the waiting run and a catch-up of its own"
    )
    a.copy().runs(80, flt_id=5).runs().wait(v.latency + 9).tick().accepted("or merged")
    a.copy().wait(v.latency + 1).tick().rejected("OB 80 is owed", "CLK-02")
    a.copy().runs(80).runs(ms=1).runs(ms=1).start().rejected("two runs at most", "CLK-03")


@situation("TINT-14")
def window_later_run(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start().until(v.point + MINUTE).runs(80)
    a.copy().dis_irt(2, v.ob).end().runs().accepted("the later run was requested before DIS_IRT", "AMB-72")
    a.copy().dis_irt(2, v.ob).end().late("the later run was requested before DIS_IRT", "AMB-72")
    a.copy().dis_airt(1).end().runs().accepted("the OB's end releases it", "AIRT-04")
    a.copy().event("delete", ob=v.ob).end().runs(85).accepted("deleted: missing at the later call", "AMB-66")
    a.copy().event("delete", ob=v.ob).end().start().rejected("deleted: missing at the later call", "AMB-66")
    a.copy().clock(v.point).end().runs().accepted("the clock set back: the request stays", "AMB-59")
    a.copy().hold().wait(9).release().end().runs().accepted("HOLD keeps it", "OBS-45")


def written(log: Log, length: int) -> Log:
    """The same log with ``at`` cut to so many characters: 19 for seconds, 16 for minutes."""
    log.lines[1:] = [line | {"at": line["at"][:length]} for line in log.lines[1:]]
    return log


@situation("FP-2", [VARIANTS[0], VARIANTS[2]])
def coarse_seconds(v: Variant) -> None:
    a = v.log().srt_dint(2500)
    written(a.copy().wait(2000).start(v.delay_ob), 19).rejected("the difference of `at` is 2000 ms", "DINT-06")
    written(a.copy().wait(2000).tick(), 19).accepted("the difference of `at` is 2000 ms")
    written(a.copy().wait(3000).tick(), 19).rejected("the difference of `at` is 3000 ms", "DINT-06")
    written(v.log().srt_dint(3000).wait(3000).runs(v.delay_ob), 19).accepted("the difference of `at` is 3000 ms")
    b = v.log().armed(v.point)
    written(b.copy().until(v.point).runs(), 19).accepted("on the point")
    written(b.copy().until(v.point, 1000).start(), 19).rejected("a second late", "TINT-23")
    written(b.copy().until(v.point).tick(), 19).accepted("the window is open")
    written(b.copy().until(v.point, 1000).tick(), 19).rejected("a second late", "TINT-23")
    written(b.copy().until(v.point, -1000).start(), 19).rejected("a second early", "TINT-32")
    shown = b.copy().until(v.point)
    written(shown.copy().start(time=iso(v.point + 999 * MS)), 19).accepted("`at` stands for its second", "FP-10")
    written(shown.copy().start(time=iso(v.point + 1000 * MS)), 19).rejected("beyond its second", "FP-10")


@situation("FP-2", [VARIANTS[0], VARIANTS[2]])
def coarse_minutes(v: Variant) -> None:
    a = v.log(begin=v.point).srt_dint(60000)
    written(a.copy().wait(60000).runs(v.delay_ob), 16).accepted("the difference of `at` is a minute")
    written(a.copy().wait(120000).tick(), 16).rejected("the difference of `at` is two minutes", "DINT-06")
    written(a.copy().start(v.delay_ob), 16).rejected("the difference of `at` is 0", "DINT-06")


@situation("TINT-32")
def series_of_days(v: Variant) -> None:
    a = v.log(begin=moment("2028-02-27T23:59:30")).armed("2028-02-28T00:00", 0x1001)
    days = [moment("2028-02-28T00:00") + k * DAY for k in range(4)]
    for k, day in enumerate(days):
        a.copy().until(day).late(f"day {k + 1}: February has 29 days")
        a.until(day).runs(period=0x1001)
    a.copy().accepted("four days, over February 29")
    a.copy().until(days[-1] + HOUR).start().rejected("no point within the day")


@situation("TINT-19")
def series_of_month_ends(v: Variant) -> None:
    year = [2026, 2028, 2088, 2100 - 200][v.number]
    if year < 1990:
        year = 1999
    leap = year % 4 == 0
    ends = [datetime(year, m, d, 6) for m, d in ((1, 31), (2, 29 if leap else 28), (3, 31), (4, 30), (5, 31))]
    a = v.log(begin=datetime(year, 1, 31, 5, 59, 30)).armed(iso(ends[0]), 0x2001)
    for end in ends:
        a.copy().until(end).late(f"the last day of month {end.month}")
        a.copy().until(end, -1).start().rejected("not before its time of day")
        a.until(end).runs()
    a.copy().accepted("five month ends")
    a.copy().until(datetime(year, 6, 1, 6)).start().rejected("June 1 is no month end")


@situation("TINT-32")
def series_of_months(v: Variant) -> None:
    year = v.begin.year
    a = v.log(begin=datetime(year, 1, 28, 5, 59, 30)).armed(iso(datetime(year, 1, 28, 6)), 0x1401)
    for month in (1, 2, 3):
        point = datetime(year, month, 28, 6)
        a.copy().until(point).late(f"the 28th of month {month}")
        a.until(point).runs(period=0x1401)
    a.copy().until(datetime(year, 3, 31, 6)).start().rejected("the 31st is no point")
    weeks = v.log(begin=datetime(year, 2, 20, 5, 59, 30)).armed(iso(datetime(year, 2, 20, 6)), 0x1201)
    for k in range(3):
        point = datetime(year, 2, 20, 6) + k * 7 * DAY
        weeks.copy().until(point).late(f"week {k + 1}")
        weeks.until(point).runs()
    weeks.accepted("three weeks over the end of February")


@situation("CLK-09")
def memory_of_days(v: Variant) -> None:
    begin = moment("2027-02-26T05:59:30")
    a = v.log(begin=begin).armed("2027-02-26T06:00", 0x1001)
    days = [moment("2027-02-26T06:00") + k * DAY for k in range(3)]
    for day in days:
        a.until(day).runs()
    a.clock(days[1] - HOUR)
    if v.s7_300:
        a.copy().until(days[1]).late("S7-300: February 27 again", "CLK-10")
        a.copy().until(days[1]).runs().until(days[2]).runs().until(days[2] + DAY).runs().accepted("S7-300", "CLK-10")
    else:
        a.copy().until(days[1]).start().rejected("February 27 was served")
        a.copy().until(days[2]).start().rejected("February 28 was served")
        a.copy().until(days[2] + DAY).late("March 1 was not served")
        a.copy().until(days[2] + DAY).runs().accepted("March 1 was not served")
    a.copy().start().rejected("no point an hour before", "AMB-40")

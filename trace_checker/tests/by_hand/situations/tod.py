"""Time-of-day interrupts, SFC 28 to 31."""

from datetime import timedelta

from tests.by_hand.situations.builder import (
    DAY,
    HOUR,
    MINUTE,
    REMEMBERING,
    REPEATING,
    VARIANTS,
    Variant,
    iso,
    moment,
    situation,
)

BADOB = [9, 18, 0, -1, 99, 32767, 20, 35]


@situation("TINT-35")
def tint_bad_ob(v: Variant) -> None:
    for i, b in enumerate(BADOB[v.number * 2 : v.number * 2 + 2]):
        v.log().set_tint(ret=0x8090, ob=b).can_tint(0x8090, b).act_tint(0x8090, b).qry_tint(0, b, 0x8090).accepted(
            "an OB outside 10..17 is a bad OB_NR of SFC 28-31"
        )
        a = v.log()
        wrong = [
            a.copy().set_tint(ret=0, ob=b),
            a.copy().can_tint(0x80A0, b),
            a.copy().act_tint(0x80A0, b),
            a.copy().qry_tint(0x10, b, 0),
        ]
        wrong[(v.number + i) % 4].rejected("an OB outside 10..17 gives 8090")


@situation("TINT-01")
def tint_all_offered(v: Variant) -> None:
    a = v.log()
    for o in range(10, 18):
        a.set_tint(ob=o).act_tint(0, o).can_tint(0, o)
    a.accepted("OB 10-17 are offered by every CPU, loaded or not (AMB-64)")
    if v.ob != 17:
        v.log().set_tint(ob=17, ret=0x8090).rejected("OB 17 is offered by every CPU: SET cannot answer 8090", "AMB-64")
    else:
        v.log().set_tint(ob=14, ret=0x8090).rejected("OB 14 is offered", "AMB-64")


@situation("TINT-05")
def tint_set_only(v: Variant) -> None:
    a = v.log().set_tint(per=[0, 0x201, 0x401, 0x1001][v.number])
    a.copy().until(v.point, 200).tick().accepted("set is not active: no start is owed")
    a.copy().until(v.point).start().rejected("set, never activated: the OB does not run")
    a.copy().until(v.point, -1).act_tint().until(v.point).runs().accepted("activated one millisecond before its point")


@situation("TINT-24")
def tint_first_point(v: Variant) -> None:
    a = v.log().armed(per=[0, 0x201, 0x401, 0x1001][v.number])
    a.copy().until(v.point).runs().accepted("starts exactly at the point")
    a.copy().until(v.point, v.latency).runs().accepted("starts at the end of the latency")
    a.copy().until(v.point, -1).start().rejected("one millisecond before its start point", "TINT-32")
    a.copy().until(v.point, v.latency + 1).start().rejected("the start is past the latency", "TINT-23")
    a.copy().until(v.point).late("the interrupt had to come", "TINT-23")


@situation("TINT-64")
def tint_once_used(v: Variant) -> None:
    a = v.log().armed().until(v.point).runs()
    a.copy().act_tint(0x80A0).can_tint(0x80A0).qry_tint(0x10).accepted(
        "once is cancelled by its call: nothing is set (AMB-08 a)"
    )
    a.copy().act_tint(0).rejected("a used-up once has nothing to activate", "AMB-08")
    a.copy().act_tint(0x80A1).rejected("80A1 is reading b of AMB-08, the default is a", "AMB-08")
    a.copy().can_tint(0).rejected("a used-up once has no date left to clear", "AMB-08")
    a.copy().qry_tint(0x14).rejected("bit 2 is 0 once it has elapsed", "TINT-74")
    b = v.log(readings={"AMB-08": "b"}).armed().until(v.point).runs()
    b.copy().act_tint(0x80A1).can_tint(0).act_tint(0x80A0).accepted(
        "under AMB-08 b the date is kept: ACT 80A1, CAN 0000", "AMB-08"
    )
    b.copy().act_tint(0x80A0).rejected("under AMB-08 b the date is kept", "AMB-08")
    a.copy().armed(v.point + MINUTE).until(v.point + MINUTE).runs().accepted(
        "it can be set and activated again", "TINT-08"
    )


@situation("TINT-10")
def tint_periodic_past(v: Variant) -> None:
    per, back = [
        (0x201, 3 * DAY + 7 * MINUTE),
        (0x401, 400 * HOUR),
        (0x1001, 800 * DAY),
        (0x401, 3 * HOUR),
    ][v.number]
    sdt = v.point - back
    a = v.log().set_tint(sdt, per)
    a.copy().act_tint().until(v.point).runs().accepted(f"the next point of the series from now on is {v.point.time()}")
    a.copy().act_tint().tick().start().rejected("no call for the past")
    a.copy().act_tint(0x80A1).rejected("80A1 never comes for a periodic one", "TINT-62")
    a.copy().act_tint().until(v.point).late("the next point of the series is served", "TINT-10")
    v.log().set_tint(sdt, per, 0x80A1).rejected("a periodic start point in the past is legal for SET", "TINT-37")
    v.log(readings={"AMB-02": "a"}).set_tint(sdt, per, 0x80A1).act_tint(0x80A0).accepted(
        "AMB-02 a: 80A1 for every PERIOD", "AMB-02"
    )
    v.log(readings={"AMB-02": "a"}).set_tint(sdt, per, 0).rejected("AMB-02 a: 80A1 for every PERIOD", "AMB-02")


@situation("TINT-11")
def tint_seconds(v: Variant) -> None:
    s = iso(v.point + timedelta(seconds=59, milliseconds=999))
    a = v.log().set_tint(s).act_tint()
    a.copy().until(v.point).runs().accepted("seconds and milliseconds of SDT are forced to 0")
    a.copy().until(v.point).late("the OB is due at the full minute", "TINT-11")
    b = v.log(readings={"AMB-14": "c"}).set_tint(s).act_tint()
    b.copy().until(v.point).start().rejected("AMB-14 c truncates nothing: due 59.999 s later", "AMB-14")
    b.copy().until(v.point, 59999).runs().accepted("AMB-14 c: due at the second given", "AMB-14")


@situation("AMB-14")
def tint_this_minute(v: Variant) -> None:
    s = iso(v.begin + timedelta(seconds=15))
    v.log().set_tint(s, ret=0x80A1).accepted("this minute's :45 is forced to :00 and is past")
    v.log().set_tint(s, ret=0).rejected("truncated first, then compared: past")
    v.log(readings={"AMB-14": "b"}).set_tint(s, ret=0x80A1).rejected(
        "AMB-14 b compares the untruncated SDT, which lies ahead"
    )
    v.log(readings={"AMB-14": "c"}).set_tint(s, ret=0).act_tint(0).wait(15000).runs().accepted(
        "AMB-14 c: starts at :45"
    )
    a = v.log(begin=v.point)
    a.copy().set_tint(ret=0).act_tint(0).runs().accepted(
        "SDT equal to the clock is not past, the call follows at once", "AMB-37"
    )
    a.copy().set_tint(ret=0x80A1).rejected("equal is not past", "AMB-37")
    a.copy().set_tint(ret=0).act_tint(0x80A1).rejected("equal is not past", "AMB-37")
    a.copy().set_tint(ret=0).act_tint(0).late("the call follows at once", "AMB-37")
    a.copy().wait(1).set_tint(ret=0x80A1).accepted("one millisecond later it is past", "AMB-14")
    a.copy().wait(1).set_tint(ret=0).rejected("one millisecond later it is past", "TINT-36")
    a.copy().set_tint(ret=0).wait(1).act_tint(0x80A1).accepted("the point passed between SET and ACT", "TINT-61")
    a.copy().set_tint(ret=0).wait(1).act_tint(0).rejected("the point passed between SET and ACT", "TINT-61")


@situation("TINT-12")
def tint_strictly_in_turn(v: Variant) -> None:
    a = v.log().armed(v.point).armed(v.point + MINUTE, ob=v.other).until(v.point).start().until(v.point + MINUTE)
    a.copy().wait(500).end().runs(v.other).accepted("the second waits for the end of the first")
    a.copy().wait(v.latency).start(v.other).rejected("OBs of one class never interrupt each other", "OBS-02")
    a.copy().wait(500).end().late("the class is free again: the waiting one is owed", "TINT-12")


@situation("TINT-12")
def tint_order_of_events(v: Variant) -> None:
    # ob2 due first, ob second, both behind OB 35
    a = (
        v.log()
        .armed(v.point, ob=v.other)
        .armed(v.point + MINUTE, ob=v.ob)
        .until(v.point, -5)
        .interrupt(35)
        .start(35)
        .until(v.point + MINUTE, 7)
        .end(35)
    )
    a.copy().runs(v.other).runs(v.ob).accepted("in order of their start events", "OBS-02")
    a.copy().start(v.ob).rejected("the other one's start event is a minute older", "OBS-02")


@situation("AMB-29")
def tint_same_minute(v: Variant) -> None:
    a = v.log().armed(v.point, ob=v.ob).armed(v.point, ob=v.other).until(v.point)
    x, y = sorted((v.ob, v.other))
    a.copy().runs(x, ms=0).runs(y).accepted("due together: any order")
    a.copy().runs(y, ms=0).runs(x).accepted("due together: any order")
    b = v.log(readings={"AMB-29": "b"}).armed(v.point, ob=v.ob).armed(v.point, ob=v.other).until(v.point)
    b.copy().start(y).rejected("AMB-29 b: ascending OB numbers")
    b.copy().runs(x, ms=0).runs(y).accepted("AMB-29 b: ascending")


@situation("TINT-13")
def tint_in_startup(v: Variant) -> None:
    a = v.log(mode="STARTUP").armed(v.point, 0x201)
    a.copy().until(v.point).wait(1).start().rejected("OB 1x is not executed in STARTUP")
    b = a.copy().until(v.point, 2 * 60000 + 15000).run()
    b.copy().runs().tick().accepted("after STARTUP one deferred run", "AMB-35")
    b.copy().runs(ms=0).start().rejected("three points in STARTUP give one run", "AMB-35")
    b.copy().late("the deferred run is owed after STARTUP", "TINT-13")
    b.copy().start(80, flt_id=2).rejected("no time error for points of STARTUP", "AMB-35")
    c = (
        v.log(mode="STARTUP", readings={"AMB-35": "b"})
        .armed(v.point, 0x201)
        .until(v.point, 60000 + 15000)
        .run()
        .runs(ms=0)
        .runs()
    )
    c.accepted("AMB-35 b: one run per point", "AMB-35")


@situation("TINT-14")
def tint_overlap(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start().until(v.point + MINUTE)
    a.copy().runs(80, flt_id=2).wait(300).end().runs().accepted(
        "OB 80 first, then the running OB, then the requested run", "TINT-15"
    )
    a.copy().late("OB 80 is owed within the latency", "TINT-14")
    a.copy().runs(80, flt_id=2).wait(300).end().late("the due run is not lost", "TINT-14")
    a.copy().runs(80, flt_id=2, ms=1).start().rejected(
        "the requested run waits for the end of the running one", "TINT-15"
    )
    a.copy().start(80, flt_id=5).rejected("the fault of an overlap is 02", "OBS-30")
    a.copy().stop(0x4568).rejected("OB 80 is loaded: the overlap does not stop", "OBS-22")
    a.copy().runs(80, flt_id=2).wait(300).end().runs(ms=1).start().rejected("one overlap, one later run", "TINT-14")


@situation("OBS-22")
def tint_overlap_no80(v: Variant) -> None:
    a = v.log([1, v.ob]).armed(v.point, 0x201).until(v.point).start().until(v.point + MINUTE)
    a.copy().wait(v.latency).stop(0x4568).accepted("without OB 80 the CPU stops")
    a.copy().late("without OB 80 the CPU stops within the latency")
    a.copy().stop(0x456D).rejected("the cause is 4568, not 456D", "OBS-21")
    a.copy().end().runs().accepted("the end in the very millisecond of the point may come first", "TINT-14")
    a.copy().stop().accepted("a stop by the switch may come at any time", "OBS-47")


@situation("AMB-19")
def tint_overlap_many(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start()
    for k in (1, 2, 3):
        a.until(v.point + k * MINUTE).runs(80, flt_id=2, ms=1)
    a.wait(100).end()
    a.copy().runs(ms=1).tick().accepted("three overlaps, three OB 80, one extra run")
    a.copy().runs(ms=0).start().rejected("at most one extra run is kept")
    (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point)
        .start()
        .until(v.point + MINUTE)
        .runs(80, flt_id=2, ms=1)
        .until(v.point + 2 * MINUTE)
        .late("every overlap calls OB 80")
    )


@situation("TINT-16")
def tint_missing(v: Variant) -> None:
    a = v.log([1, v.other, 35, 80, 85]).armed(v.point, 0x201).until(v.point)
    a.copy().runs(85, flt_id=[0xA1, 0xA2][v.number % 2]).tick().accepted("OB 85 for the missing OB", "OBS-20")
    a.copy().start(85, flt_id=0xA3).rejected("A3 is not the fault of a missing OB", "AMB-28")
    a.copy().start().rejected("the OB is not loaded")
    a.copy().late("OB 85 is owed")
    a.copy().start(80).rejected("OB 85, not OB 80", "OBS-24")
    a.copy().stop(0x456D).rejected("OB 85 is loaded", "OBS-21")
    a.copy().runs(85, flt_id=0xA1).until(v.point + MINUTE).runs(85).accepted(
        "a periodic one stays active: OB 85 each period", "AMB-46"
    )
    a.copy().runs(85, flt_id=0xA1).until(v.point + MINUTE).late(
        "a periodic one stays active: OB 85 each period", "AMB-46"
    )


@situation("OBS-21")
def tint_missing_no85(v: Variant) -> None:
    a = v.log([1, 80]).armed(v.point).until(v.point)
    a.copy().wait(v.latency).stop(0x456D).accepted("no OB 85: STOP")
    a.copy().late("no OB 85: STOP within the latency")
    a.copy().stop(0x4568).rejected("4568 belongs to time errors", "OBS-22")
    v.log([1, 80]).armed(v.point).can_tint().until(v.point, 99).tick().accepted(
        "cancelled before the call: nothing is missing", "TINT-50"
    )
    v.log([1, 80]).armed(v.point).until(v.point, -10).event("load", ob=v.ob).until(v.point).runs().accepted(
        "loaded in time: it runs", "TINT-02"
    )
    v.log([1, v.ob]).armed(v.point).until(v.point, -10).event("delete", ob=v.ob).until(v.point).start().rejected(
        "deleted before its call", "TINT-16"
    )


@situation("AMB-06")
def missing_at_activation(v: Variant) -> None:
    a = v.log([1, 80, 85]).set_tint().act_tint()
    a.copy().start(85).rejected("the default notices a missing OB at its call, not at ACT")
    b = v.log([1, 80, 85], readings={"AMB-06": "b"}).set_tint().act_tint(None)
    b.copy().runs(85).tick().accepted("AMB-06 b: at the activation attempt")
    b.copy().late("AMB-06 b: at the activation attempt")


@situation("AMB-44")
def missing_while_not_callable(v: Variant) -> None:
    a = v.log([1, 35, 80, 85]).armed(v.point).until(v.point, -5).interrupt(35).start(35).until(v.point)
    a.copy().wait(v.latency + 60).end(35).runs(85).accepted("OB 85 when it would be called, behind OB 35")
    a.copy().start(85).rejected("OB 35 runs: the missing OB could not be called yet")
    a.copy().wait(500).end(35).late("OB 85 is owed once the missing OB would be called")
    a.copy().wait(200).event("load", ob=v.ob).wait(2).end(35).runs().accepted("loaded while it waited: it is called")
    b = (
        v.log([1, 35, 80, 85], readings={"AMB-44": "a"})
        .armed(v.point)
        .until(v.point, -5)
        .interrupt(35)
        .start(35)
        .until(v.point)
    )
    b.copy().runs(85).tick().accepted("AMB-44 a: OB 85 when it is due")
    b.copy().late("AMB-44 a: OB 85 when it is due")


@situation("TINT-18")
def tint_monthly_days(v: Variant) -> None:
    y = v.begin.year
    for d, r in ((28, 0), (29, 0x8091), (30, 0x8091), (31, 0x8091)):
        s = f"{y}-01-{d:02}T06:00"
        v.log().set_tint(s, 0x1401, r).accepted("monthly is limited to days 1..28, else 8091")
    v.log().set_tint(f"{y}-01-29T06:00", 0x1401, 0).rejected("day 29 with monthly gives 8091", "AMB-05")
    v.log().set_tint(f"{y}-01-31T06:00", 0x1401, 0x8092).rejected("the code is 8091", "TINT-39")
    v.log().set_tint(f"{y}-01-28T06:00", 0x1401, 0x8091).rejected("day 28 is legal")
    v.log(readings={"AMB-05": "b"}).set_tint(f"{y}-01-31T06:00", 0x1401, 0).accepted("AMB-05 b allows day 31", "AMB-05")
    v.log().set_tint(f"{y}-01-31T06:00", 0x2001, 0).set_tint(f"{y}-01-31T06:00", 0x1801, 0).set_tint(
        f"{y}-01-31T06:00", 0x1201, 0
    ).accepted("only monthly is limited")


@situation("AMB-05", REMEMBERING[:1] + REPEATING)
def monthly_31(v: Variant) -> None:
    b = moment("2027-02-28T23:59:30.000")
    for rd, sd in (("b", "2027-01-31T00:00"), ("c", "2027-01-31T00:00")):
        a = v.log(begin=b, readings={"AMB-05": rd}).set_tint(sd, 0x1401).act_tint()
        a.copy().until(moment("2027-03-01T00:00")).wait(1).start().rejected("no monthly point on March 1")
        a.copy().until(moment("2027-03-31T00:00")).runs().accepted("the 31st of March is a point under b and c")
    a = (
        v.log(begin=moment("2027-02-27T23:59:30.000"), readings={"AMB-05": "c"})
        .set_tint("2027-01-31T00:00", 0x1401)
        .act_tint()
        .until(moment("2027-02-28T00:00"))
    )
    a.copy().runs().accepted("AMB-05 c: on the last day of a shorter month")
    a.copy().late("AMB-05 c: on the last day of a shorter month")
    a = (
        v.log(begin=moment("2027-02-27T23:59:30.000"), readings={"AMB-05": "b"})
        .set_tint("2027-01-31T00:00", 0x1401)
        .act_tint()
        .until(moment("2027-02-28T00:00"))
    )
    a.copy().start().rejected("AMB-05 b: only in months that have the day")
    a.wait(500).tick().accepted("AMB-05 b: February has no 31st")


EOM = [
    ("2027-02-27T23:59:30", "2027-02-28T00:00", "2027-02-14T00:00"),
    ("2028-02-28T23:59:30", "2028-02-29T00:00", "2028-01-31T00:00"),
    ("2026-04-30T11:59:30", "2026-04-30T12:00", "2026-04-15T12:00"),
    ("2000-02-28T23:59:30", "2000-02-29T00:00", "1999-12-31T00:00"),
]


@situation("TINT-19")
def end_of_month(v: Variant) -> None:
    b, p, s = EOM[v.number]
    a = v.log(begin=moment(b)).set_tint(s, 0x2001).act_tint()
    a.copy().until(moment(p)).runs(period=0x2001).accepted(
        "one start on the last day of the month at SDT's time of day"
    )
    a.copy().until(moment(p)).late("the last day of the month is a point")
    a.copy().until(moment(p), -1).start().rejected("not before the time of day of SDT")
    a.copy().until(moment(p)).runs().until(moment(p) + DAY).wait(1).start().rejected("the day after is no month end")


@situation("TINT-19")
def not_end_of_month(v: Variant) -> None:
    b, p, s = [
        ("2028-02-27T23:59:30", "2028-02-28T00:00", "2028-02-14T00:00"),
        ("2026-03-29T23:59:30", "2026-03-30T00:00", "2026-01-31T00:00"),
        ("2088-02-27T23:59:30", "2088-02-28T00:00", "2088-01-28T00:00"),
        ("2026-04-29T23:59:30", "2026-04-30T00:00", "2026-04-01T00:00"),
    ][v.number]
    a = v.log(begin=moment(b)).set_tint(s, 0x2001).act_tint().until(moment(p)).wait(1)
    if v.number == 3:
        v.log(begin=moment(b)).set_tint(s, 0x2001).act_tint().until(moment(p)).runs().accepted(
            "April 30 is the month end"
        )
    else:
        a.copy().start().rejected("not the last day of this month")
        a.wait(200).tick().accepted("not the last day of this month")


@situation("AMB-39")
def eom_sdt_no_month_end(v: Variant) -> None:
    b = moment("2026-11-10T05:59:30")
    s = "2026-11-10T06:00"
    a = v.log(begin=b).set_tint(s, 0x2001).act_tint().until(moment(s))
    a.copy().wait(300).tick().accepted("only the time of day counts: no run on the 10th")
    a.copy().start().rejected("the 10th is no month end")
    c = v.log(begin=b, readings={"AMB-39": "b"}).set_tint(s, 0x2001).act_tint().until(moment(s))
    c.copy().runs().accepted("AMB-39 b: first run at SDT itself")
    c.copy().late("AMB-39 b: first run at SDT itself")
    v.log(begin=b, readings={"AMB-39": "c"}).set_tint(s, 0x2001, 0x8091).accepted("AMB-39 c: 8091")
    v.log(begin=b).set_tint(s, 0x2001, 0x8091).rejected("AMB-39 c is not the default")
    v.log(begin=b, readings={"AMB-39": "c"}).set_tint(s, 0x2001, 0).rejected("AMB-39 c: 8091")


@situation("AMB-38")
def yearly_feb29(v: Variant) -> None:
    b, p, pt = [
        ("2029-02-28T05:59:30", "2029-02-28T06:00", 0),
        ("2029-03-01T05:59:30", "2029-03-01T06:00", 0),
        ("2032-02-29T05:59:30", "2032-02-29T06:00", 1),
        ("2088-02-29T05:59:30", "2088-02-29T06:00", 1),
    ][v.number]
    a = v.log(begin=moment(b)).set_tint("2028-02-29T06:00", 0x1801).act_tint().until(moment(p))
    if pt:
        a.copy().runs().accepted("yearly on Feb 29 runs in leap years")
        a.late("a leap year has the point")
    else:
        a.copy().wait(500).tick().accepted("no run in a common year")
        a.wait(1).start().rejected("no run in a common year")
    v.log(readings={"AMB-38": "b"}).set_tint("2028-02-29T06:00", 0x1801, 0x8091).accepted("AMB-38 b")
    v.log().set_tint("2028-02-29T06:00", 0x1801, 0x8091).rejected("yearly on Feb 29 is accepted by default")


@situation("TINT-39")
def illegal_dates(v: Variant) -> None:
    good = ["2028-02-29T00:00", "2000-02-29T23:59", "2089-12-31T23:59:59.999", "1990-01-01T00:00"]
    bad = [
        "2027-02-29T00:00",
        "2026-02-30T06:00",
        "2090-01-01T00:00",
        "1989-12-31T23:59",
        "2026-04-31T12:00",
        "2026-13-01T00:00",
        "2026-00-10T00:00",
        "2026-01-00T00:00",
        "2026-01-01T24:00",
        "2026-01-01T23:60",
        "2026-01-32T10:00",
    ]
    for s in good[v.number : v.number + 2]:
        v.log().set_tint(s, 0x1001, 0).accepted("a date that a DT can hold")
    for s in bad[v.number * 3 : v.number * 3 + 3]:
        v.log().set_tint(s, 0x1001, 0x8091).accepted("an illegal date or time gives 8091")
        v.log().set_tint(s, 0x1001, 0).rejected("an illegal date or time gives 8091")
    v.log().set_tint(good[v.number], 0x1001, 0x8091).rejected("a legal date")
    v.log().set_tint("DT#2026-02-30-06:00:00.000", 0, 0x8091).accepted("S7's spelling of the same")


@situation("AMB-79")
def seconds_60(v: Variant) -> None:
    s = iso(v.point)[:16] + f":{60 + 13 * v.number}"
    v.log().set_tint(s, 0, 0).act_tint().until(v.point).runs().accepted("ignored seconds may be ignored")
    v.log().set_tint(s, 0, 0x8091).act_tint(0x80A0).accepted("or make no valid DT")
    v.log().set_tint(s, 0, 0x8092).rejected("neither reading gives 8092")
    v.log(readings={"AMB-79": "b"}).set_tint(s, 0, 0).rejected("AMB-79 b: 8091")
    v.log(readings={"AMB-79": "a"}).set_tint(s, 0, 0x8091).rejected("AMB-79 a: 0000")


@situation("TINT-33")
def period_codes(v: Variant) -> None:
    good = [0, 0x201, 0x401, 0x1001, 0x1201, 0x1202, 0x1801, 0x2001]
    bad = [1, 0x200, 0x202, 0x402, 0x1002, 0x1203, 0x1402, 0x1802, 0x2002, 0x8000, -1, 0x2401]
    a = v.log()
    for p in good:
        a.set_tint(v.point, p)
    a.accepted("the codes of TINT-33")
    for p in bad[v.number * 3 : v.number * 3 + 3]:
        v.log().set_tint(per=p, ret=0x8092).accepted("any other code gives 8092")
        v.log().set_tint(per=p, ret=0).rejected("any other code gives 8092")
        v.log().set_tint(per=p, ret=0x8091).rejected("any other code gives 8092", "TINT-35")


@situation("AMB-01")
def weekly_codes(v: Variant) -> None:
    p = v.point
    for code in (0x1201, 0x1202):
        a = v.log().set_tint(p - 14 * DAY, code).act_tint().until(p)
        a.copy().runs(period=0x1201).accepted("both weekly codes; PERIOD_EXE may be either")
        a.copy().runs(period=0x1202).accepted("both weekly codes; PERIOD_EXE may be either")
        a.copy().late("a week later is a point")
        v.log().set_tint(p - 13 * DAY, code).act_tint().until(p).wait(1).start().rejected(
            "13 days later is no weekly point", "TINT-32"
        )
    v.log(readings={"AMB-01": "a"}).set_tint(p, 0x1202, 0x8092).set_tint(p, 0x1201, 0).accepted("AMB-01 a")
    v.log(readings={"AMB-01": "b"}).set_tint(p, 0x1201, 0x8092).set_tint(p, 0x1202, 0).accepted("AMB-01 b")
    v.log(readings={"AMB-01": "a"}).set_tint(p, 0x1202, 0).rejected("AMB-01 a")
    v.log().set_tint(p, 0x1202, 0x8092).rejected("both codes are weekly by default")


@situation("TINT-34")
def hourly(v: Variant) -> None:
    a = v.log().set_tint(v.point - HOUR, 0x401).act_tint().until(v.point)
    a.copy().runs().accepted("0401 is hourly")
    a.copy().late("0401 is hourly")
    b = v.log(readings={"AMB-43": "b"}).set_tint(v.point - HOUR, 0x401).act_tint().until(v.point)
    b.copy().wait(v.latency + 9).tick().accepted("AMB-43 b: daily", "AMB-43")
    b.copy().start().rejected("AMB-43 b: daily", "AMB-43")


@situation("TINT-36")
def set_past_once(v: Variant) -> None:
    s = v.point - [MINUTE, HOUR, DAY, 36 * HOUR][v.number]
    v.log().set_tint(s, 0, 0x80A1).act_tint(0x80A0).accepted("once in the past: 80A1, nothing set")
    v.log().set_tint(s, 0, 0).rejected("once in the past: 80A1")
    v.log().set_tint(s, 0, 0x80A0).rejected("the code is 80A1")
    v.log().set_tint(v.point, 0, 0x80A1).rejected("the point lies ahead")
    a = v.log().armed(v.point).set_tint(s, 0, 0x80A1)
    a.copy().until(v.point).runs().accepted("a SET that fails changes nothing", "AMB-20")
    a.copy().until(v.point).late("a SET that fails changes nothing", "AMB-20")
    b = v.log(readings={"AMB-20": "b"}).armed(v.point).set_tint(s, 0, 0x80A1)
    b.copy().act_tint(0x80A0).until(v.point, 200).tick().accepted("AMB-20 b: it cancels", "AMB-20")
    b.copy().until(v.point).start().rejected("AMB-20 b: it cancels", "AMB-20")


@situation("AMB-20")
def failed_set_keeps(v: Variant) -> None:
    for s, p, r in (
        (v.point, 0x202, 0x8092),
        ("2026-02-30T00:00", 0, 0x8091),
        (f"{v.begin.year}-01-30T00:00", 0x1401, 0x8091),
    )[v.number % 3 :]:
        a = v.log().armed(v.point, 0x201).set_tint(s, p, r).qry_tint(0x14)
        a.copy().until(v.point).runs().accepted("no state change on an error")
        a.copy().until(v.point).late("no state change on an error")
        v.log().armed(v.point, 0x201).set_tint(s, p, r).act_tint(0).can_tint(0).can_tint(0x80A0).accepted(
            "it was still set"
        )


@situation("TINT-31")
def set_cancels(v: Variant) -> None:
    a = v.log().armed(v.point).set_tint(v.point + MINUTE)
    a.copy().until(v.point).start().rejected("SET cancelled the active one")
    a.copy().until(v.point, 300).tick().act_tint().until(v.point + MINUTE).runs().accepted("only after a new ACT")
    a.copy().qry_tint(0x10).accepted("set again, not active", "TINT-74")
    a.copy().qry_tint(0x14).rejected("set again, not active", "TINT-74")
    a.copy().until(v.point + MINUTE).start().rejected("set again but not activated")


@situation("TINT-50")
def can(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).can_tint()
    a.copy().act_tint(0x80A0).can_tint(0x80A0).armed(v.point).until(v.point).runs().accepted(
        "cleared: SET must come before ACT"
    )
    a.copy().act_tint(0).rejected("date and time are cleared")
    a.copy().until(v.point).start().rejected("cancelled")
    a.copy().can_tint(0).rejected("nothing to cancel any more", "TINT-51")
    v.log().can_tint(0x80A0).accepted("nothing defined", "TINT-51")
    v.log().can_tint(0).rejected("nothing defined", "TINT-51")
    v.log().act_tint(0).rejected("nothing set", "TINT-61")
    v.log().act_tint(0x80A1).rejected("nothing set: 80A0", "TINT-61")
    v.log().set_tint().can_tint(0).act_tint(0x80A0).accepted("works on a set-but-inactive one", "TINT-52")
    v.log().set_tint().can_tint(0x80A0).rejected("works on a set-but-inactive one", "AMB-09")
    v.log(readings={"AMB-09": "b"}).set_tint().can_tint(0x80A0).act_tint(0).can_tint(0).accepted(
        "AMB-09 b: only activated ones", "AMB-09"
    )
    v.log(readings={"AMB-09": "b"}).set_tint().can_tint(0).rejected("AMB-09 b", "AMB-09")


@situation("TINT-53")
def can_running(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start().wait(1).can_tint(0)
    a.copy().wait(20).end().until(v.point + MINUTE, 300).tick().accepted(
        "CAN does not stop the running OB, the series is gone"
    )
    a.copy().wait(1).end().until(v.point + MINUTE).start().rejected("cancelled series")
    a.copy().end().end().rejected("an OB ends once", "OBS-01")
    b = v.log().armed(v.point).until(v.point).start()
    b.copy().can_tint(0).end().accepted("a once may be cancelled at OB start or OB end", "AMB-71")
    b.copy().can_tint(0x80A0).end().accepted("a once may be cancelled at OB start or OB end", "AMB-71")
    b.copy().qry_tint(0x14).can_tint(0x80A0).rejected("bit 2 = 1 says it is still active: CAN finds it", "AMB-71")
    b.copy().qry_tint(0x10).can_tint(0).rejected("bit 2 = 0 says it is cancelled", "AMB-71")
    b.copy().qry_tint(0x10).can_tint(0x80A0).end().accepted("consistent: cancelled at start", "AMB-71")


@situation("TINT-61")
def act_past(v: Variant) -> None:
    a = v.log().set_tint(v.point).until(v.point, 1)
    a.copy().act_tint(0x80A1).accepted("once, passed between SET and ACT")
    a.copy().act_tint(0).rejected("once, passed between SET and ACT")
    a.copy().act_tint(0x80A0).rejected("it is set: 80A1")
    a.copy().act_tint(0x80A1).can_tint(0).accepted("it stays set")
    b = v.log().set_tint(v.point, 0x201).until(v.point, 1).act_tint(0)
    b.copy().until(v.point + MINUTE).runs().accepted("periodic: next point", "TINT-62")
    b.copy().wait(1).start().rejected("periodic: no call for the past", "TINT-10")
    v.log().set_tint(v.point).until(v.point).act_tint(0).runs().accepted("exactly at the point", "AMB-37")
    v.log().set_tint(v.point).until(v.point).act_tint(0x80A1).rejected("exactly at the point is not past", "AMB-37")


@situation("TINT-63")
def act_twice(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).act_tint(0).until(v.point).runs()
    a.accepted("a second ACT has no effect")
    v.log().armed(v.point).act_tint(0x80A1).rejected("no code fits")
    v.log().armed(v.point).act_tint(0x80A0).rejected("no code fits")
    a.copy().start().rejected("the second ACT gives no second run")


@situation("TINT-65")
def rearm_inside(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point).start().set_tint(v.point + MINUTE).act_tint(0).wait(3).end()
    a.copy().until(v.point + MINUTE).runs().accepted("SET and ACT of the own OB from inside")
    a.copy().until(v.point + MINUTE).late("the new SET is not undone at the OB's end", "AMB-71")
    a.copy().can_tint(0).accepted("the new setting is there")
    a.copy().can_tint(0x80A0).rejected("the new setting is there", "AMB-71")


@situation("TINT-07")
def none(v: Variant) -> None:
    a = v.log(
        step7={"tod": {str(v.ob): {"execution": "none", "start": iso(v.point)[:16], "active": bool(v.number % 2)}}}
    )
    a.copy().until(v.point, 99).tick().accepted("execution none never runs")
    a.copy().until(v.point).start().rejected("execution none never runs")
    a.copy().act_tint(0x80A0).can_tint(0x80A0).accepted("nothing is set", "AMB-62")
    a.copy().act_tint(0).rejected("nothing is set", "AMB-62")
    a.copy().armed(v.point).until(v.point).runs().accepted("SFC 28 may re-parameterise it")


@situation("TINT-06")
def step7_routes(v: Variant) -> None:
    a = v.log(
        step7={
            "tod": {
                str(v.ob): {"execution": "hourly", "start": iso(v.point - 2 * HOUR)[:16], "active": True},
                str(v.other): {"execution": "once", "start": iso(v.point + MINUTE)[:16], "active": False},
            }
        }
    )
    a.copy().until(v.point).runs().accepted("STEP 7 sets and activates")
    a.copy().until(v.point).late("STEP 7 sets and activates")
    a.copy().act_tint(0, v.other).until(v.point).runs().until(v.point + MINUTE).runs(v.other).accepted(
        "STEP 7 sets, SFC 30 activates", "TINT-04"
    )
    a.copy().until(v.point).runs().until(v.point + MINUTE).start(v.other).rejected(
        "STEP 7 set it without activating", "TINT-02"
    )
    a.copy().can_tint(0).act_tint(0x80A0).until(v.point, 99).tick().accepted(
        "CAN clears a STEP 7 setting too", "TINT-50"
    )
    a.copy().qry_tint(0x14).qry_tint(0x10, v.other).accepted("bit 2 of both", "TINT-74")
    a.copy().qry_tint(0x10).rejected("STEP 7 activated it", "TINT-74")


@situation("TINT-38")
def step7_override(v: Variant) -> None:
    a = v.log(
        step7={"tod": {str(v.ob): {"execution": "minute", "start": iso(v.point - 9 * MINUTE)[:16], "active": True}}}
    ).set_tint(v.point + MINUTE)
    a.copy().until(v.point).start().rejected("SET overrides the STEP 7 configuration")
    b = a.copy().until(v.point, -15000).stop().wait(100).restart().wait(5).run()
    b.copy().until(v.point).runs().accepted("after the warm restart the STEP 7 parameters apply again", "OBS-50")
    b.copy().until(v.point).late("after the warm restart the STEP 7 parameters apply again", "OBS-50")
    c = v.log().armed(v.point).wait(100).stop().wait(100).restart(["warm", "cold"][v.number % 2]).wait(5).run()
    c.copy().until(v.point, 50).tick().accepted("settings by SFC are erased", "OBS-50")
    c.copy().until(v.point).start().rejected("settings by SFC are erased", "OBS-50")
    c.copy().act_tint(0).rejected("settings by SFC are erased", "OBS-50")


@situation("TINT-70")
def qry_bits(v: Variant) -> None:
    a = v.log().armed(v.point)
    a.copy().qry_tint(0x14).until(v.point).runs().accepted("active and loaded")
    for bit, r in (
        (0, "TINT-72"),
        (1, "TINT-73"),
        (3, "TINT-75"),
        (5, "AMB-04"),
        (7, "TINT-79"),
        (8 + v.number, "TINT-79"),
        (15, "TINT-79"),
    ):
        a.copy().qry_tint(0x14 ^ (1 << bit)).rejected(f"bit {bit} has to be 0 here", r)
    a.copy().qry_tint(0x10).rejected("active", "TINT-74")
    a.copy().qry_tint(0x04).rejected("loaded", "TINT-76")
    v.log([1, 35]).armed().qry_tint(4).accepted("not loaded", "TINT-76")
    v.log([1, 35]).armed().qry_tint(0x14).rejected("not loaded", "TINT-76")
    v.log(readings={"AMB-04": "b"}).armed().qry_tint(0x34).accepted("AMB-04 b: idle value 1", "AMB-04")
    v.log(readings={"AMB-04": "b"}).armed().qry_tint(0x14).rejected("AMB-04 b: idle value 1", "AMB-04")
    v.log(mode="STARTUP").armed().qry_tint(0x15).accepted("bit 0 = 1 in STARTUP", "TINT-72")
    v.log(mode="STARTUP").armed().qry_tint(0x14).rejected("bit 0 = 1 in STARTUP", "TINT-72")
    v.log().armed().dis_irt(2, v.ob).qry_tint(0x16).dis_irt(0x82, v.ob).qry_tint(0x16).en_irt(2, v.ob).qry_tint(
        0x14
    ).accepted("bit 1 by DIS_IRT", "IRT-17")
    v.log().dis_airt(1).armed().qry_tint(0x16).rejected("DIS_AIRT does not show in bit 1", "AIRT-13")
    v.log().event("QRY_TINT", ob=8, ret=0x8090).accepted("no STATUS where RET_VAL is not 0", "TINT-71")
    v.log().qry_tint(0xFFFF, 9, 0x8090).accepted("STATUS is not to be evaluated where RET_VAL is not 0", "TINT-71")


@situation("AMB-34")
def qry_pending_running(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point, -5).interrupt(35).start(35).until(v.point, 5)
    a.copy().qry_tint(0x14).qry_tint(0x10).wait(1).end(35).runs().accepted(
        "once and pending: bit 2 either, at each occasion anew"
    )
    a.copy().can_tint(0).end(35).wait(100).tick().accepted("CAN withdraws a pending one", "AMB-11")
    a.copy().can_tint(0).end(35).start().rejected("CAN withdraws a pending one", "AMB-11")
    a.copy().can_tint(0x80A0).rejected("a pending one can be cancelled", "AMB-34")
    b = v.log().armed(v.point, 0x201).until(v.point, -5).interrupt(35).start(35).until(v.point, 5)
    b.copy().qry_tint(0x14).accepted("periodic stays active")
    b.copy().qry_tint(0x10).rejected("periodic stays active")
    v.log().armed(v.point, 0x201).until(v.point).start().qry_tint(0x10).rejected("periodic stays active while running")
    v.log(readings={"AMB-34": "b"}).armed(v.point).until(v.point, -5).interrupt(35).start(35).until(
        v.point, 5
    ).qry_tint(0x14).rejected("AMB-34 b: 0 from the request on")
    v.log(readings={"AMB-34": "a"}).armed(v.point).until(v.point, -5).interrupt(35).start(35).until(
        v.point, 5
    ).qry_tint(0x10).rejected("AMB-34 a: 1 until OB start")


@situation("AMB-11")
def set_pending(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point, -5)
        .interrupt(35)
        .start(35)
        .until(v.point, 5)
        .set_tint(v.point + 5 * MINUTE, 0x201)
    )
    a.copy().end(35).wait(60).tick().accepted("SET withdraws a pending TOD run")
    a.copy().end(35).start().rejected("SET withdraws a pending TOD run")
    b = (
        v.log(readings={"AMB-11": "a"})
        .armed(v.point, 0x201)
        .until(v.point, -5)
        .interrupt(35)
        .start(35)
        .until(v.point, 5)
        .can_tint(None)
    )
    b.copy().end(35).runs().accepted("AMB-11 a: the pending run stays")
    b.copy().end(35).late("AMB-11 a: the pending run stays")
    c = v.log().armed(v.point).until(v.point, -5).interrupt(35).start(35).until(v.point, 5).set_tint(v.point, 0, 0x80A1)
    c.copy().end(35).runs().accepted("a SET that fails withdraws nothing")
    c.copy().end(35).late("a SET that fails withdraws nothing")


@situation("AMB-60")
def act_pending_once(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point, -5).interrupt(35).start(35).until(v.point, 5)
    a.copy().act_tint(0).end(35).runs().accepted("ACT of a pending once: 0000")
    a.copy().act_tint(0x80A1).end(35).runs().accepted("or 80A1")
    a.copy().act_tint(0x80A0).rejected("never 80A0: it is set")
    a.copy().act_tint(0).end(35).runs(ms=1).start().rejected("no second run")


@situation("AMB-18")
def overlap_pending(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point, -5).interrupt(35).start(35).until(v.point + MINUTE)
    a.copy().runs(80, flt_id=2).wait(50).end(35).runs().tick().accepted("02 while only pending")
    a.copy().wait(50).end(35).runs().wait(50).tick().accepted("merged")
    a.copy().wait(50).end(35).runs().runs().tick().accepted("buffered")
    a.copy().wait(50).end(35).runs(ms=1).runs(ms=1).start().rejected("two points, at most two runs")
    a.copy().start(80, flt_id=5).rejected("no clock change: not 05", "CLK-18")
    a.copy().wait(v.latency + 1).end(35).late("at least one run is owed", "CLK-18")
    v.log(readings={"AMB-18": "a"}).armed(v.point, 0x201).until(v.point, -5).interrupt(35).start(35).until(
        v.point + MINUTE
    ).late("AMB-18 a: 02 is owed")


@situation("TINT-09", [VARIANTS[0], VARIANTS[1], VARIANTS[3]])
def next_from_clock(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201)
    for k in range(5):
        a.until(v.point + k * MINUTE, min(k, v.latency)).runs(
            period=0x201, priority=2, strt_info=0x11 + v.ob - 10, time=iso(v.point + k * MINUTE)
        )
    a.copy().accepted("a minute series, late by less than the latency each time")
    a.copy().until(v.point + 5 * MINUTE, -1).start().rejected(
        "the next start point comes from the clock and the period"
    )
    a.copy().until(v.point + 5 * MINUTE).late("the series goes on")


@situation("AMB-36")
def first_run_literal(v: Variant) -> None:
    a = v.log(readings={"AMB-36": "b"}).armed(v.point, 0x201)
    a.copy().until(v.point).wait(1).start().rejected("AMB-36 b: first run one period after SDT")
    a.copy().until(v.point, 99).tick().until(v.point + MINUTE).runs().accepted("AMB-36 b")
    a.copy().until(v.point + MINUTE).late("AMB-36 b")
    b = v.log(profile="2006").armed(v.point, 0x201)
    b.copy().until(v.point).wait(1).start().rejected("edition 2006 prints reading b")
    b.copy().until(v.point + MINUTE).runs().accepted("edition 2006 prints reading b")
    v.log(profile="1997").armed(v.point, 0x201).until(v.point).runs().accepted("edition 1997 does not", "TINT-24")


@situation("AMB-61")
def deselected(v: Variant) -> None:
    a = v.log([1, v.other, 35, 80, 85], step7={"tod": {str(v.ob): {"deselected": True}}})
    a.copy().set_tint(ret=0x8090).act_tint(0x8090).accepted("8090 for a deselected OB")
    a.copy().set_tint(ret=0).act_tint(0).until(v.point, 50).tick().accepted("or the ordinary codes, but it never runs")
    a.copy().set_tint(ret=0).act_tint(0).until(v.point).start().rejected("it is not loaded and deselected")
    a.copy().set_tint(ret=0x8091).rejected("neither reading gives 8091 for a legal date")
    a.copy().can_tint(0).rejected("nothing set")


@situation("AMB-63")
def several_wrong(v: Variant) -> None:
    for r in (0x8090, 0x8091, 0x8092):
        v.log().set_tint("2026-02-30T00:00", 0x202, r, ob=[9, 18, 99, 0][v.number]).accepted("any code that applies")
    v.log().set_tint("2026-02-30T00:00", 0x202, 0x80A1, ob=9).rejected(
        "80A1 does not apply to a date that does not exist"
    )
    v.log().set_tint(v.point - DAY, 0x202, 0x8090).rejected("the OB number is good")
    v.log(readings={"AMB-63": "a"}).set_tint("2026-02-30T00:00", 0x202, 0x8092, ob=9).rejected("AMB-63 a: OB_NR first")
    v.log(readings={"AMB-63": "a"}).set_tint("2026-02-30T00:00", 0x202, 0x8091).accepted("AMB-63 a: SDT before PERIOD")
    v.log(readings={"AMB-63": "a"}).set_tint("2026-02-30T00:00", 0x202, 0x8092).rejected("AMB-63 a: SDT before PERIOD")


@situation("AMB-68")
def end_of_time(v: Variant) -> None:
    b = moment("2089-12-31T23:58:30.000")
    p = moment("2089-12-31T23:59:00.000")
    a = v.log(begin=b).armed(p, 0x401).until(p).runs()
    a.copy().qry_tint(0x14).accepted("no further point up to 2089: stays active")
    a.copy().qry_tint(0x10).accepted("or turns inactive")
    a.copy().wait(5000).start().rejected("no further point", "TINT-32")
    v.log(begin=b).set_tint("2090-01-01T00:00", 0x401, 0x8091).accepted("2090 lies outside DT", "TINT-39")
    v.log(begin=b).set_tint("2089-12-31T23:59:59.999", 0, 0).act_tint().until(p).runs().accepted("the last minute")
    v.log(begin=b, readings={"AMB-68": "b"}).armed(p, 0x401).until(p).runs().qry_tint(0x14).rejected(
        "AMB-68 b: inactive"
    )

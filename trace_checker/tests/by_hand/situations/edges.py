"""At the edge of a rule: what is just as old, equal to the clock, set by STEP 7 alone, lost, or comes twice."""

from typing import Any

from tests.by_hand.situations.builder import HOUR, MINUTE, Variant, bit, iso, moment, situation

E6 = [1, 10, 11, 12, 13, 17, 20, 21, 22, 23, 30, 35, 40, 55, 56, 57, 60, 70, 72, 80, 82, 83, 85, 100]


@situation("AMB-69")
def age_boundary(v: Variant) -> None:
    a = v.log(E6).interrupt(82).start(82).wait(3).interrupt(35).wait(2).interrupt(40)
    if v.latency:
        a.copy().wait(v.latency).end(82).start(35).accepted("the higher event is exactly as old as the latency")
    else:
        a.copy().end(82).start(35).rejected("latency 0: strict")
    a.copy().wait(v.latency + 1).end(82).start(35).rejected("the higher event is a millisecond older than the latency")
    a.copy().wait(v.latency + 1).end(82).wait(v.latency).runs(40).runs(35).accepted("each window runs anew", "FP-1")


@situation("OBS-02")
def order_of_lines(v: Variant) -> None:
    x, y = [(56, 55), (57, 55), (57, 56), (56, 55)][v.number]
    a = v.log(E6).interrupt(40).start(40).interrupt(x).interrupt(y).wait(v.latency + 2).end(40)
    a.copy().runs(x, ms=0).runs(y).accepted("events of one millisecond are in the order of their lines", "FP-2")
    a.copy().start(y).rejected("events of one millisecond are in the order of their lines", "FP-2")
    b = v.log(E6).interrupt(x).interrupt(y)
    b.copy().start(y).rejected("order of events also without a wait")
    b.runs(x).runs(y).accepted("order of events also without a wait")


@situation("CLK-06")
def skip_bits(v: Variant) -> None:
    a = v.log().armed(v.point).set_tint(v.point, 0x201, ob=v.other).clock(v.point + MINUTE)
    a.copy().runs(80, error_info=bit(v.ob)).runs().accepted("only active ones are late", "CLK-14")
    a.copy().start(80, error_info=bit(v.ob) | bit(v.other)).rejected("only active ones are late", "CLK-14")
    a.copy().runs(80).runs().start(v.other).rejected("only active ones are late", "CLK-14")
    b = v.log().armed(v.point).armed(v.point + MINUTE, ob=v.other).clock(v.point + MINUTE)
    b.copy().runs(80, error_info=bit(v.ob)).accepted("the other one is reached, not skipped", "AMB-37")
    b.copy().start(80, error_info=bit(v.ob) | bit(v.other)).rejected("the other one is reached, not skipped", "AMB-37")
    c = b.runs(80, error_info=bit(v.ob))
    c.copy().start(v.other).rejected("in order of start events: the skipped point is the earlier one", "TINT-12")
    c.copy().runs().late("the reached one is owed", "TINT-23")


@situation("TINT-25")
def step7_kinds(v: Variant) -> None:
    k, start, b, p = [
        ("end_of_month", "2026-01-10T06:00", "2026-02-28T05:59:30", "2026-02-28T06:00"),
        ("yearly", "2024-02-29T00:00", "2028-02-28T23:59:30", "2028-02-29T00:00"),
        ("weekly", "2026-11-01T08:00", "2026-11-22T07:59:30", "2026-11-22T08:00"),
        ("monthly", "2026-01-28T00:00", "2026-02-27T23:59:30", "2026-02-28T00:00"),
    ][v.number]

    def s(active: bool) -> dict[str, Any]:
        return {"tod": {str(v.ob): {"execution": k, "start": start, "active": active}}}

    a = v.log(begin=moment(b), step7=s(True)).until(moment(p))
    code = {"end_of_month": 0x2001, "yearly": 0x1801, "weekly": 0x1201, "monthly": 0x1401}[k]
    a.copy().runs(period=code).accepted(f"STEP 7 execution {k}")
    a.copy().late(f"STEP 7 execution {k}")
    a.copy().start(period=0x201).rejected(f"STEP 7 execution {k}", "TINT-33")
    c = v.log(begin=moment(b), step7=s(False)).until(moment(p))
    c.copy().start().rejected("not active", "TINT-02")
    c.wait(99).tick().accepted("not active", "TINT-02")
    v.log(begin=moment(b), step7=s(False)).act_tint(0).until(moment(p)).runs().accepted(
        "activated by SFC 30", "TINT-06"
    )


@situation("OBS-56")
def step7_once_future(v: Variant) -> None:
    s7 = {"tod": {str(v.ob): {"execution": "once", "start": iso(v.point)[:16], "active": True}}}
    a = v.log(step7=s7).until(v.point).runs()
    a.copy().act_tint(0x80A0).until(v.point + MINUTE).tick().accepted("used up as any once", "TINT-08")
    b = a.copy().wait(50).stop().wait(50).restart().wait(50).run()
    b.copy().runs().accepted("its start point is past now: once after the restart")
    b.copy().late("its start point is past now: once after the restart")
    c = v.log(step7=s7).can_tint(0).wait(50).stop().wait(50).restart().wait(50).run().until(v.point)
    c.copy().runs().accepted("CAN by SFC is erased by the restart", "OBS-50")
    c.late("CAN by SFC is erased by the restart", "OBS-50")
    past = {"tod": {str(v.ob): {"execution": "once", "start": iso(v.begin - 26 * HOUR)[:16], "active": True}}}
    d = v.log(step7=past)
    d.copy().wait(50).start().rejected("the log begins in RUN with nothing pending")
    d.wait(v.latency + 50).tick().accepted("the log begins in RUN with nothing pending")


@situation("TINT-07")
def none_after_restart(v: Variant) -> None:
    s7 = {"tod": {str(v.ob): {"execution": "none", "start": iso(v.point)[:16], "active": True}}}
    a = v.log(step7=s7).armed(v.point).wait(50).stop().wait(50).restart().wait(50).run()
    a.copy().until(v.point).start().rejected("none applies again after the restart", "TINT-38")
    a.copy().until(v.point, 99).act_tint(0x80A0).accepted("none applies again after the restart", "TINT-38")
    v.log(step7=s7, readings={"AMB-62": "b"}).act_tint(0).can_tint(0).accepted("AMB-62 b: STEP 7 gave a date", "AMB-62")
    v.log(step7=s7, readings={"AMB-62": "b"}).act_tint(0x80A0).rejected("AMB-62 b: STEP 7 gave a date", "AMB-62")


@situation("AIRT-01")
def delay_in_startup(v: Variant) -> None:
    a = v.log(E6, mode="STARTUP").dis_airt(1).interrupt(82).wait(v.latency + 5)
    a.copy().start(82).accepted("the startup OB may have ended unseen, and the count with it", "AIRT-04")
    a.copy().en_airt(0).runs(82, priority=28).run().accepted("released in STARTUP", "AIRT-08")


@situation("AMB-12")
def lost_series(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).dis_irt(0).until(v.point + 2 * MINUTE, 9).en_irt(0)
    a.copy().until(v.point + 3 * MINUTE).runs().accepted("three points lost, then the next", "IRT-18")
    a.copy().wait(1).start().rejected("nothing is caught up", "IRT-04")
    a.copy().until(v.point + 3 * MINUTE).late("three points lost, then the next", "IRT-18")
    b = v.log().armed(v.point, 0x201).until(v.point).start().dis_irt(1, 10).until(v.point + MINUTE, 5).en_irt(1, 10)
    b.copy().end().wait(99).tick().accepted("an overlap under DIS_IRT is lost", "IRT-04")
    b.copy().start(80).rejected("an overlap under DIS_IRT is lost: no time error", "IRT-01")
    b.end().start().rejected("an overlap under DIS_IRT is lost", "IRT-04")


@situation("AMB-48")
def hold_06_blocked(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).dis_irt(2, 80).hold().until(v.point, 5000).release()
    a.copy().start(80).rejected("OB 80 is blocked", "OBS-33")
    a.copy().wait(v.latency + 9).tick().until(v.point + MINUTE).runs().accepted(
        "no OB 80, no catch-up, the series goes on"
    )
    a.copy().runs().until(v.point + MINUTE).runs().accepted("or a catch-up")
    b = v.log([1, v.ob, 85]).armed(v.point).dis_irt(1, 80).hold().until(v.point, 5000).release()
    b.stop(0x4568).rejected("no STOP for a blocked time error", "AMB-23")


@situation("AMB-77")
def outside_twice_pending(v: Variant) -> None:
    a = v.log().interrupt(40).start(40).interrupt(35).wait(3).interrupt(35).wait(v.latency + 3)
    a.copy().end(40).runs(35).wait(v.latency + 9).tick().accepted("one run")
    a.copy().end(40).runs(35).runs(35).accepted("or two")
    a.copy().end(40).runs(35, ms=0).runs(35, ms=0).start(35).rejected("two events, two runs at most")
    a.copy().end(40).late("one run at least")


@situation("AMB-37")
def set_act_at_point(v: Variant) -> None:
    a = v.log(begin=v.point).set_tint(v.point, 0x201).act_tint(0)
    a.copy().runs(time=iso(v.point)).until(v.point + MINUTE).runs().accepted(
        "the point equal to the clock is served at once"
    )
    a.copy().runs(ms=0).start().rejected("once, not twice", "TINT-32")
    a.copy().late("the point equal to the clock is served at once")
    b = v.log(begin=v.point).set_tint(v.point - 5 * MINUTE, 0x201).act_tint(0)
    b.copy().runs().accepted("a point of the series equal to the clock is not past")
    b.copy().late("a point of the series equal to the clock is not past")
    c = v.log(readings={"AMB-37": "b"}, begin=v.point).set_tint(v.point, 0, 0x80A1)
    c.accepted("AMB-37 b: equal is past")
    v.log(readings={"AMB-37": "b"}, begin=v.point).set_tint(v.point, 0, 0).rejected("AMB-37 b: equal is past")


@situation("DINT-15")
def dint_cancel_then_start(v: Variant) -> None:
    a = v.log().srt_dint(300).wait(100).can_dint(0).srt_dint(300, 0x9).wait(299)
    a.copy().runs(v.delay_ob, sign=9).accepted("a new job after a cancelled one")
    a.copy().wait(1).late("a new job after a cancelled one")
    b = v.log().srt_dint(300).wait(100).can_dint(0).wait(200).srt_dint(300, 9)
    b.start(v.delay_ob).rejected("the old job is cancelled")
    (
        v.log()
        .srt_dint(300)
        .wait(300)
        .runs(v.delay_ob)
        .can_dint(0x80A0)
        .srt_dint(300)
        .can_dint(0)
        .can_dint(0x80A0)
        .accepted("finished, started, cancelled")
    )
    (
        v.log()
        .srt_dint(300)
        .wait(300)
        .start(v.delay_ob)
        .srt_dint(300)
        .can_dint(0)
        .wait(3)
        .end(v.delay_ob)
        .wait(400)
        .tick()
        .accepted("cancelled inside its own OB")
    )

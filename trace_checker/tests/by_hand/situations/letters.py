"""Letters of the readings that the defaults do not choose, written when the other situations had been settled."""

from tests.by_hand.situations.builder import (
    HOUR,
    MINUTE,
    MS,
    REMEMBERING,
    REPEATING,
    Log,
    Variant,
    bit,
    iso,
    moment,
    situation,
)
from tests.by_hand.situations.contract import WITH_ENTRIES


def behind_35(v: Variant, per: int, ms: int, **readings: str) -> Log:
    """OB 35 runs; the variant's time-of-day OB has waited behind it for ``ms``."""
    chosen = {name.replace("_", "-"): letter for name, letter in readings.items()}
    a = v.log(readings=chosen).armed(v.point, per)
    return a.until(v.point, -5).interrupt(35).start(35).until(v.point, ms)


@situation("AMB-03")
def letters_bit_0(v: Variant) -> None:
    step7 = {"tod": {str(v.ob): {"deselected": True}}}
    for letter in ("b", "c"):
        a = v.log([1, 35], step7=step7, readings={"AMB-03": letter, "AMB-61": "b"})
        a.copy().qry_tint(0x01).accepted("bit 0 is 1 for a deselected OB in RUN")
        a.copy().qry_tint(0x00).rejected("bit 0 is 1 for a deselected OB in RUN")
    for status in (0x00, 0x01):
        v.log([1, 35], step7=step7, readings={"AMB-61": "b"}).qry_tint(status).accepted("the bit is not judged there")
    v.log(readings={"AMB-03": "c"}).qry_tint(0x11).rejected("the OB is not deselected: released")


@situation("AMB-06")
def letters_missing_as_80(v: Variant) -> None:
    a = v.log([1, 80, 85], readings={"AMB-06": "c"}).armed(v.point).until(v.point)
    a.copy().runs(80).accepted("c: OB 80 for a missing OB")
    a.copy().start(85).rejected("c: OB 80 for a missing OB")
    a.copy().late("c: OB 80 is owed")


@situation("AMB-10", REMEMBERING)
def letters_act_again(v: Variant) -> None:
    chosen = {"AMB-10": "b", "AMB-57": "a"}
    a = v.log(readings=chosen).armed(v.point, 0x201).until(v.point).runs().wait(5000).clock(v.point - 5000 * MS)
    a.copy().act_tint(0).until(v.point).runs().accepted("b: ACT computes the next point anew")
    a.copy().act_tint(0).until(v.point).late("b: ACT computes the next point anew")
    c = v.log(readings={"AMB-10": "b"}).armed(v.point, 0x201).until(v.point).runs().wait(5000)
    c.clock(v.point - 5000 * MS).act_tint(0).until(v.point)
    c.copy().runs().accepted("b: whether the memory stays is open", "AMB-57")
    c.copy().wait(v.latency + 9).tick().accepted("b: whether the memory stays is open", "AMB-57")
    a.copy().until(v.point).start().rejected("without ACT the served point is not served again", "CLK-09")


@situation("AMB-11")
def letters_pending_delay(v: Variant) -> None:
    for letter in ("a", "c"):
        a = v.log(readings={"AMB-11": letter}).srt_dint(100).wait(90).interrupt(40).start(40).wait(100)
        a.copy().can_dint(0x80A0).end(40).runs(v.delay_ob).accepted("the waiting run stays")
        a.copy().can_dint(0).rejected("the job has elapsed")
        a.copy().srt_dint(300, 0x55).end(40).runs(v.delay_ob).wait(298).runs(v.delay_ob, sign=0x55).accepted(
            "both come"
        )
        a.copy().srt_dint(300, 0x55).end(40).late("the waiting run stays")
    b = v.log(readings={"AMB-11": "b"}).srt_dint(100).wait(90).interrupt(40).start(40).wait(100)
    b.copy().can_dint(0).end(40).wait(99).tick().accepted("b: withdrawn")
    b.copy().can_dint(0x80A0).rejected("b: it can be withdrawn")
    b.copy().can_dint(0).end(40).start(v.delay_ob).rejected("b: withdrawn")
    b.copy().srt_dint(300, 0x55).end(40).wait(299 if v.latency < 299 else 1).tick().accepted(
        "b: the new job replaces it"
    )


@situation("AMB-11")
def letters_pending_tod(v: Variant) -> None:
    for letter in ("b", "c", "d"):
        a = behind_35(v, 0x201, 5, AMB_11=letter).can_tint(0).end(35)
        a.copy().wait(99).tick().accepted("the waiting run is withdrawn")
        a.copy().start().rejected("the waiting run is withdrawn")
    a = behind_35(v, 0x201, 5, AMB_11="a").set_tint(v.point + 5 * MINUTE, 0x201)
    a.copy().end(35).runs().accepted("a: the waiting run stays, also when set anew")
    a.copy().end(35).late("a: the waiting run stays, also when set anew")


@situation("AMB-13")
def letters_class_28(v: Variant) -> None:
    for letter, overflow in (("a", 26), ("b", 28), ("c", 26), ("d", 28)):
        a = behind_35(v, 0x201, 60000, AMB_13=letter)
        a.copy().runs(80, flt_id=7, priority=overflow).accepted("class on buffer overflow")
        a.copy().start(80, flt_id=7, priority=54 - overflow).rejected("class on buffer overflow")
    a = v.log(mode="STARTUP", readings={"AMB-13": "a"}).interrupt(80, flt_id="W#16#0001")
    a.copy().runs(80, priority=28).accepted("a: 28 in STARTUP")
    a.copy().start(80, priority=26).rejected("a: 28 in STARTUP")


@situation("AMB-15")
def letters_act_manipulates(v: Variant) -> None:
    a = v.log(readings={"AMB-15": "b"}).armed(v.point, 0x201).clock(v.point + MINUTE + 5000 * MS).start(80)
    a.copy().act_tint(0).end(80).wait(99).tick().accepted("b: ACT alone is a manipulation, too")
    a.copy().act_tint(0).end(80).start().rejected("b: ACT alone is a manipulation, too")
    a.copy().dis_irt(2, v.ob).end(80).late("b: DIS_IRT is none")
    a.copy().act_tint(0x80A0, v.other).end(80).late("b: another OB")
    a.copy().act_tint(0).end(80).until(v.point + 2 * MINUTE).runs().accepted("the series goes on", "CLK-08")


@situation("AMB-16")
def letters_time_of_skip(v: Variant) -> None:
    a = v.log(readings={"AMB-16": "b"}).armed(v.point, 0x201).clock(v.point + MINUTE + 5000 * MS)
    a.copy().runs(80, time=iso(v.point)).runs(time=iso(v.point)).accepted("b: the first skipped point")
    a.copy().start(80, time=iso(a.clock_now)).rejected("b: the first skipped point")
    a.copy().start(80, time=iso(v.point + MINUTE)).rejected("b: the first skipped point")


@situation("AMB-18")
def letters_overlap_waiting(v: Variant) -> None:
    c = behind_35(v, 0x201, 60000, AMB_18="c")
    c.copy().end(35).runs().wait(60).tick().accepted("c: merged")
    c.copy().end(35).runs(ms=1).start().rejected("c: merged")
    c.copy().start(80, flt_id=2).rejected("c: merged, no time error")
    b = behind_35(v, 0x201, 60000, AMB_18="b")
    b.copy().end(35).runs().runs().accepted("b: buffered")
    b.copy().start(80, flt_id=2).rejected("b: buffered until the buffer is full")
    b.copy().runs(80, flt_id=7).accepted("b: or the buffer was full")
    a = behind_35(v, 0x201, 60000, AMB_18="a")
    a.copy().runs(80, flt_id=2).accepted("a: 02")
    a.copy().start(80, flt_id=7).rejected("a: 02, not 07")


@situation("AMB-19")
def letters_overlap_many(v: Variant) -> None:
    b = v.log(readings={"AMB-19": "b"}).armed(v.point, 0x201).until(v.point).start()
    for k in (1, 2):
        b.until(v.point + k * MINUTE).runs(80, flt_id=2)
    b.wait(9).end()
    b.copy().runs(ms=1).runs(ms=1).tick().accepted("b: each overlap has its later run")
    b.copy().runs(ms=1).late("b: each overlap has its later run")
    b.copy().runs(ms=1).runs(ms=1).start().rejected("b: two overlaps, two runs")
    c = v.log(readings={"AMB-19": "c"}).armed(v.point, 0x201).until(v.point).start()
    c.until(v.point + MINUTE).runs(80, flt_id=2).until(v.point + 2 * MINUTE)
    c.copy().wait(v.latency + 9).end().runs().tick().accepted("c: one OB 80, one later run")
    c.copy().start(80).rejected("c: one OB 80")


@situation("AMB-28")
def letters_a1_a2(v: Variant) -> None:
    for letter, right, wrong in (("a", 0xA1, 0xA2), ("b", 0xA2, 0xA1)):
        a = v.log([1, 80, 85], readings={"AMB-28": letter}).armed(v.point).until(v.point)
        a.copy().runs(85, flt_id=right).accepted("the letter's fault id")
        a.copy().start(85, flt_id=wrong).rejected("the letter's fault id")
        b = v.log([1, 80, 85], readings={"AMB-28": letter}).srt_dint(50).wait(50)
        b.copy().runs(85, flt_id=right).accepted("the letter's fault id")
        b.copy().start(85, flt_id=wrong).rejected("the letter's fault id")


@situation("AMB-31")
def letters_dtime(v: Variant) -> None:
    a = v.log(readings={"AMB-31": "a"}).srt_dint(1234).wait(1233)
    a.copy().runs(v.delay_ob, dtime=1233).accepted("a: the elapsed delay")
    a.copy().start(v.delay_ob, dtime=1200).rejected("a: the elapsed delay")
    v.log().srt_dint(1234).wait(1233).start(v.delay_ob, dtime=1233).rejected("the default: DTIME as configured")
    v.log().srt_dint(1234).wait(1233).runs(v.delay_ob, dtime=1234).accepted("the default: DTIME as configured")


@situation("AMB-32")
def letters_end_of_month(v: Variant) -> None:
    begin, point = moment("2026-03-31T05:59:30"), moment("2026-03-31T06:00")
    b = v.log(begin=begin, readings={"AMB-32": "b"}).set_tint("2026-02-28T06:00", 0x2001, None).act_tint(None)
    b.copy().until(point, v.latency + 9).tick().accepted("b: executed once, and that is past")
    b.copy().until(point).start().rejected("b: no series")
    a = v.log(begin=begin).set_tint("2026-02-28T06:00", 0x2001).act_tint().until(point)
    a.copy().runs().accepted("the default: periodic like the others")
    a.copy().late("the default: periodic like the others")


@situation("AMB-41")
def letters_5380(v: Variant) -> None:
    a = v.log(records=WITH_ENTRIES, readings={"AMB-41": "b"}).dis_irt(0x82, 40)
    a.copy().interrupt(40).diag(0x5380).accepted("b: for each blocked event")
    a.copy().diag(0x5380).rejected("b: nothing was blocked yet")
    a.copy().interrupt(40).late("b: for each blocked event")
    a.copy().interrupt(40).diag(0x5380).interrupt(40).diag(0x5380).accepted("b: for each blocked event")
    a.copy().interrupt(40).diag(0x5380).diag(0x5380).rejected("b: one event, one entry")


@situation("AMB-45")
def letters_several_missing(v: Variant) -> None:
    for letter in ("a", "b"):
        log = v.log([1, 80, 85], readings={"AMB-45": letter})
        a = log.armed(v.point).armed(v.point, 0, v.other).until(v.point).runs(85)
        if letter == "a":
            a.copy().start(85).rejected("a: one for all")
            a.copy().wait(v.latency + 9).tick().accepted("a: one for all")
        else:
            a.copy().runs(85).accepted("b: one each")
            a.copy().late("b: one each")


@situation("AMB-46")
def letters_source_ends(v: Variant) -> None:
    a = v.log([1, 80, 85], readings={"AMB-46": "b"}).armed(v.point, 0x201).until(v.point).runs(85)
    a.copy().until(v.point + MINUTE, v.latency + 9).tick().accepted("b: the source is disabled")
    a.copy().until(v.point + MINUTE).start(85).rejected("b: the source is disabled")
    a.copy().set_tint(v.point + MINUTE, 0x201).act_tint().until(v.point + MINUTE).runs(85).accepted(
        "b: until SET and ACT"
    )
    a.copy().set_tint(v.point + MINUTE, 0x201).act_tint().until(v.point + MINUTE).late("b: until SET and ACT")


@situation("AMB-53")
def letters_skip_in_startup(v: Variant) -> None:
    a = v.log(mode="STARTUP", readings={"AMB-53": "a"}).armed(v.point).clock(v.point + MINUTE)
    a.copy().start(80).rejected("a: no OB 80 in STARTUP")
    a.copy().wait(99).run().runs().accepted("a: a deferred run")
    a.copy().wait(99).run().late("a: a deferred run")
    b = v.log(mode="STARTUP", readings={"AMB-53": "b"}).armed(v.point).clock(v.point + MINUTE)
    b.copy().runs(80, flt_id=5, priority=28).run().runs().accepted("b: OB 80 in STARTUP, the catch-up in RUN")
    b.copy().runs(80, flt_id=5).run().late("b: the catch-up in RUN")
    c = v.log(readings={"AMB-53": "a"}).armed(v.point).hold().wait(5).clock(v.point + MINUTE).wait(5).release()
    c.copy().runs(80, flt_id=6, error_info=bit(v.ob)).accepted("a: part of fault 06")
    c.copy().start(80, flt_id=5).rejected("a: part of fault 06")
    d = v.log(readings={"AMB-53": "b"}).armed(v.point).hold().wait(5).clock(v.point + MINUTE).wait(5).release()
    d.copy().runs(80, flt_id=5, error_info=bit(v.ob)).runs().accepted("b: 05 after the release")
    d.copy().start(80, flt_id=6).rejected("b: 05 after the release")


@situation("AMB-54")
def letters_order_of_catch_ups(v: Variant) -> None:
    low, high = sorted((v.ob, v.other))
    b = v.log(readings={"AMB-54": "b"}).armed(v.point + MINUTE, 0, low).armed(v.point, 0, high)
    b.clock(v.point + 5 * MINUTE).runs(80)
    b.copy().runs(low).runs(high).accepted("b: ascending OB numbers")
    b.copy().start(high).rejected("b: ascending OB numbers")
    a = v.log(readings={"AMB-54": "a"}).armed(v.point + MINUTE, 0, low).armed(v.point, 0, high)
    a.clock(v.point + 5 * MINUTE).runs(80)
    a.copy().runs(high).runs(low).accepted("a: by first skipped point")
    a.copy().start(low).rejected("a: by first skipped point")


@situation("AMB-55")
def letters_after_hold(v: Variant) -> None:
    a = v.log(readings={"AMB-55": "a"}).armed(v.point, 0x201).hold().until(v.point, 5000).release().runs(80, flt_id=6)
    a.copy().runs().accepted("a: a catch-up")
    a.copy().late("a: a catch-up")
    b = v.log(readings={"AMB-55": "b"}).armed(v.point, 0x201).hold().until(v.point, 5000).release().runs(80, flt_id=6)
    b.copy().start().rejected("b: none")
    b.copy().wait(v.latency + 9).tick().until(v.point + MINUTE).runs().accepted("b: none, the series goes on")


@situation("AMB-59")
def letters_back_withdraws(v: Variant) -> None:
    b = behind_35(v, 0x201, 5, AMB_59="b").clock(v.point - 5000 * MS).wait(5).end(35)
    b.copy().start().rejected("b: the waiting request is withdrawn")
    b.copy().wait(v.latency + 9).tick().until(v.point).runs().accepted("b: its point comes again")
    if v.s7_300:
        b.copy().until(v.point).late("b: its point comes again", "CLK-10")


@situation("AMB-60")
def letters_act_pending(v: Variant) -> None:
    behind_35(v, 0, 5, AMB_60="a").act_tint(0).end(35).runs().accepted("a: 0000")
    behind_35(v, 0, 5, AMB_60="a").act_tint(0x80A1).rejected("a: 0000")
    behind_35(v, 0, 5, AMB_60="b").act_tint(0x80A1).end(35).runs().accepted("b: 80A1")
    behind_35(v, 0, 5, AMB_60="b").act_tint(0).rejected("b: 80A1")


@situation("AMB-61")
def letters_deselected(v: Variant) -> None:
    step7 = {"tod": {str(v.ob): {"deselected": True}}}
    a = v.log([1, 35, 80, 85], step7=step7, readings={"AMB-61": "a"})
    a.copy().set_tint(ret=0x8090).can_tint(0x8090).act_tint(0x8090).accepted("a: 8090")
    a.copy().set_tint(ret=0).rejected("a: 8090")
    a.copy().can_tint(0x80A0).rejected("a: 8090")
    b = v.log([1, 35, 80, 85], step7=step7, readings={"AMB-61": "b"})
    b.copy().set_tint().act_tint().until(v.point, v.latency + 9).tick().accepted("b: the ordinary codes, no run")
    b.copy().set_tint(ret=0x8090).rejected("b: the ordinary codes")
    b.copy().can_tint(0x80A0).accepted("b: the ordinary codes")


@situation("AMB-66")
def letters_delete_pending(v: Variant) -> None:
    b = behind_35(v, 0, 5, AMB_66="b").event("delete", ob=v.ob).wait(5).end(35)
    b.copy().wait(v.latency + 9).tick().accepted("b: its request vanishes")
    b.copy().start(85).rejected("b: its request vanishes")
    b.copy().event("load", ob=v.ob).start().rejected("b: its request vanishes")


@situation("AMB-67")
def letters_startup_events(v: Variant) -> None:
    a = v.log(mode="STARTUP", readings={"AMB-67": "a"}).interrupt(35).wait(50).run()
    a.copy().runs(35).accepted("a: kept until RUN")
    a.copy().late("a: kept until RUN")
    b = v.log(mode="STARTUP", readings={"AMB-67": "b"}).interrupt(35).wait(50).run()
    b.copy().start(35).rejected("b: lost")
    b.copy().wait(v.latency + 9).tick().accepted("b: lost")
    c = v.log(readings={"AMB-67": "a"}).hold().interrupt(35).wait(50).release()
    c.copy().runs(35).accepted("a: kept in HOLD")
    c.copy().late("a: kept in HOLD")
    d = v.log(readings={"AMB-67": "b"}).hold().interrupt(35).wait(50).release()
    d.copy().start(35).rejected("b: lost in HOLD")


@situation("AMB-70")
def letters_last_millisecond(v: Variant) -> None:
    b = v.log(readings={"AMB-70": "b", "AMB-11": "a"}).srt_dint(500).wait(499)
    b.copy().can_dint(0).rejected("b: elapsed, and the waiting run stays")
    b.copy().can_dint(0x80A0).runs(v.delay_ob).accepted("b: elapsed, and the waiting run stays")
    v.log(readings={"AMB-70": "b", "AMB-11": "a"}).srt_dint(500).wait(498).can_dint(0).accepted(
        "two milliseconds before"
    )


@situation("AMB-73")
def letters_lacking_classes(v: Variant) -> None:
    a = v.log(readings={"AMB-73": "b"})
    a.copy().dis_irt(2, 35, 0).dis_irt(1, 30, 0).accepted("b: every CPU has OB 35")
    if v.cpu == "S7-300":
        a.copy().dis_irt(2, 30, 0x8090).accepted("b: an S7-300 lacks OB 30 to 34")
        a.copy().dis_irt(2, 60, 0).rejected("b: an S7-300 lacks OB 60")
        a.copy().dis_irt(1, 70, 0).rejected("b: an S7-300 lacks the redundancy errors")
    v.log().dis_irt(2, 30, 0x8090).rejected("the default: 0000 whatever the CPU has")


@situation("AMB-77")
def letters_again_while_running(v: Variant) -> None:
    b = v.log(readings={"AMB-77": "b"}).interrupt(35).start(35).wait(3).interrupt(35)
    b.copy().wait(3).end(35).runs(35).accepted("b: buffered")
    b.copy().wait(3).end(35).late("b: buffered")
    b.copy().start(80, flt_id=2).rejected("b: buffered, no time error")
    c = v.log(readings={"AMB-77": "c"}).interrupt(35).start(35).wait(3).interrupt(35)
    c.copy().wait(3).end(35).wait(99).tick().accepted("c: lost")
    c.copy().wait(3).end(35).start(35).rejected("c: lost")
    c.copy().start(80, flt_id=2).rejected("c: lost, no time error")


@situation("AMB-17", REPEATING)
def letters_no_repeat(v: Variant) -> None:
    b = v.log(readings={"AMB-17": "b"}).armed(v.point, 0x201).until(v.point).runs().wait(5000)
    b.clock(v.point - 5000 * MS)
    b.copy().until(v.point).start().rejected("b: not served again")
    b.copy().until(v.point, 99).tick().until(v.point + MINUTE).runs().accepted("b: not served again")
    b.copy().clock(v.point + 10000 * MS).start(80).rejected("b: no skip over a served point", "AMB-58")


@situation("AMB-43")
def letters_daily(v: Variant) -> None:
    b = v.log(readings={"AMB-43": "b"}).armed(v.point, 0x401).until(v.point).runs(period=0x401)
    b.copy().clock(v.point + HOUR + 5000 * MS).start(80).rejected("b: no point after an hour")
    b.copy().clock(v.point + HOUR + 5000 * MS).wait(v.latency + 9).tick().accepted("b: no point after an hour")


@situation("AMB-42")
def letters_mode_1_blocks(v: Variant) -> None:
    b = v.log(readings={"AMB-42": "b"})
    b.copy().en_irt(1, 30).interrupt(35).start(35).rejected("b: MODE 1 blocks")
    b.copy().en_irt(1, 30).qry_tint(0x10).interrupt(40).runs(40).accepted("b: its class alone")
    b.copy().dis_irt(0).en_irt(2, 35).interrupt(35).runs(35).accepted("b: MODE 2 enables")
    b.copy().en_irt(1, 10).qry_tint(0x12).en_irt(0).qry_tint(0x10).accepted("b: MODE 0 enables")


@situation("AMB-13")
def letters_class_26_in_startup(v: Variant) -> None:
    for letter in ("b", "c"):
        a = v.log(mode="STARTUP", readings={"AMB-13": letter}).interrupt(80, flt_id="W#16#0001")
        a.copy().start(80, priority=28).rejected("no class 28 in STARTUP")
    v.log(mode="STARTUP").interrupt(80, flt_id="W#16#0001").runs(80, priority=28).accepted("the default: 28 in STARTUP")


@situation("AMB-52")
def letters_catch_up_of_its_own(v: Variant) -> None:
    a = v.log(readings={"AMB-52": "a"}).armed(v.point, 0x201).until(v.point).start().wait(100)
    a.clock(v.point + MINUTE + 5000 * MS).runs(80, flt_id=5).end()
    a.copy().runs().accepted("a: a catch-up of its own")
    a.copy().late("a: a catch-up of its own")


@situation("AMB-57", REMEMBERING)
def letters_memory_stays(v: Variant) -> None:
    for letter in ("a", "b"):
        a = v.log(readings={"AMB-57": letter}).armed(v.point, 0x201).until(v.point).runs().wait(5000)
        a.clock(v.point - 5000 * MS).set_tint(v.point, 0x201).act_tint().until(v.point)
        if letter == "a":
            a.copy().late("a: the memory is gone")
        else:
            a.copy().start().rejected("b: the memory stays")
            a.copy().until(v.point + MINUTE).late("b: the next point was never served")


@situation("AMB-68")
def letters_ended_series(v: Variant) -> None:
    begin = moment("2089-12-31T23:58:30.000")
    for letter, status in (("a", 0x14), ("b", 0x10)):
        a = v.log(begin=begin, readings={"AMB-68": letter}).armed("2089-12-31T23:59", 0x401).wait(30000).runs()
        a.copy().qry_tint(status).accepted("bit 2 of a series without a further point")
        a.copy().qry_tint(status ^ 4).rejected("bit 2 of a series without a further point")
        a.copy().state(v.ob, active=status == 0x14).accepted("bit 2 of a series without a further point")
        a.copy().state(v.ob, active=status != 0x14).rejected("bit 2 of a series without a further point")

"""Classes, missing OBs, OB 80 and OB 85, modes and restart."""

from tests.by_hand.situations.builder import (
    HOUR,
    MINUTE,
    MS,
    REMEMBERING,
    REPEATING,
    Variant,
    iso,
    situation,
    word,
)

EVERY_OB = [
    1,
    10,
    11,
    12,
    13,
    17,
    20,
    21,
    22,
    23,
    30,
    35,
    38,
    40,
    47,
    55,
    56,
    57,
    60,
    70,
    72,
    80,
    81,
    82,
    83,
    84,
    85,
    86,
    87,
    100,
]


@situation("OBS-01")
def higher_interrupts(v: Variant) -> None:
    lo, hi = [(35, 40), (30, 38), (55, 30), (40, 47)][v.number]
    a = v.log(EVERY_OB).interrupt(lo).start(lo).wait(5).interrupt(hi)
    a.copy().runs(hi).end(lo).accepted("strictly higher class interrupts")
    a.copy().late("strictly higher class interrupts")
    b = v.log(EVERY_OB).interrupt(hi).start(hi).wait(5).interrupt(lo).wait(v.latency)
    b.copy().start(lo).rejected("a lower class waits")
    b.copy().wait(70).end(hi).runs(lo).accepted("then resumes in order", "OBS-03")
    b.copy().wait(70).end(hi).late("owed when the higher one has ended", "OBS-03")
    a.copy().start(hi).end(lo).rejected("the topmost OB runs", "OBS-03")


@situation("OBS-02")
def same_class(v: Variant) -> None:
    x, y = [(55, 56), (56, 57), (57, 55), (55, 57)][v.number]
    a = v.log(EVERY_OB).interrupt(x).start(x).wait(5).interrupt(y).wait(v.latency)
    a.copy().start(y).rejected("same class: no interruption")
    a.copy().wait(30).end(x).runs(y).accepted("one after another")
    b = v.log(EVERY_OB).armed(v.point).until(v.point, -20).interrupt(x).start(x).until(v.point, v.latency)
    b.copy().start().rejected("OB 55-57 have class 2 like OB 1x", "OBS-04")
    b.copy().wait(30).end(x).runs().accepted("OB 55-57 have class 2 like OB 1x", "OBS-04")
    b.copy().wait(3).interrupt(y).wait(v.latency + 3).end(x).start(y).rejected("in order of their start events")
    b.copy().wait(3).interrupt(y).wait(v.latency + 3).end(x).runs().runs(y).accepted("in order of their start events")


@situation("OBS-05")
def priority_header(v: Variant) -> None:
    if v.s7_300:
        for o, p in (("20", 5), ("35", 12), ("10", 2))[v.number % 2 :]:
            v.log(priority={o: p}).unusable("S7-300: classes are fixed")
        v.log(priority={}).interrupt(35).runs(35).unusable("the field itself has no place there", line=1)
        return
    a = (
        v.log(priority={str(v.ob): 9, str(v.delay_ob): 4})
        .armed(v.point)
        .srt_dint(29000)
        .until(v.point, -1000)
        .start(v.delay_ob)
        .wait(1000)
    )
    a.copy().runs(priority=9).end(v.delay_ob).accepted("class 9 interrupts class 4")
    a.copy().late("class 9 interrupts class 4")
    a.copy().start(priority=2).rejected("its own class is 9", "OBS-04")
    for o, p in (
        ("10", 24),
        ("40", 24),
        ("1", 2),
        ("80", 26),
        ("80", 25),
        ("55", 3),
        ("60", 24),
        ("85", 23),
        ("87", 27),
        ("100", 2),
        ("20", 1),
        ("35", -1),
    ):
        v.log(priority={o: p}).unusable("class not settable")
    for o, p in (("10", 23), ("40", 2), ("82", 24), ("82", 2), ("85", 26), ("72", 28), ("70", 2)):
        v.log(EVERY_OB, priority={o: p}).interrupt(35).runs(35).accepted("settable")
    b = v.log(priority={"35": 20, "40": 20}).interrupt(35).start(35).wait(3).interrupt(40).wait(v.latency)
    b.copy().start(40).rejected("several OBs may share a class")
    b.wait(9).end(35).runs(40).accepted("several OBs may share a class")


@situation("OBS-06", REMEMBERING)
def priority_zero(v: Variant) -> None:
    a = v.log([1, v.other, 35, 80, 85], priority={str(v.ob): 0}).set_tint(ret=None).act_tint(None).until(v.point)
    a.copy().wait(v.latency + 20).tick().accepted("class 0 deselects")
    a.copy().start().rejected("class 0 deselects")
    b = v.log([1, v.ob, 35, 80, 85, 100], mode="STOP", priority={str(v.ob): 0}).wait(5).restart()
    b.copy().stop(0x454A).accepted("a deselected OB that is loaded aborts the startup", "OBS-25")
    b.copy().wait(v.latency + 1).run().rejected("a deselected OB that is loaded aborts the startup", "OBS-25")
    c = v.log(mode="STOP").wait(5).restart()
    c.stop(0x454A).rejected("nothing loaded is deselected", "OBS-25")


@situation("OBS-25", REPEATING)
def deselected_loaded(v: Variant) -> None:
    b = v.log(mode="STOP", step7={"tod": {str(v.ob): {"deselected": True}}}).wait(5).restart()
    b.copy().wait(v.latency).stop(0x454A).accepted("aborted startup")
    b.copy().wait(v.latency + 1).run().rejected("aborted startup")
    c = (
        v.log([1, v.other, 35, 80, 85, 100], mode="STOP", step7={"tod": {str(v.ob): {"deselected": True}}})
        .wait(5)
        .restart()
    )
    c.copy().wait(100).run().accepted("deselected and not loaded")
    c.stop(0x454A).rejected("deselected and not loaded")


@situation("OBS-11")
def error_classes(v: Variant) -> None:
    a = v.log(EVERY_OB).interrupt(82).start(82).wait(3).interrupt(80, flt_id=word(1)).wait(v.latency)
    if v.s7_300:
        a.copy().start(80).rejected("S7-300: OB 80 and OB 82 share class 26")
        a.copy().wait(2).end(82).runs(80, flt_id=1, priority=26).accepted("one after another")
    else:
        a.copy().runs(80, flt_id=1, priority=26).end(82).accepted("OB 80 (26) is above OB 81-87 (25)")
        a.copy().wait(1).tick().rejected("OB 80 interrupts OB 82")
    b = v.log(EVERY_OB).interrupt(60).start(60).wait(3).interrupt(82).wait(v.latency)
    if v.s7_300:
        b.copy().runs(82, priority=26).end(60).accepted("26 interrupts 25")
        b.copy().wait(1).tick().rejected("26 interrupts 25")
    else:
        b.copy().start(82).rejected("25 does not interrupt 25")
        b.copy().wait(2).end(60).runs(82, priority=25).accepted("25 after 25")
    c = v.log(EVERY_OB).interrupt(86).start(86).wait(3).interrupt(81).wait(v.latency)
    c.copy().start(81).rejected("asynchronous errors do not interrupt one another")
    c.copy().wait(9).end(86).runs(81).accepted("in order of occurrence")
    d = v.log(EVERY_OB).interrupt(86).start(86).wait(3).interrupt(83).wait(1).interrupt(81).wait(v.latency + 4).end(86)
    d.copy().runs(83).runs(81).accepted("in order of occurrence")
    d.start(81).rejected("in order of occurrence")


@situation("OBS-04")
def redundancy_classes(v: Variant) -> None:
    a = v.log(EVERY_OB).interrupt(80, flt_id=word(1)).start(80).wait(2).interrupt(72)
    a.copy().runs(72, priority=28).end(80).accepted("OB 72 has class 28")
    a.copy().late("OB 72 has class 28")
    b = v.log(EVERY_OB).interrupt(70).start(70).wait(2).interrupt(60).wait(v.latency)
    b.copy().start(60).rejected("OB 70 and OB 60 share class 25")
    b.wait(5).end(70).runs(60, priority=25).accepted("OB 70 and OB 60 share class 25")
    c = v.log(EVERY_OB).interrupt(60).start(60).interrupt(47).wait(v.latency)
    c.start(47).rejected("OB 47 has class 23")
    for o, p in ((30, 7), (38, 15), (40, 16), (47, 23), (57, 2)):
        v.log(EVERY_OB).interrupt(o).runs(o, priority=p).accepted("default classes")
        if v.number < 2:
            v.log(EVERY_OB).interrupt(o).start(o, priority=p + 1).rejected("default classes")


@situation("OBS-20")
def missing_outside(v: Variant) -> None:
    for o in (30, 40, 55)[: 2 + v.number % 2]:
        a = v.log([1, 80, 85]).interrupt(o)
        a.copy().runs(85).tick().accepted("a start event for an OB not loaded: OB 85")
        a.copy().late("a start event for an OB not loaded: OB 85")
        a.copy().start(o).rejected("not loaded")
        b = v.log([1, 80]).interrupt(o)
        b.copy().stop(0x456D).accepted("no OB 85: STOP", "OBS-21")
        b.late("no OB 85: STOP", "OBS-21")


@situation("OBS-23")
def missing_error_obs(v: Variant) -> None:
    for o in (82, 83, 86):
        a = v.log([1, 35, 80, 85]).interrupt(o)
        a.copy().wait(v.latency).stop().accepted("missing asynchronous error OB: STOP")
        a.copy().late("missing asynchronous error OB: STOP")
        a.copy().start(85).rejected("OB 85 is not called for it", "OBS-20")
        a.copy().stop(0x4568).rejected("4568 belongs to OB 80", "OBS-22")
    for o in (81, 87, 70, 72):
        b = v.log([1, 35, 80, 85]).interrupt(o)
        b.copy().wait(v.latency + 9).tick().accepted("nothing happens", "AMB-75")
        b.copy().start(85).rejected("the default: nothing", "AMB-75")
    c = v.log([1, 35, 80, 85]).interrupt(84)
    c.copy().wait(v.latency + 9).tick().accepted("84: nothing", "AMB-75")
    c.copy().stop().accepted("or STOP", "AMB-75")
    d = v.log([1, 35, 80, 85], readings={"AMB-75": "b"}).interrupt(87)
    d.copy().runs(85).accepted("AMB-75 b", "AMB-75")
    d.late("AMB-75 b", "AMB-75")
    e = v.log([1, 35, 85]).interrupt(80, flt_id=word(1))
    e.copy().stop(0x4568).accepted("missing OB 80: STOP", "OBS-22")
    e.late("missing OB 80: STOP", "OBS-22")
    f = v.log([1, 35, 80]).interrupt(85, flt_id=word(0xA3))
    f.copy().stop(0x456D).accepted("missing OB 85: STOP", "OBS-21")
    f.late("missing OB 85: STOP", "OBS-21")


@situation("OBS-26")
def cycle_twice(v: Variant) -> None:
    a = (
        v.log([1, 80, 85], cycle=True)
        .interrupt(80, flt_id=word(1))
        .runs(80, flt_id=1)
        .wait(50)
        .interrupt(80, flt_id=word(1))
    )
    a.copy().stop(0x4568).accepted("twice in one cycle: STOP")
    b = (
        v.log([1, 80, 85], cycle=True)
        .interrupt(80, flt_id=word(1))
        .runs(80, flt_id=1)
        .end(1)
        .start(1)
        .wait(50)
        .interrupt(80, flt_id=word(1))
    )
    b.copy().runs(80, flt_id=1).accepted("another cycle: OB 80 again")
    b.copy().stop(0x4568).rejected("another cycle: no STOP by a rule")
    b.copy().late("another cycle: OB 80 is owed")
    v.log([1, 80, 85]).interrupt(80, flt_id=word(1)).stop(0x4568).rejected("once is no STOP")
    c = v.log([1, 80, 85]).interrupt(80, flt_id=word(1)).runs(80).wait(50).interrupt(80, flt_id=word(1))
    c.copy().runs(80).accepted("an unseen cycle boundary")
    c.copy().stop(0x4568).accepted("or none")


@situation("OBS-30")
def ob80_by_hand(v: Variant) -> None:
    a = v.log()
    a.copy().start(80, flt_id=1).rejected("01 has its interrupt line")
    a.copy().interrupt(80, flt_id=word(1)).runs(80, flt_id=1).accepted("01 with its interrupt line")
    a.copy().interrupt(80, flt_id=word(1)).start(80, flt_id=2).rejected("the fault of the event")
    a.copy().interrupt(80, flt_id=word(0x09)).runs(80, flt_id=9).accepted("09 from outside")
    a.copy().interrupt(80, flt_id=word(2)).rejected("02 is made by the rules alone")
    a.copy().interrupt(80, flt_id=word(5)).rejected("05 is made by the rules alone")
    a.copy().interrupt(85, flt_id=word(0xA1)).rejected("A1 is made by the rules alone")
    a.copy().interrupt(85, flt_id=word(0xA3)).runs(85, flt_id=0xA3).accepted("A3 from outside")
    a.copy().interrupt(85, flt_id=word(0xA3)).start(85, flt_id=0xA1).rejected("the fault of the event")
    a.copy().start(80).rejected("no cause in the log")
    a.copy().start(85).rejected("no cause in the log")
    a.copy().interrupt(80).unusable("flt_id is required for OB 80")
    a.copy().interrupt(35, flt_id=word(1)).unusable("flt_id is for OB 80 and 85 only")
    for o in (1, 10, 20, 88, 90, 100, 121, 61):
        a.copy().interrupt(o).unusable("no start event from outside for this OB")


@situation("OBS-33")
def ob80_outside_blocked(v: Variant) -> None:
    a = v.log().dis_irt(2, 80).interrupt(80, flt_id=word(1))
    a.copy().start(80).rejected("blocked")
    a.copy().wait(v.latency + 9).tick().accepted("blocked")
    b = v.log([1, 35]).dis_irt(1, 80).interrupt(80, flt_id=word(1))
    b.copy().wait(v.latency + 9).tick().accepted("no default reaction either", "IRT-01")
    b.stop(0x4568).rejected("no default reaction either", "IRT-01")
    c = v.log().dis_airt(1).interrupt(80, flt_id=word(1)).wait(v.latency + 9)
    c.copy().en_airt(0).runs(80, flt_id=1).accepted("delayed")
    c.copy().en_airt(0).late("delayed")


@situation("OBS-41")
def stop_mode(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).wait(100).stop().wait(100)
    a.copy().tick().rejected("no program in STOP")
    a.copy().until(v.point).start().rejected("no OB in STOP")
    a.copy().start(1).rejected("no OB in STOP")
    a.copy().until(v.point, 500).restart().wait(5).run().wait(50).tick().accepted("and settings are gone", "OBS-50")
    a.copy().run().rejected("RUN only after STARTUP", "OBS-40")
    a.copy().release().rejected("no HOLD to leave", "OBS-40")
    a.copy().hold().rejected("no HOLD from STOP", "OBS-40")
    a.copy().state(v.ob, loaded=True).accepted("state in STOP: loaded", "OBS-60")
    a.copy().state(v.ob, loaded=False).rejected("state in STOP: loaded", "OBS-60")
    a.copy().clock(v.point + 9 * MINUTE).wait(99).event("load", ob=30).restart().run().accepted(
        "the clock may be set, blocks may be loaded in STOP"
    )
    a.copy().stop(0x4568).rejected("no rule stops a stopped CPU", "OBS-22")
    v.log().interrupt(35).start(35).wait(2).stop().end(35).rejected("nothing goes on in STOP")


@situation("OBS-42")
def startup_mode(v: Variant) -> None:
    a = v.log(mode="STARTUP")
    a.copy().interrupt(35).wait(v.latency + 5).start(35).rejected("no interrupt OB in STARTUP")
    a.copy().interrupt(35).wait(v.latency + 50).run().runs(35).accepted("kept until RUN", "AMB-67")
    a.copy().interrupt(35).wait(v.latency + 50).run().wait(99).tick().accepted("or lost", "AMB-67")
    a.copy().start(1).rejected("OB 1 only in RUN")
    a.copy().run().release().rejected("no HOLD to leave", "OBS-40")
    a.copy().run().run().rejected("RUN already", "OBS-40")
    b = v.log(EVERY_OB, mode="STARTUP").interrupt(82)
    b.copy().runs(82, priority=28).accepted("class 28 in STARTUP", "OBS-43")
    b.copy().start(82, priority=26).rejected("class 28 in STARTUP", "OBS-43")
    c = v.log(EVERY_OB, mode="STARTUP").interrupt(80, flt_id=word(1))
    c.copy().runs(80, priority=28).accepted("28 in STARTUP", "AMB-13")
    c.start(80, priority=26).rejected("28 in STARTUP", "AMB-13")
    v.log(EVERY_OB, mode="STARTUP", readings={"AMB-13": "c"}).interrupt(80, flt_id=word(1)).start(
        80, priority=28
    ).rejected("AMB-13 c: always 26", "AMB-13")


@situation("OBS-45")
def hold_mode(v: Variant) -> None:
    a = v.log().armed(v.point).hold()
    a.copy().wait(5).tick().rejected("no program in HOLD")
    a.copy().until(v.point).start().rejected("no OB in HOLD")
    a.copy().wait(99).release().until(v.point).runs().accepted("HOLD over before the point")
    a.copy().wait(9).start(1).rejected("no program in HOLD")
    a.copy().wait(9).run().rejected("HOLD is left by release", "OBS-40")
    a.copy().wait(9).hold().rejected("HOLD already", "OBS-40")
    a.copy().wait(9).release().release().rejected("HOLD is left", "OBS-40")


@situation("OBS-46")
def hold_tod(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).wait(10).hold().until(v.point, 2 * 60000 + 9000).release()
    a.copy().runs(80, flt_id=6, error_info=1 << v.ob - 10).runs().tick().accepted(
        "OB 80 with 06, then a catch-up", "AMB-55"
    )
    a.copy().runs(80, flt_id=6).wait(99).tick().accepted("or none", "AMB-55")
    a.copy().late("OB 80 with 06 is owed")
    a.copy().start(80, flt_id=5).rejected("06, not 05", "OBS-30")
    a.copy().start(80, flt_id=6, error_info=1 << (v.ob - 9)).rejected("the bit of the OB", "OBS-32")
    a.copy().runs(80, flt_id=6).runs(ms=1).start().rejected("one catch-up at most", "CLK-03")
    a.copy().wait(min(v.latency, 1)).start().rejected("OB 80 first", "OBS-46")
    a.copy().runs(80, flt_id=6, ms=1).start(80).rejected("one OB 80 for all points")
    a.copy().runs(80, flt_id=6).until(v.point + 3 * MINUTE).late("the series goes on", "TINT-09")
    b = v.log([1, v.ob]).armed(v.point).hold().until(v.point, 9000).release()
    b.copy().wait(v.latency).stop(0x4568).accepted("no OB 80: STOP", "OBS-22")
    b.late("no OB 80: STOP", "OBS-22")
    c = v.log().armed(v.point).armed(v.point + MINUTE, ob=v.other).hold().until(v.point + MINUTE, 5).release()
    c.copy().runs(80, flt_id=6, error_info=1 << v.ob - 10 | 1 << v.other - 10).accepted("both bits", "OBS-32")
    c.start(80, flt_id=6, error_info=1 << v.ob - 10).rejected("both bits", "OBS-32")


@situation("OBS-46")
def hold_no_point(v: Variant) -> None:
    a = v.log().set_tint(v.point, 0x201).hold().until(v.point, 9000).release()
    a.copy().wait(v.latency + 9).tick().accepted("set but not active: no 06", "CLK-14")
    a.start(80).rejected("set but not active: no 06", "CLK-14")
    b = v.log().armed(v.point).until(v.point, -5).hold().until(v.point, -2).release()
    b.copy().start(80).rejected("no point passed in HOLD")
    b.until(v.point).runs().accepted("no point passed in HOLD")


@situation("OBS-40")
def mode_order(v: Variant) -> None:
    v.log(mode="STOP").wait(5).restart().wait(5).start(100).wait(5).end(100).run().start(1).wait(1).end(1).accepted(
        "STOP, STARTUP, RUN"
    )
    v.log(mode="STOP").wait(5).run().rejected("RUN only by STARTUP")
    v.log().run().rejected("RUN already")
    v.log().release().rejected("no HOLD to leave")
    v.log(mode="STOP").start(100).rejected("no OB in STOP", "OBS-41")
    v.log(mode="STOP").restart().wait(5).start(1).rejected("STARTUP is not over", "OBS-42")
    v.log().start(100).rejected("startup OB only in STARTUP", "OBS-42")
    v.log(mode="STARTUP").end(100).wait(5).stop().wait(5).restart().end(100).accepted("STARTUP may stop")
    v.log().hold().wait(5).stop(0x430A).wait(5).restart().run().accepted("HOLD to STOP")


@situation("OBS-56")
def step7_once_past(v: Variant) -> None:
    s7 = {"tod": {str(v.ob): {"execution": "once", "start": iso(v.begin - 26 * HOUR)[:16], "active": True}}}
    a = v.log(mode="STOP", step7=s7).wait(9).restart().wait(9).run()
    a.copy().runs().accepted("called once after the warm restart")
    a.copy().late("called once after the warm restart")
    a.copy().runs(ms=1).start().rejected("once")
    a.copy().runs().stop().wait(9).restart().run().runs().accepted("after every restart")
    b = v.log([1, 80, 85], mode="STOP", step7=s7).wait(9).restart().wait(9).run()
    b.copy().runs(85).accepted("missing: OB 85", "TINT-16")
    a.copy().start(80).rejected("no time error")
    v.log(mode="STOP", step7={"tod": {str(v.ob): dict(s7["tod"][str(v.ob)], active=False)}}).restart().wait(
        9
    ).run().start().rejected("not activated")


@situation("OBS-57")
def cold_restart(v: Variant) -> None:
    a = v.log(mode="STOP").wait(9).restart("cold").wait(5).run()
    a.accepted("cold restart", "AMB-65")
    if v.s7_300:
        v.log(mode="STOP", readings={"AMB-65": "b"}).wait(9).restart("cold").rejected(
            "AMB-65 b: an S7-300 has no cold restart", "AMB-65"
        )
    else:
        v.log(mode="STOP", readings={"AMB-65": "b"}).wait(9).restart("cold").accepted(
            "AMB-65 b concerns the S7-300 only", "AMB-65"
        )
    v.log(mode="STOP").restart("hot").unusable("hot restarts are not of the format", "AMB-26")
    v.log([1, 100, 102], mode="STOP").restart("cold").start(100).rejected("the cold restart has OB 102", "OBS-42")
    v.log([1, 100, 102], mode="STOP").restart("warm").start(102).rejected("the warm restart has OB 100", "OBS-42")
    v.log([1, 100, 102], mode="STOP").restart("cold").wait(1).runs(102).run().accepted(
        "the cold restart has OB 102", "OBS-42"
    )


@situation("OBS-55")
def settings_in_startup(v: Variant) -> None:
    a = v.log(mode="STOP").wait(9).restart().armed(v.point).wait(5).run()
    a.copy().until(v.point).runs().accepted("made in OB 100: after the erasing")
    a.copy().until(v.point).late("made in OB 100: after the erasing")
    b = v.log(mode="STOP").wait(9).restart().dis_irt(2, 35).run().interrupt(35)
    b.copy().start(35).rejected("a block made in OB 100 holds in RUN", "IRT-03")
    b.wait(v.latency + 5).tick().accepted("a block made in OB 100 holds in RUN", "IRT-03")
    c = v.log(mode="STARTUP").armed(v.point).wait(5).stop().wait(5).restart().run().until(v.point)
    c.start().rejected("erased by the next restart", "OBS-50")


@situation("OBS-47")
def stop_any_time(v: Variant) -> None:
    v.log().stop().accepted("switch")
    v.log().stop(0x4303).accepted("switch")
    v.log().interrupt(35).start(35).dis_airt(1).stop(0x457F).accepted("STP, not delayed", "AIRT-11")
    v.log().stop(0x4568).rejected("4568 needs its rule", "OBS-22")
    v.log().stop(0x456D).rejected("456D needs its rule", "OBS-21")
    v.log().stop(0x454A).rejected("454A needs its rule", "OBS-25")
    v.log([1]).armed(v.point).until(v.point).stop(0x4304).accepted("the PG, while a STOP by a rule is due")
    v.log(mode="STARTUP").stop().accepted("from STARTUP")


@situation("OBS-07")
def requests_outside(v: Variant) -> None:
    a = v.log().interrupt(35).start(35).wait(3).interrupt(35)
    a.copy().runs(80, flt_id=2, ev_ob=35).end(35).runs(35).accepted(
        "again while running: OB 80 and a later run", "AMB-77"
    )
    a.copy().wait(9).end(35).runs(35).accepted("or buffered", "AMB-77")
    a.copy().wait(9).end(35).wait(99).tick().accepted("or lost", "AMB-77")
    a.copy().wait(9).end(35).runs(35, ms=1).start(35).rejected("two events, two runs at most")
    a.copy().start(35).rejected("it still runs", "OBS-02")
    a.copy().start(80, flt_id=5).rejected("no clock change", "OBS-30")
    v.log(readings={"AMB-77": "a"}).interrupt(35).start(35).wait(3).interrupt(35).late("AMB-77 a: OB 80", "AMB-77")
    v.log().start(35).rejected("no start event")
    v.log().interrupt(35).runs(35, ms=1).start(35).rejected("one event, one run")
    v.log().interrupt(35).runs(35).wait(1).interrupt(35).runs(35).accepted("two events")


@situation("OBS-03")
def stack_discipline(v: Variant) -> None:
    a = (
        v.log(EVERY_OB)
        .armed(v.point)
        .until(v.point)
        .start()
        .srt_dint(50)
        .wait(50)
        .start(v.delay_ob)
        .wait(1)
        .interrupt(35)
        .start(35)
        .wait(1)
        .interrupt(40)
        .start(40)
        .wait(1)
        .interrupt(82)
        .start(82)
    )
    a.copy().end(82).end(40).end(35).end(v.delay_ob).end().accepted("five levels deep")
    a.copy().end(82).end(35).rejected("OB 40 is on top")
    a.copy().end(40).rejected("OB 82 is on top")
    a.copy().end(1).rejected("OB 1 is at the bottom")
    a.copy().end(82).wait(1).dis_airt(1).end(40).dis_airt(1).en_airt(0).accepted(
        "each level has its own calls", "AIRT-12"
    )
    a.copy().end(82).start(82).rejected("no event")
    a.copy().start(1).rejected("OB 1 does not interrupt", "OBS-01")
    a.copy().stop().wait(2).restart().wait(2).run().wait(v.latency + 5).tick().accepted(
        "STOP clears the stack", "OBS-41"
    )


@situation("AMB-66")
def delete_ob(v: Variant) -> None:
    a = v.log([1, v.ob, 35, 80, 85]).armed(v.point, 0x201).until(v.point).start().wait(1).event("delete", ob=v.ob)
    a.copy().wait(9).end().until(v.point + MINUTE).runs(85).accepted("deleted while running: goes on, then missing")
    a.copy().wait(9).end().until(v.point + MINUTE).start().rejected("deleted")
    a.copy().wait(9).end().until(v.point + MINUTE).late("the next call finds it missing")
    b = (
        v.log([1, v.ob, 35, 80, 85])
        .armed(v.point)
        .until(v.point, -5)
        .interrupt(35)
        .start(35)
        .until(v.point, 5)
        .event("delete", ob=v.ob)
        .wait(9)
        .end(35)
    )
    b.copy().runs(85).accepted("deleted while pending: missing at its call")
    b.copy().late("deleted while pending: missing at its call")
    b.copy().start().rejected("deleted")
    c = v.log().event("delete", ob=80).armed(v.point, 0x201).until(v.point).start().until(v.point + MINUTE)
    c.copy().stop(0x4568).accepted("OB 80 deleted: STOP", "OBS-22")
    (
        v.log()
        .event("delete", ob=85)
        .event("load", ob=85)
        .event("delete", ob=v.ob)
        .qry_tint(0)
        .accepted("not loaded", "TINT-76")
    )
    v.log([1, 80, 85]).event("load", ob=v.ob).qry_tint(0x10).armed(v.point).until(v.point).runs().accepted(
        "loaded later", "TINT-76"
    )
    v.log([1, 80, 85]).event("load", ob=v.ob).qry_tint(0).rejected("loaded later", "TINT-76")


@situation("AMB-45")
def several_missing(v: Variant) -> None:
    a = v.log([1, 80, 85]).armed(v.point).armed(v.point, ob=v.other).until(v.point)
    a.copy().runs(85).wait(v.latency + 9).tick().accepted("one OB 85 for all")
    a.copy().runs(85, ms=0).runs(85).accepted("or one each")
    a.copy().runs(85, ms=0).runs(85, ms=0).start(85).rejected("two missing OBs, two OB 85 at most")
    a.copy().late("one at least", "TINT-16")
    b = v.log([1, 80]).armed(v.point).armed(v.point, ob=v.other).until(v.point).stop(0x456D)
    b.copy().accepted("STOP", "OBS-21")
    b.stop(0x456D).rejected("stopped already", "OBS-21")


@situation("TINT-15")
def info85(v: Variant) -> None:
    a = v.log([1, 80, 85]).armed(v.point, 0x401).until(v.point)
    c85 = 26 if v.s7_300 else 25
    a.copy().runs(85, flt_id=0xA1, error_info=0x401, ev=0x1111 + v.ob - 10, priority=c85).accepted(
        "start info of OB 85", "OBS-20"
    )
    a.copy().start(85, error_info=0x201).rejected("Z1 is PERIOD_EXE of the requested OB", "OBS-20")
    a.copy().start(85, ev=0x1121).rejected("event of the request", "OBS-20")
    a.copy().start(85, priority=51 - c85).rejected("class of OB 85 by CPU", "OBS-04")
    a.copy().start(85, time=iso(v.point - MS)).rejected("before the due point", "OBS-10")
    v.log([1, 80, 85]).srt_dint(100, 0x4711).wait(100).runs(
        85, error_info=0x4711, ev=0x1121 + v.delay_ob - 20
    ).accepted("SIGN of the missing delay OB", "OBS-20")


@situation("OBS-10")
def info1x(v: Variant) -> None:
    a = v.log().armed(v.point, 0x401).until(v.point, min(3, v.latency))
    for t in (v.point, a.clock_now):
        a.copy().runs(time=iso(t), period=0x401, strt_info=0x11 + v.ob - 10, priority=2).accepted(
            "time of the event or of the call"
        )
    for k, x, r in (
        ("time", iso(v.point - MS), None),
        ("time", iso(a.clock_now + MS), None),
        ("period", 0x201, "TINT-33"),
        ("strt_info", 0x12 + v.ob - 10, "OBS-04"),
        ("priority", 3, "OBS-04"),
    ):
        a.copy().start(None, **{k: x}).rejected(f"start info field {k}", r)


@situation("AMB-13")
def overflow_class(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point, -5).interrupt(35).start(35).until(v.point + MINUTE)
    a.copy().runs(80, flt_id=7, priority=28).accepted("07: buffer overflow, class 28", "OBS-08")
    a.copy().start(80, flt_id=7, priority=26).rejected("07: class 28", "AMB-13")
    a.copy().runs(80, flt_id=2, priority=26).accepted("02: class 26", "OBS-31")
    a.copy().start(80, flt_id=2, priority=28).rejected("02: class 26 in RUN", "OBS-31")
    v.log(readings={"AMB-13": "a"}).armed(v.point, 0x201).until(v.point, -5).interrupt(35).start(35).until(
        v.point + MINUTE
    ).start(80, flt_id=7, priority=28).rejected("AMB-13 a: 28 only in STARTUP")


@situation("AMB-27")
def overlap_info(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start().wait(50).interrupt(35).start(35).until(v.point + MINUTE)
    a.copy().runs(
        80, flt_id=2, error_info=0x201, ev=0x1111 + v.ob - 10, ev_ob=v.ob, time=iso(v.point + MINUTE)
    ).accepted("the requested OB")
    a.copy().start(80, flt_id=2, ev_ob=35).rejected("the requested OB, not the active one")
    v.log(readings={"AMB-27": "a"}).armed(v.point, 0x201).until(v.point).start().wait(50).interrupt(35).start(35).until(
        v.point + MINUTE
    ).runs(80, flt_id=2, ev_ob=35).accepted("AMB-27 a: the active one")
    a.copy().start(80, flt_id=2, error_info=0).rejected("PERIOD_EXE of the requested OB", "OBS-30")
    a.copy().start(80, flt_id=2, ev=0x1136).rejected("event of the request", "OBS-30")

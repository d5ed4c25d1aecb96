"""The clock is set."""

from tests.by_hand.situations.builder import DAY, HOUR, MINUTE, MS, Variant, bit, iso, moment, situation


@situation("CLK-02")
def forward_skip(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).wait(4000).clock(v.point + 3 * MINUTE + 20 * 1000 * MS)
    now = a.clock_now
    a.copy().runs(80, flt_id=5, error_info=bit(v.ob), time=iso(now), priority=26).runs(
        time=iso(v.point), period=0x201
    ).tick().accepted("OB 80 with 05, one catch-up with the first skipped point", "CLK-03")
    a.copy().late("OB 80 is owed")
    a.copy().start(80, flt_id=6).rejected("05, not 06", "OBS-30")
    a.copy().start(80, error_info=bit(v.other)).rejected("bit of the late OB", "CLK-06")
    a.copy().start(80, time=iso(v.point)).rejected("the clock after the change", "AMB-16")
    a.copy().start().rejected("OB 80 first", "CLK-03")
    b = a.copy().runs(80)
    b.copy().late("the catch-up is owed", "CLK-03")
    b.copy().start(time=iso(v.point + MINUTE)).rejected("the first skipped point", "CLK-07")
    b.copy().runs(ms=1).start().rejected("once, however many periods", "CLK-03")
    b.copy().runs().until(v.point + 4 * MINUTE).runs().accepted("goes on with the next point", "CLK-08")
    b.copy().runs().until(v.point + 4 * MINUTE).late("goes on with the next point", "CLK-08")
    b.copy().runs(80).rejected("one change, one OB 80", "OBS-32", line=len(b.lines) + 1)


@situation("CLK-05")
def forward_no80(v: Variant) -> None:
    a = v.log([1, v.ob, 85]).armed(v.point).clock(v.point + MINUTE)
    a.copy().wait(v.latency).stop(0x4568).accepted("no OB 80: STOP")
    a.copy().late("no OB 80: STOP")
    a.copy().start().rejected("no OB 80: STOP")
    v.log([1, v.ob, 85]).armed(v.point).clock(v.point).runs().accepted("exactly onto the point: no skip", "AMB-37")
    v.log([1, v.ob, 85]).set_tint(v.point).clock(v.point + MINUTE).wait(99).tick().accepted(
        "not active: no skip", "CLK-14"
    )


@situation("AMB-37")
def forward_onto(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).clock(v.point)
    a.copy().runs().accepted("reached, not skipped")
    a.copy().start(80).rejected("reached, not skipped")
    a.copy().late("reached: the call is owed")
    b = v.log(readings={"AMB-37": "b"}).armed(v.point, 0x201).clock(v.point)
    b.copy().runs(80, flt_id=5).runs().accepted("AMB-37 b: skipped")
    b.late("AMB-37 b: skipped")
    c = v.log().armed(v.point, 0x201).clock(v.point + MINUTE)
    c.copy().runs(80, flt_id=5, error_info=bit(v.ob)).runs().accepted("one skipped, one reached")
    c.copy().start().rejected("the first was skipped: OB 80 first", "CLK-02")
    d = v.log().armed(v.point, 0x201).clock(v.point - MS)
    d.copy().start(80).rejected("nothing skipped yet", "CLK-02")
    d.wait(1).runs().accepted("one millisecond short of it")


@situation("AMB-15")
def manipulated(v: Variant) -> None:
    a = v.log().armed(v.point).clock(v.point + MINUTE).start(80, flt_id=5)
    a.copy().can_tint(0).wait(1).end(80).wait(99).tick().accepted("cancelled in OB 80: no catch-up", "TINT-54")
    a.copy().can_tint(0).end(80).start().rejected("cancelled in OB 80: no catch-up", "TINT-54")
    a.copy().set_tint(v.point + 5 * MINUTE).end(80).start().rejected("set in OB 80: no catch-up", "CLK-04")
    a.copy().set_tint(v.point + 2 * MINUTE).act_tint(0).end(80).until(v.point + 2 * MINUTE).runs().accepted(
        "set anew in OB 80", "CLK-04"
    )
    a.copy().act_tint(None).end(80).late("ACT alone does not remove the catch-up")
    a.copy().dis_irt(2, v.ob).end(80).runs().accepted("DIS_IRT does not remove it: requested before")
    a.copy().dis_irt(2, v.ob).end(80).late("DIS_IRT does not remove it")
    b = (
        v.log(readings={"AMB-15": "c"})
        .armed(v.point)
        .clock(v.point + MINUTE)
        .start(80, flt_id=5)
        .dis_irt(2, v.ob)
        .end(80)
    )
    b.start().rejected("AMB-15 c: DIS_IRT manipulates it")
    a.copy().set_tint(v.point, 0, 0x80A1).end(80).late("a SET that fails manipulates nothing", "AMB-20")
    a.copy().can_tint(0x80A0, v.other).end(80).runs().accepted("another OB", "CLK-03")
    a.copy().end(80).runs().act_tint(0x80A0).accepted("caught up, then cancelled", "CLK-13")


@situation("OBS-32")
def forward_many(v: Variant) -> None:
    a = v.log().armed(v.point).armed(v.point + MINUTE, 0x201, v.other).clock(v.point + 5 * MINUTE + 1000 * MS)
    b = a.copy().runs(80, flt_id=5, error_info=bit(v.ob) | bit(v.other))
    b.copy().runs().runs(v.other).accepted("one OB 80, two catch-ups, any order", "AMB-54")
    b.copy().runs(v.other).runs().accepted("any order", "AMB-54")
    a.copy().start(80, error_info=bit(v.ob)).rejected("both bits")
    b.copy().runs().late("the second catch-up is owed", "CLK-03")
    b.copy().start(80).rejected("one OB 80 for one change")
    c = (
        v.log(readings={"AMB-54": "a"})
        .armed(v.point)
        .armed(v.point + MINUTE, 0x201, v.other)
        .clock(v.point + 5 * MINUTE + 1000 * MS)
        .runs(80)
    )
    c.copy().start(v.other).rejected("AMB-54 a: by first skipped point", "AMB-54")
    c.runs().runs(v.other).accepted("AMB-54 a", "AMB-54")
    d = a.copy().start(80).can_tint(0, v.other).end(80).runs()
    d.copy().wait(99).tick().accepted("one of them cancelled in OB 80", "TINT-54")
    d.copy().start(v.other).rejected("cancelled in OB 80", "TINT-54")
    a.copy().stop().wait(9).restart().run().wait(99).tick().accepted("a STOP in between ends it all", "OBS-50")


@situation("CLK-09")
def back(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).runs().until(v.point, 20000).clock(v.point - 10000 * MS)
    b = a.copy().until(v.point)
    if v.s7_300:
        b.copy().runs().until(v.point + MINUTE).runs().accepted("S7-300: executed again", "CLK-10")
        b.copy().late("S7-300: executed again", "CLK-10")
        a.copy().start().rejected("not at once, when its point passes again", "AMB-40")
    else:
        b.copy().wait(99).tick().until(v.point + MINUTE).runs().accepted("not served again")
        b.copy().start().rejected("not served again")
        b.copy().wait(99).until(v.point + MINUTE).late("the next point was never served")
    a.copy().start(80).rejected("backward is no time error")
    p97 = (
        v.log(profile="1997")
        .armed(v.point, 0x201)
        .until(v.point)
        .runs()
        .until(v.point, 20000)
        .clock(v.point - 10000 * MS)
        .until(v.point)
    )
    p97.copy().start().rejected("edition 1997: not served again on any CPU", "AMB-17")
    p97.wait(99).tick().until(v.point + MINUTE).runs().accepted("edition 1997: not served again on any CPU", "AMB-17")


@situation("CLK-12")
def back_once(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point).runs().until(v.point, 5000).clock(v.point - 5000 * MS)
    a.copy().until(v.point, 99).tick().accepted("a served once is cancelled")
    a.copy().until(v.point).start().rejected("a served once is cancelled")
    a.copy().act_tint(0).rejected("a served once is cancelled", "AMB-08")
    b = v.log().armed(v.point).until(v.point).start().wait(100).clock(v.point - 5000 * MS).wait(3).end()
    b.copy().until(v.point).start().rejected("back inside its own call: used up", "AMB-71")
    b.until(v.point, 99).tick().accepted("back inside its own call: used up", "AMB-71")
    c = v.log().armed(v.point).until(v.point, -5).interrupt(35).start(35).until(v.point, 5).clock(v.point - 5000 * MS)
    c.copy().wait(9).end(35).runs().accepted("the request stays", "AMB-59")
    c.copy().wait(9).end(35).late("the request stays", "AMB-59")
    c.copy().wait(9).end(35).runs().until(v.point).start().rejected("and its once is used up", "AMB-71")


@situation("AMB-57")
def back_new_set(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point)
        .runs()
        .until(v.point, 20000)
        .clock(v.point - 10000 * MS)
        .set_tint(v.point, 0x201)
        .act_tint(0)
        .until(v.point)
    )
    a.copy().runs().accepted(
        "a new setting: its points are served" if not v.s7_300 else "S7-300: served in any case",
        None if not v.s7_300 else "CLK-10",
    )
    if v.s7_300:
        a.copy().late("S7-300: served", "CLK-10")
    else:
        a.copy().wait(v.latency + 9).tick().accepted("or the memory stays with the OB")
    b = (
        v.log()
        .armed(v.point + 9 * MINUTE, 0x401)
        .until(v.point, 20000)
        .clock(v.point - 10000 * MS)
        .set_tint(v.point, 0x201)
        .act_tint(0)
        .until(v.point)
    )
    b.copy().runs().accepted("not called in the interval: no memory")
    b.late("not called in the interval: no memory")


@situation("AMB-56")
def back_unserved(v: Variant) -> None:
    # active, its point passed while blocked; then back, then unblocked
    a = (
        v.log()
        .armed(v.point, 0x201)
        .dis_irt(2, v.ob)
        .until(v.point, 20000)
        .en_irt(2, v.ob)
        .clock(v.point - 10000 * MS)
        .until(v.point)
    )
    a.copy().runs().accepted("a lost point: served when passed again")
    if v.s7_300:
        a.copy().late("S7-300: executed when passed again", "CLK-10")
    else:
        a.copy().wait(v.latency + 9).tick().accepted("or not")
    b = (
        v.log(readings={"AMB-56": "b"})
        .armed(v.point, 0x201)
        .dis_irt(2, v.ob)
        .until(v.point, 20000)
        .en_irt(2, v.ob)
        .clock(v.point - 10000 * MS)
        .until(v.point)
    )
    if not v.s7_300:
        b.copy().start().rejected("AMB-56 b: not served")
        c = (
            v.log(readings={"AMB-56": "a"})
            .armed(v.point, 0x201)
            .dis_irt(2, v.ob)
            .until(v.point, 20000)
            .en_irt(2, v.ob)
            .clock(v.point - 10000 * MS)
            .until(v.point)
        )
        c.late("AMB-56 a: served")
        d = (
            v.log(readings={"AMB-56": "d"})
            .armed(v.point, 0x201)
            .dis_irt(2, v.ob)
            .until(v.point, 20000)
            .en_irt(2, v.ob)
            .clock(v.point - 10000 * MS)
            .until(v.point)
        )
        d.late("AMB-56 d: the OB was not called")
    else:
        b.late("AMB-56 concerns S7-400 and CPU 318 only", "CLK-10")


@situation("AMB-58")
def back_then_forward(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point)
        .runs()
        .until(v.point, 20000)
        .clock(v.point - 10000 * MS)
        .wait(1000)
        .clock(v.point + 25000 * MS)
    )
    if v.s7_300:
        a.copy().runs(80, flt_id=5, error_info=bit(v.ob)).runs().accepted("S7-300: a skip")
        a.copy().late("S7-300: a skip")
    else:
        a.copy().start(80).rejected("already served: no skip")
        a.copy().wait(99).tick().until(v.point + MINUTE).runs().accepted("already served: no skip")
        b = (
            v.log(readings={"AMB-58": "b"})
            .armed(v.point, 0x201)
            .until(v.point)
            .runs()
            .until(v.point, 20000)
            .clock(v.point - 10000 * MS)
            .wait(1000)
            .clock(v.point + 25000 * MS)
        )
        b.copy().runs(80, flt_id=5).runs().accepted("AMB-58 b: a skip")
        b.late("AMB-58 b: a skip")
    c = (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point)
        .runs()
        .until(v.point, 20000)
        .clock(v.point - 10000 * MS)
        .wait(1000)
        .clock(v.point + MINUTE + 1000 * MS)
    )
    c.copy().runs(80, flt_id=5, time=iso(c.clock_now)).runs(
        time=iso(v.point if v.s7_300 else v.point + MINUTE)
    ).accepted("over a served and an unserved point")
    c.copy().runs(80).start(time=iso(v.point + MINUTE if v.s7_300 else v.point)).rejected(
        "the first skipped point by CPU", "CLK-07"
    )
    c.late("the unserved point is skipped", "CLK-02")


@situation("CLK-14")
def inactive_past(v: Variant) -> None:
    a = v.log().set_tint(v.point).clock(v.point + MINUTE)
    a.copy().act_tint(0x80A1).accepted("turned into past")
    a.copy().act_tint(0).rejected("turned into past")
    a.copy().start(80).rejected("not active: no skip")
    b = v.log().set_tint(v.point).until(v.point, 9).clock(v.point - MINUTE).act_tint(0)
    b.copy().until(v.point).runs().accepted("and back into future")
    b.until(v.point).late("and back into future")


@situation("CLK-18")
def late_is_no_skip(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x1001 if v.number != 2 else 0x401)
        .until(v.point, -5)
        .interrupt(35)
        .start(35)
        .dis_airt(1)
        .until(v.point, 20000)
    )
    a.copy().en_airt(0).wait(5).end(35).runs(time=iso(v.point)).accepted("an ordinary late start")
    a.copy().start(80).rejected("no time error")
    a.copy().en_airt(0).end(35).start(80, flt_id=5).rejected("no skip")
    a.copy().en_airt(0).end(35).late("an ordinary late start")


@situation("AMB-50")
def skip_blocked(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).dis_irt(2, v.ob).clock(v.point + 30000 * MS)
    a.copy().runs(80, flt_id=5, error_info=bit(v.ob)).wait(99).tick().accepted("OB 80, no catch-up")
    a.copy().wait(v.latency + 9).tick().accepted("or silently used up")
    a.copy().runs(80).start().rejected("blocked: no catch-up")
    a.copy().start().rejected("blocked")
    v.log(readings={"AMB-50": "b"}).armed(v.point, 0x201).dis_irt(2, v.ob).clock(v.point + 30000 * MS).start(
        80
    ).rejected("AMB-50 b: silent")
    v.log(readings={"AMB-50": "a"}).armed(v.point, 0x201).dis_irt(2, v.ob).clock(v.point + 30000 * MS).late(
        "AMB-50 a: OB 80"
    )
    b = a.copy().wait(v.latency + 9).en_irt(2, v.ob).until(v.point + MINUTE)
    b.copy().runs().accepted("goes on with the next point", "IRT-18")
    b.late("goes on with the next point", "IRT-18")


@situation("AMB-51")
def skip_missing(v: Variant) -> None:
    a = v.log([1, 80, 85]).armed(v.point).clock(v.point + MINUTE)
    a.copy().runs(80, flt_id=5, error_info=bit(v.ob)).runs(85).accepted("OB 80, then OB 85 in place of the catch-up")
    a.copy().runs(80).late("OB 85 in place of the catch-up")
    a.copy().start(85).rejected("OB 80 first")
    a.copy().late("OB 80 is owed", "CLK-02")
    v.log([1, 80, 85], readings={"AMB-51": "b"}).armed(v.point).clock(v.point + MINUTE).start(80).rejected(
        "AMB-51 b: OB 85 only"
    )
    v.log([1, 80]).armed(v.point).clock(v.point + MINUTE).runs(80).stop(0x456D).accepted(
        "no OB 85: STOP at the catch-up", "OBS-21"
    )
    v.log([1, 80]).armed(v.point).clock(v.point + MINUTE).runs(80).late("no OB 85: STOP at the catch-up", "OBS-21")


@situation("AMB-52")
def skip_running(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start().wait(100).clock(v.point + MINUTE + 5000 * MS)
    a.copy().runs(80, flt_id=5).wait(5).end().runs().tick().accepted("a catch-up of its own")
    a.copy().runs(80, flt_id=5).wait(5).end().wait(99).tick().accepted("or merged")
    a.copy().late("OB 80 is owed", "CLK-02")
    a.copy().runs(80, ms=1).end().runs(ms=1).start().rejected("one catch-up at most", "CLK-03")
    a.copy().start(80, flt_id=2).rejected("a skip, no overlap", "OBS-30")
    v.log(readings={"AMB-52": "b"}).armed(v.point, 0x201).until(v.point).start().wait(100).clock(
        v.point + MINUTE + 5000 * MS
    ).runs(80).end().start().rejected("AMB-52 b: merged")


@situation("AMB-53")
def skip_startup(v: Variant) -> None:
    a = v.log(mode="STARTUP").armed(v.point).wait(10).clock(v.point + MINUTE)
    a.copy().wait(99).run().runs().accepted("no OB 80: a deferred run")
    a.copy().runs(80, flt_id=5, priority=28).wait(99).run().runs().accepted("or OB 80 with class 28, catch-up in RUN")
    a.copy().start().rejected("no OB 1x in STARTUP", "TINT-13")
    a.copy().wait(99).run().late("the run is owed in RUN", "TINT-13")
    a.copy().start(80, priority=26).rejected("28 in STARTUP", "OBS-43")
    b = v.log().armed(v.point).hold().wait(9).clock(v.point + MINUTE).wait(9).release()
    b.copy().runs(80, flt_id=6).accepted("part of fault 06")
    b.copy().runs(80, flt_id=5).runs().accepted("or 05 after release")
    b.copy().late("one of them is owed")
    b.copy().start(80, flt_id=2).rejected("one of them", "OBS-30")


@situation("CLK-08")
def forward_boundaries(v: Variant) -> None:
    b, to, sdt, per, nxt = [
        ("2027-02-27T12:00:30", "2027-03-01T12:00:00", "2027-01-31T06:00", 0x2001, "2027-03-31T06:00"),
        ("2028-02-28T12:00:30", "2028-03-01T12:00:00", "2024-02-29T06:00", 0x1801, None),
        ("2089-11-30T12:00:30", "2089-12-31T12:00:00", "2089-01-28T13:00", 0x1401, None),
        ("2026-03-28T12:00:30", "2026-03-30T12:00:00", "2026-03-29T02:30", 0x1001, "2026-03-31T02:30"),
    ][v.number]
    first = moment(["2027-02-28T06:00", "2028-02-29T06:00", "2089-12-28T13:00", "2026-03-29T02:30"][v.number])
    a = v.log(begin=moment(b)).set_tint(sdt, per).act_tint().clock(moment(to))
    a.copy().runs(80, flt_id=5).runs(time=iso(first), period=per).accepted(
        "first skipped point over a month's end", "CLK-07"
    )
    a.copy().runs(80).start(time=iso(first + DAY)).rejected("first skipped point over a month's end", "CLK-07")
    a.copy().late("a point was skipped", "CLK-02")
    if nxt:
        c = a.copy().runs(80).runs().until(moment(nxt))
        c.copy().runs().accepted("the next point after the new time")
        c.late("the next point after the new time")


@situation("CLK-02")
def forward_no_point(v: Variant) -> None:
    a = v.log().armed(v.point + 2 * HOUR, 0x401) if v.number != 2 else v.log().armed(v.point + HOUR, 0x401)
    a.clock(v.point + 30 * MINUTE)
    a.copy().start(80).rejected("no point in between")
    a.copy().wait(v.latency + 9).tick().accepted("no point in between")
    b = v.log().armed(v.point).until(v.point).runs().wait(9).clock(v.point + MINUTE)
    b.copy().start(80).rejected("used up before the change")
    b.wait(v.latency + 9).tick().accepted("used up before the change")
    c = v.log().set_tint(v.point - 5 * MINUTE, 0x201).act_tint(0).clock(v.point - MS).wait(1)
    c.copy().runs().accepted("the point after the new time")
    c.late("the point after the new time")


@situation("CLK-03")
def two_jumps(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x201)
        .clock(v.point + 30000 * MS)
        .start(80, flt_id=5)
        .clock(v.point + MINUTE + 30000 * MS)
    )
    a.copy().wait(2).end(80).runs(80, flt_id=5).runs().accepted("a second skip inside OB 80: a second OB 80")
    a.copy().wait(2).end(80).late("a second OB 80 is owed", "CLK-02")
    b = (
        v.log()
        .armed(v.point, 0x201)
        .clock(v.point + 30000 * MS)
        .runs(80)
        .runs()
        .wait(5)
        .clock(v.point + MINUTE + 30000 * MS)
    )
    b.copy().runs(80, flt_id=5, error_info=bit(v.ob)).runs().accepted("two changes, two OB 80", "CLK-02")
    b.late("two changes, two OB 80", "CLK-02")
    c = v.log().armed(v.point).clock(v.point + MINUTE).clock(v.point - 10000 * MS)
    c.copy().runs(80).runs().until(v.point).start().rejected(
        "forward and back at once: the catch-up used it up", "CLK-13"
    )


@situation("CLK-01")
def jump_without_event(v: Variant) -> None:
    begun = v.log()
    begun.with_up = True
    begun.tick().wait(1000)
    a = begun.copy()
    a.clock_now += 5000 * MS
    a.tick().rejected("the clock jumped against up without a clock event")
    b = begun.copy()
    b.clock_now += 1000 * MS
    b.tick().accepted("one second of tolerance")
    c = begun.copy()
    c.clock_now -= 500 * MS
    c.tick().accepted("one second of tolerance")
    d = begun.copy().wait(1000000)
    d.clock_now += 10900 * MS
    d.tick().accepted("1 % and one second")
    e = begun.copy().wait(1000000)
    e.clock_now += 12000 * MS
    e.tick().rejected("more than 1 % and one second")
    g = begun.copy().tick()
    g.clock_now -= MS
    g.up += 1
    g.tick().unusable("at runs backward without a clock event")
    h = v.log(records=["call", "ob", "mode", "interrupt", "load"])
    h.with_up = True
    h.tick()
    h.wait(1000).clock_now += 5000 * MS
    h.tick().accepted("clock is not recorded: set unseen")


@situation("CLK-16")
def set_sw(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point)
        .until(v.point)
        .start()
        .wait(2)
        .clock(v.point + HOUR)
        .set_tint(v.point + 2 * HOUR if v.number != 2 else v.point + 80 * MINUTE)
        .act_tint(0)
        .wait(2)
        .end()
    )
    p = v.point + 2 * HOUR if v.number != 2 else v.point + 80 * MINUTE
    a.copy().wait(99).tick().accepted("the change-over moves the clock inside a once OB")
    a.copy().start(80).rejected("nothing skipped: it runs once", "CLK-02")
    a.copy().until(p).runs().accepted("the new once", "TINT-65")
    a.copy().until(p).late("the new once", "TINT-65")
    b = (
        v.log()
        .armed(v.point)
        .until(v.point)
        .start()
        .wait(2)
        .clock(v.point - HOUR)
        .set_tint(v.point)
        .act_tint(0)
        .wait(2)
        .end()
        .until(v.point)
    )
    b.copy().runs().accepted("back by an hour, set anew onto the same time", "AMB-57")
    if v.s7_300:
        b.copy().late("S7-300: served", "CLK-10")
    else:
        b.copy().wait(v.latency + 9).tick().accepted("S7-400: or the memory of the served point stays", "AMB-57")

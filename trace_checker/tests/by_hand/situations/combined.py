"""Rules that meet: series and the calendar, HOLD and overlaps, memory of served points, editions."""

from tests.by_hand.situations.builder import (
    DAY,
    HOUR,
    MINUTE,
    MS,
    REMEMBERING,
    REPEATING,
    Log,
    Variant,
    iso,
    moment,
    situation,
)


@situation("TINT-24")
def series_not_before_start(v: Variant) -> None:
    a = v.log().armed(v.point + 2 * MINUTE, 0x201)
    a.copy().until(v.point).wait(1).start().rejected("the series begins at SDT, not before")
    a.copy().until(v.point, 99).tick().until(v.point + MINUTE).tick().until(v.point + 2 * MINUTE).runs().until(
        v.point + 3 * MINUTE
    ).runs().accepted("begins at SDT")
    a.copy().until(v.point + 2 * MINUTE).runs().until(v.point + 3 * MINUTE).late("and goes on")
    b = v.log().set_tint(v.point - 43 * MINUTE, 0x401).act_tint(0).until(v.point)
    b.copy().wait(1).start().rejected("hourly at the minute of SDT", "TINT-32")
    b.until(v.point + 17 * MINUTE).runs().accepted("hourly at the minute of SDT", "TINT-32")


@situation("TINT-32")
def series_calendar(v: Variant) -> None:
    b, sdt, per, p = [
        ("2026-03-27T23:59:30", "2026-02-28T00:00", 0x1401, "2026-03-28T00:00"),
        ("2027-12-31T23:59:30", "2027-12-25T00:00", 0x1202, "2028-01-01T00:00"),
        ("2089-12-30T23:59:30", "2088-12-31T00:00", 0x1801, "2089-12-31T00:00"),
        ("2027-02-28T23:59:30", "2027-02-28T00:00", 0x1001, "2027-03-01T00:00"),
    ][v.number]
    a = v.log(begin=moment(b)).set_tint(sdt, per).act_tint().until(moment(p))
    a.copy().runs(period=per if per != 0x1202 else 0x1201).accepted("a point of the series")
    a.copy().late("a point of the series")
    c = v.log(begin=moment(b)).set_tint(sdt, [0x1801, 0x1001, 0x1401, 0x1201][v.number], 0x8091 if v.number == 2 else 0)
    c.accepted("other codes for the same date", "TINT-33")
    d = (
        v.log(begin=moment(b) - DAY)
        .set_tint(sdt if v.number != 3 else "2027-02-27T00:00", per if v.number != 3 else 0x1201)
        .act_tint()
        .until(moment(p) - DAY)
        .wait(1)
        if v.number in (0, 1)
        else None
    )
    if d:
        d.start().rejected("the day before is no point")


@situation("TINT-14")
def overlap_preempted(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start().wait(50).interrupt(35).start(35).until(v.point + MINUTE)
    a.copy().runs(80, flt_id=2).wait(5).end(35).wait(5).end().runs().accepted(
        "started and interrupted is still being processed"
    )
    a.copy().late("started and interrupted is still being processed")
    a.copy().runs(80).wait(5).end(35).start().rejected("it runs already", "OBS-02")
    b = a.copy().runs(80).wait(5).end(35).wait(5).can_tint(0).end()
    b.copy().wait(99).tick().accepted("CAN inside withdraws the waiting run", "AMB-11")
    b.start().rejected("CAN inside withdraws the waiting run", "AMB-11")


@situation("TINT-14")
def overlap_own_delay(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point)
        .start()
        .dis_airt(1)
        .dis_airt(2)
        .until(v.point + MINUTE, v.latency + 3)
    )
    a.copy().en_airt(1).wait(v.latency + 3).en_airt(0).runs(80, flt_id=2).end().runs().accepted(
        "delayed in the OB itself", "AIRT-09"
    )
    a.copy().en_airt(1).start(80).rejected("one delay left", "AIRT-03")
    a.copy().en_airt(1).en_airt(0).late("OB 80 after the last EN", "AIRT-09")
    a.copy().end().start().rejected("OB 80 goes first", "OBS-03")


@situation("OBS-11")
def two_time_errors(v: Variant) -> None:
    b = (
        v.log()
        .armed(v.point, 0x201)
        .srt_dint(31000)
        .until(v.point)
        .start()
        .wait(1000)
        .start(v.delay_ob)
        .srt_dint(59000)
        .until(v.point + MINUTE)
    )
    b.copy().start(80, flt_id=2).wait(3).end(80).start(80, flt_id=2).wait(3).end(80).accepted(
        "two overlaps, two OB 80 one after another"
    )
    b.copy().runs(80).late("the second OB 80 is owed")
    b.copy().runs(80, ms=0).runs(80, ms=0).start(80).rejected("two overlaps, not three", "OBS-30")
    b.copy().start(80).start(80).rejected("one class: no interruption", "OBS-02")


@situation("OBS-45")
def hold_running_ob(v: Variant) -> None:
    a = v.log().interrupt(35).start(35).dis_airt(1).wait(5).hold().wait(9000).release()
    a.copy().en_airt(0).end(35).accepted("the OB goes on after HOLD")
    a.copy().en_airt(0x8080).rejected("HOLD keeps the count", "AIRT-04")
    a.copy().interrupt(40).wait(v.latency + 5).start(40).rejected("HOLD keeps the delay", "AIRT-01")
    b = v.log().armed(v.point, 0x201).until(v.point).start().wait(5).hold().until(v.point + MINUTE, 9).release()
    b.copy().runs(80, flt_id=6).wait(3).end().runs().tick().accepted(
        "its own point passed in HOLD: 06, the catch-up after its end", "OBS-46"
    )
    b.copy().runs(80, flt_id=6).wait(3).end().wait(99).tick().accepted("or none", "AMB-55")
    b.copy().start(80, flt_id=2).rejected("passed in HOLD: 06", "OBS-46")
    b.copy().late("06 is owed", "OBS-46")


@situation("DINT-19")
def hold_twice(v: Variant) -> None:
    a = v.log().srt_dint(3000).wait(1000).hold().wait(50).release().wait(1000).hold().wait(7000).release().wait(1000)
    a.copy().runs(v.delay_ob).accepted("two HOLDs, 3000 ms of RUN")
    a.copy().late("two HOLDs, 3000 ms of RUN")
    b = v.log().srt_dint(3000).wait(1000).hold().wait(50).release().wait(1000).hold().wait(7000).release().wait(998)
    b.start(v.delay_ob).rejected("two HOLDs, 3000 ms of RUN")
    c = v.log().wait(5).srt_dint(1000).wait(999).hold().wait(60000).release()
    c.copy().wait(1).runs(v.delay_ob).accepted("one millisecond was left")
    c.copy().state(v.delay_ob, left=1).accepted("one millisecond was left", "DINT-17")
    c.copy().wait(1).late("one millisecond was left")


@situation("OBS-44")
def hold_due_before(v: Variant) -> None:
    a = v.log(latency_ms=50).interrupt(35).wait(2).hold().wait(20000).release()
    a.copy().runs(35).accepted("requested before HOLD: runs after it")
    a.copy().start(80).rejected("no time-of-day point passed", "OBS-46")
    b = v.log(latency_ms=50).armed(v.point).until(v.point, 2).hold().wait(20000).release()
    b.copy().runs().accepted("due before HOLD: pending, runs after it")
    b.copy().start(80, flt_id=6).rejected("its point did not pass in HOLD", "OBS-46")


@situation("OBS-59")
def points_in_stop(v: Variant) -> None:
    s7 = {"tod": {str(v.ob): {"execution": "minute", "start": iso(v.point - 5 * MINUTE)[:16], "active": True}}}
    a = v.log(step7=s7).stop().until(v.point + MINUTE, 20000).restart().wait(50).run()
    a.copy().wait(v.latency + 9).tick().until(v.point + 2 * MINUTE).runs().accepted(
        "points passed in STOP are not caught up"
    )
    a.copy().start().rejected("points passed in STOP are not caught up")
    a.copy().start(80).rejected("no time error for points in STOP", "OBS-30")
    a.copy().until(v.point + 2 * MINUTE).late("the series goes on", "TINT-09")
    b = v.log(step7=s7).stop().wait(5).clock(v.point + MINUTE + 20000 * MS).wait(5).restart().wait(50).run()
    b.copy().start(80).rejected("a clock set in STOP skips nothing", "CLK-02")
    b.copy().wait(v.latency + 9).tick().until(v.point + 2 * MINUTE).runs().accepted(
        "a clock set in STOP skips nothing", "CLK-02"
    )


@situation("OBS-52")
def pending_at_stop(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point)
        .srt_dint(29990)
        .until(v.point, -20)
        .interrupt(40)
        .start(40)
        .wait(5)
        .interrupt(35)
        .until(v.point, 5)
        .stop()
        .wait(20)
        .restart()
        .wait(5)
        .run()
    )
    for o in (v.ob, v.delay_ob, 35):
        a.copy().start(o).rejected("a restart discards what was pending")
    a.copy().wait(v.latency + 50).tick().accepted("a restart discards what was pending")
    a.copy().end(40).rejected("the stack is gone", "OBS-41")


@situation("CLK-10")
def back_twice(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).runs().wait(5000).clock(v.point - 5000 * MS).until(v.point)
    a = a.runs() if v.s7_300 else a.tick()
    a.wait(5000).clock(v.point - 5000 * MS).until(v.point)
    if v.s7_300:
        a.copy().runs().accepted("S7-300: a third time")
        a.copy().late("S7-300: a third time")
    else:
        a.copy().wait(99).tick().accepted("S7-400: once is enough", "CLK-09")
        a.copy().start().rejected("S7-400: once is enough", "CLK-09")


@situation("CLK-09")
def back_long(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201)
    for k in range(3):
        a.until(v.point + k * MINUTE).runs()
    a.wait(1000).clock(v.point + 30000 * MS)
    if v.s7_300:
        a.copy().until(v.point + MINUTE).runs().until(v.point + 2 * MINUTE).runs().until(
            v.point + 3 * MINUTE
        ).runs().accepted("S7-300: both repeated points again", "CLK-10")
        a.copy().until(v.point + MINUTE).runs().until(v.point + 2 * MINUTE).late(
            "S7-300: both repeated points again", "CLK-10"
        )
    else:
        a.copy().until(v.point + MINUTE, 99).tick().until(v.point + 2 * MINUTE, 99).tick().until(
            v.point + 3 * MINUTE
        ).runs().accepted("neither of the repeated points")
        a.copy().until(v.point + 2 * MINUTE).start().rejected("neither of the repeated points")
        a.copy().until(v.point + 3 * MINUTE).late("the first new point")


@situation("CLK-09")
def back_onto(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).runs().wait(5000).clock(v.point)
    if v.s7_300:
        a.copy().runs().accepted("set back exactly onto the point: reached again", "CLK-10")
        a.copy().late("set back exactly onto the point: reached again", "AMB-37")
    else:
        a.copy().start().rejected("served already")
        a.copy().wait(99).tick().accepted("served already")
    b = v.log().armed(v.point, 0x201).until(v.point).runs().wait(5000).clock(v.point + MS)
    b.copy().start().rejected("the point lies before the new time")
    b.copy().until(v.point + MINUTE).runs().accepted("the point lies before the new time")


@situation("AMB-57", REMEMBERING)
def back_keeps_to_one(v: Variant) -> None:
    def again(log: Log, runs: bool) -> Log:
        log.set_tint(v.point, 0x201).act_tint(0).until(v.point)
        log = log.runs() if runs else log.wait(v.latency + 5).tick()
        return log.until(v.point, 9000).clock(v.point - 5000 * MS)

    a = v.log().armed(v.point, 0x201).until(v.point).runs().until(v.point, 9000).clock(v.point - 5000 * MS)
    for x in (True, False):
        again(again(a.copy(), x), x).accepted("one reading throughout the log")
    b = again(a.copy(), True).set_tint(v.point, 0x201).act_tint(0).until(v.point)
    b.late("the memory was gone the first time: the same throughout")
    c = again(a.copy(), False).set_tint(v.point, 0x201).act_tint(0).until(v.point)
    c.start().rejected("the memory stayed the first time: the same throughout")


@situation("AMB-56", REMEMBERING)
def back_unserved_keeps(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x201)
        .armed(v.point, 0x201, v.other)
        .dis_irt(1, 10)
        .until(v.point, 5000)
        .en_irt(1, 10)
        .clock(v.point - 5000 * MS)
        .until(v.point)
    )
    a.copy().runs().runs(v.other).accepted("both lost points served when passed")
    a.copy().wait(v.latency + 5).tick().accepted("neither")
    a.copy().runs().late("one reading throughout: the other OB is owed")
    a.copy().start(80).rejected("backward is no time error", "CLK-09")


@situation("AMB-11")
def one_way_for_all_obs(v: Variant) -> None:
    o = [1, 20, 21, 22, 23, 35, 40, 80, 85]
    a = v.log(o).srt_dint(50, ob=20).srt_dint(60, ob=22).wait(40).interrupt(40).start(40).wait(60)
    a.copy().can_dint(0, 20).can_dint(0, 22).end(40).wait(99).tick().accepted("both withdrawn")
    a.copy().can_dint(0x80A0, 20).can_dint(0x80A0, 22).end(40).runs(22).runs(20).accepted("both kept")
    a.copy().can_dint(0, 20).can_dint(0x80A0, 22).rejected("the same throughout a log, whatever the OB")
    a.copy().can_dint(0x80A0, 22).can_dint(0, 20).rejected("the same throughout a log, whatever the OB")
    a.copy().can_dint(None, 20).end(40).runs(22, ms=1).start(20).accepted("null: kept")
    a.copy().can_dint(None, 20).end(40).runs(22).wait(99).tick().accepted("null: withdrawn")
    a.copy().can_dint(None, 20).can_dint(0, 22).end(40).start(20).rejected(
        "withdrawn for the one, withdrawn for the other"
    )


@situation("OBS-05", REMEMBERING)
def tod_classes_differ(v: Variant) -> None:
    a = (
        v.log(priority={str(v.other): 9})
        .armed(v.point)
        .armed(v.point + MINUTE, 0, v.other)
        .until(v.point)
        .start()
        .until(v.point + MINUTE)
    )
    a.copy().runs(v.other, priority=9).end().accepted("OB 1x of another class interrupts")
    a.copy().late("OB 1x of another class interrupts")
    b = (
        v.log(priority={str(v.ob): 12})
        .armed(v.point)
        .until(v.point, -50)
        .interrupt(35)
        .start(35)
        .until(v.point, v.latency)
    )
    b.copy().start().rejected("class 12 is OB 35's own", "OBS-02")
    b.copy().wait(3).end(35).runs(priority=12).accepted("class 12 is OB 35's own", "OBS-02")
    c = (
        v.log(priority={str(v.ob): 12})
        .interrupt(40)
        .start(40)
        .armed(v.point)
        .until(v.point, 5)
        .interrupt(35)
        .wait(v.latency + 5)
        .end(40)
    )
    c.copy().runs().runs(35).accepted("one class: in order of start events", "OBS-02")
    c.copy().start(35).rejected("one class: in order of start events", "OBS-02")


@situation("OBS-05", REMEMBERING)
def error_ob_low(v: Variant) -> None:
    a = v.log([1, 35, 40, 80, 82, 85], priority={"82": 5}).interrupt(35).start(35).interrupt(82).wait(v.latency)
    a.copy().start(82).rejected("OB 82 in class 5 does not interrupt OB 35", "OBS-01")
    a.copy().wait(4).end(35).runs(82, priority=5).accepted("its class is 5")
    a.copy().wait(4).end(35).start(82, priority=25).rejected("its class is 5")
    b = v.log([1, 35, 40, 80, 85], priority={"82": 5}).interrupt(35).start(35).interrupt(82)
    b.copy().stop().accepted("missing OB 82: STOP", "OBS-23")


@situation("IRT-11")
def class_members(v: Variant) -> None:
    obs = [1, 30, 38, 40, 47, 55, 57, 60, 70, 72, 80, 81, 82, 85, 87]
    for c, mem, out in (
        (30, (30, 38), 40),
        (40, (40, 47), 30),
        (50, (55, 57), 60),
        (60, (60,), 70),
        (70, (70, 72), 81),
        (80, (81, 82, 87), 72),
    ):
        a = v.log(obs).dis_irt(1, c)
        for m in mem:
            a.interrupt(m)
        a.copy().wait(v.latency + 5).tick().accepted(f"the members of class {c}")
        a.copy().start(mem[-1]).rejected(f"the members of class {c}")
        if v.number == 0:
            a.copy().interrupt(out).late(f"no member of class {c}")
        else:
            a.copy().interrupt(out).runs(out).accepted(f"no member of class {c}")


@situation("TINT-70")
def status_combined(v: Variant) -> None:
    a = v.log([1, 35, 80, 85, 100], mode="STARTUP").armed(v.point).dis_irt(1, 10)
    a.copy().qry_tint(0x07).accepted("STARTUP, blocked, active, not loaded")
    a.copy().qry_tint(0x17).rejected("not loaded", "TINT-76")
    a.copy().qry_tint(0x06).rejected("STARTUP", "TINT-72")
    b = v.log(mode="STARTUP").srt_dint(9000).dis_irt(0x81, 20)
    b.copy().qry_dint(0x17).accepted("STARTUP, blocked, active, loaded", "DINT-16")
    b.copy().run().qry_dint(0x16).accepted("RUN", "DINT-16")
    b.copy().run().qry_dint(0x17).rejected("RUN", "DINT-16")
    (
        v.log()
        .qry_tint(0x10)
        .set_tint()
        .qry_tint(0x10)
        .act_tint()
        .qry_tint(0x14)
        .can_tint()
        .qry_tint(0x10)
        .dis_irt(0)
        .qry_tint(0x12)
        .en_irt(2, v.ob)
        .qry_tint(0x10)
        .qry_tint(0x12, v.other)
        .accepted("a query changes nothing")
    )
    v.log().armed().qry_tint(0x14).qry_tint(0x14).qry_tint(0x14).until(v.point).runs().accepted(
        "a query changes nothing"
    )
    v.log().armed(v.point).qry_tint(0x14).until(v.point).late("a query changes nothing")


@situation("AMB-08")
def once_lifecycle(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point).runs().set_tint(v.point + 2 * MINUTE)
    a.copy().act_tint(0).can_tint(0).set_tint(v.point + 2 * MINUTE).until(v.point + 2 * MINUTE, 9).tick().accepted(
        "set, activated, cancelled, set"
    )
    a.copy().act_tint(0).can_tint(0).set_tint(v.point + 2 * MINUTE).until(v.point + 2 * MINUTE).start().rejected(
        "set again, not activated", "TINT-05"
    )
    a.copy().until(v.point + 2 * MINUTE, 1).act_tint(0x80A1).set_tint(v.point + 3 * MINUTE).act_tint(0).until(
        v.point + 3 * MINUTE
    ).runs().accepted("missed and set anew")
    b = v.log([1, 80, 85]).armed(v.point).until(v.point).runs(85)
    b.copy().act_tint(0x80A0).accepted("a missing OB counts as called", "AMB-46")
    b.copy().act_tint(0).rejected("a missing OB counts as called", "AMB-46")
    b.copy().event("load", ob=v.ob).start().rejected("used up", "AMB-46")


@situation("AIRT-02")
def delayed_kept_long(v: Variant) -> None:
    a = (
        v.log([1, v.ob, v.delay_ob, 35, 40, 60, 80, 82, 85])
        .interrupt(40)
        .start(40)
        .dis_airt(1)
        .interrupt(60)
        .wait(5)
        .interrupt(82)
        .wait(30000)
    )
    if v.s7_300:
        a.copy().en_airt(0).runs(82).runs(60).accepted("kept for half a minute")
    else:
        a.copy().en_airt(0).runs(60).runs(82).accepted("both class 25: in order of their events")
    a.copy().en_airt(0).start(60 if v.s7_300 else 82).rejected("highest class first, then the older", "OBS-03")
    a.copy().en_airt(0).late("kept for half a minute")
    b = a.copy().stop().wait(5).restart().wait(5).run()
    b.copy().start(60).rejected("a restart discards them", "OBS-52")


@situation("AIRT-04")
def delay_in_error_ob(v: Variant) -> None:
    a = (
        v.log([1, v.ob, v.delay_ob, 35, 40, 72, 80, 82, 85])
        .armed(v.point)
        .clock(v.point + MINUTE)
        .start(80)
        .dis_airt(1)
        .interrupt(72)
        .wait(v.latency + 5)
    )
    a.copy().start(72).rejected("delayed in OB 80 too", "AIRT-01")
    a.copy().en_airt(0).runs(72).end(80).runs().accepted("delayed in OB 80 too", "AIRT-08")
    a.copy().end(80).runs(72).runs().accepted("OB 80's end releases")
    a.copy().end(80).start().rejected("OB 72 first", "OBS-03")
    b = v.log([1, v.delay_ob, 35, 80, 85]).armed(v.point).until(v.point).start(85).dis_airt(1).dis_airt(2).end(85)
    b.copy().en_airt(0x8080).accepted("the count ends with OB 85")
    b.en_airt(1).rejected("the count ends with OB 85")


@situation("AMB-49")
def ob80_deleted_under_delay(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point)
        .start()
        .dis_airt(1)
        .until(v.point + MINUTE, 5)
        .event("delete", ob=80)
        .wait(50)
        .en_airt(0)
    )
    a.copy().stop(0x4568).accepted("OB 80 gone when it would be called", "AMB-66")
    a.copy().late("OB 80 gone when it would be called", "AMB-66")
    a.copy().start(80).rejected("not loaded", "OBS-22")
    b = (
        v.log([1, v.ob, 85])
        .armed(v.point, 0x201)
        .until(v.point, -9)
        .event("load", ob=80)
        .until(v.point)
        .start()
        .until(v.point + MINUTE)
    )
    b.copy().runs(80).accepted("loaded in time", "OBS-22")
    b.stop(0x4568).rejected("loaded in time", "OBS-22")


@situation("CLK-03")
def catchup_blocked_by_class(v: Variant) -> None:
    a = v.log().interrupt(35).start(35).armed(v.point).clock(v.point + MINUTE)
    a.copy().runs(80).start().rejected("OB 35 still runs", "OBS-01")
    a.copy().runs(80).wait(v.latency + 50).end(35).runs().accepted("the catch-up waits for OB 35")
    a.copy().runs(80).wait(v.latency + 50).end(35).late("the catch-up waits for OB 35")
    a.copy().runs(80).wait(5).can_tint(0).end(35).wait(99).tick().accepted(
        "CAN after OB 80 withdraws a pending catch-up", "AMB-11"
    )
    a.copy().runs(80).wait(5).can_tint(0).end(35).start().rejected(
        "CAN after OB 80 withdraws a pending catch-up", "AMB-11"
    )
    b = v.log().interrupt(35).start(35).dis_airt(1).armed(v.point).clock(v.point + MINUTE).wait(v.latency + 9)
    b.copy().start(80).rejected("OB 80 is delayed", "OBS-33")
    b.copy().en_airt(0).runs(80, flt_id=5).end(35).runs().accepted("OB 80 is delayed", "OBS-33")
    b.copy().end(35).start().rejected("OB 80 first", "CLK-03")


@situation("CLK-13")
def once_catchup(v: Variant) -> None:
    a = v.log().armed(v.point).clock(v.point + MINUTE).start(80, flt_id=5)
    a.copy().act_tint(None).end(80).runs(ms=1).start().rejected("once")
    b = a.copy().set_tint(v.point + 2 * MINUTE).end(80)
    b.copy().wait(99).tick().act_tint(0).until(v.point + 2 * MINUTE).runs().accepted(
        "set anew in OB 80, activated later"
    )
    b.copy().until(v.point + 2 * MINUTE).start().rejected("set anew, not activated", "TINT-05")
    c = a.copy().wait(5).end(80).start(period=0, time=iso(v.point))
    c.copy().armed(v.point + 3 * MINUTE).end().until(v.point + 3 * MINUTE).runs().accepted(
        "armed anew inside the catch-up", "TINT-65"
    )
    c.copy().end().until(v.point + MINUTE + 30000 * MS).act_tint(0x80A0).accepted("cancelled afterwards")


@situation("AMB-71")
def once_inside_readings(v: Variant) -> None:
    for rd, inside in (("a", 0x10), ("b", 0x10), ("c", 0x14)):
        a = v.log(readings={"AMB-71": rd}).armed(v.point).until(v.point).start()
        a.copy().qry_tint(inside).end().accepted(f"AMB-71 {rd} inside the OB")
        a.copy().qry_tint(inside ^ 4).rejected(f"AMB-71 {rd} inside the OB")
        a.copy().end().qry_tint(0x14).rejected("over after the OB's end under each")
    v.log(readings={"AMB-71": "a"}).armed(v.point).until(v.point).start().act_tint(0x80A0).can_tint(
        0x80A0
    ).end().accepted("cancelled at the start")
    v.log(readings={"AMB-71": "a"}).armed(v.point).until(v.point).start().act_tint(0).rejected("cancelled at the start")
    v.log(readings={"AMB-71": "c"}).armed(v.point).until(v.point).start().can_tint(0).end().accepted(
        "cancelled at the end"
    )
    v.log(readings={"AMB-71": "c"}).armed(v.point).until(v.point).start().can_tint(0x80A0).rejected(
        "cancelled at the end"
    )
    v.log(readings={"AMB-71": "c"}).armed(v.point).until(v.point).start().act_tint(0x80A1).end().accepted(
        "runs and counts as active: 80A1 or 0000", "AMB-60"
    )
    v.log(readings={"AMB-71": "c"}).armed(v.point).until(v.point).start().act_tint(0x80A0).rejected(
        "it is still set", "AMB-60"
    )


@situation("AMB-10")
def act_twice_back(v: Variant) -> None:
    if v.s7_300:
        v.log(readings={"AMB-10": "b"}).armed(v.point, 0x201).act_tint(0).until(v.point).runs().accepted(
            "ACT twice: the same result for a periodic one"
        )
        v.log(readings={"AMB-10": "b"}).armed(v.point, 0x201).act_tint(0).until(v.point).late(
            "ACT twice: the same result for a periodic one"
        )
        return
    a = (
        v.log()
        .armed(v.point, 0x201)
        .until(v.point)
        .runs()
        .wait(5000)
        .clock(v.point - 5000 * MS)
        .act_tint(0)
        .until(v.point)
    )
    a.copy().wait(99).tick().accepted("a second ACT has no effect: not served again")
    a.copy().start().rejected("a second ACT has no effect: not served again")


@situation("AMB-40", REPEATING)
def back_all_at_once(v: Variant) -> None:
    a = v.log(readings={"AMB-40": "b"}).armed(v.point + 5 * MINUTE, 0x201).wait(5000).clock(v.begin)
    a.copy().runs().accepted("AMB-40 b: every TOD OB, at once")
    a.copy().late("AMB-40 b: every TOD OB, at once")
    b = v.log(profile="2006").armed(v.point + 5 * MINUTE, 0x201).wait(5000).clock(v.begin)
    b.copy().runs().accepted("edition 2006 prints AMB-40 b")
    b.late("edition 2006 prints AMB-40 b")
    c = v.log().armed(v.point + 5 * MINUTE, 0x201).wait(5000).clock(v.begin)
    c.copy().start().rejected("the default: when its point passes")
    c.wait(v.latency + 9).tick().accepted("the default: when its point passes")


@situation("PROFILE")
def profiles(v: Variant) -> None:
    for p, w1, w2 in (("1997", 0, 0x8092), ("2006", 0x8092, 0), ("2010", 0x8092, 0)):
        v.log(profile=p).set_tint(v.point, 0x1201, w1).set_tint(v.point, 0x1202, w2).accepted(
            "the weekly code that the edition prints", "AMB-01"
        )
        v.log(profile=p).set_tint(v.point, 0x1201, 0x8092 - w1).rejected(
            "the weekly code that the edition prints", "AMB-01"
        )
        v.log(profile=p, readings={"AMB-01": "c"}).set_tint(v.point, 0x1201, 0).set_tint(v.point, 0x1202, 0).accepted(
            "a letter in readings goes first", "AMB-01"
        )
    for p, r in (("1997", 0x80A1), ("2006", 0x80A1), ("2010", 0)):
        v.log(profile=p).set_tint(v.point - HOUR, 0x201, r).accepted(
            "80A1 for a periodic one in the past by edition", "AMB-02"
        )
        v.log(profile=p).set_tint(v.point - HOUR, 0x201, 0x80A1 - r).rejected(
            "80A1 for a periodic one in the past by edition", "AMB-02"
        )
    for p, st in (("1997", 0x30), ("2006", 0x30), ("2010", 0x10)):
        v.log(profile=p).qry_tint(st).accepted("bit 5 by edition", "AMB-04")
        v.log(profile=p).qry_tint(st ^ 0x20).rejected("bit 5 by edition", "AMB-04")
    for p in ("1997", "2006", "2010"):
        v.log(profile=p).armed(v.point).set_tint(v.point, 0x202, 0x8092).act_tint(0x80A0).accepted(
            "a SET that fails cancels", "AMB-20"
        )
        v.log(profile=p).armed(v.point).set_tint(v.point, 0x202, 0x8092).qry_tint(
            0x34 if p != "2010" else 0x14
        ).rejected("a SET that fails cancels", "AMB-20")
    v.log(profile="1997").set_tint(f"{v.begin.year}-01-31T05:00", 0x1401, 0x80A1 if v.begin.month > 1 else 0).accepted(
        "edition 1997 has no limit of days, and 80A1 for any past", "AMB-05"
    )
    v.log(profile="2006").set_tint(f"{v.begin.year}-01-31T05:00", 0x1401, 0x8091).accepted(
        "edition 2006 has it", "AMB-05"
    )
    v.log(profile="2006").dis_irt(1, 30).en_irt(1, 30).interrupt(35).wait(v.latency + 5).tick().accepted(
        "edition 2006: EN_IRT MODE 1 blocks", "AMB-42"
    )
    v.log(profile="2006").en_irt(1, 30).interrupt(35).start(35).rejected("edition 2006: EN_IRT MODE 1 blocks", "AMB-42")
    v.log(profile="1997").set_tint(
        v.point - 23 * HOUR if v.number != 2 else v.point - 22 * HOUR, 0x401, 0x80A1
    ).accepted("edition 1997: past", "AMB-02")
    v.log(profile="1997").armed(v.point, 0x401).until(v.point).runs().until(
        v.point + HOUR, v.latency + 9
    ).tick().accepted("edition 1997: 0401 is daily", "AMB-43")
    v.log(profile="1997").set_tint(iso(v.begin + 15000 * MS), 0, 0).act_tint(0).wait(15000).runs().accepted(
        "edition 1997 truncates nothing", "AMB-14"
    )
    v.log(profile="1997").set_tint(iso(v.begin + 15000 * MS), 0, 0x80A1).rejected(
        "edition 1997 truncates nothing", "AMB-14"
    )


@situation("DINT-02")
def dint_load_in_time(v: Variant) -> None:
    a = v.log([1, 35, 80, 85]).srt_dint(500).wait(490)
    a.copy().event("load", ob=v.delay_ob).wait(10).runs(v.delay_ob).accepted("loaded while the delay runs")
    a.copy().event("load", ob=v.delay_ob).wait(10).late("loaded while the delay runs")
    b = v.log().srt_dint(500).wait(490).event("delete", ob=v.delay_ob).wait(10)
    b.copy().runs(85).accepted("deleted while the delay runs", "DINT-09")
    b.copy().start(v.delay_ob).rejected("deleted while the delay runs", "DINT-09")
    b.copy().runs(85).srt_dint(100).event("load", ob=v.delay_ob).wait(100).runs(v.delay_ob).accepted(
        "loaded and started anew"
    )


@situation("DINT-06")
def dint_many(v: Variant) -> None:
    o = [1, 20, 21, 22, 23, 35, 80, 85]
    a = v.log(o).srt_dint(1000, 1, ob=20).wait(7).srt_dint(993, 2, ob=21).wait(93).srt_dint(900, 3, ob=22).wait(900)
    a.copy().runs(22, sign=3).runs(21, sign=2).runs(20, sign=1).accepted("three end together: highest class first")
    if v.latency:
        a.copy().start(20).start(21).start(22).end(22).end(21).end(20).accepted(
            "the lower one may start first inside the latency", "AMB-69"
        )
    a.copy().runs(22, sign=2).rejected("each has its own SIGN", "DINT-03", line=len(a.lines) + 1)
    a.copy().runs(22).runs(21).late("the last one is owed")
    b = v.log(o).srt_dint(60000, ob=20).wait(59998)
    b.copy().start(20).rejected("a minute")
    b.copy().wait(1).runs(20).accepted("a minute")
    b.copy().wait(2).late("a minute")


@situation("IRT-03")
def dis_under_delay(v: Variant) -> None:
    a = v.log().interrupt(35).start(35).dis_airt(1).interrupt(40).dis_irt(2, 40).wait(5).en_airt(0)
    a.copy().runs(40).accepted("delayed, then disabled: requested before", "AMB-72")
    a.copy().late("delayed, then disabled: requested before", "AMB-72")
    b = v.log().interrupt(35).start(35).dis_airt(1).dis_irt(2, 40).interrupt(40).wait(5).en_airt(0)
    b.copy().start(40).rejected("disabled first: lost", "IRT-04")
    b.copy().en_irt(2, 40).start(40).rejected("disabled first: lost", "IRT-04")
    b.copy().wait(v.latency + 9).tick().accepted("disabled first: lost", "IRT-04")
    c = (
        v.log()
        .dis_irt(0)
        .interrupt(35)
        .srt_dint(50)
        .armed(v.point)
        .until(v.point, 5)
        .en_irt(0)
        .wait(v.latency + 5)
        .tick()
        .accepted("all lost")
    )
    c.copy().act_tint(0x80A0).can_dint(0x80A0).accepted("all over", "AMB-12")


@situation("IRT-15")
def en_at_the_point(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).dis_irt(2, v.ob).until(v.point).en_irt(2, v.ob)
    a.copy().runs().accepted("enabled in the millisecond of the point: before or after", "FP-2")
    a.copy().wait(99).tick().accepted("enabled in the millisecond of the point: before or after", "FP-2")
    b = v.log().armed(v.point, 0x201).until(v.point).dis_irt(2, v.ob)
    b.copy().runs().accepted("disabled in the millisecond of the point", "FP-2")
    b.copy().wait(99).tick().accepted("disabled in the millisecond of the point", "FP-2")
    c = v.log().armed(v.point, 0x201).dis_irt(2, v.ob).until(v.point, -1).en_irt(2, v.ob).wait(1)
    c.late("enabled before the point")
    d = v.log().armed(v.point).until(v.point).can_tint(0)
    d.copy().start().rejected("cancelled in the millisecond of the point", "AMB-11")
    d.wait(99).tick().accepted("cancelled in the millisecond of the point")


@situation("OBS-23")
def error_ob_loaded_later(v: Variant) -> None:
    a = v.log([1, 35, 80, 85]).event("load", ob=82).interrupt(82)
    a.copy().runs(82).accepted("loaded")
    a.copy().stop(0x456D).rejected("loaded", "FP-8")
    b = v.log([1, 35, 80, 82, 85]).event("delete", ob=82).interrupt(82)
    b.copy().late("deleted: STOP")
    b.copy().stop().accepted("deleted: STOP")
    b.copy().start(82).rejected("deleted: STOP")
    c = v.log([1, 35, 80, 82, 85]).interrupt(82).start(82).event("delete", ob=82).wait(5).end(82).interrupt(82)
    c.stop().accepted("deleted while running")


@situation("OBS-21")
def both_missing(v: Variant) -> None:
    a = v.log([1, v.ob]).armed(v.point, 0x201).srt_dint(100, ob=v.delay_ob)
    a.copy().wait(100).stop(0x456D).accepted("no OB 2x, no OB 85")
    a.copy().wait(100).stop(0x4568).rejected("no time error", "OBS-22")
    b = v.log([1, 35]).interrupt(82)
    b.copy().stop().accepted("OB 82 missing")
    c = v.log([1]).armed(v.point).clock(v.point + MINUTE)
    c.copy().stop(0x4568).accepted("no OB 80: STOP first", "CLK-05")
    c.copy().stop(0x456D).rejected("OB 80 is missing first", "AMB-51")
    v.log([1, 35]).dis_irt(1, 80).armed(v.point).clock(v.point + MINUTE).wait(v.latency + 5).tick().accepted(
        "both blocked", "AMB-23"
    )


@situation("TINT-17")
def activation_in_startup_missing(v: Variant) -> None:
    a = v.log([1, 80, 85, 100], mode="STARTUP").armed(v.point).until(v.point, 50)
    a.copy().start(85).rejected("not callable in STARTUP: noticed when called", "AMB-44")
    a.copy().wait(9).run().runs(85).accepted("noticed when called", "AMB-44")
    a.copy().wait(9).run().late("noticed when called", "AMB-44")
    a.copy().event("load", ob=v.ob).wait(9).run().runs().accepted("loaded before RUN", "TINT-13")
    b = v.log([1, 80, 100], mode="STARTUP").armed(v.point).until(v.point, 50)
    b.copy().stop(0x456D).rejected("not callable in STARTUP", "AMB-44")
    b.run().stop(0x456D).accepted("no OB 85: STOP in RUN", "OBS-21")

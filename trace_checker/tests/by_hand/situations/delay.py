"""Time-delay interrupts, SFC 32 to 34."""

from datetime import timedelta

from tests.by_hand.situations.builder import HOUR, MS, VARIANTS, Variant, iso, situation

X = 0x1234


@situation("DINT-04")
def dint_dtime(v: Variant) -> None:
    for t, r in ((1, 0), (60000, 0), (0, 0x8091), (60001, 0x8091), (-5, 0x8091), (2147483647, 0x8091)):
        v.log().srt_dint(t, ret=r).accepted("DTIME 1..60000, else 8091")
        if v.number < 2:
            v.log().srt_dint(t, ret=0x8091 - r).rejected("DTIME 1..60000, else 8091")
    v.log().srt_dint("T#1m", ret=0).accepted("T#1m is 60000 ms")
    v.log().srt_dint("T#1m1ms", ret=0).rejected("60001 ms")


@situation("DINT-05")
def dint_bad_ob(v: Variant) -> None:
    b = [19, 24, 10, -1][v.number]
    v.log().srt_dint(100, ret=0x8090, ob=b).can_dint(0x8090, b).qry_dint(0, b, 0x8090).accepted("not 20..23: 8090")
    v.log().srt_dint(100, ob=b).rejected("not 20..23: 8090")
    v.log().can_dint(0x80A0, b).rejected("not 20..23: 8090", "DINT-14")
    v.log().qry_dint(0x10, b).rejected("not 20..23: 8090", "DINT-16")
    for r in (0x8090, 0x8091):
        v.log().srt_dint(0, ret=r, ob=b).accepted("two wrong operands: any code that applies", "AMB-63")
    v.log().srt_dint(0, ret=0x8090).rejected("the OB number is good", "AMB-63")
    v.log().srt_dint(100, ret=0x80A0).rejected("SRT has no 80A0", "DINT-07")


@situation("DINT-06")
def dint_exact(v: Variant) -> None:
    a = v.log().srt_dint(3000)
    a.copy().wait(2999).runs(v.delay_ob).accepted("one millisecond early is allowed")
    a.copy().wait(2998).start(v.delay_ob).rejected("two milliseconds early")
    a.copy().wait(3000).runs(v.delay_ob).accepted("on time")
    a.copy().wait(3000 + v.latency).runs(v.delay_ob).accepted("at the end of the latency")
    a.copy().wait(3000 + v.latency + 1).start(v.delay_ob).rejected("past the latency")
    a.copy().wait(3000).late("the OB is owed")


@situation("DINT-06")
def dint_one_ms(v: Variant) -> None:
    a = v.log().srt_dint(1)
    a.copy().runs(v.delay_ob).accepted("1 ms may come one early: in the same millisecond")
    a.copy().wait(1).runs(v.delay_ob).accepted("1 ms")
    a.wait(1).late("1 ms is over")


@situation("DINT-07")
def dint_restart(v: Variant) -> None:
    a = v.log().srt_dint(2000).wait(1500).srt_dint(2000, 0x77)
    a.copy().wait(500).start(v.delay_ob).rejected("the delay was overwritten")
    a.copy().wait(2000).runs(v.delay_ob, sign=0x77, dtime=2000).accepted("runs from zero again, with the new SIGN")
    a.copy().wait(2000).start(v.delay_ob, sign=X).rejected("SIGN is replaced as well", "AMB-74")
    a.copy().wait(2000).late("the new delay is over")
    a.copy().wait(2000).runs(v.delay_ob).wait(300).tick().accepted("one job, one run")
    a.copy().wait(2000).runs(v.delay_ob, ms=1).start(v.delay_ob).rejected("one job, one run")
    b = v.log(readings={"AMB-74": "b"}).srt_dint(2000).wait(10).srt_dint(300, 0x77).wait(300)
    b.copy().runs(v.delay_ob, sign=X).accepted("AMB-74 b keeps the old SIGN", "AMB-74")
    b.copy().start(v.delay_ob, sign=0x77).rejected("AMB-74 b keeps the old SIGN", "AMB-74")
    v.log(profile="2010").srt_dint(2000).wait(10).srt_dint(300, 0x77).wait(300).start(v.delay_ob, sign=0x77).rejected(
        "edition 2010 prints AMB-74 b", "AMB-74"
    )
    v.log().srt_dint(2000).wait(10).srt_dint(0, 0x77, 0x8091).wait(1990).runs(v.delay_ob, sign=X, dtime=2000).accepted(
        "a refused SRT leaves the job alone"
    )
    v.log().srt_dint(2000).wait(10).srt_dint(0, 0x77, 0x8091).wait(1990).start(v.delay_ob, sign=0x77).rejected(
        "a refused SRT leaves the job alone"
    )


@situation("DINT-08")
def dint_from_inside(v: Variant) -> None:
    a = v.log().srt_dint(500).wait(500).start(v.delay_ob).srt_dint(700, 0x99)
    a.copy().wait(1).end(v.delay_ob).wait(699).runs(v.delay_ob, sign=0x99, dtime=700).accepted(
        "started again from inside its own OB"
    )
    a.copy().wait(1).end(v.delay_ob).wait(699).late("started again from inside")
    a.copy().wait(1).end(v.delay_ob).can_dint(0).wait(800).tick().accepted("and cancelled again")
    a.copy().qry_dint(0x14).accepted("a new job runs", "DINT-16")
    a.copy().qry_dint(0x10).rejected("a new job runs", "AMB-34")
    a.copy().can_dint(0x80A0).rejected("a new job runs", "DINT-14")


@situation("DINT-10")
def dint_overlap(v: Variant) -> None:
    a = v.log().srt_dint(500).wait(500).start(v.delay_ob).srt_dint(700, 0x99).wait(700)
    a.copy().runs(80, flt_id=2, error_info=0x99, ev=0x1121 + v.delay_ob - 20).wait(9).end(v.delay_ob).wait(
        200
    ).tick().accepted("time error; the second run may be lost", "AMB-47")
    a.copy().runs(80, flt_id=2).wait(9).end(v.delay_ob).runs(v.delay_ob, sign=0x99).accepted("or follows", "AMB-47")
    a.copy().late("time error: OB 80 is owed")
    a.copy().runs(80, flt_id=2, ms=1).start(v.delay_ob).rejected("the OB still runs")
    a.copy().start(80, flt_id=2, error_info=X).rejected("ERROR_INFO is the SIGN of the requested job", "OBS-30")
    a.copy().start(80, flt_id=2, ev=0x1111).rejected("the event of the request", "OBS-30")
    a.copy().runs(80).wait(9).end(v.delay_ob).runs(v.delay_ob, ms=1).start(v.delay_ob).rejected(
        "one request, one run at most", "AMB-47"
    )
    v.log(readings={"AMB-47": "a"}).srt_dint(500).wait(500).start(v.delay_ob).srt_dint(700).wait(700).runs(80).end(
        v.delay_ob
    ).late("AMB-47 a: it follows", "AMB-47")
    v.log(readings={"AMB-47": "b"}).srt_dint(500).wait(500).start(v.delay_ob).srt_dint(700).wait(700).runs(80).end(
        v.delay_ob
    ).start(v.delay_ob).rejected("AMB-47 b: lost", "AMB-47")
    b = v.log([1, v.delay_ob]).srt_dint(500).wait(500).start(v.delay_ob).srt_dint(700).wait(700)
    b.copy().wait(v.latency).stop(0x4568).accepted("no OB 80: STOP", "AMB-07")
    b.copy().late("no OB 80: STOP", "OBS-22")
    c = (
        v.log([1, v.delay_ob], readings={"AMB-07": "b"})
        .srt_dint(500)
        .wait(500)
        .start(v.delay_ob)
        .srt_dint(700)
        .wait(700)
    )
    c.wait(v.latency + 50).tick().accepted("AMB-07 b: the CPU continues", "AMB-07")


@situation("DINT-09")
def dint_missing(v: Variant) -> None:
    a = v.log([1, 80, 85]).srt_dint(100)
    a.copy().wait(100).runs(85, flt_id=0xA2).tick().accepted("OB 85 at the call")
    a.copy().start(85).rejected("not at SRT_DINT", "AMB-06")
    a.copy().wait(100).late("OB 85 is owed")
    a.copy().wait(100).start(v.delay_ob).rejected("not loaded")
    a.copy().wait(100).runs(85).qry_dint(0).can_dint(0x80A0).accepted("the job is over", "AMB-46")
    a.copy().wait(100).runs(85, ms=1).start(85).rejected("one job, one OB 85")
    a.copy().wait(98).start(85).rejected("the job has not elapsed", "DINT-06")
    b = v.log([1, 80]).srt_dint(100).wait(100)
    b.copy().wait(v.latency).stop(0x456D).accepted("no OB 85: STOP", "OBS-21")
    b.late("no OB 85: STOP", "OBS-21")
    c = v.log([1, 80, 85], profile="2010").srt_dint(100, ret=None)
    c.copy().runs(85).wait(1).tick().accepted("edition 2010 prints OB 85 at the SRT_DINT call", "AMB-06")
    c.late("edition 2010 prints OB 85 at the SRT_DINT call", "AMB-06")


@situation("DINT-11")
def dint_startup(v: Variant) -> None:
    a = v.log(mode="STARTUP").srt_dint(100).wait(100)
    a.copy().start(v.delay_ob).rejected("DINT OBs run only in RUN", "DINT-12")
    b = a.copy().wait(700).run()
    b.copy().runs(v.delay_ob, dtime=100).accepted("the call waits for RUN")
    b.copy().late("the call waits for RUN")
    b.copy().start(85).rejected("it is loaded")
    a.copy().wait(700).srt_dint(200, 0x55).run().wait(200).runs(v.delay_ob, sign=0x55).accepted(
        "SRT on a waiting one: a new job", "AMB-11"
    )
    c = v.log(mode="STARTUP").srt_dint(100).wait(40).run().wait(60)
    c.copy().runs(v.delay_ob).accepted("the delay runs on through the change to RUN")
    c.late("the delay runs on through the change to RUN")


@situation("AMB-69", VARIANTS)
def dint_before_ob1(v: Variant) -> None:
    a = v.log([1, v.delay_ob, 80, 85, 100], mode="STARTUP", cycle=True).srt_dint(100).wait(300).end(100).run()
    a.copy().runs(v.delay_ob).start(1).accepted("before the first instruction of OB 1")
    if v.latency:
        a.copy().start(1).wait(v.latency).runs(v.delay_ob).accepted("inside the latency OB 1 may begin first")
    else:
        a.copy().start(1).runs(v.delay_ob).accepted("the order of one millisecond: OB 1's start may be logged first")
    a.copy().start(1).late("owed within the latency", "DINT-11")
    b = (
        v.log([1, v.delay_ob, 80, 85, 100], mode="STARTUP", cycle=True, readings={"AMB-69": "b"})
        .srt_dint(100)
        .wait(300)
        .end(100)
        .run()
    )
    b.copy().start(1).rejected("AMB-69 b: nothing may stand before")
    b.copy().runs(v.delay_ob).start(1).accepted("AMB-69 b")


@situation("DINT-13")
def dint_restart_clears(v: Variant) -> None:
    a = (
        v.log()
        .srt_dint(5000)
        .wait(100)
        .stop()
        .wait(100)
        .restart(["warm", "cold", "warm", "cold"][v.number])
        .wait(10)
        .run()
    )
    a.copy().wait(4790).tick().wait(300).tick().accepted("cleared by the restart")
    a.copy().wait(4790).start(v.delay_ob).rejected("cleared by the restart")
    a.copy().can_dint(0).rejected("cleared by the restart", "DINT-14")
    a.copy().qry_dint(0x14).rejected("cleared by the restart", "DINT-16")
    b = v.log().srt_dint(5000).wait(100).stop().wait(100).restart().srt_dint(300).wait(10).run()
    b.copy().wait(290).runs(v.delay_ob).accepted("started in OB 100: after the erasing", "OBS-55")
    b.wait(290).late("started in OB 100", "OBS-55")


@situation("DINT-14")
def dint_cancel(v: Variant) -> None:
    a = v.log().srt_dint(1000).wait(400).can_dint(0)
    a.copy().wait(700).tick().accepted("cancelled, no call")
    a.copy().wait(600).start(v.delay_ob).rejected("cancelled")
    a.copy().can_dint(0x80A0).qry_dint(0x10).accepted("no job any more")
    a.copy().can_dint(0).rejected("no job any more")
    v.log().can_dint(0).rejected("no job started")
    v.log().can_dint(0x80A0).accepted("no job started")
    v.log().srt_dint(1000).wait(998).can_dint(0x80A0).rejected("the job runs")
    a.copy().srt_dint(50).wait(50).runs(v.delay_ob).accepted("and started anew", "DINT-08")
    v.log().srt_dint(1000).can_dint(0, [21, 20, 20, 20][v.number]).rejected("another OB's job: none started")
    v.log().srt_dint(1000).wait(700).srt_dint(60001, ret=0x8091).can_dint(0).accepted("a refused SRT leaves the job")


@situation("DINT-15")
def dint_cancel_running(v: Variant) -> None:
    a = v.log().srt_dint(100).wait(100).start(v.delay_ob)
    a.copy().can_dint(0x80A0).wait(5).end(v.delay_ob).accepted("CAN once its OB has started: 80A0")
    a.copy().can_dint(0).rejected("CAN once its OB has started: 80A0")
    a.copy().end(v.delay_ob).can_dint(0x80A0).accepted("finished")
    a.copy().end(v.delay_ob).can_dint(0).rejected("finished")
    a.copy().qry_dint(0x10).accepted("running: bit 2 = 0", "AMB-34")
    a.copy().qry_dint(0x14).rejected("running: bit 2 = 0", "AMB-34")


@situation("AMB-70")
def dint_last_ms(v: Variant) -> None:
    a = v.log().srt_dint(500).wait(499)
    a.copy().can_dint(0).wait(50).tick().accepted("still started")
    a.copy().can_dint(0x80A0).runs(v.delay_ob).accepted("elapsed already")
    a.copy().qry_dint(0x14).qry_dint(0x14).accepted("still started")
    v.log().srt_dint(500).wait(498).can_dint(0x80A0).rejected("two milliseconds before the end it is started")
    a.copy().can_dint(0).start(v.delay_ob).rejected("cancelled or withdrawn", "DINT-14")
    v.log(readings={"AMB-70": "a"}).srt_dint(500).wait(499).can_dint(0x80A0).rejected("AMB-70 a: job still started")
    v.log(readings={"AMB-70": "a"}).srt_dint(500).wait(499).can_dint(0).accepted("AMB-70 a")


@situation("AMB-11")
def dint_pending_cancel(v: Variant) -> None:
    a = v.log().srt_dint(100).wait(90).interrupt(40).start(40).wait(100)
    a.copy().can_dint(0).end(40).wait(99).tick().accepted("withdrawn")
    a.copy().can_dint(0x80A0).end(40).runs(v.delay_ob).accepted("or kept with 80A0")
    a.copy().can_dint(0).end(40).start(v.delay_ob).rejected("0000 and the run does not come")
    a.copy().can_dint(0x80A0).end(40).late("80A0 and the run comes")
    for r in (0x14, 0x10):
        a.copy().qry_dint(r).accepted("bit 2 of a waiting one is 1 or 0", "AMB-34")
    b = a.copy().can_dint(0).end(40).wait(20).srt_dint(100).wait(90).interrupt(40).start(40).wait(100)
    b.copy().can_dint(0x80A0).rejected("one of two, the same throughout a log")
    b.copy().can_dint(0).end(40).wait(60).tick().accepted("the same throughout")
    c = a.copy().can_dint(0x80A0).end(40).runs(v.delay_ob).srt_dint(100).wait(90).interrupt(40).start(40).wait(100)
    c.copy().can_dint(0).rejected("one of two, the same throughout a log")
    c.copy().can_dint(0x80A0).end(40).runs(v.delay_ob).accepted("the same throughout")


@situation("AMB-11")
def dint_pending_srt(v: Variant) -> None:
    a = v.log().srt_dint(100).wait(90).interrupt(40).start(40).wait(100).srt_dint(300, 0x55)
    x = a.copy().end(40).wait(300).runs(v.delay_ob, sign=0x55)
    x.copy().tick().accepted("the new job replaces the waiting run")
    y = a.copy().end(40).runs(v.delay_ob, sign=X).wait(298).runs(v.delay_ob, sign=0x55)
    y.copy().accepted("or both runs come")
    a.copy().end(40).runs(v.delay_ob, sign=X).wait(298).late("the new job's run comes in any case")
    x.copy().srt_dint(100).wait(90).interrupt(40).start(40).wait(100).can_dint(0x80A0).rejected(
        "SRT replaced: CAN withdraws, the same throughout"
    )
    x.copy().srt_dint(100).wait(90).interrupt(40).start(40).wait(100).can_dint(0).end(40).wait(99).tick().accepted(
        "the same throughout"
    )
    y.copy().srt_dint(100).wait(90).interrupt(40).start(40).wait(100).can_dint(0).rejected(
        "SRT kept the waiting run: CAN gives 80A0, the same throughout"
    )
    if v.latency < 300:
        a.copy().end(40).wait(300).start(v.delay_ob, sign=X).rejected("replaced: the new SIGN")


@situation("DINT-18")
def dint_clock_moves(v: Variant) -> None:
    a = v.log([1, v.delay_ob, 35, 80, 85]).srt_dint(10000).wait(4000)
    for to in (v.begin - 3 * HOUR, v.begin + timedelta(seconds=20)):
        b = a.copy().clock(to)
        b.copy().wait(6000).runs(v.delay_ob).accepted("a clock change does not move a delay")
        b.copy().wait(5998).start(v.delay_ob).rejected("a clock change does not move a delay")
        b.copy().wait(6000).late("a clock change does not move a delay")
        b.copy().start(v.delay_ob).rejected("not elapsed")


@situation("DINT-19")
def dint_hold(v: Variant) -> None:
    a = v.log().srt_dint(5000).wait(2000).hold().wait(20000).release()
    a.copy().wait(3000).runs(v.delay_ob).accepted("HOLD freezes the delay")
    a.copy().wait(2998).start(v.delay_ob).rejected("HOLD freezes the delay")
    a.copy().wait(3000).late("three seconds are left after HOLD")
    v.log().srt_dint(5000).wait(2000).hold().wait(3000).start(v.delay_ob).rejected("no OB in HOLD", "OBS-45")
    v.log().srt_dint(5000).wait(2000).hold().wait(20000).stop().accepted("HOLD to STOP", "OBS-40")


@situation("DINT-20")
def dint_lost(v: Variant) -> None:
    a = v.log().dis_irt(2, v.delay_ob).srt_dint(100).wait(200).en_irt(2, v.delay_ob)
    a.copy().wait(100).tick().accepted("lost")
    a.copy().start(v.delay_ob).rejected("lost, not queued", "IRT-04")
    a.copy().can_dint(0x80A0).qry_dint(0x10).accepted("the job is over", "AMB-12")
    a.copy().can_dint(0).rejected("the job is over", "AMB-12")
    a.copy().qry_dint(0x14).rejected("the job is over", "AMB-12")
    b = v.log().dis_irt(1, 20).srt_dint(100).wait(50).en_irt(1, 20).wait(50)
    b.copy().runs(v.delay_ob).accepted("enabled again before the end: it runs", "IRT-15")
    b.late("enabled again before the end", "IRT-15")
    v.log().dis_irt(2, v.delay_ob).srt_dint(100).qry_dint(0x16).accepted("blocked and active", "IRT-17")
    v.log().dis_irt(2, v.delay_ob).srt_dint(100).qry_dint(0x14).rejected("blocked: bit 1", "IRT-17")


@situation("DINT-03")
def dint_info(v: Variant) -> None:
    a = v.log().srt_dint(1234, 0xFFFF).wait(1234)
    n = 0x21 + v.delay_ob - 20
    a.copy().runs(
        v.delay_ob, strt_info=n, sign=0xFFFF, dtime=1234, priority=v.delay_class, time=iso(a.clock_now)
    ).accepted("DTIME and SIGN appear in the start info")
    for k, x, r in (
        ("strt_info", n + 1, None),
        ("sign", 0xFFFE, None),
        ("dtime", 1233, "AMB-31"),
        ("dtime", 0, "AMB-31"),
        ("priority", 2, "OBS-04"),
        ("time", iso(a.clock_now - 2 * MS), "OBS-10"),
        ("time", iso(a.clock_now + MS), "OBS-10"),
    ):
        a.copy().start(v.delay_ob, **{k: x}).rejected(f"start info field {k}", r)


@situation("DINT-01")
def dint_classes(v: Variant) -> None:
    o = [1, 20, 21, 22, 23, 35, 80, 85]
    a = (
        v.log(o)
        .srt_dint(100, ob=20)
        .srt_dint(200, ob=21)
        .srt_dint(300, ob=22)
        .srt_dint(400, ob=23)
        .wait(100)
        .start(20)
        .wait(100)
        .start(21)
        .wait(100)
        .start(22)
        .wait(100)
        .start(23)
    )
    a.copy().end(23).end(22).end(21).end(20).accepted("classes 3, 4, 5, 6 nest")
    a.copy().end(22).rejected("the topmost ends first", "OBS-03")
    b = v.log(o).srt_dint(100, ob=23).wait(100).start(23).srt_dint(100, ob=20).wait(100 + v.latency)
    b.copy().start(20).rejected("class 3 does not interrupt class 6", "OBS-01")
    b.copy().wait(7).end(23).runs(20).accepted("after the higher one")
    b.copy().wait(7).end(23).late("after the higher one", "OBS-03")


@situation("OBS-02")
def dint_order_behind(v: Variant) -> None:
    o = [1, v.ob, 20, 21, 22, 23, 35, 80, 85]
    a = (
        v.log(o)
        .srt_dint(20, ob=20)
        .srt_dint(40, ob=22)
        .srt_dint(60, ob=21)
        .wait(10)
        .interrupt(35)
        .start(35)
        .wait(190 + v.latency)
        .end(35)
    )
    a.copy().runs(22, ms=1).runs(21, ms=1).runs(20).accepted("highest class first", "OBS-03")
    a.copy().start(20).rejected("waited longer than the latency: the highest first", "AMB-69")
    a.copy().runs(22).start(20).rejected("OB 21 goes first", "OBS-03")
    a.copy().runs(22).runs(21).late("the lowest is owed too", "OBS-03")


@situation("OBS-04")
def dint_interrupts_tod(v: Variant) -> None:
    a = v.log().armed(v.point).srt_dint(30100).until(v.point).start().wait(100)
    a.copy().runs(v.delay_ob).wait(50).end().accepted("a delay OB interrupts a time-of-day OB")
    a.copy().late("a delay OB interrupts a time-of-day OB")
    b = v.log().armed(v.point).srt_dint(29000).until(v.point, -1000).start(v.delay_ob).until(v.point, v.latency)
    b.copy().start().rejected("class 2 does not interrupt a delay OB", "OBS-01")
    b.copy().wait(5).end(v.delay_ob).runs().accepted("afterwards")
    b.copy().end(v.delay_ob).runs(v.delay_ob).rejected("the delay OB ran", "DINT-03", line=len(b.lines) + 2)


@situation("DINT-17")
def dint_left(v: Variant) -> None:
    a = v.log().srt_dint(10000).wait(4000)
    a.copy().state(v.delay_ob, active=True, left=6000, loaded=True, blocked=False).accepted("remaining milliseconds")
    a.copy().state(v.delay_ob, left=5999).accepted("as exact as DINT-06")
    a.copy().state(v.delay_ob, left=5000).rejected("remaining milliseconds")
    a.copy().state(v.delay_ob, left=6002).rejected("remaining milliseconds")
    a.copy().state(v.delay_ob, active=False).rejected("a delay runs", "OBS-60")
    a.copy().hold().wait(9000).release().state(v.delay_ob, left=6000).accepted("frozen in HOLD", "DINT-19")
    a.copy().clock(v.begin + timedelta(seconds=10)).state(v.delay_ob, left=6000).accepted(
        "no matter what the clock does", "DINT-18"
    )
    a.copy().srt_dint(7000).state(v.delay_ob, left=7000).accepted("restarted")
    a.copy().can_dint(0).state(v.delay_ob, active=False).accepted("cancelled", "OBS-60")
    a.copy().can_dint(0).state(v.delay_ob, active=True).rejected("cancelled", "OBS-60")


@situation("DINT-16")
def dint_status(v: Variant) -> None:
    a = v.log().srt_dint(9000)
    a.copy().qry_dint(0x14).accepted("active, loaded")
    for bit in (0, 1, 3, 6, 7, 9, 15):
        a.copy().qry_dint(0x14 ^ 1 << bit).rejected(f"bit {bit} is 0")
    v.log().qry_dint(0x10).accepted("loaded only")
    v.log().qry_dint(0x14).rejected("no job")
    v.log([1, 35]).srt_dint(9000).qry_dint(0x04).accepted("not loaded")
    v.log(mode="STARTUP").srt_dint(9000).qry_dint(0x15).accepted("STARTUP")
    v.log(readings={"AMB-04": "b"}).qry_dint(0x30).accepted("AMB-04 b", "AMB-04")
    v.log().dis_airt(1).qry_dint(0x12).rejected("DIS_AIRT does not show", "AIRT-13")

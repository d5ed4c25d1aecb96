"""Disabled and delayed interrupts, SFC 39 to 42."""

from tests.by_hand.situations.builder import FIRST_TWO, MINUTE, Variant, situation

EITHER = (0x8090, 0x8091)


@situation("IRT-12")
def irt_bad_mode(v: Variant) -> None:
    for m in [(3, 0x83), (0x40, 0x7F), (0xFF, 4), (0x90, 0x10)][v.number]:
        v.log().dis_irt(m, 0, 0x8091).en_irt(m, 0, 0x8091).accepted("a MODE that is none: 8091")
        v.log().dis_irt(m, 0, 0).rejected("bad MODE")
        v.log().en_irt(m, 0, 0).rejected("bad MODE", "IRT-13")
        v.log().dis_irt(m, 35, 0x8090).rejected("35 is a number that an OB has: only 8091 applies", "AMB-63")
        for r in EITHER:
            v.log().dis_irt(m, [9999, 200, -1, 333][v.number], r).accepted(
                "bad MODE and a number that no OB has: either", "AMB-63"
            )


@situation("IRT-13")
def irt_en_80(v: Variant) -> None:
    m = [0x80, 0x81, 0x82, 0x80][v.number]
    o = [0, 30, 35, 0][v.number]
    a = v.log().dis_irt(m, o).en_irt(m, o, 0x8091)
    a.copy().interrupt(35).wait(v.latency + 30).tick().accepted("EN_IRT knows no 80..82: 8091, still blocked", "AMB-76")
    a.copy().interrupt(35).start(35).rejected("EN_IRT failed: still blocked", "AMB-76")
    v.log().dis_irt(m, o).en_irt(m, o, 0).rejected("EN_IRT knows no 80..82: 8091", "AMB-76")
    b = v.log(readings={"AMB-76": "b"}).dis_irt(m, o).en_irt(m, o, 0).interrupt(35)
    b.copy().runs(35).accepted("AMB-76 b", "AMB-76")
    b.late("AMB-76 b", "AMB-76")


@situation("IRT-07")
def irt_class_numbers(v: Variant) -> None:
    a = v.log()
    for c in (10, 20, 30, 40, 50, 60, 70, 80):
        a.dis_irt(1, c).en_irt(1, c).dis_irt(0x81, c).en_irt(1, c)
    a.accepted("class numbers 10..80, whatever the CPU has", "AMB-73")
    for c in [(0, 35, 11), (90, 85, 100), (1, 72, 55), (15, 121, -10)][v.number]:
        v.log().dis_irt(1, c, 0x8090).en_irt(1, c, 0x8090).dis_irt(0x81, c, 0x8090).accepted(
            "no class number: 8090", "IRT-12"
        )
        v.log().dis_irt(1, c, 0).rejected("no class number: 8090", "AMB-73")
        v.log().en_irt(1, c, 0).rejected("no class number: 8090", "AMB-73")


@situation("IRT-08")
def irt_ob_numbers(v: Variant) -> None:
    a = v.log()
    for o in (10, 17, 20, 23, 30, 38, 40, 47, 55, 57, 60, 70, 72, 80, 81, 82, 83, 84, 85, 86, 87):
        a.dis_irt(2, o).en_irt(2, o)
    a.accepted("the OBs of IRT-11")
    for o in [(1, 9, 18, 100), (19, 24, 61, 121), (39, 48, 73, 88), (54, 58, 71, 90, 122)][v.number]:
        v.log().dis_irt(2, o, 0x8090).en_irt(2, o, 0x8090).accepted("not in the table: 8090", "AMB-73")
        v.log().dis_irt(2, o, 0).rejected("not in the table: 8090", "AMB-73")
        v.log().dis_irt(0x82, o, 0x8091).rejected("not in the table: 8090", "IRT-12")
    v.log().dis_irt(2, 0, 0x8090).accepted("0 is no OB", "IRT-12")
    v.log().dis_irt(2, 0, 0).rejected("0 is no OB", "IRT-12")


@situation("AMB-22")
def irt_mode0_ob(v: Variant) -> None:
    for m in (0, 0x80):
        v.log().dis_irt(m, 35, 0).interrupt(40).wait(v.latency + 9).tick().accepted("OB_NR is ignored with MODE 00")
        v.log().dis_irt(m, 35, 0x8090).rejected("OB_NR is ignored with MODE 00")
        v.log(readings={"AMB-22": "b"}).dis_irt(m, 35, 0x8090).accepted("AMB-22 b")
        v.log(profile="2006").dis_irt(m, 35, 0).rejected("edition 2006 prints AMB-22 b")
    v.log().dis_irt(0).en_irt(0, 77, 0).interrupt(40).runs(40).accepted("EN_IRT 0 ignores it too")


@situation("IRT-04")
def irt_lost(v: Variant) -> None:
    m, o = [(0, 0), (1, 40), (2, 40), (0x82, 40)][v.number]
    a = v.log().dis_irt(m, o).wait(5).interrupt(40).wait(20)
    a.copy().en_irt(m & 3, o).wait(v.latency + 50).tick().accepted("lost, not queued")
    a.copy().en_irt(m & 3, o).start(40).rejected("lost, not queued")
    a.copy().start(40).rejected("blocked", "IRT-01")
    b = a.copy().en_irt(m & 3, o).interrupt(40)
    b.copy().runs(40).accepted("a new event leads to its OB again", "IRT-15")
    b.late("a new event leads to its OB again", "IRT-15")


@situation("IRT-16")
def irt_flag(v: Variant) -> None:
    m, o = [(0, 0), (1, 30), (2, 35), (0x81, 30)][v.number]
    e = m & 3
    a = v.log().dis_irt(m, o).dis_irt(m, o).dis_irt(m, o).en_irt(e, o).interrupt(35)
    a.copy().runs(35).accepted("a flag, not a counter")
    a.late("a flag, not a counter")
    v.log().en_irt(e, o).en_irt(e, o).dis_irt(m, o).interrupt(35).start(35).rejected(
        "EN on an enabled one is no credit", "IRT-24"
    )
    v.log().en_irt(e, o, 0x8080).rejected("EN_IRT where nothing is disabled: 0000", "IRT-24")


@situation("AMB-21")
def irt_mixing(v: Variant) -> None:
    a = v.log().dis_irt(0).en_irt(2, 35)
    a.copy().interrupt(35).runs(35).interrupt(40).wait(v.latency + 9).tick().accepted("all, then one OB enabled")
    a.copy().interrupt(35).late("last call wins for OB 35")
    a.copy().interrupt(40).start(40).rejected("OB 40 is still blocked")
    b = v.log().dis_irt(2, 35).en_irt(1, 30).interrupt(35)
    b.copy().runs(35).accepted("EN of the class opens the OB")
    b.late("EN of the class opens the OB")
    c = v.log().dis_irt(2, 35).en_irt(1, 40).interrupt(35)
    c.copy().start(35).rejected("another class")
    d = v.log().dis_irt(1, 30).en_irt(0).dis_irt(2, 40).interrupt(35)
    d.late("class closed, all opened, another OB closed")
    e = v.log(readings={"AMB-21": "b"}).dis_irt(0).en_irt(2, 35).interrupt(35)
    e.copy().start(35).rejected("AMB-21 b: three independent levels")
    e.wait(v.latency + 5).tick().en_irt(0).interrupt(35).runs(35).accepted("AMB-21 b: all levels open")


@situation("IRT-02")
def irt_across(v: Variant) -> None:
    a = v.log().interrupt(35).start(35).dis_irt(2, 40).wait(1).end(35).wait(20).interrupt(40)
    a.copy().start(40).rejected("the block outlives the OB that made it", "IRT-03")
    a.copy().wait(v.latency + 9).tick().accepted("the block outlives the OB that made it", "IRT-03")
    v.log(cycle=True).dis_irt(2, 40).end(1).start(1).end(1).start(1).interrupt(40).start(40).rejected("across cycles")
    b = (
        v.log()
        .dis_irt(0)
        .wait(9)
        .stop()
        .wait(9)
        .restart(["warm", "warm", "cold", "cold"][v.number])
        .wait(2)
        .run()
        .interrupt(40)
    )
    b.copy().runs(40).accepted("a restart ends it", "IRT-03")
    b.late("a restart ends it", "IRT-03")
    c = v.log().dis_irt(0).hold().wait(99).release().interrupt(40)
    c.start(40).rejected("HOLD does not end it", "IRT-03")


@situation("IRT-01")
def irt_missing_blocked(v: Variant) -> None:
    a = v.log([1, 80]).dis_irt(2, v.ob).armed(v.point).until(v.point)
    a.copy().wait(v.latency + 9).tick().accepted("blocked: no OB, no default reaction")
    a.copy().stop(0x456D).rejected("no default reaction for a blocked event")
    b = v.log([1, 80, 85]).dis_irt(0x81, 10).armed(v.point).until(v.point)
    b.copy().start(85).rejected("blocked: no OB 85")
    c = v.log([1, 80]).dis_irt(2, 85).armed(v.point).until(v.point)
    c.copy().wait(v.latency + 9).tick().accepted("the priority class error is blocked: no STOP", "AMB-23")
    c.stop(0x456D).rejected("the priority class error is blocked: no STOP", "AMB-23")
    d = v.log([1, 85]).dis_irt(2, 85).armed(v.point).until(v.point)
    d.copy().start(85).rejected("OB 85 is blocked", "AMB-33")
    d.wait(v.latency + 9).tick().accepted("the event is lost", "AMB-33")
    e = v.log([1, 80], readings={"AMB-23": "b"}).dis_irt(2, 85).armed(v.point).until(v.point)
    e.late("AMB-23 b: STOP", "AMB-23")
    f = v.log([1, 80, 85]).dis_irt(2, 82).interrupt(82)
    f.wait(v.latency + 9).tick().accepted("a missing OB 82 that is blocked does not stop")


@situation("IRT-18")
def irt_tod_consumed(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).dis_irt(1, 10).until(v.point, 20).en_irt(1, 10)
    a.copy().until(v.point + MINUTE).runs().accepted("consumed; goes on with the next point")
    a.copy().wait(1).start().rejected("the point was consumed")
    a.copy().until(v.point + MINUTE).late("goes on with the next point")
    a.copy().qry_tint(0x14).accepted("still active")
    b = v.log().armed(v.point).dis_irt(1, 10).until(v.point, 20).en_irt(1, 10)
    b.copy().act_tint(0x80A0).can_tint(0x80A0).qry_tint(0x10).accepted("a once is finished", "AMB-12")
    b.copy().act_tint(0x80A1).rejected("a once is finished as after its run", "AMB-12")
    b.copy().qry_tint(0x14).rejected("a once is finished", "AMB-12")
    b.copy().can_tint(0).rejected("a once is finished", "AMB-12")
    c = v.log(readings={"AMB-12": "b"}).armed(v.point).dis_irt(1, 10).until(v.point, 20).en_irt(1, 10)
    c.copy().qry_tint(0x14).can_tint(0).accepted("AMB-12 b: still active", "AMB-12")
    c.start().rejected("AMB-12 b: still active with a past time, no call", "AMB-12")


@situation("AMB-72")
def irt_queued_before(v: Variant) -> None:
    a = v.log().interrupt(40).start(40).wait(1).interrupt(35).wait(1).dis_irt(2, 35).wait(v.latency + 9).end(40)
    a.copy().runs(35).accepted("queued before DIS_IRT: still runs")
    a.copy().late("queued before DIS_IRT: still runs")
    b = a.copy().runs(35).interrupt(35)
    b.start(35).rejected("a new one is blocked", "IRT-01")
    c = (
        v.log(readings={"AMB-72": "b"})
        .interrupt(40)
        .start(40)
        .wait(1)
        .interrupt(35)
        .wait(1)
        .dis_irt(2, 35)
        .wait(9)
        .end(40)
    )
    c.copy().start(35).rejected("AMB-72 b: dropped")
    c.wait(v.latency + 9).tick().accepted("AMB-72 b: dropped")
    d = (
        v.log()
        .armed(v.point)
        .until(v.point, -5)
        .interrupt(35)
        .start(35)
        .until(v.point, 5)
        .dis_irt(1, 10)
        .wait(9)
        .end(35)
    )
    d.copy().runs().accepted("a pending time-of-day run too")
    d.late("a pending time-of-day run too")
    e = v.log().srt_dint(50).interrupt(40).start(40).wait(60).dis_irt(0).end(40)
    e.copy().runs(v.delay_ob).accepted("a pending delay run too")
    e.late("a pending delay run too")


@situation("AMB-48")
def irt_80_blocked(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).dis_irt(2, 80).until(v.point).start().until(v.point + MINUTE).wait(v.latency + 1)
    a.copy().tick().end().runs().accepted("the later run may come")
    a.copy().tick().end().wait(99).tick().accepted("or be lost with the error")
    a.copy().start(80).rejected("OB 80 is blocked", "OBS-33")
    b = v.log([1, v.ob]).armed(v.point, 0x201).dis_irt(1, 80).until(v.point).start().until(v.point + MINUTE)
    b.copy().wait(v.latency + 9).end().accepted("no STOP for a blocked time error", "AMB-23")
    b.stop(0x4568).rejected("no STOP for a blocked time error", "AMB-23")
    c = v.log().armed(v.point).dis_irt(2, 80).clock(v.point + MINUTE)
    c.copy().runs().accepted("catch-up without OB 80")
    c.copy().wait(99).tick().accepted("or none")
    c.copy().start(80).rejected("OB 80 is blocked", "OBS-33")
    v.log(readings={"AMB-48": "a"}).armed(v.point).dis_irt(2, 80).clock(v.point + MINUTE).late("AMB-48 a: it comes")
    v.log(readings={"AMB-48": "b"}).armed(v.point).dis_irt(2, 80).clock(v.point + MINUTE).start().rejected(
        "AMB-48 b: lost"
    )


@situation("IRT-09")
def irt_5380(v: Variant) -> None:
    kinds = ["call", "ob", "clock", "mode", "interrupt", "load", "diag"]
    a = v.log(records=kinds).dis_irt([0x80, 0x81, 0x82, 0x80][v.number], [0, 30, 35, 0][v.number])
    a.copy().diag(0x5380).accepted("5380 for the call")
    a.copy().diag(0x5380).diag(0x5380).rejected("once for the call", "AMB-41")
    a.copy().late("diag is listed: the entry is owed")
    v.log(records=kinds).dis_irt(0).diag(0x5380).rejected("MODE 00 makes no 5380")
    v.log(records=kinds).dis_irt(0x83, 0, 0x8091).diag(0x5380).rejected("refused: no entry")
    a.copy().diag(0x5380).en_irt(0).diag(0x5381).accepted("no table has 5381, so no rule asks for its cause", "FP-9")
    v.log().dis_irt(0x80).diag(0x5380).accepted("an entry that has a cause")
    v.log().diag(0x5380).rejected("an entry without a cause")
    v.log(records=kinds).dis_irt(0x80).diag(0x5380).dis_irt(0x80).diag(0x5380).accepted("one each call")


@situation("IRT-20")
def irt_state_bits(v: Variant) -> None:
    a = v.log().dis_irt(0x82, 35)
    a.copy().state(35, blocked=True, entries_off=True).state(40, blocked=False, entries_off=False).accepted(
        "stored per OB"
    )
    a.copy().state(35, blocked=False).rejected("blocked", "OBS-60")
    a.copy().state(35, entries_off=False).rejected("entries are off")
    a.copy().dis_irt(2, 35).state(35, blocked=True, entries_off=False).accepted(
        "DIS 02 after 82 re-enables logging", "AMB-21"
    )
    a.copy().dis_irt(2, 35).state(35, entries_off=True).rejected("DIS 02 after 82 re-enables logging", "AMB-21")
    a.copy().en_irt(2, 35).state(35, blocked=False, entries_off=False).accepted("EN clears both", "AMB-21")
    a.copy().en_irt(2, 35).state(35, entries_off=True).rejected("EN clears both", "AMB-21")
    a.copy().stop().restart().run().state(35, blocked=False).accepted("a restart clears it", "OBS-53")


@situation("AIRT-06")
def airt_count(v: Variant) -> None:
    a = v.log().interrupt(35).start(35)
    for k in range(1, 4):
        a.dis_airt(k)
    a.copy().en_airt(2).en_airt(1).en_airt(0).en_airt(0x8080).accepted("counted up and down")
    a.copy().en_airt(3).rejected("the count still left", "AIRT-07")
    a.copy().dis_airt(3).rejected("the count after the call")
    a.copy().en_airt(2).en_airt(1).en_airt(0x8080).rejected("one is still there", "AIRT-07")
    a.copy().en_airt(2).en_airt(1).en_airt(0).en_airt(0).rejected("nothing delayed: 8080", "AIRT-07")
    v.log().en_airt(0).rejected("nothing delayed: 8080", "AIRT-07")
    v.log().dis_airt(0).rejected("the count after the call is at least 1")


@situation("AIRT-14", FIRST_TWO)
def airt_deep(v: Variant) -> None:
    n = [40, 130][v.number]
    a = v.log().interrupt(35).start(35)
    for k in range(1, n + 1):
        a.dis_airt(k)
    for k in range(n - 1, -1, -1):
        a.en_airt(k)
    a.copy().en_airt(0x8080).accepted(f"{n} deep: no limit is stated")
    b = v.log().interrupt(35).start(35)
    for k in range(1, n + 1):
        b.dis_airt(k)
    b.copy().dis_airt(n).rejected("no saturation", "AIRT-06")
    b.end(35).interrupt(35).start(35).dis_airt(1).accepted("the OB's end drops all of them", "AIRT-04")


@situation("AIRT-01")
def airt_holds(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point)
        .until(v.point)
        .start()
        .dis_airt(1)
        .srt_dint(100)
        .wait(200)
        .interrupt(35)
        .interrupt(40)
        .wait(v.latency + 5)
    )
    for o in (v.delay_ob, 35, 40):
        a.copy().start(o).rejected("held back")
    a.copy().en_airt(0).runs(40).runs(35).runs(v.delay_ob).end().accepted("processed when the delay ends", "AIRT-02")
    a.copy().end().runs(40).runs(35).runs(v.delay_ob).accepted("the OB's end releases too", "AIRT-04")
    a.copy().en_airt(0).start(35).rejected("highest class first", "AIRT-08")
    a.copy().en_airt(0).late("at once", "AIRT-08")
    a.copy().dis_airt(2).en_airt(1).start(40).rejected("only at count 0", "AIRT-03")
    a.copy().end().late("the OB's end releases", "AIRT-04")


@situation("AIRT-04")
def airt_end_resets(v: Variant) -> None:
    a = v.log().interrupt(35).start(35).dis_airt(1).dis_airt(2).end(35)
    a.copy().interrupt(35).start(35).dis_airt(1).accepted("0 at the OB's end")
    a.copy().en_airt(0x8080).accepted("0 at the OB's end")
    a.copy().en_airt(1).rejected("0 at the OB's end")
    a.copy().interrupt(35).start(35).dis_airt(3).rejected("0 at the OB's end")
    a.interrupt(40).late("0 at the OB's end")


@situation("AIRT-12")
def airt_nested_frames(v: Variant) -> None:
    a = (
        v.log()
        .armed(v.point)
        .until(v.point)
        .start()
        .dis_airt(1)
        .en_airt(0)
        .wait(5)
        .interrupt(40)
        .start(40)
        .dis_airt(1)
        .dis_airt(2)
        .end(40)
    )
    a.copy().dis_airt(1).accepted("back in the lower OB the count is 0")
    a.copy().dis_airt(3).rejected("the ended OB's count is gone")
    a.copy().en_airt(0x8080).accepted("nothing delayed")
    b = (
        v.log()
        .armed(v.point)
        .until(v.point)
        .start()
        .interrupt(35)
        .start(35)
        .dis_airt(1)
        .interrupt(40)
        .wait(v.latency + 3)
    )
    b.copy().end(35).runs(40).end().accepted("released at the end of the delaying OB")
    b.copy().end().rejected("OB 35 is on top", "OBS-03")
    b.copy().start(40).rejected("delayed", "AIRT-01")


@situation("AMB-25")
def airt_cycles(v: Variant) -> None:
    a = v.log(cycle=True).dis_airt(1)
    a.copy().dis_airt(2).end(1).start(1).dis_airt(1).accepted("the cycle's end resets")
    a.copy().end(1).start(1).dis_airt(2).rejected("the cycle's end resets")
    a.copy().dis_airt(1).rejected("every cycle boundary is logged: none here", "AIRT-06")
    b = v.log().dis_airt(1)
    b.copy().dis_airt(1).accepted("an unseen cycle boundary")
    b.copy().dis_airt(2).accepted("or none")
    b.copy().dis_airt(3).rejected("neither", "AIRT-06")
    b.copy().en_airt(0x8080).accepted("an unseen cycle boundary")
    b.copy().en_airt(0).accepted("or none")
    b.copy().en_airt(1).rejected("neither", "AIRT-07")
    c = v.log(cycle=True).dis_airt(1).interrupt(40).wait(v.latency + 20)
    c.copy().start(40).rejected("delayed in OB 1", "AIRT-01")
    c.copy().end(1).runs(40).start(1).accepted("released between OB 1's end and its next start")
    if v.latency:
        c.copy().end(1).start(1).late("released between OB 1's end and its next start")
    else:
        c.copy().end(1).wait(1).start(1).rejected("released between OB 1's end and its next start")
    d = v.log().dis_airt(1).interrupt(40).wait(v.latency + 20)
    d.copy().runs(40).accepted("an unseen cycle boundary may have released it")
    d.copy().tick().en_airt(0).runs(40).accepted("or none")
    d.copy().dis_airt(2).start(40).dis_airt(1).accepted("an unseen boundary again")
    e = v.log(cycle=True, readings={"AMB-25": "b"}).dis_airt(1)
    e.copy().end(1).start(1).dis_airt(2).accepted("AMB-25 b: the count lasts over cycles")
    e.end(1).start(1).dis_airt(1).rejected("AMB-25 b: the count lasts over cycles")


@situation("AIRT-09")
def airt_delays_80_85(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).until(v.point).start().dis_airt(1).until(v.point + MINUTE, v.latency + 10)
    a.copy().start(80).rejected("OB 80 is delayed too")
    a.copy().en_airt(0).runs(80, flt_id=2).end().runs().accepted("OB 80 after the delay")
    a.copy().en_airt(0).late("OB 80 after the delay")
    a.copy().end().start().rejected("OB 80 first, its class is higher", "OBS-03")
    a.copy().end().runs(80).runs().accepted("OB 80 first")
    b = v.log([1, 35, 80, 85]).interrupt(35).start(35).dis_airt(1).srt_dint(50).wait(90)
    b.copy().start(85).rejected("the OB 85 of a missing OB")
    b.copy().en_airt(0).wait(v.latency + 1).tick().end(35).runs(85).accepted(
        "OB 35 ranks above OB 2x: at the call", "AMB-44"
    )
    c = v.log([1, v.ob, 80, 85]).armed(v.point).until(v.point).start().dis_airt(1).srt_dint(50).wait(90)
    c.copy().en_airt(0).runs(85).accepted("the OB 85 of a missing OB")
    c.copy().en_airt(0).late("the OB 85 of a missing OB")
    c.copy().start(85).rejected("delayed", "AMB-33")


@situation("AMB-49")
def airt_no80(v: Variant) -> None:
    a = v.log([1, v.ob]).armed(v.point, 0x201).until(v.point).start().dis_airt(1).until(v.point + MINUTE)
    a.copy().wait(min(2, v.latency)).stop(0x4568).accepted("STOP at once")
    a.copy().wait(v.latency + 40).en_airt(0).stop(0x4568).accepted("or when the delay ends")
    a.copy().wait(v.latency + 40).en_airt(0).late("when the delay ends at the latest")
    v.log([1, v.ob], readings={"AMB-49": "a"}).armed(v.point, 0x201).until(v.point).start().dis_airt(1).until(
        v.point + MINUTE
    ).late("AMB-49 a: at once")
    v.log([1, v.ob], readings={"AMB-49": "b"}).armed(v.point, 0x201).until(v.point).start().dis_airt(1).until(
        v.point + MINUTE
    ).stop(0x4568).rejected("AMB-49 b: when the delay ends")
    b = v.log([1, 35, 80, 85]).interrupt(35).start(35).dis_airt(1).interrupt(82)
    b.copy().wait(v.latency + 9).en_airt(0).stop().accepted("missing OB 82 under the delay")
    b.copy().wait(v.latency + 9).en_airt(0).late("missing OB 82: STOP when the delay ends at the latest")
    b.copy().stop(0x4303).accepted("the switch is not delayed", "AIRT-11")


@situation("AIRT-08")
def airt_highest_first(v: Variant) -> None:
    a = v.log().dis_airt(1).wait(1).interrupt(35).wait(v.latency + 1).interrupt(40).wait(v.latency + 20).en_airt(0)
    a.copy().runs(40).runs(35).accepted("highest class first")
    a.copy().start(35).rejected("both waited longer than the latency: the highest first", "AMB-69")
    a.copy().tick().runs(40).accepted("the caller's calls may stand first", "AMB-69")
    b = v.log().dis_airt(1).interrupt(35).wait(v.latency + 20).en_airt(0).wait(min(1, v.latency)).interrupt(40)
    b.copy().runs(40).runs(35).accepted("the fresh OB 40 first")
    if v.latency:
        b.copy().start(35).start(40).accepted(
            "OB 40's event is younger than the latency: OB 35 may start first", "AMB-69"
        )
    else:
        b.copy().start(35).rejected("latency 0: the order of classes is strict", "AMB-69")


@situation("AIRT-10")
def airt_lower_unaffected(v: Variant) -> None:
    a = v.log().interrupt(40).start(40).dis_airt(1).interrupt(35).wait(50).en_airt(0)
    a.copy().start(35).rejected("a lower class waits in any case", "OBS-01")
    a.copy().end(40).runs(35).accepted("a lower class waits in any case", "OBS-01")
    b = v.log().interrupt(40).start(40).interrupt(35).dis_airt(1).wait(9).end(40)
    b.late("the end of the OB releases", "AIRT-04")


@situation("AIRT-05")
def airt_startup(v: Variant) -> None:
    a = v.log(mode="STARTUP").dis_airt(1).dis_airt(2).wait(5).end(100).run()
    a.copy().dis_airt(1).accepted("the startup OB's end resets", "AIRT-04")
    a.copy().dis_airt(3).rejected("the startup OB's end resets", "AIRT-04")
    a.copy().interrupt(40).late("the startup OB's end resets", "AIRT-04")
    b = v.log(mode="STARTUP").dis_airt(1).run()
    b.copy().dis_airt(1).accepted("RUN ends the startup OB", "AIRT-04")
    b.dis_airt(2).rejected("RUN ends the startup OB", "AIRT-04")
    c = v.log().interrupt(35).start(35).dis_airt(1).stop().wait(9).restart().wait(1).run()
    c.copy().en_airt(0x8080).accepted("no count survives a restart", "OBS-54")
    c.en_airt(0).rejected("no count survives a restart", "OBS-54")

"""The log format: kinds left out, values, lines that cannot be read, latency."""

import json
from typing import Any

from tests.by_hand.situations.builder import HOUR, MINUTE, MS, VARIANTS, Log, Variant, iso, situation

KINDS = ["call", "ob", "clock", "mode", "interrupt", "load"]
WITH_ENTRIES = [*KINDS, "diag"]


def no(*left_out: str) -> list[str]:
    """The kinds but some."""
    return [kind for kind in KINDS if kind not in left_out]


@situation("FP-9")
def without_call(v: Variant) -> None:
    kinds = no("call")
    a = v.log(records=kinds)
    a.copy().until(v.point).runs().accepted("what the program called is unknown")
    a.copy().wait(500).start().accepted("known limit: without calls the minute of a start is not followed", "TINT-11")
    a.copy().wait(500).runs(v.delay_ob).accepted("what the program called is unknown")
    a.copy().interrupt(40).start(40).start(35).rejected("the stack's classes hold whatever it called")
    a.copy().start(30).rejected("not loaded", "OBS-20")
    a.copy().interrupt(40).wait(v.latency + 90).tick().accepted("DIS_IRT may have blocked it")
    a.copy().stop().start(35).rejected("no OB in STOP", "OBS-41")
    a.copy().start(80, flt_id=6).rejected("no HOLD: no 06", "OBS-46")
    v.log(records=kinds, mode="STARTUP").start().rejected("no OB 1x in STARTUP", "TINT-13")
    a.copy().start(80, flt_id=1).rejected("01 has its interrupt line", "OBS-30")
    a.copy().start(85, flt_id=0xA3).rejected("A3 has its interrupt line", "OBS-20")
    a.copy().until(v.point).start(strt_info=0x12 + v.ob - 10).rejected("start info is fixed", "OBS-04")
    a.copy().until(v.point).start(priority=5).rejected("class 2", "OBS-04")
    a.copy().interrupt(35).interrupt(40).runs(40).runs(35).accepted("classes")
    v.log([1, 35], records=kinds).wait(500).stop(0x456D).accepted("an unseen SRT_DINT may have found a missing OB")


@situation("FP-9")
def without_ob(v: Variant) -> None:
    kinds = no("ob")
    a = v.log(records=kinds)
    a.copy().dis_airt(1).dis_airt(2).en_airt(1).dis_airt(1).accepted("an OB may have ended unseen")
    a.copy().dis_airt(2).rejected("no count of 2 by one call", "AIRT-06")
    a.copy().dis_airt(1).dis_airt(3).rejected("no count of 3 by two calls", "AIRT-06")
    a.copy().armed(v.point).until(v.point, 500).act_tint(0x80A0).accepted("its OB ran unseen")
    a.copy().armed(v.point).wait(500).act_tint(0x80A0).rejected(
        "nothing can have used it up before its point", "TINT-61"
    )
    a.copy().srt_dint(500).wait(300).can_dint(0x80A0).rejected("not elapsed", "DINT-14")
    a.copy().srt_dint(500).wait(800).can_dint(0x80A0).accepted("its OB ran unseen")
    a.copy().set_tint(per=0x202, ret=0).rejected("return codes hold", "TINT-33")


@situation("FP-9")
def without_clock(v: Variant) -> None:
    kinds = no("clock")
    a = v.log(records=kinds)
    j = a.copy().armed(v.point, 0x201).wait(500)
    j.clock_now = v.point + MINUTE + 5 * MS
    j.runs(80, flt_id=5).runs().accepted("an unseen clock change", "CLK-02")
    b = v.log(records=kinds)
    b.with_up = True
    b.tick().srt_dint(500).wait(499)
    b.copy().runs(v.delay_ob).accepted("up decides durations", "DINT-06")
    c = b.copy()
    c.wait(-2)
    c.up = 498
    c.start(v.delay_ob).rejected("up decides durations", "DINT-06")
    e = v.log(records=kinds)
    e.with_up = True
    e.tick().armed(v.point).wait(1000)
    e.clock_now = v.point + MINUTE
    e.copy().tick().wait(v.latency + 1).tick().accepted(
        "known limit: an OB 80 that an unseen setting owes is not followed", "CLK-02"
    )
    e.copy().runs(80, flt_id=5).runs().accepted("at jumped over the point against up", "CLK-02")
    f = v.log(records=kinds)
    f.wait(500).tick()
    f.clock_now -= HOUR
    f.tick().accepted("at may run backward: set unseen")
    g = v.log(records=kinds)
    g.with_up = True
    g.wait(500).tick()
    g.up -= 1
    g.tick().unusable("up never runs backward", "FP-2")


@situation("FP-9")
def without_mode(v: Variant) -> None:
    kinds = no("mode")
    a = v.log(records=kinds)
    a.copy().armed(v.point).wait(50).act_tint(0x80A0).accepted("an unseen restart erased it")
    a.copy().dis_irt(0).wait(50).interrupt(40).runs(40).accepted("an unseen restart ended the block")
    a.copy().srt_dint(5000).wait(10000).runs(v.delay_ob).accepted("an unseen HOLD froze it")
    a.copy().srt_dint(5000).wait(4998).start(v.delay_ob).rejected("no mode change shortens a delay", "DINT-06")
    a.copy().dis_airt(1).dis_airt(3).rejected("counts hold", "AIRT-06")
    a.copy().interrupt(40).start(40).start(35).rejected("classes hold", "OBS-01")
    a.copy().qry_tint(0x11).accepted("perhaps in STARTUP", "TINT-72")
    a.copy().qry_tint(0x10).accepted("perhaps in RUN", "TINT-72")
    a.copy().qry_tint(0x18).rejected("bit 3 is 0 in every mode", "TINT-75")


@situation("FP-9")
def without_interrupt(v: Variant) -> None:
    kinds = no("interrupt")
    a = v.log(records=kinds)
    a.copy().runs(35).runs(40).accepted("unseen events")
    a.copy().start(40).start(35).rejected("classes hold", "OBS-01")
    a.copy().start(30).rejected("not loaded", "OBS-20")
    a.copy().runs(80, flt_id=1).accepted("an unseen cycle overrun", "OBS-30")
    a.copy().start(80, flt_id=5).rejected("no clock change: 05 is made by the rules alone", "CLK-02")
    a.copy().dis_irt(2, 40).wait(v.latency + 1).start(40).rejected("blocked", "IRT-01")
    a.copy().dis_irt(2, 40).runs(40).accepted("its unseen event may have come before DIS_IRT", "AMB-72")
    a.copy().dis_airt(1).wait(0).en_airt(0).runs(40).accepted("delayed")
    a.copy().interrupt(35).late("a line of it that is there counts", "OBS-03")
    v.log([1, 85], records=kinds).runs(85).accepted("an unseen event for a missing OB")
    v.log([1, 85, 80], records=kinds).stop(0x456D).accepted(
        "456D needs its rule only where every kind is recorded", "FP-8"
    )
    b = v.log(records=kinds).interrupt(35).start(35).dis_airt(1).wait(5)
    b.copy().start(40).rejected("delayed in OB 35", "AIRT-01")
    b.copy().en_airt(0).runs(40).accepted("delayed in OB 35")


@situation("FP-9")
def without_load(v: Variant) -> None:
    kinds = no("load")
    a = v.log(records=kinds)
    a.copy().qry_tint(0x00).qry_tint(0x10).accepted("deleted and loaded unseen")
    a.copy().interrupt(30).runs(30).accepted("loaded unseen")
    a.copy().armed(v.point).until(v.point).runs(85).accepted("deleted unseen")
    a.copy().armed(v.point).until(v.point).late("neither its OB nor OB 85 nor a STOP", "TINT-16")
    a.copy().interrupt(82).stop().accepted("no OB 82")
    a.copy().qry_tint(0x14).rejected("nothing is active", "TINT-74")


@situation("FP-9")
def diag_listed(v: Variant) -> None:
    a = v.log(records=WITH_ENTRIES).armed(v.point, 0x201).until(v.point).start().until(v.point + MINUTE)
    a.copy().diag(0x3502).runs(80, flt_id=2).accepted("3502 with OB 80")
    a.copy().runs(80, flt_id=2, ms=0).diag(0x3502).accepted("3502 within the latency")
    a.copy().start(80, flt_id=2).wait(v.latency + 1).end(80).rejected("3502 is owed within the latency", line=None)
    a.copy().diag(0x3505).rejected("no skip", "CLK-02")
    a.copy().diag(0x3502).diag(0x3502).rejected("one entry, one cause")
    a.copy().diag(0x4568).rejected("no STOP", "OBS-22")
    b = v.log().diag(0x3502)
    b.rejected("an entry without a cause")
    c = v.log().armed(v.point, 0x201).until(v.point).start().until(v.point + MINUTE).runs(80)
    c.copy().diag(0x3502).accepted("not listed: an entry that has a cause")
    c.copy().diag(0x3502).diag(0x3502).rejected("a cause is reported once")
    d = v.log([1, v.ob], records=WITH_ENTRIES).armed(v.point).clock(v.point + MINUTE)
    d.copy().diag(0x3505).stop(0x4568).diag(0x4568).accepted("3505 and 4568", "CLK-05")
    d.copy().diag(0x456D).rejected("no OB 85 is missing here", "OBS-21")
    e = v.log([1, 80, 85], records=WITH_ENTRIES).armed(v.point).until(v.point)
    e.copy().diag([0x35A1, 0x35A2][v.number % 2]).runs(85).accepted("35A1 or 35A2", "AMB-28")
    e.copy().diag(0x35A3).rejected("35A1 or 35A2", "AMB-28")


@situation("IRT-09")
def diag_off(v: Variant) -> None:
    a = v.log([1, v.ob, 85], records=WITH_ENTRIES).dis_irt(0x82, 80).diag(0x5380).armed(v.point).clock(v.point + MINUTE)
    a.copy().wait(v.latency + 5).tick().accepted("blocked events are not entered")
    a.copy().diag(0x3505).rejected("blocked events are not entered")
    b = v.log([1, v.ob, 85], records=WITH_ENTRIES).dis_irt(2, 80).armed(v.point).clock(v.point + MINUTE)
    b.copy().diag(0x3505).wait(v.latency + 5).tick().accepted("MODE 02: diagnostic entries continue", "IRT-08")
    b.copy().late("MODE 02: diagnostic entries continue", "IRT-08")


@situation("OBS-60")
def state_bits(v: Variant) -> None:
    a = v.log()
    a.copy().state(v.ob, active=False, blocked=False, loaded=True, entries_off=False).accepted("idle")
    a.copy().armed(v.point).state(v.ob, active=True).accepted("active")
    a.copy().armed(v.point).state(v.ob, active=False).rejected("active")
    a.copy().set_tint().state(v.ob, active=True).rejected("set only")
    a.copy().state(v.ob, loaded=False).rejected("loaded")
    a.copy().state(30, loaded=False).state(30, active=True).accepted("active is judged for OB 10-17 and 20-23 only")
    a.copy().dis_irt(1, 10).state(v.ob, blocked=True).state(v.delay_ob, blocked=False).accepted("by OB")
    a.copy().dis_airt(1).state(35, blocked=True).rejected("DIS_AIRT does not show", "AIRT-13")
    a.copy().armed(v.point).until(v.point).runs().state(v.ob, active=False).accepted("used up")
    a.copy().armed(v.point).until(v.point).runs().state(v.ob, active=True).rejected("used up", "TINT-08")
    b = v.log().armed(v.point).until(v.point, -5).interrupt(35).start(35).until(v.point, 5)
    b.copy().state(v.ob, active=True).accepted("pending once: either", "AMB-34")
    b.copy().state(v.ob, active=False).accepted("pending once: either", "AMB-34")
    a.copy().armed(v.point, 0x201).until(v.point).start().state(v.ob, active=False).rejected(
        "periodic stays active", "AMB-34"
    )


@situation("FP-2")
def whole_seconds(v: Variant) -> None:
    a = v.log()
    a.with_up = False

    def cut(log: Log) -> Log:  # `at` written in whole seconds
        log.lines[1:] = [line | {"at": line["at"][:19]} for line in log.lines[1:]]
        return log

    x = a.copy().armed(v.point).until(v.point, min(v.latency, 9)).start()
    cut(x).accepted("a second stands for the whole of its step", "FP-10")
    y = a.copy().armed(v.point).until(v.point, -900).start()
    cut(y).rejected("the second before the point", "TINT-32")


@situation("FP-3")
def minute_spelling(v: Variant) -> None:
    a = v.log()
    for spelled in (v.point.strftime("DT#%Y-%m-%d-%H:%M:%S.000"), v.point.isoformat()[:16], v.point.isoformat()[:19]):
        a.copy().set_tint(spelled).act_tint().until(v.point).runs().accepted("spellings of a date and time")
    v.log().event("SET_TINT", ob=v.ob, sdt=iso(v.point), period=0x401, ret=0).accepted("words as integers")
    v.log().event("SET_TINT", ob=9, sdt=iso(v.point), period="16#0401", ret=-32624).accepted(
        "RET_VAL as a signed integer: 8090"
    )
    v.log().event("SET_TINT", ob=9, sdt=iso(v.point), period="16#0401", ret=-32623).rejected(
        "8091 is not 8090", "TINT-35"
    )
    v.log().event("SET_TINT", ob=9, sdt=iso(v.point), period="16#0401", ret=None).accepted("not logged")
    v.log().event("SET_TINT", ob=v.ob, sdt=iso(v.point), period=0x401, ret=0, x_note="mine").accepted(
        "x_ fields are ignored"
    )


@situation("FP-6")
def general_codes(v: Variant) -> None:
    r = [0x8022, 0x807F, 0x8124, 0x8245][v.number]
    v.log().set_tint(ret=r).rejected("general codes are never right here")
    v.log().dis_irt(0, 0, r).rejected("general codes are never right here")
    v.log().en_airt(r).rejected("general codes are never right here")
    v.log().srt_dint(100, ret=r).rejected("general codes are never right here")
    v.log().qry_dint(0, None, r).rejected("general codes are never right here")
    v.log().set_tint(ret=None).act_tint(None).until(v.point).runs().accepted("null is whatever the rules give")
    v.log().set_tint(ret=None).act_tint(None).until(v.point).late(
        "null is whatever the rules give: it is due", "TINT-23"
    )
    v.log().set_tint(ret=1).rejected("0000 = no error", "TINT-22")


@situation("FORMAT")
def unusable_lines(v: Variant) -> None:
    a = v.log().tick()
    lines: tuple[list[tuple[str, dict[str, Any]]], ...] = (
        [("nope", {}), ("SET_TINT", {"ob": 10, "ret": 0}), ("start", {})],
        [("start", {"ob": "10"}), ("ACT_TINT", {"ob": 10}), ("clock", {})],
        [("call", {}), ("start", {"ob": 10, "foo": 1}), ("restart", {"type": "hot"})],
        [("QRY_TINT", {"ob": 10, "ret": 0}), ("DIS_IRT", {"mode": 0, "ret": 0}), ("state", {})],
    )
    for name, fields in lines[v.number]:
        a.copy().event(name, **fields).unusable("unknown event, missing or unknown field, wrong type")
    a.copy().raw(f'{{"event": "run", "at": "{iso(v.begin)}", "at": "{iso(v.begin)}"}}').unusable("duplicate key")
    a.copy().raw(f'{{"event": "start", "ob": NaN, "at": "{iso(v.begin)}"}}').unusable("NaN")
    a.copy().raw("not json").unusable("no JSON object")
    a.copy().raw("[]").unusable("no JSON object")
    a.copy().raw(json.dumps(v.log().lines[0])).unusable("a second header")
    a.copy().event("start", ob=40000).unusable("out of INT's range")
    a.copy().event("start", ob=35.5).unusable("no integer")
    a.copy().event("stop", cause="W#16#12345").unusable("no word")
    a.copy().event("clock", to="2026-02-30T00:00").unusable("dates in clock have to exist")
    a.copy().event("clock", to="2090-01-01T00:00").unusable("dates in clock end in 2089")
    a.copy().raw('{"event": "run"}').unusable("at is missing")
    a.copy().raw('{"event": "run", "at": "2026-11-21"}').unusable("no time of day")


@situation("FORMAT")
def unusable_headers(v: Variant) -> None:
    own: tuple[list[dict[str, Any]], ...] = (
        [{"mode": "HOLD"}, {"cpu": "S7-1500"}],
        [{"format": "s7-interrupt-log/2"}, {"obs": [1, "10"]}],
        [{"latency_ms": -1}, {"records": ["call", "nope"]}],
        [{"clock": "2026-02-30T00:00"}, {"readings": {"AMB-02": "z"}}],
    )
    every: list[dict[str, Any]] = [
        {"profile": "2011"},
        {"foo": 1},
        {"readings": {"AMB-99": "a"}},
        {"step7": {"tod": {"10": {"execution": "sometimes", "start": "2026-01-01T00:00"}}}},
        {"step7": {"tod": {"18": {"deselected": True}}}},
        {"cycle": "yes"},
        {"obs": None},
    ]
    for h in own[v.number] + every:
        log = v.log()
        log.lines[0] = {**log.lines[0], **h}
        log.tick().unusable("unusable header", line=1)
    for k in ("format", "cpu", "obs", "clock"):
        log = v.log()
        log.lines[0] = {a: b for a, b in log.lines[0].items() if a != k}
        log.tick().unusable(f"{k} is required", line=1)


@situation("FP-12")
def first_line_decides(v: Variant) -> None:
    v.log().tick().start(35).raw("broken").rejected("a line that cannot be explained comes first", line=3)
    v.log().tick().raw("broken").start(35).unusable("a line that cannot be read comes first", line=3)
    log = v.log().tick()
    log.lines.insert(1, "")
    log.lines.insert(1, "   ")
    log.start(35).rejected("lines are physical lines", line=5)
    e = v.log()
    e.lines = []
    e.unusable("an empty file", line=1)
    c = v.log()
    c.lines = [json.dumps(line) + "\r" for line in c.tick().lines]
    c.accepted("\\r\\n")
    v.log().accepted("a log may hold no event")
    v.log().wait(v.latency + 9).interrupt(35).wait(v.latency + 1).tick().raw("broken").rejected(
        "the late interrupt is seen before the broken line", line=3
    )


@situation("FP-2")
def time_backward(v: Variant) -> None:
    a = v.log().wait(10).tick()
    a.clock_now -= MS
    a.tick().unusable("at runs backward without a clock event")
    b = v.log()
    b.with_up = True
    b.wait(10).tick()
    b.up -= 1
    b.tick().unusable("up runs backward")
    c = v.log()
    c.clock_now -= MS
    c.tick().unusable("before the header's clock")
    v.log().wait(10).clock(v.begin - HOUR).wait(1).tick().accepted("a clock event sets it back")
    d2 = v.log().wait(10).clock(v.begin - HOUR)
    d2.clock_now -= MS
    d2.tick().unusable("before the new clock")


@situation("FP-1")
def lower_first(v: Variant) -> None:
    a = v.log().interrupt(35).wait(min(1, v.latency)).interrupt(40)
    a.copy().runs(40).runs(35).accepted("the higher class")
    if v.latency:
        a.copy().start(35).start(40).end(40).end(35).accepted("the lower one may start first inside the latency")
    else:
        a.copy().start(35).rejected("latency 0: strict", "AMB-69")
    obs = [1, 35, 40, 80, 82, 85]
    b = v.log(obs).interrupt(82).start(82).wait(3).interrupt(35).wait(2).interrupt(40).wait(v.latency + 5).end(82)
    b.copy().start(35).rejected("both waited longer than the latency", "AMB-69")
    b.copy().runs(40).runs(35).accepted("highest first", "OBS-03")
    c = v.log(obs).interrupt(82).start(82).wait(3).interrupt(35).wait(v.latency + 5).end(82).interrupt(40)
    if v.latency:
        c.copy().start(35).accepted("OB 40's event is fresh", "AMB-69")
    else:
        c.copy().start(35).rejected("latency 0: strict", "AMB-69")
    d = v.log().interrupt(40).wait(v.latency).tick().tick()
    d.copy().start(40).accepted("the interrupted OB's calls inside the window")
    d.copy().wait(1).start(40).rejected("past the window")


@situation("FP-1")
def window_anew(v: Variant) -> None:
    a = v.log().interrupt(35).wait(v.latency).interrupt(40).start(40).wait(30).end(40)
    a.copy().wait(v.latency).runs(35).accepted("the time runs anew after something above ran")
    a.copy().late("the time runs anew after something above ran")
    v.log().interrupt(40).interrupt(35).runs(40, ms=20).wait(v.latency).runs(35).accepted("both at once")
    v.log(latency_ms=0).interrupt(40).interrupt(35).runs(40, ms=20).wait(1).start(35).rejected("latency 0")
    v.log(latency_ms=60000).interrupt(40).wait(60000).runs(40).accepted("a minute of latency")
    v.log(latency_ms=60000).interrupt(40).wait(60001).start(40).rejected("a minute of latency")


@situation("FP-8")
def stop_causes(v: Variant) -> None:
    a = v.log([1, v.ob]).armed(v.point).clock(v.point + MINUTE)
    a.copy().stop().accepted("without a cause")
    a.copy().stop(0x4303).accepted("the switch while a STOP is due")
    a.copy().stop(0x456D).rejected("it is that rule's: 4568")
    a.copy().stop(0x4568).wait(9).restart().wait(9).run().wait(99).tick().accepted("and goes on after a restart")
    b = v.log([1, v.ob]).armed(v.point).clock(v.point + MINUTE).wait(v.latency + 1)
    b.copy().stop(0x4303).rejected("past the window any line is rejected", "CLK-05")
    b.copy().clock(v.point).rejected("past the window any line is rejected", "CLK-05")


@situation("FP-10")
def info_unknown(v: Variant) -> None:
    a = v.log().armed(v.point).until(v.point)
    a.copy().event("start", ob=v.ob, info={"nope": 1}).unusable("unknown field of info")
    a.copy().event("start", ob=v.ob, info={}).accepted("any subset, also none")
    a.copy().event("start", ob=v.ob, info={"period": 0, "priority": 2}).accepted("once is PERIOD_EXE 0000")
    a.copy().event("start", ob=v.ob, info={"period": 0x201}).rejected("once is PERIOD_EXE 0000")
    a.copy().event("start", ob=v.ob, info={"x_mine": 1}).accepted("x_ fields")
    b = v.log().srt_dint("T#1s500ms")
    b.copy().wait(1500).event("start", ob=v.delay_ob, info={"dtime": "T#1s500ms"}).accepted(
        "durations in either spelling"
    )
    b.copy().wait(1500).event("start", ob=v.delay_ob, info={"dtime": 1500}).accepted("durations in either spelling")
    b.wait(1500).event("start", ob=v.delay_ob, info={"dtime": "T#1s501ms"}).rejected("DTIME", "AMB-31")


@situation("FP-8", VARIANTS)
def startup_ob_info(v: Variant) -> None:
    a = v.log(mode="STOP").wait(100).restart()
    a.copy().start(100, strt_info=0x81, time=iso(a.clock_now)).accepted("manual warm restart", "OBS-42")
    a.copy().start(100, strt_info=0x85).rejected("85 is a cold restart", "OBS-42")
    a.copy().start(100, priority=27).accepted("class 27", "OBS-42")
    a.copy().start(100, priority=1).rejected("class 27", "OBS-42")
    a.copy().start(100, strt_info=0x82).accepted("automatic warm restart", "OBS-42")
    b = v.log(cycle=True, mode="STOP").restart().end(100).run()
    b.copy().start(1, priority=1, strt_info=1).accepted("OB 1 after a warm restart", "OBS-04")
    b.copy().start(1, strt_info=4).rejected("not after a cold one", "OBS-04")
    b.copy().start(1, strt_info=3).rejected("not after a cycle", "OBS-04")
    c = b.copy().start(1).wait(2).end(1)
    c.copy().start(1, strt_info=3).accepted("after a cycle", "OBS-04")
    c.copy().start(1, strt_info=1).rejected("after a cycle", "OBS-04")
    c.copy().start(1, priority=2).rejected("class 1", "OBS-04")


@situation("FP-1", VARIANTS)
def cycle_lines(v: Variant) -> None:
    a = v.log(cycle=True)
    a.copy().start(1).rejected("it runs already", "OBS-02")
    a.copy().end(1).end(1).rejected("it has ended", "OBS-02")
    a.copy().end(1).wait(0).tick().rejected("no OB runs: who calls?", "FP-9")
    a.copy().interrupt(35).start(35).end(1).rejected("OB 35 is on top", "OBS-03")
    a.copy().interrupt(35).start(35).start(1).rejected("OB 35 is on top", "OBS-01")
    a.copy().end(1).interrupt(35).runs(35).start(1).accepted("between two cycles")
    b = v.log()
    b.copy().start(1).end(1).start(1).tick().end(1).tick().accepted("not listed: boundaries may lie unseen")
    b.copy().interrupt(35).start(35).end(1).rejected("OB 35 is on top", "OBS-03")

"""Lines in unusual places: modes in which nothing runs, startup OBs, kinds left out."""

from collections.abc import Callable

from tests.by_hand.situations.builder import MINUTE, MS, Log, Variant, iso, moment, situation
from tests.by_hand.situations.contract import KINDS

CALLS: dict[str, Callable[[Log], Log]] = {
    "SET_TINT": lambda log: log.set_tint(),
    "CAN_TINT": lambda log: log.can_tint(0x80A0),
    "ACT_TINT": lambda log: log.act_tint(0x80A0),
    "QRY_TINT": lambda log: log.qry_tint(0x10),
    "SRT_DINT": lambda log: log.srt_dint(100),
    "CAN_DINT": lambda log: log.can_dint(0x80A0),
    "QRY_DINT": lambda log: log.qry_dint(0x10),
    "DIS_IRT": lambda log: log.dis_irt(0),
    "EN_IRT": lambda log: log.en_irt(0),
    "DIS_AIRT": lambda log: log.dis_airt(1),
    "EN_AIRT": lambda log: log.en_airt(0x8080),
}
"""Each call with an answer that is right where nothing has been called before, in RUN."""
IDLE: dict[str, Callable[[Log], Log]] = {"STOP": lambda log: log.stop(), "HOLD": lambda log: log.hold()}
"""The modes in which nothing runs, and how a log in RUN comes there."""


@situation("OBS-41")
def positions_calls(v: Variant) -> None:
    for name, call in CALLS.items():
        call(v.log()).accepted(f"{name} in RUN")
        call(IDLE["STOP"](v.log()).wait(1)).rejected(f"no program calls {name} in STOP")
        call(IDLE["HOLD"](v.log()).wait(1)).rejected(f"no program calls {name} in HOLD", "OBS-45")
        call(v.log(mode="STOP").wait(1)).rejected(f"no program calls {name} in STOP")
        call(v.log().hold().wait(9).release().wait(1)).accepted(f"{name} after HOLD")


def lines_of_obs(v: Variant) -> dict[str, Callable[[Log], Log]]:
    """Lines that need mode RUN, each with its name."""
    return {
        "start of OB 1": lambda log: log.start(1),
        "start of OB 35": lambda log: log.start(35),
        "start of a time-of-day OB": lambda log: log.start(),
        "start of a delay OB": lambda log: log.start(v.delay_ob),
        "end of OB 1": lambda log: log.end(1),
        "end of OB 35": lambda log: log.end(35),
    }


@situation("OBS-45")
def positions_idle(v: Variant) -> None:
    lines = lines_of_obs(v) | {
        "start of OB 80": lambda log: log.start(80, flt_id=1),
        "start of OB 85": lambda log: log.start(85, flt_id=0xA3),
        "start of OB 100": lambda log: log.start(100),
        "a call": lambda log: log.tick(),
        "run": lambda log: log.run(),
        "hold": lambda log: log.hold(),
    }
    kinds = KINDS[v.number]
    if kinds == "mode":
        kinds = KINDS[4]
    records = [kind for kind in KINDS if kind != kinds]
    for mode, enter in IDLE.items():
        for name, line in lines.items():
            line(enter(v.log(records=records).wait(1)).wait(5)).rejected(f"{name} in {mode}, {kinds} not recorded")
            line(enter(v.log(cycle=True).wait(1)).wait(5)).rejected(f"{name} in {mode}")
            line(enter(v.log().interrupt(35).start(35).wait(1)).wait(5)).rejected(f"{name} in {mode} over OB 35")


@situation("OBS-42")
def positions_in_startup(v: Variant) -> None:
    lines = lines_of_obs(v) | {
        "start of OB 102": lambda log: log.start(102),
        "release": lambda log: log.release(),
    }
    for name, line in lines.items():
        for left_out in ("call", "clock", "interrupt", "load"):
            records = [kind for kind in KINDS if kind != left_out]
            a = line(v.log(records=records, mode="STARTUP").wait(5))
            if (name, left_out) == ("start of OB 102", "load"):
                a.accepted("known limit: OB 102 may have been loaded, and its start line may follow the header")
            else:
                a.rejected(f"{name} in STARTUP, {left_out} not recorded")
        line(v.log(mode="STARTUP", cycle=True).wait(5)).rejected(f"{name} in STARTUP")
        line(v.log(mode="STOP").wait(5).restart().wait(5)).rejected(f"{name} in STARTUP")


@situation("OBS-42")
def positions_startup_ob(v: Variant) -> None:
    a = v.log(mode="STOP").wait(5).restart().wait(5)
    a.copy().start(100).end(100).run().tick().accepted("the startup OB with both lines")
    a.copy().end(100).run().accepted("its start is optional")
    a.copy().start(100).run().accepted("its end is optional")
    a.copy().start(100).end(100).start(100).rejected("it runs once")
    a.copy().start(100).start(100).rejected("it runs already")
    a.copy().tick().start(100).rejected("the call belongs to it: it runs already")
    a.copy().end(100).end(100).rejected("it has ended")
    a.copy().end(100).tick().rejected("it has ended: nothing runs")
    a.copy().start(100).run().end(100).rejected("RUN: it is over")
    a.copy().start(100).run().wait(5).start(100).rejected("RUN: it is over")
    v.log(mode="STARTUP").start(100).accepted(
        "known limit: a log in STARTUP may begin with the start of the startup OB"
    )
    b = v.log([1, 35, 80, 85], mode="STOP").wait(5).restart().wait(5)
    b.copy().run().tick().accepted("no startup OB is loaded")
    b.copy().start(100).rejected("no startup OB is loaded")
    b.copy().tick().rejected("no startup OB is loaded: nothing runs")
    b.copy().event("load", ob=100).start(100).accepted("loaded before it starts")


@situation("OBS-40")
def positions_modes(v: Variant) -> None:
    for kind in ("warm", "cold"):
        v.log().restart(kind).rejected("a restart begins in STOP")
        v.log().hold().restart(kind).rejected("a restart begins in STOP")
        v.log(mode="STARTUP").restart(kind).rejected("a restart begins in STOP")
    v.log(mode="STOP").release().rejected("no HOLD")
    v.log(mode="STOP").hold().rejected("HOLD is entered from a mode in which programs run")
    v.log().stop().wait(5).restart().wait(5).run().hold().wait(5).release().tick().accepted("all modes")
    v.log().hold().wait(5).stop().wait(5).release().rejected("STOP ended HOLD")
    v.log().hold().wait(5).stop().wait(5).restart().run().tick().accepted("from HOLD to STOP")


@situation("OBS-45")
def positions_cycle(v: Variant) -> None:
    a = v.log(cycle=True).end(1).hold().wait(5)
    a.copy().start(1).rejected("no cycle begins in HOLD")
    a.copy().release().start(1).tick().accepted("the cycle begins after HOLD")
    a.copy().release().tick().rejected("no OB runs between two cycles", "FP-9")
    b = v.log(cycle=True, mode="STOP").restart().run()
    b.copy().tick().rejected("OB 1 has not begun", "FP-9")
    b.copy().start(1).tick().accepted("OB 1 has begun", "FP-9")
    b.copy().end(1).rejected("OB 1 has not begun", "FP-9")
    c = v.log().end(1).hold().wait(5)
    c.copy().start(1).rejected("no cycle begins in HOLD")
    c.copy().release().tick().accepted("its start lies unseen", "FP-9")


@situation("OBS-52")
def positions_events_in_stop(v: Variant) -> None:
    a = v.log().stop().wait(5).interrupt(35).wait(5)
    a.copy().restart().wait(5).run().start(35).rejected("a restart discards process interrupts")
    a.copy().restart().wait(5).run().wait(v.latency + 9).tick().accepted("a restart discards process interrupts")
    b = v.log([1, 35, 80, 85]).stop().wait(5).interrupt(82).wait(v.latency + 9).restart().wait(5).run()
    b.copy().tick().accepted("a missing error OB does not stop a CPU in STOP", "OBS-41")
    b.copy().start(85).rejected("nothing is left of it")


@situation("CLK-01")
def positions_same_time(v: Variant) -> None:
    a = v.log().armed(v.point, 0x201).wait(5).clock(v.begin + 5 * MS)
    a.copy().until(v.point).runs().accepted("the clock is set to its own reading")
    a.copy().until(v.point).late("the clock is set to its own reading")
    a.copy().start(80).rejected("nothing is skipped", "CLK-02")
    b = v.log().armed(v.point, 0x201).until(v.point).runs(ms=0).clock(v.point)
    b.copy().until(v.point + MINUTE).runs().accepted("set onto the point that has just been served: no change")
    c = v.log().armed(v.point).until(v.point, -1).clock(v.point)
    c.copy().runs().accepted("one millisecond forward, onto the point", "AMB-37")
    c.copy().late("one millisecond forward, onto the point", "AMB-37")
    d = v.log().armed(v.point).until(v.point, -1).clock(v.point + MS)
    d.copy().runs(80, flt_id=5).runs(time=iso(v.point)).accepted("two milliseconds forward, over the point", "CLK-02")
    d.copy().start().rejected("two milliseconds forward, over the point", "CLK-02")


@situation("OBS-60")
def positions_loading(v: Variant) -> None:
    v.log().event("load", ob=v.ob).qry_tint(0x10).event("delete", ob=30).state(30, loaded=False).accepted("no change")
    v.log().event("delete", ob=v.ob).event("delete", ob=v.ob).qry_tint(0x00).accepted("deleted twice", "TINT-76")
    v.log().event("delete", ob=v.ob).event("load", ob=v.ob).qry_tint(0x00).rejected("loaded again", "TINT-76")
    a = v.log().event("delete", ob=v.ob).armed(v.point).until(v.point)
    a.copy().runs(85).accepted("missing at its call", "TINT-16")
    a.copy().event("load", ob=v.ob).runs().accepted("loaded in the millisecond of the point", "FP-2")


@situation("AMB-38")
def positions_feb_29(v: Variant) -> None:
    a = v.log(begin=moment("2029-02-28T05:59:30"), readings={"AMB-38": "c"})
    a.set_tint("2028-02-29T06:00", 0x1801).act_tint().until(moment("2029-02-28T06:00"))
    b = a.copy().runs().until(moment("2029-03-01T06:00"))
    b.copy().wait(v.latency + 9).tick().accepted("c: February 28")
    b.copy().start().rejected("c: February 28, so not March 1")
    c = a.copy().wait(v.latency + 9).tick().until(moment("2029-03-01T06:00"))
    c.copy().runs().accepted("c: March 1")
    c.copy().late("c: March 1, since not February 28")


@situation("AMB-33")
def positions_85_disabled(v: Variant) -> None:
    a = v.log([1, 80, 85], readings={"AMB-33": "b"}).dis_irt(2, 85).armed(v.point).until(v.point)
    a.copy().stop(0x456D).accepted("b: STOP as if OB 85 were missing")
    a.copy().late("b: STOP as if OB 85 were missing")
    b = v.log([1, 80, 85], readings={"AMB-33": "b"}).armed(v.point).until(v.point)
    b.copy().runs(85).accepted("b: not disabled")
    b.copy().stop(0x456D).rejected("b: not disabled")


@situation("OBS-03")
def positions_tails(v: Variant) -> None:
    a = v.log().interrupt(35).start(35).wait(1).interrupt(40).start(40).wait(1)
    a.copy().stop().wait(5).restart().wait(5).run().end(35).rejected("the restart emptied the stack", "OBS-54")
    a.copy().hold().wait(9).release().end(40).end(35).accepted("HOLD keeps the stack", "OBS-45")
    a.copy().hold().wait(9).release().end(35).rejected("OB 40 is on top")
    a.copy().hold().wait(9).interrupt(35).wait(9).release().end(40).end(35).accepted("one more event in HOLD", "AMB-67")

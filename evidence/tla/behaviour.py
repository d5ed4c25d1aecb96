"""A behaviour of System as a log, a line for each step that a log shows.

A state has the variables of System by their names. Times are those of the states; `up` is left out: it is the
difference of `at` without the jumps of the clock.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime, timedelta
from itertools import pairwise
from typing import Any

from evidence.tla.values import assignments

State = dict[str, Any]
Line = dict[str, Any]

FORMAT = "s7-interrupt-log/1"
_BEGIN = datetime(1990, 1, 1)
_ERROR_OBS = (80, 85)
_UNSEEN = ("time", "reached", "elapsed", "missing", "dropped", "power on")
_NO_STATUS = -1


def behaviour(trace: Sequence[str]) -> list[State]:
    """The states of a trace as TLC prints them, each below its heading. Raises `UnreadableValueError`."""
    return [assignments(text.partition("\n")[2]) for text in trace]


def of_system(state: State) -> bool:
    """Whether it is a state of System, or of a model that extends it."""
    return {"cpu", "clock", "loaded", "mode", "requests", "step"} <= state.keys()


def as_log(states: Sequence[State]) -> list[Line]:
    """Give header and events of a behaviour; the first state is the one before any step."""
    lines = [_header(states[0])]
    for before, after in pairwise(states):
        event = event_of(before, after)
        if event is not None:
            lines.append(event)
    return lines


def moment(value: dict[str, int]) -> str:
    """Spell a moment `[min |-> minutes since 1990, ms |-> ...]` as a DT."""
    return (_BEGIN + timedelta(minutes=value["min"], milliseconds=value["ms"])).isoformat(timespec="milliseconds")


def _header(state: State) -> Line:
    cpu = state["cpu"]
    header: Line = {
        "format": FORMAT,
        "cpu": cpu["family"],
        "obs": sorted({1, *state["loaded"]}),
        "clock": moment(state["clock"]),
        "mode": state["mode"],
        "cycle": True,
    }
    if cpu["priority"]:
        header["priority"] = {str(ob): number for ob, number in _pairs(cpu["priority"])}
    tod = {str(ob): _step7(one) for ob, one in _pairs(cpu["step7"]) if one["execution"] != "none" or one["deselected"]}
    if tod:
        header["step7"] = {"tod": tod}
    if cpu["readings"]:
        header["readings"] = dict(cpu["readings"])
    return header


def _pairs(function: Any) -> list[tuple[Any, Any]]:
    """Give the pairs of a function; TLC prints one without arguments as an empty tuple, and a record for strings."""
    return list(function.items()) if function else []


def _step7(one: dict[str, Any]) -> Line:
    given: Line = {"execution": one["execution"]}
    if one["execution"] != "none":
        given["start"] = moment({"min": one["start"], "ms": 0})
        given["active"] = one["active"]
    if one["deselected"]:
        given["deselected"] = True
    return given


def event_of(before: State, after: State) -> Line | None:
    """Give the line of a step with its time; None where a log does not show the step."""
    step = after["step"]
    name = step["event"]
    if name in _UNSEEN:
        return None
    event = {"event": "stop" if name == "switch" else name, "at": moment(before["clock"])}
    event.update(_FIELDS.get(name, _plain)(step, after))
    if name == "start" and (fault := _fault(before, step["ob"])):
        event["info"] = {"flt_id": f"16#{fault:02X}"}
    return event


def _fault(before: State, ob: int) -> int:
    """Give the fault id of the OB 80 or OB 85 that starts: that of its first request; 0 where it has none."""
    first = min((r for r in before["requests"] if r["ob"] == ob), key=lambda r: int(r["rank"]), default={"fault": 0})
    return max(0, int(first["fault"]))


def _word(value: int) -> str:
    return f"16#{value:04X}"


def _call(*operands: str) -> Callable[[Line, State], Line]:
    """The fields of a call: its operands by their names in the log, then its answer."""
    read: dict[str, Callable[[Line], Any]] = {
        "ob": lambda s: s["ob"],
        "sdt": lambda s: _sdt(s["sdt"]),
        "period": lambda s: _word(s["operand"]),
        "dtime": lambda s: s["operand"],
        "sign": lambda s: s["sign"],
        "mode": lambda s: f"16#{s['operand']:02X}",
    }

    def fields(step: Line, _: State) -> Line:
        return {name: read[name](step) for name in operands} | {"ret": _word(step["value"])}

    return fields


def _query(step: Line, _: State) -> Line:
    status = {} if step["operand"] == _NO_STATUS else {"status": _word(step["operand"])}
    return {"ob": step["ob"], "ret": _word(step["value"]), **status}


def _sdt(date: dict[str, int]) -> str:
    return "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}".format(**date)


def _plain(step: Line, _: State) -> Line:
    return {"ob": step["ob"]} if step["ob"] else {}


def _interrupt(step: Line, _: State) -> Line:
    fault = {"flt_id": f"16#{step['value']:02X}"} if step["ob"] in _ERROR_OBS else {}
    return {"ob": step["ob"], **fault}


def _clock(_: Line, after: State) -> Line:
    return {"to": moment(after["clock"])}


def _stop(step: Line, _: State) -> Line:
    return {"cause": _word(step["value"])} if step["value"] > 0 else {}


def _restart(_: Line, after: State) -> Line:
    return {"type": after["startup"]}


_FIELDS: dict[str, Callable[[Line, State], Line]] = {
    "SET_TINT": _call("ob", "sdt", "period"),
    "CAN_TINT": _call("ob"),
    "ACT_TINT": _call("ob"),
    "QRY_TINT": _query,
    "SRT_DINT": _call("ob", "dtime", "sign"),
    "CAN_DINT": _call("ob"),
    "QRY_DINT": _query,
    "DIS_IRT": _call("mode", "ob"),
    "EN_IRT": _call("mode", "ob"),
    "DIS_AIRT": _call(),
    "EN_AIRT": _call(),
    "stop": _stop,
    "interrupt": _interrupt,
    "clock": _clock,
    "restart": _restart,
}
"""Of events that have more than an OB or nothing."""

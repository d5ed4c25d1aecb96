"""What a program does, for those whose case is about its log: what it left out, or how it is written."""

from __future__ import annotations

from s7check.kit.from_log import Json

_MOST = 6
"""Words in a name, and parts in a text."""


def asks(program: Json) -> bool:
    """Whether a CPU has anything to do: an event from outside, a start point or a call can come."""
    header = program["header"]
    events = [event for event in program.get("outside", ()) if event["event"] != "state"]
    active = any(one.get("active") for one in header.get("step7", {}).get("tod", {}).values())
    first = {"RUN": (1,), "STARTUP": (1, 100, 101, 102)}.get(header.get("mode", "STOP"), ())
    own = any("call" in step for body in program["bodies"] if body["ob"] in first for step in body["steps"])
    return bool(events) or active or own or header.get("mode") == "STARTUP"


def name(program: Json, area: str) -> str:
    """A name of the requirement ``area`` and the words for what the program does."""
    words = dict.fromkeys(_words(program)) or ["startup" if program["header"].get("mode") == "STARTUP" else "step7"]
    return "-".join([area, *list(words)[:_MOST]])


def _words(program: Json) -> list[str]:
    calls = [step["call"] for body in program["bodies"] for step in body["steps"] if "call" in step]
    return [*calls, *(event["event"] for event in program.get("outside", ()))]


def about(program: Json) -> str:
    """A sentence: the start points by STEP 7, the calls of each OB, the events from outside."""
    parts = [
        f"STEP 7 has set OB {ob} ({one['execution']})"
        for ob, one in program["header"].get("step7", {}).get("tod", {}).items()
        if one.get("active")
    ]
    for body in program["bodies"]:
        calls = [f"{step['call']}{_of(step)}" for step in body["steps"] if "call" in step]
        if calls:
            more = " and more" if len(calls) > _MOST else ""
            parts.append(f"OB {body['ob']} calls {', '.join(calls[:_MOST])}{more}")
    events = [f"{event['event']}{_of(event)} after {event['after']} ms" for event in program.get("outside", ())]
    parts += ["from outside: " + ", ".join(events[:_MOST]) + (" and more" if len(events) > _MOST else "")] * bool(
        events
    )
    text = "; ".join(parts) or "STARTUP ends, and OB 1 runs"
    return f"{text[:1].upper()}{text[1:]}."


def _of(step: Json) -> str:
    return f" of OB {step['ob']}" if "ob" in step else ""

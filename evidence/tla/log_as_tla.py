"""Logs as TLA+, for TLC: the engine takes the same steps from line to line, but TLC is another program."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from s7check.engine import pool
from s7check.log.encoding import as_utf8
from s7check.log.source import open_log

ROOT = "PartialLogs"
"""The module of the specification that takes a log."""

CONFIGURATION = "INIT LogsInit\nNEXT LogsNext\nVIEW LogsView\nCHECK_DEADLOCK FALSE\n"

_STEPS = r"""
VARIABLES log, index
Event == Logs[log].events[index]
LogsInit == Init /\ log \in DOMAIN Logs /\ index = 0
LogsNext ==
    /\ UNCHANGED log
    /\ \/ index = 0 /\ Begin(Logs[log].header) /\ index' = 1
       \/ /\ index \in DOMAIN Logs[log].events
          /\ IF ~Arrived(Event) THEN Elapse(Event) /\ UNCHANGED index
             ELSE \/ Silent(Event) /\ UNCHANGED index
                  \/ Observe(Event) /\ index' = index + 1
LogsView == <<log, index, Distinct>>
Out == INSTANCE TLC
"""

_LARGEST = 2**31 - 1
"""TLC reads a negative number as the negation of a number that it can read."""


def module(name: str, files: Sequence[Path], invariant: str) -> str:
    """A module in which each log is an initial state, and its lines are observed one by one.

    `invariant` is a definition that tells what TLC finds.
    """
    logs = [f"Log{number} == {_log(file)}" for number, file in enumerate(files, 1)]
    names = ", ".join(f"Log{number}" for number in range(1, len(logs) + 1))
    beginning = f"---- MODULE {name} ----\nEXTENDS {ROOT}"
    return "\n".join([beginning, *logs, f"Logs == <<{names}>>", _STEPS + invariant, "===="])


def read(file: Path) -> tuple[str, list[str]]:
    """The header and the events of a log, each with the fields that its line has, in one order."""
    with open_log(str(file)) as source, pool.engine() as engine:
        content = engine.read(b"".join(as_utf8(source.chunks())))
    header, events = content.header or {}, content.events
    sets = {name: _set(field) if isinstance(field, list) else value(field) for name, field in header.items()}
    return _changed("NoHeader", sets), [_event(event) for event in events]


def value(json: Any) -> str:
    """A value of JSON in TLA+: objects are records, arrays tuples."""
    match json:
        case bool():
            return str(json).upper()
        case int() if json < -_LARGEST:
            return f"({json + 1} - 1)"
        case int():
            return str(json)
        case str():
            return f'"{json}"'
        case dict():
            return f"[{', '.join(f'{name} |-> {value(inner)}' for name, inner in json.items())}]"
        case _:
            return f"<<{', '.join(map(value, json))}>>"


def _log(file: Path) -> str:
    header, events = read(file)
    lines = ",\n".join(events)
    return f"[header |-> {header}, events |-> <<\n{lines}>>]"


def _event(event: dict[str, Any]) -> str:
    fields = {name: value(field) for name, field in event.items() if name != "line"}
    if "info" in event:
        fields["info"] = _changed("NoInfo", {name: value(field) for name, field in event["info"].items()})
    return _changed("NoEvent", fields)


def _changed(record: str, fields: dict[str, str]) -> str:
    if not fields:
        return record
    return f"[{record} EXCEPT {', '.join(f'!.{name} = {text}' for name, text in sorted(fields.items()))}]"


def _set(values: Iterable[Any]) -> str:
    return f"{{{', '.join(map(value, values))}}}"

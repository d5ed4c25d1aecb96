"""The shipped logs as a model for TLC: each log is an initial state, and its lines are observed one by one.

The trace checker's engine takes the same steps, but has none of TLC's registers, which hold the marks. Every log that
it accepts, and no other, has to be consumed to its end.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path, PurePosixPath
from typing import Any

from trace_checker.log.reader import read_log
from trace_checker.log.source import open_log
from trace_checker.models.manifest import HEAP_MB, Expect, Model
from trace_checker.shipped import Shipped, shipped_logs

NAME = "logs"
MODULE = "ShippedLogs"
ROOT = "Unrecorded"
"""The module of the specification that takes a log."""

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
Consumed == index > Len(Logs[log].events) => Out!PrintT(<<"consumed", log>>)
"""

_LARGEST = 2**31 - 1
"""TLC reads a negative number as the negation of one that it can read."""

_CONSUMED = re.compile(r'<<"consumed", (\d+)>>')

_CONFIGURATION = """INIT LogsInit
NEXT LogsNext
VIEW LogsView
INVARIANT Consumed
CHECK_DEADLOCK FALSE
"""


def model(timeout: float) -> Model:
    """The model whose module `module` writes."""
    return Model(
        name=NAME,
        kind="model",
        lane="ci",
        what="The shipped logs.",
        requirements=(),
        module=PurePosixPath(f"{MODULE}.tla"),
        config=_CONFIGURATION,
        mutations=(),
        deadlock=False,
        workers=1,
        heap=HEAP_MB,
        args=(),
        seconds=(0.0, timeout),
        expect=Expect(exit=0),
    )


def readable(traces: Path) -> list[Shipped]:
    """The logs of the index that can be read. Raises OSError or `msgspec.MsgspecError`."""
    return [log for log in shipped_logs(traces) if log.verdict != "unusable"]


def differences(output: str, logs: Sequence[Shipped]) -> list[str]:
    """The logs that TLC consumes though the index says that they are rejected, or the other way round."""
    consumed = {int(number) for number in _CONSUMED.findall(output)}
    return [log.file for number, log in enumerate(logs, 1) if (number in consumed) != (log.verdict == "accepted")]


def module(traces: Path, logs: Sequence[Shipped]) -> str:
    """A module with these logs."""
    named = [f"Log{number} == {_log(traces / log.file)}" for number, log in enumerate(logs, 1)]
    names = ", ".join(f"Log{number}" for number in range(1, len(logs) + 1))
    return "\n".join([f"---- MODULE {MODULE} ----\nEXTENDS {ROOT}", *named, f"Logs == <<{names}>>", _STEPS, "===="])


def _log(file: Path) -> str:
    header: dict[str, Any] = {}
    events: list[dict[str, Any]] = []
    with open_log(str(file)) as source:
        for batch in read_log(source.chunks()):
            header = batch.header or header
            events += batch.events
    sets = {name: _set(value) if isinstance(value, list) else _value(value) for name, value in header.items()}
    lines = ",\n".join(map(_event, events))
    return f"[header |-> {_changed('NoHeader', sets)}, events |-> <<\n{lines}>>]"


def _event(event: dict[str, Any]) -> str:
    """An event with the fields that its line has, the others as in NoEvent."""
    fields = {name: _value(value) for name, value in event.items() if name != "line"}
    if "info" in event:
        fields["info"] = _changed("NoInfo", {name: _value(value) for name, value in event["info"].items()})
    return _changed("NoEvent", fields)


def _changed(record: str, fields: dict[str, str]) -> str:
    return f"[{record} EXCEPT {', '.join(f'!.{name} = {value}' for name, value in fields.items())}]"


def _set(values: Iterable[Any]) -> str:
    return f"{{{', '.join(map(_value, values))}}}"


def _value(value: Any) -> str:
    """A value of JSON in TLA+: objects are records, arrays tuples."""
    match value:
        case bool():
            return str(value).upper()
        case int() if value < -_LARGEST:
            return f"({value + 1} - 1)"
        case int():
            return str(value)
        case str():
            return f'"{value}"'
        case dict():
            return f"[{', '.join(f'{name} |-> {_value(inner)}' for name, inner in value.items())}]"
        case _:
            return f"<<{', '.join(map(_value, value))}>>"

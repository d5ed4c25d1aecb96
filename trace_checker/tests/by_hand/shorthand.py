"""The shorthand of ``round.txt``: each log as a header and events of the format."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

DAY = "2026-11-21T"
HEADER = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-300",
    "obs": [1, 10, 11, 20, 35, 40, 80, 85, 100],
    "clock": f"{DAY}06:00:00.000",
    "mode": "RUN",
}
INTEGERS = {"priority", "dtime", "ev_ob", "left", "up"}
BYTES = {"flt_id", "strt_info"}
CALLS: dict[str, tuple[str, tuple[str, ...]]] = {
    "set": ("SET_TINT", ("ob", "sdt", "period", "ret")),
    "act": ("ACT_TINT", ("ob", "ret")),
    "can": ("CAN_TINT", ("ob", "ret")),
    "qry": ("QRY_TINT", ("ob", "ret", "status")),
    "srt": ("SRT_DINT", ("ob", "dtime", "sign", "ret")),
    "cand": ("CAN_DINT", ("ob", "ret")),
    "qryd": ("QRY_DINT", ("ob", "ret", "status")),
    "dis": ("DIS_IRT", ("mode", "ob", "ret")),
    "en": ("EN_IRT", ("mode", "ob", "ret")),
    "dair": ("DIS_AIRT", ("ret",)),
    "eair": ("EN_AIRT", ("ret",)),
    "start": ("start", ("ob",)),
    "end": ("end", ("ob",)),
    "clock": ("clock", ("to",)),
    "restart": ("restart", ("type",)),
    "run": ("run", ()),
    "hold": ("hold", ()),
    "release": ("release", ()),
    "stop": ("stop", ("cause",)),
    "int": ("interrupt", ("ob", "flt_id")),
    "load": ("load", ("ob",)),
    "delete": ("delete", ("ob",)),
    "diag": ("diag", ("id",)),
    "state": ("state", ("ob",)),
}
"""Short name -> event and its fields; the last ones may be left out."""


@dataclass
class HandLog:
    """A log with the verdict that its writer expects: ``A``, or ``R`` and the line."""

    name: str
    expected: str
    header: dict[str, Any]
    events: list[dict[str, Any]] = field(default_factory=list)

    def text(self) -> str:
        """The log as NDJSON."""
        return "".join(json.dumps(line) + "\n" for line in (self.header, *self.events))


def read(path: Path) -> Iterator[HandLog]:
    """The logs of a file in shorthand."""
    log: HandLog | None = None
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("//") or not line.strip():
            continue
        if line.startswith("== "):
            if log is not None:
                yield log
            _, name, expected, *header = line.split(None, 3)
            log = HandLog(name, expected, HEADER | (json.loads(header[0]) if header else {}))
            log.header["clock"] = _moment(log.header["clock"])
        else:
            assert log is not None, line
            log.events.append(_event(line))
    if log is not None:
        yield log


def _moment(text: str) -> str:
    if "T" in text:
        return text
    *hours, minutes, seconds = text.split(":")
    return f"{DAY}{int(hours[0] if hours else 6):02}:{int(minutes):02}:{float(seconds):06.3f}"


def _event(line: str) -> dict[str, Any]:
    at, short, *operands = line.split()
    event, names = CALLS[short]
    plain = [operand for operand in operands if "=" not in operand]
    made: dict[str, Any] = {"at": _moment(at), "event": event}
    made |= {name: _value(name, value) for name, value in zip(names, plain, strict=False)}
    named = dict(operand.split("=", 1) for operand in operands if "=" in operand)
    fields = {name: _value(name, value) for name, value in named.items()}
    if "up" in fields:
        made["up"] = fields.pop("up")
    if event == "state":
        return made | fields
    return made | ({"info": fields} if fields else {})


def _value(name: str, value: str) -> object:
    if name in {"ob", *INTEGERS}:
        return int(value)
    if name in {"active", "blocked", "loaded", "entries_off"}:
        return value == "true"
    if name in {"to", "time"}:
        return _moment(value)
    if name == "sdt":
        return value if "T" in value else DAY + value
    if name == "type":
        return value
    if value == "null":
        return None
    return f"B#16#{value}" if name in {"mode", *BYTES} else f"W#16#{value.rjust(4, '0')}"

"""The programs of the shipped logs, accepted and rejected ones: each is about a rule or an edge case."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from evidence.common.shipped import Shipped, shipped_logs
from s7check.kit.from_log import Json, program_of
from s7check.log.source import open_log


def programs(traces: Path) -> Iterator[Json]:
    """Programs with names of their own; of several that do the same, the smallest. Raises OSError, UnusableLogError."""
    same: dict[str, Json] = {}
    for log in shipped_logs(traces):
        if log.verdict == "unusable":
            continue
        program = _program(traces, log)
        key = json.dumps([program[part] for part in ("header", "duration", "bodies")] + [program.get("outside")])
        other = same.setdefault(key, program)
        if other is not program:
            _merge(other, program)
    names: set[str] = set()
    for program in same.values():
        name, number = program["name"], 1
        while program["name"] in names:
            number += 1
            program["name"] = f"{name}-{number}"
        names.add(program["name"])
        yield program


def _program(traces: Path, log: Shipped) -> Json:
    with open_log(str(traces / log.file)) as source:
        lines = b"".join(source.chunks()).splitlines()
    name = Path(log.file).name.split(".")[0]
    more = {} if log.verdict == "accepted" else {"catches": name.split("-", 2)[-1].replace("-", " ")}
    return program_of(lines, name, " ".join(log.reason.split()), log.requirements, **more)


def _merge(into: Json, program: Json) -> None:
    into["requirements"] += [name for name in program["requirements"] if name not in into["requirements"]]
    found = [text for text in (into.get("catches"), program.get("catches")) if text]
    if found:
        into["catches"] = "; ".join(dict.fromkeys(found))

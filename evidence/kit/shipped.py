"""The programs of the shipped logs, accepted and rejected ones: each is about a rule or an edge case."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator

from evidence.common.cases import Case
from evidence.kit.described import about, asks, name
from s7check.engine import pool
from s7check.kit.from_log import Json, program_of


def programs(cases: Iterable[Case]) -> Iterator[Json]:
    """Programs with names of their own; of several that do the same, the smallest. Raises UnusableLogError."""
    same: dict[str, Json] = {}
    for case in cases:
        if case.verdict == "unusable":
            continue
        program = _program(case)
        if not asks(program):
            continue
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


def _program(case: Case) -> Json:
    whole = not _about_its_log(case)
    more = {"catches": case.name.split("-", 2)[-1].replace("-", " ")} if case.verdict == "rejected" and whole else {}
    with pool.engine() as engine:
        program = program_of(engine, case.lines, case.name, case.reason, case.requirements, **more)
    if not whole:
        # An implementation that runs the program writes a log of its own, in which nothing of that need be.
        program |= {"name": name(program, case.requirements[0]), "about": about(program)}
    return program


_OF_A_LOG = re.compile("blank-line|carriage-returns|spellings|clock-line|up-shows|`up`")
"""In the names and reasons of cases about how a log is written, or about a clock apart from elapsed time."""


def _about_its_log(case: Case) -> bool:
    """Whether a case is about its log more than about the CPU: what was not recorded, entries of the diagnostic buffer,
    how it is written.
    """
    header, *events = (json.loads(line) for line in case.lines if line.strip())
    diag = any(event["event"] == "diag" for event in events)
    return diag or "records" in header or _OF_A_LOG.search(case.name + case.reason) is not None


def _merge(into: Json, program: Json) -> None:
    into["requirements"] += [name for name in program["requirements"] if name not in into["requirements"]]
    found = [text for text in (into.get("catches"), program.get("catches")) if text]
    if found:
        into["catches"] = "; ".join(dict.fromkeys(found))

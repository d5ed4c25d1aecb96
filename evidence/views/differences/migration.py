"""docs/rules/migration-s7-1500.md: what changes from S7-300/400, by area, with the log that shows it."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path

from evidence.common.cases import read_cases
from s7check.asking.line_text import spelled
from s7check.asking.log_prefix import Prefix, read_prefix
from s7check.engine.client import Engine
from s7check.migrating.table import Difference, differences
from s7check.migrating.walk import Point, points
from s7check.report.clauses import page_of

FAMILY = "S7-1500"
_HEADER = {"obs": "1,10,80", "mode": "RUN", "clock": "2026-11-23T05:59:00.000"}
"""Fields of the header of a log that names no others."""

_INTRODUCTION = """# From S7-300/400 to S7-1500

What a program meets that goes from S7-300/400 to S7-1500: {all} differences, {shown} of them with the shortest log that
shows it; the others have the reason why none can. **This family is advisory**
([requirements-s7-1500.md](requirements-s7-1500.md)): trust is H, M or L as there, C is a control, in which nothing
differs. `s7check migrate LOG` finds them in a log of yours ([commands](../checking/commands.md)).

"""


def text_of_case(one: Difference) -> str:
    """The log that shows a difference, as a case of ``traces/``."""
    first, *more = (line.strip() for line in one.shown.split("\n"))
    words = first.split()
    begin = next((place for place, word in enumerate(words) if word[0].isdigit()), len(words))
    events = "; ".join([*filter(None, [" ".join(words[begin:])]), *more])
    given = {word.partition("=")[0] for word in words[:begin]}
    fields = [f"{name}={value}" for name, value in _HEADER.items() if name not in given]
    return f"== {one.id} A {one.old[0]} {' '.join([*fields, *words[:begin]])}\n# {one.was}\n{events}\n"


def prefix_of(engine: Engine, one: Difference) -> Prefix:
    """The log that shows a difference. Raises `CasesError`, UnusableLogError."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "MD.txt"
        file.write_text(text_of_case(one), encoding="utf-8")
        (case,) = read_cases(file)
        log = Path(folder) / "log.ndjson"
        log.write_bytes(case.log)
        return read_prefix(engine, str(log))


def is_of_new_projects(one: Difference) -> bool:
    """Whether the difference is there only with the priorities of a new project."""
    return "in a new project" in one.becomes


def found_in(engine: Engine, one: Difference, prefix: Prefix) -> list[Point]:
    """The points of its log that name it. Raises EngineError."""
    all_points = points(engine, prefix, FAMILY, is_of_new_projects(one))
    return [point for point in all_points if one.id in {each.id for each in point.differences}]


def migration_page(engine: Engine) -> str:
    """The page. Raises EngineError, OSError and ValueError."""
    table = differences(FAMILY)
    parts = [_INTRODUCTION.format(all=len(table), shown=sum(bool(one.shown) for one in table))]
    for area, some in groupby(sorted(table, key=lambda one: one.area), key=lambda one: one.area):
        parts.append(f"## {area.capitalize()}\n\n")
        parts += [part for one in some for part in _entry(engine, one)]
    return "".join(parts)


def _entry(engine: Engine, one: Difference) -> Iterator[str]:
    rules = [", ".join(f"[{name}]({page_of(name)}#{name})" for name in names) for names in (one.old, one.new)]
    yield f'### <a id="{one.id}"></a>{one.id}, {one.trust}\n\n'
    yield f"- was: {one.was} ({rules[0]})\n- is: {one.becomes} ({rules[1]})\n- do: {one.do}\n"
    if one.none:
        yield f"- no log: {one.none}\n\n"
        return
    prefix = prefix_of(engine, one)
    point = found_in(engine, one, prefix)[0]
    new = " --new-project" if is_of_new_projects(one) else ""
    yield f"\n`s7check migrate{new}`, a log of an {prefix.header['cpu']} (OBs {prefix.header['obs']}):\n\n```\n"
    for number, line in prefix.events:
        mark = ">" if number == point.line else " "
        yield f"{mark} {line['at']} {spelled(line)}\n"
    yield f"```\n\nAn {FAMILY} does not show line {point.line}"
    yield f"; instead: {', '.join(point.instead)}.\n\n" if point.instead else ".\n\n"

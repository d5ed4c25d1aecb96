"""docs/project/results.md, which has the totals, and the page with all numbers, as text."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Iterator, Mapping

from evidence.views.results.records import Cell, Record, Table
from evidence.views.results.runs import RUNS, SECOND, Run

_TOTALS = """\
# Results

What was run, when, at which revision, and the totals; no other page has numbers of runs. `s7spec views results RUN`
runs a command, keeps its numbers in `docs/project/results/` and writes this page. `make views` makes a page with all
numbers, the tools and the machine, and says which are of an older text. [Checks](checks.md) says what runs on every
revision.

"""

_ALL = """\
# Results in full

All numbers of the runs of [results.md](results.md), made from `docs/project/results/`. The revision is that of the
checkout at the run, with `+` if files differed from it. Load is that of the machine when the run began: other work
lengthens the seconds.
"""

_WIDTH = 120


def totals(records: Mapping[str, Record]) -> str:
    """The short page: a line for every run that is kept."""
    return _TOTALS + "".join(
        _wrapped(
            f"- **{title}** (`{record.command}`, {record.date}, revision {record.revision}): {_summed(run, record)}"
        )
        for name, run in RUNS.items()
        for title, record in ((run.title, records.get(name)), (f"{run.title}, second TLC", records.get(name + SECOND)))
        if record is not None
    )


def _wrapped(text: str) -> str:
    return textwrap.fill(text, _WIDTH, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False) + "\n"


def _summed(run: Run, record: Record) -> str:
    table = record.tables[0]
    last = table.rows[-1]
    rows = [last] if last[0] == "all" else table.rows
    sums = {name: _sum(rows, table.columns.index(name)) for name in run.totals if name in table.columns}
    return ", ".join(f"{name}: {_text(value)}" for name, value in sums.items()) or "see the tables"


def _sum(rows: list[list[Cell]], column: int) -> int | float:
    return sum(cell for row in rows if isinstance(cell := row[column], int | float))


def page(records: Mapping[str, Record], old: Collection[str]) -> str:
    """The page with every run and its kept summary; those named in `old` are of an older text."""
    return "\n".join(_sections(records, old))


def _sections(records: Mapping[str, Record], old: Collection[str]) -> Iterator[str]:
    yield _ALL
    for name, run in RUNS.items():
        yield f"## {run.title}\n\n{run.about}\n"
        if name in records:
            yield from _record(records[name], name in old)
        else:
            yield f"`{run.typed}` has not been run.\n"
        if name + SECOND in records:
            yield f"### {run.title} on a second TLC\n"
            yield from _record(records[name + SECOND], name + SECOND in old)


def _record(record: Record, old: bool) -> Iterator[str]:
    if old:
        yield "**Of an older text:** something that these numbers depend on has changed since.\n"
    for table in record.tables:
        yield _table(table)
    yield from (f"{remark}\n" for remark in record.remarks)
    facts = [f"`{record.command}`", record.date, f"revision {record.revision}", *record.tools, record.machine]
    facts += [] if record.load is None else [f"load {record.load}"]
    facts += [] if record.seconds is None else [f"{record.seconds:,.0f} s"]
    facts += [] if record.exit is None else [f"exit code {record.exit}"]
    yield ", ".join(facts) + ".\n"


def _table(table: Table) -> str:
    numeric = [all(not isinstance(row[column], str) for row in table.rows) for column in range(len(table.columns))]
    lines = [f"**{table.title}**\n"] if table.title else []
    lines.append(_row(table.columns))
    lines.append(f"|{'|'.join('---:' if right else '---' for right in numeric)}|")
    lines += [_row([_text(cell) for cell in row]) for row in table.rows]
    return "\n".join(lines) + "\n"


def _row(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _text(cell: Cell) -> str:
    if cell is None:
        return ""
    return cell if isinstance(cell, str) else f"{cell:,}"

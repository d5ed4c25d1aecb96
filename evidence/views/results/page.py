"""docs/project/results.md, as text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from evidence.views.results.records import Cell, Record, Table
from evidence.views.results.runs import RUNS, SECOND

_INTRODUCTION = """\
# Results

The numbers of runs; no other page has any. `s7check results RUN` runs a command and keeps a summary of its report in
`docs/project/results/`, `s7check results --write` makes this page from these summaries. The revision is that of
the checkout at the run, with `+` if files differed from it. Load is that of the machine when the run began: other work
lengthens the seconds.
"""


def page(records: Mapping[str, Record]) -> str:
    """The page: every run with its kept summary."""
    return "\n".join(_sections(records))


def _sections(records: Mapping[str, Record]) -> Iterator[str]:
    yield _INTRODUCTION
    for name, run in RUNS.items():
        yield f"## {run.title}\n\n{run.about}\n"
        if name in records:
            yield from _record(records[name])
        else:
            yield f"`{run.typed}` has not been run.\n"
        if name + SECOND in records:
            yield f"### {run.title} on a second TLC\n"
            yield from _record(records[name + SECOND])


def _record(record: Record) -> Iterator[str]:
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

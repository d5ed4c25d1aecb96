"""The answer of ``s7check next`` as text."""

from collections.abc import Iterator

import click

from s7check.asking.differences import Difference
from s7check.asking.line_text import iso_of
from s7check.asking.next_answer import NextAnswer
from s7check.asking.rows import Row, rows
from s7check.report.report import clause_text

_SHOWN = 3
_ONLY_SOME = "the log has very many explanations, of which some were asked: more lines may be possible than these"


def to_text(answer: NextAnswer) -> str:
    """The situation, due events, possible events, the differences, and the requirements."""
    return "\n".join(_lines(answer))


def _lines(answer: NextAnswer) -> Iterator[str]:
    yield f"{answer.place}: {answer.message}"
    several = len(answer.situations)
    for number, state in enumerate(answer.situations[:_SHOWN], 1):
        yield _heading("now" if several == 1 else f"now, explanation {number} of {several}")
        yield from (f"    {topic}: {text}" for topic, text in state.said)
    if answer.questions:
        yield _heading("the explanations differ by what the sources leave open")
        yield from (f"    {one.text}" for one in answer.questions)
    yield from _due(answer)
    if not answer.possible.whole:
        yield f"  {_ONLY_SOME}"
    found = rows(answer.possible)
    yield from _table("may come", [row for row in found if not row.event.isupper()])
    yield from _table("may be called", [row for row in found if row.event.isupper()])
    yield from _differences(answer)
    ids = {name for row in found for name in row.requirements}
    ids |= {name for time in answer.possible.times for name in time.requirements}
    yield _heading("requirements")
    yield from (f"    {clause_text(name)}" for name in sorted(ids))


def _heading(text: str) -> str:
    return f"  {click.style(text, bold=True)}:"


def _due(answer: NextAnswer) -> Iterator[str]:
    due = [time for time in answer.possible.times if time.due]
    if due:
        yield _heading("may have to come" if answer.possible.endless else "must come")
    for time in due:
        what = " or ".join(allowed.text for allowed in time.due)
        yield f"    {what}, by {iso_of(time.at)}{_ids(time.requirements)}"


def _table(heading: str, found: list[Row]) -> Iterator[str]:
    if found:
        yield _heading(heading)
    for row in found:
        such = f", such as {row.example}" if row.example else ""
        yield f"    {row.text}, {row.when}{such}{_ids(row.requirements)}"


def _ids(names: list[str] | tuple[str, ...]) -> str:
    return f" [{', '.join(names)}]" if names else ""


def _differences(answer: NextAnswer) -> Iterator[str]:
    for name, refusal in answer.broken.items():
        yield _heading(f"under {name}")
        yield f"    {refusal}"
    if not answer.differences:
        if answer.columns:
            yield _heading("differs")
            yield f"    nothing, under {', '.join(answer.columns)}"
        return
    yield _heading("differs")
    yield from _grid(["", "this log", *answer.columns], answer.differences)


def _grid(head: list[str], found: list[Difference]) -> Iterator[str]:
    body = [[one.example + (f" and {one.others} like it" if one.others else ""), *one.cells] for one in found]
    widths = [max(len(row[i]) for row in [head, *body]) for i in range(len(head))]
    for row in [head, *body]:
        yield "    " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()

"""``s7check explain``."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import click
import msgspec

from s7check.asking.log_prefix import Prefix, read_prefix
from s7check.asking.session import Session
from s7check.completion import complete_files
from s7check.ending import ending
from s7check.engine import pool
from s7check.explaining.sentences import by_itself, of_line
from s7check.output import echo
from s7check.report.report import clause_text

_HELP = """Tell a log in sentences, with the requirements behind them.

LOG is a log of `s7check trace`, for instance one that `s7check import` made of a diagnostic buffer; LOG:7 is the log up
to its line 7. Each line has what happened by itself before it, what it says, and what it brings about.

Exit codes: 0 told, 1 a line is not possible (the lines before it are told), 2 the log cannot be used, 3 the
specification could not be evaluated.
"""


@dataclass(frozen=True)
class Told:
    """A line in sentences; ``explanations``: in how many ways the log may be explained there, of which one is told."""

    line: int
    at: str
    sentences: list[str]
    requirements: list[str]
    explanations: int


@click.command("explain", help=_HELP, short_help="Tell a log in sentences, with the requirements behind them.")
@click.option(
    "--format", "output", type=click.Choice(["text", "json"]), default="text", show_default=True, help="Form."
)
@click.argument("log", metavar="LOG[:LINE]", shell_complete=complete_files)
def explain_command(output: str, log: str) -> int:
    """Tell the log."""
    named: set[str] = set()
    code = 0
    with ending(log), pool.engine() as engine:
        prefix = read_prefix(engine, log)
        for told in story(Session(engine, prefix.header), prefix):
            named.update(told.requirements)
            echo(_text(told) if output == "text" else msgspec.json.encode(told).decode())
            code = 1 if told.explanations == 0 else 0
    if output == "text" and named:
        echo("\n".join(["", *(clause_text(name) for name in sorted(named))]))
    return code


def story(session: Session, prefix: Prefix) -> Iterator[Told]:
    """The lines of the log as they come; a line that is not possible is the last, with no explanation.

    Raises EngineError.
    """
    then = session.situations()[0]
    for number, line in prefix.events:
        before = session.before(line)
        if not before:
            yield _refused(session, number, line)
            return
        possible = session.possible([line], line["at"]).lines
        grounds = list(dict.fromkeys(name for one in possible for name in one.requirements))
        session.feed(line)
        after = session.situations()
        sentences = [*by_itself(then, before[0]), *of_line(line, before[0], after[0])]
        yield Told(number, line["at"], sentences, grounds, len(after))
        then = after[0]


def _refused(session: Session, number: int, line: dict[str, Any]) -> Told:
    refusal = session.why(line)
    assert refusal is not None
    expected = ", ".join(one.text for one in refusal.expected) or "nothing"
    how = "something had to come before" if refusal.late else "not possible"
    why = refusal.why.removesuffix(".")
    return Told(number, line["at"], [f"{how}: expected {expected}", *filter(None, [why])], refusal.requirements, 0)


def _text(told: Told) -> str:
    text = "; ".join(told.sentences)
    ids = f" [{', '.join(told.requirements)}]" if told.requirements else ""
    several = f" (one of {told.explanations} explanations)" if told.explanations > 1 else ""
    return f"{told.line} {told.at}  {text[:1].upper()}{text[1:]}.{ids}{several}"

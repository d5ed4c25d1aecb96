"""What ``s7check next`` finds out."""

from collections.abc import Iterable
from dataclasses import dataclass

from s7check.asking.answers import Possible
from s7check.asking.differences import Difference, differences
from s7check.asking.log_prefix import Prefix
from s7check.asking.open_questions import OpenQuestion, open_questions
from s7check.asking.session import Session
from s7check.asking.variants import Variant
from s7check.engine.answer import Refusal, Situation
from s7check.engine.client import Engine

SHARE = 16
"""Explanations of a log that are asked for each line: one that leaves kinds of event out may have hundreds."""


@dataclass(frozen=True)
class NextAnswer:
    """The situation after a log, and the events that may come.

    ``columns`` are the other headers under which the log can be explained, ``differences`` have a cell for the log's
    own header and one for each of these; the explanations of the log differ by ``questions``; ``broken`` says of the
    others at which line they reject the log.
    """

    place: str
    message: str
    situations: list[Situation]
    possible: Possible
    columns: list[str]
    differences: list[Difference]
    broken: dict[str, str]
    questions: list[OpenQuestion]


def opened(engine: Engine, prefix: Prefix) -> tuple[Session, int, Refusal | None]:
    """A session with the lines of the log, up to its end or to a line that is not possible.

    With the number of the last line in the session, and why the next one is not possible.
    """
    session = Session(engine, prefix.header)
    last = 1
    for number, event in prefix.events:
        refusal = session.feed(event)
        if refusal is not None:
            return session, last, refusal
        last = number
    return session, last, None


def what_is_next(engine: Engine, prefix: Prefix, others: Iterable[Variant]) -> NextAnswer:
    """The answer for a log, with the differences under other headers."""
    session, last, refusal = opened(engine, prefix)
    message = "after this line"
    if refusal is not None:
        message = "after this line; the next line of the log is not possible (--why says why)"
    possible = session.possible(most=SHARE)
    columns: dict[str, Possible] = {}
    broken: dict[str, str] = {}
    for variant in others:
        other, stopped = session.under(variant.of(session.header))
        if stopped is None:
            columns[variant.name] = other.possible(most=SHARE)
        else:
            number = prefix.events[len(other.lines)][0]
            broken[variant.name] = f"line {number} is not possible: {', '.join(stopped.requirements)}"
        other.close()
    return NextAnswer(
        f"{prefix.name}:{last}",
        message,
        session.situations(),
        possible,
        list(columns),
        differences({"this log": possible, **columns}) if columns else [],
        broken,
        open_questions(engine, session),
    )

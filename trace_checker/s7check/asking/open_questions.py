"""The open questions by which the explanations of a log differ."""

from dataclasses import dataclass

import msgspec

from s7check.asking.session import Session
from s7check.engine.client import Engine
from s7check.log.errors import ranges
from s7check.report.clauses import clause

_MOST = 64
"""Situations that are compared."""

_LONGEST = 200
"""Lines of a log that is followed under each letter."""


@dataclass(frozen=True)
class OpenQuestion:
    """A question that the sources leave open, and the numbers of the explanations that each of its letters leaves."""

    name: str
    explanations: dict[str, list[int]]

    @property
    def text(self) -> str:
        """The question, and for each of its answers the explanations."""
        found = clause(self.name)
        answers = [
            f"({letter}) {found.letters.get(letter, '')}: explanation{'s' * (len(numbers) > 1)} {ranges(numbers)}"
            for letter, numbers in sorted(self.explanations.items())
        ]
        return f"{self.name} {found.text} {'; '.join(answers)}"


def open_questions(engine: Engine, session: Session) -> list[OpenQuestion]:
    """The questions of which a letter leaves some of the explanations of the session's log, and another letter others.

    The specification answers: the log is followed under each letter of each question that it has met. Raises
    EngineError. None of a long log.
    """
    ours = _situations(session)
    if len(ours) < 2 or len(session.lines) > _LONGEST:
        return []
    asked = _asked(engine, session)
    named = session.header.get("readings", {})
    found = []
    for name, letters in engine.alternatives().letters:
        if name in named or (asked is not None and name not in asked):
            continue
        left = {letter: _under(session, name, letter) for letter in letters}
        parts = {letter: some for letter, some in left.items() if some and some < set(ours)}
        if set().union(*parts.values()) == set(ours) and len({frozenset(some) for some in parts.values()}) > 1:
            numbers = {letter: sorted(ours.index(one) + 1 for one in some) for letter, some in parts.items()}
            found.append(OpenQuestion(name, numbers))
    return found


def _situations(session: Session) -> list[bytes]:
    return [msgspec.json.encode(one) for one in session.situations(most=_MOST)]


def _under(session: Session, name: str, letter: str) -> set[bytes]:
    """The situations under a letter; none if the log is not possible then."""
    other, refusal = session.under({"readings": {**session.header.get("readings", {}), name: letter}})
    try:
        return set() if refusal is not None else set(_situations(other))
    finally:
        other.close()


def _asked(engine: Engine, session: Session) -> list[str] | None:
    engine.begin()
    engine.send(b"".join(msgspec.json.encode(line) + b"\n" for line in (session.header, *session.lines)))
    return engine.finish().asked

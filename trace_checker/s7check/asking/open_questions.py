"""The open questions by which the explanations of a log differ."""

import json

import msgspec

from s7check.asking.session import Session
from s7check.engine.answer import Unusable
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.log.errors import ranges
from s7check.report.clauses import clause


class OpenQuestion(msgspec.Struct, frozen=True):
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


class _Reply(msgspec.Struct, frozen=True):
    questions: list[OpenQuestion] = []
    error: str = ""
    unusable: Unusable | None = None


def open_questions(engine: Engine, session: Session) -> list[OpenQuestion]:
    """The questions of which a letter leaves some of the explanations of the session's log, and another letter others.

    Raises EngineError. None of a log of more than 200 lines.
    """
    if len(session.situations(most=2)) < 2:
        return []
    lines = [json.dumps(line) for line in session.lines]
    reply = engine.ask({"message": "questions", "header": json.dumps(session.header), "lines": lines}, _Reply)
    if reply.unusable is not None:
        raise reply.unusable.error()
    if reply.error:
        raise EngineError(reply.error)
    return reply.questions

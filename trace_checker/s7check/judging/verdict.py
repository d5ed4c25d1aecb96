"""The verdict about a log."""

from dataclasses import dataclass, field
from typing import Literal

from s7check.engine.answer import Candidate, Situation, Step

Verdict = Literal["accepted", "rejected", "unusable", "no verdict"]

EXIT_CODES: dict[Verdict, int] = {"accepted": 0, "rejected": 1, "unusable": 2, "no verdict": 3}


@dataclass(frozen=True)
class Reading:
    """The verdict about the same log under another header: ``change`` names the difference.

    ``kind`` is the changed part, ``line`` the line that decides.
    """

    kind: Literal["cpu", "profile", "letter"]
    change: str
    verdict: Verdict
    line: int | None = None


@dataclass(frozen=True)
class Report:
    """The verdict about one log.

    ``line`` is the physical line that decides, or None; ``events`` the number of events explained before it; ``event``
    the text of the rejected line, or None if it is no longer at hand; ``expected`` the events that the specification
    allows there; ``requirements`` the IDs that decide.

    Of a rejected log also: ``late``, if the line comes too late: the events ``expected`` before it, and until when;
    ``states``, the number of explanations of the lines before; ``situations``, those of the explanations nearest to the
    line; ``candidates``, each an action with its first false conjunct. ``readings`` is None if no others were to be
    tried; ``untried`` are readings for which there was no time. ``asked`` are the open questions whose letter the
    verdict depends on, None if it may depend on any. ``lines`` are the log's lines from the first one, as
    far as they are at hand, ``steps`` the situations after them. ``after`` says how the judging
    went on behind the rejection before, if this is not the first.
    """

    log: str
    verdict: Verdict
    message: str
    line: int | None = None
    events: int = 0
    event: bytes | None = None
    expected: list[str] = field(default_factory=list)
    requirements: list[str] = field(default_factory=list)
    late: list[str] = field(default_factory=list)
    states: int = 0
    situations: list[Situation] = field(default_factory=list)
    candidates: list[Candidate] = field(default_factory=list)
    readings: list[Reading] | None = None
    untried: list[str] = field(default_factory=list)
    outcomes: list[int] = field(default_factory=list, repr=False)
    open: list[int] = field(default_factory=list, repr=False)
    classes: list[int] = field(default_factory=list, repr=False)
    asked: list[str] | None = field(default=None, repr=False)
    decided: list[str] = field(default_factory=list)
    decidable: int = 0
    lines: list[bytes] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)
    after: str = ""

    @property
    def exit_code(self) -> int:
        """The exit code that the verdict stands for."""
        return EXIT_CODES[self.verdict]

    def __str__(self) -> str:
        """The report as ``s7check trace`` prints it, without colours."""
        from s7check.report.as_text import as_text  # the verdict itself does without it

        return as_text(self)

"""The report about one log: its fields, and the parts of it that all formats for people share."""

from collections.abc import Callable, Iterable, Iterator
from typing import Literal

import msgspec

from s7check.engine.answer import Candidate, Part, Refusal, Situation, Step
from s7check.log.errors import printable
from s7check.report.clauses import clause

LONGEST_LINE = 400

Verdict = Literal["accepted", "rejected", "unusable", "no verdict"]

EXIT_CODES: dict[Verdict, int] = {"accepted": 0, "rejected": 1, "unusable": 2, "no verdict": 3}


class Reading(msgspec.Struct, frozen=True):
    """The verdict about the same log under another header: ``change`` names the difference.

    ``kind`` is the changed part, ``line`` the line that decides.
    """

    kind: Literal["cpu", "profile", "letter"]
    change: str
    verdict: Verdict
    line: int | None = None


class Report(msgspec.Struct, frozen=True):
    """The verdict about one log.

    ``line`` is the physical line that decides, or None; ``events`` the number of events explained before it; ``event``
    the text of the rejected line, or None if it is no longer at hand; ``expected`` the events that the specification
    allows there; ``requirements`` the IDs that decide. From the line ``certain_from`` on only definite facts were
    checked, if it is not None.

    Of a rejected log also: ``why`` it is, in a sentence; ``late``, if the line comes too late: the events
    ``expected`` before it, and until when; ``states``, the number of explanations of the lines before;
    ``situations``, those of the explanations nearest to the line; ``candidates``, each an action with its first
    false conjunct; ``refusal`` all that the engine says of it. ``readings`` is None if no others were to be tried,
    ``compared`` what is said of them; ``untried`` are readings for which there was no time. ``asked`` are the open
    questions whose letter the verdict depends on, None if it may depend on any. ``lines`` are the log's lines from
    the first one, as far as they are at hand, ``steps`` the situations after them, ``flow`` the numbered events up
    to a rejected line, the latest ones. ``after`` says how the judging went on behind the rejection before, if this
    is not the first. The judging took ``seconds``.
    """

    log: str
    verdict: Verdict
    message: str
    line: int | None = None
    events: int = 0
    event: bytes | None = None
    expected: list[str] = []
    requirements: list[str] = []
    why: str = ""
    certain_from: int | None = None
    late: list[str] = []
    states: int = 0
    situations: list[Situation] = []
    candidates: list[Candidate] = []
    refusal: Refusal = Refusal()
    readings: list[Reading] | None = None
    untried: list[str] = []
    compared: list[Part] = []
    outcomes: list[int] = []
    open: list[int] = []
    classes: list[int] = []
    asked: list[str] | None = None
    decided: list[str] = []
    decidable: int = 0
    lines: list[bytes] = []
    steps: list[Step] = []
    flow: list[tuple[int, bytes]] = []
    after: str = ""
    seconds: float = 0

    @property
    def exit_code(self) -> int:
        """The exit code that the verdict stands for."""
        return EXIT_CODES[self.verdict]

    def __str__(self) -> str:
        """The report as ``s7check trace`` prints it, without colours."""
        return in_text(self, parts(self), self.verdict)


Cause = tuple[str, tuple[str, ...], tuple[tuple[str, str], ...]]


def cause(report: Report) -> Cause:
    """Equal for rejections for the same reason: such reports differ in little but the log."""
    return report.message, tuple(report.requirements), tuple((one.place, one.conjunct) for one in report.candidates)


def source(text: bytes) -> str:
    """A line of a log as it can be shown."""
    return printable(text.decode(errors="replace").strip(), LONGEST_LINE)


def place(report: Report) -> str:
    """Such as ``x.ndjson:7``."""
    name = printable(report.log, LONGEST_LINE)
    return name if report.line is None else f"{name}:{report.line}"


def message(report: Report) -> str:
    """The report's message, for an accepted log with the number of its events and how much of the rules it met."""
    if report.verdict != "accepted":
        return f"{report.message}; judged on after {report.after}" if report.after else report.message
    met = f"; {len(report.decided)} of {report.decidable} requirements decided something" if report.decidable else ""
    return f"{report.message} ({report.events} events){met}"


def in_text(
    report: Report, shown: Iterable[Part], verdict: str, heading: Callable[[str], str] = lambda text: text
) -> str:
    """The verdict, in such a spelling, the line and these parts of the report."""
    lines = [f"{place(report)}: {verdict}: {message(report)}"]
    if report.event is not None:
        lines.append(f"    {source(report.event)}")
    for part in shown:
        if len(part.lines) == 1 and part.heading:
            lines.append(f"  {heading(part.heading)}: {part.lines[0]}")
            continue
        if part.heading:
            lines.append(f"  {heading(part.heading)}:")
        lines += [f"    {line}" for line in part.lines]
    return "\n".join(lines)


def parts(report: Report) -> Iterator[Part]:
    """The explanation of the verdict, the most important part first."""
    yield from report.refusal.decision
    if report.verdict == "rejected":
        yield Part("", report.refusal.rules)
        if not report.after:
            yield Part("shortest prefix that fails", [f"lines 1 to {report.line}"])
    yield from report.refusal.before
    yield from report.compared
    if report.refusal.formulas:
        yield Part("formulas", report.refusal.formulas)


def clause_text(name: str) -> str:
    """Such as ``AIRT-03 Calls are counted (SF06ru, H; docs/rules/requirements.md#AIRT-03)``."""
    found = clause(name)
    origin = ", ".join(part for part in (found.source, found.confidence) if part)
    return f"{name} {found.text}" + (f" ({origin}; {found.place})" if origin else "")

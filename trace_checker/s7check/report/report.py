"""The report about one log: its fields, and the parts of it that all formats for people share."""

from collections.abc import Callable, Iterable, Iterator
from typing import Literal, NamedTuple

import msgspec

from s7check.engine.answer import Candidate, Situation, Step
from s7check.log.errors import printable
from s7check.report.clauses import clause

LONGEST_LINE = 400
MOST_EXPECTED = 12
_MOST_FORMULAS = 6

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
    false conjunct, ``formulas`` their texts. ``readings`` is None if no others were to be tried; ``untried`` are
    readings for which there was no time. ``asked`` are the open questions whose letter the verdict depends on, None
    if it may depend on any. ``lines`` are the log's lines from the first one, as far as they are at hand, ``steps``
    the situations after them, ``flow`` the numbered events up to a rejected line, the latest ones. ``after`` says
    how the judging went on behind the rejection before, if this is not the first. The judging took ``seconds``.
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
    formulas: list[str] = []
    readings: list[Reading] | None = None
    untried: list[str] = []
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


class Part(NamedTuple):
    """A heading and the lines under it; a single line stands beside it."""

    heading: str
    lines: list[str]


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
    yield from decision(report)
    if report.verdict == "rejected":
        yield Part("", [clause_text(name) for name in report.requirements])
        if not report.after:
            yield Part("shortest prefix that fails", [f"lines 1 to {report.line}"])
    for number, state in enumerate(report.situations, 1):
        of = f" {number} of {report.states}" if report.states > 1 else ""
        yield Part(f"before the line{of}", [f"{topic}: {text}" for topic, text in state.said])
    yield from readings(report)
    if shown := report.formulas[:_MOST_FORMULAS]:
        more = len(report.formulas) - len(shown)
        yield Part("formulas", [*shown, *([f"and {more} more"] if more else [])])


def decision(report: Report) -> Iterator[Part]:
    """What was expected, and the requirements that decide."""
    if report.verdict != "rejected":
        return
    if report.late:
        yield Part("expected before it", report.late)
    else:
        yield Part("expected", [_list(report.expected, MOST_EXPECTED) or "nothing"])
    yield Part("requirements", [", ".join(report.requirements)])
    if report.why:
        yield Part("why not", [report.why])


def clause_text(name: str) -> str:
    """Such as ``AIRT-03 Calls are counted (SF06ru, H; docs/rules/requirements.md#AIRT-03)``."""
    found = clause(name)
    origin = ", ".join(part for part in (found.source, found.confidence) if part)
    return f"{name} {found.text}" + (f" ({origin}; {found.place})" if origin else "")


def readings(report: Report) -> Iterator[Part]:
    """Under which other headers the verdict would be another."""
    if report.readings is None:
        return
    yield from _other_readings(report, report.readings)
    if report.untried:
        yield Part("not tried for lack of time", [_list(report.untried, MOST_EXPECTED) + " (see --budget)"])


def _other_readings(report: Report, tried: list[Reading]) -> Iterator[Part]:
    passing = [one for one in tried if one.verdict == "accepted"]
    others = [one for one in tried if one.verdict != "accepted"]
    if report.verdict == "accepted":
        yield Part("also accepted by", [f"{len(passing)} of {len(tried)} other readings"])
        yield Part("rejected by", [_outcome(one) for one in others] or ["none of them"])
        return
    yield Part("would pass with", [reading_text(one) for one in passing] or ["no other reading that was tried"])
    later = [one for one in others if one.line is not None and one.line > (report.line or 0)]
    if later:
        yield Part("would get further with", [_list([_outcome(one) for one in later], MOST_EXPECTED)])


def reading_text(one: Reading) -> str:
    """A reading with the question that it answers."""
    if one.kind != "letter":
        return one.change
    name, letter = one.change.split()
    found = clause(name)
    answer = found.letters.get(letter, "")
    return f"{one.change}: {found.text} {answer} ({found.place})" if found.text else one.change


def _outcome(one: Reading) -> str:
    where = "" if one.line is None else f" at line {one.line}"
    verdict = "" if one.verdict == "rejected" else f" {one.verdict}"
    return f"{one.change}{verdict}{where}"


def _list(texts: list[str], most: int) -> str:
    more = len(texts) - most
    return ", ".join(texts[:most]) + (f" and {more} more" if more > 0 else "")

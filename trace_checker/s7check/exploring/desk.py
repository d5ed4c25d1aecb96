"""The answers to the page: the situation of the CPU after a log, the possible events, and why others are not possible.

The page keeps the log and sends it whole, so the desk has no state that matters: it keeps sessions whose lines are
those of the last questions, and adds or takes back what differs.
"""

from collections import OrderedDict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import msgspec

from s7check.asking.answers import Line, Possible, Refusal, Time
from s7check.asking.line_text import as_line, iso_of, spelled
from s7check.asking.open_questions import open_questions
from s7check.asking.session import Session, as_answer
from s7check.asking.variants import Variant
from s7check.engine.answer import Allowed, Situation, Step
from s7check.engine.client import Engine
from s7check.exploring.library import Library
from s7check.judging.check import rejection
from s7check.judging.replay import FOLLOWED
from s7check.kit.from_log import program_of
from s7check.kit.layout import to_text
from s7check.kit.program import Program, read_program
from s7check.log.calls import OPERANDS
from s7check.report import words
from s7check.report.expected import format_allowed
from s7check.report.markup import as_text
from s7check.report.report import Report
from s7check.report.timeline import timeline
from s7check.simulating.simulation import Simulation

SESSIONS = 12
"""Sessions that are kept, each of a header that was asked for lately."""

SHARE = 16
"""Explanations of a log that are looked at for each line that may come; a log that leaves much open has thousands."""

WARM = 3
"""Logs that are looked at before the first question."""

_WITH_OPERANDS = frozenset(name for name, operands in OPERANDS.items() if operands)

Object = dict[str, Any]


class Side(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Another header to compare with: another CPU, edition, or reading such as ``AMB-12`` to ``a``."""

    cpu: str | None = None
    profile: str | None = None
    readings: dict[str, str] = {}

    @property
    def variant(self) -> Variant:
        """As the commands have it."""
        letters = tuple(self.readings.items())
        names = [*(f"{name} {letter}" for name, letter in letters)]
        name = ", ".join(part for part in (self.cpu, self.profile and f"edition {self.profile}", *names) if part)
        return Variant(name, self.cpu, self.profile, letters)


class Question(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A log, the objects of its lines, and when the next line comes; at once if that is not said."""

    header: Object
    lines: list[Object] = []
    at: str | None = None


class Call(Question, frozen=True, forbid_unknown_fields=True):
    """A log, and the event of a call after it."""

    event: str = ""


class Comparison(Question, frozen=True, forbid_unknown_fields=True):
    """A log, and another header to compare with."""

    side: Side = Side()


class Why(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A log, and a line that may not come after it."""

    header: Object
    line: Object
    lines: list[Object] = []


@dataclass
class _Kept:
    """A session, the objects of its lines as they were sent, and a situation after each of them."""

    session: Session
    sent: list[Object] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)


class Desk:
    """Answers questions with one engine. Every method may raise UnusableLogError and EngineError."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._kept: OrderedDict[bytes, _Kept] = OrderedDict()

    def look(self, question: Question) -> Object:
        """The situation after the lines, or after the last possible line, and the events that may come at the time."""
        kept, refusal = self._brought_to(question.header, question.lines)
        session = kept.session
        situations = session.situations()
        ahead = session.possible([], most=SHARE)
        at = question.at or iso_of(ahead.times[0].at)
        possible = session.possible(at=at, few=_WITH_OPERANDS, most=SHARE)
        return {
            "explained": len(kept.sent),
            "clock": session.clock,
            "refused": None if refusal is None else _refused(refusal, question.lines[len(kept.sent)]),
            "situations": [list(map(list, words.situation(state))) for state in situations],
            "states": possible.states,
            "whole": possible.whole,
            "tries": possible.tries,
            "at": at,
            "times": [_time(one) for one in ahead.times],
            "endless": ahead.endless,
            "possible": [_line(one) for one in possible.lines],
            "impossible": list(self._impossible(session, at, situations, possible)) if possible.whole else None,
            "timeline": _timeline(kept, refusal, question),
        }

    def timeline(self, question: Question) -> Object:
        """The timeline of the lines."""
        kept, refusal = self._brought_to(question.header, question.lines)
        return {"timeline": _timeline(kept, refusal, question)}

    def questions(self, question: Question) -> Object:
        """The open questions by which the explanations of the lines differ, each as a text with its answers."""
        kept, _ = self._brought_to(question.header, question.lines)
        return {"questions": [one.text for one in open_questions(self._engine, kept.session)]}

    def program(self, question: Question) -> Object:
        """The lines as a program of the kit: its text, laid out."""
        texts = [msgspec.json.encode(each) for each in (question.header, *question.lines)]
        raw = program_of(self._engine, texts, "explored", "Built in the explorer.", [])
        read_program(msgspec.json.encode(raw))
        return {"text": to_text(raw)}

    def run(self, program: Program) -> Object:
        """The log of a program: the specification runs it, and everything comes as early as it may."""
        simulation = Simulation(self._engine, program)
        try:
            header, *lines = simulation.run()
        finally:
            simulation.close()
        return {"name": program.name, "header": header, "lines": lines}

    def call(self, question: Call) -> Object:
        """The calls with this event that may come at the time, with operands that stand for all."""
        kept, _ = self._brought_to(question.header, question.lines)
        possible = kept.session.possible(at=question.at, only=[question.event], most=SHARE)
        return {"possible": [_line(one) for one in possible.lines]}

    def answers(self, question: Why) -> Object:
        """The answers that a call may get after the lines, each as a line; none where it is not possible."""
        kept, _ = self._brought_to(question.header, question.lines)
        possible = kept.session.possible([question.line], question.line.get("at"))
        return {"possible": [_line(one) for one in possible.lines]}

    def why(self, question: Why) -> Object:
        """Why the line may not come after the lines; ``refused`` is null if it may."""
        kept, _ = self._brought_to(question.header, question.lines)
        refusal = kept.session.why(question.line)
        return {"refused": None if refusal is None else _refused(refusal, question.line)}

    def _brought_to(self, header: Object, lines: Sequence[Object]) -> tuple[_Kept, Refusal | None]:
        """A session with the lines, as far as they are possible, and why the next one is not."""
        key = msgspec.json.encode(header, order="sorted")
        kept = self._kept.get(key)
        if kept is None:
            kept = self._kept[key] = _Kept(Session(self._engine, header))
            while len(self._kept) > SESSIONS:
                _, oldest = self._kept.popitem(last=False)
                oldest.session.close()
        self._kept.move_to_end(key)
        try:
            return kept, _advance(kept, lines)
        except BaseException:
            # Nobody knows how far it came.
            self._kept.pop(key, None)
            raise

    def compare(self, question: Comparison) -> Object:
        """The differences under another header: the first line that is not possible there, or the other events."""
        here, _ = self._brought_to(question.header, question.lines)
        header = question.side.variant.of(question.header)
        there, refusal = self._brought_to(header, question.lines)
        answer: Object = {"name": question.side.variant.name, "header": header, "explained": len(there.sent)}
        if refusal is not None:
            return answer | {"refused": _refused(refusal, question.lines[len(there.sent)])}
        mine, theirs = (_texts(kept.session.possible(at=question.at, most=SHARE)) for kept in (here, there))
        return answer | {"refused": None, "only_here": sorted(mine - theirs), "only_there": sorted(theirs - mine)}

    def _impossible(
        self, session: Session, at: str, situations: Sequence[Situation], possible: Possible
    ) -> Iterator[Object]:
        """The steps of the CPU that somebody might wait for and that may not come then, each with its reason."""
        offered = {spelled(_bare(line.event)) for line in possible.lines}
        for event in _looked_for(situations):
            if spelled(event) in offered or any(text.startswith(f"{spelled(event)} ") for text in offered):
                continue
            refusal = session.why({"at": at, **event})
            if refusal is not None:
                yield {"event": event, **_refused(refusal, event)}


def warm(engine: Engine, library: Library) -> None:
    """Looks at some logs: the first answers of an engine take several times as long as the later ones."""
    desk = Desk(engine)
    for case in library.contents()["gallery"][:WARM]:
        log = library.open(case["name"])
        desk.look(Question(log["header"], log["lines"]))


def _timeline(kept: _Kept, refusal: Refusal | None, question: Question) -> str:
    texts = [msgspec.json.encode(each) for each in (question.header, *question.lines)]
    steps = kept.steps[-FOLLOWED:]
    if refusal is None:
        report = Report("-", "accepted", "", events=len(kept.sent), lines=texts, steps=steps)
    else:
        line = len(kept.sent) + 2
        report = replace(rejection("-", as_answer(refusal, line), texts[line - 1], texts), steps=steps)
    picture = timeline(report)
    return "" if picture is None else as_text(picture.labels) + as_text(picture.lanes)


def _advance(kept: _Kept, lines: Sequence[Object]) -> Refusal | None:
    same = 0
    for old, new in zip(kept.sent, lines, strict=False):
        if old != new:
            break
        same += 1
    if same < len(kept.sent):
        kept.session.undo(len(kept.sent) - same)
        del kept.sent[same:], kept.steps[same:]
    for line in lines[same:]:
        refusal = kept.session.feed(line)
        if refusal is not None:
            return refusal
        kept.sent.append(line)
        kept.steps.append(Step(len(kept.sent) + 1, kept.session.situations(most=1)[0]))
    return None


def _looked_for(situations: Sequence[Situation]) -> list[Object]:
    """The starts of all loaded OBs, the ends of running OBs, and the change to RUN."""
    starts = sorted({ob for state in situations for ob in state.loaded} | {1})
    ends = sorted({frame.ob for state in situations for frame in state.running})
    return [
        *({"event": "start", "ob": ob} for ob in starts),
        *({"event": "end", "ob": ob} for ob in ends),
        {"event": "run"},
        {"event": "stop"},
    ]


def _bare(event: Object) -> Object:
    """A line without its start information, as :func:`_looked_for` has it."""
    return {name: value for name, value in as_line(event).items() if name != "info"}


def _time(one: Time) -> Object:
    due = [format_allowed(allowed) for allowed in one.due]
    return {"at": iso_of(one.at), "due": due, "requirements": one.requirements}


def _line(line: Line) -> Object:
    event = as_line(line.event)
    return {"event": event, "text": spelled(event), "requirements": line.requirements}


def _texts(possible: Possible) -> set[str]:
    return {spelled(as_line(line.event)) for line in possible.lines}


def _refused(refusal: Refusal, line: Object) -> Object:
    """A refusal in words; ``expected`` are texts, ``instead`` the same as values of a line's fields."""
    report = rejection("-", as_answer(refusal, 1), msgspec.json.encode(line), [])
    return {
        "late": refusal.late,
        "message": report.message,
        "why": report.why,
        "expected": report.late or report.expected,
        "instead": [_instead(allowed) for allowed in refusal.expected],
        "requirements": refusal.requirements,
        "because": [
            {"text": words.candidate(one), "requirements": one.requirements, "place": one.place}
            for one in report.candidates
        ],
    }


def _instead(allowed: Allowed) -> Object:
    line: Object = {"event": allowed.event} | ({"ob": allowed.ob} if allowed.ob else {})
    if allowed.field:
        given = msgspec.to_builtins(allowed.time) if allowed.field == "time" else allowed.value
        value = as_line({"event": allowed.event, allowed.field: given})[allowed.field]
        line |= {"info": {allowed.field: value}} if allowed.event == "start" else {allowed.field: value}
    return line

"""The answers to the page: what the CPU is in after a log, what may come, and what may not and why.

The page keeps the log and sends it whole, so the desk has no state that matters: it keeps sessions whose lines are
those of the last questions, and adds or takes back what differs.
"""

from collections import OrderedDict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec

from s7check.asking.answers import Line, Possible, Refusal, Time
from s7check.asking.line_text import as_line, iso_of, spelled
from s7check.asking.session import Session, as_answer
from s7check.asking.variants import Variant
from s7check.engine.answer import Allowed, Situation
from s7check.engine.client import Engine
from s7check.judging.check import rejection
from s7check.judging.replay import Replay, with_steps
from s7check.judging.verdict import Report
from s7check.report import words
from s7check.report.expected import format_allowed
from s7check.report.markup import as_text
from s7check.report.timeline import timeline

SESSIONS = 12
"""Sessions that are kept, each of a header that was asked for lately."""

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
    """A log, the objects of its lines, and the other headers to compare with."""

    header: Object
    lines: list[Object] = []
    sides: list[Side] = []


class Why(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A log, and a line that may not come after it."""

    header: Object
    line: Object
    lines: list[Object] = []


@dataclass
class _Kept:
    """A session, and the objects of its lines as they were sent."""

    session: Session
    sent: list[Object] = field(default_factory=list)


class Desk:
    """Answers questions with one engine. Every method may raise UnusableLogError and EngineError."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._kept: OrderedDict[bytes, _Kept] = OrderedDict()

    def look(self, question: Question) -> Object:
        """The situation after the lines, or after the last one that is possible, and what may come."""
        kept, refusal = self._brought_to(question.header, question.lines)
        session = kept.session
        situations = session.situations()
        possible = session.possible()
        return {
            "explained": len(kept.sent),
            "clock": session.clock,
            "refused": None if refusal is None else _refused(refusal),
            "situations": [list(map(list, words.situation(state))) for state in situations],
            "times": [_time(one) for one in possible.times],
            "endless": possible.endless,
            "possible": [_line(one) for one in possible.lines],
            "impossible": list(self._impossible(session, situations, possible)),
            "sides": [self._side(side, question) for side in question.sides],
            "timeline": self._timeline(question),
        }

    def answers(self, question: Why) -> Object:
        """The answers that a call may get after the lines, each as a line; none where it is not possible."""
        kept, _ = self._brought_to(question.header, question.lines)
        possible = kept.session.possible([question.line])
        return {"times": [_time(one) for one in possible.times], "possible": [_line(one) for one in possible.lines]}

    def why(self, question: Why) -> Object:
        """Why the line may not come after the lines; ``refused`` is null if it may."""
        kept, _ = self._brought_to(question.header, question.lines)
        refusal = kept.session.why(question.line)
        return {"refused": None if refusal is None else _refused(refusal)}

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

    def _impossible(self, session: Session, situations: Sequence[Situation], possible: Possible) -> Iterator[Object]:
        """The steps of the CPU that somebody might wait for and that may not come now, each with its reason."""
        offered = {spelled(_bare(line.event)) for line in possible.lines if line.first == 0}
        for event in _looked_for(situations):
            if spelled(event) in offered or any(text.startswith(f"{spelled(event)} ") for text in offered):
                continue
            refusal = session.why({"at": session.clock, **event})
            if refusal is not None:
                yield {"event": event, **_refused(refusal)}

    def _side(self, side: Side, question: Question) -> Object:
        """What is different under another header: the first line that is not possible there, or what may come."""
        header = side.variant.of(question.header)
        kept, refusal = self._brought_to(header, question.lines)
        answer: Object = {"name": side.variant.name, "header": header, "explained": len(kept.sent), "refused": None}
        if refusal is not None:
            return answer | {"refused": _refused(refusal)}
        possible = kept.session.possible()
        return answer | {"possible": sorted({spelled(as_line(line.event)) for line in possible.lines})}

    def _timeline(self, question: Question) -> str:
        texts = [msgspec.json.encode(each) for each in (question.header, *question.lines)]
        replay = Replay("-", texts)
        answer = replay.judge(self._engine, replay.header)
        if answer.verdict == "rejected" and answer.line is not None:
            report = rejection("-", answer, texts[answer.line - 1], texts)
        else:
            report = Report("-", "accepted", "", events=answer.events)
        picture = timeline(with_steps(report, self._engine, replay))
        return "" if picture is None else as_text(picture.labels) + as_text(picture.lanes)


def _advance(kept: _Kept, lines: Sequence[Object]) -> Refusal | None:
    same = 0
    for old, new in zip(kept.sent, lines, strict=False):
        if old != new:
            break
        same += 1
    if same < len(kept.sent):
        kept.session.undo(len(kept.sent) - same)
        del kept.sent[same:]
    for line in lines[same:]:
        refusal = kept.session.feed(line)
        if refusal is not None:
            return refusal
        kept.sent.append(line)
    return None


def _looked_for(situations: Sequence[Situation]) -> list[Object]:
    """The starts of all loaded OBs, the ends of those that run, and the change to RUN."""
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
    return {
        "event": event,
        "text": spelled(event),
        "first": line.first,
        "last": line.last,
        "requirements": line.requirements,
    }


def _refused(refusal: Refusal) -> Object:
    """A refusal in words; ``expected`` are texts, ``instead`` the same as values of a line's fields."""
    report = rejection("-", as_answer(refusal, 1), b"{}", [])
    return {
        "late": refusal.late,
        "message": report.message,
        "expected": report.late or report.expected,
        "instead": [_instead(allowed) for allowed in refusal.expected],
        "requirements": refusal.requirements,
        "because": [
            {"text": words.candidate(one), "requirements": one.requirements, "place": one.place}
            for one in report.candidates
        ],
    }


def _instead(allowed: Allowed) -> Object:
    named = {"event": allowed.event} | ({"ob": allowed.ob} if allowed.ob else {})
    value = {allowed.field: allowed.value} if allowed.field else {}
    return as_line(named) | as_line({"event": allowed.event, **value}) if allowed.event != "call" else {"event": "call"}

"""The engine's answers, as they come over the wire."""

from typing import Any, Literal, NamedTuple

import msgspec

from s7check.log.errors import UnusableLogError


class Moment(msgspec.Struct, frozen=True):
    """A point in time: minutes since 1990-01-01T00:00 and the milliseconds in the minute."""

    min: int = 0
    ms: int = 0


class Allowed(msgspec.Struct, frozen=True):
    """Something that the specification allows instead of the rejected line.

    ``ob`` is 0 where none belongs to it, ``field`` the field that must have ``value`` or empty; the field ``time``
    must have ``time``. ``text`` says it in the words of the log format.
    """

    event: str
    ob: int = 0
    field: str = ""
    value: int = 0
    time: Moment = Moment()
    text: str = ""


class Candidate(msgspec.Struct, frozen=True):
    """An action that might have explained the line, and its first false conjunct.

    ``values`` are the operands of the conjunct, ``place`` is its module and line, ``requirements``
    are the IDs that the specification names there.
    """

    action: str
    conjunct: str
    values: str = ""
    place: str = ""
    requirements: list[str] = []


class Frame(msgspec.Struct, frozen=True):
    """An OB that runs or was interrupted."""

    ob: int
    class_: int = msgspec.field(name="class", default=0)


class Pending(msgspec.Struct, frozen=True):
    """A start event whose OB has not started.

    ``open``: the sources leave open whether it has an effect; ``ready``: its OB may start now;
    ``missing``: its OB is not loaded; ``follows``: the fault of the OB 80 that comes first, or 0.
    """

    ob: int
    class_: int = msgspec.field(name="class", default=0)
    rank: int = 1
    fault: int = 0
    since: Moment = Moment()
    cause: int = 0
    late: list[int] = []
    follows: int = 0
    open: bool = False
    ready: bool = False
    missing: bool = False


class TimeOfDay(msgspec.Struct, frozen=True):
    """A time-of-day interrupt that is set; ``next`` is watched for where ``armed``."""

    ob: int
    active: bool = False
    period: int = 0
    start: Moment = Moment()
    next: Moment = Moment()
    armed: bool = False


class Delay(msgspec.Struct, frozen=True):
    """A time-delay interrupt that is started, with the milliseconds that are left."""

    ob: int
    left: int = 0
    dtime: int = 0
    sign: int = 0


class BroughtBack(msgspec.Struct, frozen=True):
    """What a hot restart brings back: OBs that go on, their delay count, OBs that wait, OBs whose delays run."""

    running: list[Frame] = []
    delay: int = 0
    pending: list[int] = []
    dint: list[int] = []


class Situation(msgspec.Struct, frozen=True):
    """The CPU before a line, ``Situation`` of the specification.

    ``running`` has the running OB last; ``stop`` is the cause of a STOP that must come, or -1;
    ``waited`` the milliseconds for which each priority class could have started an OB; where it is to be shown, it is
    ``said`` in words, each statement with its topic.
    """

    mode: str = "STOP"
    clock: Moment = Moment()
    running: list[Frame] = []
    delay: int = 0
    loaded: list[int] = []
    blocked: list[int] = []
    silenced: list[int] = []
    stop: int = -1
    latency: int = 0
    waited: list[tuple[int, int]] = []
    kept: BroughtBack = BroughtBack()
    pending: list[Pending] = []
    tod: list[TimeOfDay] = []
    dint: list[Delay] = []
    said: list[tuple[str, str]] = []


class Step(msgspec.Struct, frozen=True):
    """The situation after a line that was explained."""

    line: int
    situation: Situation


class Unusable(msgspec.Struct, frozen=True):
    """Why a line is not of the format; ``line`` is 0 and ``field`` None where there is none.

    In a source of which a log is made it has a ``place``, such as an entry.
    """

    expected: str
    found: str
    field: str | None = None
    line: int = 0
    place: str = ""

    def error(self) -> UnusableLogError:
        """The exception."""
        return UnusableLogError(self.expected, self.found, self.field, self.line)


class OtherHeader(msgspec.Struct, frozen=True):
    """A header beside that of a log: what of it is another, in words and as choices in its place.

    Those of the least ``distance`` bear most on the verdict; under the ``same`` the log is rejected alike.
    """

    kind: Literal["cpu", "profile", "letter"]
    change: str
    chosen: dict[str, Any]
    distance: int = 0
    same: bool = False


class Content(msgspec.Struct, frozen=True):
    """The content of a log: its header and its events, normalised, up to what is ``unusable``.

    Events have the field ``line``, the number of their physical line.
    """

    header: dict[str, Any] | None = None
    events: list[dict[str, Any]] = []
    unusable: Unusable | None = None
    others: list[OtherHeader] = []


class Answer(msgspec.Struct, frozen=True):
    """The engine's answer to one log; ``events`` were explained before it was decided.

    Of an ``unusable`` one: why a line is not of the format. Of a rejected one: the events ``expected`` in the place of
    the line, or before it where the line comes too ``late``; the ``requirements`` that decide. From the line
    ``loose`` on only definite facts were followed: the log is ``partial``, or there were too many explanations; from
    the line ``wide`` on waiting start events were not told apart. ``steps`` are there if the log was begun with
    ``follow``. What it cost: ``largest`` states at a time at the most, and a state was ``followed`` to its successors
    so many times.

    The ``outcomes`` are those of decisions on the way of all explanations of the lines before: 2k where decision k was
    true, has another value or was an action that was taken, 2k + 1 where it was false; the ``open`` ones are those of
    some explanations. ``classes`` are the priority classes in which OBs have started. ``asked`` are the open questions
    whose letter the verdict depends on; if it is None, any may be.
    """

    verdict: Literal["accepted", "rejected", "unusable", "error"]
    line: int | None = None
    events: int = 0
    late: bool = False
    expected: list[Allowed] = []
    requirements: list[str] = []
    message: str = ""
    unusable: Unusable | None = None
    loose: int | None = None
    partial: bool = False
    wide: int | None = None
    steps: list[Step] = []
    largest: int = 0
    followed: int = 0
    outcomes: list[int] = []
    open: list[int] = []
    classes: list[int] = []
    asked: list[str] | None = None


class Part(NamedTuple):
    """A part of a report: a heading and the lines under it; a single line stands beside it."""

    heading: str
    lines: list[str]


class Refusal(msgspec.Struct, frozen=True):
    """Why a line is not possible; its first fields as in :class:`Answer`.

    ``message`` and ``why`` say so, ``wanted`` what was expected. So many ``states`` explained the lines before, the
    ``situations`` come nearest to the line. The others are parts of a report, and lines of such: the ``decision``, the
    ``rules``, the CPU ``before`` the line, the ``formulas`` of the candidates.
    """

    late: bool = False
    expected: list[Allowed] = []
    requirements: list[str] = []
    message: str = ""
    why: str = ""
    wanted: list[str] = []
    states: int = 0
    situations: list[Situation] = []
    candidates: list[Candidate] = []
    decision: list[Part] = []
    rules: list[str] = []
    before: list[Part] = []
    formulas: list[str] = []


class Decision(msgspec.Struct, frozen=True):
    """A place at which the specification decides: a definition, or a condition in one.

    ``line`` and ``column`` are where it begins; ``text`` is the text of a condition. The specification names the
    ``requirements`` there.
    """

    kind: Literal["ACTION", "DEFINITION", "GUARD", "CONDITION"]
    module: str
    definition: str
    line: int
    column: int
    text: str = ""
    requirements: list[str] = []


class Alternatives(msgspec.Struct, frozen=True):
    """The words of a log: what a header and a call may say, ``Words`` and ``Alternatives`` of the specification.

    ``settable`` are families whose priority ``classes`` can be set; ``unknown`` are the OBs that a family lacks,
    ``usual`` the default classes. Families of ``local`` have local time, OBs from 123 on and queues.
    ``choices`` are the letters that a header may name, ``letters`` those that formulas tell apart. The OBs of
    ``faulty`` come with a fault id; ``startup`` has the OB of each restart. ``answers`` are calls with the RET_VALs
    that they may have, but for SFC 41, which answers a count.
    """

    families: list[str] = []
    settable: list[str] = []
    classes: list[tuple[str, list[tuple[int, list[int]]]]] = []
    unknown: list[tuple[str, list[int]]] = []
    local: list[str] = []
    usual: list[tuple[str, list[tuple[int, int]]]] = []
    obs: list[int] = []
    tod_obs: list[int] = []
    dint_obs: list[int] = []
    external: list[int] = []
    faulty: list[int] = []
    startup: list[tuple[str, int]] = []
    profiles: list[str] = []
    choices: list[tuple[str, list[str]]] = []
    letters: list[tuple[str, list[str]]] = []
    defaults: list[tuple[str, str]] = []
    periods: list[int] = []
    answers: list[tuple[str, list[int]]] = []

    @property
    def classic(self) -> list[str]:
        """The families that share the OBs of S7-300/400: none is unknown to them."""
        lacking = {name for name, some in self.unknown if some}
        return [name for name in self.families if name not in lacking]

    @property
    def readings(self) -> dict[str, list[str]]:
        """Ambiguity -> the letters that a header may name."""
        return {name: sorted(letters) for name, letters in self.choices}

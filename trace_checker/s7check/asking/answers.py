"""The engine's answers about a log that grows, as they come over the wire."""

from typing import Any

import msgspec

from s7check.engine.answer import Allowed, Moment


class Time(msgspec.Struct, frozen=True):
    """Both clocks at a time at which something changes: ``at`` the CPU clock, ``up`` the time since the log began.

    ``due`` has to have come by then, by these ``requirements``, in at least one explanation of the log.
    """

    at: Moment
    up: Moment
    due: list[Allowed] = []
    requirements: list[str] = []


class Line(msgspec.Struct, frozen=True):
    """A line that may come: ``event`` has its fields as a log spells them, without its time.

    It may come from the time number ``first`` to the time number ``last``, or at any later time where ``last`` is
    None.
    """

    event: dict[str, Any]
    first: int
    last: int | None
    requirements: list[str]


class Possible(msgspec.Struct, frozen=True):
    """Everything that may come next. ``endless``: nothing has to; else a line has to come by the last of the times.

    ``key`` is the same for logs that go on alike. So many ``states`` explain the log; ``whole`` says that all of them
    were looked at. There were so many ``tries``, each whether a line is possible in a state.
    """

    times: list[Time]
    endless: bool
    lines: list[Line]
    key: str = ""
    states: int = 0
    whole: bool = True
    tries: int = 0


class Parting(msgspec.Struct, frozen=True):
    """The shortest log that one session allows and another does not; ``lines`` is None where none was found.

    No shorter one has up to ``complete`` lines. So many ``pairs`` of explanations were followed and lines ``tried``;
    ``whole`` is false where one of them has too many explanations.
    """

    complete: int
    pairs: int
    tried: int
    whole: bool
    lines: list[dict[str, Any]] | None = None

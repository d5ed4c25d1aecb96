"""Possible lines, brought together in rows that a person can read."""

from dataclasses import dataclass
from typing import Any

from s7check.asking.answers import Line, Possible
from s7check.asking.line_text import iso_of, spelled
from s7check.log.errors import ranges

_ANSWERS = ("ret", "status")


@dataclass(frozen=True)
class When:
    """From when and until when a line may come; ``first`` is None for at once, ``last`` for as long as any line may."""

    first: str | None
    last: str | None

    def __str__(self) -> str:
        first = "at once" if self.first is None else f"from {self.first}"
        return first if self.last is None else f"{first}, until {self.last}"


@dataclass(frozen=True)
class Row:
    """Lines that are alike but for their OB and their operands.

    ``detail`` is the answer of a call, else the fields beside the OB; ``example`` has the operands of one of the calls.
    """

    event: str
    detail: str
    when: When
    requirements: tuple[str, ...]
    obs: tuple[int, ...]
    example: str

    @property
    def text(self) -> str:
        """Such as ``start ob=10-12`` or ``SET_TINT ret=W#16#8091``."""
        obs = f"ob={ranges(self.obs)}" if self.obs and not self.example else ""
        return " ".join(part for part in (self.event, obs, self.detail) if part)


def when(line: Line, possible: Possible) -> When:
    """When a line may come, in words of the CPU clock."""
    first = None if line.first == 0 else iso_of(possible.times[line.first].at)
    ends = line.last is not None and line.last < len(possible.times) - 1
    return When(first, iso_of(possible.times[line.last].at) if line.last is not None and ends else None)


def rows(possible: Possible) -> list[Row]:
    """All lines, in the order in which their kinds first come."""
    groups: dict[tuple[Any, ...], list[dict[str, Any]]] = {}
    for line in possible.lines:
        event = line.event
        key = (event["event"], answer(event), when(line, possible), tuple(line.requirements), _beside(event))
        groups.setdefault(key, []).append(event)
    return [
        Row(
            name,
            said or beside,
            moment,
            ids,
            tuple(sorted({event["ob"] for event in events if "ob" in event})),
            _example(events),
        )
        for (name, said, moment, ids, beside), events in groups.items()
    ]


def answer(event: dict[str, Any]) -> str:
    """The fields of a call that the CPU gives."""
    return " ".join(f"{name}={event[name]}" for name in _ANSWERS if event.get(name) is not None)


def _beside(event: dict[str, Any]) -> str:
    """Of another line the fields beside its OB; they stand for lines of their own."""
    if event["event"].isupper():
        return ""
    rest = {name: value for name, value in event.items() if name != "ob"}
    return spelled(rest).removeprefix(event["event"]).strip()


def _example(events: list[dict[str, Any]]) -> str:
    """The operands of the first call of these; empty for another line and for a call without operands."""
    first = events[0]
    if not first["event"].isupper():
        return ""
    operands = {name: value for name, value in first.items() if name not in _ANSWERS}
    return spelled(operands).removeprefix(first["event"]).strip()

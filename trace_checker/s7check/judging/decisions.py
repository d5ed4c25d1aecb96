"""The outcomes of an explanation, and the requirements that they show.

A requirement has decided something in a log if, on the way of every explanation of it,

- an action that names it was taken, which no log of ``usual.IDLE`` takes;
- a definition that names it was false, or a condition in it had an outcome, as in no log of ``usual.PLAIN``; a
  definition without conditions only has to be evaluated;
- a condition beside which it stands had such an outcome.

So it is known as exactly as the specification names it: a definition that names three requirements shows all three.
"""

from collections import defaultdict
from collections.abc import Collection, Mapping
from contextlib import suppress
from functools import cached_property
from typing import Any
from weakref import WeakKeyDictionary

import msgspec

from s7check.engine.answer import Decision
from s7check.engine.cache import cache_folder
from s7check.engine.client import Engine
from s7check.engine.command import engine_command
from s7check.engine.kept_specification import specification_state
from s7check.judging import usual
from s7check.output import write_whole
from s7check.resources import ENGINE, SPECIFICATION

_QUESTIONS = ("AMB-", "A15-")


class Decisions(msgspec.Struct, frozen=True, dict=True):
    """The decisions of a specification; an outcome is a number as in ``Answer.outcomes``.

    ``shown`` has the outcomes of which one shows that a requirement decided something, by requirement in its order;
    ``packed`` all decisions: few ask for them, and to read them takes longer than the rest.
    """

    shown: dict[str, frozenset[int]]
    packed: msgspec.Raw

    @property
    def requirements(self) -> tuple[str, ...]:
        """Those that a log can show to decide something."""
        return tuple(self.shown)

    def requirements_of(self, outcomes: Collection[int]) -> list[str]:
        """The requirements that decided something, in their order."""
        met = frozenset(outcomes)
        return [name for name, shown in self.shown.items() if not shown.isdisjoint(met)]

    @cached_property
    def guards(self) -> Mapping[int, Decision]:
        """The conditions in actions, by the number of their decision."""
        decisions = msgspec.msgpack.decode(self.packed, type=list[Decision])
        return {number: one for number, one in enumerate(decisions) if one.kind == "GUARD"}


def _shown(decisions: list[Decision], idle: frozenset[int], usual_ones: frozenset[int]) -> dict[str, frozenset[int]]:
    """``shown`` of ``Decisions``; ``idle`` outcomes are those of ``usual.IDLE``, ``usual_ones`` of ``PLAIN``, too."""
    inside: defaultdict[tuple[str, str], list[int]] = defaultdict(list)
    for number, one in enumerate(decisions):
        if one.kind in ("GUARD", "CONDITION"):
            inside[one.module, one.definition].append(number)
    shown: defaultdict[str, set[int]] = defaultdict(set)
    for number, one in enumerate(decisions):
        if one.kind == "ACTION":
            telling = {2 * number} - idle
        elif one.text or not inside[one.module, one.definition]:
            telling = {2 * number, 2 * number + 1} - usual_ones
        else:
            conditions = inside[one.module, one.definition]
            telling = {2 * number + 1, *(2 * n + side for n in conditions for side in (0, 1))} - usual_ones
        for name in one.requirements:
            if not name.startswith(_QUESTIONS):
                shown[name] |= telling
    return {name: frozenset(outcomes) for name, outcomes in sorted(shown.items()) if outcomes}


_known: WeakKeyDictionary[Engine, Decisions] = WeakKeyDictionary()


def decisions_of(engine: Engine) -> Decisions:
    """The decisions of the engine's specification; not while a log is at work. Raises EngineError.

    They are found once and then kept in the cache, since every report needs them.
    """
    if engine not in _known:
        _known[engine] = _of_the_specification(engine) if engine.command is engine_command else _found(engine)
    return _known[engine]


def _of_the_specification(engine: Engine) -> Decisions:
    file = cache_folder() / f"{specification_state(SPECIFICATION, [ENGINE / 's7-trace-engine.jar'])}.decisions"
    with suppress(OSError, msgspec.MsgspecError):
        return msgspec.msgpack.decode(file.read_bytes(), type=Decisions)
    found = _found(engine)
    with suppress(OSError):  # then they are found again
        file.parent.mkdir(parents=True, exist_ok=True)
        for old in file.parent.glob("*.decisions"):
            old.unlink()
        write_whole(file, msgspec.msgpack.encode(found))
    return found


def _found(engine: Engine) -> Decisions:
    idle, plain = (frozenset(n for log in logs for n in _outcomes(log, engine)) for logs in (usual.IDLE, usual.PLAIN))
    decisions = engine.decisions()
    return Decisions(_shown(decisions, idle, idle | plain), msgspec.Raw(msgspec.msgpack.encode(decisions)))


def _outcomes(lines: list[dict[str, Any]], engine: Engine) -> list[int]:
    engine.begin(outcomes=True)
    engine.send(b"\n".join(map(msgspec.json.encode, lines)))
    return engine.finish().outcomes

"""Accepted logs without the lines of some kinds: they are accepted, too (fine point 9)."""

import hashlib
from typing import Any

from tests.by_hand.situations.builder import Case, Situation, Variant, situation
from tests.by_hand.situations.contract import KINDS

KIND_OF = {
    "start": "ob",
    "end": "ob",
    "clock": "clock",
    "interrupt": "interrupt",
    "load": "load",
    "delete": "load",
} | dict.fromkeys(("restart", "run", "stop", "hold", "release"), "mode")
"""Event -> its kind in ``records``; what is not here is a call, or never listed by default."""
OPTIONAL = {"diag", "state"}
DRAWS = 6
"""Each family of subsets takes one in so many situations, by a hash of their names."""


def kind_of(line: dict[str, Any]) -> str:
    """The kind of a line."""
    event = line["event"]
    return event if event in OPTIONAL else KIND_OF.get(event, "call")


def complete(case: Case, variant: int) -> bool:
    """An accepted log of this variant that leaves no kind out."""
    plain = all(isinstance(line, dict) for line in case.lines)
    return case.verdict == "accepted" and case.variant == variant and plain and "records" not in case.lines[0]


def without(kinds: tuple[str, ...], pick: int) -> Situation:
    """The situation that leaves these kinds out of one log of every situation that it draws."""

    def make(v: Variant) -> None:
        seen = set()
        for case in [case for case in v.cases if complete(case, v.number)]:
            first, *lines = (line for line in case.lines if isinstance(line, dict))
            drawn = int(hashlib.sha256(f"{case.situation}{v.number}".encode()).hexdigest(), 16) % DRAWS == pick
            if case.situation in seen or not drawn or not {kind_of(line) for line in lines} & set(kinds):
                continue
            seen.add(case.situation)
            log = v.log()
            log.lines = [first | {"records": [kind for kind in KINDS if kind not in kinds]}]
            if "ob" in kinds:
                log.lines[0].pop("cycle", None)
            log.lines += [line for line in lines if kind_of(line) not in kinds]
            log.accepted(f"{case.situation} without {' and '.join(kinds)}: a kind left out never makes a log worse")

    make.__name__ = f"accepted_without_{'_'.join(kinds)}"
    return make


for number, left_out in enumerate(
    (
        ("call",),
        ("ob",),
        ("clock",),
        ("mode",),
        ("interrupt",),
        ("load", "interrupt"),
        ("call", "clock"),
        ("ob", "mode"),
        ("clock", "mode"),
        ("call", "interrupt"),
    )
):
    situation("FP-9")(without(left_out, number % DRAWS))

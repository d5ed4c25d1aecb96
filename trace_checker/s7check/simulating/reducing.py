"""A smaller program with the same effect as a larger one."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from typing import Any

from s7check.kit.program import Program, read_program
from s7check.log.errors import UnusableLogError

_ROUND = (1, 10, 100, 1000, 10_000, 60_000)


def reduced(program: Program, still: Callable[[Program], bool]) -> Program:
    """The program without each event, step, OB and setting that ``still`` does without, its times rounded."""
    raw = program.raw
    changed = True
    while changed:
        changed = False
        for smaller in _smaller(raw):
            one = _read(smaller)
            if one is not None and still(one):
                raw, changed = smaller, True
                break
    for rounder in _rounder(raw):
        one = _read(rounder(raw))
        if one is not None and still(one):
            raw = one.raw
    return read_program(_bytes(raw))


def _bytes(raw: dict[str, Any]) -> bytes:
    return json.dumps(raw).encode()


def _read(raw: dict[str, Any]) -> Program | None:
    try:
        return read_program(_bytes(raw))
    except UnusableLogError:
        return None


def _without(items: list[Any]) -> Iterator[list[Any]]:
    for place in reversed(range(len(items))):
        yield items[:place] + items[place + 1 :]


def _smaller(raw: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for bodies in _without(raw["bodies"]):
        yield raw | {"bodies": bodies}
    for outside in _without(raw.get("outside", [])):
        yield raw | {"outside": outside}
    for place, body in enumerate(raw["bodies"]):
        for steps in _without(body["steps"]):
            bodies = [*raw["bodies"][:place], body | {"steps": steps}, *raw["bodies"][place + 1 :]]
            yield raw | {"bodies": bodies}
    header = raw["header"]
    for obs in _without(header["obs"]):
        yield raw | {"header": header | {"obs": obs}}
    for name in ("priority", "cycle"):
        if name in header:
            yield raw | {"header": {key: value for key, value in header.items() if key != name}}
    tod = header.get("step7", {}).get("tod", {})
    for ob in tod:
        rest = {key: value for key, value in tod.items() if key != ob}
        yield raw | {"header": header | {"step7": header["step7"] | {"tod": rest}}}


def _rounder(raw: dict[str, Any]) -> Iterator[Callable[[dict[str, Any]], dict[str, Any]]]:
    """Changes that make a time round: each works on the result of the changes before it."""
    for body, step in [(i, k) for i, each in enumerate(raw["bodies"]) for k in range(len(each["steps"]))]:
        if "wait" in raw["bodies"][body]["steps"][step]:
            for number in _ROUND:
                yield lambda now, i=body, k=step, ms=number: _with_wait(now, i, k, ms)  # type: ignore[misc]
    for place in range(len(raw.get("outside", []))):
        for number in _ROUND:
            yield lambda now, i=place, ms=number: _with_after(now, i, ms)  # type: ignore[misc]


def _with_wait(raw: dict[str, Any], body: int, step: int, ms: int) -> dict[str, Any]:
    changed: dict[str, Any] = json.loads(json.dumps(raw))
    now = changed["bodies"][body]["steps"][step]
    now["wait"] = max(1, round(now["wait"] / ms)) * ms
    return changed


def _with_after(raw: dict[str, Any], place: int, ms: int) -> dict[str, Any]:
    changed: dict[str, Any] = json.loads(json.dumps(raw))
    now = changed["outside"][place]
    now["after"] = max(1, round(now["after"] / ms)) * ms
    return changed

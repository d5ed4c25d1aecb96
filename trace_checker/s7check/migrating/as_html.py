"""The page of ``s7check migrate``: both timelines beside each other, and the points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib.resources import files
from itertools import zip_longest
from typing import Any

from s7check.asking.line_text import spelled
from s7check.log.values import instant
from s7check.migrating.walk import Point
from s7check.report.markup import Node, document, node
from s7check.report.report import clause_text

Json = dict[str, Any]

_KINDS = {"will": "does not come", "may": "need not come", "hint": "look at it"}


def page(
    name: str, cpus: tuple[str, str], found: Sequence[Point], mine: Sequence[Json], other: Sequence[Json]
) -> bytes:
    """The page of a log ``mine`` of the old CPU; ``other`` is what the new one makes of its program, or nothing."""
    style, script = ((files("s7check.report") / f"report.{kind}").read_text(encoding="utf-8") for kind in ("css", "js"))
    return document(
        f"s7check migrate: {name}",
        style,
        script,
        node("h1", f"{name}: from {cpus[0]} to {cpus[1]}"),
        node("p", f"{cpus[1]} is advisory: what no text states is open, and a point of trust L is a hint."),
        node("h2", "Both timelines"),
        _timelines(cpus, {point.line for point in found if point.kind == "will"}, mine, other),
        node("h2", f"{len(found)} points"),
        *(_point(point) for point in found),
    )


def _timelines(cpus: tuple[str, str], marked: set[int], mine: Sequence[Json], other: Sequence[Json]) -> Node:
    """A row for each time of either CPU."""
    rows = []
    for at in sorted({line["at"] for line in (*mine, *other)}, key=instant):
        left = [(number, line) for number, line in enumerate(mine, 2) if line["at"] == at]
        right = [line for line in other if line["at"] == at]
        for one, two in zip_longest(left, right):
            text = "" if one is None else spelled(one[1])
            changed = one is not None and one[0] in marked
            cell = node("td", node("strong", text)) if changed else node("td", text)
            rows.append(node("tr", node("td", at), cell, node("td", "" if two is None else spelled(two))))
    heads = node("tr", *(node("th", text) for text in ("CPU clock", f"{cpus[0]}, the log", f"{cpus[1]}, its program")))
    return node("table", heads, *rows)


def _point(point: Point) -> Node:
    return node("section", *_parts(point))


def _parts(point: Point) -> Iterator[Node]:
    yield node("h3", f"Line {point.line}, {point.text}: {_KINDS[point.kind]}")
    if point.instead:
        yield node("p", f"Instead: {', '.join(point.instead)}.")
    for one in point.differences:
        yield node("h4", f"{one.id}, {one.area}, trust {one.trust}")
        words = (("was", one.was), ("is", one.becomes), ("do", one.do))
        yield node("dl", *(part for word, text in words for part in (node("dt", word), node("dd", text))))
        yield node("ul", *(node("li", clause_text(name)) for name in (*one.old, *one.new)))
    if not point.differences:
        yield node("ul", *(node("li", clause_text(name)) for name in (*point.old, *point.new)))

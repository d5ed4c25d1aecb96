"""Failures that have a cause in common: the rejected line, what was expected there, and the rule."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping

from s7check.kit.results import Result

SHOWN = 10
"""Clusters that the command prints."""

_NAMES = 3


def clusters(results: Iterable[Result]) -> list[tuple[str, list[Result]]]:
    """The failed results by their cause, the largest cluster first."""
    found: dict[str, list[Result]] = defaultdict(list)
    for result in results:
        if result.status in ("failed", "no verdict"):
            found[result.cause or re.sub(r"\d+", "N", result.reason)].append(result)
    return sorted(found.items(), key=lambda one: -len(one[1]))


def to_lines(results: Iterable[Result], most: int = SHOWN) -> list[str]:
    """A line for each cluster, at most so many, and how many failures are left."""
    found = clusters(results)
    lines = []
    for cause, failed in found[:most]:
        under = sorted({name for result in failed for name in result.passes_under})
        names = ", ".join(result.name for result in failed[:_NAMES]) + (" ..." if len(failed) > _NAMES else "")
        passes = f" [passes under {', '.join(under[:_NAMES])}]" if under else ""
        lines.append(f"{len(failed)} failed: {cause}{passes}: {names}")
    if left := sum(len(failed) for _, failed in found[most:]):
        lines.append(f"{left} more failed for {len(found) - most} other causes; --output FILE.txt has every report")
    return lines


def changes(old: Mapping[str, str], results: Iterable[Result]) -> list[str]:
    """What changed against a baseline, the status of each program by its name; known failures are counted."""
    news: dict[str, list[str]] = defaultdict(list)
    for result in results:
        before = old.get(result.name, "new")
        kind = "known failures" if before == result.status == "failed" else f"{before} -> {result.status}"
        if before != result.status or result.status == "failed":
            news[kind].append(result.name)
    return [f"{kind}: {len(names)}: {', '.join(names[:_NAMES])}" for kind, names in sorted(news.items())]

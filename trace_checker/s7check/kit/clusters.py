"""Failures that have a cause in common: the rejected line, what was expected there, and the rule."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping

from s7check.kit.results import FAILED, UNDER_ANOTHER, Result

SHOWN = 10
"""Clusters that the command prints."""

_NAMES = 3


def clusters(results: Iterable[Result]) -> list[tuple[str, list[Result]]]:
    """The failed results by their class and cause, the largest cluster first."""
    found: dict[tuple[str, str], list[Result]] = defaultdict(list)
    for result in results:
        if result.status in FAILED or result.status == "no verdict":
            kind = told_status(result) if result.status == UNDER_ANOTHER else "failed"
            found[kind, result.cause or re.sub(r"\d+", "N", result.reason)].append(result)
    by_size = sorted(found.items(), key=lambda one: -len(one[1]))
    return [(f"{kind}: {cause}", failed) for (kind, cause), failed in by_size]


def told_status(result: Result) -> str:
    """The status of a result, with the first readings and editions under which its log passes."""
    if result.status != UNDER_ANOTHER:
        return result.status
    more = len(result.passes_under) - _NAMES
    return f"passed under {', '.join(result.passes_under[:_NAMES])}" + (f" and {more} more" if more > 0 else "")


def to_lines(results: Iterable[Result], most: int = SHOWN) -> list[str]:
    """A line for each cluster, at most so many, and how many failures are left."""
    found = clusters(results)
    lines = []
    for cause, failed in found[:most]:
        names = ", ".join(result.name for result in failed[:_NAMES]) + (" ..." if len(failed) > _NAMES else "")
        lines.append(f"{len(failed)} {cause}: {names}")
    if left := sum(len(failed) for _, failed in found[most:]):
        lines.append(f"{left} more failed for {len(found) - most} other causes; --output FILE.txt has every report")
    return lines


def changes(old: Mapping[str, str], results: Iterable[Result]) -> list[str]:
    """What changed against a baseline, the status of each program by its name; known failures are counted."""
    news: dict[str, list[str]] = defaultdict(list)
    for result in results:
        before = old.get(result.name, "new")
        kind = "known failures" if before == result.status in FAILED else f"{before} -> {result.status}"
        if before != result.status or result.status in FAILED:
            news[kind].append(result.name)
    return [f"{kind}: {len(names)}: {', '.join(names[:_NAMES])}" for kind, names in sorted(news.items())]


def is_known(old: Mapping[str, str], result: Result) -> bool:
    """Whether a failure was one of the baseline, no better than now."""
    return result.status in FAILED and old.get(result.name) in ("failed", result.status)

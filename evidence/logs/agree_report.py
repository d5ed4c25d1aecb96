"""The output: tables, the sum, and the logs about which engine and TLC differ."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from rich.console import Console

from evidence.common.console import columns, plain
from evidence.logs.agree import Compared, Comparison

VERDICTS = ("accepted", "rejected")


def show(console: Console, found: Comparison, kept: Path) -> None:
    """Show the changes of the logs, the events where they are rejected, each difference, and the sum."""
    groups: tuple[tuple[str, Iterable[tuple[str, Compared]]], ...] = (
        ("CPU", ((one.log.cpu, one) for one in found.logs)),
        ("done to the log", ((what, one) for one in found.logs for what in one.log.done)),
    )
    for heading, pairs in groups:
        counts: dict[str, Counter[str]] = {}
        for name, one in pairs:
            counts.setdefault(name, Counter())[one.engine.verdict] += 1
        table = columns([heading], ["logs", *VERDICTS])
        for name in sorted(counts):
            table.add_row(name, *(f"{n:,}" for n in (counts[name].total(), *(counts[name][v] for v in VERDICTS))))
        console.print(table)
    table = columns(["event rejected"], ["logs"])
    for event, number in Counter(one.event for one in found.logs if one.event).most_common():
        table.add_row(event, f"{number:,}")
    console.print(table)
    for one in differences(found):
        plain(console, f"{file_of(one, kept)}: engine: {one.engine}; TLC: {one.tlc}", style="red")
    plain(console, total_lines(found))


def total_lines(found: Comparison) -> str:
    """The sum in three lines."""
    total = totals(found)
    differ = total["differ"]
    result = f"{differ:,} DIFFER" if differ else "the same verdict at the same line"
    return (
        f"{total['logs']:,} logs, {total['accepted']:,} accepted, {total['rejected']:,} rejected, "
        f"{total['lines']:,} lines: {result}\n"
        f"not among them: {total['unreadable']:,} unusable, {total['endless']:,} with too many explanations\n"
        f"engine {found.engine_seconds:.0f} s, TLC {found.tlc_version} {found.tlc_seconds:.0f} s"
    )


def totals(found: Comparison) -> dict[str, int]:
    """How many logs there are, by verdict of the engine, how many lines, how many were replaced and differ."""
    verdicts = Counter(one.engine.verdict for one in found.logs)
    return {
        "logs": len(found.logs),
        **{verdict: verdicts[verdict] for verdict in VERDICTS},
        "lines": sum(one.log.lines for one in found.logs),
        "unreadable": found.unreadable,
        "endless": found.endless,
        "differ": len(differences(found)),
    }


def differences(found: Comparison) -> list[Compared]:
    """The logs about which the two differ."""
    return [one for one in found.logs if not one.agree]


def as_json(found: Comparison) -> dict[str, Any]:
    """The numbers, and each log with its verdicts."""
    return {
        **totals(found),
        "tlc": found.tlc_version,
        "engine_seconds": round(found.engine_seconds, 1),
        "tlc_seconds": round(found.tlc_seconds, 1),
        "verdicts": [
            {
                "log": one.number,
                "cpu": one.log.cpu,
                "done": one.log.done,
                "lines": one.log.lines,
                "event": one.event,
                "engine": str(one.engine),
                "tlc": str(one.tlc),
            }
            for one in found.logs
        ],
    }


def keep(found: Comparison, folder: Path) -> None:
    """Write the logs about which the two differ into `folder`. Raises OSError."""
    for one in differences(found):
        folder.mkdir(parents=True, exist_ok=True)
        file_of(one, folder).write_bytes(one.log.content)
        file_of(one, folder).with_suffix(".txt").write_text(
            f"engine: {one.engine}\nTLC {found.tlc_version}: {one.tlc}\n", encoding="utf-8"
        )


def file_of(one: Compared, folder: Path) -> Path:
    """Where a log is kept."""
    return folder / f"{one.number}.ndjson"

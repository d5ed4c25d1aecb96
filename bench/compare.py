"""Compares this checkout with another revision on the same logs, and draws how their cost grows with their size.

Run it with the Python of the virtual environment; README.md says what is measured.
"""

import json
import math
import os
import platform
import resource
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TextIO

import click

from evidence.common.checkout import ROOT, SOFT_PLC_PROGRAM
from evidence.logs.growth_logs import PLANT, Kind, kinds, text

SMALL_LOGS = 1000
START = "d37e607"
"""The revision before the work on the cost of logs began."""

PLOTS = ROOT / "bench" / "growth"

SMALL_LOG = 100
"""Lines of a small log."""

LONG_LIMIT = 60.0
"""Seconds for a million events, and for many logs."""

LONG_RUN = 4.0
"""CPU seconds of a run after which it is not repeated: other work on the machine hardly changes it."""

VISIBLE = 0.2
"""CPU seconds above those of a start, which are not always the same."""

PARTS = (0.25, 0.5, 1.0)
"""Of the largest size, for a curve."""

WIDTH, HEIGHT, MARGIN = 460, 300, 56


@dataclass(frozen=True)
class Row:
    """CPU seconds on the same logs at the other revision and here; none where there was no verdict in time."""

    name: str
    before: float | None
    now: float | None

    @property
    def ratio(self) -> float | None:
        """How many times the cost was."""
        return self.before / self.now if self.before and self.now else None


@dataclass(frozen=True)
class Curve:
    """CPU seconds by size, less those of the smallest log, which are the start of the programs."""

    name: str
    sizes: list[int]
    seconds: list[float]

    @property
    def exponent(self) -> float | None:
        """The slope where both axes are logarithmic: 1 for a cost in proportion. None if the start hides the cost."""
        points = [(math.log(x), math.log(y)) for x, y in zip(self.sizes, self.seconds, strict=True) if y >= VISIBLE]
        if len(points) < 2:
            return None
        mean_x, mean_y = (sum(each) / len(points) for each in zip(*points, strict=True))
        slope: float = sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, _ in points)
        return slope


@contextmanager
def checkout(revision: str) -> Iterator[Path]:
    """The files of a revision, with its engine."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "revision"
        git = ["git", "-C", str(ROOT), "worktree"]
        subprocess.run([*git, "add", "--detach", "-f", str(folder), revision], check=True, capture_output=True)
        try:
            engine = folder / "trace_checker" / "engine"
            subprocess.run(["mvn", "-q", "-B", "package", "-DskipTests"], cwd=engine, check=True, stdout=sys.stderr)  # noqa: S607
            yield folder
        finally:
            subprocess.run([*git, "remove", "--force", str(folder)], check=True, capture_output=True)


def cpu(project: Path, logs: list[Path], limit: float, runs: int, *options: str) -> float | None:
    """The least CPU seconds of `s7check trace` in so many runs, one if it is long; none without verdict in time."""
    command = [sys.executable, "-m", "s7check", "trace", *(options or ("--readings", "none")), *map(str, logs)]
    environment = os.environ | {"PYTHONPATH": str(project / "trace_checker")}
    least = math.inf
    for _ in range(runs):
        before = _used()
        try:
            ran = subprocess.run(command, env=environment, cwd=project, capture_output=True, timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return None
        if ran.returncode > 1:
            return None
        least = min(least, _used() - before)
        if least > LONG_RUN:
            break
    return least


def _used() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def plant(folder: Path, events: int) -> Path:
    """The benchmark's plant."""
    return soft_plc(folder / f"plant-{events}.ndjson", str(PLANT), "--events", str(events))


def soft_plc(log: Path, *arguments: str) -> Path:
    """A log that the soft PLC writes."""
    subprocess.run([str(SOFT_PLC_PROGRAM), *arguments, "-o", str(log)], check=True)
    return log


def written(folder: Path, kind: Kind, size: int) -> Path:
    """A log that leaves much open."""
    log = folder / f"{kind.name.replace(' ', '-').replace(':', '').replace(',', '')}-{size}.ndjson"
    log.write_text(text(kind.log(size)))
    return log


def rows(folder: Path, measured: Callable[..., float | None], other: Path, events: int) -> Iterator[Row]:
    """The table: long, short and many logs, and those that leave much open."""
    small = [
        soft_plc(
            folder / f"small-{seed}.ndjson", "--random", str(seed), "--cpu", "S7-300", "--events", str(SMALL_LOG - 1)
        )
        for seed in range(1, SMALL_LOGS + 1)
    ]
    logs: dict[str, tuple[list[Path], tuple[str, ...]]] = {
        f"plant, {events:,} events": ([plant(folder, events)], ()),
        f"{len(small)} logs of {SMALL_LOG} lines": (small, ()),
    }
    for kind in kinds():
        logs[kind.name] = ([written(folder, kind, kind.large)], ())
        if kind.rejected:
            logs[f"{kind.name}, with other readings"] = (logs[kind.name][0], ("--readings", "auto"))
    for number, (name, (paths, options)) in enumerate(logs.items()):
        limit = LONG_LIMIT if number < 2 else None
        row = Row(name, *(measured(project, paths, *options, limit=limit) for project in (other, ROOT)))
        tell(line(row))
        yield row


def curves(folder: Path, measured: Callable[..., float | None], events: int) -> Iterator[Curve]:
    """How the cost grows with the size of each kind of log."""
    start = measured(ROOT, [plant(folder, 9)]) or 0.0
    sources: dict[str, tuple[int, Callable[[int], Path]]] = {"events": (events, lambda size: plant(folder, size))}
    for kind in kinds():
        if kind.large > len(PARTS):
            sources[kind.name] = (kind.large, lambda size, kind=kind: written(folder, kind, size))  # type: ignore[misc]
    for name, (largest, log) in sources.items():
        sizes = sorted({max(1, round(part * largest)) for part in PARTS})
        found = [(size, measured(ROOT, [log(size)], runs=1)) for size in sizes]
        ended = [(size, seconds - start) for size, seconds in found if seconds is not None]
        if not ended:
            continue
        curve = Curve(name, [size for size, _ in ended], [max(0.0, seconds) for _, seconds in ended])
        tell(f"{name}: exponent {spelled(curve.exponent)}")
        yield curve


def line(row: Row) -> str:
    """A row as text."""
    return f"{row.name}: {spelled(row.before)} s before, {spelled(row.now)} s now, ratio {spelled(row.ratio)}"


def tell(text: str) -> None:
    """Say how far it is; the output is for the tables."""
    click.echo(text, err=True)


def _rounded(number: float | None) -> float | None:
    return None if number is None else round(number, 2)


def spelled(number: float | None) -> str:
    """A number with two digits."""
    return "-" if number is None else f"{number:.2f}"


def drawn(curve: Curve) -> str:
    """The curve as SVG; both axes begin at 0."""
    top = max([*curve.seconds, 0.1])
    right = max([*curve.sizes, 1])
    points = [
        (MARGIN + x / right * (WIDTH - 2 * MARGIN), HEIGHT - MARGIN - y / top * (HEIGHT - 2 * MARGIN))
        for x, y in zip(curve.sizes, curve.seconds, strict=True)
    ]
    way = " ".join(f"{x:.0f},{y:.0f}" for x, y in points)
    dots = "".join(f'<circle cx="{x:.0f}" cy="{y:.0f}" r="3"/>' for x, y in points)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif"'
        ' font-size="12">'
        f'<text x="{MARGIN}" y="20">{escape(curve.name)}: exponent {spelled(curve.exponent)}</text>'
        f'<path d="M{MARGIN} {MARGIN}V{HEIGHT - MARGIN}H{WIDTH - MARGIN}" fill="none" stroke="#888"/>'
        f'<text x="4" y="{MARGIN}">{top:.1f} s</text><text x="{WIDTH - 2 * MARGIN}" y="{HEIGHT - 32}">{right:,}</text>'
        f'<polyline points="{way}" fill="none" stroke="#06c"/>{dots}</svg>\n'
    )


@click.command()
@click.option("--rev", "revision", default=START, show_default=True, help="The other revision.")
@click.option("--events", default=1_000_000, show_default=True, help="Events of the longest log.")
@click.option("--limit", "shortest", default=10.0, show_default=True, help="Seconds for a log that leaves much open.")
@click.option("--runs", default=2, show_default=True, help="Runs beside the revision; the least CPU counts.")
@click.option("--plots", type=click.Path(path_type=Path), default=PLOTS, help="Folder of the plots.")
@click.option("--json", "output", type=click.File("w"), default="-", help="Write the tables there, not to the output.")
def main(revision: str, events: int, shortest: float, runs: int, plots: Path, output: TextIO) -> None:
    """Measure, and write the tables and the plots."""
    plots.mkdir(parents=True, exist_ok=True)
    machine = f"{platform.machine()}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}"
    tell(f"{revision} before, this checkout now, CPU seconds; {machine}")

    def measured(
        project: Path, logs: list[Path], *options: str, limit: float | None = None, runs: int = runs
    ) -> float | None:
        return cpu(project, logs, limit or shortest, runs, *options)

    with tempfile.TemporaryDirectory() as name, checkout(revision) as other:
        folder = Path(name)
        compared = [
            [row.name, _rounded(row.before), _rounded(row.now), _rounded(row.ratio)]
            for row in rows(folder, measured, other, events)
        ]
        growth: list[list[str | float | None]] = []
        for curve in curves(folder, measured, events):
            name = curve.name.replace(" ", "-").replace(":", "").replace(",", "")
            (plots / f"{name}.svg").write_text(drawn(curve))
            growth.append([curve.name, curve.sizes[-1], _rounded(curve.seconds[-1]), _rounded(curve.exponent)])
    tables = [
        {"title": f"Beside {revision}", "columns": ["log", "before, CPU s", "now, CPU s", "ratio"], "rows": compared},
        {
            "title": "How the cost grows with the size",
            "columns": ["log", "largest size", "CPU s without the start", "exponent"],
            "rows": growth,
        },
    ]
    output.write(json.dumps({"tables": tables}, indent=1) + "\n")


if __name__ == "__main__":
    main()

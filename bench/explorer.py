"""Measures how long a step of the explorer takes after every line of the gallery's logs, and writes the table as JSON.

Run it with the Python of the virtual environment. A step is all that the page asks when a line is added, without the
browser: the situation, what may come and what may not, the timeline.
"""

import json
import os
import statistics
import time
from pathlib import Path
from typing import Any, TextIO

import click

from s7check.engine.client import Engine
from s7check.exploring.desk import Desk, Question, warm
from s7check.exploring.library import Library

_MS = 1000
_LEAST_SLOW = 0.1


def cpu_of(pid: int) -> float:
    """CPU seconds of the thread in which the engine of this process works; its compiler's are not in it."""
    threads = Path(f"/proc/{pid}/task").glob("*/schedstat")
    return max(int(thread.read_text().split()[0]) for thread in threads) / 1e9


def steps(desk: Desk, pid: int, logs: list[dict[str, Any]]) -> list[tuple[float, float]]:
    """Seconds, and those of the CPU, of each step."""
    found = []
    for log in logs:
        for shown in range(len(log["lines"]) + 1):
            cpu, began = cpu_of(pid) + time.process_time(), time.monotonic()
            desk.look(Question(log["header"], log["lines"][:shown]))
            seconds = time.monotonic() - began
            found.append((seconds, cpu_of(pid) + time.process_time() - cpu))
    return found


def child() -> int:
    """The engine, the only process that this one has started."""
    return int(Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children").read_text().split()[0])


@click.command()
@click.option("--json", "output", type=click.File("w"), default="-", help="Write the table there, not to the output.")
def main(output: TextIO) -> None:
    """Measure twice: in an engine as the explorer begins it, and in one that has done it all before."""
    library = Library()
    logs = [library.open(case["name"]) for case in library.contents()["gallery"]]
    rows = []
    with Engine() as engine:
        warm(engine, library)
        for engine_is in ("new", "warm"):
            measured = steps(Desk(engine), child(), logs)
            seconds, cpu = ([pair[column] for pair in measured] for column in (0, 1))
            row: list[str | int] = [engine_is, len(measured)]
            for times in (seconds, cpu):
                row += [
                    round(statistics.median(times) * _MS),
                    round(max(times) * _MS),
                    sum(t > _LEAST_SLOW for t in times),
                ]
            rows.append(row)
    columns = "engine | steps | median, ms | worst, ms | over 100 ms | CPU: median, ms | worst, ms | over 100 ms"
    output.write(json.dumps({"tables": [{"title": "", "columns": columns.split(" | "), "rows": rows}]}) + "\n")


if __name__ == "__main__":
    main()

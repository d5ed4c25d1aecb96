"""Measures the trace checker and TLC on the same logs, and writes the tables as JSON.

Run it with the Python of the virtual environment; README.md says what is measured.
"""

import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

import click

from evidence.common.chromium import missing, page_engine
from evidence.tla import log_as_tla
from evidence.tla.modules import module_folders
from evidence.tla.tlc import Toolchain, find_toolchain
from s7check.engine.command import CHOICE

PROJECT = Path(__file__).resolve().parents[1]
SOFT_PLC = PROJECT / "examples" / "soft_plc"
SPECIFICATION = PROJECT / "spec"

SCENARIO = PROJECT / "bench" / "plant.json"

COMPARED = (1_000, 10_000, 100_000)
"""Lengths at which both TLC and the checker are measured."""
MEMORY_LENGTHS = (10_000, 100_000, 1_000_000)
SMALL_HEAP_LENGTHS = (10_000, 100_000)
SMALL_HEAP = "-Xmx64m"
TLC_HEAP = "-Xmx8g"
SHORTEST = 10
SMALL = 100
"""Lines of a small log, its header among them."""
TLC_SAMPLE = 5
POLL = 0.02
MOST_IN_PAGE = 20_000_000
"""Bytes of logs that go into the page, as text in a message to the browser."""

MODULE = """---- MODULE Bench ----
EXTENDS PartialLogs, TraceLog
Out == INSTANCE TLC
VARIABLE index
BenchInit == Init /\\ index = 0
Line == Log[index]
BenchNext ==
    \\/ index = 0 /\\ Begin(Header) /\\ index' = 1
    \\/ /\\ index \\in 1..Len(Log)
       /\\ IF ~Arrived(Line) THEN Elapse(Line) /\\ UNCHANGED index
          ELSE \\/ Silent(Line) /\\ UNCHANGED index
               \\/ Observe(Line) /\\ index' = index + 1
Consumed == index > Len(Log) => Out!PrintT("consumed")
====
"""
CONFIGURATION = """INIT BenchInit
NEXT BenchNext
INVARIANT Consumed
CHECK_DEADLOCK FALSE
"""


Cell = str | int | float | None
Table = dict[str, Any]


@dataclass(frozen=True)
class Checked:
    """A run of ``s7check trace``: seconds, those of the CPU, and the most memory of Python and of the engine in MB."""

    seconds: float
    cpu: float
    python: float
    engine: float
    said: str


@dataclass(frozen=True)
class Explored:
    """A run of TLC: how it ended, seconds until the modules had been read, all seconds, those of the CPU, most MB."""

    end: str
    reading: float
    seconds: float
    cpu: float
    memory: float


def say(text: str) -> None:
    """Say on standard error how far the benchmark is."""
    click.echo(text, err=True)


def soft_plc(log: Path, *arguments: str) -> Path:
    """Have the soft PLC write a log."""
    subprocess.run([str(SOFT_PLC / "build" / "soft_plc"), *arguments, "-o", str(log)], check=True)
    return log


def check(logs: Path, java_options: str = "", highest: int = 0, engine: str = "jvm") -> Checked:
    """Check logs, which have to give no exit code above ``highest``."""
    environment = os.environ | {CHOICE: engine} | ({"JDK_JAVA_OPTIONS": java_options} if java_options else {})
    command = [sys.executable, "-m", "s7check", "trace", "--readings", "none", str(logs)]
    before = cpu_of_children()
    began = time.monotonic()
    # A file: nobody would empty a pipe while the process runs.
    with (
        tempfile.TemporaryFile("w+") as output,
        subprocess.Popen(command, env=environment, cwd=PROJECT, stdout=output) as process,
    ):
        python = most = 0.0
        while process.poll() is None:
            python = max(python, peak(process.pid))
            most = max([most, *map(peak, children(process.pid))])
            time.sleep(POLL)
        seconds = time.monotonic() - began
        output.seek(0)
        said = output.read()
    if process.returncode > highest:
        sys.exit(f"a log is not accepted: {said}")
    return Checked(seconds, cpu_of_children() - before, python, most, said)


def cpu_of_children() -> float:
    """CPU seconds of all processes that have ended, with their children."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def children(pid: int) -> list[int]:
    """The processes that any thread of a process has started and that still run."""
    try:
        threads = list(Path(f"/proc/{pid}/task").iterdir())
        return [int(child) for thread in threads for child in (thread / "children").read_text().split()]
    except OSError:
        return []


def peak(pid: int) -> float:
    """The most memory that a process has had resident so far, in MB; 0 if it has ended."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return next((int(line.split()[1]) / 1024 for line in lines if line.startswith("VmHWM")), 0.0)


def explore(tools: Toolchain, log: Path, folder: Path, limit: float) -> Explored:
    """Check with TLC that a log can be consumed to its end."""
    write_modules(log, folder)
    scratch = folder / "scratch"
    scratch.mkdir(exist_ok=True)
    command = [
        *(tools.java, TLC_HEAP, "-Xss16m", "-XX:+UseParallelGC"),
        *(f"-Djava.io.tmpdir={scratch}", f"-DTLA-Library={os.pathsep.join(map(str, module_folders(SPECIFICATION)))}"),
        *("-cp", str(tools.jar), "tlc2.TLC", *tools.flags),
        *("-workers", "1", "-metadir", str(scratch), "-config", "Bench.cfg", "Bench"),
    ]
    output = folder / "tlc.txt"
    before = cpu_of_children()
    began = time.monotonic()
    reading = memory = 0.0
    with output.open("w") as stream, subprocess.Popen(command, cwd=folder, stdout=stream, stderr=stream) as process:
        while process.poll() is None:
            now = time.monotonic() - began
            memory = max(memory, peak(process.pid))
            if not reading and "Computing initial states" in output.read_text():
                reading = now
            if now > limit:
                process.kill()
                process.wait()
                return Explored("ended", reading or now, now, cpu_of_children() - before, memory)
            time.sleep(POLL)
    seconds, cpu = time.monotonic() - began, cpu_of_children() - before
    said = output.read_text()
    if "OutOfMemoryError" in said:
        return Explored("out of memory", reading, seconds, cpu, memory)
    if process.returncode or '"consumed"' not in said:
        sys.exit(f"TLC does not consume the log:\n{said[-2000:]}")
    return Explored("consumed", reading, seconds, cpu, memory)


def write_modules(log: Path, folder: Path) -> None:
    """Write the log as the module TraceLog, and the module that consumes it."""
    header, events = log_as_tla.read(log)
    with (folder / "TraceLog.tla").open("w") as module:
        module.write(f"---- MODULE TraceLog ----\nEXTENDS {log_as_tla.ROOT}\nHeader == {header}\nLog == <<\n")
        module.write(",\n".join(events))
        module.write("\n>>\n====\n")
    (folder / "Bench.tla").write_text(MODULE)
    (folder / "Bench.cfg").write_text(CONFIGURATION)


def table(title: str, columns: str, rows: list[list[Cell]]) -> Table:
    """A table; the columns are separated by bars."""
    return {"title": title, "columns": columns.split(" | "), "rows": rows}


def tenths(number: float) -> float:
    """A number with one digit behind the point."""
    return round(number, 1)


def long_log(log: Path, events: int) -> Table:
    """The table of the long log."""
    say(f"s7check, {events} events")
    ran = check(log)
    return table(
        "One long log",
        "events | MB | seconds | CPU seconds | events/s | JVM, MB | Python, MB",
        [
            [
                events,
                round(log.stat().st_size / 1024**2),
                tenths(ran.seconds),
                tenths(ran.cpu),
                round(events / ran.seconds),
                round(ran.engine),
                round(ran.python),
            ]
        ],
    )


def compare(logs: dict[int, Path], folder: Path, limit: float) -> Table:
    """The table of TLC and the checker at the same lengths; a run of TLC that did not end has no speed."""
    tools = find_toolchain(None)
    rows: list[list[Cell]] = []
    for length, log in sorted(logs.items()):
        say(f"s7check and TLC, {length} events")
        checked = check(log)
        explored = explore(tools, log, folder, limit)
        ended = explored.end == "consumed"
        rows.append(
            [
                length,
                tenths(explored.seconds),
                tenths(explored.cpu),
                tenths(explored.reading),
                round(length / explored.seconds) if ended else explored.end,
                round(explored.memory),
                tenths(checked.seconds),
                tenths(checked.cpu),
                round(length / checked.seconds),
                tenths(explored.seconds / checked.seconds) if ended else None,
                tenths(explored.cpu / checked.cpu) if ended else None,
            ]
        )
    return table(
        "TLC on the same log",
        "events | TLC, s | CPU | reading the log, s | events/s | MB | s7check, s | CPU | events/s | ratio | of CPU",
        rows,
    )


def memory(logs: dict[int, Path]) -> Table:
    """The table of the memory at different lengths."""
    rows: list[list[Cell]] = []
    runs = [(length, "448 MB, as usual", "") for length in sorted(logs)]
    runs += [(length, SMALL_HEAP, SMALL_HEAP) for length in SMALL_HEAP_LENGTHS]
    for length, heap, options in runs:
        say(f"memory, {length} events, heap {heap}")
        ran = check(logs[length], options)
        rows.append([length, heap, round(ran.engine), round(ran.python), tenths(ran.seconds)])
    return table("Memory does not grow with the log", "events | heap | JVM, MB | Python, MB | seconds", rows)


def engines(logs: dict[str, Path]) -> Table:
    """The table of the executable and Java on the same logs."""
    rows: list[list[Cell]] = []
    for name, log in logs.items():
        row: list[Cell] = [name]
        for engine in ("native", "jvm"):
            say(f"{engine}, {name}")
            ran = min((check(log, highest=1, engine=engine) for _ in range(2)), key=lambda each: each.cpu)
            row += [round(ran.seconds, 2), round(ran.cpu, 2), round(ran.engine)]
        rows.append([*row, in_page(log)])
    return table("The executable beside Java", " | native, s | CPU | MB | Java, s | CPU | MB | page, s", rows)


def in_page(logs: Path) -> float | None:
    """Seconds for which the page judges a log or a folder of logs, the way to it included; None where it cannot."""
    files = sorted(logs.iterdir()) if logs.is_dir() else [logs]
    if missing() or sum(file.stat().st_size for file in files) > MOST_IN_PAGE:
        return None
    with page_engine() as judge:
        began = time.monotonic()
        for file in files:
            judge(file.read_bytes())
        return round(time.monotonic() - began, 2)


def small_logs(folder: Path, count: int, limit: float) -> Table:
    """The table in which the start of the programs counts most: one short log, and many small ones.

    Medians of `TLC_SAMPLE` runs; for many logs as many times TLC's median of `TLC_SAMPLE` of them.
    """
    say(f"{count} small logs")
    tools = find_toolchain(None)
    shortest = soft_plc(folder / "shortest.ndjson", str(SCENARIO), "--events", str(SHORTEST - 1))
    many = folder / "many"
    many.mkdir()
    for seed in range(1, count + 1):
        arguments = ("--random", str(seed), "--cpu", "S7-300", "--events", str(SMALL - 1))
        soft_plc(many / f"{seed:04}.ndjson", *arguments)
    checked = [check(shortest) for _ in range(TLC_SAMPLE)]
    started = [explore(tools, shortest, folder, limit) for _ in range(TLC_SAMPLE)]
    # Only how long it takes is asked for, so a rejected one does no harm.
    of_many = check(many, highest=1)
    each = [explore(tools, log, folder, limit) for log in sorted(many.iterdir())[:TLC_SAMPLE]]

    by_tlc = [count * statistics.median(times) for times in ([x.seconds for x in each], [x.cpu for x in each])]
    accepted = of_many.said.count(": accepted:")
    rows: list[list[Cell]] = [
        [
            f"a log of {SHORTEST} lines",
            *(hundredths(times) for times in ([x.seconds for x in checked], [x.cpu for x in checked])),
            *(hundredths(times) for times in ([x.seconds for x in started], [x.cpu for x in started])),
        ],
        ["TLC until its first state", None, None, hundredths([x.reading for x in started]), None],
        [
            f"{count:,} logs of {SMALL} lines, {accepted:,} of them accepted",
            tenths(of_many.seconds),
            tenths(of_many.cpu),
            *(round(times) for times in by_tlc),
        ],
    ]
    return table("Short and small logs", " | s7check, s | CPU | TLC, s | CPU", rows)


def hundredths(numbers: list[float]) -> float:
    """The median with two digits behind the point."""
    return round(statistics.median(numbers), 2)


@click.command()
@click.option("--events", default=1_000_000, show_default=True, help="Events of the long log.")
@click.option("--endless", default=10_000_000, show_default=True, help="Events of the longest log of the memory table.")
@click.option("--small", default=1_000, show_default=True, help="Number of small logs.")
@click.option("--tlc-limit", default=600.0, show_default=True, help="Seconds after which a run of TLC is ended.")
@click.option("--json", "output", type=click.File("w"), default="-", help="Write the tables there, not to the output.")
def main(events: int, endless: int, small: int, tlc_limit: float, output: TextIO) -> None:
    """Measure, and write the tables as JSON."""
    subprocess.run(["make", "-s", "-C", str(SOFT_PLC)], check=True, stdout=sys.stderr)  # noqa: S607
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        logs = {
            length: soft_plc(folder / f"{length}.ndjson", str(SCENARIO), "--events", str(length))
            for length in {*COMPARED, *MEMORY_LENGTHS, events, endless}
        }
        tables = [
            long_log(logs[events], events),
            small_logs(folder, small, tlc_limit),
            engines(
                {
                    f"a log of {SHORTEST} lines": folder / "shortest.ndjson",
                    f"{small:,} logs of {SMALL} lines": folder / "many",
                    f"{events:,} events": logs[events],
                }
            ),
            compare({n: logs[n] for n in COMPARED}, folder, tlc_limit),
            memory({n: logs[n] for n in {*MEMORY_LENGTHS, endless}}),
        ]
        output.write(json.dumps({"tables": tables}, indent=1) + "\n")


if __name__ == "__main__":
    main()

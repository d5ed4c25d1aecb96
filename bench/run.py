"""Measures the trace checker and TLC on the same logs, and prints the tables as Markdown.

Run it with the Python of the virtual environment; README.md says what is measured.
"""

import os
import platform
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import click

from evidence.tlc import log_as_tla
from evidence.tlc.process import Toolchain, find_toolchain
from s7check.engine.java import find_java

PROJECT = Path(__file__).resolve().parents[1]
SOFT_PLC = PROJECT / "examples" / "soft_plc"
SPECIFICATION = PROJECT / "spec"

SCENARIO = PROJECT / "bench" / "plant.scn"

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


@dataclass(frozen=True)
class Checked:
    """A run of ``s7check trace``: seconds, those of the CPU, and the most memory of Python and of the JVM in MB."""

    seconds: float
    cpu: float
    python: float
    jvm: float
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


def check(logs: Path, java_options: str = "", highest: int = 0) -> Checked:
    """Check logs, which have to give no exit code above ``highest``."""
    environment = os.environ | ({"JDK_JAVA_OPTIONS": java_options} if java_options else {})
    command = [sys.executable, "-m", "s7check", "trace", "--readings", "none", str(logs)]
    before = cpu_of_children()
    began = time.monotonic()
    # A file: nobody would empty a pipe while the process runs.
    with (
        tempfile.TemporaryFile("w+") as output,
        subprocess.Popen(command, env=environment, cwd=PROJECT, stdout=output) as process,
    ):
        python = jvm = 0.0
        while process.poll() is None:
            python = max(python, peak(process.pid))
            jvm = max([jvm, *map(peak, children(process.pid))])
            time.sleep(POLL)
        seconds = time.monotonic() - began
        output.seek(0)
        said = output.read()
    if process.returncode > highest:
        sys.exit(f"a log is not accepted: {said}")
    return Checked(seconds, cpu_of_children() - before, python, jvm, said)


def cpu_of_children() -> float:
    """CPU seconds of all processes that have ended, with their children."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def children(pid: int) -> list[int]:
    """The processes that a process has started and that still run."""
    try:
        return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
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
        *(f"-Djava.io.tmpdir={scratch}", f"-DTLA-Library={SPECIFICATION}"),
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


def row(*cells: str) -> str:
    """A row of a table."""
    return f"| {' | '.join(cells)} |"


def long_log(log: Path, events: int) -> list[str]:
    """The table of the long log."""
    say(f"s7check, {events} events")
    ran = check(log)
    return [
        "| events | MB | seconds | CPU seconds | events/s | JVM, MB | Python, MB |",
        "|---:|---:|---:|---:|---:|---:|---:|",
        row(
            f"{events:,}",
            f"{log.stat().st_size / 1024**2:.0f}",
            f"{ran.seconds:.1f}",
            f"{ran.cpu:.1f}",
            f"{events / ran.seconds:,.0f}",
            f"{ran.jvm:.0f}",
            f"{ran.python:.0f}",
        ),
    ]


def compare(logs: dict[int, Path], folder: Path, limit: float) -> list[str]:
    """The table of TLC and the checker at the same lengths."""
    tools = find_toolchain(None)
    rows = [
        "| events | TLC, s | CPU | reading the log, s | events/s | MB | s7check, s | CPU | events/s | ratio | of CPU |",
        "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|",
    ]
    for length, log in sorted(logs.items()):
        say(f"s7check and TLC, {length} events")
        checked = check(log)
        explored = explore(tools, log, folder, limit)
        ended = explored.end == "consumed"
        rows.append(
            row(
                f"{length:,}",
                f"{explored.seconds:.1f}",
                f"{explored.cpu:.1f}",
                f"{explored.reading:.1f}",
                f"{length / explored.seconds:,.0f}" if ended else explored.end,
                f"{explored.memory:,.0f}",
                f"{checked.seconds:.1f}",
                f"{checked.cpu:.1f}",
                f"{length / checked.seconds:,.0f}",
                f"{explored.seconds / checked.seconds:.1f}" if ended else "",
                f"{explored.cpu / checked.cpu:.1f}" if ended else "",
            )
        )
    return rows


def memory(logs: dict[int, Path]) -> list[str]:
    """The table of the memory at different lengths."""
    rows = ["| events | heap | JVM, MB | Python, MB | seconds |", "|---:|---|---:|---:|---:|"]
    runs = [(length, "448 MB, as usual", "") for length in sorted(logs)]
    runs += [(length, SMALL_HEAP, SMALL_HEAP) for length in SMALL_HEAP_LENGTHS]
    for length, heap, options in runs:
        say(f"memory, {length} events, heap {heap}")
        ran = check(logs[length], options)
        rows.append(row(f"{length:,}", heap, f"{ran.jvm:.0f}", f"{ran.python:.0f}", f"{ran.seconds:.1f}"))
    return rows


def small_logs(folder: Path, count: int, limit: float) -> list[str]:
    """The table of what the start of the programs decides: one short log, and many small ones."""
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
    return [
        "| | s7check, s | CPU | TLC, s | CPU |",
        "|---|---:|---:|---:|---:|",
        row(
            f"a log of {SHORTEST} lines",
            f"{statistics.median(x.seconds for x in checked):.2f}",
            f"{statistics.median(x.cpu for x in checked):.2f}",
            f"{statistics.median(x.seconds for x in started):.2f}",
            f"{statistics.median(x.cpu for x in started):.2f}",
        ),
        row("TLC until its first state", "", "", f"{statistics.median(x.reading for x in started):.2f}", ""),
        row(
            f"{count:,} logs of {SMALL} lines",
            f"{of_many.seconds:.1f}",
            f"{of_many.cpu:.1f}",
            *(f"{times:,.0f}" for times in by_tlc),
        ),
        "",
        f"Medians of {TLC_SAMPLE} runs; for many logs {count:,} times TLC's median of {TLC_SAMPLE} of them.",
        f"Accepted are {accepted:,} of the {count:,}.",
    ]


def machine(tools_name: str) -> str:
    """The machine and the versions in a sentence."""
    models = [
        line.split(":")[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if "model name" in line
    ]
    memory_gb = int(Path("/proc/meminfo").read_text().split()[1]) / 1024**2
    load = os.getloadavg()[0]
    said = subprocess.run([find_java(), "-version"], capture_output=True, text=True, check=True).stderr
    java = said.splitlines()[0].split('"')[1]
    cores = len(os.sched_getaffinity(0))
    return (
        f"Machine: {models[0] if models else platform.machine()}, {cores} cores, {memory_gb:.0f} GB. "
        f"Java {java}, Python {platform.python_version()}, TLC of {tools_name}.\n"
        f"Load when the run began: {load:.1f}; what other programs take lengthens the seconds, hardly those of the CPU."
    )


@click.command()
@click.option("--events", default=1_000_000, show_default=True, help="Events of the long log.")
@click.option("--endless", default=10_000_000, show_default=True, help="Events of the longest log of the memory table.")
@click.option("--small", default=1_000, show_default=True, help="Number of small logs.")
@click.option("--tlc-limit", default=600.0, show_default=True, help="Seconds after which a run of TLC is ended.")
def main(events: int, endless: int, small: int, tlc_limit: float) -> None:
    """Measure and print."""
    subprocess.run(["make", "-s", "-C", str(SOFT_PLC)], check=True, stdout=sys.stderr)  # noqa: S607
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        logs = {
            length: soft_plc(folder / f"{length}.ndjson", str(SCENARIO), "--events", str(length))
            for length in {*COMPARED, *MEMORY_LENGTHS, events, endless}
        }
        click.echo(f"# Results of one run\n\n{machine(find_toolchain(None).jar.name)}\n")
        tables: tuple[tuple[str, Callable[[], list[str]]], ...] = (
            ("One long log", lambda: long_log(logs[events], events)),
            ("Short and small logs", lambda: small_logs(folder, small, tlc_limit)),
            ("TLC on the same log", lambda: compare({n: logs[n] for n in COMPARED}, folder, tlc_limit)),
            ("Memory does not grow with the log", lambda: memory({n: logs[n] for n in {*MEMORY_LENGTHS, endless}})),
        )
        for title, rows in tables:
            click.echo(f"## {title}\n\n" + "\n".join(rows()) + "\n")


if __name__ == "__main__":
    main()

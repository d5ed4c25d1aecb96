"""Measures the trace checker on a long log, and TLC on the same log, and prints the tables as Markdown.

Run it with the Python of the virtual environment; README.md says what is measured.
"""

import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from trace_checker.java import find_java
from trace_checker.log.reader import read_log
from trace_checker.log.source import open_log
from trace_checker.models.tlc import Toolchain, find_toolchain

PROJECT = Path(__file__).resolve().parents[1]
SOFT_PLC = PROJECT / "examples" / "soft_plc"
SPECIFICATION = PROJECT / "spec"

LENGTHS = (1_000, 5_000, 20_000)
"""Lengths at which both TLC and the checker are measured, beside the long log."""
MEMORY_LENGTHS = (10_000, 100_000)
SMALL_HEAP = "-Xmx64m"
TLC_HEAP = "-Xmx4g"
POLL = 0.02

MODULE = """---- MODULE Bench ----
EXTENDS Trace, TraceLog
Out == INSTANCE TLC
VARIABLE index
BenchInit == Init /\\ index = 0
Line == Log[index]
BenchNext ==
    \\/ index = 0 /\\ Begin(Header) /\\ index' = 1
    \\/ /\\ index \\in 1..Len(Log)
       /\\ IF ~Arrived(Line) THEN Elapse(Line) /\\ UNCHANGED index
          ELSE \\/ Silent /\\ UNCHANGED index
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
    """A run of ``s7check trace``: seconds, and the most memory of Python and of the JVM in MB."""

    seconds: float
    python: float
    jvm: float


@dataclass(frozen=True)
class Explored:
    """A run of TLC: how it ended, seconds until the modules had been read, all seconds, most memory in MB."""

    end: str
    reading: float
    seconds: float
    memory: float


def say(text: str) -> None:
    """Say on standard error how far the benchmark is."""
    click.echo(text, err=True)


def write_log(folder: Path, seed: int, events: int) -> Path:
    """Have the soft PLC write a log."""
    log = folder / f"{events}.ndjson"
    command = [str(SOFT_PLC / "build" / "soft_plc"), "--random", str(seed), "--cpu", "S7-300"]
    subprocess.run([*command, "--events", str(events), "-o", str(log)], check=True)
    return log


def check(log: Path, java_options: str = "") -> Checked:
    """Check a log that has to be accepted."""
    environment = os.environ | ({"JDK_JAVA_OPTIONS": java_options} if java_options else {})
    command = [sys.executable, "-m", "trace_checker", "trace", str(log)]
    began = time.monotonic()
    with subprocess.Popen(command, env=environment, cwd=PROJECT, stdout=subprocess.PIPE, text=True) as process:
        python = jvm = 0.0
        while process.poll() is None:
            python = max(python, peak(process.pid))
            jvm = max([jvm, *map(peak, children(process.pid))])
            time.sleep(POLL)
        seconds = time.monotonic() - began
        said = process.stdout.read() if process.stdout else ""
    if process.returncode:
        sys.exit(f"the log is not accepted, choose another --seed: {said}")
    return Checked(seconds, python, jvm)


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
                return Explored("ended", reading or now, now, memory)
            time.sleep(POLL)
    seconds = time.monotonic() - began
    said = output.read_text()
    if "OutOfMemoryError" in said:
        return Explored("out of memory", reading, seconds, memory)
    if process.returncode or '"consumed"' not in said:
        sys.exit(f"TLC does not consume the log:\n{said[-2000:]}")
    return Explored("consumed", reading, seconds, memory)


def write_modules(log: Path, folder: Path) -> None:
    """Write the log as the module TraceLog, and the module that consumes it."""
    header: dict[str, Any] = {}
    events: list[dict[str, Any]] = []
    with open_log(str(log)) as source:
        for batch in read_log(source.chunks()):
            header = batch.header or header
            events += batch.events
    for event in events:
        del event["line"]
    with (folder / "TraceLog.tla").open("w") as module:
        sets = {name: as_set(value) if isinstance(value, list) else as_tla(value) for name, value in header.items()}
        module.write("---- MODULE TraceLog ----\nEXTENDS Trace\n")
        module.write(f"Header == {changed('NoHeader', sets)}\nLog == <<\n")
        module.write(",\n".join(as_event(event) for event in events))
        module.write("\n>>\n====\n")
    (folder / "Bench.tla").write_text(MODULE)
    (folder / "Bench.cfg").write_text(CONFIGURATION)


def as_event(event: dict[str, Any]) -> str:
    """An event with the fields that it has, the others as in NoEvent."""
    fields = {name: as_tla(value) for name, value in event.items()}
    if "info" in event:
        fields["info"] = changed("NoInfo", {name: as_tla(value) for name, value in event["info"].items()})
    return changed("NoEvent", fields)


def changed(record: str, fields: dict[str, str]) -> str:
    """A record with some fields replaced."""
    return f"[{record} EXCEPT {', '.join(f'!.{name} = {value}' for name, value in fields.items())}]"


def as_set(values: Iterable[Any]) -> str:
    """A set in TLA+."""
    return f"{{{', '.join(map(as_tla, values))}}}"


def as_tla(value: Any) -> str:
    """A value in TLA+: objects are records, arrays tuples."""
    if isinstance(value, bool):
        return str(value).upper()
    if isinstance(value, int):
        return str(value)
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, dict):
        return f"[{', '.join(f'{name} |-> {as_tla(inner)}' for name, inner in value.items())}]"
    return f"<<{', '.join(map(as_tla, value))}>>"


def compare(logs: dict[int, Path], folder: Path, limit: float) -> list[str]:
    """The table of TLC and the checker at the same lengths."""
    tools = find_toolchain(None)
    rows = [
        "| events | TLC, s | reading the log, s | TLC, events/s | TLC, MB | s7check, s | s7check, events/s | ratio |"
    ]
    rows.append("|---:|---:|---:|---:|---:|---:|---:|---:|")
    for length, log in sorted(logs.items()):
        say(f"s7check and TLC, {length} events")
        checked = check(log)
        explored = explore(tools, log, folder, limit)
        tlc, ratio = f"{explored.seconds:.1f} | {explored.reading:.1f} | ", ""
        if explored.end == "consumed":
            tlc += f"{length / explored.seconds:,.0f}"
            ratio = f"{explored.seconds / checked.seconds:.1f}"
        else:
            tlc += explored.end
        ours = f"{checked.seconds:.1f} | {length / checked.seconds:,.0f}"
        rows.append(f"| {length:,} | {tlc} | {explored.memory:,.0f} | {ours} | {ratio} |")
    return rows


def memory(logs: dict[int, Path]) -> list[str]:
    """The table of the memory at different lengths."""
    rows = ["| events | heap | JVM, MB | Python, MB | seconds |", "|---:|---|---:|---:|---:|"]
    for heap, options in (("as Java chooses", ""), (SMALL_HEAP, SMALL_HEAP)):
        for length in MEMORY_LENGTHS:
            say(f"memory, {length} events, heap {heap}")
            ran = check(logs[length], options)
            rows.append(f"| {length:,} | {heap} | {ran.jvm:.0f} | {ran.python:.0f} | {ran.seconds:.1f} |")
    return rows


def machine(tools_name: str) -> str:
    """The machine and the versions in a sentence."""
    models = [
        line.split(":")[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if "model name" in line
    ]
    memory_gb = int(Path("/proc/meminfo").read_text().split()[1]) / 1024**2
    said = subprocess.run([find_java(), "-version"], capture_output=True, text=True, check=True).stderr
    java = said.splitlines()[0].split('"')[1]
    cores = len(os.sched_getaffinity(0))
    return (
        f"Machine: {models[0] if models else platform.machine()}, {cores} cores, {memory_gb:.0f} GB. "
        f"Java {java}, Python {platform.python_version()}, TLC of {tools_name}."
    )


@click.command()
@click.option("--events", default=100_000, show_default=True, help="Events of the long log.")
@click.option("--seed", default=3, show_default=True, help="Seed of the soft PLC's random program.")
@click.option("--tlc-limit", default=180.0, show_default=True, help="Seconds after which a run of TLC is ended.")
def main(events: int, seed: int, tlc_limit: float) -> None:
    """Measure and print."""
    subprocess.run(["make", "-s", "-C", str(SOFT_PLC)], check=True, stdout=sys.stderr)  # noqa: S607
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        logs = {length: write_log(folder, seed, length) for length in {*LENGTHS, *MEMORY_LENGTHS, events}}
        say(f"s7check, {events} events")
        ran = check(logs[events])
        size = logs[events].stat().st_size / 1024**2
        click.echo(machine(find_toolchain(None).jar.name))
        click.echo(f"Log: soft PLC, S7-300, random program, seed {seed}, {size:.0f} MB for {events:,} events.\n")
        click.echo(
            "## One long log\n\n| events | seconds | events/s | JVM, MB | Python, MB |\n|---:|---:|---:|---:|---:|"
        )
        rate = events / ran.seconds
        click.echo(f"| {events:,} | {ran.seconds:.1f} | {rate:,.0f} | {ran.jvm:.0f} | {ran.python:.0f} |\n")
        click.echo("## Memory does not grow with the log\n\n" + "\n".join(memory(logs)) + "\n")
        compared = {length: logs[length] for length in (*LENGTHS, events)}
        click.echo("## The same specification in TLC\n\n" + "\n".join(compare(compared, folder, tlc_limit)))


if __name__ == "__main__":
    main()

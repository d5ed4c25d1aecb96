"""Damaged logs and sources: ``python -m tests.fuzz [--inputs N] [--seed N]``, or ``make fuzz``.

Each input is a shipped log, or a source of ``s7check import``, damaged in a way that its number and the seed decide.
Whatever it is, there has to be a verdict or a refusal, in one sentence, and every format has to be able to say it.
"""

import gzip
import json
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr
from dataclasses import dataclass, field
from io import StringIO
from pathlib import Path
from random import Random
from xml.etree import ElementTree as Xml

import click
from rich.console import Console
from rich.table import Table

from s7check import cli
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.judging.replay import FOLLOWED, Replay, with_readings, with_steps
from s7check.report.as_html import to_html
from s7check.report.as_json import to_json
from s7check.report.as_junit import to_junit
from s7check.report.as_sarif import to_sarif
from s7check.report.as_text import TextReports
from s7check.report.report import Report
from tests.shipped import CASES

KEPT = Path("build") / "fuzz"
SOURCES = Path(__file__).parents[2] / "examples" / "import"

HEADER = ["--cpu", "S7-400", "--obs", "1,10,35,80,85,100", "--mode", "RUN"]

EXPLAINED = 20
"""Of so many logs one is judged again for its timeline and other readings."""

BUDGET = 10
"""Seconds for a log's other readings, as by ``s7check trace --readings all --budget 10``."""

PATIENCE = 120
"""Seconds for a log."""

MARKUP = "<script>alert(1)</script>"
HOSTILE_BYTES = (
    b"\0", b"\xff\xfe", b"\xc3\x28", b"\xef\xbb\xbf", b"\r", b"\x0b", b"\x1b[2J", b"\x85", "\u2028\u202e".encode(),
    b"[" * 3000, b'{"a":' * 900, b"]" * 50, b"1e999999", b"9" * 400, b"9" * 9000, b"-", b'"', b"\\ud800", b"NaN",
    b"x" * 70_000, b"\n" * 5000, MARKUP.encode(), b"16#", b"\xa0", b",,",
)  # fmt: skip
HOSTILE_VALUES: tuple[object, ...] = (
    None, True, False, 0, -1, -0.0, 1.5, 1e300, 10**400, -(2**63), 2**64, "", "x" * 5000, MARKUP, "\0\x1b[31m\u202e",
    "W#16#FFFF", "W#16#10000", "B#16#00", "16#8090", "T#-24d20h31m23s648ms", "DT#90-1-1-0:0:0.0", "9999-99-99T99:99",
    "2026-02-29T00:00", "1990-01-01T00:00", "2089-12-31T23:59:59.999", [], {}, [[]], [1, 1], {"x_": MARKUP}, 80, 10, 85,
    65535, 2147483647, "auto", "S7-300", "cold", "RUN", "AMB-12", "a",
)  # fmt: skip

Damage = Callable[[Random, bytes], bytes]


def _flip(random: Random, data: bytes) -> bytes:
    damaged = bytearray(data)
    for _ in range(random.randint(1, 4)):
        damaged[random.randrange(len(damaged))] = random.randrange(256)
    return bytes(damaged)


def _cut(random: Random, data: bytes) -> bytes:
    return data[: random.randrange(len(data))]


def _insert(random: Random, data: bytes) -> bytes:
    place = random.randrange(len(data))
    return data[:place] + random.choice(HOSTILE_BYTES) + data[place:]


def _remove(random: Random, data: bytes) -> bytes:
    place = random.randrange(len(data))
    return data[:place] + data[place + random.randint(1, 30) :]


def _lines(random: Random, data: bytes) -> bytes:
    """A line removed, repeated, moved, cut short or joined with the next."""
    lines = data.splitlines(keepends=True)
    one, other = random.randrange(len(lines)), random.randrange(len(lines))
    match random.randrange(5):
        case 0:
            del lines[one]
        case 1:
            lines.insert(other, lines[one])
        case 2:
            lines.insert(other, lines.pop(one))
        case 3:
            lines[one] = lines[one][: random.randrange(len(lines[one]))] + b"\n"
        case _:
            lines[one] = lines[one].rstrip(b"\n")
    return b"".join(lines)


def _fields(random: Random, data: bytes) -> bytes:
    """A field of a line with another value, another name, or none."""
    lines = data.splitlines()
    number = random.randrange(len(lines))
    entry = json.loads(lines[number]) if _is_object(lines[number]) else {}
    if not entry:
        return _flip(random, data)
    name = random.choice(list(entry))
    inner = entry[name] if isinstance(entry[name], dict) and entry[name] and random.random() < 0.7 else entry
    name = random.choice(list(inner))
    match random.randrange(6):
        case 0:
            del inner[name]
        case 1:
            inner[random.choice(["ret", "ob", "at", "up", "x_" + MARKUP, MARKUP, "\0"])] = inner.pop(name)
        case 2:
            inner["x_own"] = random.choice(HOSTILE_VALUES)
        case _:
            inner[name] = random.choice(HOSTILE_VALUES)
    lines[number] = json.dumps(entry, ensure_ascii=random.random() < 0.5).encode()
    return b"\n".join(lines) + b"\n"


def _values(random: Random, data: bytes) -> bytes:
    """Up to three fields of events with the value that another line or another header has: all of it is well-formed."""
    entries = [json.loads(line) for line in data.splitlines() if _is_object(line)]
    if len(entries) < 2:
        return _fields(random, data)
    for _ in range(random.randint(1, 3)):
        entry = random.choice(entries[1:])
        name = random.choice(list(entry))
        entry[name] = random.choice([other[name] for other in entries if name in other])
    if random.random() < 0.2:
        entries[0]["cpu"] = random.choice(["S7-300", "S7-400", "CPU 318"])
        entries[0]["latency_ms"] = random.choice([0, 1, 10, 60_000])
    return b"".join(json.dumps(entry).encode() + b"\n" for entry in entries)


def _is_object(line: bytes) -> bool:
    try:
        return isinstance(json.loads(line), dict)
    except (ValueError, RecursionError):
        return False


def _pack(random: Random, data: bytes) -> bytes:
    """Packed, and then as often as not damaged; the name of the file ends in .gz."""
    packed = gzip.compress(data, mtime=0)
    return random.choice([_flip, _cut, _insert, _remove, _same, _same])(random, packed)


def _same(_: Random, data: bytes) -> bytes:
    return data


DAMAGES: dict[str, Damage] = {
    "bytes changed": _flip,
    "cut off": _cut,
    "hostile bytes put in": _insert,
    "bytes removed": _remove,
    "lines removed, repeated, moved, cut": _lines,
    "fields changed, renamed, removed": _fields,
    "values exchanged between lines": _values,
    "packed, and damaged": _pack,
}
WEIGHTS = [2, 1, 3, 1, 3, 8, 8, 1]


@dataclass
class Tally:
    """What came of the inputs; ``faults`` say which input was treated wrongly, and how."""

    counts: dict[str, Counter[str]] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)
    slowest: float = 0.0

    def add(self, kind: str, outcome: str, seconds: float, faults: list[str], content: bytes) -> None:
        """Counts an input, and keeps one that was treated wrongly."""
        self.counts.setdefault(kind, Counter())[outcome] += 1
        self.slowest = max(self.slowest, seconds)
        if faults:
            kept = KEPT / str(len(self.faults))
            KEPT.mkdir(parents=True, exist_ok=True)
            kept.write_bytes(content)
            self.faults += [f"{kept}: {kind}: {fault}" for fault in faults]


def run_logs(inputs: range, seed: int, folder: Path, tally: Tally) -> None:
    """Judges the damaged logs with these numbers, all by one engine."""
    signal.signal(signal.SIGALRM, _too_long)
    logs = [case for case in sorted(CASES, key=lambda case: case.file) if case.log and not case.packed]
    with Engine() as engine:
        for number in inputs:
            random = Random(f"{seed}/{number}")  # noqa: S311
            log = random.choice(logs)
            kind = random.choices(list(DAMAGES), WEIGHTS)[0]
            file = folder / f"log{'.gz' if DAMAGES[kind] is _pack else ''}"
            file.write_bytes(DAMAGES[kind](random, log.log))
            begun = time.monotonic()
            outcome, found = "failed", []
            signal.alarm(PATIENCE)
            try:
                report = check_log(str(file), engine, lambda _, __: None)
                outcome = report.verdict
                if number % EXPLAINED == 0 and outcome in ("accepted", "rejected"):
                    replay = Replay(str(file), [])
                    until = time.monotonic() + BUDGET
                    report = with_readings(with_steps(report, engine, replay), engine, replay, until)
                    assert len(report.steps) <= FOLLOWED
                found = list(_faults_of(report))
            except Exception as error:  # whatever it is, it is what is looked for
                found = [f"{type(error).__name__}: {error}"]
            finally:
                signal.alarm(0)
            tally.add(kind, outcome, time.monotonic() - begun, found, file.read_bytes())


def _too_long(_: int, __: object) -> None:
    raise TimeoutError(f"no verdict after {PATIENCE} s")


def _faults_of(report: Report) -> Iterator[str]:
    """What is wrong with a report of a damaged log."""
    if report.verdict == "no verdict":
        yield f"no verdict: {report.message}"
    if not report.message.isprintable() or len(report.message) > 1000:
        yield f"a message not for people: {report.message[:1000]!r}"
    if report.verdict == "unusable" and not (report.line and "expected " in report.message):
        yield f"no line, or nothing that was expected: {report.message}"
    if report.verdict == "rejected" and not (report.line and report.requirements):
        yield "rejected without a line or a requirement"
    if not click.unstyle(TextReports().add(report)).replace("\n", "").isprintable():
        yield "control characters in the text"
    json.loads(to_json(report))
    json.loads(to_sarif([report]))
    Xml.fromstring(to_junit([report]))  # noqa: S314 - it was written here
    if MARKUP.encode() in to_html([report]):
        yield "markup of the log in the page"


def run_sources(inputs: range, seed: int, folder: Path, tally: Tally) -> None:
    """Imports the damaged sources with these numbers."""
    csv = ["--from", "csv", "--map", str(SOURCES / "columns.json")]
    kinds: dict[str, list[str]] = {
        "english.txt": ["--from", "step7"], "german.txt": ["--from", "step7"], "events.csv": csv,
        "szl.hex": ["--from", "szl"], "ring.hex": ["--from", "ring"], "columns.json": ["--from", "csv", "--map"],
        "header.json": [*csv, "--header"],
    }  # fmt: skip
    for number in inputs:
        random = Random(f"{seed}/{number}")  # noqa: S311
        name = random.choice(list(kinds))
        file = folder / name
        content = (SOURCES / name).read_bytes()
        for _ in range(random.randint(1, 2)):
            content = random.choice([_flip, _cut, _insert, _remove, _lines, _fields])(random, content or b"\n")
        file.write_bytes(content)
        source = SOURCES / "events.csv" if name.endswith(".json") else ""
        arguments = [*kinds[name], str(file), *([str(source)] if source else [])]
        begun = time.monotonic()
        said = StringIO()
        with redirect_stderr(said):
            code = cli.main(["import", *arguments, *HEADER, "-o", str(folder / "imported")])
        text = said.getvalue()
        found = []
        if code not in (0, 2):
            found.append(f"exit code {code}: {text}")
        elif code and not (text.count("Error: ") == 1 and text.replace("\n", "").isprintable()):
            found.append(f"a message not for people: {text!r}")
        tally.add(f"import of {name}", "refused" if code else "written", time.monotonic() - begun, found, content)


@click.command()
@click.option("--inputs", type=click.IntRange(8), default=24_000, show_default=True, help="An eighth are sources.")
@click.option("--seed", type=int, default=1, show_default=True, help="Other inputs.")
@click.option("--json", "json_path", type=click.Path(path_type=Path, dir_okay=False), help="Write the results there.")
def main(inputs: int, seed: int, json_path: Path | None) -> None:
    """Damage logs and sources and see that each gets its verdict or its refusal."""
    tally = Tally()
    begun = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        run_sources(range(inputs // 8), seed, Path(folder), tally)
        run_logs(range(inputs // 8, inputs), seed, Path(folder), tally)
    outcomes = sorted({outcome for counts in tally.counts.values() for outcome in counts})
    table = Table("damage", *outcomes, "faults")
    for kind, counts in tally.counts.items():
        faults = sum(f": {kind}: " in fault for fault in tally.faults)
        table.add_row(kind, *(str(counts[outcome] or "") for outcome in outcomes), str(faults))
    total: Counter[str] = sum(tally.counts.values(), Counter())
    table.add_row("all", *(str(total[outcome]) for outcome in outcomes), str(len(tally.faults)))
    Console(width=120).print(table)
    click.echo(f"{inputs} inputs, {time.monotonic() - begun:.0f} s, the slowest {tally.slowest:.1f} s")
    for fault in tally.faults:
        click.echo(fault)
    if json_path is not None:
        report = {"outcomes": tally.counts, "faults": tally.faults, "slowest": round(tally.slowest, 1)}
        json_path.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    sys.exit(1 if tally.faults else 0)


if __name__ == "__main__":
    main()

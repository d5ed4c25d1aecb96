"""``s7spec logs engines``: do the executable, the page and the engine in Java give the same answers?"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from itertools import count, islice
from pathlib import Path
from random import Random
from typing import Any

import click
import msgspec

from evidence.common import gallery
from evidence.common.cases import all_cases
from evidence.common.checkout import SOFT_PLC_PROGRAM
from evidence.common.chromium import page_engine
from evidence.common.console import plain
from evidence.common.options import folder_option, json_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.logs.random_logs import Generator, SoftPlcError
from s7check.engine.answer import Answer
from s7check.engine.client import Engine
from s7check.engine.command import EngineError, jvm_command, native_command

DIFFER = 1
VERDICTS = ("accepted", "rejected", "unusable", "error")
STRANGE = (
    b"\0",
    b"\xff",
    b"\xed\xa0\x80",
    "\u2028\U0001f600".encode(),
    b"\\ud83d\\ude00",
    b"1e400",
    b"9" * 400,
    b"[" * 999,
    b'""',
)


def _judged(engine: Engine, log: bytes) -> Answer:
    """The answer of an engine that is a process to a log, with the situation after its last line."""
    engine.begin(follow=1, outcomes=True)
    engine.send(log)
    return engine.finish()


@contextmanager
def _executable(command: Callable[[], list[str]]) -> Iterator[Callable[[bytes], Answer]]:
    with Engine(command) as engine:
        yield partial(_judged, engine)


@click.command(name="engines", short_help="Do the executable, the page and Java give the same answers?")
@click.option("--logs", type=click.IntRange(0), default=10_000, show_default=True, help="How many random logs.")
@click.option("--damaged", type=click.IntRange(0), default=1_000, show_default=True, help="How many damaged ones.")
@click.option("--seed", type=int, default=1, show_default=True, help="Other logs.")
@click.option("--page", is_flag=True, help="The engine in the checker's page, in Chromium, instead of the executable.")
@click.option("--wine", is_flag=True, help="The executable for Windows, under wine.")
@folder_option("--keep", Path("build") / "engines", "Where the logs go about which the two differ.")
@json_option
def engines_command(
    logs: int, damaged: int, seed: int, page: bool, wine: bool, keep: Path, json_path: Path | None
) -> None:
    """Have two engines judge all cases, the edge cases, random logs and logs with damaged bytes.

    The whole answers are compared: verdict, line, expected events, requirements, situations, candidates, outcomes. Exit
    codes: 0 all are the same, 1 some differ, 2 wrong arguments or files, 3 an engine is missing or failed.
    """
    rows: dict[str, dict[str, str | int]] = {}
    with session(Processes(), (OSError,), (EngineError, SoftPlcError)) as console:
        other = page_engine() if page else _executable(_under_wine if wine else native_command)
        with other as compiled, Engine(jvm_command) as java:
            generator = Generator(seed, SOFT_PLC_PROGRAM, java.alternatives())
            for kind, name, log in _inputs(generator, logs, damaged):
                row = rows.setdefault(kind, {"kind": kind} | dict.fromkeys(("logs", *VERDICTS, "different"), 0))
                native, jvm = _as_fields(compiled(log)), _as_fields(_judged(java, log))
                for column in ("logs", jvm["verdict"], *(["different"] if native != jvm else [])):
                    row[column] = int(row[column]) + 1
                if native != jvm:
                    keep.mkdir(parents=True, exist_ok=True)
                    (keep / f"{name}.ndjson").write_bytes(log)
                    plain(console, f"{name}: {_first(native, jvm)}", style="red")
        for row in rows.values():
            plain(console, ", ".join(f"{name} {value}" for name, value in row.items()))
        write_json(json_path, {"kinds": list(rows.values())})
    sys.exit(DIFFER if any(row["different"] for row in rows.values()) else 0)


def _under_wine() -> list[str]:
    executable, parsed = native_command()
    return ["wine", f"{executable}.exe", f"Z:{parsed}"]


def _inputs(generator: Generator, logs: int, damaged: int) -> Iterator[tuple[str, str, bytes]]:
    cases = [(case.id.replace("/", "-"), b"\n".join(case.lines)) for case in all_cases()]
    yield from (("cases", name, log) for name, log in cases)
    yield from (("gallery", case.name, case.log) for case in gallery.cases())
    yield from (("random", f"random-{number}", generator.draw(number, 0).content) for number in range(1, logs + 1))
    random = Random(damaged)  # noqa: S311
    for number in islice(count(), damaged):
        log = bytearray(random.choice(cases)[1])
        for _ in range(random.randint(1, 3)):
            place = random.randrange(len(log) + 1)
            log[place : place + random.randrange(3)] = random.choice([random.randbytes(1), *STRANGE])
        yield "damaged", f"damaged-{number}", bytes(log)


def _as_fields(answer: Answer) -> dict[str, Any]:
    fields: dict[str, Any] = msgspec.to_builtins(answer)
    if fields["verdict"] == "error":
        del fields["message"]
    return fields


def _first(native: dict[str, Any], java: dict[str, Any]) -> str:
    """The first field in which two answers differ."""
    name = next(name for name in native | java if native.get(name) != java.get(name))
    return f"{name}: {native.get(name)} compiled, {java.get(name)} by Java"

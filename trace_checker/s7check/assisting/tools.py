"""The tools of ``s7check mcp``: each answers what a command answers, in a text of bounded length with IDs of rules."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any

import click
import msgspec
from mcp.server import MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp.types import ToolAnnotations
from pydantic import Field

import s7check
from s7check.api import check
from s7check.asking.log_prefix import Prefix, prefix_of
from s7check.asking.next_answer import what_is_next
from s7check.asking.next_text import to_text
from s7check.asking.variants import Variant, variants
from s7check.asking.why_not import why_not
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.replay import Replay, TooLongError, with_readings
from s7check.kit.collection import UnreadableProgramError, chosen, programs_of
from s7check.kit.program import FORMAT, Program, read_program
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.source import open_log
from s7check.report.clauses import all_clauses, clause
from s7check.report.report import clause_text
from s7check.simulating.comparison import compare_log, compare_program
from s7check.simulating.simulate_command import the_program
from s7check.simulating.simulation import outcomes, simulated

LONGEST = 12_000
"""Characters of an answer; the rest comes in further parts."""

_READINGS_S = 10.0
"""Seconds for other readings of a rejected log."""

_MOST_RULES = 20

_INSTRUCTIONS = """Rules of Siemens S7-300/400 interrupts: SFC 28-34 and 39-42, OB 10-17, 20-23, 80, 85, the clock, \
STOP and restart. A formal specification answers; every answer names requirements such as TINT-14 or open questions \
such as AMB-12, which `rule` shows with their sources.
A log has one JSON object a line: a header, then events in their order, such as
{"format": "s7-interrupt-log/1", "cpu": "S7-300", "obs": [1, 10, 80, 85], "clock": "2026-11-21T05:59", "mode": "RUN"}
{"event": "SET_TINT", "at": "2026-11-21T05:59:10.0", "ob": 10, "sdt": "2026-11-21T06:00", "period": "16#0201", "ret": 0}
{"event": "ACT_TINT", "at": "2026-11-21T05:59:20.0", "ob": 10, "ret": 0}
{"event": "start", "at": "2026-11-21T06:00:00.001", "ob": 10}
{"event": "end", "at": "2026-11-21T06:00:00.002", "ob": 10}
Other events: clock (to), stop, restart (type), run, interrupt (ob), load, delete, and the calls CAN_TINT, QRY_TINT, \
SRT_DINT (ob, dtime, sign), CAN_DINT, QRY_DINT, DIS_IRT and EN_IRT (mode, ob), DIS_AIRT, EN_AIRT, each with ret.
A program has the header's fields, and what each OB does, such as
{"format": "s7-interrupt-program/1", "name": "delayed", "about": "OB 20 comes after EN_AIRT.", "requirements": [], \
"header": {"cpu": "S7-300", "obs": [1, 20, 100], "clock": "2026-11-21T06:00", "mode": "RUN"}, "duration": 200, \
"bodies": [{"ob": 1, "run": 1, "steps": [{"call": "SRT_DINT", "ob": 20, "dtime": 10, "sign": 1}, {"call": "DIS_AIRT"}, \
{"wait": 50}, {"call": "EN_AIRT"}]}, {"ob": 1, "steps": [{"wait": 10}]}]}"""

Log = Annotated[str, Field(description="The lines of a log, or the path of a file with them.")]
Line = Annotated[int | None, Field(description="The last line of the log that counts, from 1; all lines by default.")]
Part = Annotated[int, Field(ge=1, description="Which part of a long answer.")]
Runnable = Annotated[
    str, Field(description="A program, a JSON object; or the path of a file with one, or a name of the kit.")
]
Cpus = Annotated[list[str], Field(description="Other CPUs: S7-300, S7-400, CPU 318, S7-1500.")]
Profiles = Annotated[list[str], Field(description="Other editions, such as 1997, or translations, such as 2006ru.")]
Readings = Annotated[list[dict[str, str]], Field(description='Other readings, such as {"AMB-12": "a"}.')]


def server() -> MCPServer[Any]:
    """The server with its tools."""
    made: MCPServer[Any] = MCPServer(
        "s7check", instructions=_INSTRUCTIONS, version=s7check.__version__, log_level="ERROR"
    )
    reading = ToolAnnotations(read_only_hint=True, open_world_hint=False)
    tools: list[Callable[..., str]] = [check_log, next_events, why_not_event, simulate, compare, rule]
    for tool in tools:
        made.add_tool(tool, annotations=reading, structured_output=False)
    return made


def check_log(
    log: Log,
    other_readings: Annotated[bool, Field(description="If it is rejected: what other readings say.")] = False,
    part: Part = 1,
) -> str:
    """Check a log: accepted, or the line that no CPU may show, with the rule, its source, and what was expected."""
    with _told(), pool.engine() as engine:
        text = _is_text(log)
        report = check(_data(log).split(b"\n") if text else _file(log), name="log")
        if other_readings and report.verdict == "rejected":
            replay = Replay("-" if text else log, report.lines)
            report = with_readings(report, engine, replay, time.monotonic() + _READINGS_S)
        return _part(str(report), part)


def next_events(
    log: Log,
    line: Line = None,
    cpus: Cpus = [],  # noqa: B006 - read alone
    profiles: Profiles = [],  # noqa: B006
    readings: Readings = [],  # noqa: B006
    part: Part = 1,
) -> str:
    """After a log: the state of the CPU, what must come and by when, what may come. Others add what they change."""
    with _told(), pool.engine() as engine:
        prefix = _prefix(engine, log, line)
        return _part(to_text(what_is_next(engine, prefix, variants(cpus, profiles, readings))), part)


def why_not_event(
    log: Log,
    event: Annotated[dict[str, Any], Field(description='Such as {"event": "start", "ob": 10}; "at" may be missing.')],
    line: Line = None,
    part: Part = 1,
) -> str:
    """Why an event may not come after a log: the condition that is false, its rule, the readings that allow it."""
    with _told(), pool.engine() as engine:
        prefix = _prefix(engine, log, line)
        last, _, report = why_not(engine, prefix, event, time.monotonic() + _READINGS_S)
        return _part(f"{prefix.name}:{last}: this may come next" if report is None else str(report), part)


def simulate(
    program: Runnable,
    cpu: Annotated[str | None, Field(description="Another CPU than the program's.")] = None,
    profile: Annotated[str | None, Field(description="An edition of the manual.")] = None,
    readings: Annotated[dict[str, str], Field(description='Such as {"AMB-12": "a"}.')] = {},  # noqa: B006
    every_outcome: Annotated[bool, Field(description="All logs, as a tree, in place of one.")] = False,
    part: Part = 1,
) -> str:
    """Run a program without a CPU: the log that the specification makes of it."""
    with _told(), pool.engine() as engine:
        variant = Variant("", cpu, profile, tuple(readings.items()))
        if every_outcome:
            tree = outcomes(engine, _program(program), variant)
            return _part("\n".join([msgspec.json.encode(tree["header"]).decode(), *tree["text"]]), part)
        log = simulated(engine, _program(program), variant)
        return _part("\n".join(msgspec.json.encode(line).decode() for line in log), part)


def compare(
    program_or_log: Annotated[str, Field(description="A program or a log: its text, a path, or a name of the kit.")],
    cpus: Cpus = [],  # noqa: B006
    profiles: Profiles = [],  # noqa: B006
    readings: Readings = [],  # noqa: B006
    part: Part = 1,
) -> str:
    """Compare CPUs, editions or readings: two on a program (first difference), any number on a log (who allows it)."""
    sides = variants(cpus, profiles, readings)
    with _told(), pool.engine() as engine:
        if _is_program(program_or_log):
            if len(sides) != 2:
                raise ToolError(f"expected two of cpus, profiles, readings; found {len(sides)}")
            _, lines = compare_program(engine, _program(program_or_log), *sides)
        elif not sides:
            raise ToolError("expected cpus, profiles or readings; found none of them")
        else:
            _, lines = compare_log(engine, _prefix(engine, program_or_log, None), sides)
        return _part("\n".join(lines), part)


def rule(
    name: Annotated[str, Field(description="An ID such as TINT-14 or AMB-12; or words that the rule has.")],
) -> str:
    """A rule by its ID: its text, sources and confidence; of an open question also its readings by letter."""
    if clause(name).text:
        return _whole(name)
    words = name.casefold().split()
    found = [one.id for one in all_clauses() if all(word in f"{one.id} {one.text}".casefold() for word in words)]
    if not found or not words:
        raise ToolError(f"expected an ID such as TINT-14 or AMB-12, or words of a rule; found {name!r}")
    more = [f"and {len(found) - _MOST_RULES} more: name more words"] if len(found) > _MOST_RULES else []
    return _part("\n".join([*map(_whole, found[:_MOST_RULES]), *more]), 1)


def _whole(name: str) -> str:
    found = clause(name)
    letters = [f"  ({letter}) {text}" for letter, text in found.letters.items()]
    place = "" if found.source else f" ({found.place})"
    return "\n".join([clause_text(name) + place, *letters])


@contextmanager
def _told() -> Iterator[None]:
    """What goes wrong, in one sentence for the assistant."""
    try:
        yield
    except (UnusableLogError, UnreadableProgramError, EngineError, TooLongError) as error:
        raise ToolError(str(error)) from error
    except click.ClickException as error:
        raise ToolError(error.format_message()) from error


def _is_text(given: str) -> bool:
    return given.lstrip().startswith("{")


def _file(name: str) -> str:
    if name == "-":  # the assistant's own messages
        raise ToolError("expected the lines of a log, or the path of a file; found '-'")
    return name


def _data(given: str) -> bytes:
    if _is_text(given):
        return given.encode("utf-8", "surrogatepass")
    with open_log(_file(given)) as source:
        return b"".join(as_utf8(source.chunks()))


def _prefix(engine: Engine, log: str, line: int | None) -> Prefix:
    return prefix_of(engine, "log" if _is_text(log) else log, _data(log), line)


def _is_program(given: str) -> bool:
    """Whether this is a program; a name that is no file is one of the kit's."""
    if not _is_text(given) and not Path(given).is_file():
        return True
    return FORMAT.encode() in _data(given)[:4096]


def _program(given: str) -> Program:
    if _is_text(given):
        return read_program(given.encode("utf-8", "surrogatepass"))
    if Path(given).is_file():
        return the_program(Path(given), None)
    found = [program for program in chosen(programs_of(), [given], []) if program.name == given]
    if not found:
        raise ToolError(f"expected a program, its file, or a name of the kit; found {given!r}")
    return found[0]


def _part(text: str, part: int) -> str:
    """A part of a text, whole lines as far as they are short enough. Raises ToolError for one that there is not."""
    parts = [""]
    for line in click.unstyle(text).splitlines(keepends=True):
        for piece in (line[at : at + LONGEST] for at in range(0, len(line), LONGEST)):
            if len(parts[-1]) + len(piece) > LONGEST:
                parts.append("")
            parts[-1] += piece
    if part > len(parts):
        raise ToolError(f"part: expected 1 to {len(parts)}; found {part}")
    more = f"\n(part {part} of {len(parts)})" if len(parts) > 1 else ""
    return parts[part - 1].rstrip("\n") + more

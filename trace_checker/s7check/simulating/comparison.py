"""Two or more CPUs, editions or readings beside each other: what differs, in lines for people."""

from __future__ import annotations

from collections.abc import Sequence

from s7check.asking.log_prefix import Prefix
from s7check.asking.session import Session
from s7check.asking.variants import Variant
from s7check.engine.client import Engine
from s7check.kit.program import Program
from s7check.report.report import clause_text
from s7check.simulating.separation import log_of, separation
from s7check.simulating.two_sides import difference_text


def compare_program(engine: Engine, program: Program, first: Variant, second: Variant) -> tuple[bool, list[str]]:
    """Whether the program tells the sides apart, and the lines that say how. Raises EngineError."""
    logs = {side: log_of(engine, program, side) for side in (first, second)}
    for allowed, refused in ((first, second), (second, first)):
        found = separation(engine, program, logs[allowed], allowed, refused)
        if found is not None:
            return True, difference_text(found, logs[allowed], logs[refused])
    return False, [f"no difference: each allows the log of the other ({len(logs[first]) - 1} events)"]


def compare_log(engine: Engine, prefix: Prefix, sides: Sequence[Variant]) -> tuple[bool, list[str]]:
    """Whether the sides differ about the log, and what each says of it. Raises EngineError and UnusableLogError."""
    ends: set[int | None] = set()
    named: set[str] = set()
    said = []
    for side in sides:
        line, requirements = _end(engine, prefix, side)
        ends.add(line)
        named.update(requirements)
        what = "allows it" if line is None else f"line {line} is not possible: {', '.join(requirements)}"
        said.append(f"{side.name}: {what}")
    return len(ends) > 1, [*said, *(f"  {clause_text(name)}" for name in sorted(named))]


def _end(engine: Engine, prefix: Prefix, side: Variant) -> tuple[int | None, list[str]]:
    """The line that the side does not allow, if there is one, and the requirements that decide."""
    session = Session(engine, side.of(prefix.header))
    for number, event in prefix.events:
        refusal = session.feed(event)
        if refusal is not None:
            session.close()
            return number, refusal.requirements
    session.close()
    return None, []

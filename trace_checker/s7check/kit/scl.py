"""A program as SCL source for a real CPU: the bodies of its OBs, each run a branch, with the logging FCs of s7log.scl.

Nothing here was compiled by STEP 7, and no CPU has run it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from s7check.kit.program import Body, Program, bodies_of
from s7check.log.calls import OPERANDS, WITHOUT_NUMBER

_SFC: dict[str, int] = dict(
    zip((name for name in OPERANDS if name != WITHOUT_NUMBER), (*range(28, 35), *range(39, 43)), strict=True)
)
"""The SFCs in the order of their numbers."""

_PARAMETERS = {"ob": "OB_NR", "sdt": "SDT", "period": "PERIOD", "dtime": "DTIME", "sign": "SIGN", "mode": "MODE"}

_RUNS = "DB110"
"""Counts the runs of each OB; s7log.scl has the numbers up to 101 and FC 100 to 151."""


class NotForCpuError(Exception):
    """The program has a step that SCL cannot say; the text says which."""


def sfc(call: str) -> int:
    """The number of a call. Raises NotForCpuError."""
    if call == WITHOUT_NUMBER:
        raise NotForCpuError(f"{call}: S7-300/400 have no such SFC")
    return _SFC[call]


def to_scl(program: Program) -> str:
    """The source, which ends with the end of a line. Raises NotForCpuError."""
    bodies = bodies_of(program.plain)
    obs = sorted({1, *program.header["obs"], *(body.ob for body in bodies)})
    parts = [_comment(program), _data_block(obs), _WAIT]
    parts += [_block(ob, [body for body in bodies if body.ob == ob]) for ob in obs]
    return "\n\n".join(parts) + "\n"


def _comment(program: Program) -> str:
    header = program.header
    lines = [
        f"(* {program.name}: {_plain(program.about)}",
        "",
        "   Generated from a program of the conformance kit; never compiled by STEP 7, never run on a CPU.",
        "   Compile it together with instrumentation/scl/s7log.scl, whose FCs write the log.",
        f"   CPU: {header['cpu']}. Set the clock to {header['clock']}, then begin in {header.get('mode', 'STOP')}.",
    ]
    lines += [f"   Priority class of OB {ob}: {level}." for ob, level in header.get("priority", {}).items()]
    step7 = header.get("step7", {})
    for ob, parameters in (*step7.get("tod", {}).items(), *step7.get("dint", {}).items()):
        said = ", ".join(f"{name} {value}" for name, value in parameters.items())
        lines.append(f"   STEP 7 parameters of OB {ob}: {said}.")
    if program.outside:
        lines.append("   From outside, by hand or by a second station:")
        lines += [f"   {_event(event)}" for event in program.outside]
    return "\n".join(lines) + " *)"


def _event(event: dict[str, Any]) -> str:
    fields = " ".join(f"{name} {value}" for name, value in event.items() if name not in ("after", "event", "every"))
    again = f", then every {event['every']} ms" if "every" in event else ""
    return f"after {event['after']} ms{again}: {event['event']} {fields}".rstrip()


def _plain(text: str) -> str:
    """Without what would end a comment."""
    return text.replace("*)", "* )").replace("(*", "( *")


def _data_block(obs: list[int]) -> str:
    members = "\n".join(f"  ob_{ob} : INT := 0;" for ob in obs)
    return f"DATA_BLOCK {_RUNS}\nTITLE = 'runs of the OBs'\nSTRUCT\n{members}\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK"


_WAIT = """(* Works for so many milliseconds, by SFC 64; interruptions count. *)
FUNCTION FC199 : VOID
VAR_INPUT
  ms : DINT;
END_VAR
VAR_TEMP
  begun : DINT;
END_VAR
BEGIN
  begun := TIME_TO_DINT(SFC64());
  WHILE TIME_TO_DINT(SFC64()) - begun < ms DO
    ;
  END_WHILE;
END_FUNCTION"""


def _block(ob: int, bodies: list[Body]) -> str:
    lines = [
        f"ORGANIZATION_BLOCK OB{ob}",
        "VAR_TEMP",
        "  info : ARRAY[0..11] OF BYTE;",
        "  date_time : DATE_AND_TIME;",
        "  ret : INT;",
        "  status : WORD;",
        "END_VAR",
        "BEGIN",
        "  FC110(DATE_TIME := date_time);",
        f"  {_RUNS}.ob_{ob} := {_RUNS}.ob_{ob} + 1;",
    ]
    numbered = [body for body in bodies if body.run]
    others = [body for body in bodies if not body.run]
    if numbered:
        lines.append(f"  CASE {_RUNS}.ob_{ob} OF")
        for body in numbered:
            lines.append(f"  {body.run} :")
            lines += [f"    {statement}" for statement in _statements(body)]
        if others:
            lines.append("  ELSE :")
            lines += [f"    {statement}" for statement in _statements(others[0])]
        lines.append("  END_CASE;")
    elif others:
        lines += [f"  {statement}" for statement in _statements(others[0])]
    if ob != 1:
        lines.append("  FC111();")
    return "\n".join([*lines, "END_ORGANIZATION_BLOCK"])


def _statements(body: Body) -> Iterator[str]:
    empty = True
    for step in body.steps:
        if "end" in step:
            continue
        empty = False
        if "wait" in step:
            yield f"FC199(ms := {step['wait']});"
        elif "call" in step:
            yield _call(step)
        elif step["event"] == "state":
            yield f"FC151(OB_NR := {step['ob']});"
        elif step["event"] == "zone":
            raise NotForCpuError("a zone: S7-300/400 have none")
        elif "to" in step:
            yield f"ret := FC100(PDT := {_date(step['to'])});"
        else:
            raise NotForCpuError("a clock that is moved by a duration: SFC 0 sets a date")
    if empty:
        yield ";"


def _call(step: dict[str, Any]) -> str:
    name = step["call"]
    number = sfc(name)
    operands = [f"{_PARAMETERS[field]} := {_value(field, step[field])}" for field in OPERANDS[name]]
    if name in ("QRY_TINT", "QRY_DINT"):
        operands.append("STATUS := status")
    return f"ret := FC{100 + number}({', '.join(operands)});"


def _value(field: str, value: Any) -> str:
    if field == "sdt":
        return _date(value)
    if field == "dtime":
        return f"T#{'-' if value < 0 else ''}{abs(value)}MS"
    if field in ("period", "sign"):
        return f"WORD#16#{value:04X}"
    if field == "mode":
        return f"BYTE#16#{value:02X}"
    return str(value)


def _date(value: str) -> str:
    return "DT#" + value.replace("T", "-")

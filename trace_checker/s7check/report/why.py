"""Why a line is not possible, in a sentence: what cannot be, the requirement, what may be instead.

The words of a rule are those of its requirement.
"""

import re
from collections.abc import Sequence
from typing import Any

import msgspec

from s7check.engine.answer import Allowed
from s7check.log.calls import OPERANDS
from s7check.report.clauses import clause
from s7check.report.expected import format_value

_SENTENCE = re.compile(r"(?:[^.(]|\([^)]*\)|[.](?! |$))+[.]?")
_MOST = 6
_CODE = re.compile(r"\b(?:16#)?([0-9A-F]{4})\b")


def why_not(event: bytes, late: Sequence[str], expected: Sequence[Allowed], requirements: Sequence[str]) -> str:
    """Such as ``SET_TINT cannot answer 16#0000 here. Monthly: the day of SDT is limited to 1 to 28 (TINT-18). It
    answers 16#8091.``

    ``event`` is the line, ``late`` are the texts of what had to come before it, of the ``requirements`` the first one
    decides most. Empty without requirements.
    """
    if not requirements:
        return ""
    if late:
        return f"Before this line has to come: {_or(late)}. {_rule(requirements[0])}"
    try:
        line = msgspec.json.decode(event, type=dict[str, Any])
    except msgspec.MsgspecError:
        return ""
    fields = [one for one in expected if one.event == line.get("event") and format_value(one)]
    # Of several wrong fields one is told; the others stand in what was expected.
    field = next((one.field for one in fields if _given(line, one.field)), "")
    instead = _or([format_value(one) for one in fields if one.field == field])
    claim, end = _claim(line, field, instead)
    return f"{claim} here. {_rule(requirements[0], claim + instead)}{end}"


def _claim(line: dict[str, Any], field: str, instead: str) -> tuple[str, str]:
    """What cannot be, and what is instead."""
    name = line["event"]
    of = f" of OB {line['ob']}" if line.get("ob") else ""
    given = _given(line, field)
    if field == "ret":
        return f"{name} cannot answer {given}", f" It answers {instead}."
    if field == "status":
        return f"{name} cannot give STATUS {given}", f" It gives {instead}."
    if field:
        return f"{name}{of} cannot have {field} {given}", f" It has {instead}."
    if name in OPERANDS:
        return f"{name} cannot be called", ""
    return f"{name}{of} cannot come", ""


def _given(line: dict[str, Any], field: str) -> str:
    """The value of a field of the line or of its ``info``, a word without its prefix; empty if it has none."""
    info = line.get("info")
    value = line.get(field, info.get(field) if isinstance(info, dict) else None)
    if isinstance(value, int) and field in ("ret", "status"):
        return f"16#{value & 0xFFFF:04X}"
    if isinstance(value, bool):
        return str(value).lower()
    return "" if value is None else re.sub(r"^[WB]#(?=16#)", "", str(value))


def _rule(name: str, about: str = "") -> str:
    """The sentence of a requirement that has a code of ``about``, or its first one."""
    sentences = [one.strip() for one in _SENTENCE.findall(clause(name).text)]
    codes = set(_CODE.findall(about))
    text = next((one for one in sentences if codes & set(_CODE.findall(one))), (sentences or [""])[0])
    return f"{text.removesuffix('.')} ({name})."


def _or(texts: Sequence[str]) -> str:
    if len(texts) > _MOST:
        return f"one of {len(texts)} values"
    return " or ".join([", ".join(texts[:-1]), texts[-1]] if len(texts) > 1 else texts)

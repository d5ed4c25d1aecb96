"""Why a line is not possible, in a sentence: what cannot be, the requirement, what may be instead.

The words of a rule are those of its requirement. WhyNot.java makes the same sentence for the page.
"""

import re
from collections.abc import Sequence
from typing import Any

import msgspec

from s7check.engine.answer import Allowed
from s7check.log.calls import OPERANDS
from s7check.report.clauses import clause, event_text
from s7check.report.expected import format_value, spelled_value

_SENTENCE = r"(?:[^.(]|\([^)]*\)|[.](?! |$))+[.]?"
_MOST = 6
_CODE = r"\b(?:16#)?([0-9A-F]{4})\b"
_NAMED_ID = r"\b(?:id|cause)=16#([0-9A-F]{4})\b"
_LINES = {
    "start": "OB {ob} cannot start",
    "end": "OB {ob} cannot end",
    "run": "The CPU cannot go to RUN",
    "stop": "The CPU cannot stop",
    "hold": "HOLD cannot begin",
    "release": "HOLD cannot end",
    "restart": "A {type} restart cannot begin",
    "interrupt": "A start event for OB {ob} cannot come",
    "clock": "The clock cannot be set",
    "load": "OB {ob} cannot be loaded",
    "delete": "OB {ob} cannot be deleted",
}


def why_not(event: bytes, late: Sequence[str], expected: Sequence[Allowed], requirements: Sequence[str]) -> str:
    """Such as ``SET_TINT cannot answer 16#0000 here. Monthly: the day of SDT is limited to 1 to 28 (TINT-18). It
    answers 16#8091.``

    ``event`` is the line, ``late`` are the texts of what had to come before it, of the ``requirements`` the first one
    decides most. Empty without requirements.
    """
    if not requirements:
        return ""
    if late:
        return f"Before this line has to come: {_or(list(map(_with_words, late)))}. {_rule(requirements[0])}"
    try:
        line = msgspec.json.decode(event, type=dict[str, Any])
    except msgspec.MsgspecError:
        return ""
    fields = [one for one in expected if one.event == line.get("event") and format_value(one)]
    # Of several wrong fields one is told; the others stand in what was expected.
    field = next((one.field for one in fields if _given(line, one.field)), "")
    instead = [format_value(one) for one in fields if one.field == field]
    claim, end = _claim(line, field, _or(instead))
    return f"{claim} here. {_rule(requirements[0], [*instead, _given(line, field)])}{end}"


def sentences(text: str) -> list[str]:
    """The sentences of a requirement's text."""
    return [one.strip() for one in re.findall(_SENTENCE, text)]


def _claim(line: dict[str, Any], field: str, instead: str) -> tuple[str, str]:
    """What cannot be, and what is instead."""
    name = line["event"]
    given = _given(line, field)
    if field == "ret":
        return f"{name} cannot answer {given}", f" It answers {instead}."
    if field == "status":
        return f"{name} cannot give STATUS {given}", f" It gives {instead}."
    if name in OPERANDS:
        return f"{name} cannot be called", ""
    if name == "diag":
        claim = f"The entry {_entry(_given(line, 'id'))}"
        return (
            (f"{claim} cannot have {field} {given}", f" It has {instead}.") if field else (f"{claim} cannot come", "")
        )
    if field:
        of = f" of OB {line['ob']}" if line.get("ob") else ""
        return f"{name}{of} cannot have {field} {given}", f" It has {instead}."
    claim = _LINES.get(name, f"{name} cannot come").format_map({"ob": "", "type": "", **line})
    return claim + (f" for {_entry(_given(line, 'cause'))}" if line.get("cause") else ""), ""


def _entry(number: str) -> str:
    """Such as ``16#4568 (STOP: OB 80 missing)``."""
    found = re.search(_CODE, number)
    text = event_text(int(found[1], 16)) if found else ""
    return f"{number} ({text})" if text else number


def _with_words(said: str) -> str:
    """What had to come, with the words of an event ID that it names."""
    return re.sub(_NAMED_ID, lambda named: named[0].replace(f"16#{named[1]}", _entry(f"16#{named[1]}")), said)


def _given(line: dict[str, Any], field: str) -> str:
    """The value of a field of the line or of its ``info`` as a report spells it; empty if it has none."""
    info = line.get("info")
    value = line.get(field, info.get(field) if isinstance(info, dict) else None)
    if isinstance(value, int):
        return spelled_value(field, value)
    return "" if value is None else re.sub(r"^[WB]#(?=16#)", "", str(value))


def _rule(name: str, about: Sequence[str] = ()) -> str:
    """The sentence of a requirement that has one of these codes, the first of them that any has; else its first one.

    0000 stands in many rules, also as a PERIOD: it counts last.
    """
    said = sentences(clause(name).text)
    codes = sorted((code for text in about for code in re.findall(_CODE, text)), key=lambda code: code == "0000")
    for code in codes:
        if found := next((one for one in said if code in re.findall(_CODE, one)), ""):
            return _cited(found, name)
    return _cited((said or [""])[0], name)


def _cited(text: str, name: str) -> str:
    return f"{text.removesuffix('.')} ({name})."


def _or(texts: Sequence[str]) -> str:
    if len(texts) > _MOST:
        return f"one of {len(texts)} values"
    return " or ".join([", ".join(texts[:-1]), texts[-1]] if len(texts) > 1 else texts)

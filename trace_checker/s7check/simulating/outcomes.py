"""Every outcome of a program in lines for people."""

from __future__ import annotations

from typing import Any

from s7check.asking.line_text import spelled


def as_text(part: dict[str, Any], indent: str = "") -> list[str]:
    """The tree, a line of the log each; a way is indented under the choice that leads to it."""
    text = [f"{indent}{line['at']} {spelled(line)}" for line in part["lines"]]
    if part["goes_on"] is not None:
        return [*text, f"{indent}goes on as at ({part['goes_on']})"]
    if part["ways"]:
        text.append(f"{indent}({part['number']}) one of {len(part['ways'])}:")
    for below in part["ways"]:
        text.append(f"{indent}  - {below['choice']}")
        text += as_text(below, indent + "    ")
    return text

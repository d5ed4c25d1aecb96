"""A program as text for people: a line for each field, event from outside and step."""

import json
from collections.abc import Iterable
from typing import Any


def to_text(program: dict[str, Any]) -> str:
    """The JSON object of a program, laid out; it ends with the end of a line."""
    fields = [f" {_one_line(name)}: {_field(name, value)}" for name, value in program.items()]
    return "{\n" + ",\n".join(fields) + "\n}\n"


def _field(name: str, value: Any) -> str:
    if name == "outside":
        return _list(map(_one_line, value), " ")
    if name == "bodies":
        return _list(map(_body, value), " ")
    return _one_line(value)


def _body(body: dict[str, Any]) -> str:
    fields = [
        f"{_one_line(name)}: {_list(map(_one_line, value), '  ') if name == 'steps' else _one_line(value)}"
        for name, value in body.items()
    ]
    return "{" + ", ".join(fields) + "}"


def _list(elements: Iterable[str], margin: str) -> str:
    lines = [f"{margin} {element}" for element in elements]
    return "[\n" + ",\n".join(lines) + "]" if lines else "[]"


def _one_line(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)

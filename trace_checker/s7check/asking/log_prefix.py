"""A log up to a line, for commands that go on from there."""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from s7check.engine.client import Engine
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.objects import decoded
from s7check.log.profile_file import ENDING, folder_of
from s7check.log.source import open_log

_NUMBERED = re.compile(r"(?P<log>.+):(?P<line>[0-9]{1,9})")


@dataclass
class Prefix:
    """The header and the events of a log as its lines have them, each event with the number of its line."""

    name: str
    header: dict[str, Any] = field(default_factory=dict)
    events: list[tuple[int, dict[str, Any]]] = field(default_factory=list)
    texts: list[bytes] = field(default_factory=list)


def read_prefix(engine: Engine, argument: str) -> Prefix:
    """The log that ``LOG`` or ``LOG:LINE`` names, whole or up to that line.

    Raises UnusableLogError for a line that cannot be read, and for a LINE that the log does not have.
    """
    return prefix_of(engine, *read_text(argument))


def read_text(argument: str) -> tuple[str, bytes, int | None]:
    """Name and text, in UTF-8, of the log that ``LOG`` or ``LOG:LINE`` names, and that line.

    Raises UnusableLogError for a file that cannot be read.
    """
    numbered = _NUMBERED.fullmatch(argument)
    if numbered is None or Path(argument).exists():
        name, last = argument, None
    else:
        name, last = numbered["log"], int(numbered["line"])
    with open_log(name) as source:
        return name, b"".join(as_utf8(source.chunks())), last


def lines_up_to(data: bytes, last: int | None) -> list[bytes]:
    """The lines of a log's text, all or up to the line ``last``. Raises UnusableLogError if there is no such line."""
    texts = data.removesuffix(b"\n").split(b"\n") if data else []
    if last is not None and not 1 <= last <= len(texts):
        raise UnusableLogError(f"a line 1 to {len(texts)}", str(last))
    return texts[:last]


def prefix_of(engine: Engine, name: str, data: bytes, last: int | None = None) -> Prefix:
    """The same for the text of a log with this name."""
    texts = lines_up_to(data, last)
    content = engine.read(b"\n".join(texts), folder_of(name))
    if content.unusable is not None:
        raise content.unusable.error()
    header, *events = ((number, decoded(text)) for number, text in enumerate(texts, 1) if text.strip())
    assert content.header is not None
    return Prefix(name, _with_letters(header[1], content.header), events, texts)


def _with_letters(header: dict[str, Any], read: dict[str, Any]) -> dict[str, Any]:
    """The header with the letters of the file that it names as its profile."""
    if not str(header.get("profile", "")).endswith(ENDING):
        return header
    rest = {field: value for field, value in header.items() if field != "profile"}
    return rest | {"readings": dict(read["readings"])}

"""A log up to a line, for commands that go on from there."""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from s7check.log.errors import UnusableLogError, quote
from s7check.log.jsonline import decode_object
from s7check.log.profile_file import folder_of, with_profile_file
from s7check.log.reader import read_log
from s7check.log.source import open_log

_NUMBERED = re.compile(r"(?P<log>.+):(?P<line>[0-9]{1,9})")


@dataclass
class Prefix:
    """The header and the events of a log as its lines have them, each event with the number of its line."""

    name: str
    header: dict[str, Any] = field(default_factory=dict)
    events: list[tuple[int, dict[str, Any]]] = field(default_factory=list)
    texts: list[bytes] = field(default_factory=list)


def read_prefix(argument: str) -> Prefix:
    """The log that ``LOG`` or ``LOG:LINE`` names, whole or up to that line.

    Raises UnusableLogError for a line that cannot be read, and for a LINE that the log does not have.
    """
    numbered = _NUMBERED.fullmatch(argument)
    if numbered is None or Path(argument).exists():
        name, last = argument, None
    else:
        name, last = numbered["log"], int(numbered["line"])
    prefix = Prefix(name)
    with open_log(name) as source:
        for batch in read_log(source.chunks(), folder_of(name)):
            of_events = {event["line"] for event in batch.events}
            for number, text in enumerate(batch.lines.texts, batch.lines.first):
                if last is not None and number > last:
                    return prefix
                prefix.texts.append(text)
                if number in of_events:
                    prefix.events.append((number, decode_object(text)))
                elif not prefix.header and batch.header is not None and text.strip():
                    prefix.header = with_profile_file(decode_object(text), folder_of(name))
    if last is not None and last > len(prefix.texts):
        raise UnusableLogError(f"a line 1 to {len(prefix.texts)}", quote(last))
    return prefix

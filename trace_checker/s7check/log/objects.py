"""The lines of a log file as objects."""

from collections.abc import Iterator
from typing import Any

from s7check.log.encoding import as_utf8
from s7check.log.jsonline import decode_object
from s7check.log.lines import split_lines
from s7check.log.source import open_log


def objects(name: str) -> Iterator[tuple[int, bytes, dict[str, Any]]]:
    """The number, the text and the object of each line that is not blank, the header first. Raises UnusableLogError."""
    with open_log(name) as source:
        for lines in split_lines(as_utf8(source.chunks())):
            for number, text in enumerate(lines.texts, lines.first):
                if text.strip():
                    yield number, text, decode_object(text)

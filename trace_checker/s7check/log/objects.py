"""The lines of a log as objects, without a look at their fields: the engine reads those."""

from collections.abc import Iterator
from typing import Any

import msgspec

from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError, printable
from s7check.log.source import open_log

_decode = msgspec.json.Decoder().decode


def decoded(text: bytes, line: int = 0) -> dict[str, Any]:
    """The object of a line. Raises UnusableLogError."""
    try:
        fields = _decode(text)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise UnusableLogError("a JSON object", printable(str(error)), line=line) from error
    if isinstance(fields, dict):
        return fields
    raise UnusableLogError("a JSON object", printable(text.decode()), line=line)


def objects(name: str) -> Iterator[tuple[int, bytes, dict[str, Any]]]:
    """The number, the text and the object of each line that is not blank, the header first. Raises UnusableLogError."""
    with open_log(name) as source:
        data = b"".join(as_utf8(source.chunks()))
    for number, text in enumerate(data.split(b"\n"), 1):
        if text.strip():
            yield number, text, decoded(text, number)

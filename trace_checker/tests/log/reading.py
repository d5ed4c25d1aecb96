"""What the engine reads: whole logs, headers, events, values."""

import json
from collections.abc import Iterable
from typing import Any

from s7check.engine import pool
from s7check.engine.answer import Content
from s7check.log.encoding import as_utf8
from tests.logs import HEADER

_EARLY = HEADER | {"clock": "1990-01-01T00:00"}


def content(*chunks: bytes) -> Content:
    """The content of a log. Raises UnusableLogError for an encoding that is none."""
    with pool.engine() as engine:
        return engine.read(b"".join(as_utf8(chunks)))


def events_of(chunks: Iterable[bytes]) -> list[dict[str, Any]]:
    """All events of a log that can be read."""
    read = content(*chunks)
    assert read.unusable is None
    return read.events


def read_header(raw: dict[str, Any]) -> dict[str, Any]:
    """The normalised header. Raises UnusableLogError."""
    read = content(json.dumps(raw).encode())
    if read.unusable is not None:
        raise read.unusable.error()
    assert read.header is not None
    return read.header


def read_event(raw: dict[str, Any]) -> dict[str, Any]:
    """The normalised event, with `up` and `counter` where the line has them. Raises UnusableLogError."""
    read = content(b"\n".join(map(str.encode, map(json.dumps, (_EARLY, raw)))))
    if read.unusable is not None:
        raise read.unusable.error()
    (event,) = read.events
    assert event.pop("line") == 2
    if "counter" not in event:
        del event["up"]
    return event


def read_value(event: str, field: str, value: object, **others: object) -> Any:
    """The normalised value of a field. Raises UnusableLogError."""
    line = {"at": "1990-01-01T00:00", **others, "event": event, field: value}
    return read_event(line)[field]

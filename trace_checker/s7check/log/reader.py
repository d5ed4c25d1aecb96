"""A log, from bytes to normalised events."""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from s7check.log.elapsed import Clocks
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.events import read_event
from s7check.log.header import read_header
from s7check.log.jsonline import decode_object
from s7check.log.lines import Lines, split_lines


class Batch(NamedTuple):
    """The content of a piece of the log: its lines, the header if it was among them, its events.

    Events have the field ``line``, the number of their physical line.
    """

    lines: Lines
    header: dict[str, Any] | None
    events: list[dict[str, Any]]


def read_log(chunks: Iterable[bytes]) -> Iterator[Batch]:
    """Yields the log in batches, each as soon as its lines are complete; memory stays constant.

    Raises UnusableLogError, with its line, after everything before that line has been yielded.
    """
    clocks: Clocks | None = None
    for lines in split_lines(as_utf8(chunks)):
        header: dict[str, Any] | None = None
        events: list[dict[str, Any]] = []
        number = lines.first
        try:
            for number, text in enumerate(lines.texts, lines.first):
                if not text.strip(b" \t\r"):
                    continue
                raw = decode_object(text)
                if clocks is None:
                    header = read_header(raw)
                    clocks = Clocks(header["clock"], "clock" in header["records"])
                else:
                    event = read_event(raw)
                    clocks.stamp(event)
                    event["line"] = number
                    events.append(event)
        except UnusableLogError as error:
            error.line = number
            yield Batch(lines, header, events)
            raise
        yield Batch(lines, header, events)
    if clocks is None:
        raise UnusableLogError("a header", "an empty log", line=1)

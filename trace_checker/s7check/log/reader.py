"""A log, from bytes to normalised events."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from s7check.log.elapsed import Clocks
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.events import read_event
from s7check.log.header import read_header
from s7check.log.jsonline import decode_object
from s7check.log.lines import Lines, split_lines
from s7check.log.profile_file import with_profile_file

HERE = Path()
"""The folder at work."""


class Batch(NamedTuple):
    """The content of a piece of the log: its lines, the header if it was among them, its events.

    Events have the field ``line``, the number of their physical line. ``error`` is that of a line that cannot be read;
    the events are those before it.
    """

    lines: Lines
    header: dict[str, Any] | None
    events: list[dict[str, Any]]
    error: UnusableLogError | None = None


class LogReader:
    """Reads the lines of one log in ``folder``; ``clocks`` are its clocks, none before the header."""

    def __init__(self, folder: Path = HERE) -> None:
        self._folder = folder
        self.clocks: Clocks | None = None

    def read(self, lines: Lines) -> Batch:
        """The content of the next lines."""
        header: dict[str, Any] | None = None
        events: list[dict[str, Any]] = []
        number = lines.first
        try:
            for number, text in enumerate(lines.texts, lines.first):
                if not text.strip(b" \t\r"):
                    continue
                if self.clocks is None:
                    header = read_header(with_profile_file(decode_object(text), self._folder))
                    self.clocks = Clocks(header["clock"], "clock" in header["records"])
                else:
                    events.append(read_line(number, text, self.clocks))
        except UnusableLogError as error:
            error.line = number
            return Batch(lines, header, events, error)
        return Batch(lines, header, events)

    def end(self) -> None:
        """Raises UnusableLogError if the log has no header."""
        if self.clocks is None:
            raise UnusableLogError("a header", "an empty log", line=1)


def read_line(number: int, text: bytes, clocks: Clocks) -> dict[str, Any]:
    """The event of the line ``number``, to which the clocks go on. Raises UnusableLogError, without the line."""
    event = read_event(decode_object(text))
    clocks.stamp(event)
    event["line"] = number
    return event


def read_log(chunks: Iterable[bytes], folder: Path = HERE) -> Iterator[Batch]:
    """Yields the log in ``folder`` in batches, each as soon as its lines are complete; memory stays constant.

    Raises UnusableLogError, with its line, after everything before that line has been yielded.
    """
    reader = LogReader(folder)
    for lines in split_lines(as_utf8(chunks)):
        batch = reader.read(lines)
        yield batch
        if batch.error is not None:
            raise batch.error
    reader.end()

"""CSV, one event a row, by a map from the log's fields to its columns."""

import csv
import io
import re
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from typing import Any

import msgspec

from s7check.importing.errors import SourceError, in_field, shown
from s7check.importing.recording import Placed, Recording, select

_TIMES = frozenset({"at", "to", "sdt", "info.time"})
"""Fields that hold a date and time."""

_EXAMPLE = datetime(2026, 11, 21, 6, 0, 30, 500_000)

_INTEGER = re.compile(r"-?[0-9]{1,20}")


class ColumnMap(msgspec.Struct, forbid_unknown_fields=True):
    """How the rows are read.

    ``columns``: field of the log (``info.period`` for one within ``info``) -> heading of its column;
    ``values``: field -> text of a cell -> value in the log, null where the row or the field is to
    be left out; ``others``: field -> value in the log for any other text; ``times``: how dates and
    times are written, as in Python's strptime.
    """

    columns: dict[str, str]
    values: dict[str, dict[str, str | int | None]] = {}
    others: dict[str, str | int | None] = {}
    times: str | None = None
    delimiter: str = ","
    encoding: str = "utf-8-sig"
    newest_first: bool = False


@dataclass(frozen=True)
class _Row:
    number: int
    cells: dict[str, str]

    @property
    def place(self) -> str:
        return f"line {self.number}"


def read_map(content: bytes) -> ColumnMap:
    """The column map of a JSON file."""
    try:
        columns = msgspec.json.decode(content, type=ColumnMap)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise SourceError(
            "column map", "a JSON object with columns, see docs/checking/import.md", str(error)
        ) from error
    for field in ("at", "event"):
        if field not in columns.columns:
            raise SourceError("column map", f'"{field}" among the columns', "none")
    if len(columns.delimiter) != 1:
        raise SourceError("column map", "a delimiter of one character", shown(columns.delimiter))
    return columns


def convert(content: bytes, columns: ColumnMap, chosen: range | None = None) -> Recording:
    """The events of the rows; a wrong value shows when the whole log is checked."""
    recording = Recording()
    rows = list(_rows(content, columns, recording))
    if columns.newest_first:
        rows.reverse()
    for row in select(rows, chosen, recording):
        event = _event(row, columns)
        if event["event"] is None:
            recording.skip("left out by the column map")
        else:
            recording.events.append(Placed(event, row.place))
    if recording.events:
        recording.header["clock"] = recording.events[0].event["at"]
    recording.header["records"] = []
    return recording


def _rows(content: bytes, columns: ColumnMap, recording: Recording) -> Iterator[_Row]:
    text = _text(content, columns.encoding)
    reader = csv.DictReader(io.StringIO(text, newline=""), delimiter=columns.delimiter, strict=True)
    try:
        headings = list(reader.fieldnames or [])
        missing = [heading for heading in columns.columns.values() if heading not in headings]
        if missing:
            raise SourceError("line 1", f"the heading {shown(missing[0])}", shown(columns.delimiter.join(headings)))
        unused = [heading for heading in headings if heading not in columns.columns.values()]
        if unused:
            recording.remarks.append("columns not used: " + ", ".join(shown(heading) for heading in unused))
        for row in reader:
            if None in row or None in row.values():
                raise SourceError(f"line {reader.line_num}", f"{len(headings)} cells", "another number of them")
            yield _Row(reader.line_num, {field: row[heading].strip() for field, heading in columns.columns.items()})
    except csv.Error as error:
        raise SourceError(f"line {reader.reader.line_num}", "CSV", str(error)) from error


def _text(content: bytes, encoding: str) -> str:
    try:
        return content.decode(encoding)
    except LookupError as error:
        raise SourceError(
            "column map", 'in "encoding" the name of one, such as "utf-8", "cp1252" or "utf-16"', shown(encoding)
        ) from error
    except UnicodeError as error:
        line = content[: error.start].count(b"\n") + 1 if isinstance(error, UnicodeDecodeError) else 1
        raise SourceError(
            f"line {line}",
            f'text in {encoding.removesuffix("-sig")}; the "encoding" of the column map names another one, such as '
            '"cp1252" for a file of Windows',
            f"{error.reason} (byte 16#{content[error.start]:02X})"
            if isinstance(error, UnicodeDecodeError)
            else str(error),
        ) from error


def _event(row: _Row, columns: ColumnMap) -> dict[str, Any]:
    event: dict[str, Any] = {"event": None, "at": None}
    for field, cell in row.cells.items():
        value = _value(row, field, cell, columns)
        if value is None:
            continue
        outer, _, inner = field.partition(".")
        if inner:
            event.setdefault(outer, {})[inner] = value
        else:
            event[outer] = value
    return event


def _value(row: _Row, field: str, cell: str, columns: ColumnMap) -> str | int | None:
    """What the log says for a cell; an empty one says nothing."""
    known = columns.values.get(field, {})
    if cell in known:
        return known[cell]
    if not cell:
        return None
    if field in columns.others:
        return columns.others[field]
    if field in _TIMES and columns.times is not None:
        try:
            return datetime.strptime(cell, columns.times).isoformat(timespec="milliseconds")
        except ValueError as error:
            example = f'a time like {shown(_EXAMPLE.strftime(columns.times))} ("times": {shown(columns.times)})'
            raise SourceError(in_field(row.place, field), example, shown(cell)) from error
    return int(cell) if _INTEGER.fullmatch(cell) else cell

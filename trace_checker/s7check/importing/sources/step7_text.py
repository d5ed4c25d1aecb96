"""The diagnostic buffer as STEP 7 V5 saves it as text (Module Information, Diagnostic Buffer, Save As).

What counts is the same in every language: the line that begins an entry, the event ID in it or in a line of its own,
as TIA Portal shows it, the coding in parentheses, the line that ends with time and date. The descriptions between
them are not read.
"""

import codecs
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from datetime import datetime

from s7check.importing.errors import SourceError, shown
from s7check.importing.sources.entry import Buffer, Entry

_EVENT = r"(?:Event|Ereignis|.v.nement|Evento)"
_BEGIN = re.compile(
    rf"\s*(?:Details (?:on|zum) |D.tails de l')?{_EVENT}(?: ?details)?\s?:?"
    r"\s+(\d{1,9})\s+(?:of|von|sur|de|di)\s+\d+\b(.*)",
    re.IGNORECASE,
)
_EVENT_ID = re.compile(
    rf"\s*:?\s*(?:{_EVENT}[ -]ID|ID (?:d'|de |di )?{_EVENT})\s?:?\s*16#\s*([0-9A-F]{{4}})\s*", re.IGNORECASE
)
_CODING_BEGINS = re.compile(r"\s*\([CK]od\w+\s?:", re.IGNORECASE)
_CODING = re.compile(_CODING_BEGINS.pattern + r"\s*16#\s*((?:[0-9A-F]{4}\s*){6})\)\s*", re.IGNORECASE)
_BYTE = {
    "OB": re.compile(r"\s*OB\s?:\s*16#\s*([0-9A-F]{2})\s*", re.IGNORECASE),
    "PK": re.compile(r"\s*P[KC]\s?:\s*16#\s*([0-9A-F]{2})\s*", re.IGNORECASE),
    "DatID": re.compile(r"\s*DatID\s*1\s*/\s*2\s?:\s*16#\s*((?:[0-9A-F]{2}\s*){2})", re.IGNORECASE),
    "info": re.compile(
        r"\s*(?:Supplementary info|Zusatzinfo|Info\.? suppl\w*\.?)\s*1\s*/\s*2\s*/\s*3\s?:"
        r"\s*16#\s*((?:[0-9A-F]{4}\s*){3})",
        re.IGNORECASE,
    ),
}
"""What stands in place of the coding in an entry that STEP 7 has no text for."""

_TIME = re.compile(
    r".*?\b(\d{1,2}):(\d{2}):(\d{2})[.:,](\d{3})\s*([AP]M)?\s+(\d{1,4})([./-])(\d{1,2})\7(\d{1,4})\s*", re.IGNORECASE
)

_AN_ID = 'an event ID such as "Event ID 16# 4302"'

DATE_ORDERS = ("DMY", "MDY", "YMD")


@dataclass
class _Block:
    """The lines of one entry, by their kinds of fact."""

    number: int
    place: str
    id: int | None
    coding: bytes | None = None
    parts: dict[str, bytes] = field(default_factory=dict)
    time: re.Match[str] | None = None


def has_entry(content: bytes) -> bool:
    """Whether an entry begins in the text."""
    return any(_BEGIN.fullmatch(line) for line in _decode(content).splitlines())


def read(content: bytes, date_order: str | None = None) -> Buffer:
    """The buffer of a text.

    ``date_order`` is one of DATE_ORDERS; without it the dates themselves have to tell it.
    """
    blocks = list(_blocks(_decode(content)))
    if not blocks:
        expected = 'entries such as "Event 1 of 100: Event ID 16# 4302" or "Ereignis 1 von 100: Ereignis-ID 16# 4302"'
        raise SourceError("", expected, "none")
    order = date_order or _date_order(blocks)
    return Buffer([Entry(block.number, block.place, _id(block), _at(block, order), _coding(block)) for block in blocks])


def _decode(content: bytes) -> str:
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return content.decode("utf-16", "replace")
    content = content.removeprefix(codecs.BOM_UTF8)
    try:
        # A text from a forum has no-break spaces, of several bytes in UTF-8. The last letter may be cut off.
        return codecs.getincrementaldecoder("utf-8")().decode(content)
    except UnicodeDecodeError:
        # Any Windows code page: all else that is read is ASCII.
        return content.decode("latin-1")


def _blocks(text: str) -> Iterator[_Block]:
    block: _Block | None = None
    for line_number, line in enumerate(text.splitlines(), 1):
        begin = _BEGIN.fullmatch(line)
        if begin:
            if block:
                yield block
            block = _begin(begin, line_number)
        elif block:
            _add(block, line)
    if block:
        yield block


def _begin(begin: re.Match[str], line_number: int) -> _Block:
    number = int(begin[1])
    place = f"entry {number} (line {line_number})"
    event_id = _EVENT_ID.fullmatch(begin[2])
    if not event_id and begin[2].strip(" :"):
        raise SourceError(place, _AN_ID, shown(begin[0].strip()))
    return _Block(number, place, int(event_id[1], 16) if event_id else None)


def _id(block: _Block) -> int:
    if block.id is None:
        raise SourceError(block.place, _AN_ID, "none")
    return block.id


def _add(block: _Block, line: str) -> None:
    if block.id is None and (event_id := _EVENT_ID.fullmatch(line)):
        block.id = int(event_id[1], 16)
    elif _CODING_BEGINS.match(line):
        match = _CODING.fullmatch(line)
        if not match:
            raise SourceError(block.place, "a coding of six words", shown(line.strip()))
        block.coding = bytes.fromhex(match[1])
    elif match := _TIME.fullmatch(line):
        block.time = match
    else:
        for name, pattern in _BYTE.items():
            if match := pattern.fullmatch(line):
                block.parts[name] = bytes.fromhex(match[1])


def _coding(block: _Block) -> bytes | None:
    coding = block.coding
    if coding is None and block.parts.keys() == _BYTE.keys():
        parts = block.parts
        coding = _id(block).to_bytes(2) + parts["PK"] + parts["OB"] + parts["DatID"] + parts["info"]
    if coding is None:
        return None
    if int.from_bytes(coding[:2]) != block.id:
        expected = f"a coding that begins with the event ID 16# {_id(block):04X}"
        raise SourceError(block.place, expected, f"16# {coding[:2].hex().upper()}")
    return coding


def _at(block: _Block, order: str) -> str:
    time = block.time
    if time is None:
        raise SourceError(block.place, 'a line that ends like "05:36:29.972 PM 03/18/2012"', "none")
    hour, minute, second, milliseconds = (int(time[group]) for group in range(1, 5))
    half = (time[5] or "").upper()
    try:
        if half and hour <= 12:
            # 12 AM is midnight, 12 PM is noon.
            hour = hour % 12 + (12 if half == "PM" else 0)
        elif half:
            raise ValueError(hour)
        year, month, day = _date(time, order)
        exact = datetime(year, month, day, hour, minute, second, milliseconds * 1000)
    except ValueError as error:
        expected = f"a time and a date ({order})"
        raise SourceError(block.place, expected, shown(time[0].strip())) from error
    return exact.isoformat(timespec="milliseconds")


def _date(time: re.Match[str], order: str) -> tuple[int, int, int]:
    parts = dict(zip(order, (time[6], time[8], time[9]), strict=True))
    year = int(parts["Y"])
    if len(parts["Y"]) == 2:
        # As in DATE_AND_TIME.
        year += 1900 if year >= 90 else 2000
    return year, int(parts["M"]), int(parts["D"])


def _date_order(blocks: Sequence[_Block]) -> str:
    """The one order in which all dates can be read."""
    times = [block.time for block in blocks if block.time]
    if all(len(time[6]) == 4 for time in times):
        return "YMD"
    if all(time[7] == "." for time in times):
        return "DMY"
    possible = [order for order in ("DMY", "MDY") if all(_possible(time, order) for time in times)]
    if len(possible) == 1:
        return possible[0]
    found = "several ways to read them" if possible else "no order that fits all of them"
    expected = f"dates that tell the order of day and month, unlike {shown(times[0][0].strip())}"
    raise SourceError("", expected, f"{found}; name it with --dates")


def _possible(time: re.Match[str], order: str) -> bool:
    _, month, day = _date(time, order)
    return 1 <= month <= 12 and 1 <= day <= 31

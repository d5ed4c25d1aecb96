"""Records of SZL 16#xxA0, the diagnostic buffer as the CPU gives it."""

from collections.abc import Sequence

from s7check.importing.errors import SourceError
from s7check.importing.sources.entry import LENGTH, Buffer, from_record
from s7check.importing.sources.hex_text import decode

_IDENTIFIED = 8
"""Bytes of the header before the records: SZL-ID, index, length of a record, number of records."""

_COUNTED = 4
"""Those without SZL-ID and index."""

_TRANSPORTED = 12
"""Those with the four bytes before them in an answer on the network: return code, transport size, length."""

_ANSWERED, _OCTETS = 0xFF, 0x09
"""Return code and transport size of an answer with data."""

_LIST = 0xA0
"""The list's number, the lower byte of the SZL-ID."""


def has_record(raw: bytes) -> bool:
    """Whether the bytes begin with a record that has an entry, with or without a header before it."""
    return any(_is_entry(raw[header : header + LENGTH]) for header in (0, _COUNTED, _IDENTIFIED, _TRANSPORTED))


def _is_entry(record: bytes) -> bool:
    try:
        from_record(1, record)
    except SourceError:
        return False
    return True


def read(content: bytes) -> Buffer:
    """The buffer of records in binary or as hexadecimal digits; the header of list or answer may come first."""
    records = _records(decode(content))
    # A slot that was never written holds zeros.
    entries = [from_record(number, record) for number, record in enumerate(records, 1) if any(record)]
    return Buffer(entries, len(records) - len(entries))


def _records(raw: bytes) -> Sequence[bytes]:
    header = len(raw) % LENGTH
    transport = _TRANSPORTED - _IDENTIFIED
    if header == _TRANSPORTED and raw[:2] == bytes((_ANSWERED, _OCTETS)):
        announced, present = int.from_bytes(raw[2:transport]), len(raw) - transport
        if announced != present:
            raise SourceError("transport", f"a length of {present} bytes, as many as follow", f"{announced}")
        return _records(raw[transport:])
    if header == _IDENTIFIED and int.from_bytes(raw[:2]) & 0xFF == _LIST:
        _check_counts(raw[_COUNTED:_IDENTIFIED], len(raw) // LENGTH)
    elif header == _COUNTED and int.from_bytes(raw[:2]) == LENGTH:
        _check_counts(raw[:_COUNTED], len(raw) // LENGTH)
    elif header:
        raise SourceError("", f"records of {LENGTH} bytes of SZL 16#00A0", f"{len(raw)} bytes")
    return [raw[at : at + LENGTH] for at in range(header, len(raw), LENGTH)]


def _check_counts(counts: bytes, present: int) -> None:
    length, number = int.from_bytes(counts[:2]), int.from_bytes(counts[2:])
    if length != LENGTH:
        raise SourceError("header", f"records of {LENGTH} bytes", f"records of {length}")
    if number != present:
        raise SourceError("header", f"{present} records, as many as follow", f"a count of {number}")

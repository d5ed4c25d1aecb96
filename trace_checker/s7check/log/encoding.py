"""The encodings of a log: UTF-8, or the encoding that a byte order mark names."""

import codecs
from collections.abc import Iterable, Iterator
from itertools import chain

from s7check.log.errors import UnusableLogError

_UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_MARKS = (codecs.BOM_UTF8, *_UTF_16)


def as_utf8(chunks: Iterable[bytes]) -> Iterator[bytes]:
    """The log in UTF-8 without a byte order mark, chunk by chunk.

    Raises UnusableLogError, without a line, if UTF-16 breaks off. The bytes of UTF-8 are not looked at.
    """
    rest = iter(chunks)
    begin = b""
    for chunk in rest:
        begin += chunk
        if begin and not any(mark.startswith(begin) and mark != begin for mark in _MARKS):
            break
    if begin.startswith(_UTF_16):
        yield from _from_utf16(begin, rest)
    else:
        yield begin.removeprefix(codecs.BOM_UTF8)
        yield from rest


def _from_utf16(begin: bytes, rest: Iterator[bytes]) -> Iterator[bytes]:
    # Lone surrogates pass: the reader of the line refuses them, and knows its number.
    decoder = codecs.getincrementaldecoder("utf-16")("surrogatepass")
    for chunk in chain([begin], rest):
        yield decoder.decode(chunk).encode("utf-8", "surrogatepass")
    try:
        decoder.decode(b"", final=True)
    except UnicodeDecodeError as error:
        raise UnusableLogError("UTF-16", "half a character at its end") from error

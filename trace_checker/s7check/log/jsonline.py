"""One line to one JSON object: UTF-8, no NaN, no lone surrogate, no key twice."""

import json
import re

import msgspec

from s7check.log.errors import UnusableLogError, printable, quote

_decode = msgspec.json.Decoder().decode
_position = re.compile(r" \(byte ([0-9]+)\)$").search
_key_like = re.compile(rb'"[ \t\r\n]*:').findall

_SURROGATE = b"\xed\xa0"
"""The first bytes of D800 to DFFF, the halves of UTF-16, in the pattern of UTF-8, which forbids them."""

_whole_escaped = re.compile(rb"\\\\|\\ud[89ab][0-9a-f]{2}\\ud[c-f][0-9a-f]{2}", re.IGNORECASE)
_half_escaped = re.compile(rb"\\ud[89a-f][0-9a-f]{2}", re.IGNORECASE).search

_LONE = ("whole characters", "a lone surrogate")

_EXCERPT = 30


def decode_object(line: bytes) -> dict[str, object]:
    """The JSON object of ``line``; raises UnusableLogError, without its line, for anything else."""
    try:
        decoded = _decode(line)
    except UnicodeDecodeError as error:
        wrong = error.object[error.start :]
        if wrong[0] == _SURROGATE[0] and wrong[1:2] >= _SURROGATE[1:]:
            raise UnusableLogError(*_LONE) from error
        raise UnusableLogError("UTF-8", f"the byte 16#{wrong[0]:02X}") from error
    except RecursionError as error:
        raise UnusableLogError("a JSON object", "too many levels of nesting") from error
    except msgspec.MsgspecError as error:
        if _half_escaped(_whole_escaped.sub(b"", line)):
            raise UnusableLogError(*_LONE) from error
        raise UnusableLogError("a JSON object", _shown(line, error)) from error
    if type(decoded) is not dict:
        raise UnusableLogError("a JSON object", quote(decoded))
    _refuse_duplicates(line, decoded)
    return decoded


def _shown(line: bytes, error: msgspec.MsgspecError) -> str:
    if line.startswith(b"\xef\xbb\xbf"):
        return "a byte order mark"
    reason = str(error).removeprefix("JSON is malformed: ").removesuffix(" - at `$[...]`")
    if reason == "Input data was truncated":
        return f"a line cut off after {_excerpt(line[-_EXCERPT:])}"
    match = _position(reason)
    if match is None:
        return printable(reason[:1].lower() + reason[1:])
    position = int(match[1])
    return f"{_excerpt(line[position : position + _EXCERPT])} at byte {position + 1} ({reason[: match.start()]})"


def _excerpt(text: bytes) -> str:
    return printable(text.decode(errors="replace").strip())


def _refuse_duplicates(line: bytes, decoded: dict[str, object]) -> None:
    # Every key, a second one too, is followed by a quote and a colon in the text; a text with no
    # more of them than there are keys after decoding has no key twice. Strings may hold more.
    keys = len(decoded)
    for value in decoded.values():
        if type(value) is dict:
            keys += len(value)
    if len(_key_like(line)) != keys:
        try:
            # Numbers stay text: only the keys matter, and a long number would cost much.
            json.loads(line, object_pairs_hook=_unique, parse_int=str, parse_float=str)
        except RecursionError as error:
            raise UnusableLogError("a JSON object", "too many levels of nesting") from error


def _unique(pairs: list[tuple[str, object]]) -> None:
    seen = set()
    for key, _ in pairs:
        if key in seen:
            raise UnusableLogError("each key once in an object", "it twice", field=printable(key))
        seen.add(key)

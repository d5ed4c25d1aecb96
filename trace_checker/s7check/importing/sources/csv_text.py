"""The text of a CSV file, in the encoding that its column map names."""

import msgspec

from s7check.importing.errors import SourceError, shown


class _Map(msgspec.Struct):
    encoding: str = "utf-8-sig"


def in_utf8(content: bytes, columns: bytes) -> bytes:
    """The text in UTF-8. Of a map that is none the engine says what is wrong, whatever the text."""
    try:
        encoding = msgspec.json.decode(columns, type=_Map).encoding
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return b""
    try:
        return content.decode(encoding).encode()
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

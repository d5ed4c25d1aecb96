"""A profile that a header names by its file: the letters of a CPU, as ``s7check decide --output`` writes them."""

from pathlib import Path

import msgspec

from s7check.log.errors import printable

ENDING = ".json"
HERE = Path()
"""The folder at work."""

_LONGEST = 1024 * 1024
"""Bytes; no header is longer."""


class _Header(msgspec.Struct):
    profile: str = ""


_header = msgspec.json.Decoder(_Header).decode


def folder_of(name: str) -> Path:
    """The folder of the log ``name``, where its header's profile is looked for; that at work for ``-``."""
    return HERE if name == "-" else Path(name).parent


def header_line(head: bytes) -> bytes | None:
    """The line of the header in the begin of a log; None if it is not whole yet."""
    text = head.lstrip()
    line, end, _ = text.partition(b"\n")
    return line if end or len(text) > _LONGEST else None


def profile_file(header: bytes, folder: Path) -> dict[str, str] | None:
    """The file that a header names as its profile, for the engine, which reads no files; None if it names none.

    ``text`` has the bytes of the file as characters, or it is said why it is ``missing``.
    """
    try:
        name = _header(header).profile
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
        return None  # the engine says what is wrong with it
    if not name.endswith(ENDING) or "/" in name or "\\" in name:
        return None
    try:
        return {"text": (folder / name).read_bytes().decode("latin-1")}
    except (OSError, ValueError) as error:
        return {"missing": error.strerror if isinstance(error, OSError) and error.strerror else printable(str(error))}

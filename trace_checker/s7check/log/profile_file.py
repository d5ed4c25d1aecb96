"""A profile that a header names by its file: the letters of a CPU, as ``s7check decide --output`` writes them."""

from pathlib import Path
from typing import Any

from s7check.log.errors import UnusableLogError, printable, quote
from s7check.log.jsonline import decode_object

ENDING = ".json"
_FIELD = "profile"


def folder_of(name: str) -> Path:
    """The folder of the log ``name``, where its header's profile is looked for; that at work for ``-``."""
    return Path() if name == "-" else Path(name).parent


def with_profile_file(header: dict[str, Any], folder: Path) -> dict[str, Any]:
    """The object of a header whose ``profile`` is a file beside the log: its letters come behind those of ``readings``.

    Any other header stays as it is. Raises UnusableLogError, without the line, for a file that cannot be used.
    """
    name = header.get(_FIELD)
    own = header.get("readings", {})
    if not isinstance(name, str) or not name.endswith(ENDING) or not isinstance(own, dict):
        return header
    rest = {field: value for field, value in header.items() if field != _FIELD}
    return rest | {"readings": {**_letters(name, folder), **own}}


def _letters(name: str, folder: Path) -> dict[str, object]:
    if "/" in name or "\\" in name:
        raise UnusableLogError("an edition, or a file in the folder of the log", quote(name), field=_FIELD)
    try:
        return decode_object((folder / name).read_bytes())
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else printable(str(error))
        raise UnusableLogError("the file of a profile beside the log", f"{quote(name)}: {reason}", _FIELD) from error
    except UnusableLogError as error:
        error.inside(_FIELD)
        raise

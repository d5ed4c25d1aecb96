"""The files of the kit: the programs that the generators make, and the data that runs found, with their origin.

What took a run of TLC or of the soft PLC is kept in ``kit/``. The first lines of such a file have the hash of what it
was made from, so that data older than their origin are noticed.
"""

from __future__ import annotations

import gzip
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

PATHS = Path("kit/paths.ndjson.gz")
"""The programs of paths through the graphs of models, in a checkout; packed, since nobody reads 1,400 such lines."""

REACHED = Path("kit/reached.ndjson")
"""The requirements and the outcomes of guards that programs reach, in a checkout."""

Json = dict[str, Any]


def as_line(value: Json) -> str:
    """An object as a line of its file, without the end of the line."""
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def read_lines(file: Path) -> list[Json]:
    """The objects of a file. Raises OSError, ValueError."""
    return [json.loads(line) for line in read_text(file).splitlines()]


def read_text(file: Path) -> str:
    """The text of a file, which may be packed. Raises OSError, ValueError."""
    data = file.read_bytes()
    return (gzip.decompress(data) if file.suffix == ".gz" else data).decode("utf-8")


def write_lines(file: Path, lines: Iterable[Json]) -> None:
    """Write a file, an object a line; packed where its name ends so. Raises OSError."""
    data = "".join(f"{as_line(line)}\n" for line in lines).encode("utf-8")
    file.write_bytes(gzip.compress(data, mtime=0) if file.suffix == ".gz" else data)

"""What the explorer can open: the gallery, the kit, the log of the command line, in a checkout the cases of traces/."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec

from s7check.kit.program import Program, read_program
from s7check.log.errors import UnusableLogError
from s7check.log.objects import decoded
from s7check.resources import CHECKOUT, GALLERY, INSTALLED, KIT

_NAME = re.compile(rb'"name": ?"([^"]+)"')
_OF_KIT = "kit/"

CASES = CHECKOUT / "build" / "traces"
"""Where a checkout has the logs of its cases, once they are written out."""


class Library:
    """Logs by the names that ``contents`` gives, so no path comes from the page."""

    def __init__(self, first: str | None = None, cases: Path = CASES) -> None:
        self._gallery = _gallery()
        self._first = first
        self._paths: dict[str, Path] = {}
        self._programs = {
            _OF_KIT + found[1].decode(): line
            for path in sorted(KIT.glob("*.ndjson"))
            for line in path.read_bytes().splitlines()
            if (found := _NAME.search(line)) is not None
        }
        if not INSTALLED:
            self._paths |= {
                str(path.relative_to(cases).with_suffix("")): path for path in sorted(cases.rglob("*.ndjson"))
            }

    def contents(self) -> dict[str, Any]:
        """The gallery's cases, the names of logs and of the kit's programs; ``first`` is the log to begin with."""
        return {"gallery": self._gallery, "logs": [*self._paths, *self._programs], "first": self._opened_first()}

    def program(self, name: str) -> Program | None:
        """The program of the kit with this name of ``contents``; None if it is the name of a log."""
        line = self._programs.get(name)
        return None if line is None else read_program(line)

    def open(self, name: str) -> dict[str, Any]:
        """The objects of a log's lines: ``header``, ``lines``. Raises UnusableLogError for no such log."""
        if any(case["name"] == name for case in self._gallery):
            return read((GALLERY / f"{name}.ndjson").read_bytes(), name)
        if name not in self._paths:
            raise UnusableLogError("the name of a log that the explorer offers", name)
        return read(self._paths[name].read_bytes(), name)

    def _opened_first(self) -> dict[str, Any] | None:
        if self._first is None:
            return None
        path, _, line = self._first.rpartition(":")
        whole = not path or not line.isdecimal() or Path(self._first).exists()
        name = self._first if whole else path
        return read(Path(name).read_bytes(), Path(name).name) | ({} if whole else {"line": int(line)})


def read(data: bytes, name: str) -> dict[str, Any]:
    """The objects of the lines of a log. Raises UnusableLogError, with the line."""
    objects: list[dict[str, Any]] = []
    for number, text in enumerate(data.removeprefix(b"\xef\xbb\xbf").splitlines(), 1):
        if text.strip():
            objects.append(decoded(text, number))
    if not objects:
        raise UnusableLogError("a header", "an empty file", line=1)
    return {"name": name, "header": objects[0], "lines": objects[1:]}


def _gallery() -> Sequence[dict[str, Any]]:
    """What is shown of each edge case."""
    shown = ("name", "title", "told", "requirements")
    cases: list[dict[str, Any]] = msgspec.json.decode((GALLERY / "cases.json").read_bytes())
    return [{name: case[name] for name in shown} for case in cases]

"""The logs that the explorer can open: the gallery, those of the command line, and in a checkout the shipped ones."""

from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import Any

import msgspec

from s7check.log.errors import UnusableLogError
from s7check.log.jsonline import decode_object
from s7check.resources import CHECKOUT, INSTALLED


class Library:
    """Logs by the names that ``contents`` gives, so no path comes from the page."""

    def __init__(self, first: str | None = None) -> None:
        self._gallery = _gallery()
        self._first = first
        self._paths: dict[str, Path] = {}
        traces = CHECKOUT / "traces"
        if not INSTALLED and traces.is_dir():
            self._paths |= {
                str(path.relative_to(traces).with_suffix("")): path for path in sorted(traces.rglob("*.ndjson"))
            }

    def contents(self) -> dict[str, Any]:
        """The gallery's cases and the names of the logs; ``first`` is the log to begin with."""
        cases = [{name: case[name] for name in ("name", "title", "told", "requirements")} for case in self._gallery]
        return {"gallery": cases, "logs": list(self._paths), "first": self._opened_first()}

    def open(self, name: str) -> dict[str, Any]:
        """The objects of a log's lines: ``header``, ``lines``. Raises UnusableLogError for no such log."""
        for case in self._gallery:
            if case["name"] == name:
                return {"name": name, "header": case["log"][0], "lines": case["log"][1:]}
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
            try:
                objects.append(decode_object(text))
            except UnusableLogError as error:
                error.line = number
                raise
    if not objects:
        raise UnusableLogError("a header", "an empty file", line=1)
    return {"name": name, "header": objects[0], "lines": objects[1:]}


def _gallery() -> Sequence[dict[str, Any]]:
    cases: list[dict[str, Any]] = msgspec.json.decode((files(__package__) / "gallery.json").read_bytes())
    return cases

"""Reports of runs, kept in docs/project/results/: from these the page can be written without a run."""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import msgspec

from evidence.common.checkout import ROOT
from s7check.engine.java import find_java

Cell = str | int | float | None

_OWN = (".", ":!docs")
"""The files that decide the numbers: all but the documents."""


class Table(msgspec.Struct, frozen=True):
    """Numbers under their headings; a title where a run has several tables."""

    columns: list[str]
    rows: list[list[Cell]]
    title: str = ""


class Record(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """The outcome of a run and its circumstances.

    `load` is that of the machine when the run began. It, `seconds` and `exit` are None where they are not known.
    `texts` is the hash of what the numbers depend on, `release` the version that was worked on.
    """

    command: str
    date: str
    revision: str
    release: str
    texts: str
    tools: list[str]
    machine: str
    load: float | None
    seconds: float | None
    exit: int | None
    tables: list[Table]
    remarks: list[str] = []


class RecordError(Exception):
    """A kept report that cannot be read; the text names the file."""


def read(folder: Path) -> dict[str, Record]:
    """All kept reports, by the name of their run. Raises `RecordError`."""
    found = {}
    for file in sorted(folder.glob("*.json")):
        try:
            found[file.stem] = msgspec.json.decode(file.read_bytes(), type=Record)
        except (OSError, msgspec.MsgspecError) as error:
            raise RecordError(f"{file}: {error}") from error
    return found


def write(folder: Path, name: str, record: Record) -> None:
    """Keep a report. Raises OSError."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.json").write_text(as_text(record), encoding="utf-8")


def as_text(record: Record) -> str:
    """A report as JSON with a line for each field, and for each row of a table."""
    fields = msgspec.to_builtins(record)
    tables = ",\n".join(_table(table) for table in fields.pop("tables"))
    lines = [f" {_json(name)}: {_json(value)}" for name, value in fields.items()]
    return "{\n" + ",\n".join([*lines, f' "tables": [\n{tables}\n ]']) + "\n}\n"


def _table(table: dict[str, Any]) -> str:
    rows = ",\n".join(f"    {_json(row)}" for row in table["rows"])
    return f'  {{"title": {_json(table["title"])}, "columns": {_json(table["columns"])}, "rows": [\n{rows}]}}'


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


def day(moment: float) -> str:
    """The day of a moment, which is in seconds since 1970."""
    return datetime.fromtimestamp(moment, UTC).date().isoformat()


def revision() -> str:
    """The commit of the checkout, with ``+`` where files differ from it, but for the documents."""
    return _git("rev-parse", "--short=7", "HEAD") + ("+" if _changed() else "")


def changed_at() -> float:
    """When the checkout changed last, documents aside, in seconds since 1970: by a commit, or a file that differs."""
    files = [ROOT / name for name in _changed()]
    committed = float(_git("log", "-1", "--format=%ct", "--", *_OWN))
    return max([committed, *(file.stat().st_mtime for file in files if file.exists())])


def _changed() -> list[str]:
    return _git("diff", "--name-only", "HEAD", "--", *_OWN).splitlines()


def _git(*arguments: str) -> str:
    run = subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=True)  # noqa: S607
    return run.stdout.strip()


def tools() -> list[str]:
    """Java and Python. Raises `s7check.engine.java.JavaMissingError`."""
    said = subprocess.run([find_java(), "-version"], capture_output=True, text=True, check=True).stderr
    version = re.search(r'"([^"]+)"', said)
    return [f"Java {version[1] if version else said}", f"Python {platform.python_version()}"]


def machine() -> str:
    """Processor, cores and memory."""
    names = re.findall(r"^model name\s*: (.*)$", Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.MULTILINE)
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 1024**3
    return f"{[*names, platform.machine()][0]}, {len(os.sched_getaffinity(0))} cores, {memory:.0f} GB"

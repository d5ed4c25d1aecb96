"""Asking a query: its module and configuration, the run, and the result that is kept for the next time."""

from __future__ import annotations

import hashlib
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

import msgspec

from evidence.common.processes import Processes
from evidence.proofs import apalache
from evidence.proofs.apalache import Answer
from evidence.proofs.queries import ManifestError, Query
from evidence.proofs.text import definitions, module_text

AFTER_A_STEP = "--tuning-options=search.invariantFilter=1->.*"
"""Formulas about states are checked after the step, not before, where they are assumed."""

_REPLACED = re.compile(r"^ +(\w+) *<- *(\w+)$", re.MULTILINE)


class Result(msgspec.Struct, frozen=True):
    """What came of a query: `key` is the hash of all that Apalache read; `megabytes` the most memory it had."""

    query: str
    key: str
    answer: Answer
    seconds: float
    megabytes: int
    version: str
    kept: bool = False


@dataclass(frozen=True)
class Asking:
    """Where queries are asked: the checkout, the folder for what is written, the program."""

    root: Path
    build: Path
    program: str
    processes: Processes


def ok(query: Query, result: Result) -> bool:
    """Whether the result is the expected one."""
    return result.answer.outcome == query.expect


def ask(asking: Asking, query: Query, *, resume: bool) -> Result:
    """Ask a query, or, with `resume`, take the result that is kept of the same text.

    Raises `ManifestError`, OSError, `evidence.common.processes.InterruptedRunError`.
    """
    folder = asking.build / query.name
    kept = asking.build / f"{query.name}.json"
    text, config = write_texts(asking.root, query, folder)
    arguments = [
        *("--config=query.cfg", f"--length={query.length}", "--no-deadlock=true"),
        f"--inv={','.join(query.formulas)}",
        *([f"--cinit={query.constants}"] if query.constants else []),
        *([AFTER_A_STEP] if query.kind not in ("claim",) and query.length else []),
        f"{query.module}.tla",
    ]
    key = hashlib.sha256("\0".join([text, config, *arguments]).encode()).hexdigest()
    if resume and kept.exists():
        before = msgspec.json.decode(kept.read_bytes(), type=Result)
        if before.key == key and before.answer.outcome == query.expect:
            return msgspec.structs.replace(before, kept=True)
    done = apalache.run(asking.program, arguments, query.formulas, folder, query.timeout, asking.processes)
    (folder / "log").write_text(done.output, encoding="utf-8")
    result = Result(query.name, key, done.answer, done.seconds, done.megabytes, apalache.version(done.output))
    kept.write_bytes(msgspec.json.encode(result))
    return result


def write_texts(root: Path, query: Query, folder: Path) -> tuple[str, str]:
    """Write the module and the configuration of a query, and return them. Raises `ManifestError`, OSError."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    folders = [root / "models", root / "spec"]
    if query.mutation is not None:
        folders.insert(0, _mutated(root, query, folder / "changed"))
    replaced = dict(_REPLACED.findall((root / "models" / f"{query.module}.cfg").read_text(encoding="utf-8")))
    roots = {query.init, query.next, *query.formulas, *replaced, *replaced.values()} | {query.constants} - {""}
    text = module_text(query.module, folders, roots, dict(query.instead))
    lacking = sorted({query.init, query.next, *query.formulas} - definitions(text))
    if lacking:
        raise ManifestError(f"query {query.name}: {query.module} does not define {', '.join(lacking)}")
    constants = "".join(f"    {name} <- {by}\n" for name, by in replaced.items())
    config = f"INIT {query.init}\nNEXT {query.next}\n" + (f"CONSTANTS\n{constants}" if constants else "")
    (folder / f"{query.module}.tla").write_text(text, encoding="utf-8")
    (folder / "query.cfg").write_text(config, encoding="utf-8")
    return text, config


def _mutated(root: Path, query: Query, folder: Path) -> Path:
    """A folder with the changed module. Raises `ManifestError` where the text to replace is not there once."""
    change = query.mutation
    assert change is not None
    path = root / "spec" / change.module
    text = path.read_text(encoding="utf-8")
    if text.count(change.replace) != 1:
        raise ManifestError(f"query {query.name}: {change.module} has not once the text {change.replace!r}")
    folder.mkdir()
    (folder / path.name).write_text(text.replace(change.replace, change.by), encoding="utf-8")
    return folder

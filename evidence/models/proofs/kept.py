"""Answers that are kept: for each formula of a query the text that it is about, and the run that answered.

The text of a formula is what Apalache reads of the query for this formula alone. So an answer stays where another
property changes, and only the formulas whose text is new are asked again.
"""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import msgspec

from evidence.models.proofs.apalache import Answer
from evidence.models.proofs.text import without_comments
from evidence.tla.flatten import definition_span
from evidence.tla.modules import reached
from evidence.tla.syntax import read_text, references

_ALIAS = re.compile(r"\(\*\s*@typeAlias:\s*(\w+)\s*=([^;]*);\s*\*\)")
_USED_ALIAS = re.compile(r"\$(\w+)")
_DIGITS = 16
"""So many of a hash tell thousands of texts apart."""


class Pending(msgspec.Struct, frozen=True):
    """A condition of a formula to which Z3 had no answer in time, as Apalache calls it, such as "state invariant 2".

    `transitions` is the option that names the transitions after which it was asked; empty for all.
    """

    condition: str
    transitions: str


class Run(msgspec.Struct, frozen=True, omit_defaults=True):
    """A run of Apalache: the query, the keys of the formulas that it was asked, and the answer to all of them.

    `megabytes` is the most memory that it had. Where a formula has `pending` conditions, the run is about it alone, and
    all its other conditions hold.
    """

    query: str
    answer: Answer
    seconds: float
    megabytes: int
    version: str
    date: str
    keys: tuple[str, ...]
    pending: tuple[Pending, ...] = ()


class Result(msgspec.Struct, frozen=True):
    """What came of a query: the answers of its runs in one, their time, the most memory that one of them had."""

    query: str
    answer: Answer
    seconds: float
    megabytes: int
    version: str
    kept: bool = False


def keys(text: str, formulas: Iterable[str], roots: Iterable[str], rest: Sequence[str]) -> dict[str, str]:
    """The key of each formula: the hash of what it and the roots need of a module's text, and of the `rest`.

    Comments other than types do not count, and no type alias that nothing of it uses. Raises
    `evidence.tla.syntax.SyntaxTreeError`.
    """
    module = read_text(text)
    uses = {name: references(unit) for name, unit in module.definitions.items()}
    spans = {name: definition_span(module, name) for name in module.definitions}
    stated, outside, at = {}, bytearray(), 0
    for name, (start, stop) in spans.items():
        stated[name] = without_comments(module.text[start:stop].decode())
        outside += module.text[at:start]
        at = stop
    around = without_comments((bytes(outside) + module.text[at:]).decode())
    aliases = dict(_ALIAS.findall(around))
    around = without_comments(_ALIAS.sub("", around))
    within = {name: _USED_ALIAS.findall(said) for name, said in aliases.items()}
    instances = [name for unit in module.units if unit.type == "module_definition" for name in references(unit)]
    common = [*roots, *instances]

    def key(formula: str) -> str:
        needed = reached([formula, *common], uses)
        said = [formula, around, *(text for name, text in stated.items() if name in needed), *rest]
        types = reached(_USED_ALIAS.findall("\n".join(said)), within)
        said += [f"{name} = {alias}" for name, alias in aliases.items() if name in types]
        return hashlib.sha256(json.dumps(said).encode()).hexdigest()[:_DIGITS]

    return {formula: key(formula) for formula in formulas}


class KeptAnswers:
    """The kept runs, in a file with a line for each. Safe to use from several threads and processes."""

    def __init__(self, file: Path) -> None:
        """Keep them in `file`, which need not be there yet."""
        self._file = file

    def of(self, query: str) -> list[Run]:
        """The runs of a query, of whatever text. Raises OSError, msgspec.MsgspecError."""
        return [run for run in self._read() if run.query == query]

    def put(self, query: str, runs: Iterable[Run]) -> None:
        """Keep these runs of a query in place of the earlier ones, without what only this machine has.

        Raises OSError, msgspec.MsgspecError.
        """
        told = [msgspec.structs.replace(run, answer=replace(run.answer, trace="")) for run in runs]
        with _locked(self._file.parent):
            others = [run for run in self._read() if run.query != query]
            new = self._file.with_suffix(".new")
            new.write_bytes(msgspec.json.Encoder().encode_lines(sorted([*others, *told], key=lambda run: run.query)))
            new.replace(self._file)  # who reads meanwhile has the whole file

    def _read(self) -> list[Run]:
        lines = self._file.read_bytes() if self._file.exists() else b""
        return msgspec.json.Decoder(Run).decode_lines(lines)


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """No other process is in this block for the same folder."""
    lock = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield
    finally:
        os.close(lock)


def still(runs: Iterable[Run], now: Iterable[str]) -> list[Run]:
    """The runs that answer these keys.

    Of a run whose formulas hold, those that changed are left out. Of another run it is not known which of them it is
    about: it counts if none has changed.
    """
    keys_now = set(now)
    found = []
    for run in runs:
        same = tuple(key for key in run.keys if key in keys_now)
        if same == run.keys or (same and run.answer.outcome == "holds"):
            found.append(msgspec.structs.replace(run, keys=same))
    return found


def together(query: str, keys_now: Mapping[str, str], runs: Sequence[Run], *, kept: bool) -> Result:
    """One result of the runs: a formula without a run is not asked, and an answer that is not "holds" is that of all.

    `keys_now` are the formulas, each with its key. Conditions, transitions and seconds are those of all these runs.
    """
    lacking = unanswered(keys_now, runs)
    others = [run.answer for run in runs if run.answer.outcome != "holds"]
    if others:
        answer = next((other for other in others if other.outcome != "not asked"), others[-1])
    elif lacking:
        answer = Answer("not asked", 0, f"not asked: {', '.join(lacking)}")
    else:
        checked = sum(run.answer.checked for run in runs)
        answer = Answer("holds", checked, taken=max(run.answer.taken for run in runs))
    return Result(
        query,
        answer,
        round(sum(run.seconds for run in runs), 1),
        max((run.megabytes for run in runs), default=0),
        runs[-1].version if runs else "",
        kept,
    )


def unanswered(keys_now: Mapping[str, str], runs: Iterable[Run]) -> tuple[str, ...]:
    """The formulas that no run answers."""
    answered = {key for run in runs if not run.pending for key in run.keys}
    return tuple(name for name, key in keys_now.items() if key not in answered)

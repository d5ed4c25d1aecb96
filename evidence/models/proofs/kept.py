"""Answers that are kept: for each formula of a query the text that it is about, and the run that answered.

The text of a formula is what Apalache reads of the query for this formula alone. So an answer stays where another
property changes, and only the formulas whose text is new are asked again.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import msgspec

from evidence.models.proofs.apalache import Answer
from evidence.models.proofs.text import without_comments
from evidence.tla.flatten import definition_span
from evidence.tla.modules import reached
from evidence.tla.syntax import read_text, references

_ALIAS = re.compile(r"\(\*\s*@typeAlias:\s*(\w+)\s*=([^;]*);\s*\*\)")
_USED_ALIAS = re.compile(r"\$(\w+)")


class Run(msgspec.Struct, frozen=True):
    """A run of Apalache: the formulas that it was asked, each with its key, and the answer to all of them.

    `megabytes` is the most memory that it had.
    """

    keys: dict[str, str]
    answer: Answer
    seconds: float
    megabytes: int
    version: str


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
        return hashlib.sha256(json.dumps(said).encode()).hexdigest()

    return {formula: key(formula) for formula in formulas}


def read(file: Path, now: Mapping[str, str]) -> list[Run]:
    """The runs of the file that answer these keys.

    Of a run whose formulas hold, the formulas that changed are left out. Of another run it is not known which of them
    it is about: it counts if none has changed.
    """
    if not file.exists():
        return []
    found = []
    for run in msgspec.json.decode(file.read_bytes(), type=list[Run]):
        same = {name: key for name, key in run.keys.items() if now.get(name) == key}
        if same == run.keys or (same and run.answer.outcome == "holds"):
            found.append(msgspec.structs.replace(run, keys=same))
    return found


def write(file: Path, runs: Sequence[Run]) -> None:
    """Keep the runs. Raises OSError."""
    file.write_bytes(msgspec.json.encode(runs))


def together(query: str, formulas: Iterable[str], runs: Sequence[Run], *, kept: bool) -> Result:
    """One result of the runs: a formula without a run is not asked, and an answer that is not "holds" is that of all.

    Conditions, transitions and seconds are those of all these runs.
    """
    answered = {name for run in runs for name in run.keys}
    lacking = [name for name in formulas if name not in answered]
    others = [run.answer for run in runs if run.answer.outcome != "holds"]
    if others:
        answer = others[-1]
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

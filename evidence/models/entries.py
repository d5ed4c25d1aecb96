"""The notation of ``models.txt`` and ``controls.txt``: an entry for each model and each negative control.

::

    == airt model ci MCAirt.tla 0
    Delays nested three deep: nothing of a higher class starts, nothing is lost.
    requirements AIRT-01 AIRT-02
    states 83351, distinct 15851, depth 29, seconds 0.3..180
    constants TodObs <- MCTodObs, Families <- MCFamilies
    invariants AirtInv

    == neg-once-not-cancelled tod 13 OnceProp alone
    constants Words <- JustOnce
    TodSettings.tla: `IF OnceIsUnsetByItsRun THEN Unset(t)` -> `IF OnceIsUnsetByItsRun THEN t`

A heading has the name, for a model its kind and lane, then the module or the base, TLC's exit code and the property
that fails; ``alone``: that property is all that is checked. A line that begins with a capital letter describes the
entry. Below a module's name, lines with ``-`` are replaced by those with ``+``. Two spaces continue a line. A comment
begins with ``//`` and stands between entries. Every error names file and line.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from textwrap import wrap
from typing import Annotated, Any, Literal, get_args

import msgspec
from msgspec import UNSET, Meta, UnsetType

LANES = ("smoke", "ci", "full")
Lane = Literal["smoke", "ci", "full"]
ModelKind = Literal["model", "liveness", "refinement", "calendar", "witness", "negative"]
Violates = Literal["invariant", "action", "temporal", "initial", "deadlock", "assumption"]

CONTROLS = "controls.txt"
"""The negative controls, beside the models."""

WIDTH = 120
"""Columns of a line of the files."""

COUNTS = ("states", "distinct", "depth")


class ManifestError(ValueError):
    """The manifest is wrong; the text names file, line, model and field."""


Count = Annotated[int, Meta(ge=0)]
Name = Annotated[str, Meta(pattern=r"^[A-Za-z0-9][A-Za-z0-9_.-]*$")]


class Expect(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    """The result that a model must have.

    `exit` is TLC's exit code: 0 passed, 10 an assumption is false, 11 deadlock, 12 or 13 a property is violated (for
    what stands under PROPERTY the TLC versions differ between 12 and 13, so both are taken there; what kind of
    violation it was is told by TLC's message codes). `property` names the violated invariant or property. `violates`
    pins the kind of a violation closer than `property` alone. The counts are generated states, distinct states and
    depth.
    """

    exit: Literal[0, 10, 11, 12, 13]
    property: str | None = None
    violates: Violates | None = None
    states: Count | None = None
    distinct: Count | None = None
    depth: Count | None = None


class Mutation(msgspec.Struct, forbid_unknown_fields=True):
    """One replacement in a module's text. `replace` must occur exactly once in `module` when the model runs."""

    module: str
    replace: Annotated[str, Meta(min_length=1)]
    by: str


class Entry(msgspec.Struct, forbid_unknown_fields=True):
    """An entry as it stands in a file.

    Paths are relative to the file's directory, `seconds` is wall time. `brief`: the run is over before code that is
    compiled well would pay, after some 7 seconds of work; unless a negative control says otherwise, it is. `constants`
    replaces assignments of the configuration ("<- Definition", "= value"), `plain` takes them out. `place` is file and
    line of the heading.
    """

    name: Name
    expect: Expect
    base: str | UnsetType = UNSET
    module: str | UnsetType = UNSET
    config: str | UnsetType = UNSET
    lane: Lane | UnsetType = UNSET
    kind: ModelKind | UnsetType = UNSET
    what: str | UnsetType = UNSET
    requirements: list[str] = []
    seconds: tuple[float, float] | UnsetType = UNSET
    workers: Annotated[int, Meta(ge=1)] | UnsetType = UNSET
    deadlock: bool | UnsetType = UNSET
    brief: bool | UnsetType = UNSET
    heap: Annotated[int, Meta(ge=64)] | UnsetType = UNSET
    specification: list[str] | UnsetType = UNSET
    view: list[str] | UnsetType = UNSET
    constraint: list[str] | UnsetType = UNSET
    constants: dict[str, str] = {}
    plain: list[str] = []
    invariants: list[str] | UnsetType = UNSET
    properties: list[str] | UnsetType = UNSET
    mutate: list[Mutation] = []
    place: str = ""


class Listed(msgspec.Struct):
    """What the files list. `others` maps a glob of files that are no models to what they are for."""

    entries: list[Entry]
    spec: str = "../spec"
    others: dict[str, str] = {}


_WORDS = ("requirements", "specification", "view", "constraint", "plain", "invariants", "properties")
"""Fields whose line has words, or `none`."""

_SCALARS: dict[str, Callable[[str], Any]] = {
    **dict.fromkeys((*COUNTS, "workers", "heap"), int),
    "seconds": lambda text: [float(end) for end in text.split("..")],
    "brief": lambda text: {"": True, "false": False}[text],
    "deadlock": lambda text: {"true": True, "false": False}[text],
    "violates": str,
    "lane": str,
    "config": str,
}
"""Fields that share a line, with commas between them."""

_TOGETHER = "\N{NO-BREAK SPACE}"
"""For a space at which no line is to end."""

_ASSIGNED = re.compile(r",\s*(?=\w+ (?:<-|=) )")
_MODULE = re.compile(r"(\w+\.tla):(?: `(.+)` -> `(.*)`)?")


def read(path: Path) -> Listed:
    """The entries of the models in `path` and of the controls beside them, in their order. Raises `ManifestError`."""
    controls = path.parent / CONTROLS
    listed = Listed([])
    for file in [path, controls] if controls.is_file() else [path]:
        _Reader(file, listed).read()
    return listed


class _Reader:
    """Reads one file into `listed`."""

    def __init__(self, path: Path, listed: Listed) -> None:
        self.path = path
        self.listed = listed
        self.raw: dict[str, Any] = {}
        self.where = ""
        self.over = True  # a comment or an empty line ends an entry

    def read(self) -> None:
        """Read all lines."""
        for line, text in _logical(self.path):
            self.where = f"{self.path}:{line}"
            if not text or text.startswith("//"):
                self.over = True
            elif text.startswith("== "):
                self._finish()
                self.raw, self.over = {"place": self.where, **self._heading(text[3:].split())}, False
            elif not self.raw and self.over:
                self._general(text)
            elif self.over:
                raise ManifestError(f"{self.where}: expected == after a comment or an empty line, not {text!r}")
            else:
                self._field(text)
        self._finish()

    def _finish(self) -> None:
        if not self.raw:
            return
        for change in self.raw.get("mutate", []):
            if isinstance(change["replace"], list):
                change |= {side: "".join(f"{line}\n" for line in change[side]) for side in ("replace", "by")}
        try:
            self.listed.entries.append(msgspec.convert(self.raw, Entry))
        except msgspec.ValidationError as error:
            said, _, field = str(error).partition(" - at `$")
            raise ManifestError(f"{self.raw['place']}: {self.raw['name']}{field.rstrip('`')}: {said}") from error

    def _heading(self, words: list[str]) -> dict[str, Any]:
        raw: dict[str, Any] = {}
        if len(words) > 4 and words[1] in get_args(ModelKind) and not words[2].isdigit():
            raw = {"kind": words[1], "lane": words[2]}
            del words[1:3]
        if len(words) < 3 or not words[2].isdigit():
            raise ManifestError(f"{self.where}: expected == NAME, of a model KIND LANE, MODULE or BASE, EXIT")
        name, of, code, *rest = words
        alone = rest[-1:] == ["alone"]
        failing = " ".join(rest[: len(rest) - alone])
        if alone and failing:
            group = "invariants" if code == "12" else "properties"
            raw |= {"invariants": [], "properties": []} | {group: [failing]}
        expect = {"exit": int(code)} | ({"property": failing} if failing else {})
        return {"name": name, "module" if of.endswith(".tla") else "base": of, "expect": expect, **raw}

    def _general(self, text: str) -> None:
        word, _, rest = text.partition(" ")
        glob, colon, reason = rest.partition(": ")
        if word == "spec" and rest:
            self.listed.spec = rest
        elif word == "other" and colon:
            self.listed.others[glob] = reason
        else:
            raise ManifestError(f"{self.where}: expected spec FOLDER, other FILE: PURPOSE, or ==, not {text!r}")

    def _field(self, text: str) -> None:
        word, _, rest = text.partition(" ")
        if changed := _MODULE.fullmatch(text):
            module, old, new = changed.groups()
            sides: Any = {"replace": old, "by": new} if old else {"replace": [], "by": []}
            self.raw.setdefault("mutate", []).append({"module": module, **sides})
        elif word in ("-", "+"):
            self._changed_line(word, rest)
        elif text[0].isupper():
            self._set("what", text)
        elif word in _WORDS:
            self._set(word, [] if rest == "none" else rest.split())
        elif word == "constants":
            self._set(word, dict(self._constant(one) for one in _ASSIGNED.split(rest)))
        else:
            for item in text.split(", "):
                self._scalar(*item.partition(" ")[::2])

    def _changed_line(self, sign: str, text: str) -> None:
        change = (self.raw.get("mutate") or [{}])[-1]
        if not isinstance(change.get("replace"), list):
            raise ManifestError(f"{self.where}: expected a line such as 'Module.tla:' before {sign}")
        change["replace" if sign == "-" else "by"].append(text)

    def _constant(self, text: str) -> tuple[str, str]:
        name, operator, value = (*text.split(" ", 2), "", "")[:3]
        if operator not in ("<-", "=") or not value:
            raise ManifestError(f"{self.where}: constants: expected NAME <- DEFINITION or NAME = VALUE, not {text!r}")
        return name, f"{operator} {value}"

    def _scalar(self, name: str, text: str) -> None:
        if name not in _SCALARS:
            raise ManifestError(f"{self.where}: {self.raw['name']}: no field is named {name!r}")
        try:
            value = _SCALARS[name](text)
        except (ValueError, KeyError) as error:
            raise ManifestError(f"{self.where}: {self.raw['name']}: {name}: {text!r} is no value of it") from error
        if name in (*COUNTS, "violates"):
            self.raw["expect"] = {**self.raw["expect"], name: value}
        else:
            self._set(name, value)

    def _set(self, name: str, value: Any) -> None:
        if name in self.raw:
            raise ManifestError(f"{self.where}: {self.raw['name']}: {name} stands twice")
        self.raw[name] = value


def _logical(path: Path) -> Iterator[tuple[int, str]]:
    """The lines with their numbers; one that two spaces begin belongs to the line before. Raises `ManifestError`."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise ManifestError(f"{path}: cannot be read: {getattr(error, 'strerror', error)}") from error
    whole: list[tuple[int, str]] = []
    for number, text in enumerate(lines, 1):
        if text.startswith("  ") and whole:
            whole[-1] = (whole[-1][0], f"{whole[-1][1]} {text.strip()}")
        else:
            whole.append((number, text))
    yield from whole


def render(entry: Entry) -> str:
    """The lines of an entry, as they stand in a file."""
    expect = entry.expect
    alone = _is_alone(entry)
    of = entry.base if entry.module is UNSET else entry.module
    model = () if entry.kind is UNSET else (entry.kind, entry.lane)
    words = ["==", entry.name, *model, of, expect.exit, expect.property or "", "alone" if alone else ""]
    lines = [" ".join(str(word) for word in words if word != "")]
    lines += _wrapped(entry.what) if isinstance(entry.what, str) else []
    lines += _wrapped(f"requirements {' '.join(entry.requirements)}") if entry.requirements else []
    scalars = [_scalar(name, value) for name, value in _values(entry) if value not in (None, UNSET)]
    lines += [", ".join(scalars)] if scalars else []
    if entry.constants:
        each = (f"{name} {value}".replace(" ", _TOGETHER) for name, value in entry.constants.items())
        lines += [line.replace(_TOGETHER, " ") for line in _wrapped(f"constants {', '.join(each)}")]
    for name in _WORDS[1:]:
        value = getattr(entry, name)
        if value is not UNSET and (value or name != "plain") and not (alone and name in ("invariants", "properties")):
            lines += _wrapped(f"{name} {' '.join(value) or 'none'}")
    return "\n".join([*lines, *(line for change in entry.mutate for line in _change(change))])


def _is_alone(entry: Entry) -> bool:
    group = "invariants" if entry.expect.exit == 12 else "properties"
    checked = {"invariants": entry.invariants, "properties": entry.properties}
    return checked == {"invariants": [], "properties": []} | {group: [entry.expect.property]}


def _values(entry: Entry) -> Iterable[tuple[str, Any]]:
    """The fields that share a line."""
    yield from ((name, getattr(entry.expect, name)) for name in (*COUNTS, "violates"))
    yield from ((name, getattr(entry, name)) for name in ("seconds", "brief", "workers", "heap", "deadlock", "config"))
    if entry.kind is UNSET:
        yield "lane", entry.lane


def _scalar(name: str, value: Any) -> str:
    if name == "seconds":
        return "seconds " + "..".join(f"{end:g}" for end in value)
    if name == "brief" and value:
        return name
    return f"{name} {str(value).lower() if isinstance(value, bool) else value}"


def _wrapped(text: str) -> list[str]:
    return wrap(text, WIDTH, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)


def _change(change: Mutation) -> list[str]:
    """The lines of a change: one line, or those that are taken out and put in."""
    line = f"{change.module}: `{change.replace}` -> `{change.by}`"
    if len(line) <= WIDTH and "\n" not in line:
        return [line]
    if any(text and not text.endswith("\n") for text in (change.replace, change.by)):
        raise ManifestError(f"{change.module}: a change of several lines, or of long ones, ends with the line")
    sides = (("-", change.replace), ("+", change.by))
    return [f"{change.module}:", *(f"{sign} {one}".rstrip() for sign, text in sides for one in text.splitlines())]


def rewrite(entry: Entry) -> None:
    """Write the entry in the place of that of its name; all other lines stay. Raises OSError."""
    name, _, number = entry.place.rpartition(":")
    file = Path(name)
    lines = file.read_text(encoding="utf-8").split("\n")
    begin = end = int(number) - 1
    while end < len(lines) and lines[end] and (end == begin or not lines[end].startswith(("== ", "//"))):
        end += 1
    lines[begin:end] = render(entry).split("\n")
    file.write_text("\n".join(lines), encoding="utf-8")

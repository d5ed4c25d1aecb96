"""The manifest: the models, and the result that each of them must have.

``models/models.txt`` and ``controls.txt`` beside it hold entries of two shapes (`evidence.models.entries`). A *base*
entry names a module and a configuration file; the file is ``MCBase.cfg`` unless it names another. A *derived* entry
names a base entry and its changes: constants, text of a module, the invariants or properties that are checked. What a
derived entry does not say, it has from its base. A base that is derived itself adds its constants.

Every error names file, line and model.
"""

from __future__ import annotations

import fnmatch
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path, PurePosixPath
from typing import Any

import msgspec
from msgspec import UNSET, UnsetType

from evidence.models.entries import LANES, Entry, Expect, Lane, Listed, ManifestError, ModelKind, Mutation, read
from evidence.tla import cfg as cfg_file

PROPERTY_KINDS = frozenset({"action", "temporal", "initial"})

HEAP_MB = 1024
"""Java heap of a run that names none, in MB."""

_SINGLE_WORKER = frozenset({"liveness", "negative", "witness"})
BASE_CONFIG = "MCBase.cfg"
"""The configuration of a module whose entry names none."""


@dataclass(frozen=True)
class Model:
    """A model ready to run: everything from its base filled in, its configuration edited.

    `module` is relative to the manifest's directory; `config` is the configuration's text, not a path, `invariants` and
    `properties` what it checks; `seconds` the band (least, most) of wall time; `workers` the most TLC workers it may
    have; `brief` whether the run is short; `base` the entry that it changes.
    """

    name: str
    kind: ModelKind
    lane: Lane
    what: str
    requirements: tuple[str, ...]
    module: PurePosixPath
    config: str
    mutations: tuple[Mutation, ...]
    deadlock: bool
    workers: int
    brief: bool
    heap: int
    seconds: tuple[float, float]
    expect: Expect
    base: str = ""
    invariants: tuple[str, ...] = ()
    properties: tuple[str, ...] = ()

    @property
    def exits(self) -> tuple[int, ...]:
        """TLC's exit codes that are as pinned."""
        return (12, 13) if self.kinds_of_exit == PROPERTY_KINDS else (self.expect.exit,)

    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of outcome (``messages.Kind``) that are as pinned."""
        return frozenset({self.expect.violates}) if self.expect.violates else self.kinds_of_exit

    @property
    def kinds_of_exit(self) -> frozenset[str]:
        """The kinds of outcome that go with the pinned exit code and property."""
        if self.expect.exit in (12, 13):
            return PROPERTY_KINDS if self.expect.property in self.properties else frozenset({"invariant"})
        return frozenset({{0: "passed", 10: "assumption", 11: "deadlock"}[self.expect.exit]})

    def with_property(self, name: str) -> Model:
        """The model with one PROPERTY alone, beside all its invariants."""
        config = cfg_file.replace_section(self.config, "PROPERTY", [name])
        return replace(self, config=config, properties=(name,))


@dataclass(frozen=True)
class Manifest:
    """A checked manifest: where it is, where the specification is, its models in order, its files without an entry."""

    path: Path
    spec: Path
    models: tuple[Model, ...]
    drift: tuple[str, ...]

    @property
    def directory(self) -> Path:
        """The directory of the models."""
        return self.path.parent

    def select(self, lane: str, names: tuple[str, ...]) -> list[Model]:
        """Return the models of these names or globs, in any lane; without names, the models of the lane.

        A lane includes the lower ones. Raises `ManifestError` for a name that no model has.
        """
        if not names:
            allowed = LANES[: LANES.index(lane) + 1]
            return [m for m in self.models if m.lane in allowed]
        for name in names:
            if not fnmatch.filter([m.name for m in self.models], name):
                raise ManifestError(f"{self.path}: no model is named {name!r}")
        return [m for m in self.models if any(fnmatch.fnmatchcase(m.name, name) for name in names)]


def shard(models: list[Model], number: int, of: int) -> list[Model]:
    """Return the part `number` (1 to `of`) of the models, in their order: each is in one part, long ones are spread."""
    dealt = sorted(models, key=lambda m: (-(m.expect.distinct or 0), -sum(m.seconds), m.name))
    mine = {m.name for m in dealt[number - 1 :: of]}
    return [m for m in models if m.name in mine]


def load(path: Path) -> Manifest:
    """Read and check the manifest and the files that it names. Raises `ManifestError`."""
    listed = read(path)
    spec = (path.parent / listed.spec).resolve()
    if not spec.is_dir():
        raise ManifestError(f"{path}: spec: {listed.spec} is not a directory")
    entries: dict[str, Entry] = {}
    for entry in listed.entries:
        if entries.setdefault(entry.name, entry) is not entry:
            first = entries[entry.name].place
            raise ManifestError(f"{entry.place}: the name {entry.name!r} stands there more than once, see {first}")
    bases = {e.name: e for e in listed.entries if isinstance(e.base, UnsetType)}
    models = [_resolve(path.parent, spec, _through(entry, entries), bases) for entry in listed.entries]
    return Manifest(path, spec, tuple(_in_lanes(listed.entries, models)), tuple(_unlisted(path, listed)))


def _in_lanes(entries: list[Entry], models: list[Model]) -> Iterator[Model]:
    """The models, with the lane of each control that says none: its model's if it is the first by which a property
    fails, else the full one.
    """
    seen: set[tuple[int, str]] = set()
    for entry, model in zip(entries, models, strict=True):
        fails = (model.expect.exit, model.expect.property or model.name)
        again = model.kind == "negative" and entry.lane is UNSET and fails in seen
        yield replace(model, lane="full") if again else model
        if model.kind == "negative":
            seen.add(fails)


def _through(entry: Entry, entries: dict[str, Entry]) -> Entry:
    """Return a change of a model that itself changes constants of a base as a change of that base."""
    between = None if isinstance(entry.base, UnsetType) else entries.get(entry.base)
    if between is None or isinstance(between.base, UnsetType) or isinstance(between.kind, UnsetType):
        return entry
    return msgspec.structs.replace(entry, base=between.base, constants=between.constants | entry.constants)


def _resolve(directory: Path, spec: Path, entry: Entry, bases: dict[str, Entry]) -> Model:
    where = f"{entry.place}: {entry.name}"
    mutations = tuple(entry.mutate)
    base = _base(where, entry, mutations, bases)
    derived = base is not entry
    value = partial(_value, where, entry, base)
    if not derived and isinstance(entry.kind, UnsetType):
        raise ManifestError(f"{where}.kind: missing")
    kind: ModelKind = "negative" if isinstance(entry.kind, UnsetType) else entry.kind
    single = kind in _SINGLE_WORKER
    if single and entry.workers not in (UNSET, 1):
        raise ManifestError(f"{where}.workers: a {kind} runs with 1 worker, its trace or liveness needs it")
    _check_mutations(where, directory, spec, mutations)
    cfg = configuration(directory, entry, base)
    model = Model(
        name=entry.name,
        kind=kind,
        lane=value("lane"),
        what=entry.what if not isinstance(entry.what, UnsetType) else _describe(where, entry, mutations),
        requirements=tuple(entry.requirements or base.requirements),
        module=_file(where, directory, "module", str(base.module), ".tla"),
        config=cfg.text,
        mutations=mutations,
        deadlock=value("deadlock", "FALSE" not in cfg.names("CHECK_DEADLOCK")),
        workers=1 if single else value("workers", 1),
        brief=kind == "negative" if isinstance(entry.brief, UnsetType) else entry.brief,
        heap=value("heap", HEAP_MB),
        seconds=_seconds(where, entry, value("seconds")),
        expect=entry.expect,
        base=base.name if derived else "",
        invariants=cfg.names("INVARIANT"),
        properties=cfg.names("PROPERTY"),
    )
    _check_model(where, model, cfg.names("CHECK_DEADLOCK"))
    if kind == "negative" and model.expect.property in model.properties:
        return model.with_property(model.expect.property)
    return model


def _value(where: str, entry: Entry, base: Entry, field: str, default: Any = UNSET) -> Any:
    """Return a field of the entry, else of its base, else the default; without any it is missing."""
    found = [value for value in (getattr(entry, field), getattr(base, field), default) if value is not UNSET]
    if not found:
        raise ManifestError(f"{where}.{field}: missing")
    return found[0]


def _seconds(where: str, entry: Entry, band: tuple[float, float]) -> tuple[float, float]:
    """Return the band of wall time; a violation of a model that is changed ends the search early."""
    least, most = (0.0, band[1]) if entry.seconds is UNSET else band
    if not 0 <= least < most:
        raise ManifestError(f"{where}.seconds: {least}..{most} is not a band")
    return least, most


def _base(where: str, entry: Entry, mutations: tuple[Mutation, ...], bases: dict[str, Entry]) -> Entry:
    """Return the entry that this one changes; itself if it has a module of its own."""
    if isinstance(entry.base, UnsetType):
        return entry
    if entry.base not in bases:
        raise ManifestError(f"{where}.base: {entry.base!r} is not the name of an entry with a module of its own")
    if entry.config is not UNSET:
        raise ManifestError(f"{where}.config: an entry with a base has it from there")
    fields = ("invariants", "properties", "deadlock", "specification", "view", "constraint")
    own = any(getattr(entry, field) is not UNSET for field in fields)
    if not (entry.constants or entry.plain or mutations or own):
        raise ManifestError(f"{where}: changes nothing of its base {entry.base}")
    return bases[entry.base]


def _describe(where: str, entry: Entry, mutations: tuple[Mutation, ...]) -> str:
    """Describe a derived entry without a description; any other entry must have its own."""
    if isinstance(entry.base, UnsetType):
        raise ManifestError(f"{where}.what: missing")
    changes = [f"{name} {value}" for name, value in entry.constants.items()]
    changes += [f"{m.replace!r} -> {m.by!r} in {m.module}" for m in mutations]
    for keyword, names in (("INVARIANT", entry.invariants), ("PROPERTY", entry.properties)):
        changes += [] if isinstance(names, UnsetType) else [f"{keyword} {' '.join(names) or 'none'}"]
    fails = entry.expect.property or {0: "nothing", 10: "an assumption", 11: "deadlock"}.get(entry.expect.exit, "?")
    return f"{entry.base} with {', '.join(changes) or 'another configuration'}: {fails} must fail"


def _file(where: str, directory: Path, field: str, name: str, suffix: str) -> PurePosixPath:
    path = directory / name
    if not name.endswith(suffix) or not path.is_file():
        raise ManifestError(f"{where}.{field}: {name} is not a {suffix} file in {directory}")
    if directory.resolve() not in path.resolve().parents:
        raise ManifestError(f"{where}.{field}: {name} is outside {directory}")
    return PurePosixPath(name)


def configuration(directory: Path, entry: Entry, base: Entry) -> cfg_file.Cfg:
    """The configuration of an entry in this directory: that of its base, changed. Raises `ManifestError`."""
    name = BASE_CONFIG if base.config is UNSET else str(base.config)
    file = _file(f"{entry.place}: {entry.name}", directory, "config", name, ".cfg")
    try:
        text = (directory / file).read_text(encoding="utf-8")
        cfg_file.parse(text)
        for one in (base, entry) if entry is not base else (base,):
            text = _changed(text, one)
        return cfg_file.parse(text)
    except (OSError, UnicodeDecodeError, cfg_file.CfgError) as error:
        raise ManifestError(f"{entry.place}: {entry.name}: {name}: {error}") from error


def _changed(text: str, entry: Entry) -> str:
    for constant in entry.plain:
        text = cfg_file.without(text, constant)
    for constant, value in entry.constants.items():
        text = cfg_file.override(text, constant, value)
    for keyword, names in (
        ("SPECIFICATION", entry.specification),
        ("VIEW", entry.view),
        ("CONSTRAINT", entry.constraint),
        ("INVARIANT", entry.invariants),
        ("PROPERTY", entry.properties),
    ):
        if not isinstance(names, UnsetType):
            text = cfg_file.replace_section(text, keyword, names)
    return text


def _check_mutations(where: str, directory: Path, spec: Path, mutations: tuple[Mutation, ...]) -> None:
    for mutation in mutations:
        if mutation.replace == mutation.by:
            raise ManifestError(f"{where}.mutate: replaces a text by itself")
        if sum(len(list(place.rglob(mutation.module))) for place in (spec, directory)) != 1:
            raise ManifestError(f"{where}.mutate.module: {mutation.module} is not in exactly one of spec and models")


def _check_model(where: str, model: Model, check_deadlock: tuple[str, ...]) -> None:
    """Check the rules that concern several fields; `check_deadlock` is said by the configuration."""
    expect = model.expect
    contradiction = "FALSE" if model.deadlock else "TRUE"
    if contradiction in check_deadlock:
        raise ManifestError(
            f"{where}.deadlock: the configuration says CHECK_DEADLOCK {contradiction}: "
            f"say {contradiction.lower()} here too"
        )
    if model.kind == "negative" and expect.exit == 0:
        raise ManifestError(f"{where}.expect.exit: a negative control has to fail")
    if model.kind not in ("negative", "witness") and expect.exit != 0:
        raise ManifestError(f"{where}.expect.exit: a {model.kind} has to pass")
    if expect.depth is not None and model.workers > 1:
        raise ManifestError(f"{where}.expect.depth: TLC's depth is exact with 1 worker only")
    if expect.exit in (12, 13):
        if expect.property is None:
            raise ManifestError(f"{where}.expect.property: missing")
        if expect.property not in model.invariants + model.properties:
            raise ManifestError(f"{where}.expect.property: the configuration does not check {expect.property}")
        if expect.property in model.invariants and expect.exit != 12:
            raise ManifestError(f"{where}.expect.exit: {expect.property} is an INVARIANT, its exit is 12")
    elif expect.property is not None and expect.exit != 10:
        raise ManifestError(f"{where}.expect.property: exit {expect.exit} names none")
    if expect.violates is not None and expect.violates not in model.kinds_of_exit:
        raise ManifestError(f"{where}.expect.violates: {expect.violates} does not go with exit and property")


def _unlisted(path: Path, listed: Listed) -> list[str]:
    """Name the .cfg and MC*.tla files that no entry names, and the exceptions that match none."""
    directory = path.parent
    named = {str(PurePosixPath(n)) for e in listed.entries for n in (e.module, e.config) if isinstance(n, str)}
    if any(isinstance(e.module, str) and e.config is UNSET for e in listed.entries):
        named.add(BASE_CONFIG)
    files = sorted(
        p.relative_to(directory).as_posix()
        for pattern in ("*.cfg", "MC*.tla")
        for p in directory.rglob(pattern)
        if "canaries" not in p.relative_to(directory).parts[:-1]
    )
    drift = []
    unused = dict(listed.others)
    for file in files:
        matching = [glob for glob in listed.others if fnmatch.fnmatchcase(file, glob)]
        for glob in matching:
            unused.pop(glob, None)
        if file not in named and not matching:
            drift.append(f"{directory / file}: no model of {path.name} names it")
    drift += [f"{path}: other: {glob!r} matches no file" for glob in unused]
    return drift

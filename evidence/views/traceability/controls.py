"""The models and controls in models/ by requirement: properties that are checked, and negative controls.

A negative control changes a formula so that a model fails. It speaks for the requirements of the property that fails
and those that its entry names. It touches those of the rule that it changes, and those of a whole specification
where the property is that the rules implement it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from evidence.models.entries import Entry, ManifestError, read
from evidence.models.manifest import configuration
from evidence.tla.cfg import Cfg
from evidence.views.traceability.entries import Entries, entries
from evidence.views.traceability.errors import UnreadableError
from evidence.views.traceability.modules import Definition, Module
from evidence.views.traceability.properties import Properties
from evidence.views.traceability.roles import rules, statements

MODELS = "models.txt"


@dataclass(frozen=True)
class Controls:
    """What models and controls say, by requirement."""

    properties: tuple[Definition, ...]
    """The properties that some model checks, and the definitions that they are made of."""
    controls: dict[str, Entries]
    """Direct are those where the property that fails, or the entry, names the requirement."""
    names: frozenset[str]
    """All negative controls."""
    models: dict[str, tuple[str, ...]]
    """The models that name it."""
    unchecked: tuple[Definition, ...]
    """Properties with requirements that no model checks or assumes."""
    checking: dict[tuple[str, str], tuple[str, ...]]
    """The models that check a definition, by its module and name."""
    entries: dict[str, Entry]
    """All models and controls by name."""


def read_controls(folder: Path, spec: Sequence[Module], models: Sequence[Module]) -> Controls:
    """Read the models and controls in a folder and their configurations. Raises `UnreadableError`."""
    listed = _entries(folder / MODELS)
    negative = [e for e in listed.values() if _is_negative(e)]
    positive = [e for e in listed.values() if not _is_negative(e)]
    if not negative or not positive:
        raise UnreadableError(f"{folder / MODELS}: no {'models' if negative else 'negative controls'}")
    known = Properties(spec, models)
    used: dict[tuple[str, str], Definition] = {}
    assumed: set[tuple[str, str]] = set()
    checking: dict[tuple[str, str], dict[str, None]] = {}
    for entry in positive:
        model, cfg = _model(entry, listed), _config(folder, entry, listed)
        for name in _checked(entry, cfg):
            for part in known.parts(model, name, instances=True):
                used[part.module, part.name] = part
                checking.setdefault((part.module, part.name), {})[entry.name] = None
        for name in cfg.names("SPECIFICATION"):
            assumed |= {(d.module, d.name) for d in known.parts(model, name, instances=False)}
    controls = _controls(folder, negative, listed, known, (*spec, *models))
    named: dict[str, tuple[str, ...]] = {}
    for entry in positive:
        for requirement in entry.requirements:
            named[requirement] = (*named.get(requirement, ()), entry.name)
    needed = assumed | used.keys()
    unchecked = [d for m in statements(spec) for d in m.definitions if d.tags and (d.module, d.name) not in needed]
    names = frozenset(entry.name for entry in negative)
    properties = tuple(sorted(used.values(), key=lambda d: (d.module, d.line)))
    models_of = {place: tuple(found) for place, found in checking.items()}
    return Controls(properties, controls, names, named, tuple(unchecked), models_of, listed)


def _entries(models: Path) -> dict[str, Entry]:
    """All entries by their names, in the order of these: nothing is to depend on where an entry stands."""
    try:
        return {entry.name: entry for entry in sorted(read(models).entries, key=lambda entry: entry.name)}
    except ManifestError as error:
        raise UnreadableError(str(error)) from error


def _controls(
    folder: Path,
    negative: Sequence[Entry],
    listed: Mapping[str, Entry],
    known: Properties,
    modules: Sequence[Module],
) -> dict[str, Entries]:
    """The negative controls of each requirement, the direct ones first."""
    ruling = {module.name for module in rules(modules)}
    direct: dict[str, list[str]] = {}
    indirect: dict[str, list[str]] = {}
    for entry in negative:
        model, failing = _model(entry, listed), str(entry.expect.property)
        named = known.parts(model, failing, instances=False)
        for requirement in [*entry.requirements, *(tag for d in named for tag in d.tags)]:
            direct.setdefault(requirement, []).append(entry.name)
        changed = [d for d in _changed(folder, entry, modules) if d.module in ruling]
        touched = [*known.parts(model, failing, instances=True), *changed]
        for requirement in [tag for d in touched for tag in d.tags]:
            indirect.setdefault(requirement, []).append(entry.name)
    return {name: entries(direct.get(name, []), indirect.get(name, [])) for name in {**direct, **indirect}}


def _is_negative(entry: Entry) -> bool:
    """As for ``s7spec models``: an entry with a base is a negative control, unless it says otherwise."""
    derived = not isinstance(entry.base, msgspec.UnsetType)
    return derived if isinstance(entry.kind, msgspec.UnsetType) else entry.kind == "negative"


def base_of(entry: Entry, listed: Mapping[str, Entry]) -> Entry:
    """The model that a model or control is derived from, or itself."""
    found = listed.get(str(entry.base))
    return entry if found is None else base_of(found, listed)


def _model(entry: Entry, listed: Mapping[str, Entry]) -> str:
    return str(base_of(entry, listed).module).removesuffix(".tla")


def _config(folder: Path, entry: Entry, listed: Mapping[str, Entry]) -> Cfg:
    base = base_of(entry, listed)
    try:
        return configuration(folder, base, base)
    except ManifestError as error:
        raise UnreadableError(str(error)) from error


def _checked(entry: Entry, cfg: Cfg) -> list[str]:
    invariants = cfg.names("INVARIANT") if isinstance(entry.invariants, msgspec.UnsetType) else entry.invariants
    properties = cfg.names("PROPERTY") if isinstance(entry.properties, msgspec.UnsetType) else entry.properties
    return [*invariants, *properties]


def _changed(folder: Path, entry: Entry, modules: Sequence[Module]) -> list[Definition]:
    changed = []
    for mutation in entry.mutate:
        module = next((m for m in modules if f"{m.name}.tla" == mutation.module), None)
        if module is None or mutation.replace.encode() not in module.text:
            raise UnreadableError(f"{folder}: {entry.name}: its text is not in {mutation.module}")
        changed += module.at(mutation.replace)
    return changed

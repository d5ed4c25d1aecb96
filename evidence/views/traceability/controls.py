"""The models and controls in models/ by requirement: properties that are checked, and negative controls.

A negative control changes a formula so that a model fails. It speaks for the requirements of the property that fails
and those that its entry names. It touches those of the rule that it changes, and those of a whole specification
where the property is that the rules implement it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from evidence.models.entries import read
from evidence.models.manifest import Model, load
from evidence.tla import cfg
from evidence.views.traceability.entries import Entries, entries
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
    entries: dict[str, Model]
    """All models and controls by name, with the description and the requirements that stand there, not in the base."""


def read_controls(folder: Path, spec: Sequence[Module], models: Sequence[Module]) -> Controls:
    """Read the models and controls in a folder and their configurations. Raises ValueError."""
    listed = _listed(folder / MODELS)
    negative = [entry for entry in listed.values() if entry.kind == "negative"]
    positive = [entry for entry in listed.values() if entry.kind != "negative"]
    if not negative:
        raise ValueError(f"{folder / MODELS}: no negative controls")
    known = Properties(spec, models)
    used: dict[tuple[str, str], Definition] = {}
    assumed: set[tuple[str, str]] = set()
    checking: dict[tuple[str, str], dict[str, None]] = {}
    for entry in positive:
        for name in (*entry.invariants, *entry.properties):
            for part in known.parts(entry.module.stem, name, instances=True):
                used[part.module, part.name] = part
                checking.setdefault((part.module, part.name), {})[entry.name] = None
        for name in cfg.parse(entry.config).names("SPECIFICATION"):
            assumed |= {(d.module, d.name) for d in known.parts(entry.module.stem, name, instances=False)}
    controls = _controls(folder, negative, known, (*spec, *models))
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


def _listed(path: Path) -> dict[str, Model]:
    """All entries by their names, in the order of these: nothing is to depend on where an entry stands."""
    models = {model.name: model for model in load(path).models}
    return {
        entry.name: replace(models[entry.name], what=entry.what or "", requirements=tuple(entry.requirements))
        for entry in sorted(read(path).entries, key=lambda entry: entry.name)
    }


def _controls(
    folder: Path, negative: Sequence[Model], known: Properties, modules: Sequence[Module]
) -> dict[str, Entries]:
    """The negative controls of each requirement, the direct ones first."""
    ruling = {module.name for module in rules(modules)}
    direct: dict[str, list[str]] = {}
    indirect: dict[str, list[str]] = {}
    for entry in negative:
        model, failing = entry.module.stem, str(entry.expect.property)
        named = known.parts(model, failing, instances=False)
        for requirement in [*entry.requirements, *(tag for d in named for tag in d.tags)]:
            direct.setdefault(requirement, []).append(entry.name)
        changed = [d for d in _changed(folder, entry, modules) if d.module in ruling]
        touched = [*known.parts(model, failing, instances=True), *changed]
        for requirement in [tag for d in touched for tag in d.tags]:
            indirect.setdefault(requirement, []).append(entry.name)
    return {name: entries(direct.get(name, []), indirect.get(name, [])) for name in {**direct, **indirect}}


def _changed(folder: Path, entry: Model, modules: Sequence[Module]) -> list[Definition]:
    changed = []
    for mutation in entry.mutations:
        module = next(m for m in modules if f"{m.name}.tla" == mutation.module)
        if mutation.replace.encode() not in module.text:
            raise ValueError(f"{folder}: {entry.name}: its text is not in {mutation.module}")
        changed += module.at(mutation.replace)
    return changed

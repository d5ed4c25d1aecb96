"""What a model's result depends on, as a hash: where it is as before, TLC would find the same.

That is every definition that the configuration needs, wherever it stands, without comments and layout, and the model's
entry in the manifest with its pins. The time of a run does not count.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from tree_sitter import Node

from evidence.common.texts import digest
from evidence.models.manifest import Manifest, Model
from evidence.tla import cfg
from evidence.tla.flatten import flatten
from evidence.tla.modules import closure, module_folders, reached, read_modules
from evidence.tla.syntax import Module, code, references
from evidence.tla.tlc import Toolchain
from s7check.resources import modules

PASSED = Path("build/as-pinned.json")
"""The models of a checkout that came as pinned: the hash of what they and their TLC were, and what came."""
FULL = Path("models/full.json")
"""The same of the full lane without its controls, to be committed: they take long, and may be run in parts."""

_STEPS = ("SPECIFICATION", "INIT", "NEXT", "CONSTRAINT", "ACTION_CONSTRAINT")
_CHECKS = ("INVARIANT", "PROPERTY", "VIEW", "SYMMETRY")


def behaviours(model: Model, folder: Path) -> list[str]:
    """The definitions that decide the behaviours of a model of the checkout at `folder`, and its constants."""
    constants = [f"{one.name} {one.operator} {one.value}" for one in cfg.parse(model.config).assignments]
    return [*_needed(model, folder, _STEPS), *sorted(constants)]


def origin(model: Model, folder: Path) -> str:
    """The hash of all that decides what TLC finds for a model of the checkout, and whether it is as pinned."""
    # "()" stands for a field that there was, so that the hashes stay.
    run = [model.config, str(model.deadlock), "()", repr(model.mutations), repr(model.expect)]
    return digest([*_needed(model, folder, _STEPS + _CHECKS), *run])


def kept(models: Iterable[Model], manifest: Manifest, tools: Toolchain) -> dict[str, dict[str, Any]]:
    """What came of the models that came as pinned; of those alone that, with all they depend on, are as they were."""
    passed = _read(_folder(manifest) / PASSED) | _read(_folder(manifest) / FULL)
    return {
        one.name: passed[one.name]["came"]
        for one in models
        if one.name in passed and passed[one.name]["of"] == _key(one, manifest, tools)
    }


def keep(model: Model, came: Mapping[str, Any], manifest: Manifest, tools: Toolchain) -> None:
    """Remember what came of a model that came as pinned. Raises OSError."""
    file = _folder(manifest) / (FULL if model.lane == "full" and model.kind != "negative" else PASSED)
    passed = _read(file) | {model.name: {"of": _key(model, manifest, tools), "came": came}}
    lines = [f" {json.dumps(name)}: {json.dumps(one)}" for name, one in sorted(passed.items())]
    file.parent.mkdir(exist_ok=True)
    new = file.with_suffix(".new")
    new.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
    new.replace(file)  # a run that is killed leaves a whole file


def written(manifest: Manifest) -> tuple[int, ...]:
    """When each module was written: where it is the same after a run, the run was of this text."""
    return _written(_folder(manifest))


def _folder(manifest: Manifest) -> Path:
    return manifest.directory.parent


def _read(file: Path) -> dict[str, dict[str, Any]]:
    return json.loads(file.read_bytes()) if file.exists() else {}


def _key(model: Model, manifest: Manifest, tools: Toolchain) -> str:
    return f"{origin(model, _folder(manifest))} {tools.sha256[:16]}"


@dataclass(frozen=True)
class _Text:
    """A module with all that it extends: its definitions, what has no name, and the names that each definition uses."""

    definitions: Mapping[str, Node]
    unnamed: tuple[Node, ...]
    uses: Mapping[str, frozenset[str]]
    instances: tuple[str, ...]


def _needed(model: Model, folder: Path, keywords: Iterable[str]) -> list[str]:
    """The definitions that these sections of the configuration need, and all that has no name, such as ASSUME."""
    config = cfg.parse(model.config)
    text = _text(model.module.stem, folder, _written(folder))
    roots = [name for keyword in keywords for name in config.names(keyword)]
    roots += [one.value for one in config.assignments if one.operator == "<-"]
    roots += [name for one in model.mutations for name in re.findall(r"\w+", one.by)]
    needed = reached([*roots, *(name for unit in text.unnamed for name in _read_unit(unit)[1])], text.uses)
    units = (*text.unnamed, *(text.definitions[name] for name in needed))
    return sorted([*(read for unit in units if (read := _read_unit(unit)[0])), *text.instances])


_UNITS: dict[bytes, tuple[str, frozenset[str]]] = {}


def _read_unit(unit: Node) -> tuple[str, frozenset[str]]:
    """Its code and the names that it uses, read once: a definition of spec/ stands in the text of every model."""
    text = unit.text or b""
    if text not in _UNITS:
        _UNITS[text] = code(unit), references(unit)
    return _UNITS[text]


def _written(folder: Path) -> tuple[int, ...]:
    """When each module was written: what is remembered of a checkout holds for this state of it."""
    return tuple(file.stat().st_mtime_ns for part in ("models", "spec") for file in modules(folder / part))


@lru_cache
def _text(name: str, folder: Path, written: tuple[int, ...]) -> _Text:
    flat = flatten(name, [folder / "models", *module_folders(folder / "spec")])
    module = Module(flat.name, flat.text.encode())
    named = {unit.id for unit in module.definitions.values()}
    every = _modules(folder, written)
    extended = reached([name], {one: every[one].extends for one in every})
    return _Text(
        module.definitions,
        tuple(unit for unit in module.units if unit.id not in named),
        {defined: _read_unit(unit)[1] for defined, unit in module.definitions.items()},
        tuple(every[one].code for one in sorted(closure(name, every) - extended)),
    )


@lru_cache(maxsize=1)
def _modules(folder: Path, _: tuple[int, ...]) -> dict[str, Module]:
    return read_modules(folder / "models") | read_modules(folder / "spec")

"""The temporary copy of ``spec/`` and ``models/`` that a run works on, with the text of a negative control changed.

Every run has a copy, also one that changes nothing: TLC writes next to its input, and nothing of that is to get
into the repository. The model's module stands there with all that it extends, which TLC starts faster with.
"""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from evidence.models.manifest import Model, Mutation
from evidence.tla.modules import module_folders
from evidence.tla.workspace import Workspace, as_one_module


class StaleMutationError(ValueError):
    """The text that a mutation replaces does not occur exactly once: the manifest is behind the specification."""


def prepare(root: Path, spec: Path, models: Path, model: Model) -> Workspace:
    """Copy the modules below the empty directory `root`, apply the mutations. Raises `StaleMutationError`."""
    _copy_modules(spec, root / "spec")
    _copy_modules(models, root / "models")
    for mutation in model.mutations:
        _apply(root, mutation)
    directory = (root / "models" / model.module).parent
    scratch = root / "scratch"
    scratch.mkdir()
    library = [root / "models", *module_folders(root / "spec")]
    workspace = Workspace(directory, model.module.name, tuple(library), scratch)
    workspace.config.write_text(model.config, encoding="utf-8")
    return as_one_module(workspace)


def _copy_modules(source: Path, target: Path) -> None:
    target.mkdir(parents=True)
    for directory, folders, files in os.walk(source):
        # Directories that tools leave behind can be large and hold old copies of modules.
        folders[:] = sorted(f for f in folders if not f.startswith(".") and f not in ("states", "canaries"))
        for file in files:
            if file.endswith(".tla"):
                copy = target / Path(directory).relative_to(source) / file
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(Path(directory) / file, copy)


def _apply(root: Path, mutation: Mutation) -> None:
    path = next(path for place in ("spec", "models") for path in (root / place).rglob(mutation.module))
    text = path.read_text(encoding="utf-8")
    times = text.count(mutation.replace)
    if times != 1:
        raise StaleMutationError(
            f"stale: {mutation.replace!r} occurs {times} times in {mutation.module}, a mutation needs exactly one"
        )
    path.write_text(text.replace(mutation.replace, mutation.by), encoding="utf-8")

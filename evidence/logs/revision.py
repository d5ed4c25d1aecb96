"""An earlier revision of the project, built in a work tree of its own."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from evidence.common.cases import Case, every_case


class RevisionError(ValueError):
    """There is no such revision; the text names it."""


class BuildError(RuntimeError):
    """A checkout cannot be built or its command fails; the text says how."""


@dataclass(frozen=True)
class Checkout:
    """A checkout after `make setup`. Nothing else of its layout is used."""

    root: Path

    @property
    def s7check(self) -> Path:
        """The command."""
        return self.root / ".venv" / "bin" / "s7check"

    @property
    def models(self) -> Path:
        """The folder of the manifest and the reasons."""
        return self.root / "models"

    def cases(self) -> list[Case]:
        """Its cases; before they were text, an area had a file for each log, and an index. Raises `CasesError`."""
        traces = self.root / "traces"
        indexes = sorted(traces.glob("*/index.json"))
        if indexes:
            return [_of_index(entry, index.parent) for index in indexes for entry in json.loads(index.read_bytes())]
        return every_case(traces)


def _of_index(entry: dict[str, Any], area: Path) -> Case:
    path = area / entry["file"]
    said = entry["verdict"], entry.get("line"), entry["requirements"], entry["reason"]
    return Case(area.name, path.name.partition(".")[0], *said, path.read_bytes(), packed=path.suffix == ".gz")


def find(root: Path, name: str) -> str:
    """The full hash of a revision. Raises `RevisionError`, and `BuildError` without git."""
    run = _git(root, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{name}^{{commit}}")
    if run.returncode:
        raise RevisionError(f"{name}: no such revision in {root}: name a commit, a tag or a branch that is fetched")
    return run.stdout.strip()


def checkout(root: Path, commit: str) -> Checkout:
    """Build a revision below build/since; the work tree of an earlier run is used again. Raises `BuildError`."""
    folder = root / "build" / "since" / commit[:12]
    if not folder.is_dir():
        _git(root, "worktree", "prune")
        run = _git(root, "worktree", "add", "--detach", str(folder), commit)
        if run.returncode:
            raise BuildError(f"git worktree add {folder}: {run.stderr.strip()}")
    # A make that runs this command would give its jobs to the other checkout's.
    alone = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    run = subprocess.run([_tool("make"), "setup"], cwd=folder, capture_output=True, text=True, check=False, env=alone)
    if run.returncode:
        raise BuildError(f"make setup in {folder} ended with exit code {run.returncode}: {run.stderr.strip()[-1000:]}")
    return Checkout(folder)


def _git(root: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([_tool("git"), "-C", str(root), *arguments], capture_output=True, text=True, check=False)


def _tool(name: str) -> str:
    found = shutil.which(name)
    if found is None:
        raise BuildError(f"{name} is not on the PATH")
    return found

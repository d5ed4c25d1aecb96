"""An earlier revision of the project, built in a work tree of its own."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path


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

    def logs(self) -> dict[str, Path]:
        """The logs that it ships, by verdict and file name: a log may move to another folder and stays the same."""
        files = [path for path in (self.root / "traces").rglob("*") if path.is_file()]
        return {f"{p.parent.name}/{p.name}": p for p in sorted(files) if p.parent.name in VERDICT_FOLDERS}


VERDICT_FOLDERS = ("accept", "reject", "unusable")


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

"""A small project with a model of a lamp, for tests of commands that run TLC."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click
from click.testing import CliRunner


def write_lamp(folder: Path, files: Mapping[str, str], states: int, distinct: int, depth: int) -> Path:
    """Write the files and a manifest with the model `lamp` and its counts."""
    manifest = f"""== lamp model smoke MCLamp.tla 0
The lamp burns down.
states {states}, distinct {distinct}, depth {depth}, seconds 0..60, config MCLamp.cfg
"""
    for name, text in {**files, "models/models.txt": manifest}.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text)
    return folder


def run_command(command: click.Command, project: Path, *arguments: str) -> tuple[int, str, dict[str, Any]]:
    """Run a command on the project's manifest; return exit code, output and results."""
    results = project / "results.json"
    results.unlink(missing_ok=True)
    fixed = ["--manifest", str(project / "models" / "models.txt"), "--json", str(results)]
    ran = CliRunner().invoke(command, [*fixed, *arguments])
    return ran.exit_code, ran.output, json.loads(results.read_text()) if results.exists() else {}

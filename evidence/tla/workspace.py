"""Where a run of TLC takes place."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from evidence.tla.flatten import Flat, flatten
from evidence.tla.syntax import SyntaxTreeError

CONFIG_NAME = "harness.cfg"


@dataclass(frozen=True)
class Workspace:
    """Where a run takes place: TLC's directory, its module's file name there, where to look for other modules.

    `scratch` is an empty directory for TLC's own files and Java's temporary ones. `flat` is the module where it stands
    there with all that it extends.
    """

    directory: Path
    module: str
    library: tuple[Path, ...]
    scratch: Path
    flat: Flat | None = None

    @property
    def config(self) -> Path:
        """The configuration file, next to the module."""
        return self.directory / CONFIG_NAME

    def located(self, line: str) -> str:
        """A line of TLC's output with the places of the modules as their authors see them."""
        return self.flat.located(line) if self.flat else line


def as_one_module(space: Workspace) -> Workspace:
    """Put the module's text and that of all that it extends into its file.

    A module that the grammar cannot read stays as it is: TLC says where it is wrong.
    """
    try:
        flat = flatten(space.module.removesuffix(".tla"), [space.directory, *space.library])
    except SyntaxTreeError:
        return space
    (space.directory / space.module).write_text(flat.text, encoding="utf-8")
    return replace(space, flat=flat)

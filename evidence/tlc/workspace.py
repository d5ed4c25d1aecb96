"""Where a run of TLC takes place."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

CONFIG_NAME = "harness.cfg"


@dataclass(frozen=True)
class Workspace:
    """Where a run takes place: TLC's directory, its module's file name there, where to look for other modules.

    `scratch` is an empty directory for TLC's own files and Java's temporary ones.
    """

    directory: Path
    module: str
    library: tuple[Path, ...]
    scratch: Path

    @property
    def config(self) -> Path:
        """The configuration file, next to the module."""
        return self.directory / CONFIG_NAME

"""The programs that tell two sides apart, as files of the kit's folder."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import msgspec

from s7check.asking.variants import Variant
from s7check.kit.program import Program, read_program
from s7check.simulating.separation import Separation

ROOT = Path(__file__).parents[2]
DIFFERENCES = ROOT / "kit" / "differences.ndjson"
EXPERIMENTS = ROOT / "kit" / "experiments.ndjson"


class Side(msgspec.Struct, frozen=True, omit_defaults=True):
    """A CPU, an edition of the manual, or the letter of an ambiguity."""

    cpu: str | None = None
    profile: str | None = None
    letters: tuple[tuple[str, str], ...] = ()

    @property
    def variant(self) -> Variant:
        """The header with this side."""
        said = [self.cpu and f"cpu {self.cpu}", self.profile and f"profile {self.profile}"]
        said += [f"{name} {letter}" for name, letter in self.letters]
        return Variant(", ".join(one for one in said if one), self.cpu, self.profile, self.letters)


class Kept(msgspec.Struct, frozen=True):
    """A program whose log on one side is refused on the other: at ``line``, by ``requirements``.

    ``grounds`` are the requirements by which the one side has the line.
    """

    allowed: Side
    refused: Side
    line: int
    grounds: list[str]
    requirements: list[str]
    program: dict[str, Any]

    def read(self) -> Program:
        """The program."""
        return read_program(json.dumps(self.program).encode())


def kept(found: Separation) -> Kept:
    """A separation to be kept."""
    allowed, refused = (Side(one.cpu, one.profile, one.letters) for one in (found.allowed, found.refused))
    return Kept(allowed, refused, found.line, found.grounds, found.refusal.requirements, found.program.raw)


def read_kept(file: Path) -> list[Kept]:
    """The programs of a file."""
    return [msgspec.json.decode(line, type=Kept) for line in file.read_bytes().splitlines()]


def write_kept(file: Path, all_kept: Iterable[Kept]) -> None:
    """Writes them, one a line."""
    file.write_bytes(b"".join(msgspec.json.encode(one) + b"\n" for one in all_kept))

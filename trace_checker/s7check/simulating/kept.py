"""The logs that are known to tell two sides apart, with their programs, as files."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec

from s7check.asking.variants import Variant
from s7check.engine.client import Engine
from s7check.kit.followed import departure
from s7check.kit.program import Program, read_program
from s7check.kit.whole import as_it_is
from s7check.resources import FOUND
from s7check.simulating.separation import Separation, separation_behind
from s7check.simulating.shortest import Bound

DIFFERENCES = FOUND / "differences.ndjson"
EXPERIMENTS = FOUND / "experiments.ndjson"
GAPS = FOUND / "undecided.ndjson"


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
    """A program with a log on one side that is refused on the other: at its last line, by ``requirements``.

    ``header`` and ``lines`` are that log, the header without what makes the sides. By the ``grounds`` the one side has
    the last line. ``bounds`` say what was searched for a shorter log.
    """

    allowed: Side
    refused: Side
    grounds: list[str]
    requirements: list[str]
    program: dict[str, Any]
    header: dict[str, Any]
    lines: list[dict[str, Any]]
    bounds: list[Bound] = []

    @property
    def name(self) -> str:
        """That of the program."""
        return str(self.program["name"])

    @property
    def line(self) -> int:
        """The number of the line that is refused."""
        return len(self.lines) + 1

    def again(self, engine: Engine) -> Separation | None:
        """The separation that is kept, if it still is one."""
        sides = self.allowed.variant, self.refused.variant
        found = separation_behind(engine, self.read(), self.header, self.lines, *sides)
        texts = [msgspec.json.encode(line) for line in (self.header, *self.lines)]
        log = as_it_is(engine, texts)
        begun = replace(self.read(), duration=log.until + 1)
        return found if found is not None and found.line == self.line and not departure(engine, begun, log) else None

    def read(self) -> Program:
        """The program."""
        return read_program(json.dumps(self.program).encode())


class Gap(msgspec.Struct, frozen=True):
    """Two letters of an ambiguity that no log is known to tell apart, and what was searched.

    Not ``searched``: the question is newer than the last search.
    """

    ambiguity: str
    letters: tuple[str, str]
    bounds: list[Bound]
    header: dict[str, Any] = {}
    searched: bool = True


def kept(found: Separation, bounds: Iterable[Bound] = ()) -> Kept:
    """A separation to be kept."""
    allowed, refused = (Side(one.cpu, one.profile, one.letters) for one in (found.allowed, found.refused))
    return Kept(
        allowed,
        refused,
        found.grounds,
        found.refusal.requirements,
        found.program.raw,
        found.header,
        found.log[1:],
        list(bounds),
    )


def read_kept(file: Path) -> list[Kept]:
    """The programs of a file."""
    return [msgspec.json.decode(line, type=Kept) for line in file.read_bytes().splitlines()]


def known(first: Variant, second: Variant) -> list[Kept]:
    """Those of two sides, in either direction, the shorter ones first."""
    both = {_what(first), _what(second)}
    found = [
        one
        for file in (DIFFERENCES, EXPERIMENTS)
        for one in read_kept(file)
        if {_what(one.allowed.variant), _what(one.refused.variant)} == both
    ]
    return sorted(found, key=lambda one: one.line)


def _what(side: Variant) -> tuple[object, ...]:
    return side.cpu, side.profile, side.letters


def read_gaps() -> list[Gap]:
    """The pairs of letters without an experiment."""
    return [msgspec.json.decode(line, type=Gap) for line in GAPS.read_bytes().splitlines()]


def write_kept(file: Path, all_kept: Iterable[Kept] | Iterable[Gap]) -> None:
    """Writes them, one a line."""
    file.write_bytes(b"".join(msgspec.json.encode(one) + b"\n" for one in all_kept))

"""What a run of the kit was: of which tool, specification and programs, on which implementation, when and how."""

from __future__ import annotations

import hashlib
import shlex
from collections.abc import Iterable, Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import msgspec

from s7check.engine.contents import contents
from s7check.kit.program import Program
from s7check.resources import SPECIFICATION, modules
from s7check.version import __version__


class Run(msgspec.Struct, frozen=True):
    """A run: versions and hashes, 16 digits each; ``implementation`` as its user names it; ``offer`` is the object of
    its file, ``readings`` the chosen ones; ``date`` is UTC.
    """

    tool: str = ""
    specification: str = ""
    programs: str = ""
    implementation: str = ""
    command: str = ""
    offer: dict[str, Any] = {}
    profile: str = ""
    readings: dict[str, str] = {}
    date: str = ""

    def told(self) -> list[tuple[str, str]]:
        """Names and values, for people, without what is empty."""
        fields = {name: getattr(self, name) for name in self.__struct_fields__}
        chosen = ", ".join(f"{name}={letter}" for name, letter in self.readings.items())
        offer = msgspec.json.encode(self.offer).decode() if self.offer else ""
        return [(name, str(value)) for name, value in (fields | {"readings": chosen, "offer": offer}).items() if value]


def this_run(
    programs: Iterable[Program],
    implementation: str,
    command: Sequence[str],
    offer: Path | None,
    profile: str | None,
    readings: Mapping[str, str],
) -> Run:
    """The run that begins now. Raises OSError."""
    lines = sorted(program.plain_line() for program in programs)
    return Run(
        tool=__version__,
        specification=contents(modules(SPECIFICATION))[:16],
        programs=hashlib.sha256(b"\n".join(lines)).hexdigest()[:16],
        implementation=implementation,
        command=shlex.join(command),
        offer=msgspec.json.decode(offer.read_bytes()) if offer is not None else {},
        profile=profile or "",
        readings=dict(readings),
        date=datetime.now(UTC).isoformat(timespec="seconds"),
    )

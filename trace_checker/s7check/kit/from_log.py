"""A log turned into a program: its calls become the bodies of OBs, the rest of its cause comes from outside."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from s7check.engine.client import Engine
from s7check.kit.program import FORMAT

Json = dict[str, Any]


def program_of(
    engine: Engine, lines: Iterable[bytes], name: str, about: str, requirements: list[str], **more: object
) -> Json:
    """The program of a log whose lines can be read; ``more`` are further fields. Raises UnusableLogError."""
    made = engine.program_of(b"\n".join(line for line in lines if line.strip()))
    return {"format": FORMAT, "name": name, "about": about, "requirements": requirements, **more, **made}

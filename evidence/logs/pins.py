"""The pins of a checkout: results of its models, reasons for survivors and for missing witnesses."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TypeVar

import msgspec

from evidence.logs.revision import Checkout

REASONS = {"survivor": "survivors.json", "witness": "witnesses.json"}


Form = TypeVar("Form")


class PinsError(ValueError):
    """A file of pins or reasons cannot be read; the text names it."""


class _Entry(msgspec.Struct):
    """An entry of the manifest, as far as two revisions are compared."""

    name: str
    expect: dict[str, Any]


class _Manifest(msgspec.Struct):
    models: list[_Entry]


class _Reason(msgspec.Struct):
    id: str
    reason: str


def pinned(checkout: Checkout) -> dict[str, str]:
    """The pinned result of each model and negative control, in one line. Raises `PinsError`."""
    manifest = _read(checkout.models / "manifest.json", _Manifest)
    return {e.name: ", ".join(f"{field} {value}" for field, value in sorted(e.expect.items())) for e in manifest.models}


def reasons(checkout: Checkout, kind: str) -> dict[str, str]:
    """The reason of each id. Raises `PinsError`."""
    return {entry.id: entry.reason for entry in _read(checkout.models / REASONS[kind], list[_Reason])}


def _read(path: Path, form: type[Form]) -> Form:
    try:
        return msgspec.json.decode(path.read_bytes(), type=form)
    except (OSError, msgspec.MsgspecError) as error:
        raise PinsError(f"{path}: {error}") from error

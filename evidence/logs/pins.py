"""The pins of a checkout: results of its models, reasons for survivors and for missing witnesses."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TypeVar

import msgspec

from evidence.logs.revision import Checkout
from evidence.models.entries import ManifestError, read

REASONS = {"survivor": "survivors.json", "witness": "witnesses.json"}


Form = TypeVar("Form")


class PinsError(ValueError):
    """A file of pins or reasons cannot be read; the text names it."""


class _Entry(msgspec.Struct):
    """An entry of the manifest of an older revision, as far as two revisions are compared."""

    name: str
    expect: dict[str, Any]


class _Manifest(msgspec.Struct):
    models: list[_Entry]


class _Reason(msgspec.Struct):
    id: str
    reason: str


def pinned(checkout: Checkout) -> dict[str, str]:
    """The pinned result of each model and negative control, in one line. Raises `PinsError`."""
    pins = {name: sorted(expect.items()) for name, expect in _expected(checkout.models)}
    return {name: ", ".join(f"{field} {value}" for field, value in fields) for name, fields in pins.items()}


def _expected(models: Path) -> list[tuple[str, dict[str, Any]]]:
    """The pins of each model by their fields; before they were text, the manifest was JSON."""
    older = models / "manifest.json"
    if older.is_file():
        return [(entry.name, entry.expect) for entry in _read(older, _Manifest).models]
    try:
        entries = read(models / "models.txt").entries
    except ManifestError as error:
        raise PinsError(str(error)) from error
    return [(entry.name, msgspec.to_builtins(entry.expect)) for entry in entries]


def reasons(checkout: Checkout, kind: str) -> dict[str, str]:
    """The reason of each id. Raises `PinsError`."""
    return {entry.id: entry.reason for entry in _read(checkout.models / REASONS[kind], list[_Reason])}


def _read(path: Path, form: type[Form]) -> Form:
    try:
        return msgspec.json.decode(path.read_bytes(), type=form)
    except (OSError, msgspec.MsgspecError) as error:
        raise PinsError(f"{path}: {error}") from error

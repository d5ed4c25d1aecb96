"""The header of the log: facts of the source, completed by the user."""

from typing import Any

from s7check.importing.errors import SourceError, in_field
from s7check.log.calls import LOG_FORMAT

_OPTIONS = {"cpu": "--cpu", "obs": "--obs", "mode": "--mode"}
"""Required fields -> the options that give them."""


def complete(told: dict[str, Any], given: dict[str, Any]) -> dict[str, Any]:
    """The header of fields ``told`` by the source and ``given`` by the user, whose word counts.

    The mode is required here: its default in the format, STOP, would claim what nobody said.
    """
    header = {"format": LOG_FORMAT, **told, **given}
    for field, option in _OPTIONS.items():
        if field not in header:
            expected = f"it from {option} or --header, since the source does not tell it"
            raise SourceError(in_field("header", field), expected, "none")
    return header

"""The whole log as text, read back so that nothing unusable is ever written."""

import json
from collections.abc import Sequence
from typing import Any

from s7check.engine import pool
from s7check.importing.errors import SourceError, in_field
from s7check.importing.recording import Placed


def render(header: dict[str, Any], events: Sequence[Placed]) -> bytes:
    """The log; raises SourceError with the place of the first event that the format does not allow."""
    lines = [header, *(placed.event for placed in events)]
    text = "".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines).encode()
    with pool.engine() as engine:
        unusable = engine.read(text).unusable
    if unusable is not None:
        place = "header" if unusable.line <= 1 else events[unusable.line - 2].place
        raise SourceError(in_field(place, unusable.field), unusable.expected, unusable.found)
    return text

"""The whole log as text, read back so that nothing unusable is ever written."""

import json
from collections.abc import Sequence
from typing import Any

from s7check.importing.errors import SourceError, in_field
from s7check.importing.recording import Placed
from s7check.log.errors import UnusableLogError
from s7check.log.reader import read_log


def render(header: dict[str, Any], events: Sequence[Placed]) -> bytes:
    """The log; raises SourceError with the place of the first event that the format does not allow."""
    lines = [header, *(placed.event for placed in events)]
    text = "".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines).encode()
    try:
        for _ in read_log([text]):
            pass
    except UnusableLogError as error:
        place = "header" if error.line <= 1 else events[error.line - 2].place
        raise SourceError(in_field(place, error.field), error.expected, error.found) from error
    return text

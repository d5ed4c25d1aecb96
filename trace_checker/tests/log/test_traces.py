"""The project's example logs, read without judging them."""

from pathlib import Path

import pytest

from evidence.common.cases import Case
from tests.log.reading import content
from tests.shipped import CASES, TRACES


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_read(case: Case) -> None:
    """Unusable logs fail at the line of their case, all others can be read."""
    log = Path(TRACES / case.file)
    if log.suffix != ".gz":
        read = content(log.read_bytes())
        assert (read.unusable and read.unusable.line) == (case.line if case.verdict == "unusable" else None)
        assert read.events or case.verdict == "unusable"

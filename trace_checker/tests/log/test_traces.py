"""The project's example logs, read without judging them."""

import pytest

from evidence.common.cases import Case
from s7check.log.errors import UnusableLogError
from s7check.log.reader import read_log
from s7check.log.source import open_log
from tests.shipped import CASES, TRACES


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_read(case: Case) -> None:
    """Unusable logs fail at the line of their case, all others can be read."""
    with open_log(str(TRACES / case.file)) as source:
        batches = read_log(source.chunks())
        if case.verdict != "unusable":
            assert sum(len(batch.events) for batch in batches)
            return
        with pytest.raises(UnusableLogError) as caught:
            list(batches)
    assert caught.value.line == case.line

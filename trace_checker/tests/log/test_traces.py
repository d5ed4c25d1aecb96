"""The project's example logs, read without judging them."""

from typing import Any

import pytest

from s7check.log.errors import UnusableLogError
from s7check.log.reader import read_log
from s7check.log.source import open_log
from tests.shipped import INDEX, TRACES


@pytest.mark.parametrize("entry", INDEX, ids=lambda entry: entry["file"])
def test_read(entry: dict[str, Any]) -> None:
    """Unusable logs fail at the line of the index, all others can be read."""
    with open_log(str(TRACES / entry["file"])) as source:
        batches = read_log(source.chunks())
        if entry["verdict"] != "unusable":
            assert sum(len(batch.events) for batch in batches)
            return
        with pytest.raises(UnusableLogError) as caught:
            list(batches)
    assert caught.value.line == entry["line"]

"""The project's example logs, read without judging them."""

from pathlib import Path

from tests.log.reading import content
from tests.shipped import CASES, TRACES


def test_read() -> None:
    """Unusable logs fail at the line of their case, all others can be read."""
    wrong = []
    for case in CASES:
        log = Path(TRACES / case.file)
        if log.suffix == ".gz":
            continue
        read = content(log.read_bytes())
        line = read.unusable and read.unusable.line
        if line != (case.line if case.verdict == "unusable" else None) or not (line or read.events):
            wrong.append((case.id, case.line, line))
    assert wrong == []

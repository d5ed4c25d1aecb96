"""The cases of the project, written out as logs for these tests."""

import atexit
import shutil
import tempfile
from pathlib import Path

from evidence.common.cases import TRACES as SOURCES
from evidence.common.cases import all_cases

SCHEMA = SOURCES / "schema" / "s7-interrupt-log-1.schema.json"

CASES = all_cases()

TRACES = Path(tempfile.mkdtemp(prefix="s7check-traces-"))
"""The folder of the logs: a case's is ``TRACES / case.file``."""
atexit.register(shutil.rmtree, TRACES, ignore_errors=True)
for each in CASES:
    each.put(TRACES)


def log_of(name: str) -> Path:
    """The log of the case with this name."""
    (found,) = (case for case in CASES if case.name == name)
    return TRACES / found.file

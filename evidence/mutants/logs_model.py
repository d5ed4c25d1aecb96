"""The shipped logs as a model for TLC.

The trace checker's engine has none of TLC's registers, which hold the marks. Every log that it accepts, and no other,
has to be consumed to its end.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory

from evidence.common.cases import Case, every_case
from evidence.models.entries import Expect
from evidence.models.manifest import Model
from evidence.tla import log_as_tla

NAME = "logs"
MODULE = "ShippedLogs"
_HEAP_MB = 4000
"""The logs are six megabytes of TLA+."""

_CONSUMED = 'Consumed == index > Len(Logs[log].events) => Out!PrintT(<<"consumed", log>>)'
_SAID = re.compile(r'<<"consumed", (\d+)>>')


def model(timeout: float) -> Model:
    """The model whose module `module` writes."""
    return Model(
        name=NAME,
        kind="model",
        lane="ci",
        what="The shipped logs.",
        requirements=(),
        module=PurePosixPath(f"{MODULE}.tla"),
        config=f"{log_as_tla.CONFIGURATION}INVARIANT Consumed\n",
        mutations=(),
        deadlock=False,
        workers=1,
        brief=False,
        heap=_HEAP_MB,
        seconds=(0.0, timeout),
        expect=Expect(exit=0),
    )


def readable(traces: Path) -> list[Case]:
    """The cases whose log can be read, those judged by hand among them. Raises OSError, `CasesError`."""
    return [case for case in every_case(traces) if case.verdict != "unusable"]


def module(cases: Sequence[Case]) -> str:
    """A module with the logs of these cases."""
    with TemporaryDirectory(prefix="s7check-") as folder:
        return log_as_tla.module(MODULE, [case.put(Path(folder)) for case in cases], _CONSUMED)


def differences(output: str, cases: Sequence[Case]) -> list[str]:
    """The cases whose log TLC consumes though it has to be rejected, or the other way round."""
    consumed = {int(number) for number in _SAID.findall(output)}
    return [case.id for number, case in enumerate(cases, 1) if (number in consumed) != (case.verdict == "accepted")]

"""The shipped logs as a model for TLC.

The trace checker's engine has none of TLC's registers, which hold the marks. Every log that it accepts, and no other,
has to be consumed to its end.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path, PurePosixPath

from evidence.common.shipped import Shipped, shipped_logs
from evidence.models.manifest import HEAP_MB, Expect, Model
from evidence.tla import log_as_tla

NAME = "logs"
MODULE = "ShippedLogs"

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
        heap=HEAP_MB,
        args=(),
        seconds=(0.0, timeout),
        expect=Expect(exit=0),
    )


def readable(traces: Path) -> list[Shipped]:
    """The logs of the index that can be read. Raises OSError or `msgspec.MsgspecError`."""
    return [log for log in shipped_logs(traces) if log.verdict != "unusable"]


def module(traces: Path, logs: Sequence[Shipped]) -> str:
    """A module with these logs."""
    return log_as_tla.module(MODULE, [traces / log.file for log in logs], _CONSUMED)


def differences(output: str, logs: Sequence[Shipped]) -> list[str]:
    """The logs that TLC consumes though the index says that they are rejected, or the other way round."""
    consumed = {int(number) for number in _SAID.findall(output)}
    return [log.file for number, log in enumerate(logs, 1) if (number in consumed) != (log.verdict == "accepted")]

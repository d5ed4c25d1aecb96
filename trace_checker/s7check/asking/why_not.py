"""Why a line may not come after a log."""

from collections.abc import Mapping
from typing import Any

import msgspec

from s7check.asking.log_prefix import Prefix
from s7check.asking.next_answer import opened
from s7check.engine.answer import Answer
from s7check.engine.client import Engine
from s7check.judging.check import rejection
from s7check.judging.replay import Replay, with_readings
from s7check.report.report import Report


def why_not(
    engine: Engine, prefix: Prefix, event: Mapping[str, Any], until: float | None = None
) -> tuple[int, dict[str, Any], Report | None]:
    """The number of the last possible line of the log, the event as a line behind it, and why it may not come.

    Without a report it may. The report has other readings, as many as are tried until that time of
    ``time.monotonic``. Raises UnusableLogError for an event that is not of the format.
    """
    session, last, _ = opened(engine, prefix)
    line = {"at": session.clock, **event}
    if str(line.get("event")).isupper():
        line.setdefault("ret", None)
    refusal = session.why(line)
    session.close()
    if refusal is None:
        return last, line, None
    lines = [*prefix.texts[:last], msgspec.json.encode(line)]
    answer = Answer("rejected", last + 1, message=refusal.message)
    report = rejection(prefix.name, answer, refusal, lines[-1], lines)
    return last, line, with_readings(report, engine, Replay("-", lines), until)

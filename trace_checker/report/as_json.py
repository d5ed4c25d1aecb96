"""One JSON object a log."""

import msgspec

from trace_checker.verdict import Report


def to_json(report: Report) -> bytes:
    """The report as one line of JSON, without its end; a rejected event is the log's own text."""
    return msgspec.json.encode(
        {
            "log": report.log,
            "verdict": report.verdict,
            "line": report.line,
            "events": report.events,
            "event": None if report.event is None else msgspec.Raw(report.event.strip()),
            "expected": report.expected,
            "requirements": report.requirements,
            "message": report.message,
        }
    )

"""A JSON object for each log."""

from typing import Any

import msgspec

from s7check.report.clauses import clause, named
from s7check.report.report import Report


def to_json(report: Report) -> bytes:
    """The report as one line of JSON, without its end; a rejected event is the log's own text."""
    return msgspec.json.encode(
        {
            "log": report.log,
            "verdict": report.verdict,
            "line": report.line,
            "events": report.events,
            "event": None if report.event is None else msgspec.Raw(report.event.strip().replace(b"\r", b" ")),
            "expected": report.expected,
            "requirements": report.requirements,
            "message": report.message,
            **({} if report.certain_from is None else {"certain_from": report.certain_from}),
            **(_explanation(report) if report.verdict == "rejected" else {}),
            **({"after": report.after} if report.after else {}),
            **({"decided": report.decided, "decidable": report.decidable} if report.decidable else {}),
            **({} if report.readings is None else {"readings": _readings(report), "untried": report.untried}),
        }
    )


def _explanation(report: Report) -> dict[str, Any]:
    return {
        **({} if report.after else {"prefix": {"first": 1, "last": report.line}}),
        "why": report.why,
        "late": report.late,
        "clauses": [_clause(name) for name in report.requirements],
        "candidates": report.candidates,
        "states": report.states,
        "situations": [state.said for state in report.situations],
    }


def _clause(name: str) -> dict[str, Any]:
    found = clause(name)
    return {**msgspec.to_builtins(found), "place": found.place}


def _readings(report: Report) -> list[dict[str, Any]]:
    return [
        {
            "change": one.change,
            "verdict": one.verdict,
            "line": one.line,
            "place": next((clause(name).place for name in named(one.change)), None),
        }
        for one in report.readings or []
    ]

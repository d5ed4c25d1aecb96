"""SARIF 2.1.0, for code hosts and editors that show results beside lines."""

from collections.abc import Sequence
from pathlib import PurePath
from typing import Any
from urllib.parse import quote

import msgspec

from s7check import __version__
from s7check.report.clauses import clause
from s7check.report.report import Report, message, parts, source

_SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_UNUSABLE = "unusable-log"
_NO_VERDICT = "no-verdict"
_OWN_RULES = {
    _UNUSABLE: "The log is not of the format s7-interrupt-log/1.",
    _NO_VERDICT: "The check could not be done.",
}


def to_sarif(reports: Sequence[Report]) -> bytes:
    """All reports as one run; accepted logs have no result."""
    results = [(report, _rule_of(report)) for report in reports if report.verdict != "accepted"]
    rules = sorted({rule for _, rule in results} | {name for report, _ in results for name in report.requirements})
    driver = {
        "name": "s7check",
        "semanticVersion": __version__,
        "rules": [_rule(name) for name in rules],
    }
    document = {
        "$schema": _SCHEMA,
        "version": "2.1.0",
        "runs": [
            {
                "tool": {"driver": driver},
                "columnKind": "utf16CodeUnits",
                "results": [_result(report, rule, rules.index(rule)) for report, rule in results],
            }
        ],
    }
    return msgspec.json.format(msgspec.json.encode(document), indent=2) + b"\n"


def _rule_of(report: Report) -> str:
    if report.verdict == "rejected":
        return report.requirements[0] if report.requirements else "rejected"
    return _UNUSABLE if report.verdict == "unusable" else _NO_VERDICT


def _rule(name: str) -> dict[str, Any]:
    found = clause(name)
    text = _OWN_RULES.get(name) or found.text or name
    return {
        "id": name,
        "shortDescription": {"text": text},
        "fullDescription": {"text": f"{text} ({found.source})" if found.source else text},
        **({"help": {"text": f"{text} See {found.place}."}} if found.text else {}),
    }


def _result(report: Report, rule: str, index: int) -> dict[str, Any]:
    lines = [message(report)]
    for part in parts(report):
        lines += [f"{part.heading}: {line}" if part.heading else line for line in part.lines]
    location: dict[str, Any] = {"artifactLocation": {"uri": _uri(report.log)}}
    if report.line is not None:
        location["region"] = {"startLine": report.line}
        if report.event is not None:
            location["region"]["snippet"] = {"text": source(report.event)}
    return {
        "ruleId": rule,
        "ruleIndex": index,
        "level": "warning" if rule == _NO_VERDICT else "error",
        "message": {"text": "\n".join(lines)},
        "locations": [{"physicalLocation": location}],
        "properties": {"requirements": report.requirements, "events": report.events},
    }


def _uri(name: str) -> str:
    return "stdin" if name == "-" else quote(PurePath(name).as_posix())

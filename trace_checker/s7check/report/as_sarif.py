"""SARIF 2.1.0, for code hosts and editors that show results beside lines."""

import os
from collections.abc import Sequence
from hashlib import sha256
from pathlib import PurePath
from typing import Any
from urllib.parse import quote

import msgspec

from s7check.report.clauses import Clause, clause
from s7check.report.report import Report, cause, message, parts, source
from s7check.resources import RULES
from s7check.version import __version__

_SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_UNUSABLE = "unusable-log"
_NO_VERDICT = "no-verdict"
_DOCUMENTS = "S7CHECK_DOCUMENTS"
"""The environment variable with the address under which code hosts show the folder of the documents."""

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
        **({"help": {"text": f"{text} See {found.place}."}, "helpUri": _address(found)} if found.text else {}),
    }


def _address(found: Clause) -> str:
    """Where the clause can be read: at the address that the environment names, else in this installation."""
    base = os.environ.get(_DOCUMENTS) or RULES.absolute().as_uri()
    return f"{base.rstrip('/')}/{PurePath(found.place).name}"


def _result(report: Report, rule: str, index: int) -> dict[str, Any]:
    lines = [message(report)]
    for part in parts(report):
        lines += [f"{part.heading}: {line}" if part.heading else line for line in part.lines]
    return {
        "ruleId": rule,
        "ruleIndex": index,
        "level": "warning" if rule == _NO_VERDICT else "error",
        "message": {"text": "\n".join(lines)},
        "locations": [_location(report, report.line, report.event)],
        "partialFingerprints": {"s7checkCause/v1": _fingerprint(report, rule)},
        **_flow(report),
        "properties": {"requirements": report.requirements, "events": report.events},
    }


def _location(report: Report, line: int | None, text: bytes | None) -> dict[str, Any]:
    location: dict[str, Any] = {"artifactLocation": {"uri": _uri(report.log)}}
    if line is not None:
        location["region"] = {"startLine": line} | ({} if text is None else {"snippet": {"text": source(text)}})
    return {"physicalLocation": location}


def _fingerprint(report: Report, rule: str) -> str:
    """The same for a rejection that other lines before it have moved, at other times: its file, cause and event."""
    try:
        event = msgspec.json.decode(report.event or b"{}", type=dict[str, Any])
    except msgspec.MsgspecError:
        event = {}
    timeless = {name: value for name, value in event.items() if name not in ("at", "up")}
    told = [report.log, rule, *cause(report), report.expected, timeless]
    return sha256(msgspec.json.encode(told, order="sorted")).hexdigest()[:32]


def _flow(report: Report) -> dict[str, Any]:
    """The lines that lead to the rejected one, which is the last."""
    if not report.flow:
        return {}
    places = [
        {
            "location": _location(report, number, text) | {"message": {"text": source(text)}},
            "importance": "essential" if number == report.line else "important",
        }
        for number, text in report.flow
    ]
    return {"codeFlows": [{"threadFlows": [{"locations": places}]}]}


def _uri(name: str) -> str:
    return "stdin" if name == "-" else quote(PurePath(name).as_posix())

"""JUnit's XML, a test case a log."""

from collections.abc import Sequence
from xml.etree import ElementTree as Xml

from s7check.report.report import Report, message, parts, place, source

_KINDS = {"rejected": "failure", "unusable": "error", "no verdict": "error"}


def to_junit(reports: Sequence[Report]) -> bytes:
    """All reports as one document."""
    kinds = [_KINDS.get(report.verdict) for report in reports]
    counts = {
        "tests": str(len(reports)),
        "failures": str(kinds.count("failure")),
        "errors": str(kinds.count("error")),
        "skipped": "0",
    }
    counts["time"] = f"{sum(report.seconds for report in reports):.3f}"
    root = Xml.Element("testsuites", counts)
    suite = Xml.SubElement(root, "testsuite", {"name": "s7check trace", **counts})
    for report, kind in zip(reports, kinds, strict=True):
        name = place(report) if report.line is None else place(report).rsplit(":", 1)[0]
        case = Xml.SubElement(
            suite, "testcase", {"classname": "s7check.trace", "name": name, "time": f"{report.seconds:.3f}"}
        )
        if kind is None:
            if report.certain_from is not None:
                Xml.SubElement(case, "system-out").text = message(report)
            continue
        of = Xml.SubElement(case, kind, {"type": report.verdict, "message": f"{place(report)}: {message(report)}"})
        of.text = _text(report)
    Xml.indent(root)
    # Characters that XML cannot hold were escaped when the lines were made printable.
    document: bytes = Xml.tostring(root, encoding="utf-8", xml_declaration=True)
    return document + b"\n"


def _text(report: Report) -> str:
    lines = [] if report.event is None else [source(report.event)]
    for part in parts(report):
        lines += [f"{part.heading}: {line}" if part.heading else line for line in part.lines]
    return "\n".join(lines)

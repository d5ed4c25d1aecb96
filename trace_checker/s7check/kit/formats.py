"""The results of a run as text, JSON, JUnit, HTML and a badge."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from importlib.resources import files
from xml.etree import ElementTree as Xml

import click
import msgspec

from s7check.api import check
from s7check.engine import pool
from s7check.engine.command import EngineError
from s7check.judging.replay import Replay, with_steps
from s7check.kit.clusters import to_lines, told_status
from s7check.kit.results import FAILED, STATES, UNDER_ANOTHER, Kept, Outcome, Result, outcomes
from s7check.report.as_html import Sections, clauses
from s7check.report.clauses import by_area, clause
from s7check.report.markup import Node, document, node
from s7check.report.report import Report
from s7check.report.timeline import legend

_COLOURS = {
    "passed": "green",
    "failed": "red",
    UNDER_ANOTHER: "cyan",
    "skipped": "yellow",
    "no verdict": "magenta",
    "not reached": "blue",
}


_SHOWN = 6
"""Programs named for a requirement."""


def to_summary(results: Sequence[Result]) -> str:
    """The failures by their causes, ten lines at most, and how many programs and requirements passed."""
    failed = [click.style(line, fg=_COLOURS["failed"]) for line in to_lines(results)]
    return "\n".join([*failed, _programs(results), _requirements(outcomes(results))])


def to_text(kept: Kept) -> str:
    """What was run, failed programs with their reports, then the requirements."""
    results = kept.programs
    lines = [f"{name}: {value}" for name, value in kept.run.told()]
    for result in results:
        if _not_kept(result):
            said = click.style(told_status(result), fg=_COLOURS[result.status], bold=True)
            lines.append(f"{result.name}: {said}: {result.reason}")
            lines += [f"    {line}" for line in result.report.splitlines()]
    requirements = kept.requirements
    lines += [_programs(results), _requirements(requirements)]
    for state in ("failed", UNDER_ANOTHER, "skipped"):
        if named := [one for one in requirements if one.state == state]:
            lines.append(f"  {_coloured(state)}:")
            lines += [f"    {_outcome(one)}" for one in named]
    if left := [one.requirement for one in requirements if one.state == "not reached"]:
        lines.append(f"  {_coloured('not reached')}: {by_area(left)}")
    return "\n".join(lines)


def _not_kept(result: Result) -> bool:
    return result.status in FAILED or result.status == "no verdict"


def _coloured(state: str) -> str:
    return click.style(state, fg=_COLOURS[state], bold=True)


def _programs(results: Sequence[Result]) -> str:
    counts = Counter(result.status for result in results)
    listed = ", ".join(f"{counts[status]} {_coloured(status)}" for status in _COLOURS if counts[status])  # type: ignore[index]
    return f"{len(results)} programs: {listed or 'none'}"


def _requirements(requirements: Sequence[Outcome]) -> str:
    # Questions that failed are no requirements: they are listed, and the total is that of the documents.
    own = [one for one in requirements if not one.requirement.startswith("AMB")]
    counts = Counter(one.state for one in own)
    listed = ", ".join(f"{counts[state]} {_coloured(state)}" for state in STATES if counts[state])
    return f"{len(own)} requirements: {listed}"


def _outcome(one: Outcome) -> str:
    programs = one.failed or one.under
    names, more = programs[:_SHOWN], len(programs) - _SHOWN
    said = "; ".join(one.reasons) if one.state == "skipped" else ", ".join(names)
    return f"{one.requirement}: {said}" + (f" and {more} more" if more > 0 else "")


def to_json(kept: Kept) -> bytes:
    """One object: the run, the programs and the requirements."""
    return msgspec.json.format(msgspec.json.encode(kept), indent=1) + b"\n"


def to_junit(kept: Kept) -> bytes:
    """A test case a program; the run as properties. A failure that passes under another reading has that as type."""
    results = kept.programs
    counts = Counter(result.status for result in results)
    numbers = {
        "tests": str(len(results)),
        "failures": str(sum(counts[status] for status in FAILED)),
        "errors": str(counts["no verdict"]),
        "skipped": str(counts["skipped"]),
    }
    root = Xml.Element("testsuites", numbers)
    suite = Xml.SubElement(root, "testsuite", {"name": "s7check kit run", **numbers})
    properties = Xml.SubElement(suite, "properties")
    for name, value in kept.run.told():
        Xml.SubElement(properties, "property", {"name": name, "value": value})
    Xml.SubElement(properties, "property", {"name": UNDER_ANOTHER, "value": str(counts[UNDER_ANOTHER])})
    kinds = {"failed": "failure", UNDER_ANOTHER: "failure", "no verdict": "error", "skipped": "skipped"}
    for result in results:
        area = result.name.split("-")[0]
        attributes = {"classname": f"s7check.kit.{area}", "name": result.name, "time": f"{result.seconds:g}"}
        case = Xml.SubElement(suite, "testcase", attributes)
        if kind := kinds.get(result.status):
            said = {"message": result.reason}
            if result.status == UNDER_ANOTHER:
                said = {"type": UNDER_ANOTHER, "message": f"{told_status(result)}; {result.reason}"}
            Xml.SubElement(case, kind, said).text = result.report
    Xml.indent(root)
    written: bytes = Xml.tostring(root, encoding="utf-8", xml_declaration=True)
    return written + b"\n"


def to_html(kept: Kept) -> bytes:
    """A page: the requirements with the programs about them, and the failed programs with their reports.

    Of a failed program that has a reduced log the page shows its timeline and explains its verdict.
    """
    results, requirements = kept.programs, kept.requirements
    style = (files("s7check.report") / "report.css").read_text(encoding="utf-8")
    failed = [result for result in results if _not_kept(result)]
    small = {result.name: report for result in failed if result.reduced and (report := _followed(result))}
    named = {report.requirements[0]: name for name, report in reversed(small.items())}
    sections = Sections()
    failures = [
        _failure(result, sections.made(place, small[result.name]) if result.name in small else _same_as(result, named))
        for place, result in enumerate(failed)
    ]
    return document(
        "s7check kit run",
        style,
        "",
        node("h1", "Conformance to the S7-300/400 interrupt functions"),
        node("table", *(node("tr", node("td", name), node("td", value)) for name, value in kept.run.told())),
        node("p", click.unstyle(_programs(results))),
        node("p", click.unstyle(_requirements(requirements))),
        *([legend()] if sections.pictures else []),
        *failures,
        node("h2", "Requirements"),
        node("table", *map(_row, requirements)),
        *clauses(list(small.values())),
    )


def _followed(result: Result) -> Report | None:
    """The verdict about the reduced log, with the situations after its lines; none if the engine fails."""
    report = check(result.reduced.splitlines(), name="reduced log")
    with pool.engine() as engine, suppress(EngineError):
        return with_steps(report, engine, Replay("-", report.lines)) if report.verdict == "rejected" else None
    return None


def _same_as(result: Result, named: Mapping[str, str]) -> Node | None:
    """Where a reduced log is shown that is rejected for the same requirement."""
    name = next((named[requirement] for requirement in result.deciding if requirement in named), None)
    if name is None:
        return None
    return node("p", "A reduced log that is rejected for the same requirement: ", node("a", name, href=f"#{name}"))


_CLASSES = {
    "passed": "accepted",
    "failed": "rejected",
    UNDER_ANOTHER: "unusable",
    "skipped": "unusable",
    "not reached": "none",
    "no verdict": "none",
}


def _class(state: str) -> str:
    return f"verdict {_CLASSES.get(state, 'none')}"


def _failure(result: Result, small: Node | None) -> Node:
    badge = node("span", told_status(result), class_=_class(result.status))
    report = node("pre", result.report, class_="quote") if result.report else None
    if report is not None and small is not None:
        report = node("details", node("summary", "the report about the whole log"), report)
    log = node("details", node("summary", "the reduced log"), node("pre", result.reduced)) if result.reduced else None
    return node("section", node("h2", badge, result.name), node("p", result.reason), small, log, report, id=result.name)


def _row(one: Outcome) -> Node:
    programs = node("td", f"{len(one.passed)} passed")
    for state, names in (("failed", one.failed), (UNDER_ANOTHER, one.under)):
        for place, name in enumerate(names):
            before = "" if place else f", {state}: "
            programs.append(node("span", before or ", ", node("a", name, href=f"#{name}")))
    if one.reasons and one.state == "skipped":
        programs.text = "; ".join(one.reasons)
    return node(
        "tr",
        node("td", node("span", one.state, class_=_class(one.state))),
        node("td", one.requirement, class_="id", id=one.requirement),
        node("td", clause(one.requirement).text),
        programs,
    )


_BADGE_COLOURS = {"failed": "#c0392b", "passed": "#2e8b57", "none": "#777777"}
_CHARACTER = 6.6


def to_badge(kept: Kept) -> bytes:
    """An SVG: how many of the requirements that were reached are kept."""
    counts = Counter(one.state for one in kept.requirements if not one.requirement.startswith("AMB"))
    failed = counts["failed"] + counts[UNDER_ANOTHER]
    reached = counts["passed"] + failed
    state = "failed" if failed else "passed" if reached else "none"
    left, right = "S7 interrupts", f"{counts['passed']} of {reached} requirements"
    widths = [round(len(text) * _CHARACTER + 12) for text in (left, right)]
    text = {"fill": "#ffffff", "font_family": "Verdana, sans-serif", "font_size": "11"}
    picture = node(
        "svg",
        node("title", f"{left}: {right}"),
        node("rect", width=widths[0], height="20", fill="#444444"),
        node("rect", x=widths[0], width=widths[1], height="20", fill=_BADGE_COLOURS[state]),
        node("text", left, x="6", y="14", **text),
        node("text", right, x=widths[0] + 6, y="14", **text),
        xmlns="http://www.w3.org/2000/svg",
        width=sum(widths),
        height="20",
    )
    written: bytes = Xml.tostring(picture, encoding="utf-8")
    return written + b"\n"


FORMATS: dict[str, Callable[[Kept], bytes]] = {
    ".txt": lambda kept: click.unstyle(to_text(kept)).encode() + b"\n",
    ".json": to_json,
    ".xml": to_junit,
    ".html": to_html,
    ".svg": to_badge,
}
"""Ending of a file -> its format."""

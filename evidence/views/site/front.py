"""The front page: a rejected log with its timeline, and three things to try."""

from __future__ import annotations

import html
import tempfile
from collections.abc import Callable, Iterator

from evidence.common import gallery
from evidence.common.gallery import Case
from evidence.views.pictures import log_of_readme
from evidence.views.site.documents import Document, Section
from evidence.views.site.linked import with_links
from evidence.views.site.logs import EXPLORER, address, drawable, picture
from s7check.engine.client import Engine
from s7check.report.clauses import clause
from s7check.report.markup import as_text
from s7check.report.report import Report
from s7check.report.timeline import patterns

_EDGE_CASE = "due-while-running"
_SIDES = ("S7-300", "S7-400", "clock-back-s7-300")
"""A CPU, another one beside it, and the edge case that they answer differently."""

_QUESTIONS = {
    "SFC 28 sets a monthly interrupt for day 31: and in February?": ("monthly-on-day-31",),
    "Three DIS_AIRT, the clock jumps over two points, one EN_AIRT: what starts?": (
        "clock-over-two-points-under-three-delays",
    ),
    "The clock is set back over a point that was served: does its OB run again?": (
        "clock-back-s7-300",
        "clock-back-s7-400",
    ),
    "The clock jumps over a point, and there is no OB 80?": ("clock-over-point-without-ob80",),
    "SRT_DINT again, while the delay runs or its OB waits: one run or two?": (
        "delay-interrupt-started-again",
        "delay-interrupt-started-again-while-it-waits",
    ),
    "DIS_IRT for one OB, EN_IRT for its class: is the OB free?": ("blocked-alone-free-by-class",),
    "CAN_TINT while the OB runs, and while it waits?": ("cancelled-inside-its-ob", "cancelled-while-pending"),
    "A warm restart or a hot one: what is left?": ("hot-restart", "restart-forgets-settings"),
    "ACT_TINT after the date has passed?": ("activated-too-late", "once-is-used-up"),
    "Two OBs of one class are due in one millisecond: which is first?": ("one-minute-two-obs",),
}
"""What people ask, and the edge cases that answer."""

_TOLD = """The rules of the interrupt functions of Siemens S7-300 and S7-400 CPUs, as a formal specification: SFC 28
to 34 and SFC 39 to 42, the clock, priorities, missing OBs, modes and restart. A program checks logs against it, and
says which line no such CPU would show, and by which rule."""


def front_page(engine: Engine, to: Callable[[str], str], *, explorer: bool) -> Document:
    """The page; `to` makes the address of an ID."""
    with tempfile.TemporaryDirectory() as folder:
        report = drawable(log_of_readme(folder), engine)
    found = {case.name: case for case in gallery.cases()}
    cards = _cards(report, found) if explorer else iter([_card("gallery.html", "Edge cases", "Forty of them.")])
    body = (
        f"<h1>Would a real S7-300/400 do that?</h1><p>{_TOLD}</p>"
        f"{as_text(patterns())}{picture(report)}"
        f'<p><span class="verdict rejected">rejected</span> {html.escape(report.why)}</p><ul>{_rules(report, to)}</ul>'
        f'<ul class="cards">{"".join(cards)}</ul>'
        f"<h2>Ten questions</h2><dl>{''.join(_answers(found, to))}</dl>"
        '<p><a href="book.html">The book</a> has every rule with its sources, its formula, its proofs and its logs, '
        'and a table of <a href="book/restart.html">what each restart keeps</a>.</p>'
        '<p><a href="gallery.html">Edge cases</a>, each by its shortest log; '
        '<a href="rules/review.html">longer ones</a>, told step by step.</p>'
    )
    return Document("s7-interrupts", body, [Section("index.html", "s7-interrupts", _TOLD)])


def _rules(report: Report, to: Callable[[str], str]) -> str:
    named = [clause(name) for name in report.requirements]
    return "".join(f'<li><a href="{to(one.id)}">{one.id}</a> {html.escape(one.text)}</li>' for one in named)


def _answers(found: dict[str, Case], to: Callable[[str], str]) -> Iterator[str]:
    for question, names in _QUESTIONS.items():
        yield f"<dt><strong>{html.escape(question)}</strong></dt>"
        for case in (found[name] for name in names):
            ids = ", ".join(f'<a href="{to(one)}">{one}</a>' for one in case.requirements)
            title = f'<a href="gallery.html#{case.name}">{html.escape(case.title)}</a>'
            yield f"<dd>{title}: {with_links(case.told, to)} {ids}</dd>"


def _cards(report: Report, found: dict[str, Case]) -> Iterator[str]:
    assert report.line is not None
    here = address("the log above", report.lines, report.line - 2)
    yield _card(here, "Open this log", "Which lines may come in place of the rejected one, and why it may not.")
    yield _card(EXPLORER, "Drop a log", "The checker runs in the page. Nothing leaves your machine.")
    case = found[_EDGE_CASE]
    yield _card(f"{EXPLORER}#open={case.name}", case.title, case.told)
    mine, other, name = _SIDES
    case = found[name]
    beside = address(case.title, case.log.splitlines(), len(case.log.splitlines()) - 1, [other])
    yield _card(beside, f"{mine} beside {other}", case.told)


def _card(place: str, title: str, text: str) -> str:
    return f'<li><a href="{place}">{html.escape(title)}</a><p>{html.escape(text)}</p></li>'

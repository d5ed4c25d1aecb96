"""A page to look at: a timeline of each log, and the explanation of its verdict. It needs no network."""

from collections import Counter
from collections.abc import Iterator, Sequence
from importlib.resources import files

from s7check.judging.verdict import Report, Verdict
from s7check.report import words
from s7check.report.clauses import clause, named
from s7check.report.lines import message, place, readings, source
from s7check.report.markup import Node, add, document, node
from s7check.report.timeline import timeline

_SCRIPT = (
    'for (const box of document.querySelectorAll(".scroll")) '
    "if (box.scrollWidth > 1.4 * box.clientWidth) box.scrollLeft = box.scrollWidth;"
)
_CLASSES: dict[Verdict, str] = {
    "accepted": "accepted",
    "rejected": "rejected",
    "unusable": "unusable",
    "no verdict": "none",
}


def to_html(reports: Sequence[Report]) -> bytes:
    """All reports as one page, accepted logs last."""
    ordered = sorted(enumerate(reports), key=lambda pair: (-bool(pair[1].exit_code), pair[0]))
    counts = Counter(report.verdict for report in reports)
    summary = [
        node("li", f"{counts[verdict]} {verdict}", class_=f"chip {name}")
        for verdict, name in _CLASSES.items()
        if counts[verdict]
    ]
    style = (files(__package__) / "report.css").read_text(encoding="utf-8")
    return document(
        f"s7check trace: {', '.join(f'{number} {verdict}' for verdict, number in sorted(counts.items()))}",
        style,
        _SCRIPT,
        node("h1", "Logs checked against the specification of the S7-300/400 interrupts"),
        node("ul", *summary, class_="chips"),
        *([_contents(ordered)] if len(reports) > 1 else []),
        *(_section(number, report) for number, report in ordered),
        *_clauses(reports),
    )


def _contents(ordered: list[tuple[int, Report]]) -> Node:
    rows = [
        node(
            "tr",
            node("td", _badge(report)),
            node("td", node("a", place(report), href=f"#log{number}")),
            _with_links("td", ", ".join(report.requirements)),
        )
        for number, report in ordered
    ]
    return node("table", *rows)


def _badge(report: Report) -> Node:
    return node("span", report.verdict, class_=f"verdict {_CLASSES[report.verdict]}")


def _section(number: int, report: Report) -> Node:
    picture = timeline(report)
    return node(
        "section",
        node("h2", _badge(report), place(report)),
        node("p", message(report)),
        node("pre", source(report.event), class_="quote") if report.event is not None else None,
        node("div", picture, class_="scroll") if picture is not None else None,
        *(_explanation(report) if report.verdict == "rejected" else []),
        *_readings(report),
        id=f"log{number}",
    )


def _explanation(report: Report) -> Iterator[Node]:
    heading = "What had to come before the line" if report.late else "What the specification allows at this point"
    yield node("h3", heading)
    expected = report.late or report.expected or ["nothing"]
    yield node("ul", *(node("li", text, class_="chip mono") for text in expected), class_="chips")
    rows = []
    for name in report.requirements:
        found = clause(name)
        origin = ", ".join(part for part in (found.source, found.confidence) if part)
        text = node("td", found.text, " ", node("span", origin, class_="origin"))
        rows.append(node("tr", _with_links("td", name, class_="id"), text))
    yield node("h3", "Requirements that decide")
    yield node("table", *rows)
    yield node("div", node("div", *_situations(report)), node("div", *_candidates(report)), class_="two")
    yield node("p", f"The shortest prefix that fails: lines 1 to {report.line}.", class_="origin")


def _situations(report: Report) -> Iterator[Node]:
    for number, state in enumerate(report.situations, 1):
        of = f" ({number} of {report.states})" if report.states > 1 else ""
        rows = [node("tr", node("td", topic, class_="key"), node("td", text)) for topic, text in words.situation(state)]
        yield node("h3", f"The CPU before the line{of}")
        yield node("table", *rows)


def _candidates(report: Report) -> Iterator[Node]:
    if not report.candidates:
        return
    rows = [
        node(
            "tr",
            node("td", node("code", one.action), class_="key"),
            node(
                "td",
                node("code", f"~({one.conjunct})"),
                f" {one.values} ",
                _with_links("span", ", ".join([*one.requirements, one.place]), class_="origin"),
            ),
        )
        for one in report.candidates
    ]
    yield node("h3", "Why not: each action's first false conjunct")
    yield node("table", *rows)


def _readings(report: Report) -> Iterator[Node]:
    for part in readings(report):
        yield node("h3", part.heading)
        yield node("ul", *(_with_links("li", line) for line in part.lines))


def _with_links(tag: str, text: str, **attributes: str) -> Node:
    """A text in which each requirement and each ambiguity leads to its place at the end of the page."""
    made = node(tag, **attributes)
    for name in named(text):
        before, _, text = text.partition(name)
        add(made, before, node("a", name, href=f"#{name}"))
    return add(made, text)


def _clauses(reports: Sequence[Report]) -> Iterator[Node]:
    """The requirements and ambiguities that the page names, with their place in the documents."""
    names: dict[str, None] = {}
    for report in reports:
        lines = [line for part in readings(report) for line in part.lines]
        tags = [name for one in report.candidates for name in one.requirements]
        names |= dict.fromkeys(named(" ".join([*report.requirements, *tags, *lines])))
    rows = []
    for found in map(clause, sorted(names)):
        answers = (f" ({letter}) {answer}" for letter, answer in found.letters.items())
        origin = "; ".join(part for part in (found.source, found.confidence, found.place) if part)
        text = node("td", found.text, *answers, " ", node("span", origin, class_="origin"))
        rows.append(node("tr", node("td", found.id, class_="id", id=found.id), text))
    if rows:
        yield node("section", node("h2", "Requirements and readings"), node("table", *rows))

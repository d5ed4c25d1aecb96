"""A page to look at: a timeline of each log, and the explanation of its verdict. It needs no network."""

from collections import Counter
from collections.abc import Iterator, Sequence
from importlib.resources import files
from xml.etree import ElementTree as Xml

from s7check.report.clauses import clause, named
from s7check.report.markup import Node, add, document, node
from s7check.report.report import Cause, Report, Verdict, cause, message, place, source
from s7check.report.timeline import legend, timeline

_CLASSES: dict[Verdict, str] = {
    "accepted": "accepted",
    "rejected": "rejected",
    "unusable": "unusable",
    "no verdict": "none",
}
_ROOM = 500_000
"""Bytes of a page for pictures, and as many for explanations: with 1,000 logs it stays below 2 MB."""


class _Room:
    """How much more of one kind a page takes."""

    def __init__(self) -> None:
        self._left = _ROOM

    def takes(self, *parts: Node) -> bool:
        """Whether these parts are still to be on the page, which then has less room."""
        size = sum(len(Xml.tostring(part)) for part in parts)
        fits = size <= self._left
        self._left -= size if fits else 0
        return fits


def to_html(reports: Sequence[Report]) -> bytes:
    """All reports as one page: first the logs that are not accepted, those with the same cause together."""
    ordered = sorted(enumerate(reports), key=lambda pair: (-bool(pair[1].exit_code), pair[0]))
    counts = Counter(report.verdict for report in reports)
    style, script = ((files(__package__) / f"report.{kind}").read_text(encoding="utf-8") for kind in ("css", "js"))
    sections = Sections()
    made = [sections.made(number, report) for number, report in ordered]
    named = {number for (number, _), section in zip(ordered, made, strict=True) if section is not None}
    return document(
        f"s7check trace: {', '.join(f'{number} {verdict}' for verdict, number in sorted(counts.items()))}",
        style,
        script,
        node("h1", "Logs checked against the specification of the S7-300/400 interrupts"),
        _summary(counts),
        *(_contents(ordered, named) if len(reports) > 1 else []),
        *([legend()] if sections.pictures else []),
        *(section for section in made if section is not None),
        *clauses(reports),
    )


def _summary(counts: Counter[Verdict]) -> Node:
    chips = [
        node("li", f"{counts[verdict]} {verdict}", class_=f"chip {name}")
        for verdict, name in _CLASSES.items()
        if counts[verdict]
    ]
    return node("ul", *chips, class_="chips")


def _contents(ordered: list[tuple[int, Report]], named: set[int]) -> Iterator[Node]:
    """A form that picks logs, and a table of them by verdict and deciding requirements; ``named`` have a section."""
    groups: dict[tuple[Verdict, str], list[tuple[int, Report]]] = {}
    for number, report in ordered:
        groups.setdefault((report.verdict, ", ".join(report.requirements)), []).append((number, report))
    verdicts = [verdict for verdict in _CLASSES if any(verdict == other for other, _ in groups)]
    boxes = [
        node("label", node("input", type="checkbox", value=_CLASSES[verdict], checked="checked"), f" {verdict}")
        for verdict in verdicts
    ]
    name = node("label", "name or requirement ", node("input", type="search", autocomplete="off"))
    yield node("form", name, *boxes, node("output"), class_="filter", hidden="hidden")
    bodies = []
    for (verdict, requirements), members in groups.items():
        what = f"{verdict} by {requirements}" if requirements else verdict
        many = f"{len(members)} log{'s' if len(members) > 1 else ''}: "
        head = node("tr", _with_links("th", many + what, scope="rowgroup"), class_="group")
        rows = [
            node("tr", node("td", node("a", place(report), href=f"#log{number}") if number in named else place(report)))
            for number, report in members
        ]
        bodies.append(node("tbody", head, *rows, class_=_CLASSES[verdict]))
    yield node("table", *bodies, class_="contents")


def _badge(report: Report) -> Node:
    return node("span", report.verdict, class_=f"verdict {_CLASSES[report.verdict]}")


class Sections:
    """The sections of the logs, with pictures and explanations as long as there is room."""

    def __init__(self) -> None:
        self.pictures = 0
        self._drawn, self._explained = _Room(), _Room()
        self._first: dict[Cause, int] = {}

    def made(self, number: int, report: Report) -> Node | None:
        """The section of a log; none for a log of which the table has said all."""
        picture = list(self._picture(report))
        if report.verdict == "accepted" and not picture and report.readings is None:
            return None
        return node(
            "section",
            node("h2", _badge(report), place(report)),
            _with_links("p", message(report)),
            node("pre", source(report.event), class_="quote") if report.event is not None else None,
            *picture,
            *(self._explanation(number, report) if report.verdict == "rejected" else []),
            *_readings(report),
            id=f"log{number}",
            class_=_CLASSES[report.verdict],
        )

    def _picture(self, report: Report) -> Iterator[Node]:
        drawn = timeline(report)
        if drawn is None:
            return
        shown = f"lines {drawn.first} to {drawn.last} of {len(report.lines)}"
        label = {"role": "region", "tabindex": "0", "aria_label": f"timeline of {place(report)}, {shown}"}
        parts = [
            node("p", shown[0].upper() + shown[1:], class_="origin"),
            *_rest(report, 1, drawn.first - 1),
            node("div", drawn.labels, drawn.lanes, class_="scroll", **label),
            *_rest(report, drawn.last + 1, len(report.lines)),
        ]
        if self._drawn.takes(*parts):
            self.pictures += 1
            yield from parts
        else:
            yield node("p", "No timeline: the page has no room for more. A page of this log alone has it.")

    def _explanation(self, number: int, report: Report) -> Iterator[Node]:
        first = self._first.setdefault(cause(report), number)
        if first != number:
            same = node("a", "the log where it is explained", href=f"#log{first}")
            yield node("p", "The same cause as in ", same, ".")
            return
        parts = list(_explanation(report))
        if self._explained.takes(*parts):
            yield from parts
        else:
            yield node("p", "No explanation: the page has no room for more. s7check trace on this log alone has it.")


def _rest(report: Report, first: int, last: int) -> Iterator[Node]:
    """Lines that the picture does not have, to be opened."""
    if first > last:
        return
    text = "\n".join(f"{number} {source(report.lines[number - 1])}" for number in range(first, last + 1))
    named = f"line {first}" if first == last else f"lines {first} to {last}"
    yield node("details", node("summary", named), node("pre", text, tabindex="0"))


def _explanation(report: Report) -> Iterator[Node]:
    heading = "What had to come before the line" if report.late else "What the specification allows at this point"
    yield node("h3", heading)
    if report.why:
        yield _with_links("p", report.why)
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
    yield from _situations(report)
    yield from _candidates(report)
    yield node("p", f"The shortest prefix that fails: lines 1 to {report.line}.", class_="origin")


def _situations(report: Report) -> Iterator[Node]:
    for number, state in enumerate(report.situations, 1):
        of = f" ({number} of {report.states})" if report.states > 1 else ""
        rows = [node("tr", node("td", topic, class_="key"), node("td", text)) for topic, text in state.said]
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
    yield node("details", node("summary", "The formulas: each action's first false conjunct"), node("table", *rows))


def _readings(report: Report) -> Iterator[Node]:
    for part in report.compared:
        yield node("h3", part.heading)
        yield node("ul", *(_with_links("li", line) for line in part.lines))


def _with_links(tag: str, text: str, **attributes: str) -> Node:
    """A text in which each requirement and each ambiguity leads to its place at the end of the page."""
    made = node(tag, **attributes)
    for name in named(text):
        before, _, text = text.partition(name)
        add(made, before, node("a", name, href=f"#{name}"))
    return add(made, text)


def clauses(reports: Sequence[Report]) -> Iterator[Node]:
    """The requirements and ambiguities that the page names, with their place in the documents."""
    names: dict[str, None] = {}
    for report in reports:
        lines = [line for part in report.compared for line in part.lines]
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

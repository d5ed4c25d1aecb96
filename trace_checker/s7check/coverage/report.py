"""A coverage as text, JSON and HTML."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files

import msgspec

from s7check.coverage.measure import Coverage, Guard
from s7check.kit.program import Program
from s7check.log.errors import ranges
from s7check.report.clauses import by_area, clause
from s7check.report.markup import Node, document, node
from s7check.report.report import EXIT_CODES

_MOST_PROGRAMS = 3
"""Programs named for a gap."""


@dataclass(frozen=True)
class Gap:
    """A requirement that decided nothing, and the programs of the kit that reach it, the shortest first: those that did
    when they were run, and of programs of which nobody knows it, those that are about it.

    ``open``: it decided something in some explanations of a log, and in others not.
    """

    requirement: str
    open: bool
    programs: tuple[str, ...]


@dataclass(frozen=True)
class Total:
    """The coverage of logs beside all that there is to cover.

    ``answers`` and ``periods`` are all that a CPU may give and take; the RET_VAL of SFC 41 is a count.
    """

    coverage: Coverage
    requirements: Sequence[str]
    guards: Sequence[Guard]
    answers: frozenset[tuple[str, int]]
    periods: frozenset[int]
    programs: Sequence[Program]

    def gaps(self) -> list[Gap]:
        """The requirements that decided nothing."""
        about: dict[str, list[str]] = {}
        for program in sorted(self.programs, key=lambda one: (len(one.line()), one.name)):
            for name in program.reaches or program.requirements:
                about.setdefault(name, []).append(program.name)
        return [
            Gap(name, name in self.coverage.open, tuple(about.get(name, [])))
            for name in self.requirements
            if name not in self.coverage.requirements
        ]

    def guards_not_met(self) -> list[Guard]:
        """The outcomes of conditions that no log has shown."""
        return [one for one in self.guards if one not in self.coverage.guards]

    @property
    def met(self) -> Mapping[str, tuple[int, int]]:
        """For each kind of count: how many were met, of how many."""
        return {
            "requirements": (len(self.requirements) - len(self.gaps()), len(self.requirements)),
            "guard outcomes": (len(self.guards) - len(self.guards_not_met()), len(self.guards)),
            "answers": (len(self.answers & self.coverage.answers), len(self.answers)),
            "PERIODs": (len(self.periods & self.coverage.periods), len(self.periods)),
        }


def to_text(total: Total, guards: bool = False) -> str:
    """The numbers, then the gaps; with ``guards`` also each outcome of a condition that no log has shown."""
    coverage = total.coverage
    lines = [_logs(coverage), *(f"{name}: {met} of {of}" for name, (met, of) in total.met.items())]
    lines += [f"{name}: {text}" for name, text in _seen(coverage)]
    if gaps := total.gaps():
        lines.append("requirements that decided nothing, with programs of the kit:")
        lines += [f"  {one.requirement} {_remark(one)}{clause(one.requirement).text}" for one in gaps]
        for program, closed in _closing(gaps):
            lines.append(f"  {program}: {by_area(closed)}")
    for name, missing in _missing(total):
        lines.append(f"{name}: {missing}")
    if guards:
        lines.append("conditions that never had this outcome:")
        lines += [f"  {_place(one)} {str(one.outcome).upper()}: {one.text}" for one in total.guards_not_met()]
    return "\n".join(lines)


def to_json(total: Total) -> bytes:
    """One object."""
    coverage = total.coverage
    content = {
        "logs": len(coverage.verdicts),
        "verdicts": Counter(coverage.verdicts),
        "requirements": sorted(coverage.requirements),
        "gaps": total.gaps(),
        "guards": sorted(coverage.guards),
        "guards_not_met": sorted(total.guards_not_met()),
        "answers": [{"call": call, "ret": ret} for call, ret in sorted(coverage.answers)],
        "answers_not_met": [{"call": call, "ret": ret} for call, ret in sorted(total.answers - coverage.answers)],
        "periods": sorted(coverage.periods),
        "periods_not_met": sorted(total.periods - coverage.periods),
        "obs": sorted(coverage.obs),
        "classes": sorted(coverage.classes),
        "left_out": sorted(coverage.left_out),
    }
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"


def to_html(total: Total) -> bytes:
    """A page that needs no network."""
    style = (files("s7check.report") / "report.css").read_text(encoding="utf-8")
    gaps = [
        node(
            "tr",
            node("td", one.requirement, class_="id"),
            node("td", _remark(one) + clause(one.requirement).text),
            node("td", ", ".join(one.programs[:_MOST_PROGRAMS])),
        )
        for one in total.gaps()
    ]
    rows = [("", "exercised"), *((name, f"{met} of {of}") for name, (met, of) in total.met.items())]
    return document(
        "s7check coverage",
        style,
        "",
        node("h1", "Rules that the logs exercise"),
        node("p", _logs(total.coverage)),
        _table([*rows, *_seen(total.coverage), *_missing(total)]),
        node("h2", "Requirements that decided nothing, with programs of the kit"),
        node("table", *gaps),
        node("h2", "Requirements that decided something"),
        _table([(name, clause(name).text) for name in sorted(total.coverage.requirements)]),
        node("h2", "Conditions that never had this outcome"),
        _table([(_place(one), f"{str(one.outcome).upper()}: {one.text}") for one in total.guards_not_met()]),
    )


def _table(rows: Iterable[tuple[str, str]]) -> Node:
    return node("table", *(node("tr", node("td", key, class_="id"), node("td", text)) for key, text in rows))


def _logs(coverage: Coverage) -> str:
    counts = Counter(coverage.verdicts)
    verdicts = ", ".join(f"{counts[name]} {name}" for name in EXIT_CODES if counts[name])
    return f"{len(coverage.verdicts)} logs: {verdicts}"


def _seen(coverage: Coverage) -> Iterator[tuple[str, str]]:
    yield "OBs started", ranges(coverage.obs) or "none"
    yield "priority classes", ranges(coverage.classes) or "none"
    if coverage.left_out:
        yield "kinds of event that a log leaves out", ", ".join(sorted(coverage.left_out))


def _missing(total: Total) -> Iterator[tuple[str, str]]:
    answers: dict[str, list[str]] = {}
    for call, ret in sorted(total.answers - total.coverage.answers):
        answers.setdefault(call, []).append(f"{ret:04X}")
    if answers:
        yield "answers that never came", "; ".join(f"{call} {', '.join(rets)}" for call, rets in answers.items())
    if periods := sorted(total.periods - total.coverage.periods):
        yield "PERIODs never set", ", ".join(f"{one:04X}" for one in periods)


def _closing(gaps: Sequence[Gap]) -> Iterator[tuple[str, list[str]]]:
    """Few programs that are about all gaps that any is about, each with the gaps that it is the first to be about."""
    left = {one.requirement: one for one in gaps if one.programs}
    while left:
        counts = Counter(program for one in left.values() for program in one.programs)
        best = max(counts, key=lambda name: (counts[name], -len(name), name))
        closed = [name for name, one in left.items() if best in one.programs]
        yield best, closed
        for name in closed:
            del left[name]


def _remark(gap: Gap) -> str:
    return "(decides in some explanations of a log, in others not) " if gap.open else ""


def _place(guard: Guard) -> str:
    return f"{guard.module}:{guard.line}:{guard.column}"

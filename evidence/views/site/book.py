"""The chapters of the book as HTML: below each rule its sources, readings, formula, checks and logs."""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from markdown_it import MarkdownIt

from evidence.models.manifest import Model
from evidence.views.site.chapters import Chapter, definition_named
from evidence.views.site.linked import TAG, Linked
from evidence.views.site.logs import Logs
from evidence.views.site.tables import Tables
from evidence.views.traceability.matrix import Cell, Matrix, Row
from evidence.views.traceability.modules import Definition
from evidence.views.traceability.project import Project
from s7check.report.clauses import Clause, is_question
from s7check.simulating.kept import Kept

_SOURCE = re.compile(r"^- \*\*(\w+)\*\*: (.*?)(?=^- |^$)", re.MULTILINE | re.DOTALL)
_NAME = re.compile(r"<code>(\w+)</code>")
_MOST = 3
"""So many formulas, properties, models and controls of a rule are shown; the others are counted."""
_LONG = 24
"""A formula of more lines is folded."""


@dataclass(frozen=True)
class Parts:
    """What the book is made of: `sources` has the editions, `defaults` the default letters, by their names."""

    project: Project
    matrix: Matrix
    linked: Linked
    logs: Logs
    experiments: Sequence[Kept]
    sources: Mapping[str, str]
    defaults: Mapping[str, str]
    tables: Tables
    explorer: bool


def editions(*pages: str) -> dict[str, str]:
    """The sources of requirement pages by their keys."""
    return {key: " ".join(text.replace("*", "").split()) for page in pages for key, text in _SOURCE.findall(page)}


class Page:
    """A chapter; `to` makes the address of a place of the site, or of an ID, on its page."""

    def __init__(self, parts: Parts, chapter: Chapter, to: Callable[[str], str]) -> None:
        self._parts = parts
        self._chapter = chapter
        self._to = to
        self._rows = {row.id: row for row in parts.matrix.rows}

    def body(self) -> str:
        """The whole chapter."""
        told = _NAME.sub(self._named, MarkdownIt().enable("table").render(self._chapter.told))
        tables = "".join(self._parts.tables(name, self._to) for name in self._chapter.tables)
        rules = "".join(self._rule(name) for name in self._chapter.rules)
        return f"<h1>{html.escape(self._chapter.title)}</h1>{told}{tables}{rules}"

    def _named(self, found: re.Match[str]) -> str:
        linked, name = self._parts.linked, found[1]
        place = linked.places.get(name) or linked.place(definition_named(self._parts.project, name))
        return f'<code><a href="{self._to(place)}">{found[1]}</a></code>'

    def _rule(self, name: str) -> str:
        clause, row = self._parts.project.requirements[name], self._rows[name]
        said = self._ids(MarkdownIt().renderInline(clause.text))
        rows = [
            ("Readings", "".join(self._readings(clause, row))),
            ("Formula", self._cell(row.cells["formula"], self._formulas(self._tagged(name)))),
            ("Property", self._cell(row.cells["property"], "".join(self._properties(row)))),
            ("Checked", "".join(self._checks(row))),
            ("Fails without it", self._cell(row.cells["model"], self._controls(row))),
            ("Accepted", self._log(row.cells["accepted"])),
            ("Rejected", self._log(row.cells["rejected"], row.cells["rejected"].entries.direct)),
        ]
        shown = "".join(f"<dt>{title}</dt><dd>{text}</dd>" for title, text in rows if text)
        head = f'<h2><a href="#{name}">{name}</a></h2><p class="said">{said}</p>{self._origin(clause)}'
        return f'<section class="rule" id="{name}">{head}<dl>{shown}</dl></section>'

    def _ids(self, text: str) -> str:
        return TAG.sub(lambda found: f'<a href="{self._to(found[0])}">{found[0]}</a>', text)

    def _origin(self, clause: Clause) -> str:
        def edition(found: re.Match[str]) -> str:
            title = self._parts.sources.get(found[0])
            return f'<abbr title="{html.escape(title)}">{found[0]}</abbr>' if title else found[0]

        said = re.sub(r"\w+", edition, html.escape(clause.source))
        place = self._to("rules/requirements.html#sources")
        return f'<p class="origin">{said}; confidence <a href="{place}">{html.escape(clause.confidence)}</a></p>'

    def _tagged(self, name: str) -> list[Definition]:
        """The formulas of a rule, first those that are about few other rules."""
        wanted = self._rows[name].cells["formula"].entries.names
        found = [d for m in self._parts.project.spec for d in m.definitions if f"{d.module}.{d.name}" in wanted]
        return sorted(found, key=lambda d: len(d.tags))

    def _cell(self, cell: Cell, shown: str) -> str:
        return shown if cell.entries.names else f"<i>{html.escape(cell.kind)}</i>: {html.escape(cell.reason)}"

    def _formulas(self, definitions: Sequence[Definition]) -> str:
        linked = self._parts.linked
        links = ", ".join(f'<a href="{self._to(linked.place(d))}">{d.name}</a>' for d in definitions[_MOST:])
        return "".join(map(self._formula, definitions[:_MOST])) + (f"<p>also {links}</p>" if links else "")

    def _formula(self, one: Definition) -> str:
        text = f"<pre>{self._parts.linked.definition(one, self._to)}</pre>"
        return f"<details><summary>{one.name}</summary>{text}</details>" if text.count("\n") > _LONG else text

    def _properties(self, row: Row) -> Iterator[str]:
        inside = [d for d in row.properties if d.module in self._parts.linked.places]
        outside = [f"{d.module}.{d.name}" for d in row.properties if d not in inside]
        yield f"<details><summary>{', '.join(d.name for d in inside)}</summary>" if inside else ""
        yield self._formulas(inside) + ("</details>" if inside else "")
        yield f"<p>in models: {', '.join(outside)}</p>" if outside else ""

    def _readings(self, clause: Clause, row: Row) -> Iterator[str]:
        formulas = set(row.cells["formula"].entries.names)
        looked_up = [name for name, cell in self._parts.matrix.readings.items() if formulas & {*cell.entries.names}]
        for name in dict.fromkeys(filter(is_question, [*TAG.findall(clause.text), *looked_up])):
            asked = self._parts.project.ambiguities[name]
            default = self._parts.defaults.get(name)
            letters = "".join(
                f"<li>{'<b>' if letter == default else ''}({letter}) {html.escape(text)}"
                f"{' (default)</b>' if letter == default else ''}</li>"
                for letter, text in asked.letters.items()
            )
            yield f"<details><summary>{name} {html.escape(asked.text)}</summary><ul>{letters}</ul>"
            yield f'<p><a href="{self._to(name)}">why</a>{"".join(self._experiments(name))}</p></details>'

    def _experiments(self, name: str) -> Iterator[str]:
        for one in self._parts.experiments:
            ((question, first),), ((_, second),) = one.allowed.letters, one.refused.letters
            if question == name:
                place = self._to(f"rules/experiments.html#{name.lower()}-{first}-against-{second}")
                yield f'; <a href="{place}">experiment {first} against {second}</a>'

    def _checks(self, row: Row) -> Iterator[str]:
        controls = self._parts.project.controls
        checking = [model for d in row.properties for model in controls.checking.get((d.module, d.name), ())]
        models = [controls.entries[name] for name in dict.fromkeys([*row.models, *checking])]
        models.sort(key=lambda entry: entry.kind == "witness")
        if models:
            more = f"<li>and in {len(models) - _MOST} other models</li>" if len(models) > _MOST else ""
            shown = "".join(map(_model, models[:_MOST]))
            yield f"<p>Model-checked by TLC, within the bounds of</p><ul>{shown}{more}</ul>"
        proofs = self._parts.project.proofs
        for name in dict.fromkeys(d.name for d in row.properties if d.name in proofs and proofs[d.name].proved):
            place = self._to("project/proofs.html#what-is-assumed")
            found = proofs[name]
            yield f"<p>{name}: proved by Apalache of {found.proved} of {found.actions} actions, "
            yield f'of one step from any state <a href="{place}">within its bounds</a></p>'

    def _controls(self, row: Row) -> str:
        found = row.cells["model"].entries
        names = sorted(found.names[: found.direct or None], key=lambda name: name.startswith("letter-"))
        shown = "".join(self._control(self._parts.project.controls.entries[name]) for name in names[:_MOST])
        more = len(found.names) - _MOST
        return f"<ul>{shown}{f'<li>and {more} others</li>' if more > 0 else ''}</ul>"

    def _control(self, entry: Model) -> str:
        changes = "".join(
            f"<pre><del>{html.escape(one.replace.rstrip())}</del>\n<ins>{html.escape(one.by.rstrip())}</ins></pre>"
            for one in entry.mutations
        )
        said = f"{entry.name}: {entry.expect.property} fails in model {entry.base or entry.name}"
        return f"<li><details><summary>{said}</summary>{changes or f'<p>{_what(entry)}</p>'}</details></li>"

    def _log(self, cell: Cell, among: int = 0) -> str:
        """The plainest log, of the first so many if `among` says so."""
        if not cell.entries.names:
            return self._cell(cell, "")
        logs = self._parts.logs
        case, drawn = logs.shown(logs.plainest(cell.entries.names[: among or None]))
        run = f' <a class="run" href="{self._to(logs.opened(case))}">run this</a>'
        where = f", line {case.line}" if case.line else ""
        return f"<p>{html.escape(case.reason)} ({case.name}{where}){run if self._parts.explorer else ''}</p>{drawn}"


def _what(entry: Model) -> str:
    return str(MarkdownIt().renderInline(entry.what))


def _model(entry: Model) -> str:
    states = f" ({entry.expect.distinct:,} states)" if entry.expect.distinct else ""
    return f"<li>{entry.name}{states}: {_what(entry)}</li>"

"""The tables of the book. TLC evaluates them in models/MCBook.tla; here they are only laid out."""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any

from evidence.common.checkout import ROOT
from evidence.common.processes import Processes
from evidence.tla import tlc
from evidence.tla.modules import module_folders, reached
from evidence.tla.values import value
from evidence.views.site.chapters import BOOK
from evidence.views.site.linked import TAG, Linked
from evidence.views.traceability.modules import Definition, Module
from evidence.views.traceability.roles import rules
from s7check.log.errors import ranges
from s7check.report.clauses import event_text

_CODES = "Codes"
_MODULE = """---- MODULE Book ----
EXTENDS MCBook, TLC
BookCodes == [{}]
BookInv == PrintT(ToString(<<SituationTable, FamilyTable, BookCodes, DemandedEntries>>))
====
"""
_CONFIG = "INIT BookInit\nNEXT BookNext\nCHECK_DEADLOCK FALSE\nINVARIANT BookInv\n"
_COMMENT = re.compile(r"\(\*((?:(?!\(\*).)*)\*\)\s*\Z", re.DOTALL)
_RET_VALS = range(0x8080, 0x8100)

To = Callable[[str], str]
"""The address of a place of the site on a page."""


class Tables:
    """The tables by their names in docs/rules/book.md. Raises ValueError for another name, or where TLC fails."""

    def __init__(self, spec: Sequence[Module], linked: Linked) -> None:
        self._linked = linked
        self._known = {d.name: d for module in rules(spec) for d in module.definitions}
        self._text = next(module.text for module in spec if module.name == _CODES)
        self._codes = [d for d in self._known.values() if d.module == _CODES and self._is_value(d)]
        self._made: dict[str, Callable[[To], str]] = {
            "periods": self._periods,
            "modes": self._modes,
            "classes of SFC 39": self._numbers,
            "status": self._status,
            "OBs": self._obs,
            "causes of STOP": self._causes,
            "faults": self._faults,
        }

    def __call__(self, name: str, to: To) -> str:
        """A table as HTML."""
        if name.startswith("codes of "):
            return self._answers(name.removeprefix("codes of "), to)
        if name.startswith("formula "):
            return f"<pre>{self._linked.definition(self._known[name.removeprefix('formula ')], to)}</pre>"
        if name not in self._made:
            known = ", ".join([*self._made, "codes of ANSWERS", "formula NAME"])
            raise ValueError(f"{BOOK}: no such table: {name}; there are {known}")
        return self._made[name](to)

    def _is_value(self, one: Definition) -> bool:
        """Whether a definition of Codes has no operands."""
        return self._text[one.start :].decode().removeprefix(one.name).lstrip().startswith("==")

    @cached_property
    def _printed(self) -> list[Any]:
        """What TLC prints in each state: situation, family, codes, entries of the diagnostic buffer."""
        library = (*module_folders(ROOT / "spec"), ROOT / "models")
        text = _MODULE.format(", ".join(f"{d.name} |-> {d.name}" for d in self._codes))
        with tlc.workspace(library, "Book", text, _CONFIG) as space:
            options = tlc.Options(1, False, 500, 120, brief=True)
            run = tlc.run(tlc.find_toolchain(None), space.as_one_module(), options, Processes())
        if run.outcome.kind != "passed":
            raise ValueError(f"models/MCBook.tla: {run.outcome.detail}\n{run.output}")
        lines = [line[1:-1].replace('\\"', '"') for line in run.output.splitlines() if line.startswith('"<<')]
        return sorted(map(value, lines), key=str)

    @property
    def _values(self) -> Any:
        return self._printed[0][2]

    @cached_property
    def _families(self) -> list[dict[str, Any]]:
        found = {one[1]["family"]: one[1] for one in self._printed}
        return [found[name] for name in sorted(found, key=lambda name: (len(name), name))]

    def _link(self, name: str, to: To) -> str:
        return f'<a href="{to(self._linked.place(self._known[name]))}">{name}</a>'

    def _said(self, one: Definition) -> str:
        """The comment above a definition of Codes, without the IDs."""
        found = _COMMENT.search(self._text[: one.start].decode())
        words = TAG.sub("", found[1]) if found else ""
        return html.escape(" ".join(re.sub(r"\[\]|\*\)\s*\(\*", " ", words).split()))

    def _named(self, of: str, wanted: Iterable[int] | None = None) -> list[tuple[int, Definition]]:
        """The numbers, all or those that are wanted, that Codes gives names, of the names that a definition reaches."""
        names = reached([of], {d.name: d.words for d in self._known.values()})
        alone = [d for d in self._codes if d.name in names and not d.words & self._values.keys()]
        found = [(number, d) for d in alone for number in _numbers_of(self._values[d.name])]
        return sorted((one for one in found if wanted is None or one[0] in wanted), key=lambda one: one[0])

    def _periods(self, to: To) -> str:
        found = self._named("ValidPeriods", self._families[0]["periods"])
        rows = [(_hex(number, 4), self._link(d.name, to)) for number, d in found]
        return _table(f"PERIOD: {self._link('ValidPeriods', to)}", ("PERIOD", "name"), rows)

    def _causes(self, to: To) -> str:
        rows = [(_hex(v, 4), self._link(d.name, to), event_text(v)) for v, d in self._named("CausesOfRules")]
        return _table(f"Events of STOP by rule: {self._link('CausesOfRules', to)}", ("event", "name", ""), rows)

    def _answers(self, name: str, to: To) -> str:
        codes = [(v, d) for v, d in self._named(name) if v in _RET_VALS or d.name == "OK"]
        rows = [(_hex(v, 4), self._link(d.name, to), self._said(d)) for v, d in codes]
        if not rows:
            return f"<p>RET_VAL has no code: <code>{self._linked.definition(self._known[name], to)}</code></p>"
        return _table(f"RET_VAL: the codes that {self._link(name, to)} names", ("code", "name", ""), rows)

    def _modes(self, to: To) -> str:
        one = self._families[0]
        rows = [
            (_hex(m, 2), str(level), _yes(m in one["dis"]), _yes(m in one["en"]), _yes(m not in one["silent"]))
            for m, level in sorted(one["level"].items())
        ]
        head = ("MODE", self._link("Level", to), "SFC 39", "SFC 40", "lost events are entered")
        return _table("MODE", head, rows)

    def _numbers(self, to: To) -> str:
        rows = [(str(n), ranges(obs)) for n, obs in sorted(self._families[0]["meant"].items())]
        return _table(f"OB_NR of a class: {self._link('ClassNumber', to)}", ("OB_NR", "OBs"), rows)

    def _status(self, to: To) -> str:
        rows: dict[tuple[str, ...], list[str]] = {}
        for one, *_ in self._printed:
            situation = [_yes(one[name]) for name in ("startup", "blocked", "active", "loaded")]
            words = [" or ".join(_hex(v, 4) for v in sorted(one[name])) for name in ("tint", "dint")]
            rows.setdefault((*situation, *words), []).append(one["family"])
        head = ("STARTUP", "blocked by SFC 39", "active", "loaded", "SFC 31", "SFC 34", "CPU")
        shown = [(*cells, ", ".join(families)) for cells, families in rows.items()]
        return _table(f"STATUS in hexadecimal: {self._link('StatusOf', to)}", head, shown)

    def _obs(self, to: To) -> str:
        names = [one["family"] for one in self._families]

        def row(ob: int) -> tuple[str, ...]:
            classes = ["" if ob in one["lacks"] else str(one["classes"][ob]) for one in self._families]
            return *classes, " ".join(_hex(v, 4) for v in sorted(self._families[0]["events"][ob]))

        rows = [(str(ob), *row(ob)) for ob in sorted(self._families[0]["classes"])]
        title = f"Class of each OB by default: {self._link('DefaultClassOf', to)}; event IDs in its start information"
        return _table(title, ("OB", *names, "event"), rows)

    def _faults(self, to: To) -> str:
        entry, entries = self._values["ErrorEntry"], self._printed[0][3]
        found = [*self._named("CycleTimeExceeded"), *self._named("FaultsOfRules")]
        rows = [
            (_hex(v, 2), _hex(entry + v, 4), self._link(d.name, to), event_text(entry + v))
            for v, d in found
            if entry + v in entries
        ]
        return _table("Fault IDs and their events", ("fault", "event", "name", ""), rows)


def _numbers_of(found: Any) -> list[int]:
    return found if isinstance(found, list) else [found]


def _hex(number: int, digits: int) -> str:
    return f"{number:0{digits}X}"


def _yes(holds: bool) -> str:
    return "yes" if holds else "no"


def _table(title: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    def line(cells: Sequence[str], tag: str) -> Iterator[str]:
        yield "<tr>"
        yield from (f"<{tag}>{cell}</{tag}>" for cell in cells)
        yield "</tr>"

    body = "".join(part for row in rows for part in line(row, "td"))
    return f"<table class='spec'><caption>{title}</caption>{''.join(line(head, 'th'))}{body}</table>"

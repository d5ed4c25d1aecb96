"""docs/rules/traceability.md, as text."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import groupby

from evidence.views.traceability.entries import Entries
from evidence.views.traceability.matrix import COLUMNS, MODULE, NOTHING, Cell, Matrix, Row, counts
from evidence.views.traceability.project import Project
from evidence.views.traceability.proofs import Proof
from evidence.views.traceability.reasons import KINDS
from s7check.report.clauses import page_of

_INTRODUCTION = """\
# Traceability

What each requirement of [requirements.md](requirements.md) has, and how `spec/` treats each ambiguity of
[readings.md](readings.md). `s7spec views requirements` fails where a requirement has neither an entry nor a reason;
`s7spec views requirements TINT-14` shows one requirement with files and lines.

| column | comes from |
|---|---|
| formula | the definitions whose comment names the requirement, of the modules that `System` and `PartialLogs` extend |
| property | those of the other modules of `spec/` (not `Explain`, `Reasons`) and of `models/`, if a model checks them |
| proof | of how many of System's actions Apalache has proved the properties, the least of them: of one step from any \
state within bounds, which a behaviour may leave: two time-of-day OBs, two time-delay OBs, a hardware OB, OB 80 and \
OB 85; at most four start events wait, and a time-of-day OB remembers at most two runs of served points of its \
setting and two of earlier ones ([proofs.md](../project/proofs.md#what-is-assumed)). TLC checks the others within the \
bounds of its models |
| model | before the semicolon the models that name it in `models/models.txt`, then the negative controls: changes \
for which a model must fail. In *italics*: the requirement stands at the changed formula only, or in an abstract \
specification of which the whole fails |
| accepted, rejected | a log of `traces/`, and how many more there are. In *italics*: it plays a part, and another \
requirement decides |

A comment that names several requirements is an entry for each of them, also where a negative control breaks only a part
of what stands below it: the columns say where to look, not how much of a requirement is checked there.

A word in brackets says why there is no entry. The reasons, from the modules and from `docs/rules/left_out.json`, are
[below](#reasons).
"""

_REASONS = """
## Reasons

| word | meaning |
|---|---|
"""


def page(matrix: Matrix, project: Project) -> str:
    """The page."""
    parts = [_INTRODUCTION, _counts(matrix)]
    for prefix, rows in groupby(matrix.rows, key=lambda row: row.id.partition("-")[0]):
        parts.append(f"\n## {prefix}\n\n| ID | {' | '.join([*COLUMNS, 'proof'])} |\n|{'---|' * (len(COLUMNS) + 2)}\n")
        parts += [_row(row, project.proofs) for row in rows]
    parts.append("\n## AMB\n\n| ID | question | looked up in | accepted | rejected |\n|---|---|---|---|---|\n")
    for name, cell in matrix.readings.items():
        logs = " | ".join(_logs(found.get(name, NOTHING)) for found in (project.logs.accepted, project.logs.rejected))
        parts.append(
            f"| [{name}](readings.md#{name}) | {project.ambiguities[name].text} | {_cell(cell, _places)} | {logs} |\n"
        )
    parts += [_REASONS, f"| {MODULE} | the box at the top of a module leaves it out |\n"]
    parts += [f"| {kind} | {meaning} |\n" for kind, meaning in KINDS.items()]
    parts += ["\n| ID | without | word | reason |\n|---|---|---|---|\n", *_reasons(matrix)]
    return "".join(parts)


def _counts(matrix: Matrix) -> str:
    lines = [
        "\n| | have it | of these: in italics only | have a reason | of these: not done | have neither |\n",
        f"|{'---|' * 6}\n",
    ]
    lines += [f"| {' | '.join(map(str, count))} |\n" for count in counts(matrix)]
    return "".join(lines)


def _row(row: Row, proofs: Mapping[str, Proof]) -> str:
    models = ", ".join(row.models)
    controls = _cell(row.cells["model"], _controls)
    cells = {
        "formula": _cell(row.cells["formula"], _places),
        "property": _cell(row.cells["property"], _places),
        "model": f"{models}; {controls}" if models else controls,
        "accepted": _cell(row.cells["accepted"], _logs),
        "rejected": _cell(row.cells["rejected"], _logs),
        "proof": _proof([proofs[d.name] for d in row.properties if d.name in proofs]) if row.properties else "",
    }
    return f"| [{row.id}]({page_of(row.id)}#{row.id}) | {' | '.join(cells.values())} |\n"


def _proof(found: list[Proof]) -> str:
    """Of how many actions the property is proved that is proved of the fewest."""
    least = min(found, key=lambda proof: proof.proved, default=None)
    if least is None or not least.proved:
        return "TLC"
    return "all" if least.proved == least.actions else f"{least.proved} of {least.actions}"


def _cell(cell: Cell, show: Callable[[Entries], str]) -> str:
    if cell.entries.names:
        return show(cell.entries)
    return "**missing**" if cell.missing else f"[{cell.kind}]"


def _places(found: Entries) -> str:
    by_module = groupby(found.names, key=lambda name: name.partition(".")[0])
    return "; ".join(f"{module}: {', '.join(name.partition('.')[2] for name in names)}" for module, names in by_module)


def _controls(found: Entries) -> str:
    return _first(2, found, lambda name: name)


def _logs(found: Entries) -> str:
    return _first(1, found, _log)


def _log(case: str) -> str:
    area, _, name = case.partition("/")
    return f"[{name}](../../traces/{area}.txt)"


def _first(most: int, found: Entries, show: Callable[[str], str]) -> str:
    """At most so many entries, the indirect ones in italics, and the number of the others."""
    shown = [show(name) if index < found.direct else f"*{show(name)}*" for index, name in enumerate(found.names[:most])]
    more = len(found.names) - most
    return ", ".join(shown) + (f" +{more}" if more > 0 else "")


def _reasons(matrix: Matrix) -> list[str]:
    """One line for the requirements that lack the same columns for the same reason."""
    lines: dict[tuple[str, str, str], list[str]] = {}
    for name, cells in matrix.cells().items():
        for kind, reason in dict.fromkeys((cell.kind, cell.reason) for cell in cells.values() if cell.reason):
            without = [column for column, cell in cells.items() if cell.reason == reason]
            lines.setdefault((", ".join(without), kind, reason), []).append(name)
    return [f"| {', '.join(names)} | {' | '.join(line)} |\n" for line, names in lines.items()]

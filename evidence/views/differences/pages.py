"""The pages of the differences and of the experiments, from the programs that are kept."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations
from typing import Any

from evidence.views.differences.shorter import SHORTEST
from s7check.asking.line_text import spelled
from s7check.engine.client import Engine
from s7check.kit.layout import to_text
from s7check.kit.program import Program
from s7check.kit.scl import NotForCpuError, to_scl
from s7check.report.clauses import all_clauses, clause, page_of
from s7check.simulating.kept import Gap, Kept, read_gaps
from s7check.simulating.shortest import searched
from s7check.simulating.two_sides import log_of_refused, side_by_side

SOURCES = "experiments"
"""The folder of the SCL sources, beside the page."""

_DIFFERENCES = """# Differences between CPUs and between editions

Each row is a program of the kit whose log one side may write and the other may not, at the line that is named.
`s7check kit show NAME > program.json` and `s7check compare program.json --cpu ... --cpu ...` show both timelines. A
test runs every one, at every revision; what was searched for a shorter one is of the revision of the search.

"""

_EXPERIMENTS = """# Experiments for the open questions

A program decides between two letters of a [question](readings.md) that the manuals leave open: run it on a CPU that
writes its log, and look at the line that is marked. `s7check decide` reads the letters from the logs. Each program is
one of the kit, or that of a log that was found by search; its SCL source is beside it. What was searched for a shorter
log stands under each: all logs of so many lines, behind the same header, at the revision of the search.

"""

_SETTLED = """## What a run of all of them on one CPU would settle

At best: where one letter allows all that another does and more, a CPU that never makes use of it leaves both. "All but
a from c" says that no program here tells these two apart.

| question | letters | settled |
|---|---|---|
"""

_REST = """## Without an experiment

No log is known that tells these letters apart: neither of a program of the kit, nor a shipped one, nor one that the
search has found. It tried all lines that the specification offers behind a header, then those of the events that are
named, in either direction. That is a bound, and no proof that there is no such log.

| question | letters | searched |
|---|---|---|
"""

_WITHOUT_LETTERS = "the specification has one of the letters only ([why](readings.md#why-the-others-have-no-constant))"


def verified(engine: Engine, all_kept: Iterable[Kept]) -> Iterator[Kept]:
    """Those that still tell their sides apart at their line."""
    return (one for one in all_kept if one.again(engine) is not None)


def differences_page(engine: Engine, all_kept: list[Kept]) -> str:
    """A table for each pair."""
    pairs = dict.fromkeys((one.allowed.variant.name, one.refused.variant.name) for one in all_kept)
    text = [_DIFFERENCES, *_shortest(engine, all_kept)]
    for pair in pairs:
        text.append(
            f"## {pair[0]} may, {pair[1]} may not\n\n| program | line | by | not by | about |\n|---|---|---|---|---|\n"
        )
        text += [
            _row(one)
            for one in all_kept
            if (one.allowed.variant.name, one.refused.variant.name) == pair and not one.name.startswith(SHORTEST)
        ]
        text.append("\n")
    return "".join(text).rstrip() + "\n"


def _shortest(engine: Engine, all_kept: list[Kept]) -> Iterator[str]:
    """The shortest log for each two sides, with what was searched."""
    yield "## The shortest\n\nFound by search, breadth first, below the logs of the kit's programs.\n\n"
    for one in all_kept:
        if one.name.startswith(SHORTEST):
            yield f"### {one.allowed.variant.name} may, {one.refused.variant.name} may not\n\n"
            yield _told(engine, one)
            yield f"{_searched(one)}\n\n{_details(one.read())}"
    yield "Of S7-400 and CPU 318 no program of the kit has a log that only one of them allows.\n\n"


def _searched(one: Kept) -> str:
    """What was searched for a shorter log."""
    return f"Searched for a shorter one: {'; '.join(searched(len(one.lines), one.bounds))}."


def _told(engine: Engine, one: Kept) -> str:
    """Both timelines and the clauses."""
    found = one.again(engine)
    other = [one.header] if found is None else log_of_refused(engine, found)
    mine = [one.header, *one.lines]
    names = one.allowed.variant.name, one.refused.variant.name
    timelines = side_by_side(names[0], mine, names[1], other, one.line)
    said = f"Under {names[1]} line {one.line} is not possible: {_ids(one.requirements)}."
    return "```\n" + "\n".join(timelines) + f"\n```\n\n{said} "


def _details(program: Program) -> str:
    text = f"<details><summary>program {program.name}</summary>\n\n"
    return f"{text}```json\n{to_text(program.raw)}```\n\n</details>\n\n"


def _row(one: Kept) -> str:
    line = spelled(one.lines[-1]).replace("|", "\\|")
    name = one.program["name"]
    cells = [f"`{name}`", f"{one.line}: `{line}`", _ids(one.grounds), _ids(one.requirements), one.program["about"]]
    return f"| {' | '.join(cells)} |\n"


def _ids(names: list[str]) -> str:
    return ", ".join(f"[{name}]({_page(name)}#{name})" for name in names)


def _page(name: str) -> str:
    return page_of(name)


def _letters() -> dict[str, list[str]]:
    return {one.id: sorted(one.letters) for one in all_clauses() if one.letters}


def untold(all_kept: Iterable[Kept]) -> dict[str, list[tuple[str, str]]]:
    """The pairs of letters of each question that no experiment tells apart."""
    apart = {frozenset({one.allowed.letters[0], one.refused.letters[0]}) for one in all_kept}
    return {
        name: [pair for pair in combinations(letters, 2) if frozenset((name, x) for x in pair) not in apart]
        for name, letters in sorted(_letters().items())
    }


def settled_table(all_kept: Iterable[Kept]) -> str:
    """What a run of all experiments would settle, as a section of the page."""
    left = untold(all_kept)
    letters = _letters()
    pairs = {name: len(those) * (len(those) - 1) // 2 for name, those in letters.items()}
    rows = [
        f"| [{name}](readings.md#{name}) | {', '.join(letters[name])} | {_left(found, pairs[name])} |\n"
        for name, found in left.items()
    ]
    whole = sum(not found for found in left.values())
    part = sum(0 < len(found) < pairs[name] for name, found in left.items())
    count = f"Of {len(left)} questions it settles {whole} to one letter and {part} in part.\n\n"
    return "".join([_SETTLED, *rows, "\n", count])


def _left(found: list[tuple[str, str]], pairs: int) -> str:
    if len(found) == pairs:
        return "nothing"
    return f"all but {', '.join(f'{one} from {other}' for one, other in found)}" if found else "one letter is left"


def sources(all_kept: Iterable[Kept]) -> dict[str, str]:
    """The SCL source of each program that a CPU can run, by its name."""
    found = {}
    for one in all_kept:
        try:
            found[one.program["name"]] = to_scl(one.read())
        except NotForCpuError:
            continue
    return found


def _source(name: str, found: dict[str, str]) -> str:
    if name not in found:
        return "It has no SCL source: a program of a CPU cannot bring about all of its steps.\n\n"
    return f"Its source for STEP 7, which no CPU has run yet: [{name}.scl]({SOURCES}/{name}.scl).\n\n"


def experiments_page(engine: Engine, all_kept: list[Kept]) -> str:
    """What the experiments settle; question, program and timelines of each; then the questions without one."""
    text = [_EXPERIMENTS, settled_table(all_kept)]
    scl = sources(all_kept)
    told = set()
    for one in all_kept:
        ((name, first),), ((_, second),) = one.allowed.letters, one.refused.letters
        told.add(name)
        found = clause(name)
        letters = "; ".join(found.letters.get(letter, letter) for letter in sorted((first, second)))
        text.append(f"## {name}: {first} against {second}\n\n{found.text} {letters}\n\n")
        text.append(f"{_told(engine, one)}{_searched(one)}\n\n")
        text.append(_source(one.program["name"], scl))
        text.append(_details(one.read()))
    return "".join([*text, _REST, *_gaps(read_gaps())])


def _gaps(gaps: Iterable[Gap]) -> Iterator[str]:
    """What is known of the pairs of letters without an experiment."""
    for gap in gaps:
        name, pair = gap.ambiguity, " against ".join(gap.letters)
        header = ""
        if not gap.searched:
            said = "newer than the last search"
        elif gap.bounds:
            said = "; ".join(dict.fromkeys(bound.text() for bound in gap.bounds))
            header = f", behind `{{{_header(gap.header)}}}`"
        else:
            said = _WITHOUT_LETTERS
        yield f"| [{name}](readings.md#{name}) | {pair} | {said}{header} |\n"


def _header(header: dict[str, Any]) -> str:
    return ", ".join(f"{name}: {value}" for name, value in header.items() if name not in ("format", "clock"))

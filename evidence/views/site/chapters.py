"""docs/rules/book.md: the chapters of the book, each with its sentences, its rules and its tables."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from evidence.common.checkout import ROOT
from evidence.tla.modules import reached
from evidence.views.traceability.modules import Definition
from evidence.views.traceability.project import Project
from evidence.views.traceability.roles import SYSTEM, rules
from s7check.report import clauses

BOOK = Path("docs/rules/book.md")
_CODE = re.compile(r"`(\w+)`")
_NAME = re.compile(r"[A-Z][a-z0-9]+[A-Z]\w*")
"""How the names of definitions look that no other word in the documents does."""

_TOLD = ("docs/rules/*.md", "spec/README.md")
"""The documents that tell of spec/."""


@dataclass(frozen=True)
class Chapter:
    """A chapter: its title, its page without ``.html``, its sentences in Markdown, its rules and its tables by name."""

    title: str
    page: str
    told: str
    rules: tuple[str, ...]
    tables: tuple[str, ...]


def read_chapters(requirements: Iterable[str], root: Path = ROOT) -> tuple[str, list[Chapter]]:
    """What stands before the chapters, and the chapters. Raises ValueError, OSError."""
    before, *parts = (root / BOOK).read_text(encoding="utf-8").split("\n## ")
    return before, [_chapter(part, tuple(requirements)) for part in parts]


def homes_of(chapters: Iterable[Chapter]) -> dict[str, str]:
    """The place of each rule and each open question in the site, by its ID."""
    rules = {name: f"book/{chapter.page}.html#{name}" for chapter in chapters for name in chapter.rules}
    questions = [one.id for one in clauses.all_clauses() if clauses.is_question(one.id)]
    return rules | {name: f"rules/{clauses.page_of(name).removesuffix('.md')}.html#{name}" for name in questions}


def _chapter(text: str, requirements: tuple[str, ...]) -> Chapter:
    title, _, rest = text.partition("\n")
    told, _, lists = rest.partition("\nRules: ")
    chosen, _, tables = lists.partition("\nTables: ")
    if not chosen:
        raise ValueError(f"{BOOK}: {title}: expected a line `Rules: TINT-30 to TINT-40, ...`")
    named = tuple(name for part in chosen.split(",") for name in _range(part.strip(), requirements))
    page = re.sub(r"\W+", "-", title.partition(":")[0].lower())
    return Chapter(title, page, told.strip(), named, tuple(one.strip() for one in tables.split(",") if one.strip()))


def _range(text: str, requirements: tuple[str, ...]) -> list[str]:
    """The requirements from one to another, in the order of the documents."""
    first, _, last = text.partition(" to ")
    for name in filter(None, (first, last)):
        if name not in requirements:
            raise ValueError(f"{BOOK}: {name} does not exist")
    (area, low), (_, high) = first.split("-"), (last or first).split("-")
    numbers = [f"{area}-{number:02}" for number in range(int(low), int(high) + 1)]
    return [one for one in requirements if one in numbers]


def problems(project: Project, root: Path = ROOT) -> list[str]:
    """Where sentences and formulas part, a line for each. Raises ValueError, OSError."""
    _, chapters = read_chapters(project.requirements, root)
    places = Counter(rule for chapter in chapters for rule in chapter.rules)
    return [
        *(f"{BOOK}: {name} stands in no chapter" for name in project.requirements if not places[name]),
        *(f"{BOOK}: {name} stands in {count} chapters" for name, count in places.items() if count > 1),
        *_undefined(project, root),
        *_untold(project, "\n".join(chapter.told for chapter in chapters)),
    ]


def _undefined(project: Project, root: Path) -> Iterator[str]:
    """Names in the documents that spec/ does not define; in the book any word in backticks is one."""
    known = {d.name for module in project.spec for d in module.definitions} | {module.name for module in project.spec}
    for path in sorted(path for pattern in _TOLD for path in root.glob(pattern)):
        for name in dict.fromkeys(_CODE.findall(path.read_text(encoding="utf-8"))):
            if name not in known and (path == root / BOOK or _NAME.fullmatch(name)):
                yield f"{path.relative_to(root)}: `{name}`: no definition of spec/ has this name"


def actions(project: Project) -> list[Definition]:
    """The actions of System: what `Next` consists of, and an observer sees."""
    system = {d.name: d for module in project.spec if module.name == SYSTEM for d in module.definitions}
    found = reached(["Next"], {name: d.words for name, d in system.items()}) - {"Seen"}
    return sorted((system[name] for name in found if system[name].words & {"Seen", "Step"}), key=lambda d: d.line)


def _untold(project: Project, told: str) -> Iterator[str]:
    """Actions that no sentence names, and tags of formulas that are no rule."""
    names = set(_CODE.findall(told))
    missing = [d for d in actions(project) if d.name not in names]
    yield from (f"{SYSTEM}.tla:{d.line}: no sentence of {BOOK} names {d.name}" for d in missing)
    known = {*project.requirements, *project.ambiguities}
    for module in rules(project.spec):
        for d in module.definitions:
            yield from (f"{module.name}.tla:{d.line}: {tag} has no sentence" for tag in d.tags if tag not in known)


def definition_named(project: Project, name: str) -> Definition:
    """The definition with a name that `problems` has not objected to: a rule before a property."""
    ordered = [*rules(project.spec), *project.spec]
    return next(d for module in ordered for d in module.definitions if d.name == name)

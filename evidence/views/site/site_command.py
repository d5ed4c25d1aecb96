"""``s7spec views site``: the docs, the specification and the gallery as static pages."""

from __future__ import annotations

import html
import re
import shutil
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, replace
from importlib.resources import files
from pathlib import Path

import click
import msgspec
from markdown_it import MarkdownIt

from evidence.common import gallery
from evidence.common.cases import all_cases
from evidence.common.checkout import ROOT
from evidence.common.console import plain
from evidence.common.options import folder_option
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.tla.tlc import ToolMissingError
from evidence.views.made import views
from evidence.views.site.book import Page, Parts, editions
from evidence.views.site.chapters import homes_of, problems, read_chapters
from evidence.views.site.documents import Document, Section, document, page_of, relative
from evidence.views.site.documents import plain as plain_words
from evidence.views.site.front import front_page
from evidence.views.site.linked import TAG, Linked, with_links
from evidence.views.site.logs import EXPLORER, Logs, drawable, picture
from evidence.views.site.modules import module_page
from evidence.views.site.tables import Tables
from evidence.views.traceability.matrix import build
from evidence.views.traceability.project import REQUIREMENTS, REQUIREMENTS_S7_1500, Project, read_project
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.report import clauses
from s7check.report.markup import as_text
from s7check.report.timeline import legend, patterns
from s7check.resources import PAGE, modules
from s7check.simulating.kept import EXPERIMENTS, read_kept

_MENU = {
    "index.html": "start",
    "book.html": "book",
    "gallery.html": "edge cases",
    "README.html": "documentation",
    "rules/requirements.html": "requirements",
    "rules/readings.html": "readings",
    "modules.html": "specification",
}


_REVIEW = "rules/review.html"
_GENERATED = ("book.html", "gallery.html", _REVIEW)
_IN_OTHER_WORDS = tuple(f"rules/{n}.html" for n in ("requirements", "requirements-s7-1500", "readings", "traceability"))
"""Pages of rules and questions, each of which the search has by itself."""
SEARCH = ROOT / "build/npm/node_modules/minisearch/dist/umd/index.js"
"""MiniSearch, which `make site` installs."""


@click.command(name="site", short_help="Docs, specification and gallery as static pages.")
@folder_option("--output", Path("build") / "site", "The folder; its old content is removed.")
def site_command(output: Path) -> int:
    """Write the pages, with the explorer if `make page` has built it.

    They load nothing from elsewhere and work from the file system.
    """
    with session(Processes(), (OSError, ValueError), (EngineError, ToolMissingError)) as console:
        project = read_project(ROOT)
        if found := problems(project):
            raise ValueError("\n".join(found))
        if not SEARCH.is_file():
            raise ValueError(f"{SEARCH.relative_to(ROOT)} is not there: run `make site`, which installs it")
        with Engine() as engine:
            made = {ROOT / place: text for place, text in views(project, engine).items()}
            pages = dict(_pages(project, made, engine))
        if output.exists():
            shutil.rmtree(output)
        for place, page in pages.items():
            path = output / place
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(_whole(place, page), encoding="utf-8")
        for source in sorted({file for page in pages.values() for file in page.files}):
            target = output / page_of(source)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(made[source].encode() if source in made else source.read_bytes())
        _write_extras(output, [section for page in pages.values() for section in page.sections])
        plain(console, f"{len(pages)} pages in {output}")
    return 0


def _pages(project: Project, made: Mapping[Path, str], engine: Engine) -> Iterator[tuple[str, Document]]:
    kept = {source: source.read_text(encoding="utf-8") for source in (ROOT / "docs").rglob("*.md")}
    for source, text in sorted({**kept, **made}.items()):
        place = page_of(source)
        if source.suffix == ".md" and place not in _GENERATED:
            page = document(source, text, place, made)
            yield place, replace(page, sections=[]) if place in _IN_OTHER_WORDS else page
    yield from _generated(project, made, engine)


def _generated(project: Project, made: Mapping[Path, str], engine: Engine) -> Iterator[tuple[str, Document]]:
    """The modules of spec/ and the chapters of the book, which lead to each other."""
    before, chapters = read_chapters(project.requirements)
    homes = homes_of(chapters)
    places = {source.stem: page_of(source) for source in modules(ROOT / "spec")}
    linked = Linked(project.spec, places, lambda name: homes.get(name, ""))

    def addressed(place: str) -> Callable[[str], str]:
        return lambda to: relative(homes.get(to, to), place)

    known = project.requirements | project.ambiguities
    for module in project.spec:
        place = places[module.name]
        body = module_page(module, linked, known, addressed(place))
        names = [Section(linked.place(d), d.name, " ".join(d.tags), module.name) for d in module.definitions]
        yield place, Document(module.name, body, [Section(place, module.name, "module of the specification"), *names])
    links = " ".join(f'<a href="{place}">{name}</a>' for name, place in places.items())
    yield "modules.html", Document("The specification", f"<h1>The specification</h1><p>{links}</p>")
    yield "index.html", front_page(engine, addressed("index.html"), explorer=PAGE.is_file())
    topics = {name: chapter.title for chapter in chapters for name in chapter.rules}
    yield "gallery.html", _gallery(engine, addressed("gallery.html"), topics)
    parts = _parts(project, linked, engine)
    source = ROOT / "docs" / "rules" / "review.md"
    review = document(source, source.read_text(encoding="utf-8"), _REVIEW, made)
    yield _REVIEW, replace(review, body=_told(review.body, parts.logs, homes, addressed(_REVIEW)))
    bodies = []
    for chapter in chapters:
        place = f"book/{chapter.page}.html"
        bodies.append(Page(parts, chapter, addressed(place)).body())
        sections = [Section(place, chapter.title, plain_words(chapter.told), "The book", weight=4)]
        sections += [_rule(homes[name], known[name], chapter.title) for name in chapter.rules]
        yield place, Document(chapter.title, as_text(patterns()) + bodies[-1], sections)
    yield "book/whole.html", Document("The book", as_text(patterns()) + "".join(bodies))
    items = "".join(f'<li><a href="book/{one.page}.html">{html.escape(one.title)}</a></li>' for one in chapters)
    questions = [_rule(homes[name], asked, "Readings") for name, asked in project.ambiguities.items()]
    whole = '<p><a href="book/whole.html">All chapters on one page</a>, to print.</p>'
    yield "book.html", Document("The book", f"{MarkdownIt().render(before)}<ol>{items}</ol>{whole}", questions)


def _rule(place: str, one: clauses.Clause, within: str) -> Section:
    weight = 1 if "15-" in one.id else 5
    return Section(place, one.id, " ".join([plain_words(one.text), *one.letters.values()]), within, weight)


def _parts(project: Project, linked: Linked, engine: Engine) -> Parts:
    pages = [(ROOT / page).read_text(encoding="utf-8") for page in (REQUIREMENTS, REQUIREMENTS_S7_1500)]
    return Parts(
        project,
        build(project),
        linked,
        Logs(all_cases(), engine),
        read_kept(EXPERIMENTS),
        editions(*pages),
        dict(engine.alternatives().defaults),
        Tables(project.spec, linked),
        explorer=PAGE.is_file(),
    )


def _told(body: str, logs: Logs, homes: Mapping[str, str], to: Callable[[str], str]) -> str:
    """The told cases: an ID leads to its rule or question, the name of a log to the explorer with it."""

    def link(found: re.Match[str]) -> str:
        case = logs.named(found["log"] or "")
        if case is not None and PAGE.is_file():
            return f'<a class="log" href="{to(logs.opened(case))}">{case.name}</a>'
        return f'<a href="{to(found[0])}">{found[0]}</a>' if found[0] in homes else found[0]

    return re.sub(rf"<a [^>]*>(?P<log>[^<]*)</a>|<[^>]*>|{TAG.pattern}", link, body)


def _gallery(engine: Engine, to: Callable[[str], str], topics: Mapping[str, str]) -> Document:
    """The edge cases, each with its timeline, below a list of them by the topic of their first rule."""
    parts = []
    sections = []
    logs = set()
    contents: dict[str, str] = {}
    gallery.write()
    for case in gallery.cases():
        log = gallery.LOGS / f"{case.name}.ndjson"
        run = f'<a class="run" href="{EXPLORER}#open={case.name}">run this</a>; ' if PAGE.is_file() else ""
        ids = ", ".join(f'<a href="{to(name)}">{name}</a>' for name in case.requirements)
        title = html.escape(case.title)
        parts.append(
            f'<section id="{case.name}"><h2>{title}</h2><p>{with_links(case.told, to)}</p>'
            f'{picture(drawable(log, engine))}<p>{run}{ids}; <a href="{page_of(log)}">log as a file</a></p></section>'
        )
        topic = topics[case.requirements[0]]
        contents[topic] = contents.get(topic, "") + f'<li><a href="#{case.name}">{title}</a></li>'
        events = dict.fromkeys(re.findall(rb'"event": "(\w+)"', case.log))
        words = f"{case.told} In its log: {b', '.join(events).decode()}."
        sections.append(Section(f"gallery.html#{case.name}", case.title, words, "Edge cases"))
        logs.add(log)
    order = [topic for topic in dict.fromkeys(topics.values()) if topic in contents]
    topical = [f"<li>{html.escape(topic)}<ul>{contents[topic]}</ul></li>" for topic in order]
    longer = f'<p><a href="{_REVIEW}">Longer cases</a> are told step by step.</p>'
    head = f'<h1>Edge cases</h1>{longer}<ul class="contents">{"".join(topical)}</ul>{as_text(legend())}'
    return Document("Edge cases", "\n".join([head, *parts]), sections, logs)


def _whole(place: str, page: Document) -> str:
    root = relative("index.html", place).removesuffix("index.html")
    places = _MENU | ({EXPLORER: "explorer"} if PAGE.is_file() else {})
    menu = "".join(f'<a href="{root}{to}">{name}</a>' for to, name in places.items())
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{html.escape(page.title)}</title>"
        f'<link rel="icon" href="data:,"><link rel="stylesheet" href="{root}report.css">'
        f'<link rel="stylesheet" href="{root}site.css"></head><body>'
        f'<nav>{menu}<input id="search" type="search" placeholder="Search" aria-label="Search" '
        f'data-root="{root}"></nav>'
        f'<ul id="found"></ul><main>{page.body}</main>'
        f'<script src="{root}site.js"></script></body></html>\n'
    )


def _write_extras(output: Path, sections: list[Section]) -> None:
    index = msgspec.json.encode([asdict(one) for one in sections]).decode()
    (output / "index.js").write_text(f"const INDEX = {index};\n", encoding="utf-8")
    (output / "report.css").write_bytes((files("s7check.report") / "report.css").read_bytes())
    if PAGE.is_file():
        shutil.copy(PAGE, output / EXPLORER)
    shutil.copy(SEARCH, output / "minisearch.js")
    for name in ("site.css", "site.js"):
        (output / name).write_bytes((files(__package__) / name).read_bytes())

"""``s7spec views site``: the docs, the specification and the gallery as static pages."""

from __future__ import annotations

import html
import shutil
from collections.abc import Iterator, Mapping
from importlib.resources import files
from pathlib import Path

import click
import msgspec

from evidence.common import gallery
from evidence.common.checkout import ROOT
from evidence.common.console import plain
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.views.made import views
from evidence.views.site.documents import Document, Section, document, page_of, relative
from evidence.views.site.modules import formulas, module_page
from evidence.views.traceability.errors import UnreadableError
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.check import check_log
from s7check.judging.replay import Replay, with_steps
from s7check.report.clauses import all_clauses
from s7check.report.markup import as_text
from s7check.report.timeline import legend, timeline
from s7check.resources import PAGE, modules

_MENU = {
    "index.html": "documentation",
    "gallery.html": "edge cases",
    "rules/requirements.html": "requirements",
    "rules/readings.html": "readings",
    "modules.html": "specification",
}
_EXPLORER = "explorer.html"
"""The page of `make page`, if it was built."""


@click.command(name="site", short_help="Docs, specification and gallery as static pages.")
@click.option(
    "--output",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("build") / "site",
    show_default=True,
    help="The folder; its old content is removed.",
)
def site_command(output: Path) -> int:
    """Write the pages, with the explorer if `make page` has built it.

    They load nothing from elsewhere and work from the file system.
    """
    with session(Processes(), (OSError, ValueError, UnreadableError), (EngineError,)) as console:
        made = {ROOT / place: text for place, text in views().items()}
        pages = dict(_pages(made))
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


def _pages(made: Mapping[Path, str]) -> Iterator[tuple[str, Document]]:
    kept = {source: source.read_text(encoding="utf-8") for source in (ROOT / "docs").rglob("*.md")}
    for source, text in sorted({**kept, **made}.items()):
        if source.suffix == ".md":
            place = "index.html" if source.name == "README.md" else page_of(source)
            yield place, document(source, text, place, made)
    yield from _modules()
    yield "gallery.html", _gallery()


def _modules() -> Iterator[tuple[str, Document]]:
    """A page for each module, and a page with the formulas of each requirement."""
    clauses = {clause.id: clause for clause in all_clauses()}
    sources = modules(ROOT / "spec")
    texts = {source.stem: source.read_text(encoding="utf-8") for source in sources}
    places = {source.stem: page_of(source) for source in sources}
    for name, text in texts.items():
        yield (
            places[name],
            Document(name, module_page(name, text, clauses, places), [Section(places[name], name, text)]),
        )
    rows = []
    for name, found in sorted(formulas(places, texts, clauses).items()):
        links = " ".join(f'<a href="{place}">{Path(place).stem}</a>' for place in found)
        rows.append(f'<tr id="{name}"><td>{name}</td><td>{html.escape(clauses[name].text)}</td><td>{links}</td></tr>')
    links = " ".join(f'<a href="{place}">{name}</a>' for name, place in places.items())
    table = f"<h2>Requirements and their formulas</h2><table>{''.join(rows)}</table>"
    yield "modules.html", Document("The specification", f"<h1>The specification</h1><p>{links}</p>{table}")


def _gallery() -> Document:
    """The edge cases, each with its timeline."""
    parts = ["<h1>Edge cases</h1>", as_text(legend())]
    sections = []
    logs = set()
    with Engine() as engine:
        gallery.write()
        for case in gallery.cases():
            log = gallery.LOGS / f"{case.name}.ndjson"
            report = check_log(str(log), engine, lambda *_: None)
            picture = timeline(with_steps(report, engine, Replay(str(log), [])))
            drawn = "" if picture is None else as_text(picture.labels) + as_text(picture.lanes)
            run = f', <a href="{_EXPLORER}#open={case.name}">run this</a>' if PAGE.is_file() else ""
            ids = ", ".join(f'<a href="rules/requirements.html#{name}">{name}</a>' for name in case.requirements)
            parts.append(
                f'<section id="{case.name}"><h2>{html.escape(case.title)}</h2><p>{html.escape(case.told)}</p>'
                f'<div class="scroll">{drawn}</div><p>{ids}; <a href="{page_of(log)}">log</a>{run}</p></section>'
            )
            sections.append(Section(f"gallery.html#{case.name}", case.title, case.told))
            logs.add(log)
    return Document("Edge cases", "\n".join(parts), sections, logs)


def _whole(place: str, page: Document) -> str:
    root = relative("index.html", place).removesuffix("index.html")
    places = _MENU | ({_EXPLORER: "explorer"} if PAGE.is_file() else {})
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
        f'<script src="{root}index.js"></script><script src="{root}search.js"></script></body></html>\n'
    )


def _write_extras(output: Path, sections: list[Section]) -> None:
    index = msgspec.json.encode([[one.place, one.title, one.text] for one in sections]).decode()
    (output / "index.js").write_text(f"const INDEX = {index};\n", encoding="utf-8")
    (output / "report.css").write_bytes((files("s7check.report") / "report.css").read_bytes())
    if PAGE.is_file():
        shutil.copy(PAGE, output / _EXPLORER)
    for name in ("site.css", "search.js"):
        (output / name).write_bytes((files(__package__) / name).read_bytes())

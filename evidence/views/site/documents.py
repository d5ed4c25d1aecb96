"""The pages of docs/ as HTML, with links that lead to pages of the site."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Container, Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token

from evidence.common.checkout import ROOT
from evidence.views.site.chapters import BOOK

_ADDRESS = re.compile(r"(?P<path>[^#]*)(?P<anchor>#.*)?")
_OWN_PAGES = {BOOK.as_posix(): "book.html", "docs/rules/gallery.md": "gallery.html"}
"""Documents in whose place the site has a page of its own."""
_BEHIND = ("project/", "rules/migration-")
"""Pages whose sections come last in the search."""
_NO_WORD = re.compile(r"[^\w\- ]")
_TAG = re.compile(r"<[^>]*>")


@dataclass
class Section:
    """A part of a page that the search can find: its place in the site, its title, its text, without Markdown.

    `within` is the title of what it is a part of; of two parts with the same words that with more `weight` comes first.
    """

    place: str
    title: str
    text: str
    within: str = ""
    weight: float = 1


@dataclass
class Document:
    """A page: its title, its body, its sections, and the files of the checkout that it refers to."""

    title: str
    body: str
    sections: list[Section] = field(default_factory=list)
    files: set[Path] = field(default_factory=set)


def document(source: Path, text: str, place: str, views: Container[Path]) -> Document:
    """Render Markdown as the page `place`, such as ``rules/review.html``.

    `source` is the file of the checkout that has the text, or would have it; `views` are files that would be there.
    """
    parser = MarkdownIt("commonmark", {"html": True}).enable("table")
    tokens = parser.parse(text)
    files: set[Path] = set()
    for link in (child for token in tokens for child in token.children or [] if child.type == "link_open"):
        link.attrs["href"] = _address(str(link.attrs["href"]), source, place, views, files.add)
    sections = list(_sections(tokens, place))
    title = sections[0].title if sections else source.stem
    return Document(title, parser.renderer.render(tokens, parser.options, {}), sections, files)


def page_of(path: Path) -> str:
    """The place in the site of a file of the checkout."""
    inside = path.relative_to(ROOT).as_posix()
    if inside in _OWN_PAGES:
        return _OWN_PAGES[inside]
    if inside.startswith("docs/") and inside.endswith(".md"):
        return inside.removeprefix("docs/").removesuffix(".md") + ".html"
    if inside.startswith("spec/") and inside.endswith(".tla"):
        return inside.removesuffix(".tla") + ".html"
    return f"files/{inside}"


@cache
def relative(to: str, place: str) -> str:
    """The address of a place of the site on the page at another one."""
    return Path(os.path.relpath(to, Path(place).parent)).as_posix()


def _address(address: str, source: Path, place: str, views: Container[Path], refer: Callable[[Path], None]) -> str:
    if "://" in address or address.startswith("#"):
        return address
    found = _ADDRESS.fullmatch(address)
    assert found is not None
    target = (source.parent / found["path"]).resolve()
    if not (target.is_file() or target in views) or not target.is_relative_to(ROOT):
        return "#"
    to = page_of(target)
    if to.startswith("files/"):
        refer(target)
    return relative(to, place) + (found["anchor"] or "")


def _sections(tokens: list[Token], place: str) -> Iterator[Section]:
    """Each heading with the text below it; the headings get anchors as the docs' links have them."""
    current: Section | None = None
    whole = ""
    for token, following in zip(tokens, [*tokens[1:], None], strict=True):
        if token.type == "heading_open" and following is not None:
            if current is not None:
                yield current
            title = _words(following)
            anchor = _NO_WORD.sub("", _TAG.sub("", following.content).lower()).replace(" ", "-")
            token.attrs["id"] = anchor
            weight = 0.3 if place.startswith(_BEHIND) else 1
            current = Section(f"{place}#{anchor}", title, "", whole, weight)
            whole = whole or title
        elif token.type == "inline" and current is not None and _words(token) != current.title:
            current.text += f" {_words(token)}"
    if current is not None:
        yield current


def plain(markdown: str) -> str:
    """The words of a line of Markdown."""
    return _words(MarkdownIt("commonmark").parseInline(markdown)[0])


def _words(token: Token) -> str:
    breaks = ("softbreak", "hardbreak")
    children = [child for child in token.children or [] if child.type != "html_inline"]
    return "".join(" " if child.type in breaks else child.content for child in children)

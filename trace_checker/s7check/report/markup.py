"""HTML and SVG as trees, so that every text is escaped when they are written."""

from collections.abc import Mapping
from xml.etree import ElementTree as Xml

Node = Xml.Element


def node(tag: str, *content: "Node | str | None", **attributes: str | float) -> Node:
    """An element; of attribute names a last underscore is dropped and others become hyphens."""
    made = Xml.Element(tag, _attributes(attributes))
    add(made, *content)
    return made


def add(to: Node, *content: "Node | str | None") -> Node:
    """Puts elements and texts at the end of an element, and returns it."""
    for part in content:
        if part is None:
            continue
        if isinstance(part, str):
            _add_text(to, part)
        else:
            to.append(part)
    return to


def as_text(element: Node) -> str:
    """An element as it stands in a page."""
    text: str = Xml.tostring(element, encoding="unicode")
    return text


def document(title: str, style: str, script: str, *content: Node) -> bytes:
    """A whole page that needs nothing else."""
    head = node(
        "head",
        node("meta", charset="utf-8"),
        node("meta", name="viewport", content="width=device-width, initial-scale=1"),
        node("title", title),
        node("style", style),
    )
    body = node("body", node("main", *content), node("script", script))
    page: bytes = Xml.tostring(node("html", head, body, lang="en"), encoding="utf-8", method="html")
    return b"<!DOCTYPE html>\n" + page + b"\n"


def _attributes(given: Mapping[str, str | float]) -> dict[str, str]:
    return {
        name.rstrip("_").replace("_", "-"): value if isinstance(value, str) else f"{value:g}"
        for name, value in given.items()
    }


def _add_text(to: Node, text: str) -> None:
    if len(to):
        to[-1].tail = (to[-1].tail or "") + text
    else:
        to.text = (to.text or "") + text

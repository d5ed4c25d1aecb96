"""The modules of spec/ as pages: each formula beside the requirements that its comment names."""

from __future__ import annotations

import html
import re
from collections.abc import Mapping

from evidence.views.site.documents import relative
from s7check.report.clauses import Clause, page_of

_TAG = re.compile(r"\b(?:[A-Z]{3,4}|[AT]15)-\d{2,}\b")
_EXTENDS = re.compile(r"\b[A-Z]\w+\b")


def module_page(name: str, text: str, clauses: Mapping[str, Clause], modules: Mapping[str, str]) -> str:
    """The body of a module's page. `modules` has the places of all pages of modules by name."""
    place = modules[name]
    rows = []
    number = 1
    for block in re.split(r"(?<=\n)\n+", text):
        named = dict.fromkeys(tag for tag in _TAG.findall(block) if tag in clauses)
        beside = "".join(_clause(clauses[tag], place) for tag in named)
        code = _code(block.rstrip("\n"), clauses, modules, place)
        rows.append(f'<tr id="L{number}"><td><pre>{code}</pre></td><td class="beside">{beside}</td></tr>')
        number += block.count("\n") + 1
    return f"<h1>{html.escape(name)}</h1>\n<table class='module'>{''.join(rows)}</table>"


def _clause(clause: Clause, place: str) -> str:
    address = relative(_place(clause.id), place)
    return f'<p><a href="{address}">{clause.id}</a> {html.escape(clause.text)}</p>'


def _place(name: str) -> str:
    page = f"rules/{page_of(name).removesuffix('.md')}.html"
    return f"{page}#{name}"


def _code(block: str, clauses: Mapping[str, Clause], modules: Mapping[str, str], place: str) -> str:
    """The text with links from tags to requirements, and from the names after EXTENDS to modules."""
    text = html.escape(block, quote=False)
    text = _TAG.sub(lambda m: _link(m[0], relative(_place(m[0]), place)) if m[0] in clauses else m[0], text)
    if text.startswith("EXTENDS"):
        text = _EXTENDS.sub(lambda m: _link(m[0], relative(modules[m[0]], place)) if m[0] in modules else m[0], text)
    return text


def _link(text: str, address: str) -> str:
    return f'<a href="{address}">{text}</a>'


def formulas(modules: Mapping[str, str], texts: Mapping[str, str], names: Mapping[str, Clause]) -> dict[str, list[str]]:
    """For each requirement the addresses of the formulas whose comments name it, as ``Module, line 12`` links."""
    found: dict[str, list[str]] = {}
    for module, text in texts.items():
        number = 1
        for block in re.split(r"(?<=\n)\n+", text):
            for tag in dict.fromkeys(_TAG.findall(block)):
                if tag in names:
                    found.setdefault(tag, []).append(f"{modules[module]}#L{number}")
            number += block.count("\n") + 1
    return found

"""The modules of spec/ as pages: each formula beside the requirements that its comment names."""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterator, Mapping

from evidence.views.site.linked import TAG, Linked
from evidence.views.traceability.modules import Module
from s7check.report.clauses import Clause


def module_page(module: Module, linked: Linked, clauses: Mapping[str, Clause], to: Callable[[str], str]) -> str:
    """The body of a module's page; `to` makes the address of a place, or of an ID in `clauses`, on that page."""
    rows = []
    for start, end in _blocks(module.text):
        block = module.text[start:end]
        named = dict.fromkeys(tag for tag in TAG.findall(block.decode()) if tag in clauses)
        beside = "".join(f'<p><a href="{to(tag)}">{tag}</a> {html.escape(clauses[tag].text)}</p>' for tag in named)
        code = linked.code(module.name, start, start + len(block.rstrip(b"\n")), to, anchors=True)
        rows.append(f'<tr><td><pre>{code}</pre></td><td class="beside">{beside}</td></tr>')
    return f"<h1>{module.name}</h1>\n<table class='module'>{''.join(rows)}</table>"


def _blocks(text: bytes) -> Iterator[tuple[int, int]]:
    """The parts of a text between empty lines, from one byte to before another."""
    start = 0
    for gap in re.finditer(rb"\n\n+", text):
        yield start, gap.end()
        start = gap.end()
    yield start, len(text)

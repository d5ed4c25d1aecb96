"""The pages of the project: their links lead somewhere."""

import re
from pathlib import Path
from urllib.parse import unquote

import pytest

from evidence.common.checkout import ROOT

PAGES = sorted(
    path
    for pattern in (
        "*.md",
        *(
            f"{folder}/**/*.md"
            for folder in ("docs", "traces", "bench", "examples", "instrumentation", "spec", "models", ".github")
        ),
    )
    for path in ROOT.glob(pattern)
)
LINK = re.compile(r"\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
ANCHOR = re.compile(r'<a id="([^"]+)">')
CODE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)


def anchors(page: Path) -> set[str]:
    """The places of a page that a link can name: its headings, as code hosts spell them, and its anchors."""
    text = page.read_text(encoding="utf-8")
    headings = (
        re.sub(r"[^\w\- ]", "", found.lower()).replace(" ", "-") for found in HEADING.findall(CODE.sub("", text))
    )
    return {*headings, *ANCHOR.findall(text)}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links(page: Path) -> None:
    """Each link to a file of the project, and to a place in a page, has an end."""
    dangling = []
    for link in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8"))):
        target, _, place = unquote(link).partition("#")
        file = (page.parent / target) if target else page
        if "://" not in link and (not file.exists() or (place and place not in anchors(file))):
            dangling.append(link)
    assert dangling == []


def test_pages_were_found() -> None:
    """The pattern finds the pages."""
    assert {ROOT / "README.md", ROOT / "docs" / "rules" / "requirements.md"} <= set(PAGES)

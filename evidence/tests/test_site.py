"""The site: every link leads somewhere, nothing comes from elsewhere."""

import re
from pathlib import Path
from urllib.parse import unquote

import pytest
from click.testing import CliRunner

from evidence.views.site.site_command import site_command
from s7check.resources import PAGE

_LINK = re.compile(r'(?:href|src)="([^"]*)"')
_ANCHOR = re.compile(r'\bid="([^"]*)"')


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The whole site, written once."""
    folder = tmp_path_factory.mktemp("made") / "site"
    result = CliRunner().invoke(site_command, ["--output", str(folder)])
    assert result.exit_code == 0, result.output
    return folder


def test_every_link_leads_to_a_page_and_its_anchor(site: Path) -> None:
    """Within the site; other hosts are linked from texts only."""
    texts = {path: path.read_text() for path in site.rglob("*.html")}
    anchors = {path: set(_ANCHOR.findall(text)) for path, text in texts.items()}
    wrong = []
    for path, text in texts.items():
        for link in _LINK.findall(text):
            if "://" in link or link.startswith("data:"):
                continue
            to, _, anchor = unquote(link).partition("#")
            target = (path.parent / to).resolve() if to else path
            if target.name == "explorer.html" and anchor:
                case = anchor.removeprefix("open=")
                anchor, target = (case, site / "gallery.html") if case != anchor else ("", target)
            if not target.is_file() or (anchor and target.suffix == ".html" and anchor not in anchors[target]):
                wrong.append(f"{path.relative_to(site)}: {link}")
    assert wrong == []


def test_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    """Scripts, styles and pictures are files of the site."""
    for path in site.rglob("*.html"):
        loaded = re.findall(r'<(?:script|link|img)[^>]*(?:href|src)="([^"]*)"', path.read_text())
        assert loaded
        assert not [one for one in loaded if "://" in one]


def test_formulas_rules_and_definitions_lead_to_each_other(site: Path) -> None:
    """From a module to the rule and to other definitions, from the rule to the definition."""
    module = (site / "spec" / "rules" / "Airt.html").read_text()
    assert '<b id="DisAirt">' in module
    assert 'href="../../book/sfc-41-dis_airt.html#AIRT-03"' in module
    assert 'href="Calls.html#Called"' in module
    assert 'href="Calls.html">Calls</a>' in module
    rule = (site / "book" / "sfc-41-dis_airt.html").read_text().partition('id="AIRT-03"')[2].partition("</section>")[0]
    assert 'href="../spec/rules/Airt.html#DisAirtAnswers"' in rule
    assert rule.count("<svg") == 4, "labels and lanes of an accepted and of a rejected log"
    for part in ("SF06ru</abbr>", "AirtCountProp", "proved by Apalache", "fails in model airt", "<del>"):
        assert part in rule


@pytest.mark.skipif(not PAGE.is_file(), reason="no page: run `make page`")
def test_the_explorer_is_there(site: Path) -> None:
    """Each page leads to it, each edge case to itself in it."""
    assert (site / "explorer.html").read_bytes() == PAGE.read_bytes()
    gallery = (site / "gallery.html").read_text()
    assert gallery.count('<a href="explorer.html#open=') == gallery.count("<section ")
    assert '<a href="../explorer.html">explorer</a>' in (site / "rules" / "requirements.html").read_text()


def test_each_edge_case_is_drawn(site: Path) -> None:
    """A timeline in each section."""
    sections = (site / "gallery.html").read_text().split("<section ")[1:]
    assert len(sections) >= 40
    assert all("<svg" in section for section in sections)


def test_the_search_knows_headings_and_modules(site: Path) -> None:
    """By their words."""
    index = (site / "index.js").read_text()
    assert "spec/rules/Airt.html" in index
    assert "rules/review.html#" in index

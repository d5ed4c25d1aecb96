"""The site: every link leads somewhere, nothing comes from elsewhere."""

import json
import re
from itertools import product
from pathlib import Path
from typing import Any, cast
from urllib.parse import unquote

import pytest
from axe_playwright_python.sync_playwright import Axe  # type: ignore[import-untyped]
from click.testing import CliRunner
from playwright.sync_api import sync_playwright

from evidence.common.chromium import QUIET, chromium, missing
from evidence.views.site import site_command as command
from evidence.views.site.site_command import site_command
from s7check.resources import PAGE

_LINK = re.compile(r'(?:href|src)="([^"]*)"')
_ANCHOR = re.compile(r'\bid="([^"]*)"')
_SEARCHES = pytest.mark.skipif(
    chromium() is None or not command.SEARCH.is_file(), reason="no Chromium, or no search: run `make site`"
)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The whole site, written once; without a search where npm has not brought one."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "none.js").touch()
    with pytest.MonkeyPatch.context() as patch:
        if not command.SEARCH.is_file():
            patch.setattr(command, "SEARCH", folder / "none.js")
        result = CliRunner().invoke(site_command, ["--output", str(folder / "site")])
    assert result.exit_code == 0, result.output
    return folder / "site"


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
    assert 'href="Codes.html#NotDelayed"' in module
    assert 'href="Calls.html">Calls</a>' in module
    rule = (site / "book" / "sfc-41-dis_airt.html").read_text().partition('id="AIRT-03"')[2].partition("</section>")[0]
    assert 'href="../spec/rules/Airt.html#CountAfterEnAirt"' in rule
    assert rule.count("<svg") == 4, "labels and lanes of an accepted and of a rejected log"
    for part in ("SF06ru</abbr>", "AirtCountProp", "proved by Apalache", "fails in model airt", "<del>"):
        assert part in rule


@pytest.mark.skipif(not PAGE.is_file(), reason="no page: run `make page`")
def test_the_explorer_is_there(site: Path) -> None:
    """Each page leads to it, each edge case to itself in it."""
    assert (site / "explorer.html").read_bytes() == PAGE.read_bytes()
    gallery = (site / "gallery.html").read_text()
    assert gallery.count('<a class="run" href="explorer.html#open=') == gallery.count("<section ")
    assert '<a href="../explorer.html">explorer</a>' in (site / "rules" / "requirements.html").read_text()


@pytest.mark.skipif(missing() != "", reason=missing())
def test_a_rule_opens_the_explorer_at_the_moment(site: Path) -> None:
    """The rejected log before its rejected line; from the front page two CPUs that differ."""
    with sync_playwright() as playwright:
        page = playwright.chromium.launch(executable_path=chromium(), args=QUIET).new_page()
        page.goto((site / "book" / "the-clock.html").as_uri())
        page.locator("#CLK-10 a.run").last.click()
        page.locator("#verdict", has_text="something had to come before this line").wait_for()
        page.goto((site / "rules" / "review.html").as_uri())
        page.get_by_text("AMB-37-clock-onto-a-point-calls-ob-80").click()
        page.locator("#verdict", has_text="line").wait_for()
        page.goto((site / "index.html").as_uri())
        page.get_by_text("S7-300 beside S7-400").click()
        page.locator("#sides", has_text="is not possible there").wait_for()


def test_each_edge_case_is_drawn(site: Path) -> None:
    """A timeline in each section, a line for each in the contents; the told cases lead to rules and questions."""
    head, *sections = (site / "gallery.html").read_text().split("<section ")
    assert len(sections) >= 40
    assert all("<svg" in section for section in sections)
    anchors = [anchor for one in sections for anchor in _ANCHOR.findall(one.partition(">")[0])]
    assert len(anchors) == len(sections)
    assert [anchor for anchor in anchors if f'<a href="#{anchor}">' not in head] == []
    told = (site / "rules" / "review.html").read_text()
    for link in ('"../book/the-clock.html#CLK-02">CLK-02</a>', '"readings.html#AMB-16">AMB-16</a>'):
        assert link in told


def test_the_book_has_the_tables_of_the_specification(site: Path) -> None:
    """As TLC evaluates them."""
    tables = {
        "sfc-28-set_tint": ("<td>80A1</td>", ">PastStart<", "<td>2001</td>", ">EndOfMonth<"),
        "sfc-31-qry_tint": ("<td>0017</td>",),
        "sfc-39-dis_irt": ("<td>82</td><td>2</td><td>yes</td><td>no</td><td>no</td>", "<td>70, 72</td>"),
        "time-errors": ("<td>05</td><td>3505</td>",),
        "missing-obs-errors-and-stop": ("<td>4568</td>", "STOP: OB 80 missing"),
        "start-events-and-obs": (
            "<b>FitsInterrupt</b>",
            "<td>17</td><td>2</td><td>2</td><td>2</td><td>2</td><td>1118</td>",
        ),
    }
    for page, parts in tables.items():
        text = (site / "book" / f"{page}.html").read_text()
        assert [part for part in parts if part not in text] == []


@_SEARCHES
def test_the_search_finds_rules_by_their_words_on_a_phone(site: Path) -> None:
    """From the file system, with titles and without Markdown; nothing is wider than the screen."""
    with sync_playwright() as playwright:
        page = playwright.chromium.launch(executable_path=chromium(), args=QUIET).new_page(
            viewport={"width": 360, "height": 800}
        )
        for place in ("index.html", "book/the-clock.html"):
            page.goto((site / place).as_uri())
            assert page.evaluate("document.documentElement.scrollWidth") == 360
        page.fill("#search", "clock set back")
        page.locator("#found a").first.wait_for()
        found = page.locator("#found a").all_inner_texts()
        page.fill("#search", "MayStart")
        page.locator("#found a", has_text="MayStart · Requests").click()
        assert page.url.endswith("Requests.html#MayStart")
    assert {"CLK-09", "CLK-10"} <= {title.split(" ")[0] for title in found[:9]}


@_SEARCHES
def test_the_search_answers_a_newcomer(site: Path) -> None:
    """The words of other manuals, block numbers in any form, the situation of an edge case; keys open a hit."""
    first = {
        "monthly": "TINT-18",
        "priority": "IRT-02",
        "OB80": "Time errors: OB 80",
        "SFC28": "SFC 28",
        "tint 31": "TINT-31",
        "simultaneously": "AMB-29",
        "retentive": "Restart",
        "unblock": "SFC 40 EN_IRT",
        "CAN_TINT waits": "Cancelled while it waits",
        "CAN_TINT running": "Cancelled inside its OB",
        "CAN_TINT pending": "Cancelled while it waits",
        "ACT_TINT too late": "Activated after its start point",
        "retrigger delay": "A time-delay interrupt is started again",
        "SRT_DINT waiting": "SRT_DINT while its OB waits",
        "DIS_AIRT clock set EN_AIRT": "A skipped point under DIS_AIRT",
        "OB 35": "OBS",
        "ACT_TINT date passed": "Activated after its start point",
    }
    with sync_playwright() as playwright:
        page = playwright.chromium.launch(executable_path=chromium(), args=QUIET).new_page()
        page.goto((site / "index.html").as_uri())
        hits = page.locator("#found a")
        for words, title in first.items():
            page.fill("#search", words)
            hits.filter(has_text=title).first.wait_for()
            assert [one for one in hits.all_inner_texts()[:3] if one.startswith(title)], words
        page.fill("#search", "day 31 february")
        hits.filter(has_text="17. Monthly").first.wait_for()
        assert "TINT-31" not in [one.split(" ")[0] for one in hits.all_inner_texts()]
        wanted = hits.nth(1).get_attribute("href")
        page.keyboard.press("ArrowDown")
        page.keyboard.press("ArrowDown")
        page.keyboard.press("Enter")
        page.wait_for_url(f"**/{wanted}")
        page.fill("#search", "TINT-31")
        hits.first.wait_for()
        page.press("#search", "Enter")
        page.wait_for_url("**#TINT-31")
        page.fill("#search", "TINT-31")
        hits.first.click()
        page.wait_for_function("!document.querySelector('#found a') && !document.querySelector('#search').value")


@pytest.mark.skipif(bool(missing()), reason=missing())
def test_axe_has_no_serious_finding(site: Path) -> None:
    """In light and dark, at 360 and 1,600 px."""
    found = []
    with sync_playwright() as playwright:
        page = playwright.chromium.launch(executable_path=chromium(), args=QUIET).new_page()
        for place in ("index.html", "gallery.html", "book/sfc-41-dis_airt.html"):
            page.goto((site / place).as_uri())
            for scheme, width in product(("light", "dark"), (360, 1600)):
                page.emulate_media(color_scheme=cast(Any, scheme))
                page.set_viewport_size({"width": width, "height": 900})
                violations = Axe().run(page).response["violations"]
                found += [(place, one["id"]) for one in violations if one["impact"] in ("serious", "critical")]
    assert found == []


def test_the_search_has_no_markdown(site: Path) -> None:
    """Neither in titles nor in texts."""
    parts = json.loads((site / "index.js").read_text().removeprefix("const INDEX = ").rstrip(";\n"))
    assert len(parts) > 1500
    assert [one for one in parts if re.search(r"`|\*\*|\]\(|<a |\[\w+ \d", one["title"])] == []
    assert [one["title"] for one in parts if re.search(r"\*\*\w|\]\(\w", one["text"])] == []

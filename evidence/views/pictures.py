"""``make pictures``: the pictures of the README, by the program itself from the log in the README.

The timeline is the one of the HTML report. The explorer's page, which `make page` builds, is photographed by Chromium,
beside it a hash of its sources; where there is no Chromium the picture stays as it is.
"""

from __future__ import annotations

import hashlib
import re
import sys
from importlib.resources import files
from pathlib import Path
from tempfile import TemporaryDirectory

from evidence.common.checkout import ROOT
from evidence.common.chromium import QUIET, chromium
from s7check.engine.client import Engine
from s7check.explore_command import page_with
from s7check.judging.check import check_log
from s7check.judging.replay import Replay, with_steps
from s7check.report.markup import as_text, node
from s7check.report.timeline import patterns, timeline

README = ROOT / "README.md"
FOLDER = ROOT / "docs" / "pictures"
TIMELINE, EXPLORER, SOURCES = FOLDER / "rejected.svg", FOLDER / "explorer.png", FOLDER / "explorer.sha256"
_STYLE = files("s7check.report") / "report.css"
_PAGE = files("s7check") / "page"
_LOG = re.compile(r"^```json\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_LAST_LINE = 4
"""Of the log, as it is shown in the explorer: the one before the rejected one."""
_WIDTH, _HEIGHT = 960, 760


def rejected() -> str:
    """The timeline of the log as an image of its own."""
    with TemporaryDirectory() as folder, Engine() as engine:
        log = log_of_readme(folder)
        report = check_log(str(log), engine, lambda *_: None)
        picture = timeline(with_steps(report, engine, Replay(str(log), [])))
    assert picture is not None, "a timeline"
    labels, lanes = picture.labels, picture.lanes
    lanes.set("x", labels.attrib["width"])
    width, height = float(labels.attrib["width"]) + float(lanes.attrib["width"]), float(lanes.attrib["height"])
    style = node("style", _STYLE.read_text(encoding="utf-8"))
    paper = node("rect", width=width, height=height, style="fill: var(--paper)")
    content = (style, patterns(), paper, labels, lanes)
    box = f"0 0 {width:g} {height:g}"
    image = node("svg", *content, xmlns="http://www.w3.org/2000/svg", viewBox=box, width=width, height=height)
    return as_text(image) + "\n"


def sources() -> str:
    """A hash of what the explorer's page is made of."""
    pages = sorted(_PAGE.iterdir(), key=lambda one: one.name)
    return hashlib.sha256(b"".join(one.read_bytes() for one in (*pages, _STYLE))).hexdigest() + "\n"


def photograph(browser: str) -> bytes:
    """The explorer with the lines before the rejected one, in Chromium."""
    from playwright.sync_api import sync_playwright

    with TemporaryDirectory() as folder, sync_playwright() as playwright:
        copy = Path(folder) / "page.html"
        copy.write_text(page_with(f"{log_of_readme(folder)}:{_LAST_LINE}"), encoding="utf-8")
        page = playwright.chromium.launch(executable_path=browser, args=QUIET).new_page(
            viewport={"width": _WIDTH, "height": _HEIGHT}
        )
        page.goto(copy.as_uri())
        page.locator("#possible button", has_text="start ob=80").first.wait_for()
        page.get_by_text("The next line at").click()  # closes the list of times: the lines move up
        page.evaluate("document.getElementById('picture').scrollIntoView()")
        return page.screenshot()


def main() -> None:
    """Write the pictures."""
    FOLDER.mkdir(exist_ok=True)
    TIMELINE.write_text(rejected(), encoding="utf-8")
    browser = chromium()
    if browser is None:
        sys.exit("no Chromium on the PATH: the picture of the explorer stays as it is")
    EXPLORER.write_bytes(photograph(browser))
    SOURCES.write_text(sources(), encoding="utf-8")


def log_of_readme(folder: str) -> Path:
    """The log of the README as a file."""
    found = _LOG.search(README.read_text(encoding="utf-8"))
    assert found is not None, "a log in the README"
    log = Path(folder) / "log.ndjson"
    log.write_text(found[1], encoding="utf-8")
    return log


if __name__ == "__main__":
    main()

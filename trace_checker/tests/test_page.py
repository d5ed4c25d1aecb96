"""The HTML page: its size, its groups, its colours, and, in a browser, its layout and its keys."""

import json
import re
import subprocess
from html import unescape
from itertools import pairwise
from pathlib import Path

import pytest
from msgspec.structs import replace
from playwright.sync_api import sync_playwright

from evidence.common.chromium import chromium
from s7check.engine.answer import Candidate, Frame, Pending, Situation, Step
from s7check.report.as_html import to_html
from s7check.report.report import Report
from tests.logs import event, log_text

CHROMIUM = chromium() or ""
CSS = (Path(__file__).parents[1] / "s7check" / "report" / "report.css").read_text(encoding="utf-8")
RUN = Situation(mode="RUN", running=[Frame(1, 1)])
LEAST_CONTRAST = 4.5


def long_log(name: str, calls: int) -> Report:
    """A log of many calls of which the last one is rejected, with all situations."""
    entries = [event("DIS_AIRT", ret=number) for number in range(1, calls + 1)]
    pending = [Pending(40, 16, ready=True), Pending(10, 2)]
    steps = [
        Step(
            line,
            Situation(mode="RUN", running=[Frame(1, 1), Frame(35, 12)][: 1 + line % 2], pending=pending[: line % 3]),
        )
        for line in range(max(2, calls - 158), calls + 1)
    ]
    return Report(
        name,
        "rejected",
        "no behaviour of the specification explains this line",
        line=calls + 1,
        events=calls - 1,
        event=json.dumps(entries[-1]).encode(),
        expected=["end ob=1"],
        requirements=["AIRT-03"],
        situations=[Situation(mode="RUN", running=[Frame(1, 1)], pending=pending)],
        candidates=[
            Candidate(
                f"DisAirt({name})", f"ret = delay + {len(name)}{name[-11:]}", "ret = 5", "Airt.tla:40", ["AIRT-03"]
            )
        ],
        lines=log_text(*entries).splitlines(),
        steps=steps,
    )


def page(*reports: Report) -> str:
    """The page's text."""
    return to_html(reports).decode()


@pytest.mark.parametrize(("calls", "says"), [(6, "Lines 2 to 7 of 7"), (300, "Lines 222 to 301 of 301")])
def test_a_long_log_says_which_lines_are_shown_and_has_the_others(calls: int, says: str) -> None:
    """The picture has the lines before the verdict; all others can be opened."""
    text = page(long_log("a", calls))
    assert says in text
    rest = "".join(re.findall(r"<details>.*?</details>", text, re.DOTALL))
    shown = int(says.split()[1])
    assert [int(n) for n in re.findall(r"^(?:<details>.*?<pre[^>]*>)?(\d+) ", rest, re.MULTILINE)] == list(
        range(1, shown)
    )


def test_a_thousand_logs_stay_below_two_megabytes() -> None:
    """Each rejected for a reason of its own, fifty with a picture; the page says where it has left something out."""
    explained = [long_log(f"{'folder/' * 5}log-{number:04}.ndjson", 200) for number in range(50)]
    for number in range(950):
        one = long_log(f"{'folder/' * 5}other-{number:04}.ndjson", 3)
        explained.append(replace(one, steps=[], lines=[]))
    data = to_html(explained)
    assert len(data) < 2_000_000
    text = data.decode()
    assert text.count("<section") == 1001
    assert "No timeline: the page has no room" in text
    assert "No explanation: the page has no room" in text
    assert 0 < text.count('class="scroll"') < 50


def test_logs_with_one_cause_are_explained_once() -> None:
    """The others lead there; accepted logs of which there is no more to say have a row alone."""
    first = long_log("a", 4)
    again = replace(first, log="b")
    text = page(Report("c", "accepted", "accepted", events=3), first, again)
    assert text.count("Requirements that decide") == 1
    assert '<a href="#log1">the log where it is explained</a>' in text
    assert text.count("<section") == 3
    assert "2 logs: rejected by" in text
    assert "1 log: accepted" in text


def test_every_requirement_is_a_link_to_a_place() -> None:
    """In the table, in the section, in the reasons."""
    text = page(long_log("a", 4), long_log("b", 5))
    assert text.count('href="#AIRT-03"') >= 4
    assert text.count('id="AIRT-03"') == 1


def colours() -> dict[str, dict[str, str]]:
    """The variables of the two colour schemes."""
    light, dark = (
        dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{3,6})", part))
        for part in CSS.split("@media (prefers-color-scheme", 1)
    )
    return {"light": light, "dark": dark}


def luminance(colour: str) -> float:
    """Relative luminance as WCAG 2 defines it."""
    digits = colour[1:] if len(colour) == 7 else "".join(2 * digit for digit in colour[1:])
    parts = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    linear = [part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(one: str, other: str) -> float:
    """The ratio of two colours, 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


GROUNDS = ("paper", "soft")
TEXTS = {
    "ink": (*GROUNDS, "red-soft", "amber-soft", "blue-soft", "band", "jump"),
    "dim": (*GROUNDS, "band", "jump"),
    "red": (*GROUNDS, "red-soft", "band", "jump"),
    "green": (*GROUNDS, "green-soft", "band", "jump"),
    "amber": (*GROUNDS, "amber-soft", "band"),
    "blue": GROUNDS,
    "on": ("blue", "green", "amber", "violet", "grey", "brown"),
}
"""Colours of texts, and the colours that can be behind them."""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_contrast(scheme: str) -> None:
    """Every text has a contrast of 4.5 to 1 or more."""
    found = colours()[scheme]
    ratios = {(text, ground): contrast(found[text], found[ground]) for text, on in TEXTS.items() for ground in on}
    assert {pair: round(ratio, 2) for pair, ratio in ratios.items() if ratio < LEAST_CONTRAST} == {}


def test_no_colour_beside_the_variables() -> None:
    """So that the test of contrast sees every colour of a text, in both schemes."""
    assert colours()["light"].keys() == colours()["dark"].keys()
    rules = CSS[CSS.index("* { box-sizing") :]
    assert not re.search(r"#[0-9a-fA-F]{3}", rules.replace("url(#", ""))
    assert not re.search(r"[^-]opacity: ", rules), "a text that is paler than its colour"
    used = set(re.findall(r"[ {](?:color|fill): var\(--([a-z-]+)\)", rules))
    fills = {"soft", "paper", "red-soft", "amber-soft", "blue-soft", "band", "jump", "violet", "grey", "brown"}
    assert used - fills == TEXTS.keys()


SCRIPT = """<script>
const all = (query, within = document) => [...within.querySelectorAll(query)];
const apart = all(".scroll > svg").flatMap(svg => {
  const boxes = all("text", svg).map(t => [t.textContent, t.getBoundingClientRect()]);
  return boxes.flatMap(([a, p], i) => boxes.slice(i + 1).filter(([b, q]) =>
    p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 3 && q.top < p.bottom - 3)
    .map(([b]) => a + "|" + b));
});
const scroll = all(".scroll").find(box => box.scrollWidth > box.clientWidth);
scroll.scrollLeft = 300;
const label = scroll.firstElementChild.getBoundingClientRect();
const sticky = Math.abs(label.left - scroll.getBoundingClientRect().left) < 3;
const badges = all(".verdict").filter(b => b.getBoundingClientRect().height > 30).length;
const drawn = all(".scroll > svg").every(svg => svg.getBoundingClientRect().height > 100)
  && document.querySelector(".scroll .band").getBoundingClientRect().width > 50;
const loaded = performance.getEntriesByType("resource").length;
const keys = all("summary, a, input, .scroll, pre[tabindex]").filter(e => e.tabIndex < 0).length;
const search = document.querySelector("[type=search]");
search.value = "other";
search.dispatchEvent(new Event("input", {bubbles: true}));
const shown = all("section[id]").filter(s => s.offsetHeight).map(s => s.id);
const said = document.querySelector("output").textContent;
search.value = "";
const box = document.querySelector("[value=rejected]");
box.checked = false;
box.dispatchEvent(new Event("input", {bubbles: true}));
const without = document.querySelector("output").textContent;
const scripts = document.scripts.length - 1;
const found = {apart, drawn, loaded, scripts, sticky, badges, keys, shown, said, without};
document.body.append(Object.assign(document.createElement("pre"), {id: "found", textContent: JSON.stringify(found)}));
</script></html>"""


@pytest.mark.skipif(not CHROMIUM, reason="no chromium on the PATH")
def test_the_layout_in_a_browser(tmp_path: Path) -> None:
    """Labels stay in view, no text lies on another, badges are whole, keys reach all controls, the filter picks.

    The page loads nothing, and a name is no script.
    """
    reports = [long_log("<script>a</script>", 300), long_log("other", 9), Report("c", "accepted", "accepted", events=3)]
    file = tmp_path / "page.html"
    file.write_text(page(*reports).replace("</html>", SCRIPT), encoding="utf-8")
    command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'profile'}"]
    run = subprocess.run(
        [*command, "--dump-dom", file.as_uri()], capture_output=True, timeout=120, check=True, text=True
    )
    found = json.loads(unescape(run.stdout.split('<pre id="found">')[1].split("</pre>")[0]))
    assert found == {
        "apart": [],
        "drawn": True,
        "loaded": 0,
        "scripts": 1,
        "sticky": True,
        "badges": 0,
        "keys": 0,
        "shown": ["log1"],
        "said": "1 of 3 logs",
        "without": "1 of 3 logs",
    }


def test_the_levels_of_headings_have_no_gap() -> None:
    """A screen reader goes from heading to heading."""
    levels = [int(level) for level in re.findall(r"<h([1-6])", page(long_log("a", 4), long_log("b", 5)))]
    assert levels[0] == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))


@pytest.mark.skipif(not CHROMIUM, reason="no chromium on the PATH")
def test_nothing_is_wider_than_a_small_window(tmp_path: Path) -> None:
    """Long names, formulas and lines break; only the timeline scrolls."""
    file = tmp_path / "page.html"
    file.write_bytes(to_html([long_log("a-long-name-of-a-log-in-a-folder/" * 4, 50), long_log("b" * 90, 9)]))
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox", "--disable-gpu"])
        small = browser.new_page(viewport={"width": 360, "height": 700})
        small.goto(file.as_uri())
        small.evaluate("document.querySelectorAll('details').forEach(one => one.open = true)")
        assert small.evaluate("document.documentElement.scrollWidth") <= 360
        browser.close()

"""The checker as one page, opened from its file in Chromium, and its engine beside the one in Java."""

import gzip
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import pytest
from axe_playwright_python.sync_playwright import Axe  # type: ignore[import-untyped]
from playwright.sync_api import Browser, Download, Page, expect, sync_playwright

from evidence.common.chromium import QUIET, chromium, firefox, in_firefox, judged_in, missing
from s7check import cli
from s7check.asking.variants import Variant
from s7check.engine.client import Engine
from s7check.engine.command import jvm_command
from s7check.explore_command import page_with
from s7check.kit.program import read_program
from s7check.resources import PAGE
from s7check.simulating.simulation import simulated
from tests.shipped import CASES, log_of
from tests.test_simulating import PROGRAM

pytestmark = pytest.mark.skipif(bool(missing()), reason=missing())

SOURCES = Path(__file__).parents[2] / "examples" / "import"
MOST = 4 * 1024 * 1024
EACH = 12
LONGEST_MS = 60_000
"""For one step, on a busy machine."""
HEADER = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-400",
    "obs": [1, 40, 80],
    "clock": "2026-03-02T08:00:30.000",
    "mode": "RUN",
}
AT = "2026-03-02T08:00:31.000"
REJECTED = "\n".join(
    json.dumps(line)
    for line in (
        HEADER,
        {"event": "interrupt", "ob": 40, "at": AT},
        {"event": "start", "ob": 40, "at": AT},
        {"event": "EN_AIRT", "ret": "W#16#0000", "at": AT},
        {"event": "end", "ob": 40, "at": AT},
    )
)


@pytest.fixture(scope="module", params=["Chromium", "Firefox"])
def browser(request: pytest.FixtureRequest) -> Iterator[Browser]:
    """One Chromium for all tests, and one Firefox."""
    expect.set_options(timeout=LONGEST_MS)
    if request.param == "Chromium":
        with sync_playwright() as playwright:
            yield playwright.chromium.launch(executable_path=chromium(), args=QUIET)
    elif firefox() is None:
        pytest.skip("no Firefox")
    else:
        with in_firefox() as launched:
            yield launched


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """The page, ready; no script may fail, and nothing but its file may be asked for."""
    context = browser.new_context(offline=True, accept_downloads=True)
    page = context.new_page()
    page.set_default_timeout(LONGEST_MS)
    failed: list[str] = []
    page.on("pageerror", lambda error: failed.append(str(error)))
    page.on("request", lambda one: failed.append(one.url) if one.url.startswith(("http", "ws")) else None)
    page.goto(PAGE.as_uri())
    page.wait_for_selector("body[data-ready]")
    yield page
    context.close()
    assert failed == []


def paste(page: Page, text: str) -> None:
    """Check a text."""
    page.fill("#text", text)
    page.click("#check")


def saved(page: Page, button: str) -> Download:
    """What a button saves."""
    if of_firefox(page):
        pytest.skip("no downloads by WebDriver BiDi")
    with page.expect_download() as download:
        page.click(button)
    return download.value


def of_firefox(page: Page) -> bool:
    """Whether it is open there: what Playwright cannot do there is not run."""
    browser = page.context.browser
    return browser is not None and browser.browser_type.name == "firefox"


def emulate(page: Page, feature: str, value: Literal["light", "dark", "print"]) -> None:
    """Another colour scheme or medium."""
    page.emulate_media(**{"media" if value == "print" else "color_scheme": value})  # type: ignore[arg-type]
    if not page.evaluate(f"matchMedia('{feature}').matches"):
        pytest.skip("the browser keeps its own")


def test_the_page_is_one_file_of_at_most_4_mb() -> None:
    """The size, and that it refers to no other file."""
    text = PAGE.read_text(encoding="utf-8")
    assert len(text.encode()) <= MOST
    assert re.findall(r'(?:src|href)="(?!data:)[^"]*"', text) == []


def test_it_says_that_nothing_leaves_the_machine(page: Page) -> None:
    """On the first view."""
    expect(page.locator("#start")).to_contain_text("Nothing leaves this machine")


def test_a_rejected_log_opens_at_its_line(page: Page) -> None:
    """With the requirement, what is possible, and the report as text."""
    paste(page, REJECTED)
    expect(page.locator("#verdict")).to_contain_text("rejected line 4: no behaviour of the specification explains")
    expect(page.locator("#explained")).to_contain_text("EN_AIRT cannot answer 16#0000 here.")
    expect(page.locator("#timeline .wrong")).to_contain_text("EN_AIRT")
    assert "EN_AIRT" in page.locator("#edit textarea").input_value()
    page.click("text=Report as text")
    expect(page.locator("#as-text")).to_contain_text("pasted.ndjson:4: rejected")
    expect(page.locator("#as-text")).to_contain_text("ret = 16#0000, AnswersTo(e) = {16#8080}")


def test_the_report_is_that_of_the_command(page: Page, tmp_path: Path) -> None:
    """Saved as a page of its own: the situation, why, the rules and the readings of `s7check trace --format html`."""
    text = log_of("AMB-12-lost-once-still-active").read_text()
    log, report, kept = (tmp_path / name for name in ("pasted.ndjson", "command.html", "kept.html"))
    log.write_text(text, encoding="utf-8")
    assert cli.main(["trace", "--format", "html", "--output", str(report), str(log)]) == 1
    paste(page, text)
    expect(page.locator("#readings li").first).to_contain_text("AMB-12 b")
    download = saved(page, "#save-report")
    assert download.suggested_filename == "pasted.html"
    download.save_as(kept)
    said = []
    for file in (report, kept):
        page.goto(file.as_uri())
        expect(page.locator("main")).to_contain_text("QRY_TINT cannot give STATUS 16#0016 here.")
        rows = page.locator("table tr").evaluate_all("all => all.map(row => row.cells[0].textContent)")
        situation = page.locator("tr", has_text="every minute").or_(page.locator("tr", has_text="clock 2026"))
        passing = page.locator("h3", has_text="would pass with").locator("+ ul li").all_inner_texts()
        said.append((set(rows), situation.all_inner_texts(), [one[:8] for one in passing]))
        assert Axe().run(page).response["violations"] == []
    (rows, *theirs), (our_rows, *ours) = said
    assert {one for one in rows if "(" not in one} <= our_rows, "the formulas are a list here"
    assert theirs == ours
    expect(page.locator(".timeline .wrong")).to_contain_text("QRY_TINT")


def test_explore_opens_a_log_at_a_line(page: Page, tmp_path: Path) -> None:
    """The copy that the command writes, at the line of the file and not at the rejected one."""
    (tmp_path / "run.ndjson").write_text(REJECTED.replace("\n", "\n\n"), encoding="utf-8")
    copy = tmp_path / "copy.html"
    copy.write_text(page_with(f"{tmp_path / 'run.ndjson'}:3"), encoding="utf-8")
    page.goto(copy.as_uri())
    expect(page.locator("#verdict")).to_contain_text("line 7: no behaviour")
    expect(page.locator("#where")).to_contain_text("run.ndjson: after line 3 of 9")
    expect(page.locator("#possible")).to_contain_text("start ob=40")


def test_a_fitting_value_mends_it_and_back_takes_that_back(page: Page) -> None:
    """The button puts the value into the line."""
    paste(page, REJECTED)
    page.click("#explained button.choice >> nth=0")
    expect(page.locator("#verdict")).to_contain_text("accepted")
    page.go_back()
    expect(page.locator("#verdict")).to_contain_text("rejected")


def test_a_packed_log_is_unpacked(page: Page) -> None:
    """One piece or several of gzip, with zero bytes behind them; what cannot be unpacked is told, also a zip."""
    text = REJECTED.encode()
    pieces = gzip.compress(text[:99]) + gzip.compress(text[99:])
    padded = gzip.compress(text[:99]) + bytes(3) + gzip.compress(text[99:]) + bytes(20)
    for run, packed in enumerate([gzip.compress(text), *([] if of_firefox(page) else [pieces, padded])]):
        page.set_input_files("#file", {"name": f"{run}.ndjson.gz", "mimeType": "application/gzip", "buffer": packed})
        expect(page.locator("#where")).to_contain_text(f"{run}.ndjson: after line 3 of 5")
        page.click("#home")
        expect(page.locator("#start")).to_be_visible()
    if of_firefox(page):
        pytest.skip("Firefox reports a damaged stream as an error of the page, too")
    wrong = {"cut.gz": pieces[:-9], "plain.gz": text, "log.zip": b"PK\3\4rest"}
    for name, packed in wrong.items():
        page.set_input_files("#file", {"name": name, "mimeType": "application/gzip", "buffer": packed})
        told = "log.zip is a zip archive" if name == "log.zip" else f"{name}: unusable: expected a sound gzip file"
        expect(page.locator("#problem")).to_contain_text(told)


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "utf-16-be"])
def test_a_byte_order_mark_names_the_encoding(page: Page, encoding: str) -> None:
    """As for s7check trace."""
    mark = "" if encoding != "utf-16-be" else "\ufeff"
    data = (mark + REJECTED).encode(encoding)
    page.set_input_files("#file", {"name": "run.ndjson", "mimeType": "text/plain", "buffer": data})
    expect(page.locator("#where")).to_contain_text("run.ndjson: after line 3 of 5")


def test_an_unusable_log_has_its_line_and_field(page: Page) -> None:
    """As s7check trace says it."""
    paste(page, REJECTED.replace('"S7-400"', '"S7-500"'))
    expect(page.locator("#problem")).to_contain_text("unusable: line 1: field cpu: expected")
    expect(page.locator("#start")).to_be_visible()


def test_an_empty_text_and_a_damaged_link_are_told(page: Page) -> None:
    """In a sentence each."""
    paste(page, " ")
    expect(page.locator("#problem")).to_contain_text("expected a log")
    if of_firefox(page):
        pytest.skip("Firefox reports a damaged stream as an error of the page, too")
    page.goto("about:blank")
    page.goto(f"{PAGE.as_uri()}#nonsense")
    expect(page.locator("#problem")).to_contain_text("The link is damaged")


def make_log(page: Page, file: Path, **fields: str) -> None:
    """Choose a source, and say what it does not tell."""
    page.set_input_files("#file", file)
    for name, value in fields.items():
        field = page.locator(f"#import [name={name}]")
        if name == "columns":
            field.set_input_files(value)
        elif field.evaluate("one => one.tagName") == "SELECT":
            field.select_option(value)
        else:
            field.fill(value)
    page.click("#import >> text=Make a log")


MAP = str(SOURCES / "columns.json")


@pytest.mark.parametrize(
    ("name", "kind", "more"),
    [
        ("german.txt", "the text of a diagnostic buffer", {}),
        ("szl.hex", "records", {}),
        ("ring.hex", "the data block of the SCL source", {"mode": "RUN", "records": "call,ob"}),
        ("events.csv", "a table", {"columns": MAP, "mode": "RUN", "records": "call,ob"}),
    ],
)
def test_a_source_becomes_the_log_of_the_command(
    page: Page, tmp_path: Path, name: str, kind: str, more: dict[str, str]
) -> None:
    """What the source tells comes from it; what the command says of it stands beside the verdict."""
    make_log(page, SOURCES / name, cpu="S7-300", obs="1 10,35,80,85,100", **more)
    expect(page.locator("#told")).to_contain_text(f"Made from {kind}")
    expect(page.locator("#told")).to_contain_text(f"recorded completely: {'call, ob' if more else 'mode, diag'}")
    download = saved(page, "#save")
    made = [json.loads(line) for line in Path(download.path()).read_text().splitlines()]
    arguments = ["--cpu", "S7-300", "--obs", "1,10,35,80,85,100", "-o", str(tmp_path / "log")]
    arguments += [f"--{'map' if name == 'columns' else name}={value}" for name, value in more.items()]
    assert cli.main(["import", str(SOURCES / name), *arguments]) == 0
    assert made == [json.loads(line) for line in (tmp_path / "log").read_text().splitlines()]


def test_what_an_import_lacks_is_told_in_its_form(page: Page, tmp_path: Path) -> None:
    """The form stays open; without an import the file is what it is, no log."""
    (tmp_path / "a.txt").write_text("Event 1 of 1: Event ID 16# 3501\n08:00:00.000 02/03/2012\n")
    make_log(page, tmp_path / "a.txt")
    expect(page.locator("#refused")).to_contain_text("expected dates that tell the order of day and month")
    make_log(page, tmp_path / "a.txt", dates="DMY")
    expect(page.locator("#refused")).to_contain_text("header: field mode: expected it")
    page.click("#import >> text=Cancel")
    expect(page.locator("#problem")).to_contain_text("a.txt: unusable: line 1: expected a JSON object")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_in_the_form_of_an_import(page: Page, scheme: Literal["light", "dark"]) -> None:
    """While it is open."""
    emulate(page, f"(prefers-color-scheme: {scheme})", scheme)
    page.set_input_files("#file", SOURCES / "events.csv")
    expect(page.locator("#import form")).to_be_visible()
    assert Axe().run(page).response["violations"] == []


def test_on_paper_there_is_what_was_found(page: Page) -> None:
    """The report, the timeline and the situation, without what is for clicking."""
    paste(page, REJECTED)
    expect(page.locator("#timeline .wrong")).to_be_visible()
    emulate(page, "print", "print")
    for there in ("#verdict", "#explained", "#timeline .wrong", "#situation"):
        expect(page.locator(there)).to_be_visible()
    assert page.locator("input:visible, select:visible, #tools:visible, #possible:visible").count() == 0


def test_a_failed_begin_changes_nothing(page: Page) -> None:
    """The message stands on the start page, and the next one works."""
    page.fill("#new [name=clock]", "2026-13-21T05:59:30")
    page.click("#new >> text=Begin")
    expect(page.locator("#problem")).to_contain_text("field clock: expected")
    expect(page.locator("#desk")).to_be_hidden()
    page.fill("#new [name=clock]", "2026-11-21T05:59:30")
    page.click("#new >> text=Begin")
    expect(page.locator("#undo")).to_be_disabled()


def test_the_clock_over_a_point_under_a_delay_without_ob_80(page: Page) -> None:
    """What happens? Answered by one entry and three clicks."""
    page.fill("#new [name=obs]", "1 10 20 40 85")
    page.click("#new >> text=Begin")
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    page.click("#possible >> text=/clock to=2026-11-21T06:00:00.001/")
    expect(page.locator("#possible")).to_contain_text("stop cause=W#16#4568")
    expect(page.locator("#situation")).to_contain_text("STOP")
    expect(page.locator("#impossible")).to_contain_text("start ob=10")
    assert page.evaluate("document.activeElement.closest('#possible') !== null")


def test_a_step_shows_first_what_the_cpu_does(page: Page) -> None:
    """The rest of what may come follows, then what may not: a step is short."""
    page.evaluate(
        """() => { window.seen = [];
            new MutationObserver(() => window.seen.push([possible.innerText, impossible.innerText]))
                .observe(document.getElementById("possible"), {childList: true}); }"""
    )
    paste(page, "\n".join(REJECTED.splitlines()[:2]))
    expect(page.locator("#impossible")).to_contain_text("end ob=1")
    (first, reasons), *_, (whole, _) = page.evaluate("window.seen")
    assert "start ob=40" in first
    assert "DIS_AIRT" not in first
    assert reasons == "…"
    assert "DIS_AIRT" in whole
    assert "The world" in whole.replace("THE WORLD", "The world")


def test_a_call_is_answered_by_its_operands(page: Page) -> None:
    """Other operands, other answers."""
    page.click("#new >> text=Begin")
    call = page.locator("details.call", has_text="SRT_DINT")
    call.locator("summary").click()
    call.locator("[name=ob]").fill("20")
    call.locator("[name=dtime]").fill("0")
    expect(call.locator(".answers")).to_contain_text("ret=W#16#8091")


def test_what_is_typed_before_the_values_come_stays(page: Page) -> None:
    """The form opens at once, its values come from the engine; what nobody typed has one of them."""
    page.click("#new >> text=Begin")
    call = page.locator("details.call", has_text="SRT_DINT")
    typed = {"ob": "20", "dtime": "0"}
    call.evaluate(
        """(box, typed) => {
          box.open = true;
          for (const [name, value] of Object.entries(typed)) box.querySelector(`[name=${name}]`).value = value;
        }""",
        typed,
    )
    expect(call.locator(".answers")).to_contain_text("ob=20 sign=W#16#0000 dtime=0 ret=W#16#8091")


def test_a_form_begins_with_a_call_that_is_taken_and_old_answers_go(page: Page) -> None:
    """A typed value takes the place of the old one; one that cannot be used is told where the buttons were."""
    page.click("#new >> text=Begin")
    call = page.locator("details.call", has_text="DIS_IRT")
    call.locator("summary").click()
    expect(call.locator(".answers")).to_contain_text("ret=W#16#0000")
    assert call.locator("[name=ob]").input_value() in ["1", "10", "20", "40", "80", "85", "100"]
    for name, typed in (("ob", "40"), ("mode", "B#16#300")):
        call.locator(f"[name={name}]").click()
        page.keyboard.type(typed)
        assert call.locator(f"[name={name}]").input_value() == typed
    expect(call.locator(".answers")).to_contain_text("mode: expected")
    assert call.locator(".answers button").count() == 0


def test_set_tintl_takes_true_and_false(page: Page) -> None:
    """A call of the S7-1500; by local time its start may be past."""
    paste(page, json.dumps(HEADER | {"cpu": "S7-1500", "obs": [1, 10, 100], "zone": 60}))
    call = page.locator("details.call", has_text="SET_TINTL")
    call.locator("summary").click()
    expect(call.locator(".answers")).to_contain_text("ret=W#16#0000")
    call.locator("[name=period]").fill("0")
    call.locator("[name=local]").fill("true")
    expect(call.locator(".answers")).to_contain_text("ret=W#16#80A1")
    call.locator("[name=local]").fill("false")
    expect(call.locator(".answers")).to_contain_text("ret=W#16#0000")


def test_the_time_of_the_next_line_stays_open(page: Page) -> None:
    """Once the list is opened; the field for any other time is there without it."""
    page.select_option("#new [name=execution]", "none")
    page.click("#new >> text=Begin")
    expect(page.locator("#time [name=at]")).to_be_visible()
    times = page.locator("#time details")
    assert times.get_attribute("open") is None
    times.locator("summary").click()
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    expect(page.locator("#situation")).to_contain_text("1 DIS_AIRT not taken back")
    assert times.get_attribute("open") is not None


def test_readings_are_grouped_by_their_questions(page: Page) -> None:
    """Each with the beginning of its text; its value is the letter alone."""
    group = page.locator("#compare optgroup[label^='AMB-11 ']")
    assert re.match(r"AMB-11 b \w+", group.locator("option").nth(1).inner_text())
    assert group.locator("option").nth(1).get_attribute("value") == "AMB-11 b"


def test_another_cpu_and_why_not(page: Page) -> None:
    """The comparison with another CPU, and the reason why a line of one's own may not come."""
    paste(page, REJECTED)
    page.select_option("#compare [name=cpu]", "S7-300")
    page.click("#compare >> text=Compare")
    expect(page.locator("#sides h3")).to_have_count(1)
    page.click("#why >> text=Why not?")
    expect(page.locator("#because")).to_contain_text("OB 10 cannot start here.")


def test_a_link_holds_all_branches(page: Page) -> None:
    """Also in a browser that knows nothing."""
    page.click("#new >> text=Begin")
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    page.click("#branch")
    expect(page.locator("#branches .tab")).to_have_count(2)
    expect(page.locator("#link")).to_be_enabled()
    address = page.url
    page.goto("about:blank")
    page.goto(address)
    expect(page.locator("#branches .tab")).to_have_count(2)
    expect(page.locator("#situation")).to_contain_text("1 DIS_AIRT not taken back")


def test_a_saved_log_is_the_log(page: Page) -> None:
    """Byte for byte its lines, under a name with one ending."""
    paste(page, REJECTED)
    download = saved(page, "#save")
    assert download.suggested_filename == "pasted.ndjson"
    assert Path(download.path()).read_text() == f"{REJECTED}\n"


def test_a_saved_program_is_a_program_of_the_kit(page: Page, real_engine: Engine, tmp_path: Path) -> None:
    """The specification runs it, and its log has the same calls."""
    page.click("#new >> text=Begin")
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    page.click("#possible >> text=EN_AIRT ret=W#16#0000")
    expect(page.locator("#situation")).not_to_contain_text("not taken back")
    download = saved(page, "#program")
    file = tmp_path / download.suggested_filename
    download.save_as(file)
    program = read_program(file.read_bytes())
    calls = [line["event"] for line in simulated(real_engine, program)[1:] if "ret" in line]
    assert (file.name, calls) == ("new.json", ["DIS_AIRT", "EN_AIRT"])


def test_a_program_becomes_the_log_of_the_command(
    page: Page, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It has verdict, timeline and explorer, and is saved as a log."""
    file = tmp_path / "nested.json"
    file.write_text(json.dumps(PROGRAM), encoding="utf-8")
    page.set_input_files("#file", file)
    page.click("#programs button:has-text('Run it')")
    expect(page.locator("#told")).to_contain_text("Made from nested.json, a program of the kit")
    expect(page.locator("#verdict")).to_contain_text("accepted the specification explains every event (5 events")
    expect(page.locator("#timeline")).to_contain_text("EN_AIRT")
    expect(page.locator("#possible")).to_contain_text("DIS_AIRT ret=W#16#0001")
    assert cli.main(["simulate", str(file)]) == 0
    download = saved(page, "#save")
    assert download.suggested_filename == "nested.ndjson"
    made = [json.loads(line) for line in Path(download.path()).read_text().splitlines()]
    assert made == [json.loads(line) for line in capsys.readouterr().out.splitlines()]


def test_one_of_several_programs_is_chosen(page: Page, tmp_path: Path) -> None:
    """Cancelled, none is run; a list of programs, or text after one, is refused as a program, not as a log."""
    file = tmp_path / "two.ndjson"
    programs = [PROGRAM, PROGRAM | {"name": "other"}]
    file.write_text("\n".join(map(json.dumps, programs)), encoding="utf-8")
    page.set_input_files("#file", file)
    expect(page.locator("#programs")).to_contain_text("two.ndjson: 2 programs of the kit")
    page.click("#programs button:has-text('Cancel')")
    expect(page.locator("#problem")).to_contain_text("it is a program of the kit, and was not run")
    paste(page, file.read_text(encoding="utf-8"))
    page.select_option("#programs [name=chosen]", index=1)
    page.click("#programs button:has-text('Run it')")
    expect(page.locator("#told")).to_contain_text("Made from other, a program of the kit")
    page.click("#home")
    for text in (json.dumps(programs), json.dumps(PROGRAM, indent=1) + "{}"):
        paste(page, text)
        expect(page.locator("#problem")).to_contain_text("unusable: expected a JSON object")


_STARTED = {"call": "SRT_DINT", "ob": 20, "dtime": 100, "sign": 0}
PARTED = PROGRAM | {
    "header": PROGRAM["header"] | {"obs": [1, 20, 80, 85, 100]},
    "outside": [],
    "duration": 900,
    "bodies": [
        {"ob": 1, "run": 1, "steps": [{"call": "DIS_AIRT"}, _STARTED, {"wait": 300}, _STARTED, {"call": "EN_AIRT"}]}
    ],
}
"""SRT_DINT while its OB waits: what waits stays, or goes (AMB-11)."""


def test_a_program_is_run_at_random_and_by_other_readings(
    page: Page, tmp_path: Path, real_engine: Engine, capsys: pytest.CaptureFixture[str]
) -> None:
    """As by --seed, --reading and --all; it can be run again, and two answers to one question are refused."""
    file = tmp_path / "parted.json"
    file.write_text(json.dumps(PARTED), encoding="utf-8")
    page.set_input_files("#file", file)
    page.click("#programs button:has-text('Show every outcome')")
    expect(page.locator("#outcomes")).to_contain_text("outcome")
    assert cli.main(["simulate", str(file), "--all"]) == 0
    assert page.locator("#outcomes").inner_text().splitlines() == capsys.readouterr().out.splitlines()[1:]
    assert Axe().run(page).response["violations"] == []
    page.select_option("#programs [name=readings]", ["AMB-11 a", "AMB-11 b"])
    page.click("#programs button:has-text('Run it')")
    expect(page.locator("#not-run")).to_have_text("AMB-11: choose one answer")
    page.select_option("#programs [name=readings]", ["AMB-11 b"])
    page.fill("#programs [name=seed]", "5")
    page.click("#programs button:has-text('Run it')")
    expect(page.locator("#told")).to_contain_text("ran it, by the number 5, AMB-11 b.")
    shown = [line.partition(" ")[2] for line in page.locator("#lines button").all_inner_texts()[1:]]
    ran = simulated(real_engine, read_program(file.read_bytes()), Variant("", letters=(("AMB-11", "b"),)), seed=5)
    assert [line.split()[:2] for line in shown] == [[line["at"], line["event"]] for line in ran[1:]]
    page.click("#told >> text=Run it otherwise")
    page.fill("#programs [name=seed]", "")
    page.click("#programs button:has-text('Run it')")
    expect(page.locator("#told")).to_contain_text("ran it, AMB-11 b.")


@pytest.mark.parametrize(
    ("field", "value", "told"),
    [
        ("durations", 5, "field durations: expected"),
        ("bodies", [{"ob": 1, "steps": [{"wait": "x"}]}], "field bodies.1.steps.1.wait: expected an integer"),
    ],
)
def test_a_bad_program_names_its_field(page: Page, field: str, value: object, told: str) -> None:
    """An unknown one, or a wrong type; nothing is opened."""
    paste(page, json.dumps(PROGRAM | {field: value}))
    expect(page.locator("#problem")).to_contain_text(f"unusable: {told}")
    expect(page.locator("#start")).to_be_visible()


def test_branches_have_timelines_beside_each_other(page: Page) -> None:
    """Going back and another line: the old lines stay, and a click goes to them."""
    page.click("#new >> text=Begin")
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    page.locator("body").press("ArrowLeft")
    expect(page.locator("#timeline [aria-current=true]")).to_contain_text("S7-400")
    page.click("#possible >> text=EN_AIRT ret=W#16#8080")
    expect(page.locator("#timeline")).to_contain_text("EN_AIRT")
    expect(page.locator("#others .timeline")).to_contain_text("DIS_AIRT")
    page.click("#others .timeline button >> text=DIS_AIRT")
    expect(page.locator("#timeline")).to_contain_text("DIS_AIRT")
    expect(page.locator("#situation")).to_contain_text("1 DIS_AIRT not taken back")
    expect(page.locator("#others .timeline")).to_contain_text("EN_AIRT")


def test_the_timeline_is_made_wider(page: Page) -> None:
    """By its button; nothing else moves."""
    paste(page, REJECTED)
    first = page.locator("#timeline button").nth(1)
    before = first.bounding_box()
    assert before is not None
    page.click("#wider")
    width = "document.querySelectorAll('#timeline button')[1]?.getBoundingClientRect().width"
    page.wait_for_function(f"before => {width} > 1.2 * before", arg=before["width"])


@pytest.mark.parametrize("width", [360, 1600])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(page: Page, scheme: Literal["light", "dark"], width: int) -> None:
    """At the start, and with a rejected log."""
    emulate(page, f"(prefers-color-scheme: {scheme})", scheme)
    page.set_viewport_size({"width": width, "height": 900})
    assert Axe().run(page).response["violations"] == []
    paste(page, REJECTED)
    expect(page.locator("#timeline .wrong")).to_be_visible()
    assert Axe().run(page).response["violations"] == []


def test_a_behaviour_is_built_by_keyboard_alone(page: Page) -> None:
    """Enter begins it; Tab leads to the buttons, Enter takes one."""
    page.locator("#new [name=clock]").press("Enter")
    expect(page.locator("#possible button", has_text="DIS_AIRT ret=W#16#0001").first).to_be_visible()
    for _ in range(200):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.textContent") == "DIS_AIRT ret=W#16#0001":
            break
    page.keyboard.press("Enter")
    expect(page.locator("#situation")).to_contain_text("1 DIS_AIRT not taken back")


def test_a_case_of_the_gallery_and_a_requirement(page: Page) -> None:
    """Found by its words; a requirement is told in full."""
    page.fill("#find", "delay OB 80 missing")
    page.click("#gallery >> text=A skipped point under DIS_AIRT, OB 80 missing")
    expect(page.locator("#timeline")).to_contain_text("stop")
    page.click("#possible button.id >> nth=0")
    assert len(page.locator("#clause p").first.inner_text()) > 20
    page.keyboard.press("Escape")
    expect(page.locator("#clause")).to_be_hidden()


FOUND = ("SRT_DINT", "CAN_TINT", "ACT_TINT", "DIS_IRT", "EN_IRT", "hot restart", "priority", "same class", "monthly")


@pytest.mark.parametrize("wanted", FOUND)
def test_an_edge_case_is_found_by_its_calls_and_its_rules(page: Page, wanted: str) -> None:
    """Also where its own text does not say them."""
    page.fill("#find", wanted)
    expect(page.locator("#gallery .choice").first).to_be_visible()


def test_an_id_is_found_as_a_whole(page: Page) -> None:
    """The end of one is no word."""
    page.fill("#find", "TINT-31")
    expect(page.locator("#gallery .choice").first).to_be_visible()
    page.fill("#find", "31")
    expect(page.locator("#gallery")).not_to_contain_text("TINT-31")


def test_in_the_site_there_are_ways_back(page: Page, tmp_path: Path) -> None:
    """To its pages, and from a rule to the book; alone the page has none."""
    assert page.locator("a:visible").count() == 0
    copy = tmp_path / "explorer.html"
    copy.write_bytes(PAGE.read_bytes())
    page.goto(copy.as_uri())
    page.wait_for_selector("body[data-ready]")
    assert page.locator("#site a").evaluate_all("all => all.map(a => a.getAttribute('href'))") == [
        "index.html",
        "book.html",
    ]
    page.locator("#gallery button.id", has_text="CLK-02").first.click()
    assert re.fullmatch(r"book/[\w-]+\.html#CLK-02", page.locator("#clause a").get_attribute("href") or "")


def test_the_question_by_which_explanations_differ(page: Page) -> None:
    """SRT_DINT on an OB that waits: AMB-11 with its answers, above the explanations."""
    header = HEADER | {"obs": [1, 20, 80, 85, 100]}
    call = {"event": "SRT_DINT", "ob": 20, "sign": 0, "ret": 0}
    lines = [
        header,
        call | {"at": AT, "dtime": 100},
        {"event": "DIS_AIRT", "at": AT, "ret": 1},
        call | {"at": "2026-03-02T08:00:31.200", "dtime": 500},
    ]
    paste(page, "\n".join(map(json.dumps, lines)))
    expect(page.locator("#situation li")).to_contain_text(re.compile(r"AMB-11.*\(b\).*: explanation \d"))
    assert page.locator("#situation li").count() == 1


def test_a_line_is_found_by_its_number_its_time_and_its_text(page: Page) -> None:
    """A text is looked for behind the shown line, and from the begin again; none is told."""
    paste(page, REJECTED.replace("\n", "\n\n"))
    current = page.locator("#timeline [aria-current=true]")
    found = {"3": "interrupt", "start": "start OB 40", "08:00:31": "EN_AIRT", "interrupt-log": "S7-400"}
    for wanted, said in found.items():
        page.fill("#find-line [name=wanted]", wanted)
        page.press("#find-line [name=wanted]", "Enter")
        expect(current).to_contain_text(said)
    page.fill("#find-line [name=wanted]", "99")
    page.press("#find-line [name=wanted]", "Enter")
    expect(page.locator("#problem")).to_contain_text("No line has 99.")


def test_the_focus_stays_with_who_goes_on_at_once(page: Page) -> None:
    """A log that has been opened takes the focus before it can be used, not when its last part is there."""
    page.evaluate(
        """() => new MutationObserver(() => document.querySelector("#find-line [name=wanted]").focus())
            .observe(document.getElementById("desk"), {attributeFilter: ["hidden"]})"""
    )
    paste(page, REJECTED)
    expect(page.locator("#readings h3")).to_be_visible()
    expect(page.locator("#find-line [name=wanted]")).to_be_focused()


def test_an_address_opens_an_edge_case(page: Page) -> None:
    """As the site links it; a name that is none is told."""
    page.goto("about:blank")
    page.goto(f"{PAGE.as_uri()}#open=clock-onto-a-point")
    expect(page.locator("#where")).to_contain_text("clock-onto-a-point: after line")
    page.goto("about:blank")
    page.goto(f"{PAGE.as_uri()}#open=none")
    expect(page.locator("#problem")).to_contain_text("names no edge case")


@pytest.mark.parametrize("width", [360, 1600])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_wider_than_the_window(browser: Browser, width: int, scheme: str) -> None:
    """On the start page and with a log."""
    context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)  # type: ignore[arg-type]
    page = context.new_page()
    page.goto(PAGE.as_uri())
    page.wait_for_selector("body[data-ready]")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    page.click("#gallery >> text=Nested DIS_AIRT")
    expect(page.locator("#verdict")).to_contain_text("accepted")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    context.close()


def test_the_keys_go_from_line_to_line(page: Page) -> None:
    """In the timeline the focus goes with them."""
    paste(page, REJECTED)
    page.locator("#timeline [aria-current=true]").focus()
    page.keyboard.press("ArrowLeft")
    expect(page.locator("#timeline [aria-current=true]")).to_contain_text("start OB 40")
    expect(page.locator("#timeline [aria-current=true]")).to_be_focused()


def test_the_engine_starts_anew_when_it_was_stopped(page: Page) -> None:
    """It says so, and answers again."""
    paste(page, REJECTED)
    expect(page.locator("#verdict")).to_contain_text("rejected")
    page.evaluate("document.getElementById('stop').onclick()")
    page.click("#home")
    paste(page, REJECTED)
    expect(page.locator("#verdict")).to_contain_text("rejected")
    expect(page.locator("#problem")).to_be_hidden()


def test_only_what_is_in_view_is_drawn(page: Page) -> None:
    """A long log has as many elements as a short one; of too many explanations there is no verdict."""
    text = "\n".join([json.dumps(HEADER), *[json.dumps({"event": "DIS_AIRT", "ret": None, "at": AT})] * 3000])
    page.set_input_files("#file", {"name": "long.ndjson", "mimeType": "text/plain", "buffer": text.encode()})
    expect(page.locator("#verdict")).to_contain_text("no verdict too many explanations")
    expect(page.locator("#timeline [aria-current=true]")).to_be_visible()
    assert page.locator("#lines button, #timeline button").count() < 100


def test_the_page_answers_as_the_engine_in_java(page: Page) -> None:
    """Each twelfth case, the whole answers. `s7spec logs engines --page` compares all."""
    with Engine(jvm_command) as java:
        for case in CASES[::EACH]:
            log = b"\n".join(case.lines)
            java.begin(follow=1, outcomes=True)
            java.send(log)
            assert judged_in(page, log) == java.finish(), case.id

"""The explorer's page in headless Chromium. Not run where there is no Chromium."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, Route, expect, sync_playwright

from s7check.exploring.library import Library
from s7check.kit.program import read_program
from tests.explorer_server import TOKEN, served
from tests.shipped import TRACES

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
QUIET = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]
LONGEST_MS = 60_000
"""For one step, on a busy machine."""

pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="no Chromium")


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """The address of a running explorer."""
    with served(Library(cases=TRACES)) as one:
        yield f"{one}/{TOKEN}/"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """One Chromium for all tests."""
    expect.set_options(timeout=LONGEST_MS)
    with sync_playwright() as playwright:
        yield playwright.chromium.launch(executable_path=CHROMIUM, args=QUIET)


@pytest.fixture
def page(browser: Browser, address: str) -> Iterator[Page]:
    """The start page, in a browser that knows nothing; no script may fail, nothing may be asked of another host."""
    context = browser.new_context()
    page = context.new_page()
    page.set_default_timeout(LONGEST_MS)
    failed: list[str] = []
    page.on("pageerror", lambda error: failed.append(str(error)))
    page.on(
        "request",
        lambda one: (
            failed.append(one.url)
            if address not in f"{one.url}/" and ":" in one.url and not one.url.startswith(("data:", "blob:"))
            else None
        ),
    )
    page.goto(address)
    expect(page.locator("#gallery li").first).to_be_visible()
    yield page
    context.close()
    assert failed == []


def may_come(page: Page, text: str) -> None:
    """Wait until a button with this text is among what may come."""
    expect(page.locator("#possible button", has_text=text).first).to_be_visible()


def test_the_clock_over_a_point_under_a_delay_without_ob_80(page: Page) -> None:
    """What happens? Answered by one entry and three clicks."""
    page.fill("#new [name=obs]", "1 10 20 40 85")
    page.click("#new >> text=Begin")
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    page.click("#possible >> text=/clock to=2026-11-21T06:00:00.001/")
    may_come(page, "stop cause=W#16#4568")
    expect(page.locator("#situation")).to_contain_text("STOP")
    expect(page.locator("#possible")).not_to_contain_text("start ob=10")
    expect(page.locator("#impossible")).to_contain_text("start ob=10")


def test_the_same_from_the_gallery(page: Page) -> None:
    """The same from the gallery."""
    page.fill("#find", "delay OB 80 missing")
    page.click("#gallery >> text=A skipped point under DIS_AIRT, OB 80 missing")
    expect(page.locator("#lines")).to_contain_text("stop cause=W#16#4568")
    expect(page.locator("#pictures svg").first).to_be_visible()
    expect(page.locator("details pattern")).to_have_count(0)  # a closed one would hide what fills the bars


def test_a_rejected_log_is_opened_changed_and_accepted(page: Page) -> None:
    """A rejected log is opened changed and accepted."""
    page.fill("#name", "AIRT/reject/AIRT-07-nothing-delayed-answers-0000")
    page.click("#open")
    expect(page.locator("#refused")).to_be_visible()
    wrong = page.locator("#lines .wrong")
    expect(wrong).to_have_count(1)
    page.locator("#refused button.choice").first.click()
    expect(page.locator("#refused")).to_be_hidden()
    expect(page.locator("#lines .wrong")).to_have_count(0)


def test_a_link_in_a_fresh_browser_shows_the_same(page: Page, browser: Browser) -> None:
    """A link in a fresh browser shows the same."""
    page.click("#gallery >> text=Nested DIS_AIRT")
    expect(page.locator("#lines li")).not_to_have_count(0)
    page.wait_for_function("location.hash.length > 10")
    lines = page.locator("#lines").inner_text()
    situation = page.locator("#situation").inner_text()
    other = browser.new_context().new_page()
    other.goto(page.url)
    expect(other.locator("#lines li").first).to_be_visible(timeout=LONGEST_MS)
    assert other.locator("#lines").inner_text() == lines
    assert other.locator("#situation").inner_text() == situation
    other.context.close()


def test_undo_redo_and_branches_by_keyboard(page: Page) -> None:
    """Undo redo and branches by keyboard."""
    page.click("#new >> text=Begin")
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    expect(page.locator("#lines li")).to_have_count(2)
    page.locator("body").press("u")
    expect(page.locator("#lines li")).to_have_count(1)
    page.locator("body").press("r")
    expect(page.locator("#lines li")).to_have_count(2)
    page.locator("body").press("ArrowLeft")
    expect(page.locator("#lines li.current")).to_contain_text("S7-400")
    page.click("#possible >> text=EN_AIRT ret=W#16#8080")
    expect(page.locator("#branches .tab")).to_have_count(2)
    expect(page.locator("#pictures .picture")).to_have_count(2)


def test_a_behaviour_is_built_by_keyboard_alone(page: Page) -> None:
    """Enter begins it; Tab leads to the buttons, Enter takes one."""
    page.locator("#new [name=clock]").press("Enter")
    may_come(page, "DIS_AIRT ret=W#16#0001")
    for _ in range(200):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.textContent") == "DIS_AIRT ret=W#16#0001":
            break
    page.keyboard.press("Enter")
    expect(page.locator("#lines li")).to_have_count(2)


def test_saved_as_a_log_and_as_a_program(page: Page, tmp_path: Path) -> None:
    """Either is opened again; the specification runs the program, and its log is the same."""
    page.click("#new >> text=Begin")
    page.click("#possible >> text=DIS_AIRT ret=W#16#0001")
    page.click("#possible >> text=EN_AIRT ret=W#16#0000")
    expect(page.locator("#lines li")).to_have_count(3)
    for name in ("save", "program"):
        with page.expect_download() as saved:
            page.click(f"#{name}")
        file = tmp_path / saved.value.suggested_filename
        saved.value.save_as(file)
        if name == "program":
            assert [step.get("call") for step in read_program(file.read_bytes()).bodies[0].steps][:2] == [
                "DIS_AIRT",
                "EN_AIRT",
            ]
        page.click("#home")
        page.set_input_files("#file", file)
        expect(page.locator("#lines")).to_contain_text("EN_AIRT ret=W#16#0000")
        expect(page.locator("#refused")).to_be_hidden()


def test_a_program_of_the_kit_is_opened(page: Page) -> None:
    """As the log that the specification makes of it."""
    page.fill("#name", "kit/AIRT-03-nested-delay")
    page.click("#open")
    expect(page.locator("#lines")).to_contain_text("DIS_AIRT ret=W#16#0002")
    expect(page.locator("#refused")).to_be_hidden()


def test_another_cpu_forks_the_behaviour(page: Page) -> None:
    """Another CPU forks the behaviour."""
    page.click("#gallery >> text=The clock is set back on an S7-300")
    page.select_option("#compare [name=cpu]", "S7-400")
    page.click("#compare >> text=Compare")
    expect(page.locator("#sides")).to_contain_text("is not possible there")
    page.click("#sides >> text=Go on there")
    expect(page.locator("#refused")).to_be_visible()


def test_a_call_with_operands_shows_its_answers(page: Page) -> None:
    """A call with operands shows its answers."""
    page.click("#new >> text=Begin")
    page.click("#possible summary:has-text('SET_TINT')")
    # page.fill selects the old value and types: with a list of choices it has once typed behind it.
    date = page.locator("#possible details[open] input[name=sdt]")
    date.evaluate("(box, value) => { box.value = value; box.dispatchEvent(new Event('input')) }", "2026-02-30T06:00")
    may_come(page, "ret=W#16#8091")


def test_an_answer_to_earlier_operands_is_not_shown(page: Page) -> None:
    """The answer to the first operands comes behind the answer to the second: what is shown is of the second."""
    held: list[Route] = []

    def later(route: Route) -> None:
        if not held:
            held.append(route)
            return
        route.fulfill(response=route.fetch())
        held[0].fulfill(response=held[0].fetch())

    page.route("**/answers", later)
    page.click("#new >> text=Begin")
    page.click("#possible summary:has-text('ACT_TINT')")
    ob = page.locator("#possible details[open] input[name=ob]")
    expect(ob).not_to_have_value("")
    with page.expect_response(
        lambda answer: "answers" in answer.url and '"ob":10' not in f"{answer.request.post_data}"
    ):
        ob.evaluate("(box) => { box.value = 10; box.dispatchEvent(new Event('input')) }")
    expect(page.locator("#possible details[open] .answers")).to_contain_text("ob=10")


def test_a_requirement_is_shown(page: Page) -> None:
    """A requirement is shown."""
    page.click("#gallery button.id >> nth=0")
    expect(page.locator("#clause")).to_be_visible()
    assert len(page.locator("#clause p").first.inner_text()) > 20
    page.keyboard.press("Escape")
    expect(page.locator("#clause")).to_be_hidden()


def test_a_wrong_log_is_told_in_a_sentence(page: Page, tmp_path: Path) -> None:
    """A wrong log is told in a sentence."""
    path = tmp_path / "wrong.ndjson"
    path.write_text('{"format": "s7-interrupt-log/1"}\nnot JSON\n')
    page.set_input_files("#file", path)
    expect(page.locator("#problem")).to_contain_text("wrong.ndjson:2: expected a JSON object")


@pytest.mark.parametrize("width", [360, 1600])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_wider_than_the_window(browser: Browser, address: str, width: int, scheme: str) -> None:
    """Nothing is wider than the window."""
    context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)  # type: ignore[arg-type]
    page = context.new_page()
    page.goto(address)
    expect(page.locator("#gallery li").first).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    page.click("#gallery >> text=Nested DIS_AIRT")
    expect(page.locator("#lines li").first).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    context.close()

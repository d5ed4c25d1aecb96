"""The explorer's answers, without a page."""

from collections.abc import Iterator
from typing import Any
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import msgspec
import pytest

from s7check.asking.line_text import spelled
from s7check.asking.session import Session
from s7check.engine.client import Engine
from s7check.exploring.desk import SESSIONS, Call, Comparison, Desk, Question, Side, Why
from s7check.exploring.library import Library, read
from s7check.kit.program import read_program
from s7check.log.calls import OPERANDS
from s7check.log.errors import UnusableLogError
from tests.explorer_server import TOKEN, served
from tests.shipped import TRACES

HEADER: dict[str, Any] = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-400",
    "obs": [1, 10, 85],
    "clock": "2026-11-21T05:59:30",
    "mode": "RUN",
    "cycle": True,
    "step7": {"tod": {"10": {"execution": "minute", "start": "2026-11-21T06:00", "active": True}}},
}
DELAYED = {"event": "DIS_AIRT", "at": "2026-11-21T05:59:30.000", "ret": "W#16#0001"}
OVER_A_POINT = {"event": "clock", "at": "2026-11-21T05:59:30.000", "to": "2026-11-21T06:00:30.000"}


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    """One engine for all questions."""
    with Engine() as one:
        yield one


@pytest.fixture
def desk(engine: Engine) -> Desk:
    """A desk without sessions."""
    return Desk(engine)


def test_what_may_come_after_the_clock_passed_a_point_under_a_delay(desk: Desk) -> None:
    """What may come after the clock passed a point under a delay."""
    answer = desk.look(Question(HEADER, [DELAYED, OVER_A_POINT]))
    assert answer["explained"] == 2
    texts = [line["text"] for line in answer["possible"]]
    assert "stop cause=W#16#4568" in texts
    assert not any(text.startswith("start ob=10") for text in texts)
    reasons = {spelled(one["event"]): one for one in answer["impossible"]}
    assert reasons["start ob=10"]["because"]
    assert 'data-line="3"' in answer["timeline"]


def test_a_line_that_is_not_possible_is_told_and_the_lines_before_are_explained(desk: Desk) -> None:
    """A line that is not possible is told and the lines before are explained."""
    wrong = DELAYED | {"ret": "W#16#0002"}
    answer = desk.look(Question(HEADER, [wrong, OVER_A_POINT]))
    assert answer["explained"] == 0
    assert "AIRT-06" in answer["refused"]["requirements"]
    assert answer["refused"]["instead"] == [{"event": "DIS_AIRT", "ret": "W#16#0001"}]


def test_lines_that_change_are_taken_back_and_added(desk: Desk) -> None:
    """Lines that change are taken back and added."""
    first = desk.look(Question(HEADER, [DELAYED, OVER_A_POINT]))
    desk.look(Question(HEADER, [DELAYED, {"event": "EN_AIRT", "at": DELAYED["at"], "ret": "W#16#0000"}]))
    again = desk.look(Question(HEADER, [DELAYED, OVER_A_POINT]))
    assert again == first


def test_another_cpu_is_compared(desk: Desk) -> None:
    """Another CPU is compared."""
    same = desk.compare(Comparison(HEADER, [DELAYED], side=Side(cpu="S7-300")))
    assert same["name"] == "S7-300"
    assert same["refused"] is None
    assert same["only_here"] == same["only_there"] == []
    other = desk.compare(Comparison(HEADER, side=Side(profile="1997")))
    assert "QRY_TINT ob=10 ret=W#16#0000 status=W#16#0014" in other["only_here"]
    assert "QRY_TINT ob=10 ret=W#16#0000 status=W#16#0034" in other["only_there"]


def test_the_lines_of_another_edition_are_refused(desk: Desk) -> None:
    """The lines of another edition are refused."""
    query = {"event": "QRY_TINT", "at": HEADER["clock"], "ob": 10, "ret": 0, "status": "W#16#0014"}
    refused = desk.compare(Comparison(HEADER, [query], side=Side(profile="1997")))
    assert refused["explained"] == 0
    assert refused["refused"]["instead"] == [{"event": "QRY_TINT", "ob": 10, "status": "W#16#0034"}]


def test_a_step_looks_at_one_time_and_at_one_line_of_a_call_with_operands(engine: Engine, desk: Desk) -> None:
    """A step looks at one time and at one line of a call with operands."""
    answer = desk.look(Question(HEADER))
    calls = {line["text"].partition(" ret=")[0] for line in answer["possible"] if line["event"]["event"].isupper()}
    assert sorted(call.partition(" ")[0] for call in calls) == sorted(OPERANDS)
    assert answer["tries"] * 5 < Session(engine, HEADER).possible().tries
    assert len(answer["times"]) > 1


def test_what_may_come_when_time_has_passed(desk: Desk) -> None:
    """What may come when time has passed."""
    due = desk.look(Question(HEADER, at="2026-11-21T06:00:00.000"))
    assert "start ob=10" in [line["text"] for line in due["possible"]]
    assert desk.look(Question(HEADER, at="2026-11-21T06:00:00.011"))["possible"] == []


def test_the_operands_of_a_call(desk: Desk) -> None:
    """The operands of a call."""
    lines = desk.call(Call(HEADER, event="SET_TINT"))["possible"]
    assert {line["event"]["event"] for line in lines} == {"SET_TINT"}
    assert len({line["event"]["period"] for line in lines}) > 5


def test_a_log_that_leaves_much_open_is_answered_in_part(desk: Desk) -> None:
    """A log that leaves much open is answered in part."""
    loose = HEADER | {"records": ["ob", "clock", "mode", "interrupt", "load"]}
    answer = desk.look(Question(loose, [{"event": "start", "at": "2026-11-21T06:00:00.000", "ob": 10}]))
    assert answer["explained"] == 1
    assert not answer["whole"]
    assert answer["impossible"] is None
    assert "end ob=10" in [line["text"] for line in answer["possible"]]
    assert answer["timeline"]


def test_the_question_by_which_explanations_differ(desk: Desk) -> None:
    """SRT_DINT on an OB that waits: AMB-11; a log with one explanation has none."""
    call = {"event": "SRT_DINT", "ob": 20, "sign": 0, "ret": 0}
    lines = [
        {**call, "at": "2026-11-21T05:59:31", "dtime": 100},
        {"event": "DIS_AIRT", "at": "2026-11-21T05:59:31", "ret": 1},
        {**call, "at": "2026-11-21T05:59:31.200", "dtime": 500},
    ]
    header = HEADER | {"obs": [*HEADER["obs"], 20]}
    (said,) = desk.questions(Question(header, lines))["questions"]
    assert said.startswith("AMB-11 ")
    assert desk.questions(Question(header, lines[:1]))["questions"] == []


def test_the_answers_to_a_call_and_why_a_line_may_not_come(desk: Desk) -> None:
    """The answers to a call and why a line may not come."""
    call = {"event": "EN_AIRT", "at": HEADER["clock"]}
    assert [line["event"]["ret"] for line in desk.answers(Why(HEADER, call))["possible"]] == ["W#16#8080"]
    start = {"event": "start", "ob": 10, "at": HEADER["clock"]}
    assert desk.why(Why(HEADER, start))["refused"]["because"]
    assert desk.why(Why(HEADER, call | {"ret": "W#16#8080"}))["refused"] is None


def test_a_behaviour_as_a_program_and_the_program_as_a_behaviour(desk: Desk) -> None:
    """The program has the call, and the specification answers it alike."""
    program = read_program(desk.program(Question(HEADER, [DELAYED]))["text"].encode())
    assert [step.get("call") for step in program.bodies[0].steps][:1] == ["DIS_AIRT"]
    assert desk.run(program)["lines"][0]["ret"] == DELAYED["ret"]


def test_more_headers_than_sessions(desk: Desk) -> None:
    """More headers than sessions."""
    for minute in range(SESSIONS + 2):
        desk.look(Question(HEADER | {"clock": f"2026-11-21T05:{minute:02}:30"}))
    assert desk.look(Question(HEADER))["explained"] == 0


def test_an_unusable_line_leaves_the_desk_usable(desk: Desk) -> None:
    """An unusable line leaves the desk usable."""
    with pytest.raises(UnusableLogError):
        desk.look(Question(HEADER, [DELAYED, {"event": "unheard-of"}]))
    assert desk.look(Question(HEADER, [DELAYED]))["explained"] == 1


def test_the_library_has_the_gallery_and_the_shipped_logs() -> None:
    """The library has the gallery and the shipped logs."""
    library = Library(cases=TRACES)
    contents = library.contents()
    assert len(contents["gallery"]) >= 40
    name = contents["gallery"][0]["name"]
    assert library.open(name)["header"]["format"] == HEADER["format"]
    assert library.open(contents["logs"][0])["lines"]
    with pytest.raises(UnusableLogError):
        library.open("../../etc/passwd")


def test_a_log_that_cannot_be_read_names_its_line() -> None:
    """A log that cannot be read names its line."""
    with pytest.raises(UnusableLogError) as caught:
        read(b'{"format": "s7-interrupt-log/1"}\nnot JSON\n', "x")
    assert caught.value.line == 2
    with pytest.raises(UnusableLogError):
        read(b"", "x")


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """The address of a running explorer."""
    with served(Library()) as one:
        yield one


def request(address: str, path: str, body: bytes | None = None, host: str | None = None) -> tuple[int, str, str]:
    """Status, text and Content-Security-Policy of the answer."""
    asked = Request(address + path, data=body, headers={"Host": host} if host else {})  # noqa: S310
    try:
        with urlopen(asked) as answer:  # noqa: S310
            return answer.status, answer.read().decode(), answer.headers["Content-Security-Policy"]
    except HTTPError as error:
        return error.code, error.read().decode(), ""


def test_the_server_answers_only_under_its_token_and_host(address: str) -> None:
    """The server answers only under its token and host."""
    status, text, policy = request(address, f"/{TOKEN}/")
    assert status == 200
    assert "s7check explore" in text
    assert "default-src 'none'" in policy
    for name in ("explorer.js", "model.js", "explorer.css", "report.css", "start"):
        assert request(address, f"/{TOKEN}/{name}")[0] == 200
    assert request(address, "/")[0] == 404
    assert request(address, "/other/")[0] == 404
    assert request(address, f"/{TOKEN}/", host="example.org")[0] == 400
    status, text, _ = request(address, f"/{TOKEN}/look", msgspec.json.encode({"header": HEADER}))
    assert status == 200
    assert msgspec.json.decode(text)["explained"] == 0


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (b"{", "truncated"),
        (b'{"header": 1}', "object"),
        (b'{"header": {"format": "x"}}', "format"),
        (b'{"header": {}, "surprise": 1}', "surprise"),
    ],
)
def test_a_question_that_does_not_fit_is_answered_by_a_sentence(address: str, body: bytes, said: str) -> None:
    """A question that does not fit is answered by a sentence."""
    status, text, _ = request(address, f"/{TOKEN}/look", body)
    assert status == 422
    assert said in text

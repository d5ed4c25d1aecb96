"""``s7check kit``: adapters that work, fail and lie; the results in every format."""

import json
import sys
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest

from s7check import __version__
from s7check.cli import main
from s7check.kit import choosing, collection
from s7check.kit.collection import programs_of
from s7check.kit.offer import Offer
from s7check.kit.program import Program, read_program
from s7check.kit.results import Result, outcomes
from tests.kit.programs import PROGRAM

ADAPTER = Path(__file__).with_name("adapter.py")
AT = '"at": "2026-11-21T05:59:30.000"'
OUTSIDE = (
    '{"event": "interrupt", "at": "2026-11-21T05:59:30.000", "ob": 35}\n'
    '{"event": "start", "at": "2026-11-21T05:59:30.000", "ob": 35}\n'
)
RIGHT = f'{{"event": "DIS_AIRT", {AT}, "ret": 1}}\n'
EVENTS = {
    "right": RIGHT,
    "wrong": f'{{"event": "DIS_AIRT", {AT}, "ret": 2}}\n',
    **{f"wrong{n}": f'{{"event": "DIS_AIRT", {AT}, "ret": 2}}\n' for n in (2, 3, 4)},
    "extra": RIGHT + f'{{"event": "EN_AIRT", {AT}, "ret": 0}}\n',
    "cut": OUTSIDE + f'{{"event": "end", {AT}, "ob": 35}}\n',
}
WEEKLY = {"ob": 10, "sdt": "2026-11-23T06:00", "period": "16#1202"}
"""The code of weekly that the edition of 1997 and the reading a of AMB-01 refuse."""

for way, answer in {"taken": "16#0000", "refused": "16#8092"}.items():
    EVENTS[way] = json.dumps({"event": "SET_TINT", "at": "2026-11-21T05:59:30.000", **WEEKLY, "ret": answer}) + "\n"


def program(way: str) -> dict[str, object]:
    """A program of one call in OB 1, and one in OB 35."""
    steps = [{"call": "SET_TINT", **WEEKLY}] if way in ("taken", "refused") else [{"call": "DIS_AIRT"}]
    return PROGRAM | {
        "name": f"AIRT-{way}",
        "requirements": ["AIRT-06"],
        "duration": 100,
        "outside": [],
        "bodies": [{"ob": 1, "run": 1, "steps": steps}, {"ob": 35, "steps": steps}],
    }


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the events that the adapter writes."""
    for name, text in EVENTS.items():
        (tmp_path / f"{name}.events").write_text(text, encoding="utf-8")
    return tmp_path


def run(folder: Path, ways: list[str], *options: str) -> tuple[int, dict[str, dict[str, object]]]:
    """The exit code and the results by way."""
    file, output = folder / "programs.ndjson", folder / "out.json"
    file.write_text("".join(json.dumps(program(way)) + "\n" for way in ways), encoding="utf-8")
    command = ["--", sys.executable, str(ADAPTER), str(folder)]
    code = main(["kit", "run", "--programs", str(file), "--output", str(output), *options, *command])
    results = json.loads(output.read_text(encoding="utf-8"))["programs"] if output.exists() else []
    return code, {result["name"].partition("-")[2]: result for result in results}


def test_run(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A right log passes; a wrong one fails with the requirement that decides."""
    code, results = run(folder, ["right", "wrong"])
    assert code == 1
    assert (results["right"]["status"], results["right"]["events"]) == ("passed", 2), "the call and the end"
    assert (results["wrong"]["status"], results["wrong"]["deciding"]) == ("failed", ["AIRT-06", "AIRT-03"])
    said = capsys.readouterr().out
    assert "1 failed: AIRT-06: DIS_AIRT ret=16#0001 expected in place of DIS_AIRT: AIRT-wrong" in said
    assert "2 programs: 1 passed, 1 failed" in said


def test_under_another_reading(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A class of its own, in every format; it fails a run, but for the reading that it needs."""
    outputs = {ending: folder / f"out{ending}" for ending in (".xml", ".html", ".txt")}
    code, results = run(folder, ["taken", "refused", "wrong"], *(f"--output={file}" for file in outputs.values()))
    statuses = {way: result["status"] for way, result in results.items()}
    assert (code, statuses["taken"], statuses["wrong"]) == (1, "passed", "failed")
    assert statuses["refused"] == "passed under another reading"
    assert {"AMB-01 a", "profile 1997"} <= {*results["refused"]["passes_under"]}  # type: ignore[misc]
    assert results["wrong"]["passes_under"] == []
    said = capsys.readouterr().out
    assert "3 programs: 1 passed, 1 failed, 1 passed under another reading" in said
    assert "1 passed under profile 1997, " in said
    outcome = {one["requirement"]: one for one in json.loads((folder / "out.json").read_text())["requirements"]}
    assert (outcome["TINT-33"]["state"], outcome["TINT-33"]["under"]) == (statuses["refused"], ["AIRT-refused"])
    suite = Xml.fromstring(outputs[".xml"].read_text(encoding="utf-8"))  # noqa: S314
    assert suite.get("failures") == "2"
    assert suite.find("testsuite/properties/property[@name='passed under another reading'][@value='1']") is not None
    assert suite.find("testsuite/testcase/failure[@type='passed under another reading']") is not None
    assert "passed under profile 1997" in outputs[".html"].read_text(encoding="utf-8")
    assert "AIRT-refused: passed under profile 1997" in outputs[".txt"].read_text(encoding="utf-8")
    assert run(folder, ["refused"], "--set", "AMB-01=a")[0] == 0
    assert run(folder, ["refused"], "--profile", "1997")[0] == 0


def test_baseline_of_another_reading(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Known as it was; worse is new, better is not."""
    assert run(folder, ["refused"])[0] == 1
    old = (folder / "out.json").rename(folder / "old.json")
    assert run(folder, ["refused"], "--baseline", str(old))[0] == 0
    assert "known failures: 1: AIRT-refused" in capsys.readouterr().out
    events = folder / "refused.events"
    events.write_text(EVENTS["refused"].replace("8092", "8091"), encoding="utf-8")
    assert run(folder, ["refused"], "--baseline", str(old))[0] == 1
    assert "passed under another reading -> failed: 1" in capsys.readouterr().out
    old = (folder / "out.json").rename(folder / "old.json")
    events.write_text(EVENTS["refused"], encoding="utf-8")
    assert run(folder, ["refused"], "--baseline", str(old))[0] == 0
    assert "failed -> passed under another reading: 1" in capsys.readouterr().out


def test_the_same_result_again(folder: Path) -> None:
    """How many adapters are at work, and which is over first, changes nothing."""
    found = []
    for jobs in ("1", "4"):
        run(folder, ["wrong", "refused", "right", *("wrong2", "wrong3", "wrong4")], "--jobs", jobs)
        result = json.loads((folder / "out.json").read_text(encoding="utf-8"))
        timeless = [one | {"seconds": 0} for one in result["programs"]]
        found.append((timeless, result["requirements"]))
    assert found[0] == found[1]
    assert [bool(one["reduced"]) for one in found[0][0]] == [True, True, False, True, True, False]


@pytest.mark.parametrize(
    ("way", "reason"),
    [
        ("crash", "the adapter ended with exit code 7: out of cheese"),
        ("hang", "no end within 2 s"),
        ("garbage", "line 1: expected a JSON object; found hello"),
        ("empty", "unusable: expected a header; found an empty log"),
        ("other", 'not the log of this program: line 1: field "cpu": expected that of the program'),
        ("extra", "not the log of this program: line 3: no call of the program is left here"),
        ("cut", "not the log of this program: line 4: expected DIS_AIRT before the end of OB 35"),
    ],
)
def test_failure(folder: Path, way: str, reason: str) -> None:
    """A program fails, and the next one runs."""
    code, results = run(folder, [way, "right"], "--timeout", "2", "--jobs", "1")
    assert code == 1
    assert results[way]["status"] == "failed"
    assert str(results[way]["reason"]).startswith(reason)
    assert results["right"]["status"] == "passed"


def test_skips(folder: Path) -> None:
    """The adapter's own reason, and an offer without an OB."""
    code, results = run(folder, ["skip"])
    assert (code, results["skip"]["status"], results["skip"]["reason"]) == (0, "skipped", "no HOLD")
    offer = folder / "offer.json"
    offer.write_text('{"obs": [1, 10, 80, 85, 100]}', encoding="utf-8")
    code, results = run(folder, ["wrong"], "--offer", str(offer))
    assert (code, results["wrong"]["status"], results["wrong"]["reason"]) == (0, "skipped", "no OB 35")


def test_offers() -> None:
    """An OB that a CPU has not need not be loaded to be missed: a call or an event from outside may name it."""
    few = Offer(obs=frozenset({1, 10, 35, 80, 85, 100}))

    def lacks(steps: list[dict[str, object]], *outside: dict[str, object]) -> str:
        bodies = [{"ob": 1, "run": 1, "steps": steps}]
        return few.lacks(read_program(json.dumps(PROGRAM | {"bodies": bodies, "outside": outside}).encode()))

    assert lacks([{"call": "QRY_DINT", "ob": 20}]) == "no OB 20"
    assert lacks([{"call": "QRY_DINT", "ob": 24}, {"call": "QRY_TINT", "ob": 20}]) == "", "no CPU has these"
    assert lacks([], {"after": 10, "event": "interrupt", "ob": 40}) == "no OB 40"


def test_fitted() -> None:
    """A program runs on the CPU's own family, and without OBs that nothing can start; it needs the others."""
    program = read_program(json.dumps(PROGRAM | {"outside": [{"after": 10, "event": "interrupt", "ob": 35}]}).encode())
    more = read_program(json.dumps(program.raw | {"header": program.header | {"obs": [1, 35, 41, 80]}}).encode())
    fitted = Offer(cpu=frozenset({"CPU 318"}), obs=frozenset({1, 10})).fitted(more)
    assert (fitted.header["cpu"], fitted.header["obs"]) == ("CPU 318", [1, 35, 80])
    assert fitted.raw["header"] == fitted.header
    assert fitted.header["clock"] == more.header["clock"]
    assert Offer().fitted(more) is more
    classes = read_program(json.dumps(more.raw | {"header": more.header | {"priority": {"35": 5}}}).encode())
    assert Offer(cpu=frozenset({"S7-300"})).lacks(Offer(cpu=frozenset({"S7-300"})).fitted(classes)) == "no S7-400"


@pytest.mark.parametrize(
    ("header", "steps", "lack"),
    [
        ({}, [], ""),
        ({"priority": {"40": 24}}, [], "no S7-1500"),
        ({"zone": 60}, [], "no S7-1500"),
        ({"queue": {"40": {"events": 2}}}, [], "no S7-1500"),
        ({"classes": {"123": "hardware"}}, [], "no S7-1500"),
        ({"step7": {"tod": {"10": {"local": True}}}}, [], "no S7-1500"),
        ({}, [{"call": "SET_TINTL", "local": True, "activate": True, **WEEKLY}], "no S7-1500"),
        ({}, [{"event": "zone", "zone": 60, "reason": "daylight"}], "no S7-1500"),
    ],
)
def test_what_only_an_s7_1500_has(header: dict[str, object], steps: list[dict[str, object]], lack: str) -> None:
    """Such a program is for no other CPU."""
    header = PROGRAM["header"] | {"cpu": "S7-1500", "obs": [1, 40, 80]} | header
    program = read_program(json.dumps(PROGRAM | {"header": header, "bodies": [{"ob": 1, "steps": steps}]}))
    older = Offer(cpu=frozenset({"S7-400"}))
    assert older.lacks(older.fitted(program)) == lack


def test_what_an_offer_lacks() -> None:
    """Deselected OBs are skipped; a log of cycles is not asked for; an OB that is always loaded may not be missed."""

    def altered(**fields: object) -> Program:
        return read_program(json.dumps(PROGRAM | {"header": PROGRAM["header"] | fields}))

    none = Offer(deselected=False, cycle=False)
    assert none.lacks(altered(priority={"35": 0})) == "no deselected OB 35"
    assert none.lacks(altered(step7={"dint": {"20": {"deselected": True}}})) == "no deselected OB 20"
    assert none.lacks(altered(step7={"tod": {"11": {"deselected": True}}})) == "no deselected OB 11"
    assert none.lacks(altered(priority={"35": 5}, step7={"tod": {"11": {"deselected": False}}})) == ""
    assert not none.fitted(altered(cycle=True)).plain["header"]["cycle"]
    assert Offer().fitted(altered(cycle=True)).header["cycle"]
    full = Offer(loaded=frozenset({35, 40, 41}))
    fitted = full.fitted(altered(obs=[1, 35, 80, 85, 100]))
    assert (fitted.header["obs"], full.lacks(fitted)) == ([1, 35, 80, 85, 100, 40, 41], "")
    missed = full.fitted(altered(obs=[1, 80, 85, 100]))
    assert full.lacks(missed) == "OB 35 cannot be missing", "OB 35 is started from outside"


def test_an_offer_of_the_diagnostic_buffer(folder: Path) -> None:
    """What is offered is owed: a log without it is not judged as if there were no entries."""
    offer = folder / "offer.json"
    offer.write_text('{"diag": true, "deselected": false, "cycle": false, "loaded": [1]}', encoding="utf-8")
    code, results = run(folder, ["right"], "--offer", str(offer))
    assert (code, results["right"]["status"]) == (1, "failed")
    assert 'field "records": expected diag, as the offer has it' in str(results["right"]["reason"])
    offer.write_text('{"diag": 1}', encoding="utf-8")
    assert main(["kit", "run", "--offer", str(offer), "--", "cpu"]) == 2


def test_resume(folder: Path) -> None:
    """What a file has is not run again, but for another command or a changed program."""
    kept = folder / "kept.ndjson"
    assert run(folder, ["right"], "--resume", str(kept))[0] == 0
    (folder / "right.events").write_text(EVENTS["wrong"], encoding="utf-8")
    assert run(folder, ["right", "wrong"], "--resume", str(kept))[0] == 1
    kept_names = [json.loads(line)["name"] for line in kept.read_text(encoding="utf-8").splitlines()]
    assert kept_names == ["AIRT-right", "AIRT-wrong", "AIRT-wrong"], "a failure again, with its reduced log"
    assert run(folder, ["right"])[0] == 1
    offer = folder / "offer.json"
    offer.write_text('{"obs": [1]}', encoding="utf-8")
    _, results = run(folder, ["wrong"], "--resume", str(kept), "--offer", str(offer))
    assert results["wrong"]["status"] == "skipped", "another offer, another result"


def test_formats(folder: Path) -> None:
    """JUnit, HTML, a badge and text."""
    outputs = {ending: folder / f"out{ending}" for ending in (".xml", ".html", ".svg", ".txt")}
    run(folder, ["right", "wrong", "skip"], *(f"--output={file}" for file in outputs.values()))
    suite = Xml.fromstring(outputs[".xml"].read_text(encoding="utf-8"))  # noqa: S314
    assert (suite.get("tests"), suite.get("failures"), suite.get("skipped")) == ("3", "1", "1")
    page = outputs[".html"].read_text(encoding="utf-8")
    assert all(part in page for part in ("AIRT-wrong", "the reduced log", "lines 2 to 2 of 2", "OB had to start"))
    assert "1 of 3 requirements" in outputs[".svg"].read_text(encoding="utf-8")
    text = outputs[".txt"].read_text(encoding="utf-8")
    assert "AIRT-wrong: failed: rejected" in text
    assert "AIRT-03: AIRT-wrong" in text
    assert f"tool: {__version__}" in text
    assert suite.find("testsuite/properties/property[@name='specification']") is not None


def test_the_run_is_in_the_result(folder: Path) -> None:
    """Which tool, specification and programs, on what, when and how; other programs have another hash."""
    offer = folder / "offer.json"
    offer.write_text('{"obs": [1, 10, 35, 80, 85, 100]}', encoding="utf-8")
    found = []
    for ways in (["right"], ["right", "extra"]):
        run(folder, ways, "--implementation", "toy 3", "--offer", str(offer), "--set", "AMB-08=b")
        found.append(json.loads((folder / "out.json").read_text(encoding="utf-8"))["run"])
    assert found[0]["implementation"] == "toy 3"
    assert (found[0]["tool"], found[0]["readings"]) == (__version__, {"AMB-08": "b"})
    assert found[0]["offer"] == {"obs": [1, 10, 35, 80, 85, 100]}
    assert "adapter.py" in found[0]["command"]
    assert found[0]["specification"] == found[1]["specification"] != ""
    assert found[0]["programs"] != found[1]["programs"]


def test_baseline(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Known failures fail no run; what changed is said."""
    assert run(folder, ["right", "wrong"])[0] == 1
    old = (folder / "out.json").rename(folder / "old.json")
    assert run(folder, ["right", "wrong"], "--baseline", str(old))[0] == 0
    assert "known failures: 1: AIRT-wrong" in capsys.readouterr().out
    (folder / "right.events").write_text(EVENTS["wrong"], encoding="utf-8")
    assert run(folder, ["right", "wrong"], "--baseline", str(old))[0] == 1
    assert "passed -> failed: 1: AIRT-right" in capsys.readouterr().out


def test_a_run_that_is_broken_off(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """By the first failure, or by time-outs."""
    for options in (["--fail-fast"], ["--timeouts", "1"]):
        code, results = run(folder, ["hang", "right", "extra"], "--jobs", "1", "--timeout", "1", *options)
        assert (code, list(results)) == (1, ["hang"])
        assert "broken off: 2 programs were not run" in capsys.readouterr().out


def test_few_programs() -> None:
    """A cover reaches all that is reached, a budget bounds its time; shards are all programs, each once."""
    programs = programs_of()
    few = choosing.covering(programs, "requirements", None)
    assert len(few) < 60
    assert {name for one in few for name in one.reaches} == {name for one in programs for name in one.reaches}
    short = choosing.covering(programs, "guards", choosing.budget_of("2min"))
    assert 0 < sum(one.duration for one in short) <= 120_000
    parts = [choosing.shard(programs, part, 3) for part in (1, 2, 3)]
    assert sorted(one.name for part in parts for one in part) == sorted(one.name for one in programs)
    with pytest.raises(ValueError, match="expected a time such as 90s"):
        choosing.budget_of("soon")


def test_logs(folder: Path) -> None:
    """The log of each program is kept."""
    run(folder, ["right"], "--logs", str(folder / "logs"))
    assert len((folder / "logs" / "AIRT-right.ndjson").read_text(encoding="utf-8").splitlines()) == 3


def test_wrong_arguments(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One message, and exit code 2."""
    file = folder / "wrong.json"
    file.write_text('{"format": "s7-interrupt-program/1", "name": "no name"}', encoding="utf-8")
    for arguments, message in [
        (["run", "--programs", str(file), "--", "cpu"], f'{file}: field "name": expected a name'),
        (["run", "--only", "nothing", "--", "cpu"], "no program fits it"),
        (["run", "--shard", "3/2", "--", "cpu"], "expected I/N such as 1/4; found 3/2"),
        (["run", "--budget", "30min", "--", "cpu"], "--budget: expected --cover beside it"),
        (["run", "--output", "x.pdf", "--", "cpu"], "expected a name that ends with one of"),
        (["list", "--requirement", "XYZ-01"], "no program fits it"),
    ]:
        assert main(["kit", *arguments]) == 2
        assert message in capsys.readouterr().err
    file.write_text(json.dumps(program("right")), encoding="utf-8")
    assert main(["kit", "run", "--programs", str(file), "--", str(folder / "nowhere")]) == 2
    assert "cannot be started" in capsys.readouterr().err


def test_no_programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """In a checkout that was not set up the message says what to do."""
    monkeypatch.setattr(collection, "KIT", tmp_path / "programs")
    assert main(["kit", "list"]) == 2
    assert f"{tmp_path / 'programs'}: expected the folder with the programs of the kit: run `make setup`" in (
        capsys.readouterr().err
    )


def test_show_and_list(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A program as it can be read again; a line for each."""
    file = folder / "one.json"
    file.write_text(json.dumps(PROGRAM), encoding="utf-8")
    assert main(["kit", "show", "AIRT-nested", "--programs", str(file)]) == 0
    assert json.loads(capsys.readouterr().out) == PROGRAM
    assert main(["kit", "list", "--requirement", "AIRT-03", "--programs", str(file)]) == 0
    assert capsys.readouterr().out.startswith("AIRT-nested  AIRT-03  Delays nest")


def test_outcomes() -> None:
    """A requirement is passed where it was measured, whatever the program is about; a failure goes before it."""
    results = [
        Result("a", "", "passed", ("AIRT-03",), decided=("AIRT-07",)),
        Result("b", "", "failed", ("AIRT-01", "AIRT-07"), deciding=("AIRT-08",)),
        Result("c", "", "failed", ("AIRT-02",), reason="crash"),
        Result("d", "", "skipped", ("AIRT-04",), reason="no OB 20"),
    ]
    states = {one.requirement: one.state for one in outcomes(results) if one.state != "not reached"}
    assert states == {"AIRT-07": "passed", "AIRT-08": "failed", "AIRT-02": "failed", "AIRT-04": "skipped"}


def test_matrix(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Two results side by side; a file that is none."""
    run(folder, ["right"])
    (folder / "out.json").rename(folder / "first.json")
    run(folder, ["wrong"])
    capsys.readouterr()
    assert main(["kit", "matrix", f"A={folder / 'first.json'}", f"B={folder / 'out.json'}"]) == 0
    page = capsys.readouterr().out
    assert "| [AIRT-06](../rules/requirements.md#AIRT-06) | passed | **failed** |" in page
    assert "## Failed on B" in page
    assert main(["kit", "matrix", "nowhere.json"]) == 2
    assert "expected NAME=FILE" in capsys.readouterr().err
    assert main(["kit", "matrix", "A=nowhere.json"]) == 2
    assert "nowhere.json: expected a result of `s7check kit run`" in capsys.readouterr().err

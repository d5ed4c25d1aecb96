"""The forms of a report, with the fake engine."""

import json
import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import pytest

from s7check import cli, trace_command
from tests.logs import event, log_text

pytestmark = pytest.mark.usefixtures("_fake_engine", "_logs")

HOSTILE = "</title></script><script>alert(1)</script>&]]>\x1b[31m\x00"
FORMATS = ["text", "json", "junit", "sarif", "html"]


@pytest.fixture
def _logs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    started = event("start", ob=40)
    calls = [event("EN_AIRT", ret=0), event("clock", to="2026-11-21T05:59:33"), event("interrupt", 33, ob=42)]
    Path("good.ndjson").write_bytes(log_text(started, *calls))
    Path("bad <b>.ndjson").write_bytes(
        log_text(started, *calls, event("EN_AIRT", 34, ret=1, x_note=HOSTILE), event("stop", 35))
    )
    Path("ugly.ndjson").write_bytes(log_text(started, event("EN_AIRT", ret=HOSTILE)))
    Path("none.ndjson").write_bytes(log_text(event("hold")))


def written(form: str, *arguments: str) -> bytes:
    """What the command writes to a file about the logs of the folder."""
    assert cli.main(["trace", "--format", form, "--output", "report", *arguments, "."]) == 3
    return Path("report").read_bytes()


@pytest.mark.parametrize("form", FORMATS)
def test_file_and_standard_output_agree(form: str, capsys: pytest.CaptureFixture[str]) -> None:
    """A report is the same in a file; then nothing is printed."""
    data = written(form)
    assert capsys.readouterr().out == ""
    assert cli.main(["trace", "--format", form, "."]) == 3
    took = re.compile(rb' time="[0-9.]+"')
    assert took.sub(b"", capsys.readouterr().out.encode()) == took.sub(b"", data)
    assert b"\x1b" not in data
    assert b"\x00" not in data


def test_folder_that_does_not_exist(capsys: pytest.CaptureFixture[str]) -> None:
    """Where no file can be made, one line says so."""
    assert cli.main(["trace", "--output", "no/report", "good.ndjson"]) == 2
    assert "no/report" in capsys.readouterr().err


def test_junit() -> None:
    """A test case a log, with counts that fit."""
    root = Xml.fromstring(written("junit"))  # noqa: S314
    cases = {str(case.get("name")): case for case in root.iter("testcase")}
    assert [(root.get("tests"), root.get("failures"), root.get("errors"))] == [("4", "1", "2")]
    failure = cases["bad <b>.ndjson"].find("failure")
    assert failure is not None
    assert str(failure.get("message")).startswith("bad <b>.ndjson:6: ")
    assert "requirements: AIRT-07" in str(failure.text)
    assert cases["ugly.ndjson"].find("error") is not None
    assert len(cases["good.ndjson"]) == 0
    times = [float(str(case.get("time"))) for case in cases.values()]
    assert sum(times) > 0
    assert float(str(root.get("time"))) == pytest.approx(sum(times), abs=0.004)


def test_sarif() -> None:
    """A result for each log that is not accepted, at its line, with a rule that is there."""
    (run,) = json.loads(written("sarif"))["runs"]
    rules = [rule["id"] for rule in run["tool"]["driver"]["rules"]]
    results: list[dict[str, Any]] = run["results"]
    assert sorted(result["ruleId"] for result in results) == ["AIRT-07", "no-verdict", "unusable-log"]
    assert all(rules[result["ruleIndex"]] == result["ruleId"] for result in results)
    (place,) = next(result["locations"] for result in results if result["ruleId"] == "AIRT-07")
    assert place["physicalLocation"]["artifactLocation"]["uri"] == "bad%20%3Cb%3E.ndjson"
    assert place["physicalLocation"]["region"]["startLine"] == 6


def _rejected() -> tuple[dict[str, Any], dict[str, Any]]:
    """The result of the rejected log, and its rule."""
    (run,) = json.loads(written("sarif"))["runs"]
    result = next(one for one in run["results"] if one["ruleId"] == "AIRT-07")
    return result, run["tool"]["driver"]["rules"][result["ruleIndex"]]


def test_sarif_leads_to_the_rejected_line() -> None:
    """The code flow has the events up to the rejected one."""
    result, _ = _rejected()
    ((steps,),) = [flow["threadFlows"] for flow in result["codeFlows"]]
    lines = [one["location"]["physicalLocation"]["region"]["startLine"] for one in steps["locations"]]
    assert lines == [2, 3, 4, 5, 6]
    assert [one["importance"] for one in steps["locations"]] == ["important"] * 4 + ["essential"]
    assert '"start"' in steps["locations"][0]["location"]["message"]["text"]


def test_sarif_knows_a_rejection_again() -> None:
    """Lines before it and other times leave the fingerprint as it is; another answer changes it."""
    first = _rejected()[0]["partialFingerprints"]
    log = Path("bad <b>.ndjson")
    header, *lines = log.read_bytes().splitlines(keepends=True)
    log.write_bytes(b"".join([header, b"\n", *(line.replace(b"05:59:34", b"05:59:36") for line in lines)]))
    assert _rejected()[0]["partialFingerprints"] == first
    log.write_bytes(log.read_bytes().replace(b'"ret": 1', b'"ret": 2'))
    assert _rejected()[0]["partialFingerprints"] != first


def test_sarif_says_where_a_rule_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    """In this installation, or where the environment says that a code host shows the documents."""
    here = _rejected()[1]["helpUri"]
    assert here.startswith("file:///")
    assert Path(here.removeprefix("file://").partition("#")[0]).is_file()
    monkeypatch.setenv("S7CHECK_DOCUMENTS", "https://example.org/docs/rules/")
    assert _rejected()[1]["helpUri"] == "https://example.org/docs/rules/requirements.md#AIRT-07"


class Page(HTMLParser):
    """What a page is made of."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.links: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Notes the tag and where its attributes lead."""
        self.tags.append(tag)
        self.links += [str(value) for name, value in attrs if name in ("href", "src", "data", "action")]
        self.places |= {f"#{value}" for name, value in attrs if name == "id"}


def test_html() -> None:
    """One page that loads nothing, with a timeline of the logs that were judged."""
    text = written("html").decode()
    page = Page(text)
    assert page.tags.count("script") == 1
    assert text.count('class="scroll"') == 2
    assert set(page.links) <= page.places
    assert "#AIRT-07" in page.links
    assert "url(http" not in text
    assert "@import" not in text
    assert "bad &lt;b&gt;.ndjson:6" in text
    assert text.index("bad &lt;b&gt;") < text.index("good.ndjson")
    assert "OB 42: no effect" in text
    assert "clock set" in text
    assert page.tags.count("main") == 1
    regions = re.findall(r'role="region"[^>]*aria-label="([^"]*)"', text)
    assert len(set(regions)) == len(regions) == 2


def test_readings(capsys: pytest.CaptureFixture[str]) -> None:
    """Each log is judged by the other readings, or none is."""
    cli.main(["trace", "--format", "json", "--readings", "all", "good.ndjson", "bad <b>.ndjson"])
    good, bad = (json.loads(line) for line in capsys.readouterr().out.splitlines())
    assert [one["change"] for one in good["readings"]] == ["cpu S7-300", "profile 2006", "AMB-01 a", "AMB-12 b"]
    assert [one["change"] for one in bad["readings"] if one["verdict"] == "accepted"] == ["AMB-12 b"]
    cli.main(["trace", "--format", "json", "--readings", "none", "bad <b>.ndjson"])
    assert "readings" not in json.loads(capsys.readouterr().out)


def test_no_time_for_readings(capsys: pytest.CaptureFixture[str]) -> None:
    """Those that were not tried are named."""
    cli.main(["trace", "--format", "json", "--budget", "0", "bad <b>.ndjson"])
    report = json.loads(capsys.readouterr().out)
    assert report["readings"] == []
    assert report["untried"] == ["cpu S7-300", "profile 2006", "AMB-01 a", "AMB-12 b"]
    cli.main(["trace", "--budget", "0", "bad <b>.ndjson"])
    said = capsys.readouterr().out
    assert "  not tried:\n    cpu S7-300\n    profile 2006\n    AMB-01 a\n    AMB-12 b\n" in said


def test_readings_unasked(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Unasked they are tried for the first rejected logs of a call only."""
    monkeypatch.setattr(trace_command, "_TRIED", 3)
    cli.main(["trace", "--format", "json", *["good.ndjson", "bad <b>.ndjson"] * 5])
    tried = ["readings" in json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert tried == [False, True] * 3 + [False, False] * 2

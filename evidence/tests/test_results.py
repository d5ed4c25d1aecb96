"""``s7spec views results``: the numbers of the documentation come from runs, and no other page has any."""

import json
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from evidence import cli
from evidence.common.checkout import ROOT
from evidence.tests.test_docs import PAGES
from evidence.views.results import records, runs, summaries, texts
from evidence.views.results import results_command as command
from evidence.views.results.page import page, totals
from evidence.views.results.records import Record, Table
from evidence.views.results.runs import RUNS, SECOND
from s7check import __version__

GENERATED = {"docs/project/results.md", "CHANGELOG.md"}
"""Pages that may have numbers of runs; those of a change log are of its day."""

COUNTED = (
    "models|logs|mutants|(?:negative )?controls|states|survivors|conditions|inputs|sources|scenarios|lines|events"
    "|requirements|ambiguities|questions|modules|properties|formulas|tests|cases"
)
ADJECTIVES = "(?:(?:accepted|rejected|unusable|random|shipped|damaged|distinct|generated|deliberate|small) )?"
NUMBER = re.compile(
    rf"(?<![\w.,#-])\d[\d,]*(?:\.\d+)? {ADJECTIVES}(?:{COUNTED})\b"
    r"|(?<![\w.,#-])\d[\d,]{2,} (?:killed|accepted|rejected|survived|passed)\b"
    r"|\d+(?:\.\d+)? ?%"
    r"|(?<![\w.-])\d[\d,.]* (?:events/s|s|seconds|minutes|hours|MB|GB|microseconds)(?![\w/])"
)

ALLOWED = {
    "bench/README.md": (
        *("10 GB", "1,000,000 events", "10 lines", "1,000 logs", "100 lines", "10,000,000 events", "20 s", "600 MB"),
        *("100,000 events", "8 GB", "4 GB", "16 MB", "20 MB", "10 s", "60 s"),
    ),
    "docs/checking/asking.md": ("200 lines",),
    "docs/checking/commands.md": (
        *("4 GB", "1 GB", "50 logs", "300 MB", "448 MB", "5 s", "80 lines", "0.5 MB", "1,000 logs", "2 MB"),
    ),
    "docs/checking/python.md": ("0.5 s",),
    "docs/checking/coverage.md": ("24 logs",),
    "docs/checking/kit.md": ("5 s", "90 s"),
    "docs/checking/log-format.md": ("1 %",),
    "docs/checking/mcp.md": ("10 s",),
    "docs/checking/explorer.md": ("200,000 lines", "5 s"),
    "docs/checking/reports.md": ("80 lines", "40 lines", "5 s", "20 events"),
    "docs/project/agreement.md": ("10,000 logs", "59 events"),
    "docs/project/commands.md": ("95 %", "60 s", "8 minutes", "60 minutes"),
    "docs/project/mutation.md": ("60 mutants", "95 %"),
    "docs/rules/modelling.md": ("1,000 states",),
    "docs/rules/readings.md": ("20 s",),
    "docs/rules/requirements.md": ("5 s", "2 s", "1 s"),
    "docs/rules/requirements-s7-1500.md": ("20 s", "2 s", "1 s"),
    "examples/soft_plc/README.md": ("60 lines", "5 s", "2 MB", "20 s"),
    "traces/README.md": ("30 lines",),
}
"""Numbers that no run gives: limits, targets, defaults, sizes of inputs, samples of output, and the requirements."""


def name(path: Path) -> str:
    """Such as ``docs/README.md``."""
    return path.relative_to(ROOT).as_posix()


def long_numbers(kept: Record) -> Iterator[str]:
    """The numbers of a run that are long enough to be known again, but for round ones, as the page writes them."""
    for cell in (cell for table in kept.tables for row in table.rows for cell in row):
        if isinstance(cell, int) and cell >= 1000 and cell % 1000:
            yield f"{cell:,}"


def main(*arguments: str) -> int:
    """The exit code of the command."""
    try:
        return cli.main(["views", "results", *arguments])
    except SystemExit as ended:
        return ended.code if isinstance(ended.code, int) else -1


@pytest.mark.parametrize("path", [path for path in PAGES if name(path) not in GENERATED], ids=name)
def test_no_number_of_a_run(path: Path) -> None:
    """No page but the generated ones counts models, logs, states or the like, nor says how long something took."""
    found = {match[0] for match in NUMBER.finditer(path.read_text(encoding="utf-8"))}
    others = found - set(ALLOWED.get(name(path), ()))
    assert not others, "numbers of a run stand in docs/project/results.md alone; ALLOWED has limits and the like"


def test_every_allowance_has_a_page() -> None:
    """None is left over."""
    assert {name(path) for path in PAGES} >= {"README.md", *ALLOWED}


@pytest.mark.parametrize(
    "text",
    [
        *("1,752 logs", "all 228 models", "205 negative controls", "785 accepted, 936 rejected", "61,884 states"),
        *("94.0 %", "71,399 events/s", "took 264 s", "21,000 damaged inputs", "533 killed", "112 MB"),
    ],
)
def test_a_number_of_a_run_is_known(text: str) -> None:
    """Phrases that stood on pages before are found."""
    assert NUMBER.search(text)


@pytest.mark.parametrize(
    "text", ["OB 80 with 02", "AMB-49 states", "0 accepted, 1 rejected", "8091", "2 * 5s", "day 31"]
)
def test_a_number_of_the_rules_is_not(text: str) -> None:
    """Numbers of OBs, readings, codes and exit codes are no counts."""
    assert not NUMBER.search(text)


def test_kept_numbers_stand_nowhere_else() -> None:
    """The numbers of the kept summaries, whatever words stand around them."""
    kept = {number for record in records.read(ROOT / command.KEPT).values() for number in long_numbers(record)}
    assert len(kept) > 20
    for path in PAGES:
        if name(path) not in GENERATED:
            numbers = set(re.findall(r"(?<![\w,])\d{1,3}(?:,\d{3})+(?![\w,])", path.read_text(encoding="utf-8")))
            assert not numbers & kept, name(path)


def test_the_page_is_up_to_date(capsys: pytest.CaptureFixture[str]) -> None:
    """It is what the kept summaries say."""
    assert main() == 0, capsys.readouterr()


def test_kept_summaries_belong_to_a_run() -> None:
    """None is left over from a run that has another name now."""
    assert {kept.removesuffix(SECOND) for kept in records.read(ROOT / command.KEPT)} <= RUNS.keys()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout with an empty page, whose runs end at once."""
    (tmp_path / command.PAGE).parent.mkdir(parents=True)
    (tmp_path / command.PAGE).write_text("", encoding="utf-8")
    (tmp_path / "CHANGELOG.md").write_text("## Unreleased\n\n## 0.0.2\n\n## 0.0.1\n", encoding="utf-8")
    monkeypatch.setattr(command, "ROOT", tmp_path)
    monkeypatch.setattr(runs, "ROOT", tmp_path)
    return tmp_path


def claims(text: str) -> list[Table]:
    """Lines such as ``claim: holds``."""
    rows: list[list[records.Cell]] = [list(line.rsplit(": ", 1)) for line in text.splitlines() if ": " in line]
    return [Table(["claim", "result"], rows)]


def as_run(monkeypatch: pytest.MonkeyPatch, code: str) -> None:
    """The run ``proofs`` is this Python code."""
    monkeypatch.setitem(
        RUNS, "proofs", runs.Run("Proofs", "About.", "make prove", claims, (sys.executable, "-c", code))
    )


def test_a_run_is_kept(folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Its summary with the circumstances; then the page can be made without it."""
    as_run(monkeypatch, "print('APLock: holds')")
    assert main() == 1
    assert "not up to date" in capsys.readouterr().out
    assert main("proofs") == 0
    kept = msgspec.json.decode((folder / command.KEPT / "proofs.json").read_bytes(), type=Record)
    assert kept.tables == [Table(["claim", "result"], [["APLock", "holds"]])]
    assert kept.command == "make prove"
    assert kept.load is not None
    assert any(tool.startswith("Java ") for tool in kept.tools)
    text = (folder / command.PAGE).read_text(encoding="utf-8")
    assert text.count("\n- **Proofs** (`make prove`, ") == 1
    (folder / command.PAGE).write_text("", encoding="utf-8")
    assert main("--write") == 0
    assert (folder / command.PAGE).read_text(encoding="utf-8") == text


@pytest.mark.parametrize(("release", "code"), [(__version__, 0), ("0.0.2", 0), ("0.0.1", 1)])
def test_numbers_of_an_older_text(
    release: str, code: int, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """They are named; what is so since before the last release is a failure."""
    as_run(monkeypatch, "print('APLock: holds')")
    assert main("proofs") == 0
    assert "older" not in capsys.readouterr().out
    kept = records.read(folder / command.KEPT)["proofs"]
    records.write(folder / command.KEPT, "proofs", msgspec.structs.replace(kept, texts="0", release=release))
    assert main() == code
    said = capsys.readouterr().out
    assert "proofs: of an older text" in said
    assert ("older than the last release" in said) == bool(code)


@pytest.mark.parametrize(
    ("file", "changes"),
    [
        ("soft_plc/plc.c", True),
        ("soft_plc/deep/plc.h", True),
        ("soft_plc/build/plc.c", False),
        ("soft_plc/README.md", False),
    ],
)
def test_which_files_are_the_text(file: str, changes: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A source counts, whatever its folder; what a build makes of it does not."""
    monkeypatch.setattr(texts, "ROOT", tmp_path)
    texts._part.cache_clear()
    before = texts.origin(["soft PLC"])
    made = tmp_path / "examples" / file
    made.parent.mkdir(parents=True)
    made.write_text("int main;")
    texts._part.cache_clear()
    assert (texts.origin(["soft PLC"]) != before) == changes
    texts._part.cache_clear()


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("code", ["raise SystemExit(3)", "pass", "print('APLock: holds'); raise SystemExit(7)"])
def test_a_run_that_fails_is_not_kept(
    code: str, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Neither a summary nor a page is written."""
    as_run(monkeypatch, code)
    assert main("proofs") == 3
    assert "make prove ended with exit code" in capsys.readouterr().err
    assert not (folder / command.KEPT).exists()
    assert (folder / command.PAGE).read_text(encoding="utf-8") == ""


def model_report(folder: Path, lane: str) -> str:
    """A report of models, as the command writes it."""
    file = folder / "report.json"
    model = {"name": "a", "kind": "model", "lane": "ci", "ok": True, "states": 3, "distinct": 2, "depth": 1}
    report = {"lane": lane, "seconds": 7, "not run again": 0, "models": [model | {"seconds": 6.5}]}
    file.write_text(json.dumps(report), encoding="utf-8")
    return str(file)


def test_a_report_is_taken_over(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing runs; what the report does not say is left out."""
    monkeypatch.setattr(records, "changed_at", lambda: 0.0)
    assert main("models", "--report", model_report(folder, "ci")) == 0
    kept = msgspec.json.decode((folder / command.KEPT / "models.json").read_bytes(), type=Record)
    assert (kept.command, kept.seconds, kept.load, kept.exit) == ("s7spec models --lane ci", 7, None, None)
    assert kept.tables[0].rows[-1] == ["all", 1, 0, 2, 6.5]


@pytest.mark.parametrize(
    ("lane", "changed", "problem"),
    [("smoke", 0.0, "expected a report of s7spec models --lane ci"), ("ci", 1e12, "the checkout has changed since")],
)
def test_a_report_that_is_not_taken_over(
    lane: str,
    changed: float,
    problem: str,
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One of another run, or of an earlier state of the checkout."""
    monkeypatch.setattr(records, "changed_at", lambda: changed)
    assert main("models", "--report", model_report(folder, lane)) == 3
    assert problem in capsys.readouterr().err
    assert not (folder / command.KEPT).exists()


def test_reports_of_some_runs_alone(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Those that tell of which run they are, one at a time."""
    for names in (["logs"], ["models", "models-full"], []):
        assert main(*names, "--report", model_report(folder, "ci")) == 2
        assert "models, models-full" in capsys.readouterr().err


def test_when_the_checkout_changed() -> None:
    """Not in the future."""
    assert 0 < records.changed_at() < time.time() + 1


def test_another_tlc_is_for_runs_of_tlc(capsys: pytest.CaptureFixture[str]) -> None:
    """The trace checker has no ``--tlc``."""
    assert main("logs", "--tlc", "x.jar") == 2
    assert "only for runs of TLC" in capsys.readouterr().err


@pytest.mark.parametrize("content", ["{", "{}", '{"command": 1}'])
def test_a_kept_summary_that_cannot_be_read(content: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The message names the file."""
    (folder / command.KEPT).mkdir()
    (folder / command.KEPT / "logs.json").write_text(content, encoding="utf-8")
    assert main() == 2
    assert "logs.json: " in capsys.readouterr().err


def test_page() -> None:
    """Numbers with thousands separated, to the right; what is not known is left out; a second TLC has its own part."""
    kept = Record(
        command="s7spec logs agree --logs 10000", date="2026-11-21", revision="abc", tools=["TLC 2.18"],
        release="1", texts="", machine="2 cores", load=None, seconds=None, exit=0,
        tables=[Table(["log", "lines"], [["a", 1234], ["b", None]], "T")],
        remarks=["A remark."],
    )  # fmt: skip
    text = page({"agreement": kept, "agreement-second-tlc": kept}, ["agreement"])
    part = text.partition("\n## Agreement\n")[2].partition("\n## ")[0]
    assert "**T**\n\n| log | lines |\n|---|---:|\n| a | 1,234 |\n| b |  |\n\nA remark.\n" in part
    assert "`s7spec logs agree --logs 10000`, 2026-11-21, revision abc, TLC 2.18, 2 cores, exit code 0.\n" in part
    assert "### Agreement on a second TLC\n" in part
    assert part.count("**Of an older text:**") == 1
    assert "`s7spec models --lane ci` has not been run." in text


def test_each_total_is_a_column() -> None:
    """The short page leaves out what is no column: a fault of a run may be among it."""
    kept = records.read(ROOT / command.KEPT)
    lacking = {
        name: missing
        for name, run in RUNS.items()
        if name in kept and kept[name].command == run.typed
        if (missing := set(run.totals) - set(kept[name].tables[0].columns))
    }
    assert lacking == {}


def test_totals() -> None:
    """Columns that a run names: added up, or those of the row that does it."""
    kept = Record(
        command="s7spec models --lane ci", date="2026-11-21", revision="abc", tools=[], machine="", load=None,
        release="1", texts="", seconds=None, exit=0,
        tables=[Table(["kind", "models", "seconds"], [["model", 1200, 1.5], ["control", 2, 1]])],
    )  # fmt: skip
    line = "- **Models** (`s7spec models --lane ci`, 2026-11-21, revision abc): models: 1,202\n"
    assert totals({"models": kept}).endswith(f"\n\n{line}")
    (table,) = kept.tables
    table.rows.append(["all", 3, 1])
    assert "models: 3\n" in totals({"models": kept})


def test_summary_of_models() -> None:
    """Sums by kind, and each model but the negative controls."""
    common = {"lane": "ci", "ok": True, "states": 20, "distinct": 10, "depth": 3, "seconds": 1.25}
    found = [{"name": "a", "kind": "model", **common}, {"name": "neg-a", "kind": "negative", **common}]
    by_kind, each = summaries.models(json.dumps({"not run again": 1, "models": found}))
    assert by_kind.title == "1 of them came as pinned in earlier runs, and nothing changed since"
    assert by_kind.rows == [["model", 1, 0, 10, 1.2], ["negative", 1, 0, 10, 1.2], ["all", 2, 0, 20, 2.4]]
    assert each.rows == [["a", "ci", 20, 10, 3, 1.25]]


def test_summary_of_witnesses() -> None:
    """A condition that nothing meets is named, unless it has a reason."""
    conditions = [
        {"id": "Airt/A", "missing": missing, "reason": reason, "text": "delay > 0"}
        for missing, reason in (([], None), (["TRUE", "FALSE"], "a bound"), (["TRUE", "FALSE"], None))
    ]
    report = {"kinds": {}, "all": {"conditions": 3, "without": 1}, "conditions": conditions}
    kinds, without = summaries.witnesses(json.dumps(report))
    assert kinds.rows == [["all", 3, 1]]
    assert without.rows == [["Airt/A", "TRUE or FALSE", "delay > 0"]]


def test_summary_of_logs() -> None:
    """By area and verdict; verdicts that no log has are left out."""
    report = [
        {"log": "traces/TINT/accept/a.ndjson", "verdict": "accepted", "events": 2},
        {"log": "traces/TINT/reject/b.ndjson", "verdict": "rejected", "events": 1},
        {"log": "traces/AMB/accept/c.ndjson", "verdict": "accepted", "events": 4},
    ]
    (table,) = summaries.logs("\n".join(map(json.dumps, report)))
    assert table.columns == ["area", "logs", "accepted", "rejected", "events explained"]
    assert table.rows == [["AMB", 1, 1, 0, 4], ["TINT", 2, 1, 1, 3], ["all", 3, 2, 1, 7]]


@pytest.mark.parametrize("run", [run for run in RUNS.values() if "-m" in run.process], ids=lambda run: run.typed)
def test_commands_have_these_options(run: runs.Run) -> None:
    """The command of a run takes its options; none is started."""
    ended = subprocess.run([*run.process, "--help"], cwd=ROOT, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    for option in (argument for argument in run.process if argument.startswith("--")):
        assert option in ended.stdout

"""Mutants before checks that are made up: which are run, what is kept, what is said."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from evidence.common.reasons import ReasonsError, read
from evidence.mutants.bench import Bench, UnsoundBaselineError, Verdict
from evidence.mutants.findings import Finding, Findings, How
from evidence.mutants.listing import mutants
from evidence.mutants.mutants_report import as_json, numbers
from evidence.mutants.survivors import Reason, explain
from evidence.tla.modules import read_modules
from evidence.tla.syntax import Module

TEXT = """---- MODULE M ----
EXTENDS Integers
A(x) == x + 1
B(x) == x < 5
====
"""


@dataclass
class FakeCheck:
    """Kills a mutant whose text has one of the keys of `kills` in it."""

    name: str
    kills: dict[str, How]
    seconds: float = 1.0
    told: frozenset[int] | None = None
    ran: list[str] = field(default_factory=list)

    modules = frozenset({"M"})
    parameters = frozenset[str]()

    def key(self, changed: Module | None) -> str:
        """Depend on the changed code."""
        return f"{self.name} {changed.code if changed else ''}"

    def marks(self, spec: Path) -> frozenset[int] | None:
        """Look at the marks and tell those that are made up."""
        assert "EXTENDS EvaluationMarks, Integers" in (spec / "M.tla").read_text()
        assert (spec / "EvaluationMarks.tla").is_file()
        return self.told

    def run(self, spec: Path, timeout: float) -> Finding:
        """Find one of the keys in the text."""
        text = (spec / "M.tla").read_text()
        self.ran.append(text)
        return Finding(next((how for part, how in self.kills.items() if part in text), "survived"), "", self.seconds)


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    """Make a specification of one module."""
    (tmp_path / "spec").mkdir()
    (tmp_path / "spec" / "M.tla").write_text(TEXT)
    return tmp_path / "spec"


def judged(spec: Path, *checks: FakeCheck, thorough: bool = False, stated: bool = False) -> dict[str, Verdict]:
    """Judge all its mutants; return the verdicts by change."""
    modules = read_modules(spec)
    found = mutants(modules, ["M"])
    bench = Bench(spec, modules, Findings(spec.parent / "findings.ndjson"), thorough, stated)
    bench.calibrate(checks, found, lambda _: None)
    return {f"{v.mutant.was} -> {v.mutant.by}": v for v in bench.judge_all(found, 2, lambda _: None)}


def test_the_first_kill_ends_the_checks_of_a_mutant(spec: Path) -> None:
    """The cheaper check comes first, and nothing after a kill."""
    cheap = FakeCheck("cheap", {"x - 1": "property"})
    dear = FakeCheck("dear", {"x - 1": "property", "x >= ": "error"}, seconds=9)
    verdicts = judged(spec, dear, cheap)
    assert (verdicts["x + 1 -> x - 1"].how, verdicts["x + 1 -> x - 1"].by) == ("property", "cheap")
    assert (verdicts["x < 5 -> x >= 5"].how, verdicts["x < 5 -> x >= 5"].by) == ("error", "dear")
    assert verdicts["x < 5 -> x >= 5"].evaluating == ("cheap",)
    assert verdicts["x < 5 -> x <= 5"].how == "survived"
    assert set(verdicts["x < 5 -> x <= 5"].evaluating) == {"cheap", "dear"}
    assert not any("x - 1" in text for text in dear.ran)


def test_findings_are_kept(spec: Path) -> None:
    """A second run has nothing to do."""
    first = judged(spec, FakeCheck("c", {"x - 1": "property"}))
    again = FakeCheck("c", {})
    assert judged(spec, again) == first
    assert again.ran == []


def test_a_line_that_was_cut_off_is_found_out_again(spec: Path) -> None:
    """An interrupted run costs one finding."""
    first = judged(spec, FakeCheck("c", {"x - 1": "property"}))
    kept = spec.parent / "findings.ndjson"
    kept.write_bytes(kept.read_bytes()[:-9])
    again = FakeCheck("c", {"x - 1": "property"})
    assert judged(spec, again) == first
    assert len(again.ran) == 1


def test_a_fresh_run_asks_again(spec: Path) -> None:
    """It uses no finding of an earlier run, and those after it use its own."""
    found = Findings(spec.parent / "findings.ndjson")
    found.keep("k", "c", "M/A", Finding("property", "", 1.0))
    fresh = Findings(spec.parent / "findings.ndjson", fresh=True)
    assert fresh.known("k") is None
    fresh.keep("k", "c", "M/A", Finding("survived", "", 1.0))
    known = Findings(spec.parent / "findings.ndjson").known("k")
    assert known is not None
    assert known.how == "survived"


def test_what_is_not_evaluated_is_not_run(spec: Path) -> None:
    """A check is run only on what it evaluates."""
    check = FakeCheck("c", {}, told=frozenset({1}))
    verdicts = judged(spec, check)
    evaluated = [change for change, verdict in verdicts.items() if verdict.evaluating]
    assert evaluated == ["x + 1 -> x - 1"]
    assert len(check.ran) == 2  # and the unchanged specification


def test_a_weak_kill_is_enough_unless_thorough(spec: Path) -> None:
    """A thorough run looks for a kill by a property."""
    weak = FakeCheck("weak", {"x - 1": "count", "x + 2": "count"})
    strong = FakeCheck("strong", {"x - 1": "property"}, seconds=9)
    assert judged(spec, weak, strong)["x + 1 -> x - 1"].how == "count"
    thorough = judged(spec, weak, strong, thorough=True)
    assert (thorough["x + 1 -> x - 1"].how, thorough["x + 1 -> x - 1"].by) == ("property", "strong")
    assert (thorough["1 -> 2"].how, thorough["1 -> 2"].by) == ("count", "weak")


def test_only_what_is_stated_kills(spec: Path) -> None:
    """Where only properties count, a mutant gets past counts, timeouts and errors."""
    first = FakeCheck("first", {"x - 1": "count", "x + 2": "error", "x >= ": "timeout"})
    second = FakeCheck("second", {"x - 1": "property"}, seconds=9)
    verdicts = judged(spec, first, second, stated=True)
    assert (verdicts["x + 1 -> x - 1"].how, verdicts["x + 1 -> x - 1"].by) == ("property", "second")
    for change in ("1 -> 2", "x < 5 -> x >= 5"):
        assert (verdicts[change].how, set(verdicts[change].evaluating)) == ("survived", {"first", "second"})
    assert verdicts["1 -> 2"].detail == "error first"
    assert verdicts["x < 5 -> x >= 5"].detail == "timeout first"


def test_marks_that_a_temporal_formula_does_not_bear_are_left_out(spec: Path) -> None:
    """Where TLC refuses marks, those of temporal formulas and their constants go, and their mutants count as run."""

    class Temporal(FakeCheck):
        def marks(self, spec: Path) -> frozenset[int] | None:
            return None if "EvaluationMarks" in (spec / "Calendar.tla").read_text() else frozenset({1})

    (spec / "Calendar.tla").write_text(TEXT.replace("MODULE M", "MODULE Calendar"))
    check = Temporal("c", {})
    check.modules = frozenset({"M", "Calendar"})
    modules = read_modules(spec)
    bench = Bench(spec, modules, Findings(spec.parent / "findings.ndjson"))
    found = mutants(modules, ["Calendar", "M"])
    bench.calibrate([check], found, lambda _: None)
    past = {v.mutant.id for v in bench.judge_all(found, 1, lambda _: None) if v.evaluating}
    assert {m.id for m in found if m.module == "Calendar"} < past
    assert {m.module for m in found if m.id not in past} == {"M"}


@dataclass
class SlowCheck(FakeCheck):
    """Times out on mutants below `needs` seconds; the unchanged specification takes `later` after the first run."""

    needs: float = 50.0
    later: float = 10.0

    def run(self, spec: Path, timeout: float) -> Finding:
        """Time out or survive."""
        changed = "x + 1" not in (spec / "M.tla").read_text()
        seconds = self.later if self.ran else self.seconds
        self.ran.append("mutant" if changed else "unchanged")
        return Finding("timeout" if changed and timeout < self.needs else "survived", "", seconds)


@pytest.mark.parametrize(("later", "how"), [(10.0, "survived"), (1.0, "timeout")])
def test_a_slow_machine_kills_nothing(spec: Path, later: float, how: str) -> None:
    """After a timeout the unchanged specification is timed anew."""
    check = SlowCheck("c", {}, later=later)
    assert judged(spec, check)["x + 1 -> x - 1"].how == how
    assert "mutant unchanged" in " ".join(check.ran)


def test_a_check_that_always_fails_shows_nothing(spec: Path) -> None:
    """Without a passing baseline there are no verdicts."""
    with pytest.raises(UnsoundBaselineError, match="does not pass c: deadlock"):
        judged(spec, FakeCheck("c", {"MODULE": "deadlock"}))
    assert judged(spec, FakeCheck("c", {})), "a failure is not kept: its reason may be gone"


def test_survivors_and_reasons(spec: Path) -> None:
    """Survivors need a reason; equivalent ones do not count."""
    verdicts = judged(spec, FakeCheck("c", {"x - 1": "property", "x + 2": "count", "x + 0": "invalid"}))
    bare = explain(list(verdicts.values()), [], [v.mutant.id for v in verdicts.values()])
    assert [v.mutant.definition for v in bare.unexplained] == ["B"] * 4
    assert not as_json(bare, 1.0)["ok"]

    equal = verdicts["x < 5 -> x <= 5"].mutant.id
    reasons = [Reason(equal, "x is never 5", equivalent=True), Reason("M/B/*", "nobody asks")]
    full = explain(list(verdicts.values()), reasons, [v.mutant.id for v in verdicts.values()])
    assert (full.unexplained, full.stale) == ([], [])
    counts = numbers(full)
    assert (counts["mutants"], counts["invalid"], counts["equivalent"], counts["counted"]) == (7, 1, 1, 5)
    assert (counts["killed"], counts["property"], counts["count"], counts["survived"]) == (2, 1, 1, 3)
    assert counts["score"] == 0.4
    document = as_json(full, 1.0)
    assert document["ok"]
    assert {m["id"]: m["reason"] for m in document["mutants"] if m["how"] == "survived"}[equal] == "x is never 5"
    json.dumps(document)


def test_stale_reasons(spec: Path) -> None:
    """A reason is stale when its mutant is gone or killed, not when it was not run."""
    verdicts = list(judged(spec, FakeCheck("c", {"x - 1": "property"})).values())
    ids = [v.mutant.id for v in verdicts]
    killed = next(v.mutant.id for v in verdicts if v.how == "property")
    gone = Reason("M/C/*", "was there once")
    assert explain(verdicts, [gone, Reason(killed, "why")], ids).stale == [
        "M/C/*: there is no such mutant",
        f"{killed}: does not survive",
    ]
    assert explain([], [Reason(killed, "not in this sample")], ids).stale == []


def test_a_count_makes_no_equivalence_stale(spec: Path) -> None:
    """TLC may count the steps of an equivalent mutant otherwise; any other reason is stale then."""
    verdicts = list(judged(spec, FakeCheck("c", {"x + 2": "count"})).values())
    ids = [v.mutant.id for v in verdicts]
    counted = next(v.mutant.id for v in verdicts if v.how == "count")
    assert explain(verdicts, [Reason(counted, "the same steps", equivalent=True)], ids).stale == []
    assert explain(verdicts, [Reason(counted, "nobody asks")], ids).stale == [f"{counted}: does not survive"]


def test_reasons_file(tmp_path: Path) -> None:
    """No file holds no reasons; an empty reason is none."""
    path = tmp_path / "survivors.json"
    assert read(path, Reason) == []
    path.write_text('[{"id": "M/A/*", "reason": "as it is"}]')
    assert read(path, Reason) == [Reason("M/A/*", "as it is")]
    path.write_text('[{"id": "M/A/*", "reason": ""}]')
    with pytest.raises(ReasonsError, match=r"survivors\.json.*reason"):
        read(path, Reason)

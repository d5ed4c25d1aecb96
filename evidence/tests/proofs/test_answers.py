"""Answers are asked until there is one, and kept as long as their text stays; the command's exit codes."""

from __future__ import annotations

import dataclasses
import json
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import pytest

from evidence.cli import main
from evidence.common.checkout import ROOT
from evidence.common.processes import Processes
from evidence.models.proofs import prove_command as command
from evidence.models.proofs import runner
from evidence.models.proofs.apalache import HOME_VARIABLE, Answer, Apalache, answer, interpret
from evidence.models.proofs.kept import KeptAnswers, Pending, Result, Run, keys, still, together
from evidence.models.proofs.making import Query
from evidence.models.proofs.queries import Proofs
from evidence.models.proofs.report import as_json, assumptions, standing
from evidence.models.proofs.runner import Asking, ask, ok
from evidence.tests.proofs.recorded import recorded

Program = Callable[..., Apalache]


@pytest.fixture
def program(tmp_path: Path) -> Iterator[Program]:
    """A program in the place of Apalache, which begins a run with a statement, and says this: each the next one."""

    def made(output: str | list[str], code: int, begin: str = "pass") -> Apalache:
        (tmp_path / "output").write_text(json.dumps([output] if isinstance(output, str) else output))
        (tmp_path / "program.py").write_text(
            f"import json, sys\noutputs = json.load(open({str(tmp_path / 'output')!r}))\n"
            f"for line in sys.stdin:\n    {begin}\n"
            f"    print(outputs.pop(0) if outputs[1:] else outputs[0])\n    print('@!@!@EXIT {code}', flush=True)\n"
        )
        return stack.enter_context(Apalache([sys.executable, str(tmp_path / "program.py")], Processes()))

    with ExitStack() as stack:
        yield made


def claim(proofs: Proofs) -> Query:
    """A query of one formula, ``Steps``."""
    (query,) = proofs.select(("lock-steps",))
    return query


def test_an_answer_is_kept_for_the_same_text(tmp_path: Path, proofs: Proofs, program: Program) -> None:
    """It is asked again where the text differs, where it was not as claimed, and where nothing kept is to be taken."""
    query = claim(proofs)
    asking = Asking(ROOT, tmp_path / "build", KeptAnswers(tmp_path / "kept"), program(recorded("holds"), 0))
    assert ask(asking, query, "all").answer.outcome == "not asked"
    first = ask(asking, query, "claimed")
    assert ok(query, first)
    assert (first.kept, first.version) == (False, "0.62.1")
    assert ask(asking, query, "claimed").kept
    assert ask(asking, query, "all").kept
    assert not ask(asking, query).kept
    assert ask(asking, dataclasses.replace(query, length=2), "all").answer.outcome == "not asked"
    assert not ask(asking, dataclasses.replace(query, length=2), "claimed").kept
    violated = dataclasses.replace(asking, apalache=program(recorded("violated"), 12))
    assert not ok(query, ask(violated, query))
    assert not ask(violated, query, "claimed").kept
    assert ask(violated, query, "all").answer.outcome == "violated"


def test_the_key_of_a_formula_is_its_text() -> None:
    """A change counts for the formulas that need what changed, and a comment for none."""
    text = (
        "---- MODULE M ----\nEXTENDS Integers\nVARIABLE\n  \\* @type: Int;\n  x\n\nInit == x = 0\n\n"
        "Step == x + 1\n\n\\* @type: Bool;\nP == Step > 0\n\nQ == x > 0\n====\n"
    )
    before = keys(text, ["P", "Q"], ["Init"], ["length 1"])
    assert before["P"] != before["Q"]
    changes = {
        "x + 1": ("x + 2", "P"),
        "x > 0": ("x > 1", "Q"),
        "x = 0": ("x = 1", "PQ"),
        "EXTENDS Integers": ("EXTENDS Naturals", "PQ"),
        "type: Bool": ("type: Int", "P"),
        "Q ==": ("(* why *)\nQ ==", ""),
    }
    for old, (new, changed) in changes.items():
        after = keys(text.replace(old, new, 1), ["P", "Q"], ["Init"], ["length 1"])
        assert {name for name in "PQ" if before[name] != after[name]} == set(changed), new
    assert keys(text, ["P"], ["Init"], ["length 2"])["P"] != before["P"]


def test_a_type_that_nothing_uses_does_not_count() -> None:
    """Of the type aliases a query needs some; another one may change."""
    text = (
        "---- MODULE M ----\nEXTENDS Integers\n(*  @typeAlias: inner = { a: Int };    *)\n"
        "(*  @typeAlias: used = { b: $inner,   *)\n(*                   c: Int };    *)\n"
        "(*  @typeAlias: other = { d: Int };    *)\nVARIABLE\n  \\* @type: $used;\n  x\n\nP == x.c = 0\n====\n"
    )
    (before,) = keys(text, ["P"], [], []).values()
    for old, new, changed in (("d: Int", "d: Str", False), ("c: Int }", "c: Str }", True), ("a: Int", "a: Str", True)):
        assert (keys(text.replace(old, new), ["P"], [], []) != {"P": before}) == changed


def test_answers_of_formulas_that_stay(tmp_path: Path) -> None:
    """Of a run whose formulas hold those stay that did not change; a refuted run stays whole or not at all."""
    answers = KeptAnswers(tmp_path / "kept.ndjson")
    held = Run("q", Answer("holds", 6, taken=2), 8.0, 100, "0.62.1", "2026-11-29", ("1", "2"))
    refuted = Run("q", Answer("violated", 1, "R"), 2.0, 300, "0.62.1", "2026-11-29", ("3", "4"))
    assert answers.of("q") == []
    answers.put("q", [held, refuted])
    other = msgspec.structs.replace(held, query="another")
    answers.put("another", [other])
    assert answers.of("another") == [other]
    assert still(answers.of("q"), ["1", "2", "3", "4"]) == [held, refuted]
    (left,) = still(answers.of("q"), ["1", "new", "3", "newer"])
    assert left.keys == ("1",)
    some = together("q", {"P": "1", "Q": "new"}, [left], kept=True)
    assert (some.answer.outcome, some.answer.detail) == ("not asked", "not asked: Q")
    more = Run("q", Answer("holds", 3, taken=2), 5.0, 200, "0.62.1", "2026-11-29", ("new",))
    whole = together("q", {"P": "1", "Q": "new"}, [left, more], kept=False)
    assert (whole.answer, whole.seconds, whole.megabytes) == (Answer("holds", 9, taken=2), 13.0, 200)
    assert together("q", {"P": "1", "R": "3"}, [left, refuted], kept=True).answer.outcome == "violated"


def test_a_path_of_this_machine_is_not_kept(tmp_path: Path) -> None:
    """A counterexample is named when it is found, and is in the folder for output alone."""
    answers = KeptAnswers(tmp_path / "kept.ndjson")
    trace = Answer("violated", 1, "R", trace=str(tmp_path / "violation.tla"))
    answers.put("q", [Run("q", trace, 2.0, 300, "0.62.1", "2026-11-29", ("3",))])
    (kept,) = answers.of("q")
    assert not kept.answer.trace


def test_the_answers_of_the_tree(proofs: Proofs) -> None:
    """Each is of a query that is asked, and as claimed: what is not has no place there."""
    claimed = {query.name: query.expect for query in proofs.queries}
    runs = msgspec.json.Decoder(Run).decode_lines((ROOT / command.KEPT).read_bytes())
    assert runs
    others = [run for run in runs if run.answer.outcome != claimed.get(run.query)]
    assert [(run.query, run.answer.outcome) for run in others if not run.pending] == []


def test_only_what_is_new_is_asked(tmp_path: Path, proofs: Proofs, program: Program) -> None:
    """A query with a formula more asks for this one."""
    query = claim(proofs)
    asking = Asking(ROOT, tmp_path / "build", KeptAnswers(tmp_path / "kept"), program(recorded("holds"), 0))
    assert ok(query, ask(asking, query))
    more = dataclasses.replace(query, formulas=(*query.formulas, "Invariant"))
    output = recorded("holds").replace("the invariant Steps", "the invariant Invariant")
    asked_for_both = program(output, 0)
    result = ask(dataclasses.replace(asking, apalache=asked_for_both), more, "claimed")
    assert (result.answer.outcome, result.answer.checked) == ("holds", 72)
    assert "Steps ==" not in (asking.build / query.name / f"{query.module}.tla").read_text()


def test_a_late_condition_has_a_run_of_its_own(tmp_path: Path, proofs: Proofs, program: Program) -> None:
    """What came of the others is kept, whatever comes of it; its formula holds if it does."""
    steps = claim(proofs)
    query = dataclasses.replace(steps, formulas=(*steps.formulas, "Invariant"))
    text = recorded("holds")
    others = text.replace("produced 5 ", "produced 3 ")
    own = text.replace("invariant Steps", "invariant Invariant").replace("produced 5 ", "produced 2 ")
    first = others + own.replace("invariant 3 holds.", "invariant 3 => TIMEOUT.")
    alone = "State 0: Checking 1 action invariants\nState 0: action invariant 1 holds.\n"
    for second, outcome in ((alone, "holds"), (text, "nothing checked")):
        asking = Asking(ROOT, tmp_path / "build", KeptAnswers(tmp_path / outcome), program([first, second], 0))
        result = ask(asking, query)
        kept = asking.answers.of(query.name)
        assert [(run.answer.outcome, len(run.keys)) for run in kept] == [("holds", 1), (outcome, 1)]
        assert result.answer.outcome == outcome


def test_a_condition_is_asked_until_there_is_an_answer(
    tmp_path: Path, proofs: Proofs, program: Program, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By other seeds; what is known is kept, so that the next time this condition alone is asked."""
    monkeypatch.setattr(runner, "TRIES", 2)
    first = recorded("holds").replace("invariant 4 holds.", "invariant 4 => TIMEOUT.")
    alone = "State 0: Checking 1 action invariants\nState 0: action invariant 4 holds.\n"
    late = alone.replace("holds.", "=> TIMEOUT.")
    query, answers = claim(proofs), KeptAnswers(tmp_path / "kept")
    asking = Asking(ROOT, tmp_path / "build", answers, program([first, late], 0))
    result = ask(asking, query, "claimed")
    assert result.answer.detail == "Z3 has no answer yet about action invariant 4"
    assert ask(asking, query, "all").answer.outcome == "not asked"
    assert [run.pending for run in answers.of(query.name)] == [(Pending("action invariant 4", ""),)]
    lines = tmp_path / "lines"
    again = program([late, alone], 0, f"open({str(lines)!r}, 'a').write(line)")
    result = ask(dataclasses.replace(asking, apalache=again), query, "claimed")
    first_try, second_try = lines.read_text().splitlines()
    assert "search.invariantFilter=.*->action4" in first_try
    assert second_try == first_try.replace("action4", "action4:z3.smt.random_seed=1")
    assert (result.answer.outcome, result.answer.checked) == ("holds", first.count(" holds.") + 1)
    assert ask(asking, query, "all").answer == result.answer


def test_too_long(tmp_path: Path, proofs: Proofs, program: Program) -> None:
    """A query that does not end in its time is ended."""
    sleeping = program("", 0, "__import__('time').sleep(60)")
    asking = Asking(ROOT, tmp_path / "build", KeptAnswers(tmp_path / "kept"), sleeping)
    result = ask(asking, dataclasses.replace(claim(proofs), timeout=1))
    assert (result.answer.outcome, result.answer.detail) == ("timeout", "ended after 1 s")


def instead(monkeypatch: pytest.MonkeyPatch, folder: Path, apalache: Apalache) -> None:
    """The command takes this program for Apalache, and keeps its answers in a folder."""
    monkeypatch.setattr(command, "find_apalache", list)
    monkeypatch.setattr(command, "Apalache", lambda *_: apalache)
    monkeypatch.setattr(command, "BUILD", folder / "build")
    monkeypatch.setattr(command, "KEPT", folder / "kept.ndjson")


def test_a_process_stays(tmp_path: Path, program: Program) -> None:
    """The next run is one of the same process, unless that ended; how it ended is the run's exit code."""
    count = tmp_path / "count"
    apalache = program(recorded("holds"), 0, f"open({str(count)!r}, 'a').write(f'{{__import__(\"os\").getpid()}} ')")
    for _ in range(2):
        assert apalache.run([[]], tmp_path, 60).code == 0
    first, second = count.read_text().split()
    assert first == second
    dead = Apalache([sys.executable, "-c", "print('no memory'); raise SystemExit(3)"], Processes())
    for _ in range(2):
        assert (
            answer(dead.run([[]], tmp_path, 60), partial(interpret, asked=["Steps"])).detail == "exit code 3: no memory"
        )


@pytest.mark.parametrize(("name", "exit_code", "code"), [("holds", 0, 0), ("violated", 12, 1), ("nothing", 0, 1)])
def test_exit_codes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, program: Program, name: str, exit_code: int, code: int
) -> None:
    """0 as claimed, 1 where an answer differs."""
    instead(monkeypatch, tmp_path, program(recorded(name), exit_code))
    report = tmp_path / "report.json"
    with pytest.raises(SystemExit) as ended:
        main(["prove", "lock-steps", "--json", str(report)])
    assert ended.value.code == code
    (query,) = json.loads(report.read_bytes())["queries"]
    assert query["ok"] == (code == 0)


def test_two_queries_at_a_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, program: Program) -> None:
    """Each waits until the other has begun; the answers come in the order of the queries."""
    begun = tmp_path / "begun"
    begun.mkdir()
    waits = (
        "import os, pathlib, time\n"
        f"    begun = pathlib.Path({str(begun)!r})\n"
        "    (begun / str(os.getpid())).touch()\n"
        "    while len(list(begun.iterdir())) < 2: time.sleep(0.01)"
    )
    instead(monkeypatch, tmp_path, program(recorded("holds"), 0, waits))
    report = tmp_path / "report.json"
    with pytest.raises(SystemExit) as ended:
        main(["prove", "--jobs", "2", "l*-steps", "--json", str(report)])
    assert ended.value.code == 0
    assert [query["name"] for query in json.loads(report.read_bytes())["queries"]] == ["lock-steps", "life-steps"]


def test_apalache_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Exit code 3; nothing is called proved."""
    monkeypatch.setenv(HOME_VARIABLE, str(tmp_path))
    with pytest.raises(SystemExit) as ended:
        main(["prove", "lock-steps"])
    assert ended.value.code == 3
    assert "not run: apalache-mc was not found" in capsys.readouterr().err


@pytest.mark.parametrize("shard", ["0/2", "3/2", "1", "a/b"])
def test_a_wrong_shard(shard: str) -> None:
    """Wrong arguments."""
    assert main(["prove", "--shard", shard, "--list"]) == 2


def test_shards_are_all_queries(proofs: Proofs, capsys: pytest.CaptureFixture[str]) -> None:
    """Each query is in one shard."""
    for part in ("1/3", "2/3", "3/3"):
        main(["prove", "--list", "--shard", part])
    listed = [line.partition(":")[0] for line in capsys.readouterr().out.splitlines()]
    assert sorted(listed) == sorted(q.name for q in proofs.queries)


def test_the_report_says_what_is_assumed(proofs: Proofs) -> None:
    """The bounds, the world, the lemma, the readings."""
    said = assumptions(proofs)
    for word in ("Ind", "models/APSystem.tla", "at most 4 start events", "9 OBs that run", "lemma", "by default"):
        assert word in said
    assert as_json(proofs, [])["assumptions"] == said


def test_a_property_stands_as_its_queries_do(proofs: Proofs) -> None:
    """Proved of the actions whose queries hold; one of states only with the beginning and what follows."""

    def rows(*names: str) -> dict[str, dict[str, Any]]:
        answers = [
            (q, Result(q.name, Answer("holds" if q.name in names else "timeout", 1), 1, 1, "")) for q in proofs.queries
        ]
        return {row["formula"]: row for row in standing(proofs, answers)}

    some = rows("StartsOb")
    assert some["EndProp"]["proved"] == 1
    assert len(some["EndProp"]["unknown"]) == len(proofs.actions) - 1
    assert some["StackInv"]["proved"] == 0
    assert rows("StartsOb", "first", "invariants")["StackInv"]["proved"] == 1
    every = rows(*(q.name for q in proofs.queries))
    for cell in filter(lambda cell: not cell.letter, proofs.file.not_proved):
        assert cell.action.replace("invariants", "any state") in every[cell.formula]["not claimed"]
    assert [row for row in every.values() if row["unknown"]] == []

"""The kit: generated alike for the same seed, and measured."""

import json
import re
import shutil
import subprocess
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from evidence.common import reasons
from evidence.common.cases import Case
from evidence.common.checkout import ROOT
from evidence.kit import kept_paths, measured, meetings, paths, programs
from evidence.kit.files import PATHS, REACHED, as_line, write_lines
from evidence.kit.paths import Graph, cover
from evidence.kit.reached import Reached, reach
from evidence.kit.reached_command import REASONS
from evidence.kit.reached_findings import findings
from evidence.mutants import against_kit as kit_mutants
from evidence.mutants.bench import Verdict
from evidence.mutants.checks import Check
from evidence.mutants.listing import Mutant, mutants
from evidence.tests.test_mutants_bench import FakeCheck
from evidence.tla.syntax import Module
from s7check.engine.client import Engine
from s7check.judging.decisions import decisions_of
from s7check.kit.program import read_program
from s7check.resources import KIT


def node(number: int, event: str, mode: str) -> str:
    """A state as TLC draws it; the first one is filled."""
    rest = r"/\\ delay = 0\n/\\ stack = <<>>\n/\\ loaded = {1}\n/\\ requests = {}"
    label = rf"/\\ step = [event |-> \"{event}\"]\n/\\ mode = \"{mode}\"\n{rest}"
    return f'{number} [label="{label}"' + (",style = filled]" if number == 1 else "];")


DOT = [
    "strict digraph DiskGraph {",
    node(1, "on", "STOP"),
    '1 -> 2 [label="",color="black",fontcolor="black"];',
    node(2, "a", "RUN"),
    '2 -> 3 [label="",color="black",fontcolor="black"];',
    node(3, "b", "RUN"),
    '3 -> 2 [label="",color="black",fontcolor="black"];',
    '2 -> 4 [label="",color="black",fontcolor="black"];',
    node(4, "stop", "STOP"),
    "}",
]


def test_the_same_seed_gives_the_same_programs() -> None:
    """And another one others."""
    one, again, other = (list(map(as_line, meetings.programs(seed))) for seed in (1, 1, 2))
    assert one == again
    assert one != other


@pytest.fixture(scope="module")
def every() -> dict[str, dict[str, Any]]:
    """The programs by their names, with what they reach."""
    lines = [json.loads(line) for lines in programs.by_area().values() for line in lines]
    assert len(lines) == len({one["name"] for one in lines})
    return {one["name"]: one for one in lines}


def test_the_smallest_programs_of_an_area_come_first() -> None:
    """What they reach does not count."""
    for lines in programs.by_area().values():
        bare = [{name: value for name, value in json.loads(line).items() if name != "reaches"} for line in lines]
        sizes = [len(as_line(one)) for one in bare]
        assert sizes == sorted(sizes)


def test_every_program_says_what_it_is_about(every: dict[str, dict[str, Any]]) -> None:
    """By requirements; what it reaches is measured, and not by a generator."""
    assert all(one["requirements"] for one in every.values())
    assert not any("reaches" in one for one in programs.programs())


def test_names_and_texts_are_about_the_cpu(every: dict[str, dict[str, Any]]) -> None:
    """Not about what the log of a case left out, its entries of the diagnostic buffer, or how it is written."""
    words = re.compile(r"records|\bdiag\b|blank|spellings|carriage|`up`", re.IGNORECASE)
    assert [one["name"] for one in every.values() if words.search(f"{one['name']} {one['about']}")] == []


def test_files_are_written(tmp_path: Path) -> None:
    """And nothing else stays in the folder; this is what the checkout's s7check reads."""
    (tmp_path / "OLD.ndjson").write_text("{}")
    count = programs.write(tmp_path)
    assert not (tmp_path / "OLD.ndjson").exists()
    assert count == sum(len(file.read_bytes().splitlines()) for file in tmp_path.glob("*.ndjson"))
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == {
        file.name: file.read_bytes() for file in KIT.iterdir()
    }


def test_setup_py_makes_the_programs() -> None:
    """Where pip builds the wheel there is msgspec, and none of the other packages that the tools use."""
    hidden = ("click", "rich", "tree_sitter", "tree_sitter_tlaplus")
    script = f"import sys; sys.modules.update(dict.fromkeys({hidden})); import evidence.kit.programs"
    subprocess.run([sys.executable, "-c", script], cwd=ROOT, check=True)


@pytest.fixture
def copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The specification and the models, to change them, and data of the kit that are as new as these."""
    monkeypatch.setattr(paths, "MODELS", ("airt", "hold"))
    for folder in ("spec", "models"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    (tmp_path / "kit").mkdir()
    origins = [{"model": model.name, "origin": kept_paths.origin(model, tmp_path)} for model in kept_paths.models()]
    write_lines(tmp_path / PATHS, origins)
    write_lines(tmp_path / REACHED, [{"origin": measured.origin(tmp_path)}])
    return tmp_path


def changed(folder: Path, module: str, old: str, new: str) -> None:
    """Another text in a module of the specification."""
    (file,) = (folder / "spec").rglob(f"{module}.tla")
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new, 1), encoding="utf-8")


def test_data_that_are_as_new_as_their_origin(copy: Path) -> None:
    """A comment changes nothing, nor does a property."""
    changed(copy, "Airt", "\n\n", "\n\\* A comment.\n\n")
    assert [*kept_paths.problems(copy), *measured.problems(copy)] == []
    changed(copy, "PropertiesAirt", "AirtInv ==", "AirtInv == TRUE\nOtherInv ==")
    assert [*kept_paths.problems(copy), *measured.problems(copy)] == []


def test_data_that_are_older_than_a_rule(copy: Path) -> None:
    """The messages name the file, its origin and the command."""
    changed(copy, "Airt", "delay + 1", "delay + 2")
    assert kept_paths.problems(copy) == [
        f"kit/paths.ndjson.gz: older than the model {name}: s7spec kit paths --write" for name in sorted(paths.MODELS)
    ]
    assert measured.problems(copy) == [
        "kit/reached.ndjson: older than spec/, the soft PLC or a program of the kit: s7spec kit reached --write"
    ]


def test_paths_take_every_step() -> None:
    """Through each edge of the graph, from the beginning."""
    graph = Graph.of(iter(DOT))
    assert graph.begins == ["1"]
    variables = {state: paths.variables(text) for state, text in graph.states.items()}
    found = list(cover(graph, variables))
    assert all(path[0] == "1" for path in found)
    assert {pair for path in found for pair in pairwise(path)} == {
        ("1", "2"),
        ("2", "3"),
        ("3", "2"),
        ("2", "4"),
    }


@pytest.fixture(scope="module")
def few(every: dict[str, dict[str, Any]], engine: Engine) -> Reached:
    """The measurement of three programs; much was measured of the smallest one before, which counts for nothing."""
    names = ("AIRT-07-nothing-delayed-answers-0000", "AIRT-nesting-002", "DINT-beside-20-21-cancel")
    much = {"reaches": {"requirements": ["AIRT-07"], "guards": [f"Airt/EnAirt/TRUE/{n}" for n in range(99)]}}
    some = {**every, names[0]: every[names[0]] | much}
    return reach([read_program(as_line(some[name]).encode()) for name in names], engine, lambda _: None)


def test_what_is_reached_is_named(few: Reached) -> None:
    """Requirements and outcomes of guards, by the smallest programs first; what is missing is told."""
    assert few.requirements["AIRT-07"][0] == "AIRT-07-nothing-delayed-answers-0000"
    assert "AIRT-03" in few.by_program()["AIRT-nesting-002"]["requirements"]
    assert "Lines/IsCall/TRUE/Called" in {
        name for program in few.requirements["AIRT-07"] for name in few.by_program()[program]["guards"]
    }
    found = findings(few, {}, reasons.read(REASONS, reasons.Excuse))
    assert not found.ok
    assert found.share < 0.5
    assert "TINT-33" in found.few


def test_a_reason_has_no_say_against_a_log(few: Reached) -> None:
    """An outcome that a shipped log shows can be observed, whatever reason there is; a needless reason is stale."""
    guard = next(one for one in few.outcomes if one not in few.guards)
    excuse = [reasons.Excuse(id="*", reason="none of these")]
    with_log = findings(few, {guard: "some.ndjson"}, excuse)
    without = findings(few, {}, excuse)
    assert with_log.observable == without.observable + 1
    assert findings(few, {}, [*excuse, reasons.Excuse(id="Lines/IsCall/TRUE/Called", reason="x")]).stale


def test_reasons_name_conditions_that_exist(engine: Engine) -> None:
    """Of the file of reasons, each entry fits some outcome."""
    reached = Reached(decisions_of(engine))
    assert not [one for one in findings(reached, {}, reasons.read(REASONS, reasons.Excuse)).stale if "no such" in one]


def test_mutants_that_an_accepted_log_shows() -> None:
    """Counted are those that the kit or a shipped log shows; the share is the kit's part."""
    some = mutants({"A": Module("A", b"---- MODULE A ----\nF(x) == x + 1\nG(x) == x - 1 /\\ x = 2\n====\n")}, ["A"])[:4]
    hows = [("log", "kit"), ("log", "accepted logs"), ("survived", ""), ("invalid", "kit")]
    score = kit_mutants.score([Verdict(m, how, by, "", 0.0, ()) for m, (how, by) in zip(some, hows, strict=True)])  # type: ignore[arg-type]
    assert (score["shown"], score["by_kit"], score["share"]) == (2, 1, 0.5)
    assert score["missed"] == [some[1].id]
    plain = {"format": "s7-interrupt-log/1", "cpu": "S7-300", "obs": [1], "clock": "2026-11-21T06:00"}
    logs = {"a": plain, "b": plain | {"records": ["mode"]}, "c": plain | {"readings": {"AMB-01": "a"}}}
    startup = [b'{"event":"restart"}', b'{"event":"start","ob":100}', b'{"event":"end","ob":100}', b'{"event":"run"}']
    assert kit_mutants.without_startup_obs(startup) == (startup[0], startup[3])
    cases = [Case("X", name, "accepted", None, [], "", json.dumps(header).encode()) for name, header in logs.items()]
    assert [case.name for case in kit_mutants.accepted_logs(cases)] == ["a"]


def test_the_rest_of_the_kit_only_where_a_shipped_log_notices() -> None:
    """Whatever neither the first logs nor a shipped one notices, and whatever the first ones do, is not tried again."""
    some = mutants({"A": Module("A", b"---- MODULE A ----\nF(x) == x + 1\nG(x) == x - 1 /\\ x = 2\n====\n")}, ["A"])[:4]
    kills = {kit_mutants.KIT: some[:1], kit_mutants.SHIPPED: some[1:3], kit_mutants.REST: some[2:]}
    tried: dict[str, list[Mutant]] = {}

    def judge(check: Check, left: list[Mutant]) -> list[Verdict]:
        tried[check.name] = left
        killed = kills[check.name]
        return [
            Verdict(m, "log", check.name, "", 0.0, ()) if m in killed else Verdict(m, "survived", "", "", 0.0, ())
            for m in left
        ]

    score = kit_mutants.before_the_kit([FakeCheck(name, {}) for name in kills], some, judge)
    assert list(tried.values()) == [some, some[1:], some[1:3]]
    assert (score["shown"], score["by_kit"], score["missed"]) == (3, 2, [some[1].id])

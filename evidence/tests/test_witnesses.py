"""``s7spec witnesses``: what has to be witnessed, and what TLC meets of it in a small project."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from evidence.common import reasons
from evidence.common.cases import Case
from evidence.common.reasons import Excuse
from evidence.mutants import logs_model as logs
from evidence.mutants.conditions import Condition, conditions
from evidence.mutants.witnesses import Seen
from evidence.mutants.witnesses_command import witnesses_command
from evidence.mutants.witnesses_report import COLUMNS, explain, numbers
from evidence.tests.lamp import run_command, write_lamp
from evidence.tla.modules import read_modules
from evidence.tla.syntax import Module

ROOT = Path(__file__).parents[2]

SYSTEM = r"""---- MODULE System ----
EXTENDS Integers
VARIABLES left, step
Full == 2
Init == left = 0 /\ step = "none"
On == left = 0 /\ left' = Full
Burn == /\ left > 0
        /\ \/ left > 1
           \/ left = 1
        /\ left' = IF left > Full THEN 7 ELSE left - 1
Break == left > Full /\ left' = 0
Change == \/ On /\ step' = "on"
          \/ Burn /\ step' = "burn"
Next == Change \/ (\E s \in {"break"} : Break /\ step' = s)
Spec == Init /\ [][Next]_<<left, step>>
====
"""
PROPERTIES = r"""---- MODULE PropertiesLamp ----
EXTENDS System
InRange == left \in 0..Full
WentOutProp == [][ left = 1 /\ left' = 0 => step' = "burn" ]_<<left, step>>
BrokenProp == [][ left > Full => step' = "break" ]_<<left, step>>
NobodyInv == \A o \in {} : o = left
BeforeInv == {} = { l \in 0..left : l > Full }
====
"""
MODEL = "---- MODULE MCLamp ----\nEXTENDS PropertiesLamp\n====\n"
CONFIGURATION = "SPECIFICATION Spec\nINVARIANTS InRange NobodyInv BeforeInv\nPROPERTIES WentOutProp BrokenProp\n"


@pytest.fixture
def lamp(tmp_path: Path) -> Path:
    """Make a small project."""
    files = {
        "spec/System.tla": SYSTEM,
        "spec/PropertiesLamp.tla": PROPERTIES,
        "models/MCLamp.tla": MODEL,
        "models/MCLamp.cfg": CONFIGURATION,
    }
    return write_lamp(tmp_path, files, states=5, distinct=4, depth=4)


def run(project: Path, *arguments: str) -> tuple[int, str, dict[str, Any]]:
    """Run the command; return exit code, output and results."""
    return run_command(witnesses_command, project, *arguments)


def test_what_has_no_witness(lamp: Path) -> None:
    """An action never taken, guards never true or never false, vacuous antecedents."""
    code, output, document = run(lamp, "--against", "models")
    assert code == 1
    assert "NO REASON" in output
    lacking = {c["id"].rsplit("/", 1)[0] + ": " + c["text"]: c["missing"] for c in document["conditions"]}
    assert {text: missing for text, missing in lacking.items() if missing} == {
        "System/Burn/guard: left = 1": ["FALSE"],
        "System/Burn/guard: \\/ left > 1 \\/ left = 1": ["FALSE"],
        "System/Burn/condition: left > Full": ["TRUE"],
        "System/Break/guard: left > Full": ["TRUE"],
        "System/Next/action: Break /\\ step ' = s": ["evaluated"],
        "PropertiesLamp/BrokenProp/antecedent: left > Full": ["TRUE"],
        "PropertiesLamp/NobodyInv/instance: \\A o \\in { } : o = left": ["evaluated"],
        "PropertiesLamp/BeforeInv/filter: l > Full": ["TRUE"],
    }
    assert lacking['System/Next/action: On /\\ step \' = "on"'] == []
    assert lacking["PropertiesLamp/WentOutProp/antecedent: left = 1 /\\ left ' = 0"] == []
    assert document["all"]["without"] == 8


def test_reasons_needed_and_stale() -> None:
    """What has no witness needs a reason; one whose condition is gone, or has its witness, is stale."""
    met, unmet = found("guard", "/\\ x = 1\n/\\ y = 1\n/\\ x' = 2")
    seen = [Seen(met, {"TRUE": ("m", "logs"), "FALSE": ("logs",)}), Seen(unmet, {"TRUE": ("m",), "FALSE": ()})]
    ids = [met.id, unmet.id, "N/D/guard/0"]
    assert numbers(explain(seen, [], ids)) == dict(zip(COLUMNS, (2, 0, 1, 0, 1), strict=True))
    assert not explain(seen, [], ids).ok
    assert explain(seen, [Excuse("M/*", "why"), Excuse("N/*", "of a model that was not run")], ids).ok
    stale = explain(seen, [Excuse("Gone/*", "-"), Excuse(met.id, "-"), Excuse(unmet.id, "-")], ids)
    assert stale.stale == ["Gone/*: there is no such condition", f"{met.id}: has its witness"]
    assert not stale.ok


def test_a_model_that_fails(lamp: Path) -> None:
    """Its marks are no evidence."""
    (lamp / "spec" / "System.tla").write_text(SYSTEM.replace("Full == 2", "Full == 3"))
    (lamp / "models" / "MCLamp.cfg").write_text(CONFIGURATION.replace("InRange", "Wrong"))
    code, output, _ = run(lamp, "--against", "models")
    assert code == 3
    assert "Error: lamp:" in output


def found(kind: str, body: str, module: str = "M") -> list[Condition]:
    """Return the conditions of this kind in a definition with this body."""
    text = f"---- MODULE {module} ----\nEXTENDS Integers\nVARIABLES x, y\nD ==\n{body}\n====\n"
    return [c for c in conditions({module: Module(module, text.encode())}) if c.kind == kind]


@pytest.mark.parametrize(
    ("kind", "body", "module", "texts"),
    [
        ("guard", "/\\ x = 1\n/\\ y > 2 \\/ x < y\n/\\ x' = 2", "M", ["x = 1", "y > 2 \\/ x < y", "y > 2", "x < y"]),
        ("guard", "x = 1 /\\ y = 2", "M", []),
        ("guard", "/\\ x = 1\n/\\ x' = 2", "PropertiesM", []),
        ("condition", "x' = IF y = 1 THEN 2 ELSE 3", "M", ["y = 1"]),
        ("case", "x' = CASE y = 1 -> 2 [] y = 2 -> 3 [] OTHER -> 4", "M", ["y = 1", "y = 2"]),
        ("antecedent", "[][x = 1 => x' = 2]_x", "PropertiesM", ["x = 1"]),
        ("antecedent", "[](x = 1 => <>(y = 2))", "PropertiesM", []),
        ("antecedent", "x = 1 => y = 2", "M", []),
        ("filter", "{ z \\in x : z > 1 } = {}", "Inductive", ["z > 1"]),
        ("instance", "\\A z \\in x : z > 1", "Inductive", ["\\A z \\in x : z > 1"]),
        ("instance", "\\A z \\in x : z > 1 => y = 1", "Inductive", []),
    ],
)
def test_conditions(kind: str, body: str, module: str, texts: list[str]) -> None:
    """What is found in actions and in properties."""
    assert [c.text for c in found(kind, body, module)] == texts


def test_ids_last() -> None:
    """Lines that move and other definitions leave an id as it is; equal conditions have ids of their own."""
    (first,) = found("condition", "x' = IF y = 1 THEN 2 ELSE 3")
    (moved,) = found("condition", "\n\\* moved\n  x' = IF y = 1 THEN 2 ELSE 3\nE == 1")
    assert moved.id == first.id
    twice = found("guard", "\\/ x = 1 /\\ x' = 1\n\\/ x = 1 /\\ x' = 2")
    assert len({c.id for c in twice}) == len(twice) == 2


def test_a_name_is_what_its_module_knows() -> None:
    """An action is no guard where another module, which it is not built on, has a predicate of that name."""
    one = "---- MODULE A ----\nVARIABLE x\nStep == x' = 1\nNext == x = 0 /\\ Step\n====\n"
    other = "---- MODULE B ----\nVARIABLE y\nStep == y = 1\nNext == Step /\\ y' = 0\n====\n"
    modules = {name: Module(name, text.encode()) for name, text in (("A", one), ("B", other))}
    for order in (["A", "B"], ["B", "A"]):
        guards = [(c.module, c.text) for c in conditions({name: modules[name] for name in order}) if c.kind == "guard"]
        assert sorted(guards) == [("A", "x = 0"), ("B", "Step")]


def test_reasons_are_of_conditions() -> None:
    """Each reason of models/witnesses.json is of a condition of the specification."""
    known = {c.id for c in conditions(read_modules(ROOT / "spec"))}
    assert [why.id for why in reasons.read(ROOT / "models" / "witnesses.json", Excuse) if why.id not in known] == []


def test_actions_of_the_system() -> None:
    """Each action of Next of the specification, by its last conjunct."""
    actions = [c.text for c in conditions(read_modules(ROOT / "spec")) if c.kind == "action"]
    assert len(actions) == 35
    assert all("Seen (" in text or "step ' =" in text for text in actions)


def test_logs_bear_witness(tmp_path: Path) -> None:
    """TLC goes through the lines of a log."""
    (tmp_path / "traces").mkdir()
    header = "cpu=S7-300 obs=1 clock=2026-03-02T08:00:30.000 mode=RUN\n"
    (tmp_path / "traces" / "AIRT.txt").write_text(f"{header}== a A AIRT-03\n0:31 dair 0001\n0:32 eair 0000\n")
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "models.txt").write_text(f"spec {ROOT / 'spec'}\n")
    code, _, document = run(tmp_path, "--against", "logs")
    assert code == 1
    seen = {
        c["text"]: c["seen"] for c in document["conditions"] if c["id"].startswith(("Lines/IsCall/", "Lines/Answered/"))
    }
    assert seen['e . event = "DIS_AIRT"'] == {"TRUE": ["logs"]}
    assert seen["ret \\in AnswersTo ( e )"]["TRUE"] == ["logs"]


def test_logs_that_tlc_judges_otherwise() -> None:
    """Those that it consumes though they are rejected, and those that it does not consume though they are accepted."""
    cases = [Case("X", name, verdict, None, [], "", b"") for name, verdict in (("a", "accepted"), ("b", "rejected"))]
    assert logs.differences('<<"consumed", 1>>\n', cases) == []
    assert logs.differences('<<"consumed", 2>>\n', cases) == ["X/a", "X/b"]

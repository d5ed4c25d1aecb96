"""``s7spec prove``: queries that forget nothing, texts that say the same, answers that cannot be had for nothing."""

from __future__ import annotations

import dataclasses
import json
import re
import shutil
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import msgspec
import pytest

from evidence.cli import main
from evidence.common.cases import read_cases
from evidence.common.checkout import MANIFEST as MODELS
from evidence.common.checkout import ROOT
from evidence.common.processes import Processes
from evidence.models.entries import CONTROLS, Mutation
from evidence.models.proofs import prove_command as command
from evidence.models.proofs.apalache import HOME_VARIABLE, Answer, Apalache, interpret, late
from evidence.models.proofs.kept import KeptAnswers, Result, Run, keys, still, together
from evidence.models.proofs.queries import MANIFEST, ManifestError, Proofs, Query, load, named_actions
from evidence.models.proofs.report import as_json, assumptions, standing
from evidence.models.proofs.runner import Asking, ask, instances, ok, parts, texts
from evidence.models.proofs.text import (
    all_letters,
    as_action,
    default_letters,
    definitions,
    fixed_constants,
    named_letters,
    put_in_place,
    read_by_any,
    read_by_default,
    unless_read,
    with_letters,
    without_comments,
)
from evidence.tla.actions import conjuncts
from evidence.tla.modules import closure, reached, read_modules
from evidence.tla.syntax import SyntaxTreeError, meaningful, operand, references, token
from s7check.engine.client import Engine
from s7check.judging.check import check_log

RECORDED = Path(__file__).parent / "fixtures"


@pytest.fixture(scope="module")
def proofs() -> Proofs:
    """The queries of the checkout."""
    return load(ROOT)


def recorded(name: str) -> str:
    """Apalache's output of a run; of the violated one without most of the conditions that hold."""
    return (RECORDED / f"{name}.txt").read_text()


# What Apalache says


def test_every_condition_holds() -> None:
    """Each formula asked has conditions, and each condition is said to hold."""
    assert interpret(recorded("holds"), 0, ["Steps"]) == Answer("holds", 36, taken=10)


def test_a_counterexample() -> None:
    """The answer names the condition and the file, and how many conditions held before it."""
    answer = interpret(recorded("violated"), 12, ["Ind"])
    assert (answer.outcome, answer.checked, answer.detail) == ("violated", 4, "action invariant 55 is violated")
    assert answer.trace.endswith("violation1.tla")


def test_no_condition_was_checked() -> None:
    """A filter that lets none through: Apalache reports no error and exit code 0."""
    text = recorded("nothing")
    assert "EXITCODE: OK" in text
    answer = interpret(text, 0, ["StackInv"])
    assert answer.outcome == "nothing checked"
    assert answer.detail.startswith("0 of ")


@pytest.mark.parametrize(
    ("change", "asked"),
    [
        (("State 0: action invariant 3 holds.", ""), ["Steps"]),
        (("VCGen produced 5 ", "VCGen produced 0 "), ["Steps"]),
        (("", ""), ["Steps", "Lost"]),
    ],
)
def test_a_condition_is_lost(change: tuple[str, str], asked: list[str]) -> None:
    """One that is not said to hold, a formula without any, a formula that Apalache does not name."""
    assert change[0] in recorded("holds")
    assert interpret(recorded("holds").replace(*change), 0, asked).outcome == "nothing checked"


def test_a_condition_takes_too_long() -> None:
    """The formula that it is of is named; the answer is to the others, and all conditions have to be named."""
    text = recorded("holds")
    more = text.replace("invariant Steps", "invariant Ind").replace("produced 5 ", "produced 2 ")
    output = more + text.replace("produced 5 ", "produced 3 ").replace("invariant 3 holds.", "invariant 3 => TIMEOUT.")
    assert late(text) == ()
    assert late(output) == ("Steps",)
    assert interpret(output, 0, ["Ind", "Steps"]).outcome == "holds"
    assert interpret(output.replace("TIMEOUT", "UNKNOWN"), 0, ["Ind", "Steps"]).outcome == "nothing checked"
    assert interpret(output, 0, ["Steps"]).outcome == "timeout"
    states = output.replace("action invariant 0 holds.", "state invariant 0 holds.")
    assert late(states) == ("Ind", "Steps")


def test_apalache_fails() -> None:
    """Its first error is the detail; an exit code other than 0 is never a proof."""
    said = "Configuration error: Neither INIT and NEXT, nor SPECIFICATION   E@06:38:51.659\nEXITCODE: ERROR (255)\n"
    answer = interpret(said, 255, ["Steps"])
    assert (answer.outcome, answer.detail) == (
        "failed",
        "exit code 255: Configuration error: Neither INIT and NEXT, nor SPECIFICATION",
    )
    assert interpret(recorded("holds"), 255, ["Steps"]).outcome == "failed"


def test_java_fails() -> None:
    """Apalache has not begun: what is said last is the detail."""
    said = "Error occurred during initialization of VM\nMultiple garbage collectors selected\n"
    assert interpret(said, 1, ["Steps"]).detail == "exit code 1: Multiple garbage collectors selected"
    assert interpret("", 1, ["Steps"]).detail == "exit code 1: no message"


# What is asked


def test_each_action_has_its_query_and_its_control(proofs: Proofs) -> None:
    """With the invariant and every property of steps but those that the manifest lists."""
    left = {(cell.action, cell.formula) for cell in proofs.file.not_proved if not cell.letter}
    properties = {name for names in proofs.steps.values() for name in names}
    assert len(proofs.actions) == len(set(proofs.actions)) >= 30
    assert len(properties) > 70
    stepping = [query for query in proofs.queries if query.kind == "step"]
    assert Counter(a for q in stepping if "Ind" in q.formulas for a in q.actions) == Counter(proofs.actions)
    for action in proofs.actions:
        formulas = [name for query in stepping if action in query.actions for name in query.formulas]
        wanted = {name for name in properties | {"Ind", "InWorld"} if (action, name) not in left}
        assert sorted(formulas) == sorted(wanted)
    for query in stepping:
        assert query.next == (query.actions[0] if len(query.actions) == 1 else "Together")
        assert (query.init, query.length, query.expect) == ("AnyInit", 1, "holds")
    controls = [query for query in proofs.queries if query.name.startswith("control-")]
    assert [query.actions for query in controls] == [(action,) for action in proofs.actions]
    assert all((q.next, q.formulas, q.expect) == (q.actions[0], ("NoStep",), "violated") for q in controls)


def test_each_action_is_asked_of_each_family(proofs: Proofs) -> None:
    """The same formulas of every action, in the world of the family, and a control that each can take a step."""
    assert [family.name for family in proofs.file.induction.families] == ["s7-1500"]
    only = [action for family in proofs.file.induction.families for action in family.only]
    assert sorted((*proofs.actions, *only)) == sorted(named_actions(read_modules(ROOT / "spec")))
    for family in proofs.file.induction.families:
        of = [query for query in proofs.queries if query.name.startswith(f"{family.name}-")]
        assert {query.kind for query in of} == {"begins", "family", "control"}
        for kind in ("family", "control"):
            assert Counter(a for q in of if q.kind == kind for a in q.actions) == Counter(
                (*proofs.actions, *family.only)
            )
        for query in of:
            able = proofs.file.induction.able.get(query.actions[0]) if query.kind == "control" else None
            assert (query.module, query.alone) == (family.module, ", ".join(filter(None, (family.letters, able))))
            assert dict(query.instead).items() >= {k: tuple(v) for k, v in family.instead.items()}.items()
            assert query.kind != "family" or query.formulas == tuple(family.formulas)


def test_mutants_of_many_actions(proofs: Proofs) -> None:
    """At least thirty changed guards, each asked of one action and one property, with the change of its control."""
    mutants = [query for query in proofs.queries if query.kind == "mutant" and query.actions]
    assert len({query.name for query in mutants}) == len(mutants) >= 30
    assert len({query.actions for query in mutants}) > 15
    assert all((len(q.actions), len(q.formulas), q.expect) == (1, 1, "violated") and q.mutations for q in mutants)
    (query,) = proofs.select(("mutant-end-keeps-the-delay",))
    assert query.mutations[0].by in texts(ROOT, query)[0]


def test_mutants_of_the_abstract_specifications(proofs: Proofs) -> None:
    """The controls of each abstract specification, asked as its claim is, with one formula and their change."""
    claims = {query.name: query for query in proofs.queries if query.kind == "claim"}
    mutants = {q.name: q for q in proofs.queries if q.kind == "mutant" and not q.actions}
    assert {query.module for query in mutants.values()} == {"APLock", "APLife", "APFates"}
    listed = [(of, text.split()) for of, controls in proofs.file.claim_mutants.items() for text in controls]
    for of, (control, *formula) in listed:
        query, claim = mutants[f"mutant-{control.removeprefix('neg-')}"], claims[of]
        assert (query.init, query.length, len(query.formulas)) == (claim.init, claim.length, 1)
        assert not formula or query.formulas == (*formula,)
        text, unchanged = texts(ROOT, query)[0], texts(ROOT, dataclasses.replace(query, mutations=()))[0]
        assert query.expect == "violated"
        assert text != unchanged


def test_actions_that_are_asked_together(proofs: Proofs) -> None:
    """The step is their disjunction; a formula that is not claimed of one of them is asked of none."""
    query = next(q for q in proofs.queries if q.name == "calls-irt")
    text, _ = texts(ROOT, query)
    assert "\nTogether == " + " \\/ ".join(query.actions) + "\n====" in text


def test_what_is_not_claimed_is_not_asked(proofs: Proofs) -> None:
    """Neither of the action alone, nor in the query of every letter."""
    left = [cell for cell in proofs.file.not_proved if cell.action in proofs.actions and not cell.letter]
    assert left
    for cell in left:
        for query in proofs.queries:
            if query.kind in ("step", "letters") and cell.action in query.actions:
                assert cell.formula not in query.formulas


def test_formulas_that_are_asked_apart(proofs: Proofs) -> None:
    """Each query of such a formula is in its own world: by default, of letters, of a letter alone, of a mutant."""
    kinds = {"calls-irt-wide": {"step", "letters", "letter", "mutant"}, "first-point": {"step", "mutant"}}
    assert {apart.name for apart in proofs.file.induction.apart} == kinds.keys()
    for apart in proofs.file.induction.apart:
        of = [
            q for q in proofs.queries if set(apart.formulas) & set(q.formulas) and set(q.actions) & set(apart.actions)
        ]
        assert {query.kind for query in of} == kinds[apart.name]
        for query in of:
            assert set(query.formulas) <= set(apart.formulas)
            assert {(name, tuple(others)) for name, others in apart.instead.items()} <= set(query.instead)
            assert query.module == (apart.module or proofs.file.induction.module)
        others = {query.name: dict(query.instead) for query in proofs.queries if query not in of}
        assert not [name for name, instead in others.items() if set(apart.instead) - {"NextPoint"} & set(instead)]


def test_the_wider_world_has_all_obs(proofs: Proofs) -> None:
    """Those of module Cpu, and the query reads them."""
    spec, models = read_modules(ROOT / "spec"), read_modules(ROOT / "models")
    errors = token(operand(spec["Cpu"].definitions["AsyncErrorObs"], "definition"))
    wanted = token(operand(spec["Cpu"].definitions["OldExternalObs"], "definition")).replace(
        "AsyncErrorObs", f"({errors})"
    )
    given = token(operand(models["APSystem"].definitions["AllExternalObs"], "definition"))
    assert given.split() == wanted.split()
    (query,) = proofs.select(("calls-irt-wide",))
    assert "APExternalObs == (30..38)" in texts(ROOT, query)[0]


def test_a_sample_in_the_place_of_the_calendar(proofs: Proofs) -> None:
    """The step and the property have the same one; its lemma has NextPoint itself."""
    step, lemma = (texts(ROOT, proofs.select((name,))[0])[0] for name in ("first-point", "sampled-point"))
    for text, by_sample in ((step, "NextPoint(t, m, c)"), (step, "IsFirst(start, period"), (lemma, "FirstPoint(start")):
        said = text.partition(f"\n{by_sample}")[2].partition("\\* @type")[0]
        assert "IsSample(" in said
        assert "Sample.point" in said
    assert "FirstUnserved(t, begin, c)" in lemma
    assert "FirstUnserved" not in step


def test_queries_of_each_transition(proofs: Proofs) -> None:
    """Each asks formulas of which another query, a control, says that the action can take a step."""
    unfiltered = {query.name for query in proofs.queries if query.unfiltered}
    assert unfiltered >= {"ClockIsSet", "letters-lock", "refines-lock", "conserves-EventFromOutside"}
    assert {query.name for query in proofs.queries if query.kind == "letter"} <= unfiltered
    assert not unfiltered & {"MissesOb", "conserves-first", "conserves-lock"}
    controlled = {query.actions for query in proofs.queries if query.kind == "control" and not query.unfiltered}
    for query in proofs.queries:
        if query.unfiltered:
            assert {(action,) for action in query.actions} <= controlled


def test_formulas_about_states_come_first(proofs: Proofs) -> None:
    """`late` counts so. Apalache takes a formula for one about a step if it has a prime, itself or in what it uses."""
    modules = read_modules(ROOT / "spec")
    units = {name: unit for module in modules.values() for name, unit in module.definitions.items()}
    uses = {name: references(unit) for name, unit in units.items()}

    def has_prime(name: str) -> bool:
        return any("'" in token(units[used]) for used in reached([name], uses) if used in units)

    assert all(has_prime(name) for names in proofs.steps.values() for name in names)
    assert not any(has_prime(name) for names in proofs.states.values() for name in names)
    for query in proofs.queries:
        about_states = [name in proofs.file.induction.invariants for name in query.formulas]
        assert query.kind not in ("step", "letters") or about_states == sorted(about_states, reverse=True)


def test_a_divided_action_loses_no_transition() -> None:
    """Each transition is in one run, however many there are; the initial one is in all."""
    options = [part.removeprefix("search.transitionFilter=") for part in parts([3, 5])]
    assert len(options) == 3
    assert all(re.fullmatch(option, "0->0") for option in options)
    runs = [[n for n, option in enumerate(options) if re.fullmatch(option, f"1->{step}")] for step in range(60)]
    assert runs == [[0]] * 3 + [[1]] * 2 + [[2]] * 55
    assert parts([]) == [""]


def test_history_stops_no_step(proofs: Proofs) -> None:
    """It says the next value of each variable of the mapping and nothing more, so the control of the action is enough.

    The queries of a refinement ask formulas of each transition, whether a state can take it or not.
    """
    modules = read_modules(ROOT / "models")
    assert any(query.unfiltered for query in proofs.queries if query.kind == "refines")
    for refinement in proofs.file.refinements.values():
        names = closure(refinement.module, modules)
        definitions = {key: unit for name in names for key, unit in modules[name].definitions.items()}
        parts = [operand(definitions[refinement.history], "definition")]
        given = []
        while parts:
            part = parts.pop()
            if part.type == "let_in":
                parts.append(meaningful(part)[-1])
            elif some := conjuncts(part):
                parts += some
            elif part.type == "identifier_ref":
                parts.append(operand(definitions[token(part)], "definition"))
            else:
                said = re.match(r"(\w+)' +=", token(part))
                assert said, token(part)
                given.append(said[1])
        variables = [unit for name in names for unit in modules[name].units if unit.type == "variable_declaration"]
        own = {token(node) for unit in variables for node in unit.children if node.type == "identifier"}
        assert sorted(given) == sorted(own)


@pytest.mark.parametrize(
    ("word", "any_state", "begins", "steps", "history", "abstract", "needed"),
    [
        (
            "refines",
            "AnyRefined",
            ("LockBegins", "LifeBegins"),
            ("LockStep", "LifeStep"),
            "History",
            {"CounterLock", "LifeCycle"},
            {"InClass", "RunningClasses"},
        ),
        ("conserves", "AnyCounted", ("EventsBegin",), ("EventsStep",), "CountedOn", {"Conservation"}, {"FatesOf"}),
    ],
)
def test_each_action_refines(
    proofs: Proofs,
    word: str,
    any_state: str,
    begins: tuple[str, ...],
    steps: tuple[str, ...],
    history: str,
    abstract: set[str],
    needed: set[str],
) -> None:
    """Every action is asked the steps of the abstract specifications, with the history, and their initial states."""
    first, *others = (q for q in proofs.queries if q.kind == "refines" and q.name.startswith(f"{word}-"))
    assert (first.formulas, first.length) == (begins, 0)
    assert sorted(action for query in others for action in query.actions) == sorted(proofs.actions)
    assert {(q.init, q.formulas, q.length, q.expect) for q in others} == {(any_state, steps, 1, "holds")}
    (query,) = proofs.select((f"{word}-StartsOb",))
    text, _ = texts(ROOT, query)
    assert f"\nTogether == (StartsOb) /\\ {history}\n====" in text
    assert instances(ROOT, query, text).keys() == abstract
    assert needed <= definitions(text)


def test_one_invariant_for_all(proofs: Proofs) -> None:
    """It holds at first, and every property of states follows from it."""
    first, invariants = (next(q for q in proofs.queries if q.name == name) for name in ("first", "invariants"))
    assert (first.init, first.formulas) == ("Init", ("Ind", "InWorld"))
    left = {cell.formula for cell in proofs.file.not_proved if cell.action == "invariants"}
    assert set(invariants.formulas) == {name for names in proofs.states.values() for name in names} - left


def test_what_is_put_in_place_has_its_lemma(proofs: Proofs) -> None:
    """Its query has the operator itself. Three others TLC checks (models calendar-lemma and tables).

    The last one, StatusWordsFor, is the same set where every number is a status word.
    """
    lemmas = {query.name: query for query in proofs.queries if query.kind == "lemma"}
    closing = {lemma.of for lemma in proofs.file.induction.lemmas} - {""}
    assert closing == {*proofs.file.induction.instead} - {"FirstPoint", "DefaultClass", "FamilyOf", "StatusWordsFor"}
    for lemma in proofs.file.induction.lemmas:
        query = lemmas[lemma.name]
        assert lemma.of not in dict(query.instead)
        assert (query.init, query.formulas, query.length) == (lemma.init, (lemma.formula,), 0)


def test_the_worlds_of_the_queries(proofs: Proofs) -> None:
    """They differ in bounds alone. Nothing is claimed from the smallest one."""
    base = proofs.file.induction
    operators = read_modules(ROOT / "models")["APSystem"].definitions
    for world in (base.world, base.smaller, base.refuted):
        said = token(operators[world.state])
        assert f"StateWith(t, u, {world.waiting}, {world.running})" in said
        alike = re.sub(r"\d", "n", said).removeprefix(world.state)
        assert alike == re.sub(r"\d", "n", token(operators[base.world.state])).removeprefix(base.world.state)
    assert f"StateWith(t, u, 7, {base.world.running + 1})" in token(operators["DeeperInit"])
    assert token(operators["DepthInv"]).endswith(f"Len(stack) <= {base.world.running}")
    for query in proofs.queries:
        states = dict(query.instead).get(base.world.state, (base.world.state,))
        if query.expect == "violated":
            assert states == ((base.refuted.state,) if query.actions else (base.world.state,))
        else:
            assert states == ((base.smaller if query.kind in ("letters", "refines", "family") else base.world).state,)


def test_the_small_world(proofs: Proofs) -> None:
    """``--small``: the queries of steps alone begin there, and the report says the bounds."""
    small, base = proofs.in_small_world(), proofs.file.induction
    for query, other in zip(proofs.queries, small.queries, strict=True):
        assert (query != other) == (query.kind == "step")
    query = next(query for query in small.queries if query.name == "StartsOb")
    said = f"StateWith(t, u, {base.refuted.waiting}, {base.refuted.running})"
    assert said in texts(ROOT, query)[0]
    assert f"at most {base.refuted.waiting} start events that wait" in assumptions(small)


def test_models_within_the_proofs(proofs: Proofs) -> None:
    """What `ProvedProp` of the models says of a state is what the proofs begin with."""
    models = read_modules(ROOT / "models")
    said = token(models["MCBase"].definitions["ProvedProp"])
    world, base = models["APSystem"].text.decode(), proofs.file.induction
    for name in ("APTodObs", "APDintObs", "APExternalObs", "APObs", "APAmbiguities"):
        (members,) = re.findall(rf"^{name} == (\{{.*\}})$", world, re.MULTILINE)
        assert f"\\subseteq {members}" in said
    (classes,) = re.findall(r"set \\in SUBSET (\{.*\}),", world)
    assert f"DOMAIN cpu.priority \\subseteq {classes}" in said
    for bound, most in (("Cardinality(requests)", base.world.waiting), ("Len(stack)", base.world.running)):
        assert f"{bound} <= {most}" in said
    assert f"{base.world.state} == \\E t \\in {{Gen(2)}}, u \\in {{Gen(2)}} :" in world
    assert "Cardinality(tod[o].served) <= 2" in said


def test_every_letter_is_asked(proofs: Proofs) -> None:
    """Of the same actions and formulas, but those that are not claimed of a letter; the constants are declared."""
    whole = [query for query in proofs.queries if "Ind" in query.formulas]
    steps = {action: query for query in whole if query.kind == "step" for action in query.actions}
    letters = [query for query in whole if query.kind == "letters"]
    assert {action for query in letters for action in query.actions} == set(proofs.actions)
    for query in letters:
        for action in query.actions:
            left = {cell.formula for cell in proofs.file.not_proved if cell.letter and cell.action in query.actions}
            assert set(steps[action].formulas) - left <= set(query.formulas)
    text, _ = texts(ROOT, letters[0])
    assert "CONSTANTS\n    \\* @type: Str;\n    LetterOf" in without_comments(text)
    assert 'LetterOf49 \\in {"a", "b", "c"}' in text


def test_queries_are_picked_by_name(proofs: Proofs) -> None:
    """By globs; an action stands for the query about its step."""
    assert [q.name for q in proofs.select(("CallDisAirt", "control-CallD*Airt"))] == ["lock", "control-CallDisAirt"]
    with pytest.raises(ManifestError, match="no query or action is called CallDis:"):
        proofs.select(("CallDis",))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"version": 2}, "version"),
        ({"not_proved": [{"action": "Nothing", "formula": "EndProp", "tried": "ten characters"}]}, "no action"),
        ({"not_proved": [{"action": "EndsOb", "formula": "NoProp", "tried": "ten characters"}]}, "neither a property"),
        ({"not_proved": [{"action": "EndsOb", "formula": "EndProp", "tried": "no"}]}, "tried"),
        ({"mutants": {"EndsOb": ["neg-airt-en-ends-all No"]}}, "a property"),
        (
            {
                "not_proved": [
                    {"action": "EndsOb", "formula": "EndProp", "letter": "AMB-49b", "tried": "ten characters"}
                ]
            },
            "letter",
        ),
        (
            {
                "not_proved": [
                    {"action": "EndsOb", "formula": "EndProp", "letter": "AMB-49 b", "tried": "ten characters"}
                ]
            },
            "no model letter-49b-EndProp",
        ),
        ({"mutants": {"EndsOb": ["airt EndProp"]}}, "airt is no control"),
        ({"induction": {"divided": {"Nothing": [3]}}}, "induction.divided: Nothing: .* expected a glob"),
        ({"induction": {"divided": {"StartsOb": [3, 2]}}}, "induction.divided: StartsOb: .* numbers above 0 in order"),
        ({"induction": {"unfiltered": ["first"]}}, "induction.unfiltered: expected queries about steps, not first"),
        (
            {"claim_mutants": {"no": ["neg-lock-alone-ends-in-hold EndStep"]}},
            "a claim",
        ),
        ({"claim_mutants": {"lock-steps": ["lock-alone EndStep"]}}, "no control"),
    ],
)
def test_a_wrong_manifest(tmp_path: Path, change: dict[str, Any], said: str) -> None:
    """The message names the file and the field."""
    (tmp_path / "models").mkdir()
    (tmp_path / "spec").symlink_to(ROOT / "spec")
    for file in (MODELS, MODELS.with_name(CONTROLS)):
        (tmp_path / file).symlink_to(ROOT / file)
    manifest = json.loads((ROOT / MANIFEST).read_bytes())
    parts = {key: manifest[key] | part if isinstance(part, dict) else part for key, part in change.items()}
    (tmp_path / MANIFEST).write_text(json.dumps(manifest | parts))
    with pytest.raises(ManifestError, match=f"proofs.json: .*{said}"):
        load(tmp_path)


# What Apalache reads


def test_a_property_becomes_an_action_formula() -> None:
    """The columns stay."""
    text = "P ==\n    [][ /\\ a\n        /\\ b ]_vars\nQ == [][c]_<<x>>\n"
    assert as_action(text).splitlines()[:3] == ["P ==", "    (   /\\ a", "        /\\ b )"]


def test_readings_are_read_by_default() -> None:
    """The letters are those of module Readings."""
    rows = 'Questions ==\n  { <<"AMB-02", "b", AB>>,\n    <<"AMB-09", "a", ABC>> }\n<<"AMB-01", "a">>\n'
    letters = default_letters(rows)
    assert letters == {"AMB-02": "b", "AMB-09": "a"}
    assert read_by_default('Reading("AMB-02") = "a" /\\ Reading("AMB-09") = "b"', letters) == '"b" = "a" /\\ "a" = "b"'
    assert read_by_default("Of(a) == Defaults[a]", letters) == 'Of(a) == (CASE a = "AMB-02" -> "b" [] OTHER -> "a")'


def test_a_text_of_any_letter() -> None:
    """A constant for each ambiguity, but for those that a CPU shows; the letters are those of module Readings."""
    letters = all_letters('Questions ==\n  { <<"AMB-02", "b", ABC>>,\n    <<"AMB-01", "a", AB>> }\n')
    assert letters == {"AMB-02": "abc", "AMB-01": "ab"}
    text = read_by_any('==\nEXTENDS A\nF == Reading("AMB-02") = "a" /\\ Reading("AMB-11") = "b"\n====\n', ["AMB-11"])
    said = with_letters(text, letters, "Any")
    assert 'F == LetterOf02 = "a" /\\ Reading("AMB-11") = "b"' in said
    assert "EXTENDS A\nCONSTANTS\n    \\* @type: Str;\n    LetterOf02\n" in said
    assert said.endswith('AnyLetters ==\n    /\\ Any\n    /\\ LetterOf02 \\in {"a", "b", "c"}\n====\n')


@pytest.mark.parametrize(
    ("said", "fixed"),
    [
        ("A \\in 1..3 /\\ R = [a |-> A] /\\ S = Gen(1)", set()),
        ("A \\in 1..3 /\\ A # 0", set()),
        ("A \\in 1..3 /\\ (A = 3 => R = [a |-> A])", {"A"}),
        ("A \\in 1..3 /\\ A = Few", {"A"}),
        ("A \\in 1..3 /\\ IsFew", {"A"}),
    ],
)
def test_a_constant_that_gets_one_value(said: str, fixed: set[str]) -> None:
    """Apalache puts a value that a constant is compared with in the place of the constant everywhere."""
    declared = "---- MODULE M ----\nCONSTANTS A,\n    R\nCONSTANT S\nFew == 1\nIsFew == A = Few\nOther == A = 2\n"
    assert fixed_constants(f"{declared}Any == {said}\n====\n", "Any") == fixed


def test_a_query_whose_constants_get_one_value(proofs: Proofs, tmp_path: Path) -> None:
    """Such a query is not asked."""
    shutil.copytree(ROOT / "spec", tmp_path / "spec")
    shutil.copytree(ROOT / "models", tmp_path / "models")
    world = tmp_path / "models" / "APSystem.tla"
    world.write_text(world.read_text().replace("/\\ AnyFault \\in", "/\\ AnyFault = 3\n    /\\ AnyFault \\in"))
    query = next(query for query in proofs.queries if query.name == "lock")
    with pytest.raises(ManifestError, match="query lock: AnyConstants compares AnyFault by =; "):
        texts(tmp_path, query)


def test_a_formula_says_nothing_of_some_letters() -> None:
    """The formula itself stays, since a query also assumes it; what is asked stands at the end."""
    text = "---- MODULE M ----\nP == TRUE\nQ == P\n====\n"
    said = unless_read(text, "Q", ["AMB-21 b", "AMB-42 c"])
    condition = 'LetterOf21 = "b" \\/ LetterOf42 = "c"'
    asked = f"QButFor == \\A asked \\in (IF {condition} THEN {{}} ELSE {{TRUE}}) : Q"
    assert said == f"---- MODULE M ----\nP == TRUE\nQ == P\n{asked}\n====\n"
    said = unless_read(text, "Q", ["AMB-21 b, AMB-42 c", "AMB-10 b"])
    assert 'IF (LetterOf21 = "b" /\\ LetterOf42 = "c") \\/ LetterOf10 = "b" THEN' in said
    with pytest.raises(SyntaxTreeError, match="no definition of R"):
        unless_read(text, "R", ["AMB-21 b"])


def test_letters_that_are_left_out(proofs: Proofs, tmp_path: Path) -> None:
    """A formula that is not claimed of a letter is asked of the others, in the query about letters alone."""
    cell = {"action": "CallEnIrt", "formula": "SilentProp", "letter": "AMB-21 b", "tried": "ten characters"}
    (tmp_path / "models").mkdir()
    (tmp_path / "spec").symlink_to(ROOT / "spec")
    for file in (MODELS, MODELS.with_name(CONTROLS)):
        (tmp_path / file).symlink_to(ROOT / file)
    (tmp_path / MANIFEST).write_text(json.dumps(json.loads((ROOT / MANIFEST).read_bytes()) | {"not_proved": [cell]}))
    asked = {query.name: query for query in load(tmp_path).queries}
    assert asked["letters-calls-irt"].unless == (("SilentProp", ("AMB-21 b",)),)
    assert "SilentProp" in asked["letters-calls-irt"].formulas
    assert "SilentProp" in asked["calls-irt"].formulas
    said = [name for name, query in asked.items() if any(name in query.formulas for name, _ in query.unless)]
    assert said == ["letters-calls-irt"]


def test_some_formulas_of_a_query_about_letters(proofs: Proofs) -> None:
    """Where the others have an answer already, the letters that are left out of these do not matter."""
    (query,) = (query for query in proofs.queries if query.name == "letters-calls-irt")
    text, _ = texts(ROOT, dataclasses.replace(query, formulas=("InWorld",)))
    assert 'InWorldButFor == \\A asked \\in (IF LetterOf21 = "b"' in text
    assert "InWorld ==\n    /\\" in text
    assert "AirtKeepsProp" not in text


def test_a_letter_that_is_left_out_is_refuted(proofs: Proofs) -> None:
    """Each has a query of this letter alone, of which the formula is violated; the others are read by default."""
    cells = {(cell.action, cell.formula, cell.letter) for cell in proofs.file.not_proved if cell.letter}
    queries = [query for query in proofs.queries if query.kind == "letter"]
    assert {(*query.actions, *query.formulas, query.alone) for query in queries} == cells
    assert {query.expect for query in queries} == {"violated"}
    (query,) = (query for query in queries if query.name == "letter-CallEnIrt-InWorld-AMB-21-b-AMB-42-b")
    text, _ = texts(ROOT, query)
    assert not query.unless
    assert 'LetterOf21 \\in {"b"}' in text
    assert 'LetterOf42 \\in {"b"}' in text
    assert 'LetterOf75 \\in {"a"}' in text


def test_what_a_letter_contradicts_is_in_a_log(proofs: Proofs, tmp_path: Path) -> None:
    """TLC comes to it by this letter alone, and the trace checker explains it; no log is of anything else."""
    cells = {cell.control: cell for cell in proofs.contradicted}
    logs = {case.name: case for case in read_cases(ROOT / "models" / "letters.txt")}
    assert logs.keys() == cells.keys()
    with Engine() as engine:
        for name, cell in cells.items():
            assert logs[name].header["readings"] == named_letters(cell.letter)
            report = check_log(str(logs[name].put(tmp_path)), engine, lambda *_: None)
            assert report.verdict == "accepted", str(report)


def test_an_operator_is_put_in_the_place_of_another() -> None:
    """With its type, and what used the one uses the other."""
    text = (
        "---- MODULE M ----\nEXTENDS Integers\n\\* @type: Int => Int;\nF(x) == x\n\nG == F(1)\n\n"
        "Lemma(x) == x\n\n\\* @type: Int => Int;\nApF(x) ==\n  Lemma(x) + 1\n\nH == 1\n====\n"
    )
    changed = put_in_place(text, "F", ["Lemma", "ApF"])
    places = [changed.index(part) for part in ("Lemma(x) == x\n", "F(x) ==\n  Lemma(x) + 1", "G == F(1)", "H == 1")]
    assert places == sorted(places)
    assert changed.count("F(x) ==") == 1
    assert changed.count("@type") == 1
    with pytest.raises(SyntaxTreeError, match="no definition of K"):
        put_in_place(text, "K", ["ApF"])


def test_the_text_has_what_the_query_needs(proofs: Proofs) -> None:
    """And no box, no reading, and of the calendar the lemma."""
    (query,) = proofs.select(("StartsOb",))
    text, config = texts(ROOT, query)
    assert {"StartsOb", "AnyInit", *query.formulas} <= definitions(text)
    assert "CallSetTint" not in definitions(text)
    assert "[][" not in text
    assert 'Reading("' not in text
    assert "AnyPoint" not in text
    assert config.startswith("INIT AnyInit\nNEXT StartsOb\n")


def test_comments_say_nothing() -> None:
    """But types: an answer stays where a comment changes."""
    alias = "(* @typeAlias: t = { a: Int,   *)\n(*   b: Int };  *)"
    typed = "\\* @type: Int => Int;\nG(x) =="
    text = f"(* A box *)\nF == 1 \\* why\n\n(* two\n   lines *)\n{typed} (* b *) x\n{alias}\n"
    assert without_comments(text) == f"F == 1\n{typed}  x\n{alias}"


def test_a_mutation_needs_its_text_once(proofs: Proofs) -> None:
    """Otherwise the manifest is behind the specification."""
    (query,) = proofs.select(("control-DropsRequest",))
    change = Mutation(module="Scheduler.tla", replace="    /\\ r.open\n", by="    /\\ ~r.open\n")
    text, _ = texts(ROOT, dataclasses.replace(query, mutations=(change,)))
    assert "/\\ ~r.open\n" in text
    stale = msgspec.structs.replace(change, replace="no such text")
    with pytest.raises(ManifestError, match=r"Scheduler\.tla has not once the text 'no such text'"):
        texts(ROOT, dataclasses.replace(query, mutations=(stale,)))


# Asking


Program = Callable[..., Apalache]


@pytest.fixture
def program(tmp_path: Path) -> Iterator[Program]:
    """A program in the place of Apalache, which begins a run with a statement, and says this."""

    def made(output: str, code: int, begin: str = "pass") -> Apalache:
        (tmp_path / "output").write_text(output)
        (tmp_path / "program.py").write_text(
            f"import sys\nfor line in sys.stdin:\n    {begin}\n"
            f"    print(open({str(tmp_path / 'output')!r}).read())\n    print('@!@!@EXIT {code}', flush=True)\n"
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
    assert [(run.query, run.answer.outcome) for run in runs if run.answer.outcome != claimed.get(run.query)] == []


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


def test_a_late_formula_has_a_run_of_its_own(tmp_path: Path, proofs: Proofs, program: Program) -> None:
    """What came of the others is kept, whatever comes of it."""
    steps = claim(proofs)
    query = dataclasses.replace(steps, formulas=(*steps.formulas, "Invariant"))
    text = recorded("holds")
    others = text.replace("produced 5 ", "produced 3 ")
    own = text.replace("invariant Steps", "invariant Invariant").replace("produced 5 ", "produced 2 ")
    own = own.replace("invariant 4 holds.", "invariant 4 => TIMEOUT.")
    asking = Asking(ROOT, tmp_path / "build", KeptAnswers(tmp_path / "kept"), program(others + own, 0))
    assert ask(asking, query).answer.detail == "Z3 had no answer in time about Invariant"
    kept = asking.answers.of(query.name)
    assert [(run.answer.outcome, len(run.keys)) for run in kept] == [("holds", 1), ("timeout", 1)]


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
        assert apalache.run([[]], ["Steps"], tmp_path, 60).answer.outcome == "holds"
    first, second = count.read_text().split()
    assert first == second
    dead = Apalache([sys.executable, "-c", "print('no memory'); raise SystemExit(3)"], Processes())
    for _ in range(2):
        assert dead.run([[]], ["Steps"], tmp_path, 60).answer == Answer("failed", 0, "exit code 3: no memory")


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

"""The queries of the proofs forget nothing, and a wrong manifest is refused."""

from __future__ import annotations

import dataclasses
import json
import re
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from evidence.common.checkout import MANIFEST as MODELS
from evidence.common.checkout import ROOT
from evidence.models.entries import CONTROLS
from evidence.models.proofs.made import instances, parts, texts
from evidence.models.proofs.manifest import MANIFEST, ManifestError
from evidence.models.proofs.queries import Proofs, load, named_actions
from evidence.models.proofs.report import assumptions
from evidence.models.proofs.text import (
    definitions,
    without_comments,
)
from evidence.tla.actions import conjuncts
from evidence.tla.modules import closure, reached, read_modules
from evidence.tla.syntax import meaningful, operand, references, token


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
        assert query.kind not in ("step", "letters", "family") or about_states == sorted(about_states, reverse=True)


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

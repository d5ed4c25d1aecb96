"""The text that Apalache reads says what that of spec/ says."""

from __future__ import annotations

import dataclasses
import json
import shutil
from pathlib import Path

import msgspec
import pytest

from evidence.common.cases import read_cases
from evidence.common.checkout import MANIFEST as MODELS
from evidence.common.checkout import ROOT
from evidence.models.entries import CONTROLS, Mutation
from evidence.models.proofs.made import texts
from evidence.models.proofs.manifest import MANIFEST, ManifestError
from evidence.models.proofs.queries import Proofs, load
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
from evidence.tla.syntax import SyntaxTreeError
from s7check.engine.client import Engine
from s7check.judging.check import check_log


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

"""Which mutants there are: every kind of change, texts that keep their columns, ids that last."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from evidence.mutants.listing import Mutant, mutants
from evidence.tla.modules import read_modules
from evidence.tla.syntax import Module, SyntaxTreeError

SPEC = Path(__file__).parents[2] / "spec"


def made_of(body: str, name: str = "D") -> list[Mutant]:
    """Return the mutants of a definition with this body."""
    text = f"---- MODULE M ----\nEXTENDS Integers\nVARIABLES x, y\nStep == x' = 1\n{name} ==\n{body}\n====\n"
    found = mutants({"M": Module("M", text.encode())}, ["M"])
    return [mutant for mutant in found if mutant.definition == name]


def changes(body: str, kind: str, name: str = "D") -> list[str]:
    """Say what the mutants of a kind change."""
    return [f"{m.was} -> {m.by}" for m in made_of(body, name) if m.kind == kind]


@pytest.mark.parametrize(
    ("body", "kind", "expected"),
    [
        ("x < 1 /\\ Ready", "drop-conjunct", ["x < 1 -> TRUE", "Ready -> TRUE"]),
        ("/\\ x < 1\n/\\ x' = 2", "drop-conjunct", ["x < 1 -> TRUE"]),
        ("/\\ x < 1\n/\\ Step", "drop-conjunct", ["x < 1 -> TRUE"]),
        ("Step \\/ UNCHANGED x", "drop-disjunct", ["Step -> FALSE", "UNCHANGED x -> FALSE"]),
        ("/\\ Ready\n/\\ ~Busy\n/\\ x = 1", "negate-guard", ["Ready -> ~( Ready )", "~ Busy -> Busy"]),
        ("Ready => Busy", "negate-guard", ["Ready -> ~( Ready )"]),
        ("{ i \\in y : Ready(i) }", "negate-guard", ["Ready ( i ) -> ~( Ready ( i ) )"]),
        ("IF Ready THEN 1 ELSE 2", "negate-condition", ["Ready -> ~( Ready )"]),
        ("x < y", "comparison", ["x < y -> x <= y", "x < y -> x >= y"]),
        ("x \\in y", "comparison", ["x \\in y -> x \\notin y"]),
        ("x' = y", "comparison", []),
        ("x' = y", "unchanged", ["x ' = y -> x ' = x"]),
        ("x' \\in y", "unchanged", ["x ' \\in y -> x ' = x"]),
        ("Ready \\/ Busy", "connective", ["Ready \\/ Busy -> (( Ready ) /\\ ( Busy ))"]),
        ("Ready /\\ Step", "connective", []),
        ("\\A i \\in y : i = x", "quantifier", ["\\A -> \\E"]),
        ("\\E i \\in y : x' = i", "quantifier", []),
        ("x + y - 1", "arithmetic", ["x + y - 1 -> x - y - 1", "y - 1 -> y + 1"]),
        ("<<0, 7>>", "constant", ["0 -> 1", "0 -> (-1)", "7 -> 8", "7 -> 6"]),
        ("[x EXCEPT !.a = 1, !.b = @]", "keep-field", ["1 -> @"]),
        ("x \\cup y", "drop-union", ["x -> {}", "y -> {}"]),
        ("x \\ y", "drop-union", ["y -> {}"]),
        ("CASE x = 1 -> 2 [] OTHER -> 3", "drop-case", ["x = 1 -> FALSE", "OTHER -> FALSE"]),
        ('x = "a" /\\ y = "b"', "literal", ['"a" -> "b"', '"b" -> "a"']),
        ("x = \\h10 /\\ y = \\h2F", "literal", ["\\h 10 -> \\h2F", "\\h 2F -> \\h10"]),
        ("x = TRUE", "boolean", ["TRUE -> FALSE"]),
        ("[][Step]_x", "drop-conjunct", []),
    ],
)
def test_kind_of_change(body: str, kind: str, expected: list[str]) -> None:
    """Each kind of change is made where it is due."""
    assert changes(body, kind) == expected


def test_first_values_are_kept() -> None:
    """A first state without a value for a variable shows nothing."""
    assert changes("/\\ x = 0\n/\\ y \\in {1}\n/\\ x < 2", "drop-conjunct", "Init") == ["x < 2 -> TRUE"]
    assert changes("x = 0 /\\ y \\in {1}", "comparison", "Init") == []


LISTS = """\
    /\\ IF x < 1 THEN /\\ Ready
                     /\\ Busy  \\* why
       ELSE \\/ Busy
            \\/ Ready
    /\\ y = 1 /\\ x = 2"""


def test_what_is_kept_keeps_its_column() -> None:
    """Whatever a longer text displaces goes to a line of its own."""
    bullet = re.compile(r"/\\|\\/|Ready|Busy|THEN|ELSE|=|<")

    def columns(text: str) -> set[tuple[str, int]]:
        return {(found[0], found.start()) for line in text.splitlines() for found in bullet.finditer(line)}

    kept = columns(LISTS)
    for mutant in made_of(LISTS):
        if mutant.kind in ("comparison", "constant", "negate-condition", "negate-guard"):
            missing = kept - columns(mutant.text.decode())
            assert {word for word, _ in missing} <= {*mutant.was.split()}, mutant.text.decode()


def test_changes_in_lists_stay_in_the_list() -> None:
    """Every mutant of nested lists can be read."""
    for mutant in made_of(LISTS):
        assert not Module("M", mutant.text).root.has_error, mutant.text.decode()


def test_ids_outlive_unrelated_edits() -> None:
    """Comments and other definitions are not part of an id."""
    body = "/\\ Ready\n/\\ x = 1\n/\\ x = 1"
    before = made_of(body)
    text = before[0].text.replace(b"TRUE", b"Ready", 1)
    edited = text.replace(b"Step ==", b"\\* new\nOther == 1 + 2\n\nStep ==").replace(
        b"/\\ Ready", b"/\\ Ready  \\* new"
    )
    after = mutants({"M": Module("M", edited)}, ["M"])
    assert [m.id for m in after if m.definition == "D"] == [m.id for m in before]
    assert len({m.id for m in before}) == len(before)


def test_a_module_that_cannot_be_read_is_named() -> None:
    """The user is told file and line."""
    with pytest.raises(SyntaxTreeError, match=r"M\.tla:2"):
        mutants({"M": Module("M", b"---- MODULE M ----\nA == /\\\n====\n")}, ["M"])


def test_the_specification_has_mutants_enough() -> None:
    """A part of spec/ has 500 mutants, each with an id and a text of its own."""
    modules = read_modules(SPEC)
    found = mutants(modules, ["Airt", "Requests", "Scheduler", "TimeOfDay"])
    assert len(found) >= 500
    assert len({m.id for m in found}) == len(found)
    assert all(m.text != modules[m.module].text for m in found)

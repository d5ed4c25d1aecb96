"""Arguments of which an operator makes copies are bound where it is applied."""

from __future__ import annotations

import re

import pytest

from evidence.tla.binding import bind_arguments
from evidence.tla.syntax import SyntaxTreeError


def bound(definitions: str) -> str:
    """The definitions after the change, with one blank between words and none beside brackets."""
    text = bind_arguments(f"---- MODULE Small ----\nVARIABLES x, y\n{definitions}\n====\n")
    return re.sub(r"\s*([(){}])\s*", r"\1", re.sub(r"\s+", " ", text))


TWICE = "Twice(n) == n + n\n"
BECOMES = "Becomes(n) == x' = n /\\ y' = n\n"


@pytest.mark.parametrize(
    ("definitions", "texts"),
    [
        # LET defines what the operator makes copies of; one copy is the argument itself.
        (f"{TWICE}One == Twice(x + 1)", ["One ==(LET bound_1 ==(x + 1)IN Twice(bound_1))"]),
        ("Once(n) == n\nOne == Once(x + 1)", ["One == Once(x + 1)"]),
        # Names, numbers and strings are as short as a name that LET would give them.
        *((f"{TWICE}One == Twice({short})", [f"One == Twice({short})"]) for short in ("x", "x'", "7", '"7"', "TRUE")),
        # Apalache writes the body of a quantifier for each element; the set is one.
        ("Each(n) == \\A i \\in 1..3 : i < n\nOne == Each(x + 1)", ["LET bound_1 ==(x + 1)"]),
        ("Some(s) == \\E i \\in s : i > 0\nOne == Some({x, y})", ["One == Some({x, y})"]),
        # An operator may pass the argument on to one that makes copies.
        (
            f"{TWICE}Passes(n) == Twice(n)\nOne == Passes(x + 1)",
            ["Passes(n)== Twice(n)", "One ==(LET bound_1 ==(x + 1)IN Passes(bound_1))"],
        ),
        # What LET binds further inside stands there once.
        (
            f"{TWICE}Passes(n) == Twice(n + 1)\nOne == Passes(x + 1)",
            ["Passes(n)==(LET bound_1 ==(n + 1)IN Twice(bound_1))", "One == Passes(x + 1)"],
        ),
        # Applications in arguments are bound in turn, so the text does not grow with the depth.
        (
            f"{TWICE}One == Twice(Twice(x + 1))",
            ["(LET bound_1 ==((LET bound_2 ==(x + 1)IN Twice(bound_2)))IN Twice(bound_1))"],
        ),
        # Apalache puts no prime on what LET defines: the argument would be that of the state before the step.
        ("Twice(n) == <<n', n>>\nOne == Twice(x + y)", ["One == Twice(x + y)"]),
        ("Later(n) == n'\nTwice(n) == <<Later(n), n>>\nOne == Twice(x + y)", ["One == Twice(x + y)"]),
        # Apalache finds FALSE in an action behind a quantifier, and not in a LET.
        (
            f"{BECOMES}Adds == Becomes(x + 1)\nEither == Becomes(y) \\/ Adds",
            ["Adds ==(\\E bound_1 \\in{x + 1}: Becomes(bound_1))", "Either == Becomes(y)\\/ Adds"],
        ),
        # An operator that applies an action is one.
        (
            f"{BECOMES}Passes(n) == Becomes(n)\nAdds == Passes(x + 1)",
            ["Adds ==(\\E bound_1 \\in{x + 1}: Passes(bound_1))"],
        ),
        # An operator of a LET makes copies, too; one of an instance may have the name of one of the module.
        ("One == LET Twice(n) == n + n IN Twice(x + 1)", ["IN(LET bound_1 ==(x + 1)IN Twice(bound_1))"]),
        (
            f"{TWICE}Other == INSTANCE Small2 WITH z <- x\nOne == Other!Twice(x + 1, y)",
            ["One == Other!Twice(x + 1, y)"],
        ),
        # A change of one definition changes no name in another.
        (f"{TWICE}One == Twice(x + 1)\nTwo == Twice(x + 2)", ["Two ==(LET bound_1 ==(x + 2)"]),
    ],
)
def test_what_is_bound(definitions: str, texts: list[str]) -> None:
    """An argument is bound where copies of it would be made, and nowhere else."""
    made = bound(definitions)
    assert [text for text in texts if text not in made] == []


def test_tokens_stay_in_their_columns() -> None:
    """The bullets of a list stand below each other."""
    text = bind_arguments(
        "---- MODULE Small ----\nVARIABLE x\nTwice(n) == n + n\n"
        "One == /\\ Twice(x + 1) = 2\n       /\\ \\/ x = 3\n          \\/ x = 4\n====\n"
    )
    lines = text.splitlines()
    assert next(line for line in lines if "\\/ x = 3" in line).index("/\\") == 7
    assert next(line for line in lines if "\\/ x = 4" in line).index("\\/") == 10


def test_types_stay_above_their_operators() -> None:
    """Apalache reads the comment directly above a definition."""
    assert "\n\\* @type: Int => Int;\n" in bind_arguments(
        "---- MODULE Small ----\nVARIABLE x\n\\* @type: Int => Int;\nTwice(n) == n + n\nOne == Twice(x + 1)\n====\n"
    )


def test_a_text_that_the_grammar_cannot_read_is_an_error() -> None:
    """Nothing is made of half a module."""
    with pytest.raises(SyntaxTreeError):
        bind_arguments("---- MODULE Small ----\nOne == (\n====\n")

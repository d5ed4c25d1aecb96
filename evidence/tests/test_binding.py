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


def test_let_binds_an_argument_that_is_used_twice() -> None:
    """LET defines what the operator makes copies of."""
    assert "One ==(LET bound_1 ==(x + 1)IN Twice(bound_1))" in bound("Twice(n) == n + n\nOne == Twice(x + 1)")


def test_an_argument_that_is_used_once_stays() -> None:
    """One copy is the argument itself."""
    assert "One == Once(x + 1)" in bound("Once(n) == n\nOne == Once(x + 1)")


@pytest.mark.parametrize("argument", ["x", "x'", "7", '"seven"', "TRUE"])
def test_what_a_copy_costs_nothing_of_stays(argument: str) -> None:
    """Names, numbers and strings are as short as a name that LET would give them."""
    assert f"One == Twice({argument})" in bound(f"Twice(n) == <<n, n>>\nOne == Twice({argument})")


def test_what_is_looked_at_for_each_element_is_used_more_than_once() -> None:
    """Apalache writes the body of a quantifier for each element."""
    assert "LET bound_1 ==(x + 1)" in bound("Each(n) == \\A i \\in 1..3 : i < n\nOne == Each(x + 1)")


def test_the_set_of_a_quantifier_is_looked_at_once() -> None:
    """Its elements are many, the set is one."""
    assert "One == Some({x, y})" in bound("Some(s) == \\E i \\in s : i > 0\nOne == Some({x, y})")


def test_copies_are_counted_through_the_operators_that_an_argument_passes() -> None:
    """An operator may pass the argument on to one that makes copies."""
    text = bound("Twice(n) == n + n\nPasses(n) == Twice(n)\nOne == Passes(x + 1)")
    assert "Passes(n)== Twice(n)" in text
    assert "One ==(LET bound_1 ==(x + 1)IN Passes(bound_1))" in text


def test_an_argument_that_is_bound_inside_is_one_copy() -> None:
    """What LET binds further inside stands there once."""
    text = bound("Twice(n) == n + n\nPasses(n) == Twice(n + 1)\nOne == Passes(x + 1)")
    assert "Passes(n)==(LET bound_1 ==(n + 1)IN Twice(bound_1))" in text
    assert "One == Passes(x + 1)" in text


def test_applications_in_arguments_are_bound_in_turn() -> None:
    """So the text does not grow with the depth."""
    text = bound("Twice(n) == n + n\nOne == Twice(Twice(x + 1))")
    assert "(LET bound_1 ==((LET bound_2 ==(x + 1)IN Twice(bound_2)))IN Twice(bound_1))" in text


@pytest.mark.parametrize("within", ["Twice(n) == <<n', n>>", "Later(n) == n'\nTwice(n) == <<Later(n), n>>"])
def test_a_parameter_under_a_prime_is_not_bound(within: str) -> None:
    """Apalache puts no prime on what LET defines: the argument would be that of the state before the step."""
    assert "One == Twice(x + y)" in bound(f"{within}\nOne == Twice(x + y)")


def test_a_quantifier_binds_the_argument_of_an_action() -> None:
    """Apalache finds FALSE in an action behind a quantifier, and not in a LET."""
    text = bound("Becomes(n) == x' = n /\\ y' = n\nAdds == Becomes(x + 1)\nEither == Becomes(y) \\/ Adds")
    assert "Adds ==(\\E bound_1 \\in{x + 1}: Becomes(bound_1))" in text
    assert "Either == Becomes(y)\\/ Adds" in text


def test_an_operator_that_applies_an_action_is_one() -> None:
    """It is bound in the same way."""
    text = bound("Becomes(n) == x' = n /\\ y' = n\nPasses(n) == Becomes(n)\nAdds == Passes(x + 1)")
    assert "Adds ==(\\E bound_1 \\in{x + 1}: Passes(bound_1))" in text


def test_operators_of_a_let_are_known_in_it() -> None:
    """An operator of a LET makes copies, too."""
    text = bound("One == LET Twice(n) == n + n IN Twice(x + 1)")
    assert "IN(LET bound_1 ==(x + 1)IN Twice(bound_1))" in text


def test_an_operator_of_an_instance_is_another_one() -> None:
    """It may have the name of one of the module."""
    text = bound("Twice(n) == n + n\nOther == INSTANCE Small2 WITH z <- x\nOne == Other!Twice(x + 1, y)")
    assert "One == Other!Twice(x + 1, y)" in text


def test_each_definition_counts_its_own_names() -> None:
    """A change of one definition changes no name in another."""
    text = bound("Twice(n) == n + n\nOne == Twice(x + 1)\nTwo == Twice(x + 2)")
    assert "Two ==(LET bound_1 ==(x + 2)" in text


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

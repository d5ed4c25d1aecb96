"""What Apalache says is a proof only where nothing lacks."""

from __future__ import annotations

import pytest

from evidence.models.proofs.apalache import Answer, Late, interpret, late, settled
from evidence.tests.proofs.recorded import recorded


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
    """It is named as in a run of its formula alone; the answer is to the others, and all have to be named."""
    text = recorded("holds")
    more = text.replace("invariant Steps", "invariant Ind").replace("produced 5 ", "produced 2 ")
    output = more + text.replace("produced 5 ", "produced 3 ").replace("invariant 3 holds.", "invariant 3 => TIMEOUT.")
    assert late([text]) == []
    assert late([more, output.removeprefix(more)]) == [Late("Steps", "action invariant 1", 1)]
    assert interpret(output, 0, ["Ind", "Steps"]).outcome == "holds"
    assert interpret(output.replace("TIMEOUT", "UNKNOWN"), 0, ["Ind", "Steps"]).outcome == "nothing checked"
    states = output.replace("action invariant 0 holds.", "state invariant 0 holds.")
    with pytest.raises(AssertionError, match="formulas about states do not come first"):
        late([states])


def test_apalache_sorts_conditions_as_words() -> None:
    """Those of all formulas, by the number in their formula: 0, 0, 1, 1, 10, 11, 2, 2, as its source says."""
    made = "Producing verification conditions from the invariant {}\n VCGen produced {} verification condition(s)\n"
    said = "".join(f"State 1: state invariant {at} holds.\n" for at in range(15) if at not in (5, 6, 7))
    said += "".join(f"State 1: state invariant {at} => TIMEOUT.\n" for at in (5, 6, 7))
    output = made.format("Ind", 12) + made.format("InWorld", 3) + made.format("EndProp", 1) + said
    output += "State 0: action invariant 0 => TIMEOUT.\n"
    assert late([output]) == [
        Late("Ind", "state invariant 3", 0),  # its condition 11
        Late("Ind", "state invariant 4", 0),  # its condition 2
        Late("InWorld", "state invariant 2", 0),
        Late("EndProp", "action invariant 0", 0),
    ]


def test_a_condition_alone() -> None:
    """It holds where it does so as often as Apalache announced it, and no other was asked."""
    said = "State 0: Checking 1 action invariants\nState 0: action invariant 3 holds.\n"
    assert settled(said * 2, 0, "action invariant 3") == Answer("holds", 2, taken=2)
    for wrong in ("", said + said.replace("3", "2"), said.replace("Checking 1", "")):
        assert settled(wrong, 0, "action invariant 3").outcome == "nothing checked"
    assert settled(said.replace("holds", "=> TIMEOUT"), 0, "action invariant 3").outcome == "timeout"
    assert settled(recorded("violated"), 12, "action invariant 55").outcome == "violated"
    assert settled(said, 255, "action invariant 3").outcome == "failed"


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

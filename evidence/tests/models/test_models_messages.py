"""What is read out of TLC's -tool output, on short outputs written for it. No TLC is run."""

from __future__ import annotations

import pytest

from evidence.tla.messages import Counts, Outcome, Parser, interpret, progress


def message(code: int, text: str, level: int = 0) -> str:
    """Frame a text as TLC does."""
    return f"@!@!@STARTMSG {code}:{level} @!@!@\n{text}\n@!@!@ENDMSG {code} @!@!@\n"


STATS = message(2199, "1,234 states generated, 56 distinct states found, 0 states left on queue.") + message(
    2194, "The depth of the complete state graph search is 7."
)
END = message(2186, "Finished in 9ms at (...)")


def read(output: str, exit_code: int) -> Outcome:
    """Interpret a whole output."""
    parser = Parser()
    for line in output.splitlines(keepends=True):
        parser.feed(line)
    parser.finish()
    return interpret(parser, exit_code)


def test_success() -> None:
    """Success needs its message, the end, and exit 0; counts and version come with it."""
    outcome = read(message(2262, "TLC2 Version 2.18 of 20 March 2023") + message(2193, "done") + STATS + END, 0)
    assert outcome.kind == "passed"
    assert outcome.counts == Counts(1234, 56, 7)
    assert outcome.version == "2.18 of 20 March 2023"


@pytest.mark.parametrize(
    ("code", "text", "kind", "names"),
    [
        (2110, "Invariant Inv is violated.", "invariant", ("Inv",)),
        (2107, "Invariant Inv is violated by the initial state:\nx = 0", "invariant", ("Inv",)),
        (2112, "Action property Step is violated.", "action", ("Step",)),
        (2112, "Action property line 6, col 1 to line 6, col 2 of module A is violated.", "action", ()),
        (2108, "Property P is violated by the initial state:\nx = 0", "initial", ("P",)),
        (2116, "Temporal properties were violated.\n", "temporal", ()),
        (2116, "Temporal property Live was violated.\n", "temporal", ("Live",)),
        (2116, "Temporal properties A, B, and C were violated.\n", "temporal", ("A", "B", "C")),
        (2116, "Temporal properties A and B were violated.\n", "temporal", ("A", "B")),
        (2114, "Deadlock reached.", "deadlock", ()),
        (2104, "Assumption line 4, col 1 to line 4, col 9 of module A is false.", "assumption", None),
    ],
)
def test_violations(code: int, text: str, kind: str, names: tuple[str, ...] | None) -> None:
    """Each violation is told by its code, its property by its text; a location is no name but for an assumption."""
    outcome = read(message(code, text, 1) + message(2121, "The behavior up to this point is:", 1) + STATS + END, 12)
    assert outcome.kind == kind
    assert outcome.names == (("line 4, col 1 to line 4, col 9 of module A",) if names is None else names)


VIOLATED = message(2110, "Invariant Inv is violated.", 1)
SUCCESS = message(2193, "done")


@pytest.mark.parametrize(
    ("output", "exit_code", "kind"),
    [
        pytest.param("", 0, "broken", id="no message of success"),
        pytest.param(STATS + END, 0, "broken", id="all but the message of success"),
        pytest.param(SUCCESS + STATS, 0, "broken", id="cut off after it"),
        pytest.param(SUCCESS + END, 1, "broken", id="success with another exit code"),
        pytest.param(VIOLATED + message(2103, "nested", 1) + END, 12, "broken", id="an error beside a violation"),
        pytest.param(message(2113, "P failed.", 1) + END, 13, "broken", id="an error with the exit code of a property"),
        pytest.param(message(2105, "A failed.", 1) + END, 10, "broken", id="an error with that of an assumption"),
        pytest.param(message(2116, "Temporal properties were violated.", 1), 1, "broken", id="a crash meanwhile"),
        pytest.param(message(2255, "a formula", 3) + SUCCESS + END, 0, "passed", id="a warning changes nothing"),
    ],
)
def test_kind(output: str, exit_code: int, kind: str) -> None:
    """Message and exit code have to agree, and an error is never a violation."""
    assert read(output, exit_code).kind == kind


def test_nested_messages() -> None:
    """The frame of an error inside another error's text is read as a message of its own."""
    inner = message(2132, "Assert: boo")
    outcome = read(f"@!@!@STARTMSG 2111:1 @!@!@\nEvaluating invariant I failed.\n{inner}\n@!@!@ENDMSG 2111 @!@!@\n", 76)
    assert outcome.kind == "broken"
    assert outcome.detail == "error 2111: Evaluating invariant I failed."


def test_trace_and_cut_off_output() -> None:
    """States of the trace are kept as printed, also the lasso's end and one cut off by a kill."""
    output = message(2116, "Temporal properties were violated.", 1) + message(2217, "1: <Initial>\nx = 0\n", 4)
    output += message(2122, "1: Back to state", 4) + "@!@!@STARTMSG 2217:4 @!@!@\n2: cut"
    assert read(output, 13).trace == ("1: <Initial>\nx = 0", "1: Back to state", "2: cut")


def test_initial_state_is_a_trace() -> None:
    """A violation in an initial state shows that state."""
    assert read(message(2107, "Invariant I is violated by the initial state:\nx = 0\n", 1) + END, 12).trace == (
        "x = 0",
    )


def test_parser_errors_are_kept() -> None:
    """What the parser says outside any message is among the errors, its progress lines are not."""
    output = "Parsing file A.tla\n***Parse Error***\nWas expecting x\n" + message(3002, "Parsing failed.", 1)
    outcome = read(output, 150)
    assert outcome.kind == "broken"
    assert outcome.errors == ("Parsing failed.", "***Parse Error***\nWas expecting x")


def test_progress() -> None:
    """A progress line is read out of both forms of its message."""
    parser = Parser()
    text = "Progress(5) at 2026: 1,200 states generated (8 s/min), 90 distinct states found (6 ds/min), 1 states left."
    done = [m for line in message(2200, text).splitlines() for m in parser.feed(line)]
    assert [progress(m) for m in done] == ["1,200 generated, 90 distinct"]

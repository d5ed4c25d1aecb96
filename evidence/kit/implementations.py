"""kit/implementations.ndjson: the outcomes of the kit on the implementations that the project runs it on.

``python -m evidence.kit.implementations NAME=FILE...`` keeps the outcomes of results of ``s7check kit run``, a line for
each requirement: the state by implementation, and of a failure the first programs that show it.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec

from evidence.common.checkout import ROOT
from evidence.kit.files import Json, read_lines, write_lines
from s7check.kit.matrix import SHOWN, to_matrix
from s7check.kit.results import UNDER_ANOTHER, Kept, Outcome

KEPT = ROOT / "kit" / "implementations.ndjson"


def keep(results: Mapping[str, Sequence[Outcome]]) -> None:
    """Keep what the page shows of the outcomes by implementation. Raises OSError."""
    lines: dict[str, Json] = {}
    for name, outcomes in results.items():
        for one in outcomes:
            line = lines.setdefault(one.requirement, {"requirement": one.requirement})
            # One program more than the page names: it says that there are others.
            shown = {"failed": one.failed[: SHOWN + 1]} if one.failed else {"under": one.under[: SHOWN + 1]}
            line[name] = shown if any(shown.values()) else one.state
    write_lines(KEPT, lines.values())


def kit_results() -> str:
    """The page of the outcomes that are kept. Raises OSError, ValueError."""
    outcomes: dict[str, list[Outcome]] = {}
    for line in read_lines(KEPT):
        requirement = line.pop("requirement")
        for name, state in line.items():
            kind = "failed" if "failed" in state else UNDER_ANOTHER
            said = {"state": state} if isinstance(state, str) else {"state": kind, **state}
            outcomes.setdefault(name, []).append(msgspec.convert({"requirement": requirement, **said}, Outcome))
    return to_matrix(outcomes)


def main(runs: Sequence[str]) -> None:
    """Keep the results that the arguments name."""
    files = dict(run.split("=", 1) for run in runs)
    keep({name: msgspec.json.decode(Path(file).read_bytes(), type=Kept).requirements for name, file in files.items()})


if __name__ == "__main__":
    main(sys.argv[1:])

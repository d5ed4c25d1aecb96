"""``s7spec kit reached``: which rules of the specification does the kit reach?"""

from __future__ import annotations

from pathlib import Path

import click

from evidence.common import reasons
from evidence.common.cases import all_cases
from evidence.common.checkout import ROOT
from evidence.common.console import plain
from evidence.common.options import json_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.kit import measured
from evidence.kit.reached import reach, shown_by_logs
from evidence.kit.reached_findings import as_json, as_text, findings
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.kit.adapter import AdapterError
from s7check.kit.collection import UnreadableProgramError, programs_of

REASONS = ROOT / "kit" / "not_observable.json"
LESS = 1


@click.command(name="reached", short_help="Which rules of the specification does the kit reach?")
@json_option
@click.option("--write", is_flag=True, help="Keep what each program of the kit reaches.")
def reached_command(json_path: Path | None, *, write: bool) -> int:
    """Run the kit on the soft PLC, with each of its options and choices, and on the specification by other readings.

    Counted are the outcomes of the conditions in the actions of spec/, without those of which kit/not_observable.json
    says why no log shows them, and the requirements that at least two programs reach.
    """
    usage = (reasons.ReasonsError, UnreadableProgramError, OSError)
    with session(Processes(), usage, (AdapterError, EngineError)) as console:
        why = reasons.read(REASONS, reasons.Excuse)
        with Engine() as engine:
            origin, programs = measured.origin(), programs_of()
            reached = reach(programs, engine, lambda line: plain(console, line))
            shown = shown_by_logs(all_cases(), engine, reached)
        found = findings(reached, shown, why)
        for line in as_text(found):
            plain(console, line)
        if write:
            measured.write(origin, [program.name for program in programs], reached.by_program())
        write_json(json_path, as_json(found))
    return 0 if found.ok else LESS

"""``s7spec logs growth``: does a log cost more than its length, whatever is in it?"""

from __future__ import annotations

import sys
from dataclasses import asdict
from pathlib import Path

import click

from evidence.common.console import plain
from evidence.common.options import json_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.logs.growth_costs import Cost, cost_of
from evidence.logs.growth_logs import Kind, kinds

STEEP = 1
TIMES, TIMES_LONG = 10, 20
"""How much more CPU than ten lines a log may take, and one of 10,000 lines."""
MEMORY = 300
"""MB."""


@click.command(name="growth", short_help="Does a log cost more than its length, whatever is in it?")
@click.argument("names", nargs=-1)
@click.option("--limit", type=float, default=60, show_default=True, help="Seconds that a log may take.")
@click.option("--little", is_flag=True, help="Logs as small as in the tests.")
@json_option
def growth_command(names: tuple[str, ...], limit: float, little: bool, json_path: Path | None) -> None:
    """Measure logs that leave much open: those whose name has one of NAMES, or all.

    A log may take ten times the CPU of ten lines, one of 10,000 lines twenty times, and 300 MB.
    """
    steep = 0
    costs: list[Cost] = []
    with session(Processes(), (OSError,), ()) as console:
        smallest, *others = kinds()
        usual = cost_of(smallest, 1, limit)
        for kind in (kind for kind in others if not names or any(name in kind.name for name in names)):
            cost = cost_of(kind, kind.little if little else kind.large, limit)
            costs.append(cost)
            fault = _fault(kind, cost, usual)
            steep += bool(fault)
            plain(console, f"{_line(cost)}  {fault}".rstrip(), style="red" if fault else "")
        write_json(json_path, {"usual": asdict(usual), "costs": [asdict(cost) for cost in costs], "steep": steep})
    sys.exit(STEEP if steep else 0)


def _line(cost: Cost) -> str:
    return (
        f"{cost.kind}: {cost.lines:,} lines, {cost.verdict}, {cost.cpu} s, {cost.memory} MB, "
        f"{cost.largest:,} states at a time, {cost.followed:,} steps"
    )


def _fault(kind: Kind, cost: Cost, usual: Cost) -> str:
    if cost.verdict != ("rejected" if kind.rejected else "accepted"):
        return cost.message or "no verdict"
    if cost.cpu > usual.cpu * (TIMES_LONG if kind.long else TIMES):
        return f"{cost.cpu / usual.cpu:.0f} times ten lines"
    return f"more than {MEMORY} MB" if cost.memory > MEMORY else ""

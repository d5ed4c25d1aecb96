"""``s7spec logs edges``: the lines that the explorer offers beside the edges of graphs that TLC exports."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from evidence.common.console import plain
from evidence.common.options import json_option, tlc_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.logs.explored import Compared, Comparison
from evidence.logs.graph import WORLDS, Graph, NotExportedError, exported
from evidence.tla.tlc import ToolMissingError, find_toolchain
from s7check.engine.client import Engine
from s7check.engine.command import EngineError

DIFFERS = 1
_LONGEST = 600.0
_TOLD = 3


@click.command(name="edges", short_help="The explorer's steps beside the edges of graphs that TLC exports.")
@tlc_option
@json_option
@click.argument("names", nargs=-1, metavar="[WORLD]...", type=click.Choice(list(WORLDS)))
def edges_command(jar: Path | None, json_path: Path | None, names: tuple[str, ...]) -> int:
    """Export the graph of each world, and compare what follows each log of it.

    A log stands for all states of the graph in which the CPU may be after it. Every edge of these that a log shows has
    to be offered, at its time, and no other line of the graph that changes anything.
    """
    rows: list[dict[str, Any]] = []
    processes = Processes()
    with session(processes, (ValueError, OSError), (ToolMissingError, EngineError, NotExportedError)) as console:
        tools = find_toolchain(jar)
        for name in names or WORLDS:
            graph = exported(WORLDS[name], tools, processes, _LONGEST)
            with Engine() as engine:
                found = Comparison(engine, graph).run()
            rows.append(_row(name, graph, found))
            plain(console, ", ".join(f"{key} {value}" for key, value in rows[-1].items()))
            for title, logs in (("not offered", found.missing), ("offered, no edge", found.more)):
                for log in sorted(logs, key=len)[:_TOLD]:
                    plain(console, f"{title}:\n{log}\n")
        write_json(json_path, {"worlds": rows})
    return DIFFERS if any(row["not offered"] or row["offered, no edge"] for row in rows) else 0


def _row(name: str, graph: Graph, found: Compared) -> dict[str, Any]:
    return {
        "world": name,
        "model": WORLDS[name].model,
        "states": len(graph.at),
        "edges": graph.edges,
        "compared": len(found.edges),
        "logs": found.logs,
        "questions": found.questions,
        "not offered": len(found.missing),
        "before what is due": found.early,
        "offered, no edge": len(found.more),
    }

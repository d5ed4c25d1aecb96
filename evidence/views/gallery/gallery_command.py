"""``s7spec views gallery``: the edge cases, found by TLC, judged by the trace checker."""

from __future__ import annotations

import json
from pathlib import Path

import click

from evidence.common.console import plain
from evidence.common.gallery import CASES, LOGS, Case, cases, replace_log, write
from evidence.common.options import tlc_option
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.common.shorthand import shorthand
from evidence.tla.tlc import ToolMissingError, find_toolchain
from evidence.views.gallery.search import NotFoundError, Search
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.check import check_log

DIFFERS = 1


@click.command(name="gallery", short_help="Edge cases, each the shortest behaviour that TLC finds.")
@tlc_option
@click.option("--write", "renew", is_flag=True, help="Write the logs.")
@click.argument("names", nargs=-1, metavar="[NAME]...")
def gallery_command(jar: Path | None, renew: bool, names: tuple[str, ...]) -> int:
    """Find each case again and compare it with its log in gallery/cases.txt.

    Of several behaviours of the same length TLC finds the first in its order, which is fixed; so a difference means
    that the specification or the case has changed.
    """
    wrong: set[str] = set()
    processes = Processes()
    with session(processes, (ValueError, OSError), (ToolMissingError, EngineError)) as console, Engine() as engine:
        search = Search(find_toolchain(jar), processes)
        chosen = _chosen(names)
        write()
        for case in chosen:
            said = _settled(case, search, renew) or _refused(case, engine)
            if said:
                wrong.add(case.name)
            plain(console, f"{case.name}: {said or 'found, accepted'}")
        plain(console, f"{len(chosen)} cases, {len(wrong)} not as they should be")
    return DIFFERS if wrong else 0


def _refused(case: Case, engine: Engine) -> str:
    """Why the trace checker does not accept the log; empty if it does."""
    report = check_log(str(LOGS / f"{case.name}.ndjson"), engine, lambda *_: None)
    return "" if report.verdict == "accepted" else str(report)


def _chosen(names: tuple[str, ...]) -> list[Case]:
    """Raises ValueError for a name that is none."""
    found = {case.name: case for case in cases()}
    if unknown := [name for name in names if name not in found]:
        raise ValueError(f"no such case: {', '.join(unknown)}")
    return [found[name] for name in names] if names else list(found.values())


def _settled(case: Case, search: Search, renew: bool) -> str:
    """Why the log is not what TLC finds; empty if it is. With ``renew`` it is made so."""
    try:
        short = shorthand(search(case))
    except NotFoundError as error:
        return str(error)
    if shorthand([json.loads(line) for line in case.log.splitlines()]) == short:
        return ""
    if not renew:
        return f"TLC finds another behaviour than {CASES.name}"
    replace_log(case.name, short)
    write()
    return ""

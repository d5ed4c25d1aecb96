"""``s7spec views gallery``: the edge cases, found by TLC, judged by the trace checker."""

from __future__ import annotations

from pathlib import Path

import click
import msgspec

from evidence.common.checkout import ROOT
from evidence.common.console import plain
from evidence.common.options import tlc_option
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.tla.tlc import ToolMissingError, find_toolchain
from evidence.views.gallery.cases import Case, cases
from evidence.views.gallery.search import NotFoundError, Search
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.check import check_log

DIFFERS = 1


@click.command(name="gallery", short_help="Edge cases, each the shortest behaviour that TLC finds.")
@tlc_option
@click.option("--write", is_flag=True, help="Write the logs.")
@click.argument("names", nargs=-1, metavar="[NAME]...")
def gallery_command(jar: Path | None, write: bool, names: tuple[str, ...]) -> int:
    """Find each case again and compare it with its log in gallery/.

    Of several behaviours of the same length TLC finds the first in its order, which is fixed; so a difference means
    that the specification or the case has changed.
    """
    wrong: set[str] = set()
    processes = Processes()
    with session(processes, (ValueError, OSError), (ToolMissingError, EngineError)) as console, Engine() as engine:
        search = Search(find_toolchain(jar), processes)
        chosen = _chosen(names)
        for case in chosen:
            said = _settled(case, search, write) or _refused(case, engine)
            if said:
                wrong.add(case.name)
            plain(console, f"{case.name}: {said or 'found, accepted'}")
        plain(console, f"{len(chosen)} cases, {len(wrong)} not as they should be")
    return DIFFERS if wrong else 0


def _refused(case: Case, engine: Engine) -> str:
    """Why the trace checker does not accept the log; empty if it does."""
    report = check_log(str(case.log), engine, lambda *_: None)
    return "" if report.verdict == "accepted" else str(report)


def _chosen(names: tuple[str, ...]) -> list[Case]:
    """Raises ValueError for a name that is none."""
    found = {case.name: case for case in cases()}
    if unknown := [name for name in names if name not in found]:
        raise ValueError(f"no such case: {', '.join(unknown)}")
    return [found[name] for name in names] if names else list(found.values())


def _text(lines: list[dict[str, object]]) -> str:
    return "".join(msgspec.json.encode(line).decode() + "\n" for line in lines)


def _settled(case: Case, search: Search, write: bool) -> str:
    """Why the log is not what TLC finds; empty if it is. With ``write`` it is made so."""
    try:
        text = _text(search(case))
    except NotFoundError as error:
        return str(error)
    if write:
        case.log.write_text(text)
    elif not case.log.exists() or case.log.read_text() != text:
        return f"TLC finds another behaviour than {case.log.relative_to(ROOT)}"
    return ""

"""``s7spec since``: the same verdicts and pins as at an earlier revision?"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import click

from evidence.common.cases import CasesError
from evidence.common.checkout import ROOT, SOFT_PLC_PROGRAM
from evidence.common.options import json_option, write_json
from evidence.common.processes import Processes
from evidence.common.reasons import Excuse, ReasonsError, assign, read
from evidence.common.session import session
from evidence.logs import pins
from evidence.logs import since as compare
from evidence.logs import since_report as report
from evidence.logs.random_logs import Generator, SoftPlcError
from evidence.logs.revision import BuildError, Checkout, RevisionError, checkout, find
from evidence.logs.since_judging import judge
from evidence.tla import log_as_tla
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.log.errors import UnusableLogError

DIFFERENT = 1


@click.command(name="since", short_help="Same verdicts and pins as at an earlier revision?")
@click.option("--logs", type=click.IntRange(0), default=200, show_default=True, help="How many random logs.")
@click.option("--seed", type=int, default=1, show_default=True, help="Other random logs.")
@click.option(
    "--expected",
    type=click.Path(path_type=Path, dir_okay=False, exists=True),
    help="Differences that are wanted: a JSON list of {id, reason}; an id may be a glob.",
)
@json_option
@click.argument("revision", metavar="REV")
def since_command(revision: str, logs: int, seed: int, expected: Path | None, json_path: Path | None) -> None:
    """Compare this checkout with revision REV: verdict and line of every log, pins of every model, reasons.

    REV is built below build/since, which takes minutes the first time. Both judge the logs of their cases and the same
    random ones.
    """
    usage = (RevisionError, CasesError, pins.PinsError, ReasonsError, OSError)
    with session(Processes(), usage, (BuildError, SoftPlcError, EngineError)) as console:
        commit = find(ROOT, revision)
        excuses = read(expected, Excuse) if expected else []
        click.echo(f"building {commit[:12]}")
        before, now = checkout(ROOT, commit), Checkout(ROOT)
        comparisons = _shipped(before, now, click.echo)
        if logs:
            comparisons.append(_random(before, now, logs, seed, click.echo))
        comparisons += _pins(before, now)
        ids = [one.id for comparison in comparisons for one in comparison.differences]
        explained = report.Explained(commit, comparisons, *assign(excuses, ids, ids, ids)[:2])
        report.show(console, explained)
        write_json(json_path, report.as_json(explained))
    sys.exit(0 if explained.ok else DIFFERENT)


def _shipped(before: Checkout, now: Checkout, tell: Callable[[str], None]) -> list[compare.Comparison]:
    """Every log of a case has to get a verdict: two checkers that fail alike are no evidence."""
    with tempfile.TemporaryDirectory(prefix="s7check-since-") as temporary:
        old, new = _logs(before, Path(temporary) / "before"), _logs(now, Path(temporary) / "now")
        tell(f"judging the logs of {len(old.cases)} and {len(new.cases)} cases")
        names = compare.renamed(old.content, new.content)
        found = compare.logs("logs of cases", "log", judge(before, old.files), judge(now, new.files), names)
    found.differences += found.undecided
    return [compare.cases(old, new, names), found]


def _logs(checkout: Checkout, folder: Path) -> compare.Logs:
    """The logs of a checkout, written to a folder and read by this one."""
    cases = {case.id: case for case in checkout.cases()}
    files = {name: case.put(folder) for name, case in cases.items()}
    return compare.Logs(cases, files, {name: _content(file) for name, file in files.items()})


def _content(file: Path) -> compare.Content:
    """Of a log that cannot be read, the line."""
    try:
        header, events = log_as_tla.read(file)
    except UnusableLogError as error:
        return (f"line {error.line} cannot be read",)
    return header, *events


def _random(before: Checkout, now: Checkout, logs: int, seed: int, tell: Callable[[str], None]) -> compare.Comparison:
    """A random log may have more explanations than the checkers follow; it then has no verdict, which is noted."""
    tell(f"judging {logs} random logs")
    with Engine() as engine:
        generator = Generator(seed, SOFT_PLC_PROGRAM, engine.alternatives())
    with tempfile.TemporaryDirectory(prefix="s7check-since-") as temporary:
        files = {str(number): Path(temporary) / f"{number}.ndjson" for number in range(1, logs + 1)}
        for number, file in files.items():
            file.write_bytes(generator.draw(int(number), 0).content)
        earlier, judged = judge(before, files), judge(now, files)
    found = compare.logs("random logs", "random", earlier, judged, {name: name for name in files})
    if len(found.undecided) == logs:
        raise BuildError(f"no random log gets a verdict: {found.undecided[0].text}")
    found.notes += [f"{one.id}: {one.text}" for one in found.undecided]
    return found


def _pins(before: Checkout, now: Checkout) -> list[compare.Comparison]:
    found = [compare.pins(pins.pinned(before), pins.pinned(now))]
    for kind, title in (("survivor", "reasons of mutants that survive"), ("witness", "reasons for no witness")):
        found.append(compare.reasons(title, kind, pins.reasons(before, kind), pins.reasons(now, kind)))
    return found

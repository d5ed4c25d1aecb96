"""Judges the logs of all situations and compares with the verdicts that their writer expects.

``python -m tests.by_hand.situations.judge`` does it; exit code 1 says that some differ.
"""

import importlib
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import cache
from pathlib import Path

import click

from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.judging.verdict import Report
from tests.by_hand.situations.builder import Case, cases

MODULES = (
    "tod",
    "delay",
    "blocking",
    "modes",
    "clock",
    "contract",
    "combined",
    "subsets",
    "edges",
    "letters",
    "positions",
    "windows",
)
"""In this order: ``subsets`` draws from the modules before it."""


@cache
def all_cases() -> list[tuple[str, Case]]:
    """The logs with their names."""
    for module in MODULES:
        importlib.import_module(f"tests.by_hand.situations.{module}")
    return list(cases())


def differences(
    named: Iterable[tuple[str, Case]], judge: Callable[[Path], Report], folder: Path
) -> list[tuple[str, Case, Report]]:
    """The logs whose verdict or line is not the expected one. Logs are written to ``folder``."""
    found = []
    file = folder / "log.ndjson"
    for name, case in named:
        file.write_text(case.text(), encoding="utf-8", newline="")
        report = judge(file)
        if (report.verdict, report.line) != case.expected:
            found.append((name, case, report))
    return found


def letters_with_effect(
    named: Iterable[tuple[str, Case]], judge: Callable[[Path], Report], folder: Path
) -> set[tuple[str, str]]:
    """The letters of readings without which a log that names them gets another verdict or line."""
    effective = set[tuple[str, str]]()
    for name, case in named:
        header = case.lines[0] if case.lines else ""
        if isinstance(header, str) or case.verdict == "unusable":
            continue
        readings = header.get("readings", {})
        for letter in [letter for letter in readings.items() if letter not in effective]:
            fewer = {ambiguity: chosen for ambiguity, chosen in readings.items() if ambiguity != letter[0]}
            without = replace(case, lines=({**header, "readings": fewer}, *case.lines[1:]))
            if differences([(name, without)], judge, folder):
                effective.add(letter)
    return effective


@click.command()
@click.option("--write", type=click.Path(path_type=Path, file_okay=False), help="Write the logs there and judge none.")
def main(write: Path | None) -> None:
    """Judge the logs of all situations."""
    named = all_cases()
    if write is not None:
        write.mkdir(parents=True, exist_ok=True)
        for name, case in named:
            (write / f"{name}.ndjson").write_text(case.text(), encoding="utf-8", newline="")
        return
    with tempfile.TemporaryDirectory() as folder, Engine() as engine:
        found = differences(named, lambda log: check_log(str(log), engine, lambda _, __: None), Path(folder))
    for name, case, report in found:
        wanted = case.verdict if case.line is None else f"{case.verdict} at line {case.line}"
        click.echo(f"{name}: {wanted} expected, {report.verdict} at {report.line}: {case.requirement}: {case.why}")
    verdicts = Counter(case.verdict for _, case in named)
    click.echo(
        f"{len(named)} logs of {len({case.situation for _, case in named})} situations ("
        + ", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items()))
        + f"), {len(found)} differ"
    )
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()

"""``s7check differences``."""

from __future__ import annotations

import click

from evidence.differences.kept import DIFFERENCES, EXPERIMENTS, read_kept, write_kept
from evidence.differences.pages import RULES, differences_page, experiments_page, verified, write_sources
from evidence.differences.search import differences, experiments
from s7check.engine.client import Engine
from s7check.kit.collection import programs_of


@click.command("differences", short_help="Differences between CPUs, editions and readings, found by search.")
@click.option("--search", is_flag=True, help="Search the programs of the kit anew; takes hours.")
@click.option("--write", is_flag=True, help="Write the pages docs/rules/differences.md and experiments.md.")
def differences_command(search: bool, write: bool) -> int:
    """Run each program that is kept on both sides, and say how many still tell them apart.

    Exit codes: 0 all of them, 1 one does not, 2 wrong arguments, 3 the specification could not be evaluated.
    """
    with Engine() as engine:
        if search:
            programs = programs_of()
            write_kept(DIFFERENCES, verified(engine, list(differences(engine, programs, click.echo))))
            write_kept(EXPERIMENTS, verified(engine, list(experiments(engine, programs, click.echo))))
        kept = {file: read_kept(file) for file in (DIFFERENCES, EXPERIMENTS)}
        code = 0
        for file, all_kept in kept.items():
            right = list(verified(engine, all_kept))
            click.echo(f"{file.name}: {len(right)} of {len(all_kept)} tell their sides apart")
            code = max(code, int(len(right) < len(all_kept)))
        if write:
            (RULES / "differences.md").write_text(differences_page(engine, kept[DIFFERENCES]), encoding="utf-8")
            (RULES / "experiments.md").write_text(experiments_page(engine, kept[EXPERIMENTS]), encoding="utf-8")
            write_sources(kept[EXPERIMENTS])
    return code

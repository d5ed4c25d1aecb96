"""``s7spec views differences``."""

from __future__ import annotations

import click

from evidence.views.differences.pages import untold, verified
from evidence.views.differences.search import differences, experiments
from evidence.views.differences.shorter import SHORTEST, filled, shorter, shortest_of_sides
from s7check.engine.client import Engine
from s7check.kit.collection import programs_of
from s7check.simulating.kept import DIFFERENCES, EXPERIMENTS, GAPS, Kept, read_kept, write_kept


@click.command("differences", short_help="Differences between CPUs, editions and readings, found by search.")
@click.option("--search", is_flag=True, help="Search the programs of the kit anew; takes hours.")
@click.option("--shorten", is_flag=True, help="Search for shorter logs, and for letters without one; takes an hour.")
def differences_command(search: bool, shorten: bool) -> int:
    """Run each program that is kept on both sides, and say how many still tell them apart."""
    with Engine() as engine:
        if search:
            programs = programs_of()
            write_kept(DIFFERENCES, verified(engine, list(differences(engine, programs, click.echo))))
            write_kept(EXPERIMENTS, verified(engine, list(experiments(engine, programs, click.echo))))
        if search or shorten:
            _shorten(engine)
        code = 0
        for file in (DIFFERENCES, EXPERIMENTS):
            all_kept = read_kept(file)
            right = list(verified(engine, all_kept))
            click.echo(f"{file.name}: {len(right)} of {len(all_kept)} tell their sides apart")
            code = max(code, int(len(right) < len(all_kept)))
    return code


def _by_letters(one: Kept) -> tuple[str, list[str]]:
    (ambiguity, first), (_, second) = one.allowed.letters[0], one.refused.letters[0]
    return ambiguity, sorted((first, second))


def _shorten(engine: Engine) -> None:
    """Keep the shortest logs that are found, and what was searched."""
    of_kit = [one for one in read_kept(DIFFERENCES) if not one.name.startswith(SHORTEST)]
    write_kept(DIFFERENCES, [*shortest_of_sides(engine, of_kit, click.echo), *of_kit])
    known = list(shorter(engine, read_kept(EXPERIMENTS), click.echo))
    more, gaps = filled(engine, known, untold(known), click.echo)
    write_kept(EXPERIMENTS, sorted([*known, *more], key=_by_letters))
    write_kept(GAPS, gaps)

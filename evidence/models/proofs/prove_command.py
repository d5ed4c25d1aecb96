"""``s7spec prove``: ask Apalache for the proofs about System, and compare each answer with the claim."""

from __future__ import annotations

import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import click
import msgspec
from rich.console import Console

from evidence.common.checkout import ROOT
from evidence.common.options import json_option, shard_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.models.proofs import report
from evidence.models.proofs.apalache import Apalache, ApalacheMissingError, find_apalache
from evidence.models.proofs.kept import KeptAnswers, Result
from evidence.models.proofs.making import Query
from evidence.models.proofs.manifest import ManifestError
from evidence.models.proofs.queries import load
from evidence.models.proofs.runner import Asking, Kept, ask, ok
from evidence.tla.syntax import SyntaxTreeError

DIFFERENT = 1
BUILD = Path("build/proofs")
SMALL = Path("build/proofs-small")
KEPT = Path("models/proved.ndjson")
"""The answers from the whole world; those of --small stay in their folder."""


@click.command(name="prove", short_help="Prove properties of the specification with Apalache.")
@click.option("--list", "listing", is_flag=True, help="Name the queries and ask nothing.")
@shard_option
@click.option("--resume", is_flag=True, help="Take kept answers that are as claimed, and ask for the others.")
@click.option("--kept", "only_kept", is_flag=True, help="Report the kept answers and ask nothing.")
@click.option("--small", is_flag=True, help="Begin steps in the small world of the controls: less is proved, sooner.")
@click.option(
    "--jobs",
    type=click.IntRange(1),
    default=1,
    show_default=True,
    help="Queries at a time: a core and up to 6 GB each.",
)
@json_option
@click.argument("names", nargs=-1, metavar="[NAME]...")
def prove_command(
    *,
    listing: bool,
    shard: tuple[int, int],
    resume: bool,
    only_kept: bool,
    small: bool,
    jobs: int,
    json_path: Path | None,
    names: tuple[str, ...],
) -> None:
    """Ask Apalache the queries of models/proofs.json.

    NAME picks queries or actions of System (globs work). The answers are kept in models/proved.ndjson, those of --small
    in build/proofs-small.
    """
    processes = Processes()
    refused = (ManifestError, SyntaxTreeError, OSError, msgspec.MsgspecError)
    with session(processes, refused, (ApalacheMissingError,)) as console:
        proofs = load(ROOT).in_small_world() if small else load(ROOT)
        queries = proofs.select(names)[shard[0] - 1 :: shard[1]]
        if listing:
            for query in queries:
                click.echo(f"{query.name}: {query.kind}, {query.expect}, {len(query.formulas)} formulas")
            return
        kept: Kept = "all" if only_kept else "claimed" if resume else "nothing"
        with Apalache([] if only_kept else find_apalache(), processes) as program:
            build = ROOT / (SMALL if small else BUILD)
            build.mkdir(parents=True, exist_ok=True)
            asking = Asking(ROOT, build, KeptAnswers(build / KEPT.name if small else ROOT / KEPT), program)
            answers = _ask_all(asking, queries, kept, jobs, console, processes)
        write_json(json_path, report.as_json(proofs, answers))
        report.show(console, proofs, answers)
        sys.exit(0 if answers and all(ok(query, result) for query, result in answers) else DIFFERENT)


def _ask_all(
    asking: Asking, queries: list[Query], kept: Kept, jobs: int, console: Console, processes: Processes
) -> list[tuple[Query, Result]]:
    """Ask queries, `jobs` at a time, and return the answers in their order. What ends this early ends Apalache too."""
    with ThreadPoolExecutor(jobs) as pool:
        try:
            return list(pool.map(lambda query: _ask(asking, query, kept, console), queries))
        except BaseException:
            processes.close()
            pool.shutdown(cancel_futures=True)
            raise


def _ask(asking: Asking, query: Query, kept: Kept, console: Console) -> tuple[Query, Result]:
    result = ask(asking, query, kept)
    outcome = result.answer.outcome
    word = "as claimed" if ok(query, result) else f"NOT AS CLAIMED (claimed: {query.expect})"
    said = f"{query.name}: {outcome}, {word}, {result.answer.checked} conditions, {result.seconds:.0f} s"
    said = f"{query.name}: {outcome}" if outcome == "not asked" else said
    console.print(said + (", kept" if result.kept else ""), markup=False, highlight=False, soft_wrap=True)
    return query, result

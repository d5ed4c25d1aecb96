"""The command ``s7spec``."""

from pathlib import Path

import click

from evidence.common.checkout import ROOT
from s7check.program import Commands, run

COMMANDS = {
    "models": "evidence.models.models_command:models_command",
    "prove": "evidence.models.proofs.prove_command:prove_command",
    "mutants": "evidence.mutants.mutants_command:mutants_command",
    "witnesses": "evidence.mutants.witnesses_command:witnesses_command",
    "since": "evidence.logs.since_command:since_command",
    "verify": "evidence.verify:verify_command",
}
LOGS = {
    "agree": "evidence.logs.agree_command:agree_command",
    "edges": "evidence.logs.edges_command:edges_command",
    "engines": "evidence.logs.engines_command:engines_command",
    "growth": "evidence.logs.growth_command:growth_command",
    "left-out": "evidence.logs.left_out_command:left_out_command",
}
KIT = {
    "paths": "evidence.kit.paths_command:paths_command",
    "reached": "evidence.kit.reached_command:reached_command",
    "faults": "evidence.kit.faults_command:faults_command",
}
VIEWS = {
    "make": "evidence.views.views_command:make_command",
    "requirements": "evidence.views.traceability.requirements_command:requirements_command",
    "results": "evidence.views.results.results_command:results_command",
    "gallery": "evidence.views.gallery.gallery_command:gallery_command",
    "differences": "evidence.views.differences.differences_command:differences_command",
    "cases": "evidence.views.cases:cases_command",
    "vectors": "evidence.views.vectors:vectors_command",
    "site": "evidence.views.site.site_command:site_command",
}


def check_folder(folder: Path) -> None:
    """The tools read the files of ROOT. Raises `ClickException` for a folder in another checkout, or in none."""
    here = folder.resolve()
    around = next((f for f in (here, *here.parents) if (f / Path(__file__).relative_to(ROOT)).is_file()), None)
    if around != ROOT:
        place = f"in the checkout {around}" if around else "in no checkout"
        raise click.ClickException(
            f"{here} is {place}, but this s7spec checks {ROOT}: go there, or run another checkout's .venv/bin/s7spec"
        )


@click.group(cls=Commands, places=COMMANDS, context_settings={"help_option_names": ["-h", "--help"]})
def cli() -> None:
    """Check the specification itself: models, proofs, mutants, logs, kit and pages.

    s7spec works on the checkout around the current folder. Exit codes of every command: 0 as expected, 1 not, 2 wrong
    arguments or files, 3 a tool is missing or failed, 130 interrupted.
    """
    check_folder(Path.cwd())


@cli.group(cls=Commands, places=LOGS)
def logs() -> None:
    """Do the verdicts of the trace checker hold?"""


@cli.group(cls=Commands, places=KIT)
def kit() -> None:
    """Of the conformance kit, what needs TLC or the soft PLC."""


@cli.group(cls=Commands, places=VIEWS)
def views() -> None:
    """Pages and files that are made from others."""


def main(arguments: list[str] | None = None) -> int:
    """Runs ``s7spec`` and returns its exit code; ``arguments`` are those of the process by default."""
    return run(cli, "s7spec", arguments)

"""The command ``s7check``."""

import os

import click

from s7check.program import Commands, run
from s7check.version import __version__

COMMANDS = {
    "trace": "s7check.trace_command:trace_command",
    "merge": "s7check.report.merge_command:merge_command",
    "decide": "s7check.deciding.command:decide_command",
    "explain": "s7check.explaining.command:explain_command",
    "compare": "s7check.simulating.compare_command:compare_command",
    "distinguish": "s7check.simulating.distinguish_command:distinguish_command",
    "migrate": "s7check.migrating.command:migrate_command",
    "simulate": "s7check.simulating.simulate_command:simulate_command",
    "next": "s7check.asking.next_command:next_command",
    "explore": "s7check.explore_command:explore_command",
    "mcp": "s7check.assisting.command:mcp_command",
    "coverage": "s7check.coverage.command:coverage_command",
    "reduce": "s7check.reducing.command:reduce_command",
    "import": "s7check.importing.command:import_command",
    "watch": "s7check.live.command:watch_command",
    "kit": "s7check.kit.command:kit_command",
}


def _version(context: click.Context, _: click.Parameter, asked: bool) -> None:
    if asked:
        from s7check.engine.command import engine_kind

        _choose(context.params.get("engine"))
        click.echo(f"s7check, version {__version__}, engine {engine_kind()}")
        context.exit()


def _choose(engine: str | None) -> None:
    """Has this process and those that it starts use an engine."""
    if engine:
        os.environ["S7CHECK_ENGINE"] = engine


@click.group(cls=Commands, places=COMMANDS, context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--engine", type=click.Choice(["native", "jvm"]), help="The engine: an executable, or a Java program.")
@click.option("--version", is_flag=True, callback=_version, expose_value=False, help="Show the version.")
def cli(engine: str | None) -> None:
    """Check the interrupt functions of S7-300/400 CPUs (SFC 28-34 and 39-42).

    The rules come from one TLA+ specification, which s7check evaluates on the logs of a CPU or of a soft PLC.
    """
    _choose(engine)


def main(arguments: list[str] | None = None) -> int:
    """Runs ``s7check`` and returns its exit code; ``arguments`` are those of the process by default."""
    return run(cli, "s7check", arguments)

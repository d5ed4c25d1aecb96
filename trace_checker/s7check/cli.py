"""The command ``s7check``."""

import sys
from importlib import import_module
from io import TextIOWrapper

import click

from s7check import __version__

INTERRUPTED = 130
WRONG_ARGUMENTS = 2
NO_VERDICT = 3

COMMANDS = {
    "trace": "s7check.trace_command:trace_command",
    "merge": "s7check.report.merge_command:merge_command",
    "decide": "s7check.deciding.command:decide_command",
    "explain": "s7check.explaining.command:explain_command",
    "compare": "s7check.simulating.compare_command:compare_command",
    "distinguish": "s7check.simulating.distinguish_command:distinguish_command",
    "simulate": "s7check.simulating.simulate_command:simulate_command",
    "next": "s7check.asking.next_command:next_command",
    "explore": "s7check.exploring.command:explore_command",
    "coverage": "s7check.coverage.command:coverage_command",
    "reduce": "s7check.reducing.command:reduce_command",
    "import": "s7check.importing.command:import_command",
    "kit": "s7check.kit.command:kit_command",
}
"""Subcommand -> ``module:attribute`` of its click command, imported when it is asked for.

A command returns its exit code or ends with ``sys.exit``.
"""

ADDED_COMMANDS = "s7check.commands"
"""Group of entry points by which another distribution adds such commands."""


class _Commands(click.Group):
    def list_commands(self, ctx: click.Context) -> list[str]:
        return [*COMMANDS, *sorted(_added())]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        place = COMMANDS.get(cmd_name) or _added().get(cmd_name)
        if place is None:
            return None
        module, attribute = place.split(":")
        command: click.Command = getattr(import_module(module), attribute)
        return command


def _added() -> dict[str, str]:
    from importlib.metadata import entry_points

    return {point.name: point.value for point in entry_points(group=ADDED_COMMANDS)}


@click.group(cls=_Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="s7check")
def cli() -> None:
    """Check the interrupt functions of S7-300/400 CPUs (SFC 28-34 and 39-42).

    The rules come from one TLA+ specification, which s7check evaluates on the logs of a CPU or of a soft PLC.
    """


def main(arguments: list[str] | None = None) -> int:
    """Runs ``s7check`` and returns its exit code: 0 to 3 as the commands say, 130 on Ctrl-C.

    ``arguments`` are those of the process by default.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    try:
        code = cli.main(arguments, prog_name="s7check", standalone_mode=False)
    except click.ClickException as error:
        error.show()
        return WRONG_ARGUMENTS
    except (click.Abort, KeyboardInterrupt):
        return INTERRUPTED
    except Exception as error:  # whatever it is, a user is owed a sentence, no traceback
        click.echo(f"Error: {type(error).__name__}: {error}", err=True)
        return NO_VERDICT
    return code if isinstance(code, int) else 0

"""The command ``s7check``."""

import sys
from importlib import import_module
from io import TextIOWrapper

import click

from trace_checker import __version__

INTERRUPTED = 130
WRONG_ARGUMENTS = 2
NO_VERDICT = 3

COMMANDS = {
    "trace": "trace_checker.trace_command:trace_command",
    "import": "trace_checker.importing.command:import_command",
    "models": "trace_checker.models.command:models_command",
    "mutants": "trace_checker.mutants.command:mutants_command",
    "requirements": "trace_checker.traceability.command:requirements_command",
    "witnesses": "trace_checker.witnesses.command:witnesses_command",
    "agree": "trace_checker.agreement.command:agree_command",
    "verify": "trace_checker.verify_command:verify_command",
}
"""Subcommand -> ``module:attribute`` of its click command, imported when it is asked for.

A command returns its exit code or ends with ``sys.exit``.
"""


class _Commands(click.Group):
    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        module, attribute = COMMANDS[cmd_name].split(":")
        command: click.Command = getattr(import_module(module), attribute)
        return command


@click.group(cls=_Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="s7check")
def cli() -> None:
    """Check the interrupt functions of S7-300/400 CPUs (SFC 28-34 and 39-42).

    The rules come from one TLA+ specification; s7check evaluates it. For logs of a CPU or of a soft
    PLC there are trace and import; models, mutants, witnesses, agree, requirements and verify work on the
    project itself, in a checkout of it.
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

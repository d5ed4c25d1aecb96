"""A program of several commands: each is imported when it is asked for, and every end has its exit code."""

import gc
import sys
from collections.abc import Mapping
from importlib import import_module
from io import TextIOWrapper
from typing import Any

import click

from s7check.resources import FailedError

INTERRUPTED = 130
WRONG_ARGUMENTS = 2
FAILED = 3


class Commands(click.Group):
    """A group of commands: name -> ``module:attribute`` of a click command.

    A command returns its exit code or ends with ``sys.exit``.
    """

    def __init__(self, *arguments: Any, places: Mapping[str, str], **settings: Any) -> None:
        super().__init__(*arguments, **settings)
        self.places = places

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The names in the order of the table, then the groups."""
        return [*self.places, *super().list_commands(ctx)]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command, imported now."""
        place = self.places.get(cmd_name)
        if place is None:
            return super().get_command(ctx, cmd_name)
        module, attribute = place.split(":")
        if module not in sys.modules:
            # What is imported stays: no collection looks for garbage in it, nor does the end of the process.
            gc.disable()
            import_module(module)
            gc.freeze()
            gc.enable()
        command: click.Command = getattr(sys.modules[module], attribute)
        return command


def run(program: click.Command, name: str, arguments: list[str] | None) -> int:
    """Runs a program and returns its exit code: 0 to 3 as its commands say, 130 on Ctrl-C.

    ``arguments`` are those of the process by default.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    try:
        code = program.main(arguments, prog_name=name, standalone_mode=False)
    except click.ClickException as error:
        error.show()
        return WRONG_ARGUMENTS
    except (click.Abort, KeyboardInterrupt):
        return INTERRUPTED
    except FailedError as error:
        click.echo(f"Error: {error}", err=True)
        return FAILED
    except Exception as error:  # whatever it is, a user is owed a sentence, no traceback
        click.echo(f"Error: {type(error).__name__}: {error}", err=True)
        return FAILED
    return code if isinstance(code, int) else 0

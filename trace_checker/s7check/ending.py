"""The end of a command whose file cannot be used, or whose engine fails."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import click

from s7check.engine.command import EngineError
from s7check.log.errors import UnusableLogError
from s7check.report.report import EXIT_CODES


@contextmanager
def ending(name: str) -> Iterator[None]:
    """Tell of an unusable file of this name or a failed engine, and end with the exit code of that verdict."""
    try:
        yield
    except UnusableLogError as error:
        at = f":{error.line}" if error.line else ""
        click.echo(f"{click.format_filename(name)}{at}: unusable: {error.reason}", err=True)
        raise click.exceptions.Exit(EXIT_CODES["unusable"]) from error
    except EngineError as error:
        click.echo(f"{click.format_filename(name)}: {error}", err=True)
        raise click.exceptions.Exit(EXIT_CODES["no verdict"]) from error

"""What the shell completes beside the names that click knows."""

from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


def complete_files(_: click.Context, __: click.Parameter, incomplete: str) -> "list[CompletionItem]":
    """Has the shell complete names of files.

    For arguments that are no ``click.Path``: that type would refuse some, of which a verdict must be given.
    """
    from click.shell_completion import CompletionItem

    return [CompletionItem(incomplete, type="file")]

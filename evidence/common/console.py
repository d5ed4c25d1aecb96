"""Text for the user."""

from __future__ import annotations

from collections.abc import Iterable

from rich.console import Console
from rich.table import Table
from rich.text import Text

WIDTH_OF_LOG = 140
"""Columns of a table where no terminal says how wide it is."""

LONGEST_CODE = 100


def console() -> Console:
    """The terminal, or a log that is wide enough for a table."""
    terminal = Console(highlight=False)
    return terminal if terminal.is_terminal else Console(highlight=False, width=WIDTH_OF_LOG)


def plain(console: Console, text: str, style: str | None = None) -> None:
    """Print text as it is."""
    console.print(Text(text, style=style or ""), soft_wrap=True)


def short(text: str) -> str:
    """Code that is not too long for a line."""
    return text if len(text) <= LONGEST_CODE else f"{text[: LONGEST_CODE - 4]} ..."


def columns(texts: Iterable[str], numbers: Iterable[str]) -> Table:
    """A table without borders, with columns of texts and, behind them, of numbers."""
    made = Table(box=None, pad_edge=False)
    for heading in texts:
        made.add_column(heading, overflow="fold")
    for heading in numbers:
        made.add_column(heading, justify="right", no_wrap=True)
    return made

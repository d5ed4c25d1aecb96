"""What ``s7check watch`` shows: on a terminal a picture that stays in place, elsewhere a line for each event."""

from contextlib import suppress
from typing import Protocol

import click
from rich.console import Console, Group
from rich.live import Live
from rich.panel import Panel
from rich.text import Text

from s7check.asking.line_text import spelled
from s7check.live.watch import Watch
from s7check.output import echo

_LINES, _NOTES, _DUE = 12, 4, 4


class View(Protocol):
    """Shows a watch after each step."""

    def show(self, watch: Watch) -> None:
        """Shows what is new."""

    def close(self) -> None:
        """Leaves the terminal as it was."""


class Plain:
    """Each event, note and trouble on a line of its own."""

    def __init__(self) -> None:
        self._shown = [0, 0]
        self._trouble = ""

    def show(self, watch: Watch) -> None:
        """Prints what has not been printed."""
        notes = [f"- {note}" for note in watch.notes.since(self._shown[1])]
        for text in [*map(_line, watch.lines.since(self._shown[0])), *notes]:
            echo(text)
        self._shown = [watch.lines.count, watch.notes.count]
        if watch.trouble != self._trouble:
            self._trouble = watch.trouble
            echo(f"- {self._trouble or 'connected again'}")

    def close(self) -> None:
        """Nothing to do."""


class Terminal:
    """The last lines, the verdict, and what must come by when."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._live = Live(console=Console(), auto_refresh=False)
        self._live.start()

    def show(self, watch: Watch) -> None:
        """Draws it anew."""
        self._live.update(Panel(Group(*picture(watch)), title=self._name), refresh=True)

    def close(self) -> None:
        """The last picture stays."""
        with suppress(Exception):  # such as a terminal that is gone
            self._live.stop()


def picture(watch: Watch) -> list[Text]:
    """The lines of the picture."""
    log = watch.log
    until = watch.tail.told_until
    parts = [Text(f"CPU in {watch.tail.mode or 'an unknown mode'}{f', told until {until}' if until else ''}")]
    if log is not None:
        kinds = ", ".join(log.header["records"])
        parts.append(Text(f"{log.name}: {log.events} events, none wrong; recorded completely: {kinds}", style="green"))
    else:
        parts.append(Text("no log: waiting for an entry of OB 1, or for a restart", style="yellow"))
    parts += [Text(f"  {_line(line)}") for line in watch.lines.last(_LINES)]
    due = log.due()[:_DUE] if log is not None else []
    parts += [Text(f"must come by {by}: {what}", style="bold") for by, what in due]
    parts += [Text(f"- {note}", style="dim") for note in watch.notes.last(_NOTES)]
    if watch.trouble:
        parts.append(Text(f"{watch.trouble}; connecting again", style="red"))
    return parts


def _line(event: dict[str, object]) -> str:
    return click.unstyle(f"{event['at']} {spelled(event)}")

"""``s7check explore``."""

import base64
import gzip
import tempfile
import webbrowser
from pathlib import Path

import click
import msgspec

from s7check.asking.log_prefix import lines_up_to, read_text
from s7check.completion import complete_files
from s7check.ending import ending
from s7check.output import write_whole
from s7check.resources import INSTALLED, PAGE, FailedError

_HELP = """Open the page on which a log is checked and a behaviour is built event by event.

The page is one file (docs/checking/explorer.md): it shows the verdict, the timeline, the situation of the CPU, what may
come next and what may not and why. It asks no network. LOG is a log to begin with, - for standard input; LOG:7 is
opened at its line 7. The command prints the name of the file and ends: without LOG it is that of s7check itself, else
a copy with the log inside.

Exit codes: 0 done, 2 the log cannot be read or the file not be written, 3 there is no page.
"""
_EMPTY = '<script type="application/json" id="first">null</script>'
"""Where the page has the log to begin with."""


@click.command("explore", help=_HELP, short_help="Explore behaviours in a browser.")
@click.option(
    "--output",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Write the page to FILE.",
    metavar="FILE",
    show_default="a new folder for temporary files",
)
@click.option("--browser/--no-browser", default=True, show_default=True, help="Open the page in a browser.")
@click.argument("log", metavar="[LOG[:LINE]]", required=False, shell_complete=complete_files)
def explore_command(file: Path | None, browser: bool, log: str | None) -> int:
    """Write the page, print its name and open it."""
    page = page_with(log)
    if file is None and log is None:
        file = PAGE
    else:
        file = file or Path(tempfile.mkdtemp(prefix="s7check-")) / "s7check.html"
        try:
            write_whole(file, page.encode())
        except OSError as error:
            raise click.FileError(str(file), hint=error.strerror or str(error)) from error
    click.echo(click.format_filename(file))
    if browser:
        webbrowser.open(file.resolve().as_uri())
    return 0


def page_with(log: str | None = None) -> str:
    """The page, with the log that ``LOG`` or ``LOG:LINE`` names inside. Raises FailedError if there is no page."""
    try:
        page = PAGE.read_text(encoding="utf-8")
    except OSError as error:
        again = "install a wheel that `make wheel` has built, or a checkout in which `make page` has run"
        remedy = again if INSTALLED else "run `make page`"
        raise FailedError(f"{PAGE}: expected the page of the explorer: {remedy}") from error
    if log is None:
        return page
    with ending(log):
        name, text, line = read_text(log)
        lines_up_to(text, line)
    packed = base64.b64encode(gzip.compress(text, mtime=0)).decode()
    first = {"name": "log.ndjson" if name == "-" else Path(name).name, "log": packed, "line": line}
    as_json = msgspec.json.encode(first).decode().replace("<", "\\u003c")
    return page.replace(_EMPTY, _EMPTY.replace("null", as_json), 1)

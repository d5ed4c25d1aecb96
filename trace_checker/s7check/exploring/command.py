"""``s7check explore``."""

import socket
import webbrowser

import click

from s7check.completion import complete_files
from s7check.engine import pool
from s7check.engine.command import EngineError
from s7check.log.errors import UnusableLogError
from s7check.report.report import EXIT_CODES

_LOOPBACK = "127.0.0.1"
_HELP = """Serve a page on which a behaviour is built event by event.

The page shows the timeline, the situation of the CPU, what may come next and what may not and why, each with its
requirement. LOG is a log to begin with, LOG:7 its line 7. The page is served on the loopback address only, under an
address with a secret token, and nothing is written but what you save. Ctrl-C ends it.

Exit codes: 0 ended by Ctrl-C, 2 the log cannot be used, 3 no engine or no free port.
"""


@click.command("explore", help=_HELP, short_help="Explore behaviours in a browser.")
@click.option("--port", type=click.IntRange(0, 65535), default=0, show_default="any that is free", help="TCP port.")
@click.option("--browser/--no-browser", default=True, show_default=True, help="Open the page in a browser.")
@click.argument("log", metavar="[LOG[:LINE]]", required=False, shell_complete=complete_files)
def explore_command(port: int, browser: bool, log: str | None) -> int:
    """Serve until Ctrl-C."""
    import uvicorn

    from s7check.exploring.desk import warm
    from s7check.exploring.library import Library
    from s7check.exploring.server import application, new_token

    token = new_token()
    try:
        library = Library(log)
        library.contents()
        with pool.engine() as engine, socket.socket(socket.AF_INET, socket.SOCK_STREAM) as listening:
            warm(engine, library)  # and a page without an engine would be of no use
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listening.bind((_LOOPBACK, port))
            address = f"http://{_LOOPBACK}:{listening.getsockname()[1]}/{token}/"
            click.echo(f"{address}\nCtrl-C ends it.")
            if browser:
                webbrowser.open(address)
            settings = uvicorn.Config(
                application(engine, library, token), log_level="warning", access_log=False, server_header=False
            )
            uvicorn.Server(settings).run(sockets=[listening])
    except UnusableLogError as error:
        click.echo(f"{click.format_filename(log or '')}: unusable: {error}", err=True)
        return EXIT_CODES["unusable"]
    except OSError as error:
        subject = click.format_filename(error.filename) if error.filename else f"port {port}"
        click.echo(f"{subject}: {error.strerror}", err=True)
        return EXIT_CODES["unusable"] if error.filename else EXIT_CODES["no verdict"]
    except EngineError as error:
        click.echo(f"no engine: {error}", err=True)
        return EXIT_CODES["no verdict"]
    return 0

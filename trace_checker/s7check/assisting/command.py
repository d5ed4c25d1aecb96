"""``s7check mcp``."""

import click

INSTALL = 'pip install "s7check[mcp]"'

_HELP = """Serve the checker to an assistant, by the Model Context Protocol.

The server reads standard input and writes standard output until its input ends. Its tools check a log, say what may
come next and why something may not, run a program on the specification, compare two CPUs, and show a rule with its
sources. They read files that the user may read, and write none.

\b
Exit codes: 0 the input has ended, 2 the SDK `mcp` is not installed, 3 something else failed.
"""


@click.command("mcp", help=_HELP, short_help="Serve the checker to an assistant that writes programs.")
def mcp_command() -> int:
    """Serve until the input ends."""
    try:
        import mcp  # noqa: F401 - an optional dependency
    except ImportError as error:
        raise click.ClickException(f"expected the SDK of the Model Context Protocol: {INSTALL}; found none") from error
    from s7check.assisting.tools import server

    server().run("stdio")
    return 0

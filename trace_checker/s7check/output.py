"""Output: a file that is written whole or not at all, and standard output."""

import os
import sys
from pathlib import Path

import click

output_option = click.option(
    "--output",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Write to FILE, whole or not at all, and not to standard output.",
    metavar="FILE",
)


def echo(text: str | bytes) -> None:
    """Writes ``text`` to standard output, bytes as they are, a string with a line end and, on a terminal, its colours.

    Nothing happens if the reader of a pipe is gone: it has seen enough. Raises click.ClickException if the output
    cannot be written.
    """
    if sys.stdout is None:
        raise click.ClickException("standard output is closed: expected an open one, or --output FILE")
    try:
        click.echo(text, nl=isinstance(text, str), color=False if "NO_COLOR" in os.environ else None)
    except BrokenPipeError:
        _give_up()
    except OSError as error:
        _give_up()
        raise click.ClickException(f"standard output: cannot be written: {error.strerror or error}") from error


def _give_up() -> None:
    """Python writes the rest of its buffer as it ends, which would fail once more."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def deliver(data: bytes, file: Path | None) -> None:
    """Writes a document that ends with a line end to ``file``, whole or not at all, or to standard output.

    Raises click.ClickException if it cannot be written.
    """
    if file is None:
        echo(data.rstrip(b"\n").decode())
        return
    try:
        write_whole(file, data)
    except OSError as error:
        raise click.FileError(str(file), hint=error.strerror or str(error)) from error


def write_whole(path: Path, data: bytes) -> None:
    """Writes ``data`` to ``path``; a file that is there stays as it was if that fails.

    Raises OSError.
    """
    from tempfile import mkstemp

    if path.exists() and not path.is_file():
        # A device or a pipe cannot be replaced.
        path.write_bytes(data)
        return
    path = path.resolve()
    mode = path.stat().st_mode & 0o777 if path.exists() else 0o666 & ~_umask()
    fd, name = mkstemp(prefix=f".{path.name[:50]}.", dir=path.parent)
    try:
        with os.fdopen(fd, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        Path(name).chmod(mode)
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask

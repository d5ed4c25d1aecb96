"""Where a log's bytes come from: a file, a gzip file or standard input."""

import os
import stat
import sys
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from s7check.log.errors import UnusableLogError, printable
from s7check.readable import readable

CHUNK = 64 * 1024
"""Bytes asked for at a time; a pipe gives fewer, so lines arrive when they are written."""

ENDINGS = (".ndjson", ".ndjson.gz", ".jsonl", ".jsonl.gz")
"""How the names of logs end, in a folder that is given as a whole."""

_LOGS = "*.ndjson or *.jsonl"
_UNPACKED = 1024 * 1024
_GZIP = 16 + zlib.MAX_WBITS

Wait = Callable[[int], bool]
"""Called with the file descriptor before each read, which may block. False ends the reading."""


def wait_for_input(fd: int) -> bool:
    """Waits until ``fd`` can be read; the ``Wait`` of a reader with nothing else to wait for."""
    readable(fd)
    return True


class Source:
    """An open log: ``fd`` to wait on, ``packed`` whether it is gzip, ``size`` in bytes or None."""

    def __init__(self, fd: int, packed: bool) -> None:
        self.fd = fd
        self.packed = packed
        self.size = os.fstat(fd).st_size or None
        self.taken = 0

    def chunks(self, wait: Wait = wait_for_input) -> Iterator[bytes]:
        """Yields the log's bytes in pieces of any length until its end or until ``wait`` says no.

        Raises UnusableLogError, without a line, if they cannot be read or unpacked.
        """
        return _unpack(self._raw(wait)) if self.packed else self._raw(wait)

    def _raw(self, wait: Wait) -> Iterator[bytes]:
        while wait(self.fd):
            try:
                chunk = os.read(self.fd, CHUNK)
            except OSError as error:
                raise UnusableLogError("a log that can be read", _reason(error)) from error
            if not chunk:
                return
            self.taken += len(chunk)
            yield chunk


@contextmanager
def open_log(name: str) -> Iterator[Source]:
    """Opens the file ``name``, ``-`` for standard input; a name ending in ``.gz`` is gzip.

    Raises UnusableLogError, without a line, if that is impossible.
    """
    if name == "-":
        if sys.stdin is None:
            raise UnusableLogError("a log on standard input", "standard input closed")
        try:
            fd = sys.stdin.fileno()
        except (OSError, ValueError) as error:
            raise UnusableLogError("a log on standard input", _reason(error)) from error
        yield Source(fd, packed=False)
        return
    try:
        # Windows would change the ends of lines.
        fd = os.open(name, os.O_RDONLY | getattr(os, "O_BINARY", 0))
    except (OSError, ValueError) as error:
        raise UnusableLogError("a log that can be opened", _reason(error)) from error
    try:
        if stat.S_ISDIR(os.fstat(fd).st_mode):
            raise UnusableLogError(f"a folder with {_LOGS} in it", "a folder without any")
        yield Source(fd, packed=name.endswith(".gz"))
    finally:
        os.close(fd)


def _reason(error: Exception) -> str:
    if isinstance(error, OSError) and error.strerror:
        return error.strerror[0].lower() + error.strerror[1:]
    return printable(str(error))


def _unpack(packed: Iterator[bytes]) -> Iterator[bytes]:
    """Unpacks gzip members one after another, in pieces that stay small for any packing rate."""
    member = zlib.decompressobj(_GZIP)
    begun = False
    for chunk in packed:
        while chunk:
            if not begun:
                # Zero bytes between and after members are padding.
                chunk = chunk.lstrip(b"\0") if member.eof else chunk
                if not chunk:
                    break
                member = zlib.decompressobj(_GZIP)
                begun = True
            try:
                plain = member.decompress(chunk, _UNPACKED)
            except zlib.error as error:
                raise UnusableLogError("a sound gzip file", printable(str(error))) from error
            if plain:
                yield plain
            chunk = member.unused_data if member.eof else member.unconsumed_tail
            begun = not member.eof
    if begun or not member.eof:
        raise UnusableLogError("a sound gzip file", "its end too early")

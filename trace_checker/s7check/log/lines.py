"""From chunks of bytes to batches of numbered physical lines."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from s7check.log.errors import UnusableLogError

LONGEST_LINE = 1024 * 1024
"""Bytes of the longest line that is read; it bounds the memory that a log can take."""


class Lines(NamedTuple):
    r"""Consecutive lines, without their ``\n``; ``first`` is the number of the first of them."""

    first: int
    texts: list[bytes]


def split_lines(chunks: Iterable[bytes]) -> Iterator[Lines]:
    """Yields the lines that each chunk completes, as soon as it has come.

    The end of the log completes its last line. Raises UnusableLogError for a line that is too long and,
    with the line it would have come in, for an error of ``chunks``.
    """
    number = 1
    pieces: list[bytes] = []
    pending = 0
    try:
        for chunk in chunks:
            *complete, rest = chunk.split(b"\n")
            if complete:
                complete[0] = b"".join([*pieces, complete[0]])
                pieces, pending = [], 0
                longest = max(map(len, complete))
                if longest > LONGEST_LINE:
                    good = next(i for i, line in enumerate(complete) if len(line) > LONGEST_LINE)
                    yield Lines(number, complete[:good])
                    raise _too_long(number + good)
                yield Lines(number, complete)
                number += len(complete)
            pieces.append(rest)
            pending += len(rest)
            if pending > LONGEST_LINE:
                raise _too_long(number)
    except UnusableLogError as error:
        error.line = error.line or number
        raise
    if pending:
        yield Lines(number, [b"".join(pieces)])


def _too_long(number: int) -> UnusableLogError:
    return UnusableLogError(f"a line of at most {LONGEST_LINE} bytes", "a longer one", line=number)

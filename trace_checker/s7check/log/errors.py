"""The one exception of reading, and how texts and numbers are told in messages."""

from collections.abc import Iterable

_LONGEST = 60


class UnusableLogError(Exception):
    """A line that is not of the format.

    ``line`` is the physical line, from 1, or 0 where none can be named (a file that cannot be
    opened); ``field`` the path of the field (``"info.time"``) or None where the whole line is
    meant; ``expected`` and ``found`` are texts for people, free of control characters.
    """

    def __init__(self, expected: str, found: str, field: str | None = None, line: int = 0) -> None:
        super().__init__(expected, found, field, line)
        self.expected = expected
        self.found = found
        self.field = field
        self.line = line

    @property
    def reason(self) -> str:
        """The message without the line."""
        where = "" if self.field is None else f'field "{self.field}": '
        return f"{where}expected {self.expected}; found {self.found}"

    def __str__(self) -> str:
        return f"line {self.line}: {self.reason}" if self.line else self.reason


def printable(text: str, longest: int = _LONGEST) -> str:
    """``text`` cut to ``longest`` characters, with everything a terminal might obey escaped."""
    cut = text if len(text) <= longest else text[:longest] + "..."
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in cut)


def ranges(numbers: Iterable[int]) -> str:
    """Such as ``1, 10-17, 80``."""
    parts: list[list[int]] = []
    for number in sorted(numbers):
        if parts and number == parts[-1][-1] + 1:
            parts[-1].append(number)
        else:
            parts.append([number])
    return ", ".join(str(part[0]) if len(part) == 1 else f"{part[0]}-{part[-1]}" for part in parts)

"""The one exception of importing."""

from s7check.log.errors import printable


class SourceError(Exception):
    """Something in a source, or a source itself, that cannot be imported.

    ``place`` names it within the source (``"entry 3"``), or is empty where the whole source is
    meant; ``expected`` and ``found`` are texts for people.
    """

    def __init__(self, place: str, expected: str, found: str) -> None:
        super().__init__(place, expected, found)
        self.place = place
        self.expected = expected
        self.found = found

    def __str__(self) -> str:
        where = f"{self.place}: " if self.place else ""
        return f"{where}expected {self.expected}; found {self.found}"


def shown(text: str) -> str:
    """``text`` from a source as a message quotes it: short, in quotation marks, printable."""
    return f'"{printable(text)}"'


def in_field(place: str, field: str | None) -> str:
    """The place of a field of the log within ``place``."""
    return f'{place}: field "{field}"' if field else place

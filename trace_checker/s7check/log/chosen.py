"""What the caller chooses in the place of a log's header."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Chosen:
    """An edition of the manual by which every log is judged, and ambiguities with the letters of their readings.

    A letter goes before that of the header and before the edition.
    """

    profile: str | None = None
    letters: Mapping[str, str] = field(default_factory=dict)

    def in_place_of(self, header: dict[str, Any]) -> dict[str, Any]:
        """The normalised header with these choices."""
        profile = header["profile"] if self.profile is None else self.profile
        readings = [[name, letter] for name, letter in {**dict(header["readings"]), **self.letters}.items()]
        return header | {"profile": profile, "readings": readings}


NOTHING = Chosen()

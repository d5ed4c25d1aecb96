"""What the caller chooses in the place of a log's header."""

from collections.abc import Mapping
from typing import Any

import msgspec


class Chosen(msgspec.Struct, frozen=True):
    """An edition of the manual by which every log is judged, ambiguities with the letters of their readings, a CPU.

    A letter goes before that of the header and before the edition.
    """

    profile: str | None = None
    letters: Mapping[str, str] = {}
    cpu: str | None = None

    def but(self, other: "Chosen") -> "Chosen":
        """These choices but for those of ``other``."""
        profile = self.profile if other.profile is None else other.profile
        return Chosen(profile, {**self.letters, **other.letters}, other.cpu or self.cpu)

    @classmethod
    def of(cls, message: Mapping[str, Any]) -> "Chosen":
        """The choices of such a message."""
        return cls(message.get("profile"), message.get("readings", {}), message.get("cpu"))

    def message(self) -> dict[str, Any]:
        """The choices as the engine takes them."""
        return {
            **({} if self.profile is None else {"profile": self.profile}),
            **({"readings": dict(self.letters)} if self.letters else {}),
            **({} if self.cpu is None else {"cpu": self.cpu}),
        }


NOTHING = Chosen()

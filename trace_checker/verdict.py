"""What is said about a log."""

from dataclasses import dataclass, field
from typing import Literal

Verdict = Literal["accepted", "rejected", "unusable", "no verdict"]

EXIT_CODES: dict[Verdict, int] = {"accepted": 0, "rejected": 1, "unusable": 2, "no verdict": 3}


@dataclass(frozen=True)
class Report:
    """The verdict about one log.

    ``line`` is the physical line it is about, or None; ``events`` the number of events explained
    before; ``event`` the text of the rejected line, or None where it is no longer at hand;
    ``expected`` what the specification allows there; ``requirements`` the IDs that decide it.
    """

    log: str
    verdict: Verdict
    message: str
    line: int | None = None
    events: int = 0
    event: bytes | None = None
    expected: list[str] = field(default_factory=list)
    requirements: list[str] = field(default_factory=list)

    @property
    def exit_code(self) -> int:
        """The exit code that the verdict stands for."""
        return EXIT_CODES[self.verdict]

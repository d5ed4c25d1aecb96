"""The two clocks of a log: the CPU's, which can be set, and elapsed time, which cannot."""

from typing import Any

from s7check.log.errors import UnusableLogError
from s7check.log.values import MS_PER_MINUTE, Moment, iso, moment

Readings = dict[str, int]
"""The state of both clocks in milliseconds: ``clock``, ``up`` and ``elapsed``."""


class Clocks:
    """Follows a log's times from line to line.

    ``clock`` is the CPU clock when the log begins; ``jumps_logged`` says whether every setting of
    the clock is in the log. Elapsed time counts from the log's begin: where a line has no ``up`` it
    follows the CPU clock, settings left out.
    """

    def __init__(self, clock: Moment, jumps_logged: bool) -> None:
        self._clock = _milliseconds(clock)
        self._up = 0
        self._elapsed = 0
        self.jumps_logged = jumps_logged

    @property
    def readings(self) -> Readings:
        """The clocks after the last line."""
        return {"clock": self._clock, "up": self._up, "elapsed": self._elapsed}

    def set(self, readings: Readings) -> None:
        """Goes on from these readings."""
        self._clock, self._up, self._elapsed = readings["clock"], readings["up"], readings["elapsed"]

    @property
    def reading(self) -> int:
        """The CPU clock, in milliseconds since 1990-01-01T00:00."""
        return self._clock

    def stamp(self, event: dict[str, Any]) -> None:
        """Turns ``at`` into a moment and ``up`` too, which is filled in where it is missing; as it was given it
        becomes ``counter``.

        Raises UnusableLogError if either runs backward.
        """
        at: int = event["at"]
        up: int | None = event.get("up")
        passed = at - self._clock
        if passed < 0 and self.jumps_logged:
            raise UnusableLogError(f"no time before {iso(self._clock)}, the clock's last reading", iso(at), field="at")
        if up is None:
            # Where its settings are not logged, a clock that runs backward was set.
            self._elapsed += max(passed, 0)
        elif up < self._up:
            raise UnusableLogError(f"no number below {self._up}, the last one", str(up), field="up")
        else:
            self._up = up
            event["counter"] = moment(up)
            # Lines without `up` may have counted further than the next line with it.
            self._elapsed = max(self._elapsed, up)
        self._clock = _milliseconds(event["to"]) if "to" in event else at
        event["at"] = moment(at)
        event["up"] = moment(self._elapsed)


def _milliseconds(reading: Moment) -> int:
    return reading["min"] * MS_PER_MINUTE + reading["ms"]

"""Elapsed time from the CPU clock and the system time of SFC 64 TIME_TCK."""

from datetime import datetime, timedelta

_WRAP = 1 << 31
"""TIME_TCK counts milliseconds from 0 to 2^31 - 1 and begins again."""

_RESOLUTION = 11
"""Milliseconds by which the two may differ: TIME_TCK counts in steps of 10 on many S7-300, the clock in steps of 1."""

_DRIFT = 1000
"""They run apart by no more than a thousandth."""


class Elapsed:
    """Milliseconds since the first entry, on a clock that nobody sets.

    Where clock and system time agree as far as their resolution goes, the finer clock counts; where
    they do not, the clock was set and the system time counts; ``jumped`` says so of the last entry.
    """

    def __init__(self) -> None:
        self.jumped = False
        self._up = 0
        self._last: tuple[datetime, int] | None = None

    def up(self, at: str, tick: int, restarted: bool) -> int:
        """The elapsed time of the next entry; a restart sets the system time to 0."""
        clock = datetime.fromisoformat(at)
        self.jumped = False
        if self._last is not None:
            by_clock = (clock - self._last[0]) // timedelta(milliseconds=1)
            by_tick = (tick - self._last[1]) % _WRAP
            apart = abs(by_clock - by_tick)
            if restarted or (by_clock >= 0 and apart <= _RESOLUTION + by_tick // _DRIFT):
                self._up += max(by_clock, 0)
            else:
                self.jumped = True
                self._up += by_tick
        self._last = clock, tick
        return self._up

    def set_clock(self, to: str) -> None:
        """The clock was set right after the last entry."""
        assert self._last is not None
        self._last = datetime.fromisoformat(to), self._last[1]

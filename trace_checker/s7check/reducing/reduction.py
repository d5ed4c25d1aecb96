"""Fewer lines, a shorter header, rounder values, as long as the log is rejected for the same reason."""

from collections import Counter
from collections.abc import Iterator, Sequence
from datetime import datetime
from typing import Any

from s7check.engine.client import Engine
from s7check.reducing.candidate import Event, Fields, Judge, OutOfTimeError
from s7check.report.report import Report

_NEEDED = ("format", "cpu", "obs", "clock", "mode")
"""Fields that each header keeps; ``mode`` may be left out, but nobody knows its default by heart."""


def reduce_log(lines: Sequence[Fields], rejection: Report, engine: Engine, until: float) -> "Reduction":
    """The reduction of a log, header first, that is rejected at its last line, at the time ``until`` of
    ``time.monotonic`` at the latest. Raises EngineError.
    """
    header, *fields = lines
    reduction = Reduction(Judge(engine, rejection, until), header, list(map(Event, fields)))
    reduction.run()
    return reduction


_RESTARTS = 4
"""Restarts at which a shorter log is tried to begin."""


def _without_ob(header: Fields, ob: object) -> Fields:
    """The header without an OB: not loaded, without parameters."""
    less: dict[str, Any] = {**header, "obs": [one for one in header["obs"] if one != ob]}
    if "tod" in header.get("step7", {}):
        tod = {name: value for name, value in header["step7"]["tod"].items() if name != str(ob)}
        less["step7"] = {**header["step7"], "tod": tod}
    if "priority" in header:
        less["priority"] = {name: value for name, value in header["priority"].items() if name != str(ob)}
    return less


def _ob(event: Event) -> object:
    return event.fields.get("ob")


def _event_and_ob(event: Event) -> object:
    return event.fields.get("event"), event.fields.get("ob")


class Reduction:
    """The smallest log so far: ``header``, ``events``, and whether there was time to try everything (``done``)."""

    def __init__(self, judge: Judge, header: Fields, events: Sequence[Event]) -> None:
        self._judge = judge
        self.header = header
        self.events = list(events)
        self.done = False

    def run(self) -> None:
        """Reduces the log. Raises EngineError."""
        try:
            self._begin_at_a_restart()
            self._take_the_end()
            self._remove_kinds()
            self._remove_lines()
            self._trim_header()
            self._round()
            self._remove_lines()
            self._trim_header()
            self.done = True
        except OutOfTimeError:
            pass

    def _accept(self, header: Fields, events: Sequence[Event]) -> bool:
        if not self._judge.fits(header, events):
            return False
        self.header, self.events = header, list(events)
        return True

    def _begin_at_a_restart(self) -> None:
        """The log from its last restart on that fits: a restart forgets nearly all that was before."""
        loaded = set(self.header["obs"])
        begins = []
        for place, one in enumerate(self.events[:-1]):
            if one.fields["event"] == "restart":
                header = {**self.header, "clock": one.fields["at"], "mode": "STOP", "obs": sorted(loaded)}
                begins.append((header, self.events[place:]))
            elif one.fields["event"] in ("load", "delete"):
                (loaded.add if one.fields["event"] == "load" else loaded.discard)(one.fields["ob"])
        for header, events in reversed(begins[-_RESTARTS:]):
            if self._accept(header, events):
                return

    def _take_the_end(self) -> None:
        """The shortest end of the log that fits, twice as long each time: it begins at the time of its first line.

        Lines in it that only the lines before could explain are left out.
        """
        length = 8
        while length < len(self.events):
            rest = self.events[-length:]
            for mode in dict.fromkeys((self.header.get("mode", "STOP"), "RUN")):
                header = {**self.header, "clock": rest[0].fields["at"], "mode": mode}
                if self._accept(header, self._judge.explained(header, rest)):
                    return
            length *= 2

    def _remove_kinds(self) -> None:
        """All lines of an OB, and of a kind of event of an OB, are left out at once, the most frequent first.

        They lie scattered: no piece of the log has them alone.
        """
        for kind in (_ob, _event_and_ob):
            for name, _ in Counter(map(kind, self.events[:-1])).most_common():
                rest = [one for one in self.events[:-1] if kind(one) != name] + self.events[-1:]
                if not self._accept(self.header, rest) and kind is _ob:
                    self._accept(_without_ob(self.header, name), rest)

    def _remove_lines(self) -> None:
        """Delta debugging: ever smaller pieces are left out, never the last line."""
        size = len(self.events) // 2
        while size >= 1:
            removed = False
            at = 0
            while at < len(self.events) - 1:
                end = min(at + size, len(self.events) - 1)
                if self._accept(self.header, [*self.events[:at], *self.events[end:]]):
                    removed = True
                else:
                    at = end
            size = 1 if size == 1 and removed else size // 2

    def _trim_header(self) -> None:
        for name in [name for name in self.header if name not in _NEEDED]:
            self._accept({key: value for key, value in self.header.items() if key != name}, self.events)
        for ob in list(self.header["obs"]):
            self._accept({**self.header, "obs": [one for one in self.header["obs"] if one != ob]}, self.events)
        for clock in _rounder(str(self.events[0].fields["at"])):
            if self._accept({**self.header, "clock": clock}, self.events):
                break

    def _round(self) -> None:
        for place in range(len(self.events)):
            self._drop_fields(place)
            for changes in self._simpler(place):
                if self._try(place, changes):
                    break
            dtime = self.events[place].fields.get("dtime")
            if isinstance(dtime, int):
                for unit in (60_000, 1_000):
                    if dtime % unit and dtime > unit and self._try(place, {"dtime": dtime // unit * unit}):
                        break

    def _drop_fields(self, place: int) -> None:
        """Leaves out the fields, and those of ``info``, that the line does not need."""
        for name in list(self.events[place].fields):
            if name not in ("event", "at"):
                self._try(place, {}, without=(name,))
        info = self.events[place].fields.get("info")
        for name in list(info) if isinstance(info, dict) else []:
            now = self.events[place].fields["info"]
            self._try(place, {"info": {key: value for key, value in now.items() if key != name}})

    def _simpler(self, place: int) -> Iterator[dict[str, Any]]:
        """Other times for a line: that of the line before, or a rounder one."""
        at = str(self.events[place].fields["at"])
        before = str(self.events[place - 1].fields["at"] if place else self.header["clock"])
        yield from ({"at": other} for other in (before, *_rounder(at)) if other != at)

    def _try(self, place: int, changes: Fields, without: Sequence[str] = ()) -> bool:
        changed = self.events[place].with_fields(changes, without)
        return self._accept(self.header, [*self.events[:place], changed, *self.events[place + 1 :]])


def _rounder(at: str) -> Iterator[str]:
    """The whole minute before a time, and the whole second, both written as finely: a coarse time is no moment."""
    try:
        time = datetime.fromisoformat(at.removeprefix("DT#"))
    except ValueError:  # the form that has a hyphen between date and time
        return
    whole = time.replace(microsecond=0)
    fine = "milliseconds" if "." in at else "seconds"
    yield from (one.isoformat(timespec=fine) for one in (whole.replace(second=0), whole))

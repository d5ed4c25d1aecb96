"""The program's side of a simulation: bodies that are at work, and the events from outside that are still to come."""

from __future__ import annotations

from collections import Counter
from typing import Any

from s7check.kit.program import Program

CYCLE_OB = 1

_PAUSE = 1
"""Milliseconds of a cycle of OB 1 whose body does not wait: a cycle of no length would go on forever."""


class Frame:
    """An OB that was started, with the steps that are left; ``busy`` is the rest of a wait, in ms."""

    def __init__(self, ob: int, steps: tuple[dict[str, Any], ...], idle: bool = False) -> None:
        self.ob = ob
        self.steps = steps
        self.idle = idle
        """Nothing is to be done in this run nor in any later one: it goes on for as long as it may."""
        self.place = 0
        self.busy = 0
        self._enter()

    def _enter(self) -> None:
        step = self.step
        self.busy = step["wait"] if step is not None and "wait" in step else 0

    @property
    def step(self) -> dict[str, Any] | None:
        """The step that is to be done or waited for; None at the end."""
        step = self.steps[self.place] if self.place < len(self.steps) else None
        return None if step is not None and "end" in step else step

    def go_on(self) -> None:
        """The step is done."""
        self.place += 1
        self._enter()

    def copy(self) -> Frame:
        """A frame that goes on by itself."""
        twin = Frame(self.ob, self.steps, self.idle)
        twin.place, twin.busy = self.place, self.busy
        return twin


class Work:
    """The bodies of a program at work."""

    def __init__(self, program: Program) -> None:
        self._bodies = {(body.ob, body.run): body.steps for body in program.bodies}
        self._last_run = {ob: max(run for other, run in self._bodies if other == ob) for ob, _ in self._bodies}
        self._runs: Counter[int] = Counter()
        self.frames: list[Frame] = []
        self._stopped: list[Frame] = []
        """What STOP has interrupted and a hot restart brings back."""

    def copy(self) -> Work:
        """Work that goes on by itself."""
        twin = object.__new__(Work)
        twin._bodies, twin._last_run = self._bodies, self._last_run
        twin._runs = self._runs.copy()
        twin.frames = [frame.copy() for frame in self.frames]
        twin._stopped = [frame.copy() for frame in self._stopped]
        return twin

    def start(self, ob: int) -> None:
        """An OB starts."""
        self._runs[ob] += 1
        run = self._runs[ob]
        steps = self._bodies.get((ob, run), self._bodies.get((ob, 0), ()))
        if ob == CYCLE_OB and not any("wait" in step for step in steps):
            steps = (*(step for step in steps if "end" not in step), {"wait": _PAUSE})
        more = (ob, 0) in self._bodies or run <= self._last_run.get(ob, 0)
        self.frames.append(Frame(ob, steps, idle=ob == CYCLE_OB and not more))

    def end(self) -> None:
        """The OB on top has ended."""
        self.frames.pop()

    def stop(self, in_startup: bool) -> None:
        """STOP; that of STARTUP ends the startup OB for good."""
        if not in_startup:
            self._stopped = self.frames
        self.frames = []

    def restart(self, hot: bool) -> None:
        """Only a hot restart brings back what STOP has interrupted."""
        if not hot:
            self._stopped = []

    def go_on(self) -> None:
        """RUN."""
        self.frames, self._stopped = self._stopped, []

    @property
    def top(self) -> Frame | None:
        """The OB that is at work."""
        return self.frames[-1] if self.frames else None

    def key(self) -> tuple[object, ...]:
        """Equal for work that goes on alike."""
        both = (*self._stopped, None, *self.frames)
        frames = tuple(frame and (frame.ob, id(frame.steps), frame.place, frame.busy) for frame in both)
        return (frames, tuple(sorted(self._runs.items())))

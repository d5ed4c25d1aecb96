"""The kit in a test suite: each program is a test. pytest and unittest both know the errors."""

from __future__ import annotations

import atexit
from collections.abc import Mapping, Sequence
from pathlib import Path
from unittest import SkipTest

from s7check.kit.adapter import Adapter
from s7check.kit.choosing import Aim, covering
from s7check.kit.clusters import told_status
from s7check.kit.collection import chosen, programs_of
from s7check.kit.offer import Offer, read_offer
from s7check.kit.results import Result
from s7check.kit.running import Runner


class NotKeptError(AssertionError):
    """A program did not pass; ``result`` says why, and so does the text of the error."""

    def __init__(self, result: Result) -> None:
        super().__init__(f"{told_status(result)}: {result.reason}\n{result.report}".rstrip())
        self.result = result


class Kit:
    """Programs for the adapter ``command``; ``names`` are theirs, and ``run`` runs one.

    ``only``, ``requirements``, ``programs``, ``offer``, ``cover``, ``timeout``, ``profile`` and ``letters`` are the
    options of ``s7check kit run``. The adapter is started when the first program runs, and ended with Python.

    Raises EngineError, OSError, UnusableLogError for an offer, UnreadableProgramError for programs, ValueError if no
    program is chosen.
    """

    def __init__(
        self,
        command: Sequence[str],
        *,
        only: Sequence[str] = (),
        requirements: Sequence[str] = (),
        programs: Sequence[Path | str] = (),
        offer: Path | str | None = None,
        cover: Aim | None = None,
        timeout: float = 60.0,
        profile: str | None = None,
        letters: Mapping[str, str] | None = None,
    ) -> None:
        offered = Offer() if offer is None else read_offer(Path(offer))
        few = chosen(programs_of([Path(file) for file in programs]), only, requirements)
        few = [offered.fitted(program) for program in few]
        if cover is not None:
            few = covering([program for program in few if not offered.lacks(program)], cover, None)
        if not few:
            raise ValueError("expected a choice of programs; no program fits it (see `s7check kit list`)")
        self._programs = {program.name: program for program in few}
        self._runner = Runner(command, offer=offered, profile=profile, letters=letters)
        self._adapter = Adapter(command, timeout)
        atexit.register(self._adapter.__exit__, None, None, None)

    @property
    def names(self) -> list[str]:
        """The names of the programs."""
        return list(self._programs)

    def run(self, name: str) -> Result:
        """The result of a program that has passed.

        Raises NotKeptError if it has not, SkipTest if it was skipped, AdapterError if the command cannot be started.
        """
        __tracebackhide__ = True  # pytest then shows the test and the reason
        result = self._runner.result(self._adapter, self._programs[name])
        if result.status == "skipped":
            raise SkipTest(result.reason)
        if result.status != "passed":
            raise NotKeptError(result)
        return result

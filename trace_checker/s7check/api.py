"""Checking from Python: a whole log, or the events of a program while it runs."""

import os
from codecs import BOM_UTF8
from collections.abc import Iterable, Mapping
from contextlib import suppress
from types import TracebackType
from typing import Any, Self

import msgspec

from s7check.engine import pool
from s7check.engine.answer import Alternatives
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.check import Judging, check_log
from s7check.judging.replay import Replay, TooLongError, with_readings
from s7check.log.chosen import Chosen
from s7check.log.errors import UnusableLogError
from s7check.report.report import Reading, Report, Verdict

__all__ = ["Checker", "Line", "NotAcceptedError", "Reading", "Report", "Verdict", "check"]

Line = Mapping[str, Any] | str | bytes
"""A line of a log: its fields as the log format spells them, or its text."""

_NAME = "log"


class NotAcceptedError(AssertionError):
    """A log was not accepted; ``report`` says why, and so does the text of the error."""

    def __init__(self, report: Report) -> None:
        super().__init__(str(report))
        self.report = report


def check(
    log: str | os.PathLike[str] | Iterable[Line],
    *,
    profile: str | None = None,
    letters: Mapping[str, str] | None = None,
    other_readings: bool = False,
    decided: bool = False,
    name: str = _NAME,
) -> Report:
    """The verdict about a log.

    ``log`` is the path of a file (``.gz`` is unpacked), or the lines: the header, then the events. ``profile``
    (``"2006"``) and ``letters`` (``{"AMB-08": "b"}``) take the place of the header's own choices. With
    ``other_readings`` the log is judged by every other reading too, one changed at a time; with ``decided`` the report
    of an accepted log has the requirements that decided something. It calls lines that have no file by ``name``.
    The engine serves later calls as well, until Python ends.

    A log that is unusable and an engine that fails are verdicts of the report. Raises ValueError for a profile, an
    ambiguity or a letter that there is not, TypeError for a line that JSON cannot say.
    """
    chosen = _chosen(profile, letters)
    with pool.engine() as engine:
        if isinstance(log, str | os.PathLike):
            file = os.fspath(log)
            report = check_log(file, engine, lambda _, __: None, chosen, decided)
        else:
            file = "-"
            report = _check_lines(log, engine, chosen, name, decided)
        if other_readings and report.verdict in ("accepted", "rejected"):
            with suppress(TooLongError, EngineError):  # the verdict stands without it
                report = with_readings(report, engine, Replay(file, report.lines, chosen))
        return report


class Checker:
    """Judges the events of a program while it runs.

    Feed the header first. The line that no behaviour of the specification explains raises NotAcceptedError, where the
    program is still at that event. As a context manager it raises also if the log has no header at the end.

        with s7check.Checker() as checker:
            checker.feed({"format": "s7-interrupt-log/1", "cpu": "S7-300", "obs": [1, 10], "clock": ..., "mode": "RUN"})
            checker.feed({"event": "SET_TINT", "at": ..., "ob": 10, "sdt": ..., "period": 0x0201, "ret": 0})

    ``profile``, ``letters`` and ``name`` are those of ``check``, as are the errors. A checker belongs to one thread;
    several may be at work at a time, each with an engine.
    """

    def __init__(
        self, *, profile: str | None = None, letters: Mapping[str, str] | None = None, name: str = _NAME
    ) -> None:
        chosen = _chosen(profile, letters)
        self._engine: Engine | None = pool.take()
        self._judging = Judging(name, self._engine, chosen)
        self._report: Report | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None) -> None:
        report = self.report()
        if kind is None and report.verdict != "accepted":
            raise NotAcceptedError(report)

    def feed(self, line: Line) -> None:
        r"""Takes the next line; a text may have several, with ``\n`` between them.

        Raises NotAcceptedError if the log is not accepted with this line, and for each line that follows; RuntimeError
        after ``report``.
        """
        if self._report is None:
            if not self._judged(line):
                return
            self.report()
        elif self._report.verdict == "accepted":
            raise RuntimeError("the checker has reported: feed a new one")
        assert self._report is not None
        raise NotAcceptedError(self._report)

    def report(self) -> Report:
        """The verdict about the lines so far; nothing can be fed after it."""
        if self._report is None:
            self._report = self._judging.report()
        if self._engine is not None:
            pool.give_back(self._engine)
            self._engine = None
        return self._report

    def _judged(self, line: Line) -> bool:
        """Whether the log is judged with this line."""
        text = _ended(line)
        try:
            self._judging.take(text if self._judging.lines else text.removeprefix(BOM_UTF8))
            return self._judging.decided()
        except EngineError as error:
            self._judging.fail(error)
            return True


def _check_lines(lines: Iterable[Line], engine: Engine, chosen: Chosen, name: str, decided: bool) -> Report:
    judging = Judging(name, engine, chosen, decided=decided)
    try:
        judging.take_all(map(_ended, lines), lambda _: None)
    except UnusableLogError as error:
        judging.refuse(error)
    except EngineError as error:
        judging.fail(error)
    return judging.report()


def _ended(line: Line) -> bytes:
    """The text of a line, with its end."""
    return encoded(line).removesuffix(b"\n") + b"\n"


def encoded(line: Line) -> bytes:
    """The text of a line. Raises TypeError for fields that JSON cannot say."""
    if isinstance(line, bytes):
        return line
    if isinstance(line, str):
        return line.encode("utf-8", "surrogatepass")
    return msgspec.json.encode(line)


def _chosen(profile: str | None, letters: Mapping[str, str] | None) -> Chosen:
    """Raises ValueError, with the values that there are."""
    with suppress(EngineError):  # it is a verdict
        words = pool.alternatives() if profile is not None or letters else Alternatives()
        if profile is not None and profile not in words.profiles:
            raise ValueError(f"profile: expected {', '.join(words.profiles)} or None; found {profile!r}")
        for ambiguity, letter in (letters or {}).items():
            known = words.readings.get(ambiguity)
            if known is None:
                raise ValueError(f"letters: expected ambiguities such as AMB-08; found {ambiguity!r}")
            if letter not in known:
                raise ValueError(f"letters: {ambiguity}: expected {' or '.join(known)}; found {letter!r}")
    return Chosen(profile, dict(letters or {}))

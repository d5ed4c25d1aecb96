"""Checks one log: reads it, has the engine judge it, decides which line comes first."""

from collections import deque
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import Any

import click

from s7check.engine.answer import NOTHING_TO_CHOOSE, Answer, Candidate
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.decisions import decisions_of
from s7check.log.chosen import NOTHING, Chosen
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.lines import Lines, split_lines
from s7check.log.profile_file import folder_of
from s7check.log.reader import Batch, LogReader
from s7check.log.source import Source, open_log
from s7check.report.expected import format_allowed, format_late
from s7check.report.report import Report

_KEPT = 16 * 1024 * 1024
"""Bytes of lines kept for the report; more than can be under way to the engine at a time."""

_LOOKED_AT = 1000
"""Lines of a file without a header that are looked at to tell its kind."""

_OVERHEAD = 48
"""Bytes that a line takes beside its own: an endless log of empty lines must not fill the memory."""

_READ_FIRST = 2000
"""Events after which the engine may read lines; it knows no examples before that, and starts beside the reading."""

_ASKED = 500
_ASKED_PART = 0.05
"""The engine reads no more lines if it has asked for that many, and that part of them: each question is a wait."""

_UNEXPLAINED = "no behaviour of the specification explains this line"
_TOO_LATE = "something had to come before this line"

Progress = Callable[[Source, int], None]
"""Called now and then with the log being read and the number of events read from it."""


def check_log(name: str, engine: Engine, progress: Progress, chosen: Chosen = NOTHING) -> Report:
    """The verdict about the log ``name`` (``-`` for standard input); never raises for a log.

    ``chosen`` takes the place of the header's own choices.
    """
    judging = Judging(click.format_filename(name), engine, chosen)
    reader = LogReader(folder_of(name))
    try:
        with open_log(name) as source:
            for lines in split_lines(as_utf8(source.chunks(engine.wait))):
                judging.take_lines(lines, reader)
                progress(source, judging.events)
                if judging.refused:
                    break
            else:
                reader.end()
    except UnusableLogError as error:
        judging.refuse(error)
    except EngineError as error:
        judging.fail(error)
    return judging.report()


class Judging:
    """The judging of one log by ``engine``, batch after batch; ``report`` ends it."""

    def __init__(self, log: str, engine: Engine, chosen: Chosen = NOTHING) -> None:
        self._log = log
        self._engine = engine
        self._chosen = chosen
        self._recent = _RecentLines()
        self._begun = False
        self._unusable: UnusableLogError | None = None
        self._failed: EngineError | None = None
        self._passed = 0
        self._asked = 0
        self.events = 0
        """The events that were taken."""

    def take(self, batch: Batch) -> None:
        """Sends the next lines to the engine. Raises EngineError."""
        self._recent.add(batch.lines)
        if batch.header is not None:
            self._engine.begin(self._chosen.in_place_of(batch.header))
            self._begun = True
        self._engine.send(batch.events)
        self.events += len(batch.events)
        if batch.error is not None:
            self.refuse(batch.error)

    def take_lines(self, lines: Lines, reader: LogReader) -> None:
        """The same for the next lines, which ``reader`` has not read. Raises EngineError.

        Of a long log whose lines differ in little but their times the engine reads most: it is faster.
        """
        if self._begun and self.events >= _READ_FIRST and self._asked <= _ASKED + self._passed * _ASKED_PART:
            self._recent.add(lines)
            self._engine.send_lines(lines, reader, partial(self._read, reader))
            self._passed += len(lines.texts)
            self.events += len(lines.texts)
            return
        self._engine.end_lines()
        self.take(reader.read(lines))

    def _read(self, reader: LogReader, number: int) -> dict[str, Any] | None:
        """The event of a line that the engine cannot read; none if it is unusable."""
        self._asked += 1
        batch = reader.read(Lines(number, [self._recent.get(number) or b""]))
        if batch.error is not None:
            self.refuse(batch.error)
        return batch.events[0] if batch.events else None

    @property
    def refused(self) -> bool:
        """Whether a line cannot be read."""
        return self._unusable is not None

    def refuse(self, error: UnusableLogError) -> None:
        """The log goes no further: a line cannot be read."""
        self._unusable = error if self._begun else _source_of_import(error, self._recent)

    def fail(self, error: EngineError) -> None:
        """The log goes no further: the engine has failed."""
        self._failed = error

    def decided(self) -> bool:
        """Whether the lines so far decide the verdict, whatever follows. Raises EngineError."""
        return self._unusable is not None or self._failed is not None or (self._begun and self._engine.decided())

    def report(self) -> Report:
        """The verdict."""
        answer: Answer | None = None
        # The engine was sent the lines before the unusable one: its answers about them come first.
        # If it has decided already, reading was broken off and the rest means nothing.
        if self._begun and self._failed is None:
            try:
                answer = self._engine.finish()
            except EngineError as error:
                self._failed = error
        if self._failed is not None:
            return Report(self._log, "no verdict", str(self._failed))
        if answer is not None and answer.verdict == "rejected":
            last = answer.line or 0
            return rejection(self._log, answer, self._recent.get(last), self._recent.up_to(last))
        if answer is not None and answer.verdict == "error":
            return Report(self._log, "no verdict", answer.message, line=answer.line, events=answer.events)
        events = answer.events if answer else 0
        if self._unusable is not None:
            line = self._unusable.line or None
            return Report(self._log, "unusable", self._unusable.reason, line=line, events=events)
        message = "the specification explains every event" + _loosened(answer)
        report = Report(self._log, "accepted", message, events=events)
        return report if answer is None else self._with_decided(report, answer)

    def _with_decided(self, report: Report, answer: Answer) -> Report:
        try:
            decisions = decisions_of(self._engine)
        except EngineError:  # the verdict stands without it
            return report
        return replace(
            report,
            outcomes=answer.outcomes,
            open=answer.open,
            classes=answer.classes,
            decided=decisions.requirements_of(answer.outcomes),
            decidable=len(decisions.requirements),
        )


def _source_of_import(error: UnusableLogError, recent: "_RecentLines") -> UnusableLogError:
    """The error; if the bytes are a diagnostic buffer, it says that a log can be made from them."""
    from s7check.importing.kinds import kind_of  # logs do not wait for it

    kind = kind_of(b"\n".join(recent.up_to(_LOOKED_AT)))
    if kind is None:
        return error
    return UnusableLogError(
        "a log", f"a diagnostic buffer, of which `s7check import --from {kind}` makes one", line=error.line
    )


def rejection(log: str, answer: Answer, event: bytes | None, lines: list[bytes]) -> Report:
    """The report of a log that the engine rejects; ``event`` is the rejected line, ``lines`` are those up to it."""
    return Report(
        log,
        "rejected",
        (_TOO_LATE if answer.late else _UNEXPLAINED) + _loosened(answer),
        line=answer.line,
        events=answer.events,
        event=event,
        expected=[format_allowed(allowed) for allowed in answer.expected],
        requirements=answer.requirements,
        late=[format_late(allowed, answer.situations) for allowed in answer.expected] if answer.late else [],
        states=answer.states,
        situations=answer.situations,
        candidates=_telling(answer.candidates),
        outcomes=answer.outcomes,
        open=answer.open,
        classes=answer.classes,
        asked=answer.asked,
        lines=lines,
    )


def _loosened(answer: Answer | None) -> str:
    if answer is None or (answer.loose is None and answer.wide is None):
        return ""
    if answer.loose is not None:
        return f"; too many explanations: from line {answer.loose} on only certain facts are checked"
    return f"; too many explanations: from line {answer.wide} on start events that wait are not all told apart"


def _telling(candidates: list[Candidate]) -> list[Candidate]:
    """Without the actions that are about another kind of event altogether, and those of which there is nothing to say:
    they had nothing to act on, or are not meant for this log.
    """
    of_this_event = [one for one in candidates if not one.conjunct.startswith("e.event ")]
    telling = [one for one in of_this_event if one.values != NOTHING_TO_CHOOSE and one.conjunct != "FALSE"]
    return telling or of_this_event or candidates


class _RecentLines:
    """The last lines read, to quote the line that the engine rejects."""

    def __init__(self) -> None:
        self._batches: deque[Lines] = deque()
        self._bytes = 0

    def add(self, lines: Lines) -> None:
        self._batches.append(lines)
        self._bytes += _size(lines)
        while self._bytes > _KEPT and len(self._batches) > 1:
            self._bytes -= _size(self._batches.popleft())

    def up_to(self, number: int) -> list[bytes]:
        """All lines from the first one to this one; none if the first is no longer at hand."""
        if not self._batches or self._batches[0].first != 1:
            return []
        texts = (text for lines in self._batches for text in lines.texts)
        return list(islice(texts, number))

    def get(self, number: int) -> bytes | None:
        for lines in reversed(self._batches):
            if 0 <= number - lines.first < len(lines.texts):
                return lines.texts[number - lines.first]
        return None


def _size(lines: Lines) -> int:
    return sum(map(len, lines.texts)) + _OVERHEAD * len(lines.texts)

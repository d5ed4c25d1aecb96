"""Checks one log: reads it, has the engine judge it, decides which line comes first."""

import time
from collections import deque
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path

import click
from msgspec.structs import replace

from s7check.engine.answer import Answer, Refusal
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.decisions import decisions_of
from s7check.log.chosen import NOTHING, Chosen
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.profile_file import HERE, folder_of
from s7check.log.source import Source, open_log
from s7check.report.clauses import texts
from s7check.report.report import Report

_KEPT = 16 * 1024 * 1024
"""Bytes of lines kept for the report; more than can be under way to the engine at a time."""

_FLOW = 20
"""Lines that lead to a rejected one and stay in its report."""

_LOOKED_AT = 1000
"""Lines of a file without a header that are looked at to tell its kind."""

Progress = Callable[[Source, int], None]
"""Called now and then with the log being read and the number of lines read from it."""


def check_log(
    name: str, engine: Engine, progress: Progress, chosen: Chosen = NOTHING, decided: bool = False
) -> Report:
    """The verdict about the log ``name`` (``-`` for standard input); never raises for a log.

    ``chosen`` takes the place of the header's own choices. With ``decided`` the report has the requirements that
    decided something, which is slower.
    """
    begun = time.monotonic()
    judging = Judging(click.format_filename(name), engine, chosen, folder_of(name), decided)
    try:
        with open_log(name) as source:
            judging.take_all(source.chunks(engine.wait), lambda _: progress(source, judging.lines))
    except UnusableLogError as error:
        judging.refuse(error)
    except EngineError as error:
        judging.fail(error)
    return replace(judging.report(), seconds=time.monotonic() - begun)


class Judging:
    """The judging of one log in ``folder`` by ``engine``, piece after piece; ``report`` ends it."""

    def __init__(
        self, log: str, engine: Engine, chosen: Chosen = NOTHING, folder: Path = HERE, decided: bool = False
    ) -> None:
        self._log = log
        self._engine = engine
        self._chosen = chosen
        self._folder = folder
        self._decided = decided
        self._recent = _RecentLines()
        self._begun = False
        self._unusable: UnusableLogError | None = None
        self._failed: EngineError | None = None

    @property
    def lines(self) -> int:
        """The lines that were taken."""
        return self._recent.ended

    def take_all(self, chunks: Iterable[bytes], taken: Callable[[bytes], None]) -> None:
        """Takes the pieces of a log in any encoding; ``taken`` gets each in UTF-8.

        Raises EngineError, and UnusableLogError with the line that would have come next.
        """
        try:
            for chunk in as_utf8(chunks):
                self.take(chunk)
                taken(chunk)
        except UnusableLogError as error:
            error.line = self.lines + 1
            raise

    def take(self, chunk: bytes) -> None:
        """Sends the next piece, in UTF-8, to the engine. Raises EngineError."""
        self._begin()
        self._recent.add(chunk)
        self._engine.send(chunk)

    def _begin(self) -> None:
        if not self._begun:
            self._begun = True
            self._engine.begin(self._chosen.message(), folder=self._folder, outcomes=self._decided)

    def refuse(self, error: UnusableLogError) -> None:
        """The log goes no further: its source is unusable."""
        self._unusable = error

    def fail(self, error: EngineError) -> None:
        """The log goes no further: the engine has failed."""
        self._failed = error

    def decided(self) -> bool:
        """Whether what was taken decides the verdict, whatever follows. Raises EngineError."""
        return self._unusable is not None or self._failed is not None or (self._begun and self._engine.decided())

    def report(self) -> Report:
        """The verdict."""
        answer: Answer | None = None
        # The engine was sent what came before the source broke off: its answers about that come first.
        if self._failed is None and (self._begun or self._unusable is None):
            try:
                self._begin()
                answer = self._engine.finish(broken=self._unusable is not None)
                if answer.verdict == "rejected":
                    return self._rejection(answer)
            except EngineError as error:
                self._failed = error
        if self._failed is not None:
            return Report(self._log, "no verdict", str(self._failed))
        if answer is not None and answer.verdict == "error":
            return Report(self._log, "no verdict", answer.message, line=answer.line, events=answer.events)
        events = answer.events if answer else 0
        unusable = self._unusable if answer is None or answer.unusable is None else answer.unusable.error()
        if unusable is not None:
            unusable = self._source_of_import(unusable)
            return Report(self._log, "unusable", unusable.reason, line=unusable.line or None, events=events)
        if answer is not None and answer.loose is not None and not answer.partial:
            return Report(self._log, "no verdict", answer.message, events=events, certain_from=answer.loose)
        assert answer is not None
        report = Report(self._log, "accepted", answer.message, events=events, certain_from=answer.loose)
        return self._with_decided(report, answer) if self._decided else report

    def _rejection(self, answer: Answer) -> Report:
        last = answer.line or 0
        event = self._recent.get(last)
        self._engine.tell(texts)
        return rejection(self._log, answer, self._engine.refusal(event or b""), event, self._recent.up_to(last))

    def _source_of_import(self, error: UnusableLogError) -> UnusableLogError:
        """The error; if it is in place of the header, and the bytes are a program or a source of an import, it says
        what makes a log of them.
        """
        from s7check.importing.asking import kind_of  # logs do not wait for it

        begin = b"\n".join(self._recent.up_to(_LOOKED_AT))
        if not begin or any(map(bytes.strip, self._recent.up_to(max(error.line - 1, 0)))):
            return error
        with suppress(EngineError):  # the verdict stands without it
            if kind := kind_of(begin, self._engine):
                found = f"a diagnostic buffer, of which `s7check import --from {kind}` makes one"
                if kind == "program":
                    found = "a program of the kit, which `s7check simulate` runs"
                return UnusableLogError("a log", found, line=error.line)
        return error

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


def rejection(log: str, answer: Answer, refusal: Refusal, event: bytes | None, lines: list[bytes]) -> Report:
    """The report of a log that the engine rejects; ``event`` is the rejected line, ``lines`` are those up to it."""
    return Report(
        log,
        "rejected",
        answer.message,
        line=answer.line,
        events=answer.events,
        event=event,
        expected=[allowed.text for allowed in refusal.expected],
        requirements=refusal.requirements,
        certain_from=answer.loose,
        late=refusal.wanted if refusal.late else [],
        why=refusal.why,
        states=refusal.states,
        situations=refusal.situations,
        candidates=refusal.candidates,
        refusal=refusal,
        outcomes=answer.outcomes,
        open=answer.open,
        classes=answer.classes,
        asked=answer.asked,
        lines=lines,
        flow=[(number, text) for number, text in enumerate(lines, 1) if number > 1 and text.strip()][-_FLOW:],
    )


class _RecentLines:
    """The last part of what was read, to quote the line that the engine rejects."""

    def __init__(self) -> None:
        self._chunks: deque[bytes] = deque()
        self._bytes = 0
        self._dropped = 0
        self._whole = True
        self.ended = 0
        """The lines that have ended."""

    def add(self, chunk: bytes) -> None:
        self._chunks.append(chunk)
        self._bytes += len(chunk)
        self.ended += chunk.count(b"\n")
        while self._bytes > _KEPT and len(self._chunks) > 1:
            dropped = self._chunks.popleft()
            self._bytes -= len(dropped)
            self._dropped += dropped.count(b"\n")
            self._whole = False

    def up_to(self, number: int) -> list[bytes]:
        """All lines from the first one to this one; none if the first is no longer at hand."""
        return b"".join(self._chunks).split(b"\n", number)[:number] if self._whole else []

    def get(self, number: int) -> bytes | None:
        """A line, if it is still at hand."""
        place = number - 1 - self._dropped
        texts = b"".join(self._chunks).split(b"\n", max(place, 0) + 1)
        return texts[place] if 0 <= place < len(texts) else None

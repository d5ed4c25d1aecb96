"""Runs programs through adapters, several at a time, and has the logs judged."""

from __future__ import annotations

import hashlib
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any, cast

import msgspec

from s7check.api import check
from s7check.engine import pool
from s7check.engine.command import EngineError
from s7check.kit.adapter import NO_END, Adapter
from s7check.kit.followed import departure
from s7check.kit.offer import Offer
from s7check.kit.program import Program
from s7check.kit.results import Result, result_of
from s7check.kit.whole import Whole, whole
from s7check.log.objects import decoded
from s7check.reducing.candidate import as_text
from s7check.reducing.reduction import reduce_log
from s7check.report.report import Report

_REDUCED = 3
"""Failed programs for a requirement whose logs are reduced."""

_REDUCING = 10.0
"""Seconds for that, at most."""


class Runner:
    """Runs programs on the implementation behind ``command``; ``jobs`` adapters work at a time.

    Programs are fitted to ``offer``; those that it lacks something for are skipped. With ``logs`` the log of each
    program is kept in that folder. With ``fail_fast`` the run ends with the first failure, else with so many
    ``timeouts``; programs that have not run then have no result. ``resume`` is a file of results, to which each new one
    is added; programs that it has are not run again.
    """

    def __init__(
        self,
        command: Sequence[str],
        *,
        jobs: int = 1,
        timeout: float = 60.0,
        offer: Offer | None = None,
        logs: Path | None = None,
        resume: Path | None = None,
        profile: str | None = None,
        letters: dict[str, str] | None = None,
        fail_fast: bool = False,
        timeouts: int = 1_000_000,
    ) -> None:
        self._command = tuple(command)
        self._jobs = jobs
        self._timeout = timeout
        self._offer = offer or Offer()
        self._logs = logs
        self._resume = resume
        self._profile = profile
        self._letters = letters or {}
        self._fail_fast = fail_fast
        self._timeouts = timeouts
        self._lock = threading.Lock()
        self._reduced_for: Counter[str] = Counter()

    def run(self, programs: Sequence[Program], progress: Callable[[Result], None]) -> list[Result]:
        """The results in the order of the programs; ``progress`` gets each as soon as it is there.

        Raises AdapterError if the command cannot be started, OSError if a file cannot be written.
        """
        done = self._kept()
        results: dict[str, Result] = {}
        left = []
        for program in map(self._offer.fitted, programs):
            kept = done.get(program.name)
            if kept is not None and kept.digest == self._digest(program):
                results[program.name] = kept
                progress(kept)
            else:
                left.append(program)
        if self._logs is not None:
            self._logs.mkdir(parents=True, exist_ok=True)
        for result in self._new(left):
            results[result.name] = result
            self._keep(result)
            progress(result)
        return [results[program.name] for program in programs if program.name in results]

    def _new(self, programs: Iterable[Program]) -> Iterator[Result]:
        local = threading.local()
        with ExitStack() as adapters, ThreadPoolExecutor(self._jobs) as pool:
            lock = threading.Lock()

            def work(program: Program) -> Result:
                if not hasattr(local, "adapter"):
                    local.adapter = Adapter(self._command, self._timeout)
                    with lock:
                        adapters.enter_context(local.adapter)
                return self._result(local.adapter, program)

            futures: list[Future[Result]] = [pool.submit(work, program) for program in programs]
            hung = 0
            try:
                for future in as_completed(futures):
                    result = future.result()
                    hung += result.reason.startswith(NO_END)
                    yield result
                    if (self._fail_fast and result.status == "failed") or hung >= self._timeouts:
                        pool.shutdown(cancel_futures=True)
                        return
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise

    def _result(self, adapter: Adapter, program: Program) -> Result:
        digest = self._digest(program)
        lack = self._offer.lacks(program)
        if lack:
            return Result(program.name, digest, "skipped", program.requirements, lack)
        begun = time.monotonic()
        ran = adapter.run(program)
        seconds = round(time.monotonic() - begun, 3)
        if ran.skipped:
            return Result(program.name, digest, "skipped", program.requirements, ran.skipped)
        if ran.failed:
            self._keep_log(program, ran.log)
            return Result(program.name, digest, "failed", program.requirements, ran.failed, seconds=seconds)
        with pool.engine() as engine:
            log = whole(engine, program, ran)
        self._keep_log(program, log.lines)
        report = check(log.lines, profile=self._profile, letters=self._letters, name=program.name)
        if report.verdict == "unusable":
            adapter.end()  # unread output may still be under way
        result = result_of(report, program.name, digest, program.requirements, seconds)
        if report.verdict == "rejected" and self._first_few(report):
            return msgspec.structs.replace(result, reduced=self._reduced(report), passes_under=self._under(report))
        if result.status == "passed" and (reason := _departure(program, log)):
            return msgspec.structs.replace(result, status="failed", reason=f"not the log of this program: {reason}")
        return result

    def _keep_log(self, program: Program, lines: Iterable[bytes]) -> None:
        if self._logs is not None:
            (self._logs / f"{program.name}.ndjson").write_bytes(b"".join(line + b"\n" for line in lines))

    def _first_few(self, report: Report) -> bool:
        """Whether few logs that were rejected for the same requirement have been reduced; reducing takes seconds."""
        with self._lock:
            first = report.requirements[0]
            self._reduced_for[first] += 1
            return self._reduced_for[first] <= _REDUCED

    def _under(self, report: Report) -> tuple[str, ...]:
        """The readings and editions under which the log is accepted."""
        tried = check(report.lines, profile=self._profile, letters=self._letters, other_readings=True, name=report.log)
        return tuple(one.change for one in tried.readings or () if one.verdict == "accepted")

    def _reduced(self, report: Report) -> str:
        """The smallest log that is rejected alike."""
        header, *events = cast("list[dict[str, Any]]", [decoded(line) for line in report.lines if line.strip()])
        if self._profile is not None:
            header["profile"] = self._profile
        if self._letters:
            header["readings"] = header.get("readings", {}) | self._letters
        with pool.engine() as engine, suppress(EngineError):
            reduction = reduce_log([header, *events], report, engine, time.monotonic() + _REDUCING)
            return as_text(reduction.header, reduction.events).decode()
        return ""

    def _digest(self, program: Program) -> str:
        letters = (f"{name}={value}" for name, value in self._letters.items())
        said = [*self._command, self._offer.lacks(program), self._profile or "", *letters]
        return hashlib.sha256(b"\0".join([program.line(), *(text.encode() for text in said)])).hexdigest()[:16]

    def _kept(self) -> dict[str, Result]:
        if self._resume is None or not self._resume.exists():
            return {}
        results = {}
        for line in self._resume.read_bytes().splitlines():
            try:
                result = msgspec.json.decode(line, type=Result)
            except msgspec.MsgspecError:
                continue  # a line that was cut off when the run was broken off
            results[result.name] = result
        return results

    def _keep(self, result: Result) -> None:
        if self._resume is not None and result.status != "no verdict":
            with self._resume.open("ab") as file:
                file.write(msgspec.json.encode(result) + b"\n")


def _departure(program: Program, log: Whole) -> str:
    with pool.engine() as engine:
        return departure(engine, program, log)

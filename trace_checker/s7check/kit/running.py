"""Runs programs through adapters, several at a time, and has the logs judged."""

from __future__ import annotations

import hashlib
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from contextlib import ExitStack
from pathlib import Path

import msgspec

from s7check.kit.adapter import NO_END, Adapter
from s7check.kit.judging import LogJudge, first_few
from s7check.kit.offer import Offer
from s7check.kit.program import Program
from s7check.kit.results import FAILED, Result
from s7check.report.report import Report

_REDUCED = 3
"""Failed programs for a requirement whose logs are reduced."""


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
        letters: Mapping[str, str] | None = None,
        fail_fast: bool = False,
        timeouts: int = 1_000_000,
    ) -> None:
        self._command = tuple(command)
        self._jobs = jobs
        self._timeout = timeout
        self._offer = offer or Offer()
        self._logs = logs
        self._resume = resume
        self._judge = LogJudge(profile, letters, self._offer.diag)
        self._fail_fast = fail_fast
        self._timeouts = timeouts
        self._rejected: dict[str, Report] = {}

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
        self._reduce(results, programs)
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
                return self.result(local.adapter, program)

            futures: list[Future[Result]] = [pool.submit(work, program) for program in programs]
            hung = 0
            try:
                for future in as_completed(futures):
                    result = future.result()
                    hung += result.reason.startswith(NO_END)
                    yield result
                    if (self._fail_fast and result.status in FAILED) or hung >= self._timeouts:
                        pool.shutdown(cancel_futures=True)
                        return
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise

    def result(self, adapter: Adapter, program: Program) -> Result:
        """The result of a program, which is fitted to the offer, on an adapter. Raises AdapterError."""
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
        result, report, log = self._judge.result(program, ran, seconds)
        self._keep_log(program, log.lines)
        if report.verdict == "unusable":
            adapter.end()  # unread output may still be under way
        if report.verdict == "rejected":
            self._rejected[program.name] = report
        return msgspec.structs.replace(result, digest=digest)

    def _reduce(self, results: dict[str, Result], programs: Iterable[Program]) -> None:
        """Reduces the first rejected logs for each requirement, in the order of the programs."""
        inorder = (results[program.name] for program in programs if program.name in results)
        few = [result for result in first_few(inorder, _REDUCED) if result.name in self._rejected]
        with ThreadPoolExecutor(self._jobs) as pool:
            for result, small in zip(few, pool.map(self._reduced, few), strict=True):
                results[result.name] = msgspec.structs.replace(result, reduced=small)
                self._keep(results[result.name])

    def _reduced(self, result: Result) -> str:
        return self._judge.reduced(self._rejected[result.name])

    def _keep_log(self, program: Program, lines: Iterable[bytes]) -> None:
        if self._logs is not None:
            (self._logs / f"{program.name}.ndjson").write_bytes(b"".join(line + b"\n" for line in lines))

    def _digest(self, program: Program) -> str:
        letters = (f"{name}={value}" for name, value in self._judge.letters.items())
        said = [*self._command, self._offer.lacks(program), self._judge.profile or "", *letters]
        said += ["diag"] * self._offer.diag
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

"""``s7check trace``."""

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from importlib import import_module
from pathlib import Path

import click
from msgspec.structs import replace

from s7check.completion import complete_files
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.check import check_log
from s7check.judging.replay import Replay, TooLongError, with_readings, with_steps
from s7check.judging.workers import Workers
from s7check.letters import Profile, set_option
from s7check.log.chosen import NOTHING, Chosen
from s7check.names import logs_of
from s7check.output import echo, output_option, write_whole
from s7check.report.as_json import to_json
from s7check.report.as_text import TextReports
from s7check.report.progress import ProgressBar
from s7check.report.report import Report

_WHOLE = {
    "junit": "s7check.report.as_junit:to_junit",
    "sarif": "s7check.report.as_sarif:to_sarif",
    "html": "s7check.report.as_html:to_html",
}
"""Formats that are one document for all logs: ``module:function``, imported when it is asked for."""

_TRIED = 10
"""Rejected logs of a call for which other readings are tried unasked."""

_BUDGET = 5.0
"""Seconds of a call in which other readings are tried unasked."""

_DRAWN = 50
"""Logs of a call that get a timeline."""


_HELP = """Check whether recorded runs of a CPU keep to the rules of the S7-300/400.

A LOG is a file of the format s7-interrupt-log/1: what the CPU did, one JSON object a line, the
SFC calls with their RET_VAL, OBs starting and ending, the clock being set. A file whose name
ends in .gz is unpacked; - reads standard input while it is being written. A folder stands for all
logs in it (*.ndjson, *.jsonl, packed or not), a pattern such as 'logs/**/*.ndjson' for those that it fits.

\b
Verdicts, and the exit code that each stands for:
  accepted    0  an S7-300/400 may behave like this
  rejected    1  it may not: the line, what it may do instead, the rule
  unusable    2  the log is not of the format: the line and the field
  no verdict  3  the check could not be done, no Java for instance, or a log that
                 leaves nothing out has too many explanations

Over several logs the exit code is the highest of theirs.
"""


@click.command("trace", help=_HELP, short_help="Check logs of a CPU against the specification.")
@click.option(
    "--format",
    "output",
    type=click.Choice(["text", "json", *_WHOLE]),
    default="text",
    show_default=True,
    help="text for people; json, one object a log; junit, sarif and html, one document.",
)
@output_option
@click.option(
    "--readings",
    type=click.Choice(["auto", "all", "none"]),
    default="auto",
    show_default=True,
    help="Where the manuals leave something open: judge a log by every other reading, CPU and edition too, one "
    f"changed at a time, and say which change the verdict. all, every log; auto, the first {_TRIED} rejected ones.",
)
@click.option(
    "--budget",
    type=click.FloatRange(min=0),
    help=f"Seconds for other readings in this call: {_BUDGET} with --readings auto, no limit with all. Those that bear "
    "on the rule that decided come first; the report names the others.",
    metavar="SECONDS",
)
@click.option(
    "--profile",
    type=Profile(),
    default=None,
    metavar="EDITION|FILE.json",
    help="Judge every log by this edition of the manual, or by the letters that `s7check decide` has written to FILE; "
    "its header has no say.",
)
@set_option(
    "Judge every log by this reading of an open question (docs/rules/readings.md); its header has no say, nor "
    "--profile. May be given several times."
)
@click.option(
    "--keep-going",
    is_flag=True,
    help="Also the rejections behind the first one of a log; each says how the judging went on.",
)
@click.option(
    "--decided",
    is_flag=True,
    help="Say of each accepted log how many requirements decided something; this is slower.",
)
@click.argument("logs", nargs=-1, required=True, metavar="LOG...", shell_complete=complete_files)
def trace_command(
    output: str,
    file: Path | None,
    readings: str,
    budget: float | None,
    profile: Chosen | None,
    letters: dict[str, str],
    keep_going: bool,
    decided: bool,
    logs: tuple[str, ...],
) -> int:
    """Judge the logs and report."""
    if "" in logs:
        raise click.UsageError("LOG: expected the name of a file or folder, a pattern or -; found an empty text")
    if keep_going and "-" in logs:
        raise click.UsageError("--keep-going: expected logs that can be read again; found - for standard input")
    names = logs_of(logs)
    reports: list[Report] = []
    written: list[bytes] = []
    texts = TextReports()

    def write(piece: str) -> None:
        if file is None:
            progress.pause()
            echo(piece)
        else:
            written.append((click.unstyle(piece) if output == "text" else piece).encode() + b"\n")

    with Workers(pool.take) as workers, ProgressBar(len(names)) as progress:
        work = _Work(
            workers,
            progress,
            readings,
            budget,
            _chosen(profile or NOTHING, letters),
            output == "html",
            keep_going,
            decided,
        )
        for report in work.reports(names):
            if output in _WHOLE:
                reports.append(report)
                continue
            write(to_json(report).decode() if output == "json" else texts.add(report))
            reports.append(_without_bulk(report))
        if texts.sum():
            write(texts.sum())
    if output in _WHOLE:
        written = [_document(output, reports)]
        if file is None:
            echo(written[0].rstrip(b"\n").decode())
    if file is not None:
        try:
            write_whole(file, b"".join(written))
        except OSError as error:
            raise click.FileError(str(file), hint=error.strerror or str(error)) from error
    return max((report.exit_code for report in reports), default=0)


def _chosen(profile: Chosen, letters: dict[str, str]) -> Chosen:
    return replace(profile, letters={**profile.letters, **letters})


class _Work:
    """Judges logs; the parts of a report for which there is a limit come in the order of the logs."""

    def __init__(
        self,
        workers: Workers,
        progress: ProgressBar,
        readings: str,
        budget: float | None,
        chosen: Chosen,
        drawn: bool,
        keep_going: bool,
        decided: bool,
    ) -> None:
        self._workers = workers
        self._progress = progress
        self._readings = readings
        self._chosen = chosen
        self._keep_going = keep_going
        self._decided = decided
        self._tried = 0
        self._left = _BUDGET if budget is None and readings == "auto" else budget
        self._to_draw = _DRAWN if drawn else 0

    def reports(self, names: Sequence[str]) -> Iterator[Report]:
        """The reports in the order of the names."""
        for name, judged in zip(names, self._workers.in_order(names, self._judged), strict=True):
            self._progress.begin(click.format_filename(name))
            report = judged.result()
            yield self._completed(replace(report, lines=[]), name, report.lines)
            if self._keep_going and report.verdict == "rejected":
                yield from self._onward(report, name)
            self._progress.done()

    def _onward(self, report: Report, name: str) -> list[Report]:
        """The rejections behind the first one; none if the engine fails."""
        # Here, for most calls have no use for it.
        from s7check.asking.onward import rejections

        def found(first: Report, engine: Engine) -> list[Report]:
            with suppress(EngineError):
                return [one.report for one in rejections(name, first, engine, self._chosen)]
            return []

        return self._workers.submit(report, found).result()

    def _judged(self, name: str, engine: Engine) -> Report:
        progress = self._progress.of(click.format_filename(name))
        report = check_log(name, engine, progress, self._chosen, self._decided)
        if self._readings == "all" and self._left is None:
            return _again(report, lambda r: with_readings(r, engine, Replay(name, report.lines, self._chosen)))
        return report

    def _completed(self, report: Report, name: str, lines: list[bytes]) -> Report:
        """The report with the parts that need the log once more; ``lines`` are the lines of a stream, which is gone."""
        auto = self._readings == "auto" and report.verdict == "rejected" and self._tried < _TRIED
        tries = auto or (self._readings == "all" and self._left is not None)
        draws = self._to_draw > 0

        def completed(report: Report, engine: Engine) -> Report:
            replay = Replay(name, lines, self._chosen)
            if tries:
                self._tried += 1
                self._progress.trying()
                begun = time.monotonic()
                report = with_readings(report, engine, replay, None if self._left is None else begun + self._left)
                if self._left is not None:
                    self._left = max(0, self._left - (time.monotonic() - begun))
            if draws:
                self._to_draw -= 1
                report = with_steps(report, engine, replay)
            return report

        if not tries and not draws:
            return report
        return self._workers.submit(
            report, lambda report, engine: _again(report, lambda r: completed(r, engine))
        ).result()


def _again(report: Report, judge: Callable[[Report], Report]) -> Report:
    """The report with parts that need the log once more, if it has a verdict about behaviour."""
    if report.verdict in ("accepted", "rejected"):
        with suppress(TooLongError, EngineError):  # the verdict stands without it
            return judge(report)
    return report


def _document(output: str, reports: Sequence[Report]) -> bytes:
    module, function = _WHOLE[output].split(":")
    write: Callable[[Sequence[Report]], bytes] = getattr(import_module(module), function)
    return write(reports)


def _without_bulk(report: Report) -> Report:
    """The part that the exit code needs; the rest was written."""
    return Report(report.log, report.verdict, report.message)

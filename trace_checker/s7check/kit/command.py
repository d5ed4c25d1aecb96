"""``s7check kit``."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

import click
import msgspec

from s7check.importing.errors import SourceError
from s7check.importing.sources import live
from s7check.kit import formats
from s7check.kit.adapter import AdapterError
from s7check.kit.choosing import Aim, budget_of, covering
from s7check.kit.choosing import shard as part_of
from s7check.kit.clusters import changes, is_known
from s7check.kit.collection import UnreadableProgramError, chosen, programs_of
from s7check.kit.hardware import fitted, lacks
from s7check.kit.identity import this_run
from s7check.kit.layout import to_text
from s7check.kit.matrix import to_matrix
from s7check.kit.offer import Offer, read_offer
from s7check.kit.program import Program
from s7check.kit.results import FAILED, Kept, Result, outcomes
from s7check.kit.running import Runner
from s7check.kit.scl import NotForCpuError, to_scl
from s7check.letters import EDITION, set_option
from s7check.log.errors import UnusableLogError
from s7check.output import echo, write_whole
from s7check.report.progress import ProgressBar

_LANE_S = 90.0
"""Seconds beside its duration that a program may take on a real CPU."""

_ENDINGS = " ".join(formats.FORMATS)

_FILES = click.option(
    "--programs",
    "files",
    multiple=True,
    type=click.Path(exists=True, path_type=Path),
    help="Programs of this file or folder in place of the kit's. May be given several times.",
    metavar="FILE",
)
_ONLY = click.option(
    "--only",
    multiple=True,
    help="Programs whose name fits the pattern, such as 'AIRT-*'. May be given several times.",
    metavar="PATTERN",
)
_REQUIREMENT = click.option(
    "--requirement",
    "requirements",
    multiple=True,
    help="Programs about this requirement, such as AIRT-03. May be given several times.",
    metavar="ID",
)


@click.group("kit", short_help="Run the conformance kit on an implementation.")
def kit_command() -> None:
    """Programs that bring a CPU to the places where implementations go wrong.

    docs/checking/kit.md describes programs and adapters.
    """


def _chosen(files: tuple[Path, ...], only: tuple[str, ...], requirements: tuple[str, ...]) -> list[Program]:
    try:
        programs = chosen(programs_of(files), only, requirements)
    except UnreadableProgramError as error:
        raise click.ClickException(str(error)) from error
    if not programs:
        raise click.ClickException("expected a choice of programs; no program fits it (see `s7check kit list`)")
    return programs


@kit_command.command("list", short_help="List programs.")
@_ONLY
@_REQUIREMENT
@_FILES
def list_command(only: tuple[str, ...], requirements: tuple[str, ...], files: tuple[Path, ...]) -> int:
    """List the programs: name, requirements, what each is about."""
    for program in _chosen(files, only, requirements):
        echo(f"{program.name}  {' '.join(program.requirements)}  {program.about}")
    return 0


@kit_command.command("show", short_help="Show a program.")
@click.argument("name")
@click.option(
    "--format",
    "form",
    type=click.Choice(["json", "scl"]),
    default="json",
    show_default=True,
    help="json, laid out; scl, source for STEP 7, which no CPU has run yet.",
)
@_FILES
def show_command(name: str, form: str, files: tuple[Path, ...]) -> int:
    """Show the program NAME."""
    for program in _chosen(files, (name,), ()):
        try:
            echo((to_scl(program) if form == "scl" else to_text(program.raw)).rstrip("\n"))
        except NotForCpuError as error:
            raise click.ClickException(f"{program.name} has {error}") from error
    return 0


def _offer(_: click.Context, __: click.Parameter, file: Path | None) -> tuple[Offer, Path | None]:
    if file is None:
        return Offer(), None
    try:
        return read_offer(file), file
    except UnusableLogError as error:
        raise click.BadParameter(f"{file}: {error.reason}") from error


def _outputs(_: click.Context, __: click.Parameter, names: tuple[Path, ...]) -> tuple[Path, ...]:
    for name in names:
        if name.suffix not in formats.FORMATS:
            raise click.BadParameter(f"expected a name that ends with one of {_ENDINGS}; found {name}")
    return names


def _budget(_: click.Context, __: click.Parameter, text: str | None) -> int | None:
    try:
        return None if text is None else budget_of(text)
    except ValueError as error:
        raise click.BadParameter(str(error)) from error


def _shard(_: click.Context, __: click.Parameter, text: str | None) -> tuple[int, int]:
    part, _slash, parts = (text or "1/1").partition("/")
    if not (part.isdecimal() and parts.isdecimal() and 1 <= int(part) <= int(parts)):
        raise click.BadParameter(f"expected I/N such as 1/4; found {text}")
    return int(part), int(parts)


def _baseline(_: click.Context, __: click.Parameter, file: Path | None) -> dict[str, str]:
    if file is None:
        return {}
    try:
        kept = msgspec.json.decode(file.read_bytes(), type=Kept)
    except msgspec.MsgspecError as error:
        raise click.BadParameter(f"{file}: expected a .json result of `s7check kit run`; {error}") from error
    return {result.name: result.status for result in kept.programs}


@kit_command.command("run", short_help="Run programs on an implementation and judge its logs.")
@_ONLY
@_REQUIREMENT
@_FILES
@click.option(
    "--offer",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    callback=_offer,
    help="What the CPU offers, a JSON object; programs that need more are skipped.",
    metavar="FILE",
)
@click.option(
    "--cover",
    type=click.Choice(["requirements", "guards"]),
    help="Few programs that reach all that the others reach.",
)
@click.option(
    "--budget",
    callback=_budget,
    help="With --cover: the time for the programs on the CPU, such as 90s, 30min or 2h.",
    metavar="TIME",
)
@click.option("--shard", callback=_shard, help="The I-th of N parts of the programs.", metavar="I/N")
@click.option("--fail-fast", is_flag=True, help="End with the first failure.")
@click.option(
    "--timeouts",
    type=click.IntRange(min=1),
    default=10,
    show_default=True,
    help="End after so many programs without an end in time.",
    metavar="N",
)
@click.option("--implementation", default="", help="Name and version of the implementation, for the result.")
@click.option(
    "--baseline",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    callback=_baseline,
    help="An earlier .json result: say what changed; its failures are known and fail no run.",
    metavar="FILE",
)
@click.option("--jobs", type=click.IntRange(1, 64), help="Adapters at work at a time, by default one a core.")
@click.option(
    "--timeout",
    type=click.FloatRange(min=0, min_open=True),
    default=60.0,
    show_default=True,
    help="Seconds that a program may take; after them its adapter is ended and the program has failed.",
    metavar="SECONDS",
)
@click.option(
    "--resume",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Keep every result in FILE, and do not run again what it has.",
    metavar="FILE",
)
@click.option(
    "--logs",
    type=click.Path(file_okay=False, path_type=Path),
    help="Keep the log of every program in this folder.",
    metavar="FOLDER",
)
@click.option(
    "--output",
    "outputs",
    multiple=True,
    type=click.Path(dir_okay=False, path_type=Path),
    callback=_outputs,
    help="Write the result to FILE too: .txt, .json, .xml (JUnit), .html or .svg, a badge. May be given several times.",
    metavar="FILE",
)
@click.option("--profile", type=EDITION, metavar="EDITION", help="Judge every log by this edition of the manual.")
@set_option("Judge every log by this reading of an open question. May be given several times.")
@click.option(
    "--cpu-address", metavar="ADDRESS", help="Run them on this CPU, snap7://HOST:RACK:SLOT, in place of COMMAND."
)
@click.option("--stop-cpu-and-set-clock", "consent", is_flag=True, help="Agree that --cpu-address does that.")
@click.option("--port", type=click.IntRange(1, 65535), default=102, show_default=True, help="TCP port of that CPU.")
@click.option(
    "--latency", type=click.IntRange(0), default=100, show_default=True, metavar="MS", help="Latency of its logs."
)
@click.argument("command", nargs=-1, type=click.UNPROCESSED)
def run_command(
    only: tuple[str, ...],
    requirements: tuple[str, ...],
    files: tuple[Path, ...],
    offer: tuple[Offer, Path | None],
    cover: Aim | None,
    budget: int | None,
    shard: tuple[int, int],
    fail_fast: bool,
    timeouts: int,
    implementation: str,
    baseline: dict[str, str],
    jobs: int | None,
    timeout: float,
    resume: Path | None,
    logs: Path | None,
    outputs: tuple[Path, ...],
    profile: str | None,
    letters: dict[str, str],
    cpu_address: str | None,
    consent: bool,
    port: int,
    latency: int,
    command: tuple[str, ...],
) -> int:
    r"""Run the programs through the adapter COMMAND, judge each log, and say which requirements are kept.

    Write -- before the command. The adapter reads a program a line from standard input and writes its log to standard
    output, with the line {"event": "done"} behind it. Or --cpu-address: a CPU with the interpreter of
    instrumentation/awl in it, which nobody has tried on a real one yet.

    \b
    Exit codes: 0 no program failed, 1 one did, 2 wrong arguments, 3 a log could not be judged.
    """
    if (cpu_address is None) != bool(command):
        raise click.UsageError("expected either COMMAND, behind --, or --cpu-address")
    on_cpu = list if cpu_address is None else _on_cpu(offer[0], consent, cpu_address, port)
    programs = on_cpu(_chosen(files, only, requirements))
    if cover is not None:
        runs = [one for one in programs if not offer[0].lacks(offer[0].fitted(one))]
        programs = covering([one for one in runs if cpu_address is None or not lacks(one)], cover, budget)
    elif budget is not None:
        raise click.UsageError("--budget: expected --cover beside it")
    programs = part_of(programs, *shard)
    if cpu_address is not None:
        command, jobs = (sys.executable, "-m", "s7check.live.lane", cpu_address, str(port), str(latency)), 1
        timeout = max([timeout, *(one.duration / 1000 + _LANE_S for one in programs)])
    run = this_run(programs, implementation, command, offer[1], profile, letters)
    runner = Runner(
        command,
        jobs=jobs or os.cpu_count() or 1,
        timeout=timeout,
        offer=offer[0],
        logs=logs,
        resume=resume,
        profile=profile,
        letters=letters,
        fail_fast=fail_fast,
        timeouts=timeouts,
    )
    try:
        with ProgressBar(len(programs)) as progress:

            def told(result: Result) -> None:
                progress.done()
                progress.begin(result.name)

            results = runner.run(programs, told)
        kept = Kept(results, outcomes(results), run)
        echo(formats.to_summary(results))
        if baseline:
            echo("\n".join(changes(baseline, results)))
        if len(results) < len(programs):
            echo(f"broken off: {len(programs) - len(results)} programs were not run")
        for output in outputs:
            write_whole(output, formats.FORMATS[output.suffix](kept))
    except AdapterError as error:
        raise click.ClickException(str(error)) from error
    except OSError as error:
        raise click.FileError(str(error.filename), hint=error.strerror or str(error)) from error
    return _exit_code([result for result in results if not is_known(baseline, result)])


def _on_cpu(offer: Offer, consent: bool, address: str, port: int) -> Callable[[Iterable[Program]], list[Program]]:
    """Puts programs on a real CPU, which answers, with its OBs."""
    if not consent:
        raise click.UsageError("--cpu-address stops the CPU and sets its clock: expected --stop-cpu-and-set-clock, too")
    families, obs = list(offer.cpu or ()), offer.obs
    if obs is None or len(families) != 1:
        raise click.UsageError("--cpu-address: expected --offer FILE with cpu, one family, and obs, the OBs in the CPU")
    try:
        live.client(live.parse(address, port)).disconnect()
    except SourceError as error:
        raise click.ClickException(f"{address}: {error}") from error
    return lambda programs: [fitted(program, families[0], obs) for program in programs]


@kit_command.command("matrix", short_help="Put the results of several implementations side by side.")
@click.option("--output", type=click.Path(dir_okay=False, path_type=Path), help="Write to FILE.", metavar="FILE")
@click.argument("runs", nargs=-1, required=True, metavar="NAME=FILE...")
def matrix_command(output: Path | None, runs: tuple[str, ...]) -> int:
    """Write a page in Markdown with a row for each requirement and a column for each implementation NAME.

    FILE is the .json of its `s7check kit run --output`.
    """
    read = {}
    for run in runs:
        name, given, file = run.partition("=")
        if not given:
            raise click.ClickException(f"expected NAME=FILE, such as plc=results.json; found {run}")
        try:
            read[name] = msgspec.json.decode(Path(file).read_bytes(), type=Kept).requirements
        except (OSError, msgspec.MsgspecError) as error:
            said = error.strerror if isinstance(error, OSError) else str(error)
            raise click.ClickException(f"{file}: expected a result of `s7check kit run`; found {said}") from error
    page = to_matrix(read)
    if output is None:
        echo(page.rstrip("\n"))
    else:
        write_whole(output, page.encode())
    return 0


def _exit_code(results: list[Result]) -> int:
    statuses = {result.status for result in results}
    return 3 if "no verdict" in statuses else 1 if FAILED & statuses else 0

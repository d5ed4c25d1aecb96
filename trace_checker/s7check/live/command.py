"""``s7check watch``."""

import sys
from contextlib import closing
from pathlib import Path
from time import monotonic, sleep
from typing import Any

import click

from s7check.ending import ending
from s7check.importing.errors import SourceError
from s7check.importing.options import Cpu, JsonFile, Obs, Words
from s7check.importing.sources import live
from s7check.letters import set_option
from s7check.live.connection import Connection
from s7check.live.view import Plain, Terminal, View
from s7check.live.watch import Watch
from s7check.output import echo
from s7check.report.as_text import TextReports

_HELP = f"""Judge a running CPU by the log that its program writes.

ADDRESS is snap7://HOST:RACK:SLOT (rack 0, slot 2 for an S7-300); needs python-snap7: {live.INSTALL}. Of the CPU are
read the ring of the SCL instrumentation (--db), the diagnostic buffer, the mode, the clock, and the states of OBs.
Nothing is written to it.

\b
  s7check watch snap7://192.168.0.1:0:2 --cpu S7-300 --obs 1,10,80,100 --records call,ob -o run.ndjson

Nobody has tried this on a real CPU yet (docs/checking/watch.md).

\b
Exit codes: 0 every log is accepted, 1 one is rejected, 2 wrong arguments, or the CPU cannot be read, 3 no verdict.
"""

_LONGEST_PAUSE_S = 5.0


@click.command("watch", help=_HELP, short_help="Judge a running CPU, as its log comes.")
@click.option(
    "-o", "--output", type=click.Path(dir_okay=False, path_type=Path), help="The log; the next is FILE-2, ..."
)
@click.option("--db", type=click.IntRange(1, 65535), default=101, show_default=True, help="Data block of the ring.")
@click.option("--cpu", type=Cpu(), help="The CPU's family, S7-300, S7-400 or CPU 318; or its name, such as 315-2DP.")
@click.option("--obs", type=Obs(), metavar="N,N...", help="The OBs loaded in it, such as 1,10,80 or OB1,OB10,OB80.")
@click.option("--latency", type=int, metavar="MS", help="Longest time until an OB that is due has started.")
@set_option("How open questions of the manuals are answered, where not by the default (docs/rules/readings.md).")
@click.option("--step7", type=JsonFile(), metavar="FILE", help="STEP 7 parameters of the OBs, as in the header, JSON.")
@click.option("--records", type=Words(), metavar="KIND,...", help="Kinds that the ring holds completely: call,ob.")
@click.option("--header", "fields", type=JsonFile(), metavar="FILE", help="Any fields of the header, JSON.")
@click.option("--port", type=click.IntRange(1, 65535), default=live.ISO_ON_TCP, show_default=True, help="TCP port.")
@click.option(
    "--poll", type=click.IntRange(10), default=100, show_default=True, metavar="MS", help="Time between polls."
)
@click.option("--seconds", type=float, help="End after so many seconds; at Ctrl-C by default.")
@click.option("--keep-going", is_flag=True, help="Go on after a rejected log.")
@click.argument("address")
def watch_command(
    output: Path | None,
    db: int,
    port: int,
    poll: int,
    seconds: float | None,
    keep_going: bool,
    address: str,
    **options: Any,
) -> int:
    """Watch until something is wrong, the time is over, or Ctrl-C."""
    given = _given(options)
    end = None if seconds is None else monotonic() + seconds
    with ending(address), closing(Connection(_address(address, port), db)) as cpu:
        try:
            watch = Watch(cpu, given, output)
            _follow(watch, address, poll / 1000, end, keep_going)
        except SourceError as error:
            raise click.ClickException(f"{address}: {error}") from error
        except OSError as error:
            raise click.ClickException(f"{output}: cannot be written: {error.strerror or error}") from error
    reports = TextReports()
    for report in watch.reports:
        echo(reports.add(report))
    if not watch.reports:
        echo(f"{address}: no log: {watch.passed_over} events before OB 1 or a restart was seen")
    return max((report.exit_code for report in watch.reports), default=3)


def _address(text: str, port: int) -> live.Address:
    try:
        return live.parse(text, port)
    except SourceError as error:
        raise click.UsageError(f"{text}: {error}") from error


def _follow(watch: Watch, name: str, pause: float, until: float | None, keep_going: bool) -> None:
    view: View = Terminal(name) if sys.stdout is not None and sys.stdout.isatty() else Plain()
    wait = pause
    try:
        while until is None or monotonic() < until:
            watch.step()
            view.show(watch)
            if not keep_going and any(report.verdict != "accepted" for report in watch.reports):
                break
            wait = min(_LONGEST_PAUSE_S, 2 * wait) if watch.trouble else pause
            sleep(wait)
    except KeyboardInterrupt:
        pass
    finally:
        watch.end()
        view.show(watch)
        view.close()


def _given(options: dict[str, Any]) -> dict[str, Any]:
    """The fields of the headers that the user gives; an option counts more than --header."""
    fields = {name: options[name] for name in ("cpu", "obs", "step7", "records")}
    fields |= {"latency_ms": options["latency"], "readings": options["letters"] or None}
    given: dict[str, Any] = options["fields"] or {}
    given |= {name: value for name, value in fields.items() if value is not None}
    for name in ("cpu", "obs"):
        if name not in given:
            raise click.UsageError(f"--{name}: expected it, or --header with it; found none")
    return given

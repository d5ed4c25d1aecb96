"""``s7check import``."""

import json
from pathlib import Path
from typing import Any

import click

from s7check.completion import complete_files
from s7check.importing.asking import Imported, kind_of, log_of
from s7check.importing.errors import SourceError
from s7check.importing.options import Cpu, JsonFile, Obs, Words
from s7check.importing.sources import csv_text, live
from s7check.letters import set_option
from s7check.log.errors import printable
from s7check.output import echo, write_whole

_KINDS = ("step7", "szl", "csv", "ring")

LARGEST = 16 * 1024 * 1024
"""Bytes of the largest source; the whole of it is in memory."""


_HELP = f"""Turn the records of a CPU into a log for s7check trace.

SOURCE is a file, - for standard input, or a CPU, snap7://HOST:RACK:SLOT (rack 0, slot 2 for an
S7-300), which needs python-snap7: {live.INSTALL}.

\b
--from
  step7  the diagnostic buffer as STEP 7 V5 saves it as text
         (Module Information, Diagnostic Buffer, Save As)
  szl    records of SZL 16#00A0, 20 bytes each, binary or hexadecimal digits
  csv    one event a row; --map says which column is which field
  ring   the data block that the SCL instrumentation writes, binary or
         hexadecimal digits

The log's header needs what no source tells: --cpu, --obs, and --mode where SOURCE does not show
it; or --header, a file that holds any of the header's fields. What SOURCE does not tell is left
out of the log; its field "records" lists the kinds of event that are complete.

\b
Examples:
  s7check import --from step7 buffer.txt --cpu S7-400 --obs 1,10,80,85,100 -o log.ndjson
  s7check import snap7://192.168.0.1:0:2 --cpu S7-300 --obs 1,10,80 -o log.ndjson
  s7check import --from ring --db 101 snap7://192.168.0.1:0:2 --header plant.json -o log.ndjson

Standard error says how many entries were read and skipped, and why. The output is written whole
or not at all.

\b
Exit codes:
  0  the log is written
  2  SOURCE or an option cannot be used: which entry, and what was expected;
     or the log cannot be written
  3  something else failed
"""


@click.command("import", help=_HELP, short_help="Turn a diagnostic buffer, CSV or ring into a log.")
@click.option(
    "--from",
    "kind",
    type=click.Choice(_KINDS),
    help="What SOURCE is (above), where it does not show it; a CPU gives szl by default.",
)
@click.option(
    "-o", "--output", type=click.Path(dir_okay=False, path_type=Path), help="The log; standard output by default."
)
@click.option("--cpu", type=Cpu(), help="The CPU's family, S7-300, S7-400 or CPU 318; or its name, such as 315-2DP.")
@click.option("--obs", type=Obs(), metavar="N,N...", help="The OBs loaded in it, such as 1,10,80 or OB1,OB10,OB80.")
@click.option("--clock", metavar="TIME", help="Its clock when the log begins; that of the first event by default.")
@click.option("--mode", type=click.Choice(["STOP", "STARTUP", "RUN"]), help="Its mode then, if SOURCE does not tell.")
@click.option(
    "--latency",
    type=int,
    metavar="MS",
    help="Longest time in milliseconds until an OB that is due has started; 10 by default.",
)
@set_option("How open questions of the manuals are answered, where not by the default (docs/rules/readings.md).")
@click.option("--step7", type=JsonFile(), metavar="FILE", help="STEP 7 parameters of the OBs, as in the header, JSON.")
@click.option("--records", type=Words(), metavar="KIND,...", help="Kinds of event that SOURCE holds completely.")
@click.option("--header", "fields", type=JsonFile(), metavar="FILE", help="Any fields of the header, JSON.")
@click.option("--entries", metavar="A-B", help="Only entries A to B, as SOURCE numbers them.")
@click.option("--dates", type=click.Choice(["DMY", "MDY", "YMD"]), help="Order of day, month, year in a step7 text.")
@click.option(
    "--map",
    "columns",
    type=click.Path(exists=True, dir_okay=False),
    metavar="FILE",
    help="For csv: which column is which field of the log, JSON (docs/checking/import.md).",
)
@click.option("--db", type=click.IntRange(1, 65535), help="Number of the ring's data block in the CPU.")
@click.option(
    "--port", type=click.IntRange(1, 65535), default=live.ISO_ON_TCP, show_default=True, help="TCP port of the CPU."
)
@click.argument("source", metavar="SOURCE", shell_complete=complete_files)
def import_command(kind: str | None, output: Path | None, source: str, **options: Any) -> int:
    """Imports ``source``; the help says how."""
    name = "standard input" if source == "-" else printable(source, 200)
    try:
        imported = _imported(kind, source, options)
    except SourceError as error:
        raise click.ClickException(f"{name}: {error}") from error
    text = "".join(json.dumps(line, ensure_ascii=False) + "\n" for line in imported.log).encode()
    if output is None:
        echo(text)
    else:
        try:
            write_whole(output, text)
        except OSError as error:
            raise click.ClickException(f"{output}: cannot be written: {error.strerror}") from error
    first, *rest = imported.told
    for line in (f"{name}: {first}", *(f"  {line}" for line in rest)):
        click.echo(line, err=True)
    return 0


def _imported(kind: str | None, source: str, options: dict[str, Any]) -> Imported:
    """The log of the source."""
    given = _given(options)
    remarks: list[str] = []
    if source.startswith(live.SCHEME):
        kind = kind or "szl"
        content, remarks = _of_cpu(kind, live.parse(source, options["port"]), options["db"])
    else:
        content = _content(source)
        kind = kind or ("csv" if options["columns"] is not None else kind_of(content))
    if kind == "program":
        raise click.UsageError("SOURCE is a program of the kit, which `s7check simulate` runs")
    if kind is None:
        raise click.UsageError(
            "--from is missing, and SOURCE does not show what it is: expected the text of a diagnostic buffer (step7), "
            "records of SZL 16#00A0 (szl), the data block of the SCL source (ring), or with --map a table (csv)"
        )
    how = {"entries": options["entries"], "dates": options["dates"], "remarks": remarks}
    if kind != "csv":
        return log_of(content, kind, given, **how)
    if options["columns"] is None:
        raise click.UsageError(
            "--map is missing: expected a JSON file that says which column is which field (docs/checking/import.md)"
        )
    columns = _content(options["columns"])
    return log_of(csv_text.in_utf8(content, columns), kind, given, **how, map=columns.decode("latin-1"))


def _content(name: str) -> bytes:
    try:
        with click.open_file(name, "rb") as file:
            content: bytes = file.read(LARGEST + 1)
    except (OSError, ValueError, RuntimeError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise SourceError("", "a file that can be read", str(reason)) from error
    if len(content) > LARGEST:
        raise SourceError("", f"a file of at most {LARGEST} bytes", "a larger one")
    return content


def _of_cpu(kind: str, address: live.Address, db: int | None) -> tuple[bytes, list[str]]:
    """The bytes of a source in the CPU, and remarks about them."""
    if kind == "szl":
        return live.read_diagnostic_buffer(address)
    if kind != "ring":
        raise click.UsageError(f"--from {kind}: a CPU gives szl or ring")
    if db is None:
        raise click.UsageError("--db: which data block is the ring?")
    return live.read_ring(address, db), []


def _given(options: dict[str, Any]) -> dict[str, Any]:
    """The fields of the header that the user gives; an option counts more than --header."""
    fields = {name: options[name] for name in ("cpu", "obs", "clock", "mode", "step7", "records")}
    fields["latency_ms"] = options["latency"]
    fields["readings"] = options["letters"] or None
    given: dict[str, Any] = options["fields"] or {}
    return given | {name: value for name, value in fields.items() if value is not None}

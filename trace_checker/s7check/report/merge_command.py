"""``s7check merge``."""

from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click
import msgspec

from s7check.log.errors import printable
from s7check.output import deliver, output_option
from s7check.report.report import EXIT_CODES, Verdict

_HELP = """Merge reports of `s7check trace --format json` into one, with sums.

A REPORT is a file with one JSON object a line, such as each of several machines has written about its part of the
logs; - is standard input. The result is one JSON object: "sums", and "reports" in the order of the files.

Exit codes: as that of `s7check trace` about all of the logs, 0 to 3; 2 also for a file that is no such report.
"""


class _Judged(msgspec.Struct):
    """The part of a log's report that is added up."""

    log: str
    verdict: Verdict
    events: int
    requirements: list[str] = []


@click.command("merge", help=_HELP, short_help="Merge JSON reports of several machines, with sums.")
@output_option
@click.argument("reports", nargs=-1, required=True, type=click.File("rb"), metavar="REPORT...")
def merge_command(file: Path | None, reports: tuple[Any, ...]) -> int:
    """Merge and write."""
    texts: list[bytes] = []
    judged: list[_Judged] = []
    for report in reports:
        for number, line in enumerate(report, 1):
            if line.strip():
                judged.append(_read(line, f"{click.format_filename(report.name)}:{number}"))
                texts.append(line.strip())
    merged = msgspec.json.encode({"sums": sums(judged), "reports": [msgspec.Raw(text) for text in texts]}) + b"\n"
    deliver(merged, file)
    return max((EXIT_CODES[one.verdict] for one in judged), default=0)


def sums(judged: Iterable[_Judged]) -> dict[str, Any]:
    """The number of logs, of each verdict, of explained events, and of the rejections that a requirement decides."""
    verdicts: Counter[str] = Counter(dict.fromkeys(EXIT_CODES, 0))
    requirements: Counter[str] = Counter()
    events = 0
    for one in judged:
        verdicts[one.verdict] += 1
        requirements.update(one.requirements)
        events += one.events
    return {"logs": verdicts.total(), **verdicts, "events": events, "requirements": dict(requirements.most_common())}


def _read(line: bytes, place: str) -> _Judged:
    try:
        return msgspec.json.decode(line, type=_Judged)
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        found = printable(str(error))
        raise click.ClickException(
            f"{place}: expected the report about a log, an object of `s7check trace --format json`; found: {found}"
        ) from error

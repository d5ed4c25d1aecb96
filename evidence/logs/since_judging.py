"""The verdicts of a checkout about logs, by its own command ``s7check trace``."""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path

import msgspec

from evidence.logs.revision import BuildError, Checkout

BATCH = 500
"""Logs of one call: their names have to fit into a command line."""


class Judged(msgspec.Struct, frozen=True):
    """The report of ``s7check trace --format json`` about a log. `line` is physical, counted from 1."""

    verdict: str
    line: int | None
    requirements: list[str]
    message: str

    def __str__(self) -> str:
        return self.verdict if self.line is None else f"{self.verdict} at line {self.line}"


def judge(checkout: Checkout, logs: Mapping[str, Path]) -> dict[str, Judged]:
    """Judge logs by name. Raises `BuildError` if the command does not report about each of them."""
    found: dict[str, Judged] = {}
    for first in range(0, len(logs), BATCH):
        names = list(logs)[first : first + BATCH]
        found |= dict(zip(names, _reports(checkout, [logs[name] for name in names]), strict=True))
    return found


def _reports(checkout: Checkout, files: list[Path]) -> list[Judged]:
    with tempfile.TemporaryDirectory(prefix="s7check-since-") as temporary:
        output = Path(temporary) / "reports"
        command = [str(checkout.s7check), "trace", "--format", "json", "--readings", "none", "--output", str(output)]
        environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "VIRTUAL_ENV")}
        run = subprocess.run([*command, *map(str, files)], env=environment, capture_output=True, text=True, check=False)
        lines = output.read_bytes().splitlines() if output.is_file() else []
    try:
        reports = [msgspec.json.decode(line, type=Judged) for line in lines]
    except msgspec.MsgspecError as error:
        raise BuildError(f"{checkout.s7check} trace --format json: {error}") from error
    if len(reports) != len(files):
        raise BuildError(
            f"{checkout.s7check} trace reported about {len(reports)} of {len(files)} logs "
            f"(exit code {run.returncode}): {run.stderr.strip()[-1000:]}"
        )
    return reports

"""``s7spec views vectors``: the cases of traces/ as test vectors for other languages, a JSON file each."""

from __future__ import annotations

import base64
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click
import msgspec

import s7check
from evidence.common.cases import TRACES, Case, CasesError, read_cases
from evidence.common.checkout import ROOT
from evidence.common.console import plain
from evidence.common.options import folder_option
from evidence.common.processes import Processes
from evidence.common.session import session
from s7check.engine.client import Engine
from s7check.engine.command import EngineError

FORMAT = "s7-interrupt-vectors/1"
SCHEMA = TRACES / "schema" / "s7-interrupt-vectors-1.schema.json"


@click.command(name="vectors", short_help="Write the cases of traces/ as test vectors in JSON.")
@folder_option("--output", ROOT / "build" / "views" / "vectors", "Folder of the vectors; its old content is removed.")
def vectors_command(output: Path) -> None:
    """Write a JSON file for each case file, and the JSON Schema of them.

    A log is valid, invalid from a line on, or acceptable under a reading that the sources leave open.
    """
    with session(Processes(), (CasesError, OSError), (EngineError,)) as console:
        plain(console, f"{output}: {write(output)} vectors")


def write(output: Path) -> int:
    """Write the files to a folder of their own; how many logs they have. Raises CasesError, OSError, EngineError."""
    with Engine() as engine:
        defaults = dict(engine.alternatives().defaults)
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    shutil.copy(SCHEMA, output)
    logs = 0
    for file in sorted(TRACES.rglob("*.txt")):
        cases = list(read_cases(file))
        logs += len(cases)
        path = output / file.relative_to(TRACES).with_suffix(".json")
        path.parent.mkdir(exist_ok=True)
        document = vectors(file.stem, cases, defaults)
        path.write_bytes(msgspec.json.format(msgspec.json.encode(document), indent=1) + b"\n")
    return logs


def vectors(area: str, cases: list[Case], defaults: Mapping[str, str]) -> dict[str, Any]:
    """The document of one area; ``defaults`` are the letters by which a log is judged whose header names none."""
    return {
        "format": FORMAT,
        "schema": SCHEMA.name,
        "version": s7check.__version__,
        "area": area,
        "numberOfTests": len(cases),
        "tests": [vector(case, defaults) for case in cases],
    }


def vector(case: Case, defaults: Mapping[str, str]) -> dict[str, Any]:
    """One test. A log that is accepted is acceptable where a reading decides that, chosen by its header or not."""
    reading = _reading(case, defaults)
    accepted = "acceptable" if reading else "valid"
    return {
        "id": case.id,
        "comment": case.reason,
        "requirements": case.requirements,
        "result": accepted if case.verdict == "accepted" else "invalid",
        "flags": ["unusable"] if case.verdict == "unusable" else [],
        **({"line": case.line} if case.line else {}),
        **({"reading": reading} if reading else {}),
        **_log(case.log),
    }


def _reading(case: Case, defaults: Mapping[str, str]) -> dict[str, str]:
    """The letters, and the edition as ``profile``, that the verdict hangs on."""
    if case.verdict == "unusable":
        return {}
    profile = {"profile": case.header["profile"]} if "profile" in case.header else {}
    chosen: dict[str, str] = profile | case.header.get("readings", {})
    decides = next(iter(case.requirements), "")
    return chosen or ({decides: defaults[decides]} if decides in defaults else {})


def _log(log: bytes) -> dict[str, str]:
    """The bytes of the file, as text where they are that."""
    try:
        return {"log": log.decode()}
    except UnicodeDecodeError:
        return {"base64": base64.b64encode(log).decode()}

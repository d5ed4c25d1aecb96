"""Options that several commands have, and the file that one of them asks for."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from evidence.common.checkout import MANIFEST, ROOT

Command = TypeVar("Command", bound=Callable[..., Any])


def folder_option(name: str, default: Path, said: str) -> Callable[[Command], Command]:
    """An option for a folder that the command writes."""
    shown = default.relative_to(ROOT) if default.is_relative_to(ROOT) else default
    kind = click.Path(path_type=Path, file_okay=False)
    return click.option(name, type=kind, default=default, show_default=shown.as_posix(), help=said)


def _part(_context: click.Context, _option: click.Parameter, value: str) -> tuple[int, int]:
    """Read the part and the number of parts."""
    found = re.fullmatch(r"(\d+)/(\d+)", value)
    if not found or not 1 <= int(found[1]) <= int(found[2]):
        raise click.BadParameter(f"{value!r}: expected I/N with I from 1 to N, such as 2/4")
    return int(found[1]), int(found[2])


shard_option = click.option(
    "--shard", metavar="I/N", default="1/1", callback=_part, help="Only the I-th of N parts, for several machines."
)
manifest_option = click.option(
    "--manifest",
    type=click.Path(path_type=Path, dir_okay=False),
    default=ROOT / MANIFEST,
    help="Default: models/models.txt.",
)
tlc_option = click.option(
    "--tlc",
    "jar",
    type=click.Path(path_type=Path),
    help="TLC's jar. Default: $TLA2TOOLS_JAR, or the jar that the build provides.",
)
json_option = click.option(
    "--json", "json_path", type=click.Path(path_type=Path, dir_okay=False), help="Write the results there."
)


def write_json(path: Path | None, document: dict[str, Any]) -> None:
    """Write the results where ``--json`` says, if it does. Raises OSError."""
    if path is not None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")

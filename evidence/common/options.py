"""Options that several commands have, and the file that one of them asks for."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click

from evidence.common.checkout import MANIFEST, ROOT

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

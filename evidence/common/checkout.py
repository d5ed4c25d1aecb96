"""Where things are in the checkout; the tools are installed from it and nowhere else."""

from pathlib import Path

import click

ROOT = Path(__file__).resolve().parents[2]
SOFT_PLC = ROOT / "examples" / "soft_plc"
SOFT_PLC_PROGRAM = SOFT_PLC / "build" / "soft_plc"
MANIFEST = Path("models/manifest.json")
"""The manifest of the models, from the root."""


def check_folder(folder: Path) -> None:
    """The tools read the files of ROOT. Raises `ClickException` for a folder in another checkout, or in none."""
    here = folder.resolve()
    around = next((f for f in (here, *here.parents) if (f / Path(__file__).relative_to(ROOT)).is_file()), None)
    if around != ROOT:
        place = f"in the checkout {around}" if around else "in no checkout"
        raise click.ClickException(
            f"{here} is {place}, but this s7spec checks {ROOT}: go there, or run another checkout's .venv/bin/s7spec"
        )

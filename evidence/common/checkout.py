"""Where things are in the checkout; the tools are installed from it and nowhere else."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOFT_PLC = ROOT / "examples" / "soft_plc"
SOFT_PLC_PROGRAM = SOFT_PLC / "build" / "soft_plc"
MANIFEST = Path("models/models.txt")
"""The manifest of the models, from the root; the negative controls stand beside it."""

"""Outputs of Apalache, recorded for the tests."""

from pathlib import Path

RECORDED = Path(__file__).parent / "fixtures"


def recorded(name: str) -> str:
    """Apalache's output of a run; of the violated one without most of the conditions that hold."""
    return (RECORDED / f"{name}.txt").read_text()

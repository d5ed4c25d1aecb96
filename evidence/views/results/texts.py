"""The texts that a run's numbers depend on, as a hash: where it differs, the numbers are of an older text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import lru_cache

from evidence.common.checkout import ROOT
from evidence.common.texts import digest
from evidence.kit.files import read_text
from evidence.tla.modules import judging, read_modules

_FILES = {
    "models": ("models/*.cfg", "models/*.txt"),
    "proofs": ("models/proofs.json",),
    "cases": ("traces/*.txt", "traces/by_hand/*.txt"),
    "engine": ("trace_checker/engine/src/main/**/*.java",),
    "checker": ("trace_checker/s7check/**/*.py",),
    "kit": ("kit/*.ndjson*", "evidence/kit/*.py"),
    "soft PLC": ("examples/soft_plc/**/*.[ch]",),
}
"""The files of each part. Three parts have TLA+ modules, without comments and layout: ``spec`` and ``models``
those of their folder, ``judging`` those of spec/ that the engine reads."""

_TIMES = re.compile(r", seconds [\d.]+\.\.\d+")
"""How long a model may take, which is of a machine."""


def origin(parts: Iterable[str]) -> str:
    """The hash of these parts of the checkout. Raises OSError."""
    return digest(text for part in parts for text in _part(part))


@lru_cache
def _part(part: str) -> tuple[str, ...]:
    found = [file for pattern in _FILES.get(part, ()) for file in sorted(ROOT.glob(pattern))]
    sources = [file for file in found if "build" not in file.relative_to(ROOT).parts]  # a run makes files there
    return (*_modules(part), *(_TIMES.sub("", read_text(file)) for file in sources))


def _modules(part: str) -> Iterator[str]:
    if part in ("spec", "models"):
        yield from (module.code for _, module in sorted(read_modules(ROOT / part).items()))
    if part == "judging":
        yield from (module.code for module in judging(read_modules(ROOT / "spec")).values())

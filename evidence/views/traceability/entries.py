"""The entries of a requirement in one column."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Entries:
    """Names of formulas, controls or logs. The first `direct` ones are about the requirement, the others touch it."""

    names: tuple[str, ...] = ()
    direct: int = 0


def entries(direct: list[str], indirect: list[str]) -> Entries:
    """The distinct names, the direct ones first."""
    first = tuple(dict.fromkeys(direct))
    return Entries((*first, *dict.fromkeys(name for name in indirect if name not in first)), len(first))

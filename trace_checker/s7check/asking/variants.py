"""Other headers for the same log: another CPU, another edition, another reading."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import click

from s7check.engine import pool
from s7check.engine.answer import Alternatives
from s7check.letters import EDITION, Letters, OneOf


@dataclass(frozen=True)
class Variant:
    """A change of a header, and its name, such as ``cpu S7-400`` or ``AMB-12 a``."""

    name: str
    cpu: str | None = None
    profile: str | None = None
    letters: tuple[tuple[str, str], ...] = ()

    def of(self, header: Mapping[str, Any]) -> dict[str, Any]:
        """The header, an object as in a log, with this change."""
        changed = dict(header)
        if self.cpu is not None:
            changed = fitted(changed, self.cpu, pool.alternatives())
        if self.profile is not None:
            changed["profile"] = self.profile
        if self.letters:
            changed["readings"] = {**changed.get("readings", {}), **dict(self.letters)}
        return changed


def fitted(header: Mapping[str, Any], cpu: str, words: Alternatives) -> dict[str, Any]:
    """The header on a CPU of another family, without OBs and priorities that this one does not have."""
    changed = {**header, "cpu": cpu}
    lacking = dict(words.unknown).get(cpu, [])
    if isinstance(changed.get("obs"), list):
        changed["obs"] = [ob for ob in changed["obs"] if ob not in lacking]
    if "priority" in changed:
        classes = dict(next((some for name, some in words.classes if name == cpu), []))
        changed["priority"] = {
            ob: level for ob, level in changed["priority"].items() if level in classes.get(int(ob), [])
        }
        if cpu not in words.settable or not changed["priority"]:
            del changed["priority"]
    return changed


AS_IT_IS = Variant("as it is")
"""No change."""


def variants(cpus: Iterable[str], profiles: Iterable[str], readings: Iterable[Mapping[str, str]]) -> list[Variant]:
    """The variants that the options of a command name, each once."""
    named = [
        *(Variant(f"cpu {cpu}", cpu=cpu) for cpu in cpus),
        *(Variant(f"profile {profile}", profile=profile) for profile in profiles),
        *(
            Variant(", ".join(f"{name} {letter}" for name, letter in letters.items()), letters=tuple(letters.items()))
            for letters in readings
        ),
    ]
    return list(dict.fromkeys(named))


def variant_options(command: click.decorators.FC) -> click.decorators.FC:
    """The options ``--cpu``, ``--profile`` and ``--reading``, each any number of times."""
    options: list[Callable[[click.decorators.FC], click.decorators.FC]] = [
        click.option(
            "--cpu",
            "cpus",
            multiple=True,
            type=OneOf("families"),
            metavar="FAMILY",
            help="In this CPU. May be given several times.",
        ),
        click.option(
            "--profile",
            "profiles",
            multiple=True,
            type=EDITION,
            metavar="EDITION",
            help="By this edition of the manual. May be given several times.",
        ),
        click.option(
            "--reading",
            "readings",
            multiple=True,
            type=Letters(),
            metavar="AMB-NN=LETTER,...",
            help="By this reading of an open question (docs/rules/readings.md). May be given several times.",
        ),
    ]
    for option in reversed(options):
        command = option(command)
    return command

"""The programs that a call means: those of the kit or of files, and a choice among them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fnmatch import fnmatchcase
from pathlib import Path

from s7check.kit.program import Program, read_programs
from s7check.log.errors import UnusableLogError
from s7check.resources import INSTALLED, KIT

_ENDINGS = (".json", ".ndjson")


class UnreadableProgramError(Exception):
    """A file of programs cannot be read; the text names file, line and field."""


def programs_of(files: Sequence[Path] = ()) -> list[Program]:
    """The programs in files, and in folders with ``*.json`` and ``*.ndjson``; those of the kit where none is named.

    Raises UnreadableProgramError, also for a name that two programs have.
    """
    if not files and not KIT.is_dir():
        remedy = "install s7check again" if INSTALLED else "run `make setup`"
        raise UnreadableProgramError(f"{KIT}: expected the folder with the programs of the kit: {remedy}")
    programs: dict[str, Program] = {}
    for file in _files(files or [KIT]):
        try:
            for program in read_programs(file):
                if program.name in programs:
                    raise UnreadableProgramError(f"{file}: expected each name once; found {program.name} again")
                programs[program.name] = program
        except UnusableLogError as error:
            raise UnreadableProgramError(f"{file}: {error}") from error
        except OSError as error:
            raise UnreadableProgramError(f"{file}: expected a file that can be read; found {error.strerror}") from error
    return list(programs.values())


def _files(names: Iterable[Path]) -> Iterable[Path]:
    for name in names:
        if name.is_dir():
            yield from sorted(file for file in name.iterdir() if file.suffix in _ENDINGS)
        else:
            yield name


def chosen(programs: Iterable[Program], patterns: Sequence[str], requirements: Sequence[str]) -> list[Program]:
    """Programs whose name fits a pattern and that are about a requirement or reach it; an empty choice leaves all."""
    return [
        program
        for program in programs
        if (not patterns or any(fnmatchcase(program.name, pattern) for pattern in patterns))
        and (not requirements or set(requirements) & {*program.requirements, *program.reaches})
    ]

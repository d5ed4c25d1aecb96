"""Puts a TLA+ module and all that it extends into one, for Apalache.

Apalache 0.62.1 takes half as long again for the type check of System where it follows EXTENDS
itself. Before a check it also inlines what the check does not need; --only leaves that out.
The definitions are copied as they stand.

usage: flatten.py [--only NAME,...] MODULE FOLDER...
(writes the module to standard output; the folders are searched in turn; NAMEs are operators, which
are kept with what they use)
"""

import re
import sys
from collections.abc import Iterable
from pathlib import Path

STANDARD = {"Integers", "Sequences", "FiniteSets"}
MODULE = re.compile(r"^-{4,} *MODULE \w+ *-{4,}\n(.*?)^={4,}", re.DOTALL | re.MULTILINE)
EXTENDS = re.compile(r"^EXTENDS\s+(\w+(?:\s*,\s*\w+)*)", re.MULTILINE)
DEFINITION = re.compile(r"^(?P<types>(?:\\\* @type.*\n)*)(?P<name>[A-Za-z]\w*)(?:\([^=]*\))? *==", re.MULTILINE)
"""Up to the == of a definition, which begins in the first column in spec/ and models/."""
OTHER = re.compile(r"^(?:\(\*|-{4,}|VARIABLES?\b|ASSUME\b|\\\*)", re.MULTILINE)
"""What else begins in the first column, and ends a definition."""


def flatten(top: str, folders: list[Path]) -> str:
    """The modules' text in order, without the lines that name them and what they extend."""
    bodies: dict[str, str] = {}

    def add(name: str) -> None:
        if name in STANDARD or name in bodies:
            return
        path = next((p for p in (folder / f"{name}.tla" for folder in folders) if p.is_file()), None)
        module = MODULE.search(path.read_text(encoding="utf-8")) if path else None
        if module is None:
            sys.exit(f"flatten.py: {name}.tla: expected a module in {', '.join(map(str, folders))}")
        extends = EXTENDS.search(module[1])
        for extended in re.split(r"[,\s]+", extends[1].strip()) if extends else []:
            add(extended)
        bodies[name] = EXTENDS.sub("", module[1], count=1)

    add(top)
    return "".join(bodies.values())


def keep_only(text: str, names: Iterable[str]) -> str:
    """The text without the definitions that the names do not need."""
    definitions: dict[str, tuple[int, int]] = {}
    for found in DEFINITION.finditer(text):
        other = OTHER.search(text, found.end())
        following = DEFINITION.search(text, found.end())
        ends = [match.start() for match in (other, following) if match]
        definitions[found["name"]] = (found.start(), min(ends, default=len(text)))
    needed: set[str] = set()
    asked = list(names)
    while asked:
        name = asked.pop()
        if name in definitions and name not in needed:
            needed.add(name)
            asked += re.findall(r"\w+", text[slice(*definitions[name])])
    kept, end = "", 0
    for name, (start, stop) in definitions.items():
        kept += text[end : stop if name in needed else start]
        end = stop
    return kept + text[end:]


def main(arguments: list[str]) -> None:
    """Write the module that the command line asks for."""
    only = None
    if arguments[:1] == ["--only"]:
        only, arguments = arguments[1].split(","), arguments[2:]
    if len(arguments) < 2:
        sys.exit(__doc__)
    text = flatten(arguments[0], [Path(folder) for folder in arguments[1:]])
    if only is not None:
        text = keep_only(text, only)
    sys.stdout.write(f"---- MODULE {arguments[0]} ----\nEXTENDS {', '.join(sorted(STANDARD))}\n{text}====\n")


if __name__ == "__main__":
    main(sys.argv[1:])

"""Puts a TLA+ module and all that it extends into one, for Apalache.

The time that Apalache 0.62.1 takes to import a module doubles with each step of a chain of EXTENDS,
and that of spec/ is 25 modules long. The definitions are copied as they stand.

usage: flatten.py MODULE FOLDER...    (writes the module to standard output; the folders are searched in turn)
"""

import re
import sys
from pathlib import Path

STANDARD = {"Integers", "Sequences", "FiniteSets"}
MODULE = re.compile(r"^-{4,} *MODULE \w+ *-{4,}\n(.*?)^={4,}", re.DOTALL | re.MULTILINE)
EXTENDS = re.compile(r"^EXTENDS (.+)$", re.MULTILINE)


def flatten(top: str, folders: list[Path]) -> str:
    """The text of a module ``top`` that extends standard modules alone."""
    bodies: dict[str, str] = {}
    standard: set[str] = set()

    def add(name: str) -> None:
        if name in STANDARD:
            standard.add(name)
        elif name not in bodies:
            path = next((p for p in (folder / f"{name}.tla" for folder in folders) if p.is_file()), None)
            module = MODULE.search(path.read_text(encoding="utf-8")) if path else None
            if module is None:
                sys.exit(f"flatten.py: {name}.tla: expected a module in {', '.join(map(str, folders))}")
            extends = EXTENDS.search(module[1])
            for extended in re.split(r"[,\s]+", extends[1].strip()) if extends else []:
                add(extended)
            bodies[name] = EXTENDS.sub("", module[1], count=1)

    add(top)
    return f"---- MODULE {top} ----\nEXTENDS {', '.join(sorted(standard))}\n{''.join(bodies.values())}====\n"


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.stdout.write(flatten(sys.argv[1], [Path(folder) for folder in sys.argv[2:]]))

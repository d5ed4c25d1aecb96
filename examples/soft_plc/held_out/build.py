"""Build the soft PLC once for each change of changes.json: build/held_out/NAME, each with one fault.

These faults are held out: they were written from the requirements without a look at the kit, and the kit is not
changed because of them. They say how good the kit is at faults that nobody had in mind when it was made. A change is
a text that occurs once in a file of s7cpu/, and the text in its place.

usage: python3 held_out/build.py [NAME...]        in examples/soft_plc, after `make`
exit:  0 built, 1 a text does not occur exactly once or the compiler refuses it, 2 unknown NAME
"""

import json
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PLC = HERE.parent
BUILD = PLC / "build" / "held_out"


def changed(change: dict[str, str]) -> str:
    """Give the text of the changed file; ValueError unless the old text occurs exactly once."""
    text = (PLC / "s7cpu" / change["file"]).read_text()
    count = text.count(change["old"])
    if count != 1:
        raise ValueError(f"{change['name']}: the old text occurs {count} times in {change['file']}, expected once")
    return text.replace(change["old"], change["new"])


def build(change: dict[str, str]) -> None:
    """Compile the changed file and link it with the other objects of the program."""
    folder = BUILD / "obj" / change["name"]
    folder.mkdir(parents=True, exist_ok=True)
    source = folder / change["file"]
    source.write_text(changed(change))
    compiler = os.environ.get("CC", "cc")
    unit = source.with_suffix(".o")
    subprocess.run([compiler, "-std=c11", "-O2", "-w", f"-I{PLC / 's7cpu'}", "-include", PLC / "faults/substitute.h",
                    f"-DIN_{source.stem}", "-c", "-o", unit, source], check=True)  # fmt: skip
    folders = ("s7cpu", "plc", "scenario", "random", "faults")
    sources = [c.relative_to(PLC) for name in folders for c in (PLC / name).glob("*.c")]
    objects = [PLC / "build" / "obj" / c.with_suffix(".o") for c in sources if c.parts != ("s7cpu", source.name)]
    subprocess.run([compiler, "-o", BUILD / change["name"], unit, *objects], check=True)


def main(names: list[str]) -> int:
    """Build the named changes, or all."""
    changes = {c["name"]: c for c in json.loads((HERE / "changes.json").read_text())}
    unknown = sorted(set(names) - set(changes))
    if unknown:
        sys.stderr.write(f"held_out/build.py: no such change: {', '.join(unknown)}\n")
        return 2
    for name in names or changes:
        try:
            build(changes[name])
        except (ValueError, subprocess.CalledProcessError) as error:
            sys.stderr.write(f"held_out/build.py: {error}\n")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

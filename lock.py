"""Writes requirements.lock anew: the versions that pip-compile chooses, the wheels that pip takes on each system.

`python lock.py [--keep]`, with pip-tools beside pip; `--keep` leaves the versions as they are. A package of pure Python
has one wheel; of the others there is a wheel for each system and Python below. pip refuses whatever is not listed.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

LOCK = Path("requirements.lock")
PYTHONS = ("3.11", "3.12", "3.13", "3.14")
GLIBC = ("manylinux_2_28", "manylinux_2_17", "manylinux2014", "manylinux2010", "manylinux1")
SYSTEMS = (
    [f"{glibc}_x86_64" for glibc in GLIBC],
    [f"{glibc}_aarch64" for glibc in GLIBC[:3]],
    ["win_amd64"],
    ["macosx_11_0_arm64"],
)


def compile_versions() -> None:
    """Let pip-compile choose versions for requirements.in; those of the lock stay where they still fit."""
    options = ("--quiet", "--allow-unsafe", "--no-header", "--no-annotate", "--strip-extras", "--no-emit-options")
    command = [sys.executable, "-m", "piptools", "compile", *options, "--output-file", LOCK, "requirements.in"]
    subprocess.run(command, check=True)


def chosen(pins: list[str], python: str, platforms: list[str]) -> dict[str, tuple[str, str]]:
    """Name -> file and SHA-256 of the wheel that pip takes for each pin; nothing is installed."""
    options = ["--dry-run", "--no-deps", "--ignore-installed", "--only-binary=:all:", "--target=unused", "--report=-"]
    options += [f"--python-version={python}", *(f"--platform={platform}" for platform in platforms)]
    command = [sys.executable, "-m", "pip", "install", "--quiet", *options, *pins]
    report = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    wheels = [(one["metadata"]["name"], one["download_info"]) for one in report["install"]]
    return {_key(name): (info["url"], info["archive_info"]["hashes"]["sha256"]) for name, info in wheels}


def _key(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def main() -> None:
    """Write the lock."""
    if "--keep" not in sys.argv:
        compile_versions()
    pins = re.findall(r"^[\w.-]+==[\w.]+", LOCK.read_text(encoding="utf-8"), re.MULTILINE)
    hashes: dict[str, set[str]] = {_key(pin.split("==")[0]): set() for pin in pins}
    asked = pins
    for python in PYTHONS:
        for platforms in SYSTEMS:
            wheels = chosen(asked, python, platforms)
            for name, (_, sha256) in wheels.items():
                hashes[name].add(sha256)
            # One wheel serves all where it is of pure Python.
            asked = [p for p in asked if not wheels[_key(p.split("==")[0])][0].endswith("-none-any.whl")]
    text = ""
    for pin in pins:
        lines = [pin, *(f"    --hash=sha256:{one}" for one in sorted(hashes[_key(pin.split("==")[0])]))]
        text += " \\\n".join(lines) + "\n"
    LOCK.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

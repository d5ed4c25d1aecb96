"""A Java program's classes as the JVM itself keeps them (class data sharing): a start costs a third less.

An archive fits one JVM, one set of options and jars. That of the engine is made at its second use on a machine, so a
machine that is thrown away after one use does not pay for it. That of TLC, which runs often in one call, is made at
once.
"""

import os
import subprocess
from contextlib import suppress
from pathlib import Path

from s7check.engine.cache import cache_folder

_KEPT = 8
"""Archives in the cache; each has some 15 MB."""

_PATIENCE = 60

_OPTION = "-XX:SharedArchiveFile="


def archive_options(
    jvm: list[str], jars: list[Path], program: list[str], sample: bytes, at_once: bool = False
) -> list[str]:
    """The options by which the JVM takes its classes from an archive; none if there is no archive.

    ``jvm`` is Java with its options, ``program`` the main class with its arguments, ``sample`` an input at whose end
    it ends; the archive has the classes that it needs for that. ``at_once``: it is made at the first use. Whatever
    fails here is no error: there is no archive.
    """
    import hashlib

    with suppress(OSError, RuntimeError, subprocess.SubprocessError):
        own = os.environ.get("JDK_JAVA_OPTIONS", "")
        parts = [*jvm, own, *map(_state, [Path(jvm[0]).resolve(), *jars])]
        archive = cache_folder() / f"{hashlib.sha256(repr(parts).encode()).hexdigest()[:32]}.jsa"
        if not archive.exists() and (_used_before(archive) or at_once):
            _make(archive, jvm, ["-cp", os.pathsep.join(map(str, jars)), *program], sample)
        if archive.exists():
            # An archive that does not fit after all is no reason to complain.
            return ["-Xlog:disable", f"{_OPTION}{archive}"]
    return []


def forget_archive(command: list[str]) -> bool:
    """Delete the archive of a command whose program failed, since it may be damaged; whether there was one."""
    found = [Path(option.partition("=")[2]) for option in command if option.startswith(_OPTION)]
    for archive in found:
        with suppress(OSError):
            archive.unlink()
    return bool(found)


def _state(file: Path) -> str:
    state = file.stat()
    return f"{file} {state.st_size} {state.st_mtime_ns}"


def _used_before(archive: Path) -> bool:
    archive.parent.mkdir(parents=True, exist_ok=True)
    mark = archive.with_suffix(".used")
    if mark.exists():
        return True
    mark.touch()
    return False


def _make(archive: Path, jvm: list[str], program: list[str], sample: bytes) -> None:
    import tempfile

    with tempfile.TemporaryDirectory(dir=archive.parent, prefix="making-") as folder:
        made = Path(folder) / archive.name
        subprocess.run(
            [*jvm, "-Xlog:disable", f"-XX:ArchiveClassesAtExit={made}", *program],
            cwd=folder,
            input=sample,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            timeout=_PATIENCE,
            check=False,
        )
        if made.exists():
            made.replace(archive)
            archive.with_suffix(".used").unlink(missing_ok=True)
    for old in sorted(archive.parent.glob("*.jsa"), key=lambda file: file.stat().st_mtime_ns)[:-_KEPT]:
        old.unlink()

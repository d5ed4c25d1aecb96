"""Puts the files that resources.py names, and the engine, into the wheel; all else is said in pyproject.toml."""

import os
import runpy
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from setuptools import setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py
from setuptools.errors import ExecError
from setuptools.modified import newer_group

SPECIFICATION = Path("spec")
RULES = (
    "docs/rules/requirements.md",
    "docs/rules/requirements-s7-1500.md",
    "docs/rules/readings.md",
    "docs/rules/differences-s7-1500.txt",
)
KNOWN = ("kit/differences.ndjson", "kit/experiments.ndjson")
FOR_ADAPTERS = (
    *("examples/adapters/template.py", "examples/adapters/toy_cpu.py", "examples/adapters/toy_offer.json"),
    *("docs/checking/kit.md", "docs/checking/log-format.md"),
    *("kit/s7-interrupt-program-1.schema.json", "traces/schema/s7-interrupt-log-1.schema.json"),
)
"""What the author of an adapter needs, in the wheel's folder ``adapters``."""
ENGINE = Path("trace_checker/engine")
CONTENTS = "trace_checker/s7check/engine/contents.py"
TARGET = ENGINE / "target"
JAR = TARGET / "s7-trace-engine.jar"
PLATFORM = os.environ.get("S7CHECK_WHEEL") or sysconfig.get_platform().replace("-", "_").replace(".", "_")
"""The kind of machine that the wheel is for: this one, or ``win_amd64``."""
PAGE = Path("build/page/s7check.html")
EXECUTABLE = TARGET / ("s7-trace-engine.exe" if PLATFORM.startswith("win") else "s7-trace-engine")


class BuildWithData(build_py):
    """An editable installation goes on using the checkout's own files."""

    def run(self) -> None:
        """Copies the packages, then the other files to the places in s7check/resources.py."""
        if self.editable_mode:
            super().run()
            return
        package = Path(self.build_lib) / "s7check"
        # What an earlier build left there would get into the wheel.
        shutil.rmtree(package, ignore_errors=True)
        super().run()
        build_engine()
        shutil.copytree(SPECIFICATION, package / "spec")
        (package / "rules").mkdir()
        for page in RULES:
            shutil.copy(page, package / "rules")
        for name in KNOWN:
            shutil.copy(name, package)
        (package / "adapters").mkdir()
        for name in FOR_ADAPTERS:
            shutil.copy(name, package / "adapters")
        make_programs_and_gallery(package)
        for file in (JAR, *TARGET.glob("lib/*.jar"), *([EXECUTABLE] if is_built(EXECUTABLE) else [])):
            copy = package / "jars" / file.relative_to(TARGET)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, copy)
        if is_built(PAGE) and not newer_group([*SPECIFICATION.rglob("*.tla"), *map(Path, RULES)], PAGE):
            (package / "page").mkdir()
            shutil.copy(PAGE, package / "page")
        parse_specification(package)


class WheelForAMachine(bdist_wheel):
    """With an executable the wheel is for one kind of machine; the executable is static, so any Linux will do."""

    def get_tag(self) -> tuple[str, str, str]:
        """The tag of the wheel."""
        python, abi, platform = super().get_tag()
        if is_built(EXECUTABLE):
            platform = PLATFORM.replace("linux_", "manylinux_2_17_") if PLATFORM.startswith("linux_") else PLATFORM
        return python, abi, platform


def is_built(file: Path) -> bool:
    """Whether `make native` or `make page` has built it of the engine that is there."""
    return file.is_file() and file.stat().st_mtime_ns >= JAR.stat().st_mtime_ns


def make_programs_and_gallery(package: Path) -> None:
    """Makes the programs of the conformance kit, and the logs of the edge cases."""
    sys.path[:0] = [".", "trace_checker"]
    from evidence.common import gallery
    from evidence.kit import programs

    programs.write(package / "programs")
    gallery.write(package / "gallery")


def parse_specification(package: Path) -> None:
    """Has the engine parse the specification, which it would do at its first use; without Java it still does then."""
    java = shutil.which("java")
    if java is None:
        return
    jars = [package / "jars" / JAR.name, *sorted((package / "jars" / "lib").glob("*.jar"))]
    fingerprint = runpy.run_path(CONTENTS)["fingerprint"]
    parsed = (package / "parsed" / f"{fingerprint([*(package / 'spec').rglob('*.tla'), jars[0]])}.tree").resolve()
    parsed.parent.mkdir()
    engine = [java, "-cp", os.pathsep.join(map(str, jars)), "s7.jvm.Main", package / "spec", parsed]
    subprocess.run(engine, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=False)


def build_engine() -> None:
    """Builds the engine unless it is newer than its sources."""
    sources = [ENGINE / "pom.xml", *ENGINE.glob("src/main/**/*.java")]
    if not newer_group(sources, JAR):
        return
    maven = shutil.which("mvn")
    if maven is None:
        raise ExecError(
            f"the engine {JAR} is not built or older than its sources, and there is no Maven (mvn) on the PATH: "
            "install Maven and JDK 17, or build the wheel where they are and install that"
        )
    if subprocess.run([maven, "-q", "-B", "package", "-DskipTests"], cwd=ENGINE, check=False).returncode:
        raise ExecError(f"Maven did not build the engine: see its messages, then try `mvn package` in {ENGINE}")


# The same files make the same bytes: no entry of the wheel has the time of its making.
os.environ.setdefault("SOURCE_DATE_EPOCH", "315532800")
setup(cmdclass={"build_py": BuildWithData, "bdist_wheel": WheelForAMachine})

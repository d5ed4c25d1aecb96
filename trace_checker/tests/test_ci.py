"""The CI of a project: the script behind action.yml and the container, tests by CTest, pinned actions."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.logs import RUN, event, log_text

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "instrumentation" / "ci" / "check.sh"
TEMPLATE = ROOT / "examples" / "adapters" / "template.py"
CTEST = ROOT / "examples" / "ctest"

PATH = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"


def check(folder: Path, **variables: str) -> int:
    """The exit code of the script with these variables."""
    environment = {**os.environ, "PATH": PATH, "RESULTS": str(folder / "results"), **variables}
    return subprocess.run(["bash", SCRIPT], cwd=folder, env=environment, capture_output=True, check=False).returncode


def test_logs_by_pattern(tmp_path: Path) -> None:
    """A rejected log fails the job, and stands in the SARIF."""
    (tmp_path / "good.ndjson").write_bytes(log_text(event("DIS_AIRT", ret=1), header=RUN))
    assert check(tmp_path, LOGS="*.ndjson") == 0
    (tmp_path / "bad.ndjson").write_bytes(log_text(event("EN_AIRT", ret=0), header=RUN))
    assert check(tmp_path, LOGS="*.ndjson") == 1
    (run,) = json.loads((tmp_path / "results" / "s7check.sarif").read_bytes())["runs"]
    assert len(run["results"]) == 1


def test_the_kit(tmp_path: Path) -> None:
    """The adapter runs programs; the page and the badge are written."""
    only = "--only 'AIRT-07-nothing-*'"
    assert check(tmp_path, ADAPTER=f"{sys.executable} {TEMPLATE}", KIT_OPTIONS=only) == 0
    assert {file.name for file in (tmp_path / "results").iterdir()} == {"kit.html", "kit.svg"}
    assert check(tmp_path, ADAPTER="false", KIT_OPTIONS=only) == 1


def test_the_action_passes_its_inputs() -> None:
    """Each input is used, and the script is where the action looks for it."""
    text = (ROOT / "action.yml").read_text(encoding="utf-8")
    declared = re.findall(r"^  ([a-z-]+):$", text.partition("runs:")[0], re.MULTILINE)
    assert set(declared) == set(re.findall(r"inputs\.([a-z-]+)", text))
    assert SCRIPT.relative_to(ROOT).as_posix() in text
    assert SCRIPT.relative_to(ROOT).as_posix() in (ROOT / "Containerfile").read_text(encoding="utf-8")


def test_the_workflows_make_what_there_is() -> None:
    """Each target that a workflow names, also in a matrix, is in the Makefile."""
    targets = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    for workflow in (ROOT / ".github" / "workflows").glob("*.yml"):
        text = workflow.read_text(encoding="utf-8")
        named = {word for run in re.findall(r"\bmake ([a-z -]+)", text) for word in run.split() if word[0] != "-"}
        named |= {word for row in re.findall(r"target: \[(.*)\]", text) for word in re.split(r",\s*", row)}
        assert named <= targets, workflow.name


@pytest.mark.skipif(not shutil.which("cmake"), reason="cmake is not there")
def test_ctest(tmp_path: Path) -> None:
    """The example builds and passes; with a wrong delay it fails at the log."""
    source, build = tmp_path / "source", str(tmp_path / "build")
    shutil.copytree(CTEST, source)
    environment = {**os.environ, "PATH": PATH}

    def tests() -> subprocess.CompletedProcess[str]:
        folder = f"-DS7LOG_FOLDER={ROOT / 'instrumentation'}"
        for command in (
            ["cmake", "-S", str(source), "-B", build, folder],
            ["cmake", "--build", build],
        ):
            subprocess.run(command, env=environment, capture_output=True, check=True)
        ctest = ["ctest", "--test-dir", build, "--output-on-failure"]
        return subprocess.run(ctest, env=environment, capture_output=True, text=True, check=False)

    assert tests().returncode == 0
    program = source / "delay_test.c"
    program.write_text(program.read_text().replace("now_.at += 500, now_.up += 500", "now_.at += 400, now_.up += 400"))
    failed = tests()
    assert failed.returncode != 0
    assert "rejected: no behaviour of the specification explains this line" in failed.stdout


def test_actions_are_pinned() -> None:
    """Each action of another project is named by a commit: a tag can be moved."""
    files = [ROOT / "action.yml", *(ROOT / ".github" / "workflows").glob("*.yml")]
    used = [name for file in files for name in re.findall(r"^\s*(?:- )?uses: (\S+)", file.read_text(), re.MULTILINE)]
    assert len(used) > 10
    assert [name for name in used if name != "./" and not re.fullmatch(r"[\w/-]+@[0-9a-f]{40}", name)] == []

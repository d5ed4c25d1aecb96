"""Controls of one model in one JVM: the same results, and a JVM of its own where that could matter."""

from __future__ import annotations

import contextlib
import subprocess
from dataclasses import replace
from pathlib import Path

from evidence.common.processes import Processes
from evidence.models.entries import Expect
from evidence.models.manifest import load
from evidence.models.runner import Harness, check, prepare
from evidence.tests.models.conftest import Project
from evidence.tla import tlc
from evidence.tla.resident import Residents


class Counting(Processes):
    """Processes that are counted."""

    started = 0

    def start(self, command: list[str], directory: Path, stdin: int = subprocess.DEVNULL) -> subprocess.Popen[str]:
        """Start one more."""
        self.started += 1
        return super().start(command, directory, stdin)


def test_one_jvm_for_the_controls_of_a_model(project: Project) -> None:
    """Three controls in one JVM come to their results; what checks liveness, or drifts, has a JVM of its own."""
    document = project.document
    document["models"][0]["kind"] = "model"
    project.write(document)
    manifest = load(project.path)
    models = {model.name: model for model in manifest.models}
    processes = Counting()
    with contextlib.closing(Residents(processes, 1)) as residents:
        harness = Harness(manifest, tlc.find_toolchain(project.jar), processes, residents=residents)
        for name in ("neg-step", "neg-initial", "neg-step"):
            shared, alone = check(harness, models[name]), check(replace(harness, residents=None), models[name])
            assert shared.ok
            assert (shared.outcome.kind, shared.outcome.counts) == (alone.outcome.kind, alone.outcome.counts)
        assert processes.started == 1 + 3
        wrong = replace(models["neg-step"], expect=Expect(exit=13, property="StepByOne", distinct=99))
        assert check(harness, wrong).count_problems
        assert processes.started == 1 + 3 + 1
        # Other arguments of TLC take another JVM, and TLC checks liveness here.
        assert check(harness, models["neg-returns"]).ok
        assert processes.started == 1 + 3 + 1 + 2


def test_a_jvm_that_ends_is_no_result(project: Project, tmp_path: Path) -> None:
    """Nobody takes it for a result of TLC; the next run starts another."""
    manifest = load(project.path)
    model = next(m for m in manifest.models if m.name == "neg-step")
    tools = tlc.find_toolchain(project.jar)
    space = prepare(tmp_path / "run", manifest, model)
    options = tlc.Options(workers=1, deadlock=True, heap=256, timeout=60, brief=True)
    with contextlib.closing(Residents(Processes(), 1)) as residents:
        broken = replace(tools, sharing=("-XX:+NoSuchOption",))
        assert residents.run("counter", broken, space, options) is None
        run = residents.run("counter", tools, space, options)
        assert run is not None
        assert run.outcome.kind == "action"

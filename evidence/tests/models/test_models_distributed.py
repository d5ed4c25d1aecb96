"""TLC's distributed mode: two workers on this machine find the states that one process finds."""

from __future__ import annotations

from typing import Any

import pytest

from evidence.models import distributed
from evidence.tests.models.conftest import Project
from evidence.tla import tlc

TRIES = 6

SAFE: dict[str, Any] = {
    "name": "safe",
    "base": "counter",
    "kind": "model",
    "lane": "smoke",
    "what": "The counter steps by one.",
    "properties": ["StepByOne"],
    "expect": {"exit": 0, "states": 6, "distinct": 5, "depth": 5},
}


@pytest.fixture
def spread(project: Project) -> Project:
    """Give the project a model without liveness, one that counts wrongly and one that fails."""
    if not distributed.works(tlc.find_toolchain(project.jar)):
        pytest.skip("the distributed mode of this TLC does not work")
    document = project.document
    wrong = {**SAFE, "name": "wrong-pin", "expect": {**SAFE["expect"], "distinct": 6}}
    fails = {**SAFE, "name": "fails", "constants": {"Overshoots": "= TRUE"}}
    project.write({**document, "models": [*document["models"], SAFE, wrong, fails]})
    return project


def test_two_workers_find_the_pinned_states(spread: Project) -> None:
    """Distinct states are as pinned; generated states, which differ, do not matter."""
    code, output, results = spread.run("--distributed", "2", "safe")
    assert code == 0, output
    (model,) = results["models"]
    assert (model["result"], model["distinct"]) == ("passed", 5)


def test_another_count_fails(spread: Project) -> None:
    """A pin that the run does not come to is drift."""
    code, output, _ = spread.run("--distributed", "2", "wrong-pin")
    assert code == 1
    assert "5 distinct, pinned 6" in output


def test_violation_fails(spread: Project) -> None:
    """A violation is seen although TLC's server ends with exit code 0."""
    code, output, _ = spread.run("--distributed", "1", "fails")
    assert code == 1
    assert "something is violated" in output


@pytest.mark.parametrize(("failures", "exit_code"), [(2, 0), (TRIES, 1)])
def test_server_that_breaks(spread: Project, monkeypatch: pytest.MonkeyPatch, failures: int, exit_code: int) -> None:
    """A server that ends by an exception says nothing about the model, which is run again, but not for ever."""
    started: list[list[str]] = []
    breaks = ["sh", "-c", "echo @!@!@STARTMSG 1000:1 @!@!@; exit 1"]
    command = distributed.server_command

    def server(*arguments: Any) -> list[str]:
        started.append(breaks if len(started) < failures else command(*arguments))
        return started[-1]

    monkeypatch.setattr(distributed, "server_command", server)
    monkeypatch.setattr(distributed, "TRIES", TRIES)
    code, output, _ = spread.run("--distributed", "2", "safe")
    # TLC's own server breaks now and then, too: there are more runs than it takes.
    assert code == exit_code, output
    assert failures <= len(started) <= TRIES


@pytest.mark.parametrize(("name", "why"), [("counter", "ignores liveness"), ("neg-step", "only models that must pass")])
def test_what_it_cannot_check_is_not_run(spread: Project, name: str, why: str) -> None:
    """A model that was named and cannot be run fails the command."""
    code, output, _ = spread.run("--distributed", "2", name)
    assert code == 1
    assert why in output
    assert f"{name} was named and not run" in output


@pytest.mark.parametrize("arguments", [("--host", "here"), ("--distributed", "0"), ("--distributed", "2", "--update")])
def test_wrong_arguments(project: Project, arguments: tuple[str, ...]) -> None:
    """Options that make no sense together end with exit code 2."""
    assert project.run(*arguments)[0] == 2


def test_stale_mutation_is_drift(spread: Project) -> None:
    """A replacement that no longer fits is told before anything starts."""
    entry = {**SAFE, "name": "stale", "mutate": [{"module": "Counter.tla", "replace": "no such text", "by": ""}]}
    document = spread.document
    spread.write({**document, "models": [*document["models"], entry]})
    code, output, _ = spread.run("--distributed", "1", "stale")
    assert code == 1
    assert "stale" in output

"""Many logs: several engines, the order of the logs, and no engine that stays behind."""

import threading
import time
from pathlib import Path

import pytest

from s7check.engine.client import Engine
from s7check.judging import workers
from s7check.judging.check import check_log
from s7check.judging.workers import Outcome, Workers
from tests.logs import event, log_text


@pytest.fixture(autouse=True)
def _two_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "_ALONE", 0)
    monkeypatch.setattr(workers, "_processors", lambda: 2)


def results(outcomes: list[Outcome[str]]) -> list[str]:
    """What they have come to."""
    return [outcome.result() for outcome in outcomes]


def test_order(fake_command: list[str]) -> None:
    """The first job ends last; two threads and two engines do all."""
    threads = set()

    def work(number: int, _: Engine) -> int:
        threads.add(threading.get_ident())
        time.sleep(0.3 if number == 0 else 0.01)
        return number

    started: list[Engine] = []

    def start() -> Engine:
        started.append(Engine(lambda: fake_command))
        return started[-1]

    with Workers(start) as pool:
        assert [future.result() for future in pool.in_order(range(30), work)] == list(range(30))
    assert len(threads) == len(started) == 2


def test_one_log_needs_one_engine(fake_command: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """In the first second there is one engine, as most calls need no other."""
    monkeypatch.setattr(workers, "_ALONE", 60)
    started: list[Engine] = []

    def start() -> Engine:
        started.append(Engine(lambda: fake_command))
        return started[-1]

    with Workers(start) as pool:
        assert [future.result() for future in pool.in_order(range(5), lambda number, _: number)] == list(range(5))
    assert len(started) == 1


def test_crash_costs_one_log(fake_command: list[str], tmp_path: Path) -> None:
    """The logs before and after it have their verdicts."""
    logs = []
    for number in range(8):
        last = event("stop", cause=0xDEAD) if number == 3 else event("run")
        logs.append(tmp_path / f"{number}.ndjson")
        logs[-1].write_bytes(log_text(event("run"), last))

    def work(log: Path, engine: Engine) -> str:
        return check_log(str(log), engine, lambda _, __: None).verdict

    with Workers(lambda: Engine(lambda: fake_command)) as pool:
        verdicts = results(list(pool.in_order(logs, work)))
    assert verdicts == [*["accepted"] * 3, "no verdict", *["accepted"] * 4]


def test_broken_off(fake_command: list[str]) -> None:
    """After an exception nobody waits for a job that does not end, and no other job begins."""
    begun: list[int] = []

    def work(number: int, _: Engine) -> None:
        begun.append(number)
        threading.Event().wait(60)

    def broken_off(pool: Workers) -> None:
        with pool:
            for number in range(5):
                pool.submit(number, work)
            raise KeyboardInterrupt

    before = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        broken_off(Workers(lambda: Engine(lambda: fake_command)))
    assert time.monotonic() - before < 30
    assert len(begun) <= 2

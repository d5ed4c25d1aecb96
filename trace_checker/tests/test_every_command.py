"""Every command on logs of every kind: a documented exit code, and no error that nobody meant."""

import json
import shlex
from collections.abc import Sequence
from pathlib import Path

import click
import pytest

from s7check import cli
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.judging import workers
from s7check.resources import FailedError
from tests.logs import RUN, event, log_text
from tests.shipped import CASES, TRACES
from tests.test_simulating import PROGRAM

IMPORTED = Path(__file__).parents[2] / "examples" / "import"
CPU = "--cpu S7-400 --obs 1,10,80,85,100"
SOURCES = [
    f"--from step7 english.txt {CPU}",
    f"--from step7 german.txt {CPU}",
    f"--from szl szl.hex {CPU} --mode RUN",
    f"--from ring ring.hex {CPU} --mode RUN",
    f"--from csv events.csv --map columns.json {CPU} --mode RUN",
]
OWN_FIELDS = log_text(
    event("DIS_AIRT", ret=1, x_note={"{ob}": [1, {"%s": None}]}, x_text="{0} %d {"),
    event("diag", id="W#16#3501", info={"strt_info": "B#16#01"}, x_={}),
    header=RUN | {"x_who": {"{}": 1}},
)

SPREAD = 311
"""Of so many shipped logs one is taken; the number has no factor in common with how cases are written in pairs."""

ON_ALL = [
    *(f"trace --readings none --format {form}" for form in ("text", "json", "junit", "sarif", "html")),
    *(f"coverage --format {form}" for form in ("text", "json", "html")),
]
"""Commands that take many logs."""

ON_EACH = {
    "explain": 1,
    "explain --format json": 1,
    "compare --cpu S7-300 --cpu S7-400": 1,
    """next --why '{"event": "start", "ob": 80, "info": {"flt_id": 2}}'""": 1,
    "next": 4,
    "next --format json": 4,
    "trace --readings none --keep-going": 6,
    "reduce --budget 0": 6,
    "decide": 12,
}
"""Commands for one log, each with a step: the dear ones see fewer logs."""


def run(arguments: Sequence[str]) -> int:
    """The exit code; an error that is not meant for a user is raised."""
    try:
        code = cli.cli.main(list(arguments), prog_name="s7check", standalone_mode=False)
    except click.ClickException:
        return 2
    except FailedError:
        return 3
    except (click.exceptions.Exit, SystemExit) as end:
        code = end.exit_code if isinstance(end, click.exceptions.Exit) else end.code
    return code if isinstance(code, int) else 0


@pytest.fixture(autouse=True)
def _one_engine(real_engine: Engine, monkeypatch: pytest.MonkeyPatch) -> None:
    """All commands have the same warm engine: most of the time would go into starting others."""
    monkeypatch.setattr(workers, "_processors", lambda: 1)
    monkeypatch.setattr(pool, "take", lambda: real_engine)
    monkeypatch.setattr(pool, "give_back", lambda _: None)
    monkeypatch.setattr(real_engine, "__exit__", lambda *_: None, raising=False)


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Shipped logs of all areas and verdicts, one of each imported kind, one with fields of its own."""
    folder = tmp_path_factory.mktemp("logs")
    for number, source in enumerate(SOURCES):
        arguments = [str(IMPORTED / part) if (IMPORTED / part).is_file() else part for part in shlex.split(source)]
        assert run(["import", *arguments, "-o", str(folder / f"imported-{number}.ndjson")]) == 0
    (folder / "own-fields.ndjson").write_bytes(OWN_FIELDS)
    (folder / "none.ndjson").write_bytes(b"")
    return [TRACES / case.file for case in CASES[::SPREAD]] + sorted(folder.iterdir())


@pytest.mark.parametrize("command", ON_ALL)
def test_on_all(command: str, logs: list[Path], capsys: pytest.CaptureFixture[str]) -> None:
    """The logs have every verdict, and the highest code counts."""
    assert run([*shlex.split(command), *map(str, logs)]) == 2
    assert capsys.readouterr().out


@pytest.mark.parametrize("command", ON_EACH)
def test_on_each(command: str, logs: list[Path], capsys: pytest.CaptureFixture[str]) -> None:
    """Each log has an answer or is unusable."""
    codes = {log.name: run([*shlex.split(command), str(log)]) for log in logs[:: -ON_EACH[command]]}
    assert {name: code for name, code in codes.items() if code not in (0, 1, 2)} == {}
    assert {0, 1} & set(codes.values())
    if "json" in command:
        assert all(json.loads(line) for line in capsys.readouterr().out.splitlines())


@pytest.mark.parametrize("options", ["", "--seed 3", "--all", "--all --format json", "--cpu S7-300"])
def test_simulate(options: str, tmp_path: Path) -> None:
    """A program, and what is none."""
    (tmp_path / "program.json").write_text(json.dumps(PROGRAM))
    assert run(["simulate", *options.split(), str(tmp_path / "program.json")]) == 0
    for text in ("", "[]", "{", '{"format": "s7-interrupt-log/1"}', "\xff"):
        (tmp_path / "none.json").write_text(text)
        assert run(["simulate", *options.split(), str(tmp_path / "none.json")]) == 2


@pytest.mark.parametrize("form", ["text", "json"])
def test_distinguish(form: str, capsys: pytest.CaptureFixture[str]) -> None:
    """What is known of two CPUs, without a search."""
    sides = ["--cpu", "S7-300", "--cpu", "S7-400"]
    assert run(["distinguish", *sides, "--format", form, "--budget", "0", "--pairs", "1"]) in (0, 1)
    assert capsys.readouterr().out

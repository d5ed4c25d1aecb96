"""The example that judges logs on a Dask cluster; it runs where Dask is installed."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from s7check import cli
from tests.shipped import CASES, TRACES

EXAMPLE = Path(cli.__file__).parents[2] / "examples" / "dask" / "judge_logs.py"


def test_loopback_cluster(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Two workers on this machine give the verdicts of the cases, in the order of the logs; `merge` adds them up."""
    pytest.importorskip("distributed")
    cases = CASES[:60]
    logs = [str(TRACES / case.file) for case in cases]
    run = subprocess.run([sys.executable, EXAMPLE, *logs], capture_output=True, timeout=300, check=True)
    reports = [json.loads(line) for line in run.stdout.splitlines()]
    assert [report["log"] for report in reports] == logs
    assert [report["verdict"] for report in reports] == [case.verdict for case in cases]
    (tmp_path / "report.json").write_bytes(run.stdout)
    cli.main(["merge", str(tmp_path / "report.json")])
    assert json.loads(capsys.readouterr().out)["sums"]["logs"] == len(logs)

"""The adapters that the project ships run the kit's programs."""

import json
import sys
from pathlib import Path

import pytest

from s7check.cli import main
from s7check.kit.collection import programs_of
from tests.test_soft_plc import program as soft_plc

__all__ = ["soft_plc"]

ADAPTERS = Path(__file__).parents[3] / "examples" / "adapters"
AWLSIM = Path(__file__).parents[3] / "build" / "awlsim"


def results(folder: Path, *arguments: str) -> list[dict[str, object]]:
    """The results of a run of the kit."""
    output = folder / "result.json"
    main(["kit", "run", "--output", str(output), "--timeout", "30", *arguments])
    programs: list[dict[str, object]] = json.loads(output.read_text(encoding="utf-8"))["programs"]
    return programs


def test_template(tmp_path: Path) -> None:
    """Short enough to be copied; what the toy CPU does right passes, its mistake fails for its requirement."""
    template = ADAPTERS / "template.py"
    assert len(template.read_text(encoding="utf-8").splitlines()) <= 100
    offer = str(ADAPTERS / "toy_offer.json")
    command = ["--offer", offer, "--only", "AIRT-07-*", "--only", "DINT-16-*", "--", sys.executable, str(template)]
    found = results(tmp_path, *command)
    assert {result["status"] for result in found if str(result["name"]).startswith("AIRT")} >= {"passed"}
    failed = {requirement for result in found if result["status"] == "failed" for requirement in result["deciding"]}  # type: ignore[attr-defined]
    assert failed == {"DINT-16"}


@pytest.mark.skipif(not AWLSIM.is_dir(), reason="awlsim is not there; `make test-checker` installs it")
def test_awlsim(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """AWL runs in a simulator that others have written: calls and operands take their way through it."""
    monkeypatch.setenv("PYTHONPATH", str(AWLSIM))
    names = ["AIRT-nesting-002", "DINT-calls-OB-1-S7-300", "DINT-beside-20-21-cancel", "DINT-beside-21-20-start"]
    names += ["TINT-39-every-field-at-its-limit", "TINT-19-end-of-month-on-feb-28-of-a-leap-year"]
    names += ["CLK-05-skip-without-ob-80-stops", "CLK-02-calls-not-recorded-clock-set-back"]
    names += ["OBS-56-log-begins-in-startup", "IRT-01-blocked-missing-obs-do-not-stop"]
    only = [f"--only={name}" for name in names]
    adapter = str(ADAPTERS / "awlsim_adapter.py")
    found = results(tmp_path, "--offer", str(ADAPTERS / "awlsim_offer.json"), *only, "--", sys.executable, adapter)
    assert {result["name"]: result["status"] for result in found} == dict.fromkeys(names, "passed")


def test_soft_plc(soft_plc: str, tmp_path: Path) -> None:
    """A sample of the programs of each area passes, also those that are skipped only for what this CPU lacks."""
    names = [program.name for program in programs_of()][::40]
    found = results(tmp_path, *(f"--only={name}" for name in names), "--", soft_plc, "--kit")
    assert len(found) == len(names)
    assert [result for result in found if result["status"] not in ("passed", "skipped")] == []
    assert sum(result["status"] == "passed" for result in found) > len(names) * 0.9


@pytest.mark.parametrize("fault", ["airt-flag", "dint-no-limit", "month-end-30"])
def test_fault(soft_plc: str, fault: str, tmp_path: Path) -> None:
    """A deliberate mistake is found."""
    only = {"airt-flag": "AIRT-0*", "dint-no-limit": "DINT-04-*", "month-end-30": "TINT-19-*"}[fault]
    found = results(tmp_path, "--only", only, "--", soft_plc, "--kit", "--fault", fault)
    assert any(result["status"] == "failed" and result["deciding"] for result in found)

"""The column "proof" of the traceability page."""

import json
from pathlib import Path

import msgspec
import pytest

from evidence.common.checkout import ROOT
from evidence.models.proofs.queries import load
from evidence.models.proofs.report import as_json
from evidence.views.results import summaries
from evidence.views.traceability.page import _proof
from evidence.views.traceability.project import PROOFS
from evidence.views.traceability.proofs import Proof, read_proofs


def test_the_kept_summary_is_read(tmp_path: Path) -> None:
    """With the headings that the summary of a run has."""
    report = as_json(load(ROOT), [])
    document = {"tables": summaries.proofs(json.dumps(report))}
    (tmp_path / "proofs.json").write_bytes(msgspec.json.encode(document))
    proofs = read_proofs(tmp_path / "proofs.json")
    assert proofs["StackInv"] == Proof(0, 31)
    assert {"EndProp", "AirtCountProp"} <= proofs.keys()


def test_no_run_yet(tmp_path: Path) -> None:
    """Nothing is proved."""
    assert read_proofs(tmp_path / "proofs.json") == {}


def test_a_damaged_summary(tmp_path: Path) -> None:
    """The message names the file."""
    (tmp_path / PROOFS.name).write_text("{}")
    with pytest.raises(ValueError, match=r"proofs\.json"):
        read_proofs(tmp_path / PROOFS.name)


@pytest.mark.parametrize(
    ("proofs", "said"),
    [([], "TLC"), ([Proof(0, 31)], "TLC"), ([Proof(30, 30)], "all"), ([Proof(30, 30), Proof(11, 30)], "11 of 30")],
)
def test_the_least_counts(proofs: list[Proof], said: str) -> None:
    """A requirement is proved as far as each of its properties."""
    assert _proof(proofs) == said

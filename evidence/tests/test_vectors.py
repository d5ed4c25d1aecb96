"""The pack of test vectors for other languages."""

import base64
import gzip
import json
from collections import Counter
from collections.abc import Callable
from typing import Any

import jsonschema_rs
import pytest

from evidence import cli
from evidence.common.cases import TRACES, Case, read_cases
from evidence.views.vectors import SCHEMA, vector

Document = dict[str, Any]


@pytest.fixture(scope="module")
def pack(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Document]:
    """Each document by its path."""
    folder = tmp_path_factory.mktemp("vectors")
    assert cli.main(["views", "vectors", "--output", str(folder)]) == 0
    assert (folder / SCHEMA.name).read_bytes() == SCHEMA.read_bytes()
    files = [file for file in folder.rglob("*.json") if file.name != SCHEMA.name]
    return {file.relative_to(folder).as_posix(): json.loads(file.read_bytes()) for file in files}


def test_each_case_is_a_vector(pack: dict[str, Document]) -> None:
    """With its bytes, its line and its requirements."""
    left = dict(pack)
    for file in TRACES.rglob("*.txt"):
        document = left.pop(file.relative_to(TRACES).with_suffix(".json").as_posix())
        cases = list(read_cases(file))
        assert document["numberOfTests"] == len(document["tests"]) == len(cases)
        for case, test in zip(cases, document["tests"], strict=True):
            assert (test["id"], test.get("line"), test["requirements"]) == (case.id, case.line, case.requirements)
            assert (test["result"] == "invalid") == (case.verdict != "accepted")
            assert case.log == (test["log"].encode() if "log" in test else base64.b64decode(test["base64"]))
    assert not left


def test_schema(pack: dict[str, Document]) -> None:
    """Each document is of the schema; all results occur."""
    schema = jsonschema_rs.validator_for(json.loads(SCHEMA.read_bytes()))
    for document in pack.values():
        schema.validate(document)
    results = Counter(test["result"] for document in pack.values() for test in document["tests"])
    assert min(results[result] for result in ("valid", "invalid", "acceptable")) > 100


@pytest.mark.parametrize(
    "damage",
    [
        lambda test: test.pop("result"),
        lambda test: test.pop("line"),
        lambda test: test.pop("log"),
        lambda test: test.update(base64=""),
        lambda test: test.update(result="valid"),
        lambda test: test.update(line=0),
        lambda test: test.update(requirements=["TINT"]),
        lambda test: test.update(reading={}),
        lambda test: test.update(flags=["odd"]),
        lambda test: test.update(more=1),
    ],
)
def test_what_the_schema_refuses(damage: Callable[[Document], object]) -> None:
    """A field that is missing, is of another result, or says something else."""
    test = vector(Case("X", "a", "rejected", 2, ["TINT-01"], "Why.", b'{"cpu": "S7-300"}\n'), {})
    document = {"format": "s7-interrupt-vectors/1", "schema": SCHEMA.name, "version": "1", "area": "X"}
    schema = jsonschema_rs.validator_for(json.loads(SCHEMA.read_bytes()))
    assert schema.is_valid(document | {"numberOfTests": 1, "tests": [test]})
    damage(test)
    assert not schema.is_valid(document | {"numberOfTests": 1, "tests": [test]})


@pytest.mark.parametrize(
    ("header", "requirement", "result", "reading"),
    [
        ({}, "TINT-01", "valid", None),
        ({"readings": {"AMB-02": "b"}}, "TINT-01", "acceptable", {"AMB-02": "b"}),
        ({"profile": "1997"}, "TINT-01", "acceptable", {"profile": "1997"}),
        ({}, "AMB-02", "acceptable", {"AMB-02": "a"}),
    ],
)
def test_results(header: Document, requirement: str, result: str, reading: Document | None) -> None:
    """What a reading decides is acceptable, whether the header names the letter or not."""
    log = json.dumps(header).encode()
    for text, packed in ((log, False), (gzip.compress(log), True)):
        test = vector(Case("X", "a", "accepted", None, [requirement], "", text, packed), {"AMB-02": "a"})
        assert (test["result"], test.get("reading")) == (result, reading)

"""The manifest's format: what is refused, with file and field, and what an entry resolves to. No TLC is run."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from evidence.models.judge import render
from evidence.models.manifest import Manifest, ManifestError, load, shard
from evidence.models.runner import StaleMutationError, prepare

FIXTURES = Path(__file__).parent / "fixtures"


@pytest.fixture
def manifest(tmp_path: Path) -> Path:
    """Copy the fixture project and return the path of its manifest."""
    shutil.copytree(FIXTURES, tmp_path, dirs_exist_ok=True)
    return tmp_path / "models" / "manifest.json"


def change(manifest: Path, index: int, **fields: Any) -> Manifest:
    """Set fields of one entry (None removes one) and load the manifest."""
    document = json.loads(manifest.read_text(encoding="utf-8"))
    entry = {**document["models"][index], **fields}
    document["models"][index] = {k: v for k, v in entry.items() if v is not None}
    manifest.write_text(json.dumps(document), encoding="utf-8")
    return load(manifest)


OVERSHOOT = {"exit": 12, "property": "InRange"}


@pytest.mark.parametrize(
    ("index", "fields", "said"),
    [
        (0, {"lane": "nightly"}, "models[0] (counter).lane: Invalid enum value 'nightly'"),
        (0, {"lanes": "ci"}, "models[0] (counter): Object contains unknown field `lanes`"),
        (0, {"expect": {"exit": 1}}, "models[0] (counter).expect.exit: Invalid enum value 1"),
        (0, {"expect": {"exit": 75}}, "models[0] (counter).expect.exit: Invalid enum value 75"),
        (0, {"what": None}, "models[0] (counter).what: missing"),
        (0, {"kind": None}, "models[0] (counter).kind: missing"),
        (0, {"seconds": None}, "models[0] (counter).seconds: missing"),
        (0, {"seconds": [3, 2]}, "models[0] (counter).seconds: 3.0..2.0 is not a band"),
        (0, {"module": "MCNone.tla"}, "models[0] (counter).module: MCNone.tla is not a .tla file"),
        (0, {"config": "MCNone.cfg"}, "models[0] (counter).config: MCNone.cfg is not a .cfg file"),
        (0, {"module": "../spec/Counter.tla"}, "models[0] (counter).module: ../spec/Counter.tla is outside"),
        (0, {"workers": 2}, "models[0] (counter).workers: a liveness runs with 1 worker"),
        (0, {"args": ["-continue"]}, "models[0] (counter).args: -continue is not for a manifest"),
        (0, {"expect": {"exit": 11}}, "models[0] (counter).expect.exit: a liveness has to pass"),
        (1, {"name": "counter"}, "the name 'counter' stands there more than once"),
        (1, {"base": "none"}, "models[1] (neg-overshoot).base: 'none' is not the name"),
        (2, {"base": "neg-overshoot"}, "models[2] (neg-definition).base: 'neg-overshoot' is not the name"),
        (1, {"config": "MCCounter.cfg"}, "models[1] (neg-overshoot).config: an entry with a base"),
        (1, {"overrides": {}}, "models[1] (neg-overshoot): changes nothing of its base counter"),
        (1, {"overrides": {"Nothing": "TRUE"}}, "MCCounter.cfg: Nothing is assigned 0 times"),
        (1, {"overrides": {"Overshoots": False}}, "Overshoots = FALSE already: the override changes nothing"),
        (1, {"expect": {"exit": 0}}, "models[1] (neg-overshoot).expect.exit: a negative control has to fail"),
        (1, {"expect": {"exit": 12}}, "models[1] (neg-overshoot).expect.property: missing"),
        (1, {"expect": {"exit": 12, "property": "InRang"}}, "the configuration does not check InRang"),
        (1, {"expect": {"exit": 13, "property": "InRange"}}, "InRange is an INVARIANT, its exit is 12"),
        (1, {"expect": {**OVERSHOOT, "violates": "action"}}, "violates: action does not go with exit and property"),
        (1, {"mutate": {"module": "No.tla", "replace": "a", "by": "b"}}, "mutate.module: No.tla is not in exactly one"),
        (1, {"mutate": {"module": "Counter.tla", "replace": "a", "by": "a"}}, "replaces a text by itself"),
        (9, {"workers": 2}, "models[9] (endless).expect.depth: TLC's depth is exact with 1 worker only"),
    ],
)
def test_wrong_entry_is_refused(manifest: Path, index: int, fields: dict[str, Any], said: str) -> None:
    """A wrong entry is refused in words that name the file, the model and the field."""
    with pytest.raises(ManifestError) as error:
        change(manifest, index, **fields)
    assert said in str(error.value)
    assert str(error.value).startswith(str(manifest))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "manifest.json:1:2: not JSON"),
        ('{"version": 2, "models": []}', "version: Invalid enum value 2"),
        ('{"models": []}', "the document: Object missing required field `version`"),
        ('{"version": 1, "models": [], "spec": "none"}', "spec: none is not a directory"),
        ('{"version": 1, "models": [{"name": "a", "name": "b"}]}', "the field 'name' stands twice"),
    ],
)
def test_wrong_document_is_refused(manifest: Path, text: str, said: str) -> None:
    """Text that is not a manifest is refused with its place."""
    manifest.write_text(text, encoding="utf-8")
    with pytest.raises(ManifestError, match=r"manifest\.json") as error:
        load(manifest)
    assert said in str(error.value)


def test_missing_manifest_is_refused(tmp_path: Path) -> None:
    """A manifest that is not there is an error of the manifest."""
    with pytest.raises(ManifestError, match="cannot be read"):
        load(tmp_path / "manifest.json")


def test_deadlock_must_agree_with_configuration(manifest: Path) -> None:
    """A configuration that switches the deadlock check off behind the manifest's back is refused."""
    config = manifest.parent / "MCEndless.cfg"
    config.write_text(config.read_text() + "CHECK_DEADLOCK FALSE\n")
    with pytest.raises(ManifestError, match="CHECK_DEADLOCK FALSE"):
        load(manifest)


def test_derived_entry_has_the_rest_from_its_base(manifest: Path) -> None:
    """A derived entry is a negative control in its base's lane, with its requirements, and describes itself."""
    model = load(manifest).models[1]
    assert (model.kind, model.lane, model.requirements, model.workers) == ("negative", "smoke", ("T-1",), 1)
    assert model.what == "counter with Overshoots True: InRange must fail"
    assert "Overshoots = TRUE" in model.config
    assert model.seconds == (0.0, 60.0)


def test_either_exit_for_properties_only(manifest: Path) -> None:
    """What stands under PROPERTY may be a step, liveness or the initial state; `violates` pins which."""
    loaded = change(manifest, 3, expect={"exit": 12, "property": "StepByOne"})
    assert loaded.models[3].kinds == {"action", "temporal", "initial"}
    assert loaded.models[4].kinds == {"temporal"}
    assert loaded.models[1].kinds == {"invariant"}


def test_names_may_be_globs(manifest: Path) -> None:
    """A glob picks all models of that form in the manifest's order, whatever their lane."""
    loaded = load(manifest)
    assert [m.name for m in loaded.select("smoke", ("neg-d*", "endless"))] == [
        "neg-definition",
        "neg-deadlock",
        "endless",
    ]


@pytest.mark.parametrize("of", [1, 2, 4, 50])
def test_each_model_is_in_one_shard(manifest: Path, of: int) -> None:
    """The shards together have each model once, in the manifest's order, and about as many each."""
    models = list(load(manifest).models)
    shards = [shard(models, number, of) for number in range(1, of + 1)]
    assert sorted(m.name for part in shards for m in part) == sorted(m.name for m in models)
    assert all(part == [m for m in models if m in part] for part in shards)
    assert max(map(len, shards)) - min(map(len, shards)) <= 1


def test_mutation_changes_the_copy_only(manifest: Path, tmp_path: Path) -> None:
    """The copy that a run works on has the new text, the specification keeps the old one."""
    loaded = load(manifest)
    space = prepare(tmp_path / "copy", loaded, loaded.models[3])
    assert "x' = x + 2\nAgain" in (tmp_path / "copy" / "spec" / "Counter.tla").read_text()
    assert "x + 2" not in (loaded.spec / "Counter.tla").read_text()
    assert space.config.read_text() == loaded.models[3].config


def test_stale_mutation(manifest: Path, tmp_path: Path) -> None:
    """A text that occurs more than once is not replaced."""
    loaded = change(manifest, 3, mutate={"module": "Counter.tla", "replace": "x + 1", "by": "x"})
    with pytest.raises(StaleMutationError, match=r"occurs 2 times in Counter\.tla"):
        prepare(tmp_path / "copy", loaded, loaded.models[3])


def test_rendered_manifest_is_the_same_document(manifest: Path) -> None:
    """Rewriting keeps content and order, and entries that fit a line stay on one."""
    document = json.loads(manifest.read_text(encoding="utf-8"))
    text = render(document)
    assert json.loads(text) == document
    assert list(json.loads(text)["models"][0]) == list(document["models"][0])
    assert '      "expect": {"exit": 0, "states": 6, "distinct": 5, "depth": 5}' in text.split("\n")

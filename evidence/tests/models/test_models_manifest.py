"""The manifest's format: what is refused, with file and field, and what an entry resolves to. No TLC is run."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from evidence.common.checkout import MANIFEST, ROOT
from evidence.models.entries import ManifestError, read, render
from evidence.models.manifest import Manifest, load, shard
from evidence.models.runner import prepare

FIXTURES = Path(__file__).parent / "fixtures"


@pytest.fixture
def manifest(tmp_path: Path) -> Path:
    """Copy the fixture project and return the path of its manifest."""
    shutil.copytree(FIXTURES, tmp_path, dirs_exist_ok=True)
    return tmp_path / "models" / "models.txt"


def change(manifest: Path, old: str, new: str) -> Manifest:
    """Replace a text that stands once in models or controls, and load the manifest."""
    for file in (manifest, manifest.parent / "controls.txt"):
        text = file.read_text(encoding="utf-8")
        if old in text:
            assert text.count(old) == 1
            file.write_text(text.replace(old, new), encoding="utf-8")
            return load(manifest)
    raise AssertionError(old)


COUNTER = "== counter liveness smoke MCCounter.tla 0\n"
WHAT = "The counter stays in its range, steps by one and always comes back.\n"
OVERSHOOT = "== neg-overshoot counter 12 InRange\n"
COUNTS = "states 6, distinct 6, depth 6\n"
CONSTANT = "constants Overshoots = TRUE\n"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (COUNTER, "== counter liveness nightly MCCounter.tla 0\n", "counter.lane: Invalid enum value 'nightly'"),
        (COUNTER, "== counter\n", "models.txt:3: expected == NAME, of a model KIND LANE, MODULE or BASE"),
        (COUNTER, "== counter liveness smoke MCCounter.tla 1\n", "counter.expect.exit: Invalid enum value 1"),
        (COUNTER, "== counter liveness smoke MCCounter.tla 11\n", "counter.expect.exit: a liveness has to pass"),
        (COUNTER, "== counter MCCounter.tla 0\n", "counter.kind: missing"),
        (COUNTER, "== counter liveness smoke MCNone.tla 0\n", "counter.module: MCNone.tla is not a .tla file"),
        (COUNTER, "== counter liveness smoke ../spec/Counter.tla 0\n", "../spec/Counter.tla is outside"),
        (WHAT, "", "models.txt:3: counter.what: missing"),
        (WHAT, f"{WHAT}lanes ci\n", "models.txt:5: counter: no field is named 'lanes'"),
        (WHAT, f"{WHAT}what it is\n", "models.txt:5: counter: no field is named 'what'"),
        (WHAT, f"{WHAT}- a\n", "models.txt:5: expected a line such as 'Module.tla:' before -"),
        (WHAT, f"{WHAT}// Why.\n", "models.txt:6: expected == after a comment or an empty line"),
        (", seconds 0..60", "", "models.txt:3: counter.seconds: missing"),
        ("seconds 0..60", "seconds 3..2", "counter.seconds: 3.0..2.0 is not a band"),
        ("seconds 0..60", "seconds long", "models.txt:6: counter: seconds: 'long' is no value of it"),
        ("seconds 0..60", "seconds 60", "counter.seconds: Expected `array` of length 2"),
        ("seconds 0..60", "seconds 0..60, seconds 0..70", "models.txt:6: counter: seconds stands twice"),
        ("seconds 0..60", "seconds 0..60, workers 2", "counter.workers: a liveness runs with 1 worker"),
        ("seconds 0..3", "seconds 0..3, workers 2", "endless.expect.depth: TLC's depth is exact with 1 worker only"),
        ("config MCCounter.cfg", "config MCNone.cfg", "counter.config: MCNone.cfg is not a .cfg file"),
        (", config MCCounter.cfg", "", "counter.config: MCBase.cfg is not a .cfg file"),
        (OVERSHOOT, "== counter counter 12 InRange\n", "controls.txt:3: the name 'counter' stands there m"),
        (OVERSHOOT, "== neg-overshoot none 12 InRange\n", "neg-overshoot.base: 'none' is not the name"),
        (OVERSHOOT, "== neg-overshoot neg-step 12 InRange\n", "neg-overshoot.base: 'neg-step' is not the name"),
        (OVERSHOOT, "== neg-overshoot counter 0\n", "neg-overshoot.expect.exit: a negative control has to fail"),
        (OVERSHOOT, "== neg-overshoot counter 12\n", "neg-overshoot.expect.property: missing"),
        (OVERSHOOT, "== neg-overshoot counter 12 InRang\n", "the configuration does not check InRang"),
        (OVERSHOOT, "== neg-overshoot counter 13 InRange\n", "InRange is an INVARIANT, its exit is 12"),
        (COUNTS, f"config MCCounter.cfg, {COUNTS}", "neg-overshoot.config: an entry with a base"),
        (COUNTS, f"violates action, {COUNTS}", "violates: action does not go with exit and property"),
        (COUNTS, "states six\n", "controls.txt:4: neg-overshoot: states: 'six' is no value of it"),
        (CONSTANT, "", "controls.txt:3: neg-overshoot: changes nothing of its base counter"),
        (CONSTANT, "constants Nothing = TRUE\n", "MCCounter.cfg: Nothing is assigned 0 times"),
        (CONSTANT, "constants Overshoots = FALSE\n", "Overshoots = FALSE already: the override changes nothing"),
        (CONSTANT, "constants Overshoots TRUE\n", "expected NAME <- DEFINITION or NAME = VALUE, not 'Overshoots TRUE'"),
        (CONSTANT, "plain Nothing\n", "MCCounter.cfg: Nothing is assigned 0 times, it is to be left out once"),
        (CONSTANT, "No.tla: `a` -> `b`\n", "mutate.module: No.tla is not in exactly one"),
        (CONSTANT, "Counter.tla: `a` -> `a`\n", "replaces a text by itself"),
        ("// Models of a counter.", "// Models.\nmodels counter", "models.txt:2: expected spec FOLDER,"),
        ("// Models of a counter.", "spec none", "models.txt: spec: none is not a directory"),
    ],
)
def test_wrong_entry_is_refused(manifest: Path, old: str, new: str, said: str) -> None:
    """A wrong entry is refused in words that name the file, the line, the model and the field."""
    with pytest.raises(ManifestError) as error:
        change(manifest, old, new)
    assert said in str(error.value)
    assert str(error.value).startswith(str(manifest.parent))


def test_missing_manifest_is_refused(tmp_path: Path) -> None:
    """A manifest that is not there is an error of the manifest."""
    with pytest.raises(ManifestError, match=r"models\.txt: cannot be read"):
        load(tmp_path / "models.txt")


def test_deadlock_must_agree_with_configuration(manifest: Path) -> None:
    """Deadlocks are looked for as the configuration says, and an entry that says otherwise is refused."""
    assert load(manifest).models[2].deadlock
    config = manifest.parent / "MCEndless.cfg"
    config.write_text(config.read_text() + "CHECK_DEADLOCK FALSE\n")
    assert not load(manifest).models[2].deadlock
    with pytest.raises(ManifestError, match="CHECK_DEADLOCK FALSE"):
        change(manifest, "seconds 0..3", "seconds 0..3, deadlock true")


def test_derived_entry_has_the_rest_from_its_base(manifest: Path) -> None:
    """A derived entry is a negative control in its base's lane, with its requirements, and describes itself."""
    model = load(manifest).models[3]
    assert (model.kind, model.lane, model.requirements, model.workers) == ("negative", "smoke", ("T-1",), 1)
    assert model.what == "counter with Overshoots = TRUE: InRange must fail"
    assert "Overshoots = TRUE" in model.config
    assert model.seconds == (0.0, 60.0)


def test_either_exit_for_properties_only(manifest: Path) -> None:
    """What stands under PROPERTY may be a step, liveness or the initial state; `violates` pins which."""
    kinds = {m.name: m.kinds for m in change(manifest, "violates action\n", "").models}
    assert kinds["neg-step"] == {"action", "temporal", "initial"}
    assert kinds["neg-returns"] == {"temporal"}
    assert kinds["neg-overshoot"] == {"invariant"}


def test_another_control_of_a_property_is_in_the_full_lane(manifest: Path) -> None:
    """The first is in the lane of its model, and one that names a lane is there."""

    def lane(name: str) -> str:
        return next(m.lane for m in load(manifest).models if m.name == name)

    assert (lane("neg-overshoot"), lane("neg-definition")) == ("smoke", "smoke")
    change(manifest, "lane smoke\n", "")
    assert (lane("neg-overshoot"), lane("neg-definition")) == ("smoke", "full")


def test_names_may_be_globs(manifest: Path) -> None:
    """A glob picks all models of that form in the manifest's order, whatever their lane."""
    loaded = load(manifest)
    assert [m.name for m in loaded.select("smoke", ("neg-d*", "endless"))] == [
        "endless",
        "neg-definition",
        "neg-deadlock",
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
    model = next(m for m in loaded.models if m.name == "neg-step")
    space = prepare(tmp_path / "copy", loaded, model)
    assert "x' = x + 2\nAgain" in (tmp_path / "copy" / "spec" / "Counter.tla").read_text()
    assert "x + 2" not in (loaded.spec / "Counter.tla").read_text()
    assert space.config.read_text() == model.config


@pytest.mark.parametrize("path", [ROOT / MANIFEST, FIXTURES / "models" / "models.txt"])
def test_entries_stand_as_update_writes_them(path: Path) -> None:
    """Each entry, rendered, is the lines that it was read from; so a change of pins changes their line alone."""
    files = {name: (path.parent / name).read_text(encoding="utf-8") for name in (path.name, "controls.txt")}
    for entry in read(path).entries:
        file, line = entry.place.rsplit(":", 1)
        lines = files[Path(file).name].splitlines()[int(line) - 1 :]
        assert lines[: render(entry).count("\n") + 1] == render(entry).split("\n")

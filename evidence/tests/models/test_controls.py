"""The manifest of the project: it names each file, and no two of its negative controls are the same wrong rule."""

import re
from collections import defaultdict

from msgspec import UNSET

from evidence.common.checkout import MANIFEST, ROOT
from evidence.models.entries import read
from evidence.models.manifest import Manifest, Model, load
from evidence.tla.modules import read_modules


def controls(manifest: Manifest) -> dict[str, list[Model]]:
    """The negative controls that change the specification, by what they make of it, without layout."""
    modules = {**read_modules(manifest.spec), **read_modules(manifest.directory)}
    found = defaultdict(list)
    for model in manifest.models:
        if model.kind == "negative" and model.mutations:
            texts = {m.module: modules[m.module.removesuffix(".tla")].text.decode() for m in model.mutations}
            for m in model.mutations:
                texts[m.module] = texts[m.module].replace(m.replace, m.by)
            found[re.sub(r"\s+", "", "".join(texts.values()))].append(model)
    return found


def test_the_manifest_names_each_configuration() -> None:
    """`s7spec models` fails on a file that is forgotten. Here that costs no model."""
    assert load(ROOT / MANIFEST).drift == ()


def test_each_control_has_a_wrong_rule_of_its_own() -> None:
    """One model never has a change twice. If several have it, all but one say why: the field `what` of the file."""
    said = {entry.name for entry in read(ROOT / MANIFEST).entries if entry.what is not UNSET}
    for same in controls(load(ROOT / MANIFEST)).values():
        names = [model.name for model in same]
        assert len({model.base for model in same}) == len(same), names
        assert len(set(names) - said) <= 1, names

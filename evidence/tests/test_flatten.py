"""A module and all that it extends as one module, and the places that tools name in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from evidence.common.checkout import ROOT
from evidence.tla.flatten import flatten, keep_only, split
from evidence.tla.modules import closure, module_folders, read_modules
from evidence.tla.syntax import Module, SyntaxTreeError, references
from evidence.tla.tlc import Workspace

BASE = """---- MODULE Base ----
EXTENDS Integers,
        Sequences
(* Above. *)
\\* @type: Int => Int;
Twice(n) == 2 * n
\\* @type: Int => Int;
Thrice(n) == 3 * n (* beside *)
====
what stands below is no part of it
"""
TOP = """---- MODULE Top ----
EXTENDS Base, FiniteSets
Four == Twice(2)
====
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with two modules."""
    (tmp_path / "Base.tla").write_text(BASE, encoding="utf-8")
    (tmp_path / "Top.tla").write_text(TOP, encoding="utf-8")
    return tmp_path


def test_extended_modules_come_first_and_standard_modules_stay_extended(folder: Path) -> None:
    """Each module's text stands once, before the modules that extend it."""
    lines = [line for line in flatten("Top", [folder]).text.splitlines() if line.strip()]
    assert lines == [
        "---- MODULE Top ----",
        "EXTENDS Integers, Sequences, FiniteSets",
        "(* Above. *)",
        "\\* @type: Int => Int;",
        "Twice(n) == 2 * n",
        "\\* @type: Int => Int;",
        "Thrice(n) == 3 * n (* beside *)",
        "Four == Twice(2)",
        "====",
    ]


def test_each_line_has_the_place_from_which_it_comes(folder: Path) -> None:
    """A place in the one module becomes the place in the module of its author."""
    flat = flatten("Top", [folder])
    number = flat.text.splitlines().index("Thrice(n) == 3 * n (* beside *)") + 1
    said = f"<Next line {number}, col 1 to line {number}, col 18 of module Top>"
    assert flat.located(said) == "<Next line 8, col 1 to line 8, col 18 of module Base>"
    assert flat.located("line 1, col 1 to line 1, col 2 of module Other") == (
        "line 1, col 1 to line 1, col 2 of module Other"
    )


def test_only_the_definitions_that_are_needed_are_kept_with_their_types(folder: Path) -> None:
    """Operators that nothing needs are left out, with the types above them."""
    kept = keep_only(flatten("Top", [folder]), ["Four"])
    assert "Twice(n)" in kept
    assert "Thrice" not in kept
    assert kept.count("@type") == 1
    assert "(* Above. *)" in kept


def test_what_depends_on_variables_stands_apart(tmp_path: Path) -> None:
    """All else is where TLC finds constants; a place in either becomes the place in the module of its author."""
    text = """---- MODULE Top ----
VARIABLE x
Two == 2
Next ==
    x' = x + Two
Rest(n) == Next /\\ n = 2
====
"""
    (tmp_path / "Top.tla").write_text(text, encoding="utf-8")
    top, rules, constants = split("Top", [tmp_path])
    assert (top.name, rules.name, constants.name) == ("Top", "TopRules", "TopConstants")
    assert rules.text.splitlines()[1:-1] == ["EXTENDS TopConstants", *text.splitlines()[1:2], *text.splitlines()[3:6]]
    assert constants.text.splitlines()[2:-1] == ["Two == 2"]
    assert rules.located("line 5, col 5 to line 5, col 16 of module TopRules") == (
        "line 5, col 5 to line 5, col 16 of module Top"
    )
    assert constants.located("line 3, col 1 to line 3, col 8 of module TopConstants").startswith("line 3, col 1 ")
    (tmp_path / "Top.tla").write_text(text.replace("Two == 2", "Two == 2\nASSUME Two = 2"), encoding="utf-8")
    assert split("Top", [tmp_path]) == ()


def test_nothing_of_a_model_is_lost() -> None:
    """Every definition of a model's modules is there and uses the same names."""
    modules = read_modules(ROOT / "spec") | read_modules(ROOT / "models")
    flat = Module("MCAirt", flatten("MCAirt", [ROOT / "models", *module_folders(ROOT / "spec")]).text.encode())
    parts = [modules[name] for name in closure("MCAirt", modules)]
    wanted = {name: unit for part in parts for name, unit in part.definitions.items()}
    assert flat.definitions.keys() == wanted.keys()
    assert all(references(flat.definitions[name]) == references(unit) for name, unit in wanted.items())
    _, *apart = split("MCAirt", [ROOT / "models", *module_folders(ROOT / "spec")])
    found = {name: unit for one in apart for name, unit in Module(one.name, one.text.encode()).definitions.items()}
    assert found.keys() == wanted.keys()
    assert all(references(found[name]) == references(unit) for name, unit in wanted.items())


@pytest.mark.parametrize("text", ["no module", "---- MODULE Top ----\nA == \n====\n"])
def test_a_module_that_cannot_be_read_is_left_to_tlc(tmp_path: Path, text: str) -> None:
    """The file stays as it is, so that TLC names the place of the mistake."""
    (tmp_path / "Top.tla").write_text(text, encoding="utf-8")
    with pytest.raises(SyntaxTreeError, match=r"Top\.tla"):
        flatten("Top", [tmp_path])
    space = Workspace(tmp_path, "Top.tla", (), tmp_path).as_one_module()
    assert space.flat == ()
    assert (tmp_path / "Top.tla").read_text(encoding="utf-8") == text


def test_a_module_that_is_not_there_is_named(tmp_path: Path) -> None:
    """The message has its name."""
    with pytest.raises(SyntaxTreeError, match="None"):
        flatten("None", [tmp_path])


def test_a_name_of_an_instance_is_no_name_of_the_module() -> None:
    """Next of an abstract specification does not bring the next-state relation of the module along."""
    text = b"---- MODULE M ----\nA == Lock!Next \\/ UNCHANGED Lock!lockVars \\/ Lock!Foo(Bar, 2) \\/ Own(Baz)\n====\n"
    assert references(Module("M", text).definitions["A"]) == {"Lock", "Bar", "Own", "Baz"}

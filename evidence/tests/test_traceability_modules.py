"""Reading TLA+ modules for traceability: which definition a comment belongs to."""

from pathlib import Path

import pytest

from evidence.views.traceability.ids import mentioned, tagged
from evidence.views.traceability.modules import Module, read_module

MODULE = r"""------------------------------- MODULE Example ------------------------------
(***************************************************************************)
(* Says something about points [CLK-09].                                   *)
(*                                                                         *)
(* Treats a, b.  Left out: operands, which nobody sees [TINT-21]; and the  *)
(* rest [OBS-09] (AMB-26).                                                 *)
(***************************************************************************)
EXTENDS Integers

VARIABLES
    (* [OBS-40] The mode. *)
    \* @type: Str;
    mode,
    (* [AIRT-03] The count (of SFC 41). *)
    count

-----------------------------------------------------------------------------
(* A section about [TINT-05]. *)

(* [TINT-72] ..      *)
(* [TINT-74] Bits.   *)
\* @type: (Int, Int) => Int;
Bits(a,
     b) == a + b  \* [DINT-16]

Plain == "(* [TINT-99] *) == \* [TINT-98]"
(* AMB-02 without brackets *)
Chosen == IF Reading("AMB-02") = "a" THEN 1
          (* [IRT-01] (* nested [IRT-02] *) inside *)
          ELSE Reading("AMB-03")
f[x \in Int] == x \* nothing
=============================================================================
"""


@pytest.fixture
def module(tmp_path: Path) -> Module:
    """The example as a file."""
    (tmp_path / "Example.tla").write_text(MODULE, encoding="utf-8")
    return read_module(tmp_path / "Example.tla")


def test_definitions_and_variables(module: Module) -> None:
    """All of them are found with their lines; strings and comments are no definitions."""
    found = {d.name: d.line for d in module.definitions}
    assert found == {"mode": 13, "count": 15, "Bits": 23, "Plain": 26, "Chosen": 28, "f": 31}


def test_comments_belong_to_definitions(module: Module) -> None:
    """Above: to the next one; indented or at the end of a line: to the one around."""
    tags = {d.name: d.tags for d in module.definitions if d.tags}
    assert tags == {
        "mode": ("OBS-40",),
        "count": ("AIRT-03",),
        "Bits": ("TINT-05", "TINT-72", "TINT-73", "TINT-74", "DINT-16"),
        "Chosen": ("IRT-01", "IRT-02"),
    }


def test_readings(module: Module) -> None:
    """The ambiguities whose letter a formula looks up."""
    assert {d.name: d.readings for d in module.definitions if d.readings} == {"Chosen": ("AMB-02", "AMB-03")}


def test_box(module: Module) -> None:
    """The box of a module names what it is about and what it leaves out, and why."""
    assert module.tags == ("CLK-09",)
    reason = "operands, which nobody sees [TINT-21]; and the rest [OBS-09] (AMB-26)."
    assert module.left_out == {"TINT-21": reason, "OBS-09": reason}


def test_place_of_a_text(module: Module) -> None:
    """A piece of text belongs to the definitions that it touches."""
    assert [d.name for d in module.at("THEN 1")] == ["Chosen"]
    assert [d.name for d in module.at('[TINT-98]"\n(* AMB-02 without brackets *)\nChosen')] == ["Plain", "Chosen"]
    assert module.at("nowhere") == []


def test_ids() -> None:
    """An ID is a whole word; only brackets make it a claim."""
    assert mentioned("AIRT-03 IRT-9 AMB-nn XTINT-01 TINT-01x CLK-100 TINT-33-once") == [
        "AIRT-03",
        "IRT-9",
        "CLK-100",
        "TINT-33",
    ]
    assert tagged("TINT-01 [TINT-02] (c) [TINT-02] [AMB-7]") == ["TINT-02", "AMB-7"]

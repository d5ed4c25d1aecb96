------------------------------- MODULE Families -------------------------------
(***************************************************************************)
(* The families of CPUs: a record of facts for each, in which they differ. *)
(* No other module compares the name of a family, and none has a case for  *)
(* all others: a family without a record is unknown.                       *)
(*                                                                         *)
(* Left out: the types of a family and the OBs that each offers (AMB-64).  *)
(***************************************************************************)
EXTENDS Integers

(***************************************************************************)
(* @typeAlias: family = { name: Str, errorClass: Int, settable: Bool,      *)
(*                        lacks: Set(Int), restarts: Set(Str),             *)
(*                        repeats: Bool };                                 *)
(***************************************************************************)

(* errorClass: the class of OB 81 to 87 [OBS-04]. settable: the classes of *)
(* OBs can be set [OBS-05]. lacks: OBs that SFC 39 and 40 know and that no *)
(* CPU of the family has [AMB-73]. restarts: the types of restart          *)
(* [OBS-57] [AMB-65]. repeats: after the clock was set back, points are    *)
(* served again that were served already [CLK-09] [CLK-10].                *)
\* @type: Set($family);
KnownFamilies ==
  { [ name       |-> "S7-300",
      errorClass |-> 26,
      settable   |-> FALSE,
      lacks      |-> (30..34) \cup {60, 70, 72},
      restarts   |-> {"warm"},
      repeats    |-> TRUE ],
    [ name       |-> "S7-400",
      errorClass |-> 25,
      settable   |-> TRUE,
      lacks      |-> {60, 70, 72},
      restarts   |-> {"warm", "cold", "hot"},
      repeats    |-> FALSE ],
    [ name       |-> "CPU 318",
      errorClass |-> 25,
      settable   |-> TRUE,
      lacks      |-> {60, 70, 72},
      restarts   |-> {"warm", "cold"},
      repeats    |-> FALSE ] }

\* @type: Set(Str);
FamilyNames == { f.name : f \in KnownFamilies }

\* @type: Str => $family;
FamilyOf(name) == CHOOSE f \in KnownFamilies : f.name = name

(* [OBS-05] The classes that an OB can be given, where they can be set.    *)
(* Class 0 deselects an OB, too [OBS-06].                                  *)
\* @type: Int => Set(Int);
SettableClasses(o) ==
    CASE o \in (10..17) \cup (20..23) \cup (30..38) \cup (40..47) -> 2..23
      [] o \in {70, 72} -> 2..28
      [] o \in {81, 82, 83, 84, 86, 87} -> 2..26
      [] o = 85 -> 24..26
      [] OTHER -> {}
=============================================================================

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
(*                        repeats: Bool, byKind: Bool, raises: Bool,       *)
(*                        inherits: Bool, stops: Bool, heldBack: Set(Int), *)
(*                        keeps: Bool, missesInStop: Bool, jump: Int,      *)
(*                        queues: Bool, openCodes: Bool, showsDelay: Bool, *)
(*                        timeAlone: Bool, setsLocal: Bool,                *)
(*                        holdsStartup: Bool,                              *)
(*                        unknown: Set(Int),                               *)
(*                        letters: Set(<<Str, Str>>) };                    *)
(***************************************************************************)

(* errorClass: the class of OB 81 to 87 [OBS-04]. settable: the classes of *)
(* OBs can be set [OBS-05]. lacks: OBs that SFC 39 and 40 know and that no *)
(* CPU of the family has [AMB-73]. restarts: the types of restart          *)
(* [OBS-57] [AMB-65]. repeats: after the clock was set back, points are    *)
(* served again that were served already [CLK-09] [CLK-10].                *)
(*                                                                         *)
(* What tells the S7-1500 from the others:                                 *)
(* byKind: the OBs of a kind share a default class [T15-30] [T15-35];      *)
(* settable up to 24 or 26, and not to 0 [T15-60]. raises: errors have     *)
(* class 28 in STARTUP and when a buffer overflows [OBS-31] [OBS-43]; else *)
(* their own [T15-61]. inherits: an error OB has the class of the OB at    *)
(* fault [OBS-61]; else its own [T15-63]. stops: an event whose OB is      *)
(* missing leads to OB 85 or STOP [OBS-20]; else it is ignored [T15-110]   *)
(* [T15-113]. heldBack: errors whose OB waits for RUN [T15-117]. keeps:    *)
(* start events of STARTUP wait for RUN [T15-118]. missesInStop: OB 80 may *)
(* report points that passed in STOP [T15-120]. jump: a clock set forward  *)
(* by fewer ms is caught up without OB 80, one set back by as many serves  *)
(* points again [T15-90] [T15-94]; 0: there is no such limit.              *)
(* queues: how many start events of a time-of-day OB wait is a parameter   *)
(* [T15-68]. openCodes: no text of some calls was found [T15-143].         *)
(* showsDelay: bit 1 of STATUS is of DIS_AIRT [T15-53]; else of SFC 39     *)
(* [TINT-73]. timeAlone: at the end of a month, the date of a start does   *)
(* not count [T15-22]. setsLocal: there is SET_TINTL [T15-08].             *)
(* holdsStartup: HOLD comes in STARTUP, too [T15-121]. unknown: OBs that   *)
(* no program of the family has [T15-12]. letters: questions about the     *)
(* others that its texts decide.                                           *)
\* @type: Set($family);
KnownFamilies ==
  { [ name       |-> "S7-300",
      errorClass |-> 26,
      settable   |-> FALSE,
      lacks      |-> (30..34) \cup {60, 70, 72},
      restarts   |-> {"warm"},
      repeats    |-> TRUE,
      byKind     |-> FALSE,
      raises     |-> TRUE,
      inherits   |-> TRUE,
      stops      |-> TRUE,
      heldBack   |-> {},
      keeps      |-> FALSE,
      missesInStop |-> FALSE,
      jump       |-> 0,
      queues     |-> FALSE,
      openCodes  |-> FALSE,
      showsDelay |-> FALSE,
      timeAlone  |-> FALSE,
      setsLocal  |-> FALSE,
      holdsStartup |-> FALSE,
      unknown    |-> {},
      letters    |-> {} ],
    [ name       |-> "S7-400",
      errorClass |-> 25,
      settable   |-> TRUE,
      lacks      |-> {60, 70, 72},
      restarts   |-> {"warm", "cold", "hot"},
      repeats    |-> FALSE,
      byKind     |-> FALSE,
      raises     |-> TRUE,
      inherits   |-> TRUE,
      stops      |-> TRUE,
      heldBack   |-> {},
      keeps      |-> FALSE,
      missesInStop |-> FALSE,
      jump       |-> 0,
      queues     |-> FALSE,
      openCodes  |-> FALSE,
      showsDelay |-> FALSE,
      timeAlone  |-> FALSE,
      setsLocal  |-> FALSE,
      holdsStartup |-> FALSE,
      unknown    |-> {},
      letters    |-> {} ],
    [ name       |-> "CPU 318",
      errorClass |-> 25,
      settable   |-> TRUE,
      lacks      |-> {60, 70, 72},
      restarts   |-> {"warm", "cold"},
      repeats    |-> FALSE,
      byKind     |-> FALSE,
      raises     |-> TRUE,
      inherits   |-> TRUE,
      stops      |-> TRUE,
      heldBack   |-> {},
      keeps      |-> FALSE,
      missesInStop |-> FALSE,
      jump       |-> 0,
      queues     |-> FALSE,
      openCodes  |-> FALSE,
      showsDelay |-> FALSE,
      timeAlone  |-> FALSE,
      setsLocal  |-> FALSE,
      holdsStartup |-> FALSE,
      unknown    |-> {},
      letters    |-> {} ],
    [ name       |-> "S7-1500",
      errorClass |-> 6,
      settable   |-> TRUE,
      lacks      |-> {60, 70, 72, 81, 84, 85, 87},
      restarts   |-> {"warm"},
      repeats    |-> FALSE,
      byKind     |-> TRUE,
      raises     |-> FALSE,
      inherits   |-> FALSE,
      stops      |-> FALSE,
      heldBack   |-> {80},
      keeps      |-> TRUE,
      missesInStop |-> TRUE,
      jump       |-> 20000,
      queues     |-> TRUE,
      openCodes  |-> TRUE,
      showsDelay |-> TRUE,
      timeAlone  |-> TRUE,
      setsLocal  |-> TRUE,
      holdsStartup |-> TRUE,
      unknown    |-> {60, 65, 70, 72, 73, 81, 84, 85, 87, 88, 90, 101, 102},
      letters    |-> { <<"AMB-27", "a">>, <<"AMB-55", "a">>,
                       <<"AMB-56", "a">>, <<"AMB-65", "b">> } ] }

\* @type: Set(Str);
FamilyNames == { f.name : f \in KnownFamilies }

\* @type: Str -> $family;
FactsOf == [ n \in FamilyNames |-> CHOOSE f \in KnownFamilies : f.name = n ]
\* @type: Str => $family;
FamilyOf(name) == FactsOf[name]

(* [OBS-05] The classes that an OB can be given, where they can be set.    *)
(* Class 0 deselects an OB, too [OBS-06].                                  *)
\* @type: Int => Set(Int);
SettableClasses(o) ==
    CASE o \in (10..17) \cup (20..23) \cup (30..38) \cup (40..47) -> 2..23
      [] o \in {70, 72} -> 2..28
      [] o \in {81, 82, 83, 84, 86, 87} -> 2..26
      [] o = 85 -> 24..26
      [] OTHER -> {}

(* [T15-30] [T15-35] [T15-60] [T15-62] [T15-63] No OB is deselected by it. *)
\* @type: Int => Set(Int);
ClassesByKind(o) ==
    CASE o \in (10..17) \cup (20..23) \cup (30..38) \cup (55..57) -> 2..24
      [] o \in (40..47) \cup {82, 83, 86, 121, 122} -> 2..26
      [] OTHER -> {}

\* @type: ($family, Int) => Set(Int);
ClassesToSet(f, o) ==
    IF f.byKind THEN ClassesByKind(o)
    ELSE IF SettableClasses(o) = {} THEN {} ELSE {0} \cup SettableClasses(o)
=============================================================================

--------------------------------- MODULE Cpu --------------------------------
(***************************************************************************)
(* Terms for the parts of a CPU: OBs, priority classes, the blocks of SFC  *)
(* 39, the stack of running OBs.                                           *)
(*                                                                         *)
(* Sources: requirements, section 5.1, table 7.1.                          *)
(* Left out: OB 90.                                                        *)
(***************************************************************************)
EXTENDS Sequences, Families, State

(* The facts of this CPU's family. *)
Family == FamilyOf(cpu.family)

-----------------------------------------------------------------------------
(* OBs *)

(* [T15-10] [T15-11] The OBs from 123 on that the CPU at hand has, and     *)
(* those of them in the event class of OB `first'.                         *)
NumberedObs == DOMAIN cpu.classes
\* @type: Int => Set(Int);
Numbered(first) == { o \in NumberedObs : cpu.classes[o] = first }
(* The OB whose rules such an OB shares; another has its own.              *)
\* @type: Int => Int;
Kin(o) == IF o \in NumberedObs THEN cpu.classes[o] ELSE o

(* [TINT-01] [DINT-01] [AMB-64] Offered by every CPU; models use fewer. *)
OldTodObs  == 10..17
OldDintObs == 20..23
TodObs  == IF NumberedObs = {} THEN OldTodObs
                               ELSE OldTodObs \cup Numbered(10)
DintObs == IF NumberedObs = {} THEN OldDintObs
                               ELSE OldDintObs \cup Numbered(20)

CycleOb   == 1
(* [T15-79] OB 1 and those that run after it in its cycle.                 *)
CycleObs == IF NumberedObs = {} THEN {CycleOb} ELSE {CycleOb} \cup Numbered(1)
TimeErrorOb == 80
DiagnosticOb == 82
ProgramErrorOb == 85
(* [OBS-29] Asynchronous errors with an OB of their own. *)
AsyncErrorObs == 80..87
(* [OBS-61] [IRT-23] Synchronous errors: a programming error, an access    *)
(* error.                                                                  *)
SyncErrorObs == {121, 122}
OldStartupObs == {100, 101, 102}
StartupObs == IF NumberedObs = {} THEN OldStartupObs
              ELSE OldStartupObs \cup Numbered(100)
(* Start events from outside. *)
OldExternalObs == (30..38) \cup (40..47) \cup (55..57) \cup {60, 70, 72}
                    \cup AsyncErrorObs
ExternalObs == IF NumberedObs = {} THEN OldExternalObs
               ELSE OldExternalObs \cup Numbered(30) \cup Numbered(40)

\* @type: Str => Int;
StartupOb(type) == CASE type = "warm" -> 100
                     [] type = "hot"  -> 101
                     [] OTHER         -> 102

(* [T15-116] The startup OBs from 123 on that are to come in this STARTUP. *)
LaterStartups == IF NumberedObs = {} THEN {}
                 ELSE { o \in Numbered(100) : o > resume.last }
(* [OBS-42] With that of the restart before them.                          *)
StartupsAhead ==
    (IF startup \in {"warm", "cold", "hot"} THEN {StartupOb(startup)} ELSE {})
      \cup LaterStartups

(* The types of restart that are possible; models use fewer.               *)
RestartTypes == {"warm", "cold", "hot"}
(* [OBS-57] *)
HotRestartExists == "hot" \in Family.restarts \cap RestartTypes

(* [T15-30] [T15-35] [T15-61] .. [T15-66] Cyclic interrupts have the       *)
(* intervals of STEP 7: 5 s for OB 30 to 10 ms for OB 38.                  *)
\* @type: Int => Int;
ClassByKind(o) ==
    CASE o \in {CycleOb, 100} -> 1
      [] o \in 10..17 -> 2
      [] o \in 20..23 -> 3
      [] o \in 30..35 -> o - 22
      [] o \in {36, 37} -> 13
      [] o = 38       -> 14
      [] o \in 40..47 -> 16  \* or 18 [A15-05]
      [] o \in 55..57 -> 4
      [] o = TimeErrorOb -> 22
      [] o = 82       -> 5
      [] o \in SyncErrorObs -> 7
      [] OTHER        -> 6

(* [OBS-04] Table 7.1. *)
\* @type: ($family, Int) => Int;
DefaultClassOf(f, o) ==
    IF f.byKind THEN ClassByKind(o) ELSE
    CASE o = CycleOb       -> 1
      [] o \in 10..17      -> 2
      [] o \in 20..23      -> o - 17
      [] o \in 30..38      -> o - 23
      [] o \in 40..47      -> o - 24
      [] o \in 55..57      -> 2
      [] o \in {60, 70}    -> 25
      [] o = 72            -> 28
      [] o = TimeErrorOb   -> 26
      [] o \in 81..87      -> f.errorClass
      [] OTHER             -> 27

(* As a table, since each step asks for it; a log may ask for any number.  *)
Tabled == 1..122
\* @type: Str -> (Int -> Int);
DefaultClasses ==
    [ n \in FamilyNames |->
        [ o \in Tabled |-> DefaultClassOf(FamilyOf(n), o) ] ]

\* @type: Int => Int;
DefaultClass(o) ==
    LET k == Kin(o)
    IN  IF k \in Tabled THEN DefaultClasses[cpu.family][k]
                        ELSE DefaultClassOf(Family, k)

(* [OBS-05] *)
\* @type: Int => Int;
ClassOf(o) == IF o \in DOMAIN cpu.priority THEN cpu.priority[o]
                                           ELSE DefaultClass(o)

(* [OBS-04] The class of the startup OB [T15-64].                          *)
StartupClass == IF Family.byKind THEN 1 ELSE 27

(* [OBS-06] [TINT-02] (c) [DINT-02] *)
\* @type: Int => Bool;
Deselected(o) == \/ o \in TodObs /\ cpu.step7[o].deselected
                 \/ ClassOf(o) = 0

(* [T15-20] [T15-21] [T15-99] By how many minutes the time from which an   *)
(* interrupt counts is ahead of the clock.                                 *)
\* @type: Bool => Int;
ZoneOf(local) == IF local THEN cpu.zone ELSE 0

(* [A15-20] No hour of daylight saving is known.                           *)
\* @type: $run;
NoHour == [from |-> 0, to |-> 0]

(* [T15-68] The parameters of its queue are known, and so is what waits.   *)
\* @type: Int => Bool;
HasQueue(o) == o \in DOMAIN cpu.queues /\ cpu.queues[o].size > 0

-----------------------------------------------------------------------------
(* SFC 39/40: blocked OBs *)

(* [IRT-11] The class number of an OB; not its priority class. *)
\* @type: Int => Int;
ClassNumber(o) == IF o \in 55..57 THEN 50 ELSE (Kin(o) \div 10) * 10

(* [IRT-11] The OBs that can be blocked; models use fewer. *)
Blockable == TodObs \cup DintObs \cup ExternalObs

(* [AMB-21] (b) Beside OBs, irt has marks: one for each class, one for     *)
(* everything.                                                             *)
\* @type: Int => Int;
ClassMark(number) == 1000 + number
AllMark == 2000

\* @type: (Set(Int), Int) => Bool;
MarkedIn(marks, o) ==
    /\ marks # {}
    /\ \/ o \in marks
       \/ ClassMark(ClassNumber(o)) \in marks
       \/ AllMark \in marks

(* [IRT-01] [IRT-02] New start events of the OB are lost. *)
\* @type: Int => Bool;
Blocked(o) == MarkedIn(irt.blocked, o)

(* [IRT-09] Nor do they get entries in the diagnostic buffer. *)
\* @type: Int => Bool;
Silenced(o) == MarkedIn(irt.silent, o)

(* Start events of the OB have an effect. *)
\* @type: Int => Bool;
TakesEvents(o) == ~Deselected(o) /\ ~Blocked(o)

-----------------------------------------------------------------------------
(* The stack *)

\* @type: (Int, Int) => $frame;
Frame(o, class) == [ob |-> o, class |-> class, error |-> 0, told |-> {}]

NoFrame == Frame(0, 0)

Running == IF stack = <<>> THEN NoFrame ELSE stack[Len(stack)]

(* [OBS-61] The running OB does not go on before its error OB has started. *)
Failed == Running.error # 0

(* Calls in OB 80 may concern the OBs that it reports. *)
InTimeErrorOb == Running.ob = TimeErrorOb

\* @type: Int => Bool;
OnStack(o) == \E i \in DOMAIN stack : stack[i].ob = o

(* In these modes start points are reached and delays run [OBS-41]         *)
(* [OBS-44]; not in HOLD [OBS-45] [DINT-19].                               *)
Watching == mode \in {"RUN", "STARTUP"}
=============================================================================

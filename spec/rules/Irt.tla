--------------------------------- MODULE Irt --------------------------------
(***************************************************************************)
(* SFC 39 DIS_IRT and SFC 40 EN_IRT: new interrupts and asynchronous       *)
(* errors are lost, without the reaction to a missing OB, until a call     *)
(* enables them or the CPU is restarted (section 3). StartEvents has the   *)
(* lost events, Cpu the blocked OBs.                                       *)
(*                                                                         *)
(* Left out: synchronous errors, which are not affected (SyncErrors).      *)
(***************************************************************************)
EXTENDS Calls, Errors

(* [IRT-11] The numbers that MODE 01 and MODE 02 take [AMB-73]: a startup  *)
(* or cycle OB from 123 on is no interrupt either.                         *)
Lacking == IF LackingObsAreRefused THEN Family.lacks ELSE {}
ObNumbersOfIrt ==
    ( OldTodObs \cup OldDintObs \cup ExternalObs
        \cup (NumberedObs \ (CycleObs \cup StartupObs)) ) \ Lacking
ClassNumbersOfIrt == { ClassNumber(o) : o \in ObNumbersOfIrt }

(* The numbers of all OBs of these CPUs. *)
ObNumbersInUse == {1, 73, 88, 90, 121, 122} \cup OldTodObs \cup OldDintObs
                    \cup (61..65) \cup (100..102) \cup ExternalObs
                    \cup NumberedObs

(* [IRT-06] [IRT-07] [IRT-08] MODE names everything, a class or an OB;     *)
(* with 80 to 82 nothing is entered in the diagnostic buffer either        *)
(* [IRT-09].                                                               *)
\* @type: Int => Int;
Level(m) == m % 128
\* @type: Int => Bool;
WithoutEntries(m) == m >= 128
DisModes == {0, 1, 2, 128, 129, 130}
(* [IRT-13] [AMB-76] *)
EnModes == IF EnIrtTakesMode8x THEN DisModes ELSE {0, 1, 2}

(* [IRT-12] [AMB-22] *)
\* @type: (Int, Int) => Bool;
NumberFits(m, o) ==
    CASE Level(m) = 0 -> o = 0 \/ ~Mode0TakesOb0Alone
      [] Level(m) = 1 -> o \in ClassNumbersOfIrt
      [] OTHER        -> o \in ObNumbersOfIrt

(* [T15-58] [A15-21] MODE 80 to 82 may be unknown.                         *)
\* @type: (Int, Set(Int)) => Set(Int);
WithMode8x(m, answers) ==
    IF ~(Family.openCodes /\ WithoutEntries(m)) \/ Mode8xIsKnown THEN answers
    ELSE IF Mode8xIsUnknown THEN {BadMode} ELSE answers \cup {BadMode}

(* [IRT-12] [AMB-63] With a bad MODE, 8090 is answered only for a number   *)
(* that no OB has.                                                         *)
\* @type: (Int, Int, Set(Int)) => Set(Int);
IrtErrors(m, o, modes) ==
    IF m \notin modes
    THEN {BadMode} \cup (IF o \in ObNumbersInUse THEN {} ELSE {BadOb})
    ELSE IF NumberFits(m, o) THEN {} ELSE {BadOb}

(* [T15-12] [T15-147] An OB that the S7-1500 does not know may be refused. *)
\* @type: (Int, Int, Set(Int)) => Set(Int);
WithUnknownOb(m, o, answers) ==
    IF Family.openCodes /\ Level(m) = 2 /\ o \in Family.lacks /\ OK \in answers
    THEN answers \cup {BadOb} ELSE answers

\* @type: (Int, Int) => Set(Int);
DisIrtAnswers(m, o) ==
    OpenCodes(WithMode8x(m, WithUnknownOb(m, o,
                              Usual(IrtErrors(m, o, DisModes)))))

(* [IRT-24] Nothing need be blocked.                                       *)
\* @type: (Int, Int) => Set(Int);
EnIrtAnswers(m, o) == WithUnknownOb(m, o, Usual(IrtErrors(m, o, EnModes)))

(* [AMB-21] One flag for each OB; under (b) one for each of three levels.  *)
\* @type: (Int, Int) => Set(Int);
Meant(m, o) ==
    IF Level(m) = 2 THEN {o}
    ELSE IF BlocksHaveLevels
    THEN { IF Level(m) = 0 THEN AllMark ELSE ClassMark(o) }
    ELSE { b \in Blockable : Level(m) = 0 \/ ClassNumber(b) = o }

(* [T15-54] [A15-21] A class may leave out the OBs from 123 on.            *)
\* @type: (Int, Int) => Set(Set(Int));
Meanings(m, o) ==
    IF NumberedObs = {} \/ Level(m) # 1 THEN {Meant(m, o)}
    ELSE (IF NumberedHaveNoClass THEN {} ELSE {Meant(m, o)})
           \cup (IF NumberedHaveAClass THEN {}
                 ELSE {Meant(m, o) \ NumberedObs})

(* [IRT-16] Flags, not counters; the last call wins, also for entries. *)
\* @type: (Set(Int), Bool) => $irt;
BlockedWith(marks, silent) ==
    [ blocked |-> irt.blocked \cup marks,
      silent  |-> IF silent THEN irt.silent \cup marks
                            ELSE irt.silent \ marks ]

\* @type: Set(Int) => $irt;
BlockedWithout(marks) ==
    [blocked |-> irt.blocked \ marks, silent |-> irt.silent \ marks]

(* [AMB-72] A waiting request still runs, or the call drops it; called in  *)
(* OB 80, it may cancel a catch-up [CLK-04] [AMB-15].                      *)
\* @type: ($request, Set(Int)) => Bool;
Dropped(r, marks) ==
    /\ MarkedIn(marks, r.ob)
    /\ \/ DisIrtDropsRequests
       \/ DisIrtStopsCatchUp /\ InTimeErrorOb /\ IsCatchUp(r)

\* @type: Set(Int) => Set($request);
RequestsAfterDisIrt(marks) ==
    LET gone == { r \in requests : Dropped(r, marks) }
    IN  IF gone = {} THEN requests ELSE Close(requests \ gone)

(* [IRT-09] [AMB-41] *)
\* @type: Int => Set($entry);
EntriesOfDisIrt(m) ==
    IF WithoutEntries(m) /\ DisIrtIsEntered
    THEN {Entry(EntriesDisabled)} ELSE {}

(* [IRT-01] [IRT-06] .. [IRT-09] *)
\* @type: (Int, Int, Int) => Bool;
DisIrt(m, o, ret) ==
    /\ IF ret = OK
       THEN \E marks \in Meanings(m, o) :
              /\ irt'      = BlockedWith(marks, WithoutEntries(m))
              /\ requests' = RequestsAfterDisIrt(marks)
              /\ entered'  = EntriesOfDisIrt(m)
       ELSE irt' = irt /\ requests' = requests /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, tod, dint, stopCause, runVars>>

(* [AMB-42] Under (b) MODE 1 blocks. *)
\* @type: (Int, Set(Int)) => $irt;
IrtAfterEnIrt(m, marks) ==
    IF Level(m) = 1 /\ EnIrtMode1Blocks THEN BlockedWith(marks, FALSE)
                                        ELSE BlockedWithout(marks)

(* [IRT-13] [IRT-14] *)
\* @type: (Int, Int, Int) => Bool;
EnIrt(m, o, ret) ==
    /\ irt' \in IF ret # OK THEN {irt}
               ELSE { IrtAfterEnIrt(m, marks) : marks \in Meanings(m, o) }
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, tod, dint, outcomeVars,
                   runVars>>
=============================================================================

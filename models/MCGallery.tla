------------------------------ MODULE MCGallery ------------------------------
(***************************************************************************)
(* A world in which TLC looks for the shortest behaviour with an edge      *)
(* case: the invariant Untold says that the case does not come.            *)
(*                                                                         *)
(* gallery/cases.txt has the cases. Each gives the constants below: the    *)
(* interventions of program and world (MayHappen), their number (Budget),  *)
(* and two predicates: Middle must hold in some state, and Goal in a later *)
(* state. Time and the steps of the CPU itself are free.                   *)
(*                                                                         *)
(* Left out: everything that a case does not need; its constants say so. *)
(***************************************************************************)
EXTENDS MCBase

VARIABLES
    (* Past steps: <<event, OB, number, 1 or 2>>, with 2 from the second    *)
    (* time on. The number is the fault id of an OB 80 or 85 that starts,   *)
    (* the fault id of the OB 80 that an OB follows, or the value           *)
    (* of the step.                                                        *)
    \* @type: Set(<<Str, Int, Int, Int>>);
    past,
    (* Interventions of program and world. *)
    \* @type: Int;
    spent,
    (* Middle has held. *)
    \* @type: Bool;
    met

(* The constants of a case; these values only complete the module. *)
\* @type: Set(Str);
MayHappen == {}
Budget == 0
Middle == TRUE
Goal == FALSE

GalleryTodObs == {10}
GalleryDintObs == {20}
GalleryBlockable == {10, 20, 40, 80, 85}
GalleryFamilies == {"S7-400"}
GalleryLoads == {{10, 20, 40, 80, 85}}
GalleryStep7 == {[o \in TodObs |-> NotConfigured]}
GalleryPriorities == {[o \in {} |-> 0]}
GalleryObNumbers == {10, 20}
GallerySdts == {Date(1)}
GalleryWords == {Once}
GalleryDtimes == {30000}
GallerySigns == {7}
GalleryIrtModes == {2}
GalleryMoments == HalfMinutes(0, 3)
GalleryPowerOn == {Moment(0, 30000)}
GalleryTargets == {Moment(2, 30000)}
GalleryInterrupts == {<<40, 0>>}
GalleryRestarts == {"warm"}
GalleryChangingObs == {}
GalleryHold == TRUE
GalleryRetVals ==
    0..4 \cup {BadOb, BadSdt, BadPeriod, NotSet, PastStart, NotDelayed}
GalleryReadings == {[a \in {} |-> ""]}

(* A time-of-day interrupt that STEP 7 has set and activated. *)
\* @type: (Str, Int) => Set(Int -> $step7);
Step7Active(execution, m) == {[o \in TodObs |-> Activated(execution, m)]}

(* The request that starts now: the first of the OB. *)
NewlyStarted ==
    CHOOSE r \in requests :
        /\ r.ob = step'.ob
        /\ \A q \in requests : q.ob = r.ob => r.rank <= q.rank

Number ==
    IF step'.event # "start" THEN step'.value
    ELSE IF \A r \in requests : r.ob # step'.ob THEN 0
    ELSE IF step'.ob \in {TimeErrorOb, ProgramErrorOb} THEN NewlyStarted.fault
    ELSE NewlyStarted.follows

Notes ==
    LET first == <<step'.event, step'.ob, Number, 1>>
    IN  IF step'.event = "time" THEN {}
        ELSE IF first \in past THEN {<<step'.event, step'.ob, Number, 2>>}
        ELSE {first}

(* For a case: it has happened, it has happened twice. *)
\* @type: (Str, Int, Int) => Bool;
Happened(event, o, n) == <<event, o, n, 1>> \in past
\* @type: (Str, Int, Int) => Bool;
Twice(event, o, n) == <<event, o, n, 2>> \in past
\* @type: Int => Bool;
Ran(o) == \E note \in past : note[1] = "start" /\ note[2] = o
\* @type: Str => Bool;
Some(event) == \E note \in past : note[1] = event
InCycle == mode = "RUN" /\ Running.ob = CycleOb
Now(m, ms) == clock = Moment(m, ms)

(* Steps that are no intervention; the first restart switches the CPU on. *)
ByItself == {"start", "end", "run", "missing", "dropped", "stop", "reached",
         "elapsed", "time"}
SwitchesOn == step'.event = "restart" /\ past = {}

GalleryInit == Init /\ past = {} /\ spent = 0 /\ met = Middle
GalleryNext ==
    /\ Next
    /\ \/ step'.event \in ByItself /\ spent' = spent
       \/ SwitchesOn /\ spent' = spent
       \/ step'.event \in MayHappen /\ spent < Budget /\ spent' = spent + 1
    /\ past = {} => SwitchesOn
    /\ past' = past \cup Notes
    /\ met' = (met \/ Middle')
GallerySpec == GalleryInit /\ [][GalleryNext]_<<vars, past, spent, met>>

GalleryView == <<cpuVars, past, spent, met>>

Untold == ~(met /\ Goal)
=============================================================================

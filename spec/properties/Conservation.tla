---------------------------- MODULE Conservation ----------------------------
(***************************************************************************)
(* No start event disappears and none is made up (section 5.1): each is    *)
(* exactly one of                                                          *)
(*   waiting    until its OB starts [OBS-07]                               *)
(*   open       the sources leave open whether it has an effect of its own *)
(*              [AMB-18] [AMB-45] [AMB-77]                                 *)
(*   running, and when its OB has ended, served                            *)
(*   lost       under DIS_IRT [IRT-04], of its OB or of the OB 80 that     *)
(*              reports it [AMB-48]                                        *)
(*   missed     since its OB is missing [OBS-20]                           *)
(*   withdrawn  by a call that cancels the interrupt [TINT-50], by the     *)
(*              call of the OB of a one-shot interrupt [TINT-08], or with  *)
(*              its OB [AMB-66]                                            *)
(*   cleared    by STOP [OBS-41]                                           *)
(*   merged     with a start event that waited, was open or ran            *)
(*                                                                         *)
(* An abstract specification: System implements it (models/FatesMapping).  *)
(* `fates' is a multiset for each OB: how many start events have each      *)
(* fate.                                                                   *)
(* Left out: why an event is lost, missed or cleared when it occurs. The   *)
(* mapping says it.                                                        *)
(***************************************************************************)
EXTENDS Integers

CONSTANT
    (* OBs. *)
    \* @type: Set(Int);
    Obs

VARIABLES
    (* The number of start events of each OB so far, and their fates. *)
    \* @type: Int -> Int;
    occurred,
    \* @type: Int -> (Str -> Int);
    fates

tokenVars == <<occurred, fates>>

Fates == { "waiting", "open", "running", "served", "lost", "missed",
           "withdrawn", "cleared", "merged" }

\* @type: (Str -> Int) => Int;
Total(b) == b["waiting"] + b["open"] + b["running"] + b["served"] + b["lost"]
              + b["missed"] + b["withdrawn"] + b["cleared"] + b["merged"]

(* Every start event has one fate. *)
Conserved == \A o \in Obs : occurred[o] = Total(fates[o])

Init == /\ occurred = [o \in Obs |-> 0]
        /\ fates = [o \in Obs |-> [f \in Fates |-> 0]]

-----------------------------------------------------------------------------
(* What a step does to the start events of one OB *)

\* @type: (Int, Str) => Int;
Change(o, f) == fates'[o][f] - fates[o][f]

\* @type: (Int, Str) => Bool;
More(o, f) == Change(o, f) > 0

\* @type: Int => Bool;
Busy(o) == fates[o]["waiting"] + fates[o]["open"] + fates[o]["running"] > 0

(* So many start events occur, and only these fates change. *)
\* @type: (Int, Int, Set(Str)) => Bool;
Moves(o, n, some) == /\ occurred'[o] = occurred[o] + n
                     /\ Total(fates'[o]) = Total(fates[o]) + n
                     /\ \A f \in Fates \ some : Change(o, f) = 0

(* Open start events may turn out to have had no effect. *)
\* @type: Int => Bool;
Fades(o) == Moves(o, 0, {"open", "merged"}) /\ ~More(o, "open")

(* One start event occurs, or up to three: a time error may be reported in *)
(* two ways, and an OB 80 from outside may come beside both. One is merged *)
(* only with another one. If one waits, open ones may turn out to have had *)
(* no effect.                                                              *)
\* @type: Int => Bool;
Occurs(o) ==
    LET new == {"waiting", "lost", "missed", "cleared", "merged"}
        n   == occurred'[o] - occurred[o]
    IN  /\ n \in 1..3
        /\ Moves(o, n, new \cup {"open"})
        /\ \A f \in new : Change(o, f) >= 0
        /\ Change(o, "open") < 0 => More(o, "waiting")
        /\ More(o, "merged") => Busy(o) \/ Busy(o)'

(* One start event that waits or is open is taken to be run or missed.     *)
(* Open ones may turn out to have had no effect; or, of a one-shot         *)
(* interrupt, all others are withdrawn.                                    *)
\* @type: (Int, Str) => Bool;
Taken(o, fate) ==
    /\ Moves(o, 0, {"waiting", "open", fate, "withdrawn", "merged"})
    /\ Change(o, fate) = 1
    /\ Change(o, "merged") >= 0
    /\ \/ /\ Change(o, "waiting") \in {-1, 0}
          /\ ~More(o, "open")
          /\ Change(o, "withdrawn") = 0
       \/ /\ fates'[o]["waiting"] = 0 /\ fates'[o]["open"] = 0
          /\ Change(o, "withdrawn") >= 0
          /\ Change(o, "withdrawn") + Change(o, "waiting") \in {-1, 0}

\* @type: Int => Bool;
Ends(o) == /\ Moves(o, 0, {"running", "served"})
           /\ Change(o, "running") = -1

(* [AMB-45] Another OB may have reported that this one is missing. *)
\* @type: Int => Bool;
Excused(o) == Moves(o, 0, {"waiting", "open"}) /\ ~More(o, "waiting")

\* @type: Int => Bool;
Withdraws(o) ==
    /\ Moves(o, 0, {"waiting", "open", "withdrawn", "merged"})
    /\ fates'[o]["waiting"] = 0 /\ fates'[o]["open"] = 0
    /\ Change(o, "withdrawn") = fates[o]["waiting"]

\* @type: Int => Bool;
Clears(o) ==
    /\ Moves(o, 0, {"waiting", "open", "running", "cleared", "merged"})
    /\ fates'[o]["waiting"] = 0 /\ fates'[o]["open"] = 0
    /\ fates'[o]["running"] = 0
    /\ Change(o, "merged") = fates[o]["open"]

-----------------------------------------------------------------------------

Occur == \A o \in Obs : Occurs(o) \/ Fades(o)

\* @type: Int => Bool;
Start(o) == Taken(o, "running") /\ \A p \in Obs \ {o} : Fades(p)

\* @type: Int => Bool;
End(o) == Ends(o) /\ \A p \in Obs \ {o} : Excused(p)

(* An OB that is missing, or no longer waits, may be reported by another.  *)
\* @type: Int => Bool;
Vanish(o) == /\ Withdraws(o) \/ Taken(o, "missed")
             /\ \A p \in Obs \ {o} : Occurs(p) \/ Fades(p)

Stop == \A o \in Obs : Clears(o)

Next == \/ Occur \/ Stop
        \/ \E o \in Obs : Start(o) \/ End(o) \/ Vanish(o)

Spec == Init /\ [][Next]_tokenVars
=============================================================================

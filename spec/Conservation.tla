---------------------------- MODULE Conservation ----------------------------
(***************************************************************************)
(* No start event disappears and none is made up (section 5.1): each is    *)
(* exactly one of                                                          *)
(*   waiting    until its OB starts [OBS-07]                               *)
(*   open       the sources leave open whether it has an effect of its own *)
(*              [AMB-18] [AMB-77]                                          *)
(*   running, and when its OB has ended, served                            *)
(*   lost       under DIS_IRT [IRT-04]                                     *)
(*   withdrawn  by a call that cancels the interrupt [TINT-50], or by the  *)
(*              call of the OB of a once interrupt [TINT-08]               *)
(*   cleared    by STOP [OBS-41]                                           *)
(*   merged     with a start event that waited, was open or ran            *)
(*                                                                         *)
(* An abstract specification: models/MCRefineEvents shows that System      *)
(* implements it.  `fates' is a multiset for each OB: how many start       *)
(* events have each fate.                                                  *)
(* Left out: missing OBs, HOLD, a blocked OB 80 (which may take the runs   *)
(* that follow it along [AMB-48]).                                         *)
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

Fates == { "waiting", "open", "running", "served", "lost", "withdrawn",
           "cleared", "merged" }

\* @type: (Str -> Int) => Int;
Total(b) == b["waiting"] + b["open"] + b["running"] + b["served"] + b["lost"]
              + b["withdrawn"] + b["cleared"] + b["merged"]

(* Every start event has one fate. *)
Conserved == \A o \in Obs : occurred[o] = Total(fates[o])

Init == /\ occurred = [o \in Obs |-> 0]
        /\ fates = [o \in Obs |-> [f \in Fates |-> 0]]

-----------------------------------------------------------------------------
(* The fates of one OB's start events, b, after a step *)

\* @type: (Str -> Int, Str) => (Str -> Int);
OneMore(b, f) == [g \in Fates |-> IF g = f THEN b[g] + 1 ELSE b[g]]

\* @type: (Str -> Int, Str, Str, Int) => (Str -> Int);
Moved(b, f, g, n) == [ h \in Fates |-> IF h = f THEN b[h] - n
                                       ELSE IF h = g THEN b[h] + n ELSE b[h] ]

(* Any number of open start events may turn out to have had no effect. *)
\* @type: (Str -> Int) => Set(Str -> Int);
Faded(b) == { Moved(b, "open", "merged", n) : n \in 0..b["open"] }

(* One start event occurs.  It is merged only with another one. *)
\* @type: (Str -> Int) => Set(Str -> Int);
WithOneMore(b) ==
    { OneMore(c, "waiting") : c \in Faded(b) }
      \cup { OneMore(b, "open"), OneMore(b, "lost") }
      \cup (IF b["waiting"] + b["open"] + b["running"] > 0
            THEN { OneMore(b, "merged") } ELSE {})

(* By the start of the OB of a once interrupt the others are withdrawn. *)
\* @type: (Str -> Int) => Set(Str -> Int);
WithStart(b) ==
    { Moved(b, f, "running", 1)
      : f \in { g \in {"waiting", "open"} : b[g] > 0 } }
\* @type: (Str -> Int) => Set(Str -> Int);
WithLastStart(b) ==
    { Moved(Moved(c, "waiting", "withdrawn", c["waiting"]),
            "open", "merged", c["open"]) : c \in WithStart(b) }

-----------------------------------------------------------------------------

(* One or two start events of an OB occur at a time: a time error may be   *)
(* reported in two ways.                                                   *)
Occur == \A o \in Obs :
           LET one == WithOneMore(fates[o])
           IN  \/ occurred'[o] = occurred[o] /\ fates'[o] = fates[o]
               \/ occurred'[o] = occurred[o] + 1 /\ fates'[o] \in one
               \/ /\ occurred'[o] = occurred[o] + 2
                  /\ \E c \in one : fates'[o] \in WithOneMore(c)

\* @type: Int => Bool;
Start(o) == /\ \A p \in Obs :
                 fates'[p] \in
                   IF p = o
                   THEN UNION { Faded(c) : c \in WithStart(fates[p]) }
                          \cup WithLastStart(fates[p])
                   ELSE Faded(fates[p])
            /\ UNCHANGED occurred

\* @type: Int => Bool;
End(o) == /\ fates[o]["running"] > 0
          /\ fates' = [fates EXCEPT ![o] =
                         Moved(fates[o], "running", "served", 1)]
          /\ UNCHANGED occurred

\* @type: Int => Bool;
Withdraw(o) == /\ fates' = [fates EXCEPT ![o] =
                    Moved(Moved(fates[o],
                      "waiting", "withdrawn", fates[o]["waiting"]),
                      "open", "merged", fates[o]["open"])]
               /\ UNCHANGED occurred

Fade == (\A o \in Obs : fates'[o] \in Faded(fates[o])) /\ UNCHANGED occurred

Stop == /\ fates' = [o \in Obs |->
                      Moved(Moved(Moved(fates[o],
                        "waiting", "cleared", fates[o]["waiting"]),
                        "running", "cleared", fates[o]["running"]),
                        "open", "merged", fates[o]["open"])]
        /\ UNCHANGED occurred

Next == \/ Occur \/ Fade \/ Stop
        \/ \E o \in Obs : Start(o) \/ End(o) \/ Withdraw(o)

Spec == Init /\ [][Next]_tokenVars
=============================================================================

---------------------------- MODULE FatesMapping ----------------------------
(***************************************************************************)
(* The start events of some OBs of System as those of Conservation, for    *)
(* MCRefineEvents and APConserve.                                          *)
(*                                                                         *)
(* The history counts as an observer can: start events as they occur, of   *)
(* OB 80 and OB 85 by their entries in the diagnostic buffer; ends; missing *)
(* OBs; start events that a call, a deletion or STOP removes; and those of *)
(* an OB that has no other one, if they leave nothing and have a cause to  *)
(* do so. Waiting, open and running ones are counted in the state. The     *)
(* rest is "merged": Conservation says that only start events that may be  *)
(* merged are.                                                             *)
(***************************************************************************)
EXTENDS Properties

CONSTANT
    \* @type: Set(Int);
    CountedObs

VARIABLES
    \* @type: Int -> Int;
    occurred,
    \* @type: Int -> Int;
    served,
    \* @type: Int -> Int;
    lost,
    \* @type: Int -> Int;
    missed,
    \* @type: Int -> Int;
    withdrawn,
    \* @type: Int -> Int;
    cleared

history == <<occurred, served, lost, missed, withdrawn, cleared>>

NoneYet == [o \in CountedObs |-> 0]

\* @type: Int => Int;
Waits(o) == Cardinality({ r \in requests : r.ob = o /\ ~r.open })
\* @type: Int => Int;
Opens(o) == Cardinality({ r \in requests : r.ob = o /\ r.open })
\* @type: Int => Int;
Runs(o) == Cardinality({ i \in DOMAIN stack : stack[i].ob = o })

-----------------------------------------------------------------------------
(* A step of System as an observer sees it *)

(* An error that may have occurred counts if its OB may wait for it.       *)
\* @type: Int => Int;
ErrorsOccurring(o) ==
    LET ofThis == { n \in entered' : n.of.ob = o }
        sure   == Cardinality({ n \in ofThis : ~n.open })
        more   == (Waits(o) + Opens(o))' - Waits(o) - Opens(o)
    IN  IF (\E n \in ofThis : n.open) /\ more > 0 THEN sure + more ELSE sure

(* A skip may wait for the end of HOLD [AMB-53].                           *)
\* @type: Int => Bool;
ComesOfASkip(o) ==
    \/ /\ step'.event \in {"clock", "release"} /\ mode # "STOP"
       /\ Skipped(o) /\ tod'[o].next # tod[o].next
    \/ PassedInHold(o)

(* How many start events of an OB occur in this step. *)
\* @type: Int => Int;
Occurring(o) ==
    IF o \in AsyncErrorObs THEN ErrorsOccurring(o)
    ELSE IF /\ ~Deselected(o)
            /\ \/ /\ step'.event \in {"interrupt", "reached", "elapsed"}
                  /\ step'.ob = o /\ mode # "STOP"
               \/ o \in TodObs /\ ComesOfASkip(o)
               \/ Did("restart") /\ PendingIn(requests', o)
    THEN 1 ELSE 0

(* No other start event of the OB was there, and this one leaves nothing.  *)
\* @type: Int => Bool;
LeavesNothing(o) == /\ Waits(o) + Opens(o) + Runs(o) = 0
                    /\ { r \in requests' : r.ob = o } = {}

(* A buffer overflow [OBS-08], or an OB 80 that is blocked [AMB-48], takes *)
(* the start event of another OB along. The overflow has no entry if OB 80 *)
(* is blocked without entries [IRT-09].                                    *)
\* @type: Int => Bool;
IsTakenAlong(o) ==
    \/ Did("interrupt") /\ Silenced(TimeErrorOb) /\ ClassIsTaken(ClassOf(o))
    \/ \E n \in entered' : /\ n.id = ErrorEntry + BufferOverflow
                           /\ n.of.cause = o
    \/ o \in TodObs /\ ComesOfASkip(o) /\ Blocked(TimeErrorOb)

\* @type: Int => Bool;
IsLost(o) == /\ ~Did("restart")
             /\ Blocked(o) \/ (LeavesNothing(o) /\ IsTakenAlong(o))
\* @type: Int => Bool;
IsMissed(o) == /\ o \in AsyncErrorObs \ loaded
               /\ LeavesNothing(o)
\* @type: Int => Bool;
IsCleared(o) == LeavesNothing(o) /\ stopCause' # NoCause

(* How many of those waiting are withdrawn: by a call, with the OB, or     *)
(* since the OB of a one-shot interrupt is called for one of them.         *)
\* @type: Int => Int;
Withdrawing(o) ==
    LET gone == Waits(o) - Waits(o)'
    IN  IF step'.ob # o THEN 0
        ELSE IF step'.event \in { "SET_TINT", "CAN_TINT", "SRT_DINT",
                                  "CAN_DINT", "delete" }
        THEN gone
        ELSE IF /\ step'.event \in {"start", "missing"} /\ gone > 1
                /\ o \in TodObs /\ tod[o].period = Once
        THEN gone - 1 ELSE 0

\* @type: (Int -> Int, Int -> Int) => (Int -> Int);
Plus(f, g) == [o \in CountedObs |-> f[o] + g[o]]

(* One that is lost is not missed, and one that is missed is not cleared.  *)
HistoryCounts ==
    LET new    == [o \in CountedObs |-> Occurring(o)]
        stops  == step'.event \in {"stop", "switch"}
        by(e)  == [o \in CountedObs |-> IF Did(e) /\ step'.ob = o THEN 1
                                                                  ELSE 0]
    IN  /\ occurred'  = Plus(occurred, new)
        /\ served'    = Plus(served, by("end"))
        /\ lost'      = Plus(lost, [o \in CountedObs |->
                          IF IsLost(o) THEN new[o] ELSE 0])
        /\ missed'    = Plus(Plus(missed, by("missing")),
                          [o \in CountedObs |->
                            IF IsMissed(o) /\ ~IsLost(o) THEN new[o] ELSE 0])
        /\ withdrawn' = Plus(withdrawn,
                          [o \in CountedObs |-> Withdrawing(o)])
        /\ cleared'   = Plus(cleared, [o \in CountedObs |->
                          IF stops THEN Waits(o) + Runs(o)
                          ELSE IF IsCleared(o) /\ ~IsMissed(o) /\ ~IsLost(o)
                          THEN new[o] ELSE 0])

-----------------------------------------------------------------------------

\* @type: Int => (Str -> Int);
FatesOf(o) ==
    LET waits == Waits(o)
        open  == Opens(o)
        runs  == Runs(o)
        rest  == occurred[o] - waits - open - runs - served[o] - lost[o]
                   - missed[o] - withdrawn[o] - cleared[o]
    IN  [ f \in { "waiting", "open", "running", "served", "lost", "missed",
                  "withdrawn", "cleared", "merged" } |->
            CASE f = "waiting"   -> waits
              [] f = "open"      -> open
              [] f = "running"   -> runs
              [] f = "served"    -> served[o]
              [] f = "lost"      -> lost[o]
              [] f = "missed"    -> missed[o]
              [] f = "withdrawn" -> withdrawn[o]
              [] f = "cleared"   -> cleared[o]
              [] OTHER           -> rest ]

AllFates == [o \in CountedObs |-> FatesOf(o)]
=============================================================================

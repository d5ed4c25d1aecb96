----------------------------- MODULE LifeMapping -----------------------------
(***************************************************************************)
(* OB 10 of System as the interrupt of LifeCycle, for MCRefineTod and      *)
(* APRefine. A deselected OB counts as not set.                            *)
(*                                                                         *)
(* `past' is history: an observer could keep it.                           *)
(***************************************************************************)
EXTENDS Properties

VARIABLE
    \* @type: Str;
    past

(* A start event of OB 10 occurs. A skip may wait for the end of HOLD      *)
(* [AMB-53].                                                               *)
Occurs10 == /\ ~Deselected(10)
            /\ \/ Did("reached") /\ step'.ob = 10
               \/ /\ step'.event \in {"clock", "release"} /\ mode # "STOP"
                  /\ Skipped(10) /\ tod'[10].next # tod[10].next
               \/ PassedInHold(10)

(* The start events of OB 10 are over. *)
PastAfter ==
    IF Did("end") /\ step'.ob = 10 THEN "served"
    ELSE IF Did("missing") /\ step'.ob = 10 THEN "missed"
    ELSE IF /\ step'.event \in {"SET_TINT", "CAN_TINT"}
            /\ step'.ob = 10 /\ step'.value = OK
            /\ PendingIn(requests, 10)
    THEN "cancelled"
    ELSE IF Occurs10 /\ Blocked(10) THEN "lost"
    ELSE IF /\ step'.event \in {"stop", "switch"}
            /\ PendingIn(requests, 10) \/ OnStack(10)
    THEN "cleared"
    ELSE past

IsSet10 == tod[10].set /\ ~Deselected(10)

Setting10 == IF ~IsSet10 THEN "unset"
             ELSE IF tod[10].called THEN "called"
             ELSE IF tod[10].active THEN "active" ELSE "set"
Once10    == IsSet10 /\ tod[10].period = Once
Waiting10 == Cardinality({ r \in requests : r.ob = 10 /\ ~r.open })
=============================================================================

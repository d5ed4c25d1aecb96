----------------------------- MODULE APConserve -----------------------------
(***************************************************************************)
(* System implements Conservation, for Apalache: from any state in which   *)
(* Ind holds, in the world of APSystem, each action is a step of it or     *)
(* changes nothing of it. An asynchronous error has a fault id.            *)
(*                                                                         *)
(* One OB is counted here, and it is any. That is enough for all: Next of  *)
(* Conservation says of each OB by itself what a step does to it. Which    *)
(* part of Next that is depends on the event, and on whether it is of the  *)
(* OB, of another one of the world, or of none (EventsStep).               *)
(* The history begins at 0: Conservation speaks of what a step adds. The   *)
(* fates are a variable, since Apalache copies what stands for a variable. *)
(***************************************************************************)
EXTENDS APSystem, FatesMapping

CONSTANTS
    \* @type: Int;
    TheOb

APCounted == {TheOb}

WorldObs == {10, 11, 20, 21, 40, 80, 85}

ConserveConstants == /\ AnyConstants
                     /\ AnyFault # 0
                     /\ TheOb \in WorldObs

(* What a call withdraws, or the deletion of the OB. *)
Withdrawals == { "SET_TINT", "CAN_TINT", "SRT_DINT", "CAN_DINT", "delete" }

VARIABLE
    \* @type: Int -> (Str -> Int);
    counts

CountsBegin == /\ served = NoneYet /\ lost = NoneYet /\ missed = NoneYet
               /\ withdrawn = NoneYet /\ cleared = NoneYet
               /\ counts = AllFates

AnyCounted ==
    /\ AnyInit
    /\ occurred = [o \in CountedObs |-> Waits(o) + Opens(o) + Runs(o)]
    /\ CountsBegin
FirstCounted == Init /\ occurred = NoneYet /\ CountsBegin

CountedOn == HistoryCounts /\ counts' = AllFates'

Tokens == INSTANCE Conservation WITH Obs <- CountedObs, fates <- counts

EventsBegin == Tokens!Init

(* The part of Next of Conservation that the event is. A call that answers *)
(* an error withdraws nothing: then the step is Occur, in which an OB may  *)
(* stay as it is.                                                          *)
EventsStep ==
    LET own(some)    == step'.event \in some /\ step'.ob = TheOb
        others(some) == step'.event \in some /\ step'.ob \in WorldObs \ {TheOb}
    IN  IF own({"start"}) THEN Tokens!Start(TheOb)
        ELSE IF others({"start"}) THEN Tokens!Fades(TheOb)
        ELSE IF own({"end"}) THEN Tokens!End(TheOb)
        ELSE IF others({"end"}) THEN Tokens!Excused(TheOb)
        ELSE IF own({"missing"} \cup Withdrawals)
        THEN Tokens!Vanish(TheOb) \/ UNCHANGED Tokens!tokenVars
        ELSE IF step'.event \in {"stop", "switch"} THEN Tokens!Stop
        ELSE Tokens!Occur
=============================================================================

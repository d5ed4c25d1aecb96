----------------------------- MODULE APConserve -----------------------------
(***************************************************************************)
(* System implements Conservation, for Apalache: from any state in which   *)
(* Ind holds, in the world of APSystem, each action is a step of it or     *)
(* changes nothing of it. An asynchronous error has a fault id.            *)
(*                                                                         *)
(* Two OBs are counted here, and each is any. That is enough for all: Next *)
(* of Conservation speaks of one OB that starts, ends, is missing or loses *)
(* its start events, and of each other by itself. That one is the first    *)
(* here, since another is another case of the same query.                  *)
(* The history begins at 0: Conservation speaks of what a step adds. The   *)
(* fates are a variable, since Apalache copies what stands for a variable. *)
(***************************************************************************)
EXTENDS APSystem, FatesMapping

CONSTANTS
    \* @type: Int;
    ActingOb,
    \* @type: Int;
    OtherOb

APCounted == {ActingOb, OtherOb}

WorldObs == {10, 11, 20, 40, 80, 85}

ConserveConstants == /\ AnyConstants
                     /\ AnyFault # 0
                     /\ ActingOb \in WorldObs
                     /\ OtherOb \in WorldObs

(* What a call withdraws, or the deletion of the OB. *)
Withdrawals == { "SET_TINT", "CAN_TINT", "SRT_DINT", "CAN_DINT", "delete" }

AnotherActs == /\ step'.event \in {"start", "end", "missing"} \cup Withdrawals
               /\ step'.ob \in WorldObs \ {ActingOb}

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

CountedOn == Counted /\ counts' = AllFates'

Tokens == INSTANCE Conservation WITH Obs <- CountedObs, fates <- counts

EventsBegin == Tokens!Init

(* The part of Next of Conservation that the event is. *)
PartOfNext ==
    LET acts(some) == step'.event \in some /\ step'.ob = ActingOb
    IN  IF acts({"start"}) THEN Tokens!Start(ActingOb)
        ELSE IF acts({"end"}) THEN Tokens!End(ActingOb)
        ELSE IF acts({"missing"} \cup Withdrawals) THEN Tokens!Vanish(ActingOb)
        ELSE IF step'.event \in {"stop", "switch"} THEN Tokens!Stop
        ELSE Tokens!Occur

EventsStep == AnotherActs \/ UNCHANGED Tokens!tokenVars \/ PartOfNext
=============================================================================

------------------------------- MODULE APLife -------------------------------
(***************************************************************************)
(* A proof by Apalache that the life cycle of a time-of-day interrupt      *)
(* (spec/LifeCycle) has the properties of MCLifeAlone, for any number of   *)
(* waiting start events:                                                   *)
(*   1. Invariant holds in the initial state;                              *)
(*   2. every step from every state in which it holds ends in one;         *)
(*   3. every such step is as the ...Step formulas say.                    *)
(* s7check prove 'life-*'                                                  *)
(***************************************************************************)
EXTENDS MCLifeAlone

Invariant == OffInv /\ ActiveInv /\ waiting >= 0

(* Any state in which Invariant holds. *)
AnyState ==
    /\ on \in BOOLEAN
    /\ setting \in Settings
    /\ once \in BOOLEAN
    /\ blocked \in BOOLEAN
    /\ waiting \in Nat
    /\ perhaps \in BOOLEAN
    /\ running \in BOOLEAN
    /\ past \in Pasts

AnyInit == AnyState /\ Invariant

(* Next of LifeCycle. A variable that it leaves open may take any value of *)
(* its type.                                                               *)
APNext ==
    \/ Set \/ Cancel \/ Activate \/ Lost \/ End \/ Fade
    \/ Stop \/ Restart
    \/ perhaps' \in BOOLEAN /\ (Due \/ Start)
    \/ blocked' \in BOOLEAN /\ BlockOrFree

Steps == StartStep /\ OnceStep /\ StaysStep /\ ActivateStep /\ BlockedStep
           /\ RunsOnStep
=============================================================================

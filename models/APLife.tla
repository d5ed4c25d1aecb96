------------------------------- MODULE APLife -------------------------------
(***************************************************************************)
(* A proof by Apalache that the life cycle of a time-of-day interrupt      *)
(* (spec/properties) has the properties of MCLifeAlone, for any number of   *)
(* waiting start events:                                                   *)
(*   1. Invariant holds in the initial state;                              *)
(*   2. every step from every state in which it holds ends in one;         *)
(*   3. every such step is as the ...Step formulas say.                    *)
(* s7spec prove 'life-*'                                                   *)
(***************************************************************************)
EXTENDS MCLifeAlone

Invariant == OffInv /\ ActiveInv /\ waiting >= 0

(* Any state in which Invariant holds. *)
AnyState ==
    /\ on \in BOOLEAN
    /\ doomed \in BOOLEAN
    /\ loaded \in BOOLEAN
    /\ setting \in Settings
    /\ once \in BOOLEAN
    /\ blocked \in BOOLEAN
    /\ waiting \in Nat
    /\ perhaps \in BOOLEAN
    /\ running \in BOOLEAN
    /\ past \in Pasts

AnyInit == AnyState /\ Invariant

APNext == AnyNext

Steps == StartStep /\ OnceStep /\ StaysStep /\ ActivateStep /\ BlockedStep
           /\ RunsOnStep /\ LostStep
=============================================================================

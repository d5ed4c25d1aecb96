------------------------------- MODULE APFates ------------------------------
(***************************************************************************)
(* A proof by Apalache that Conservation (spec/properties) has the         *)
(* properties of MCFatesAlone for ANY number of start events:              *)
(*   1. Invariant holds in the initial state;                              *)
(*   2. every step from every state in which it holds ends in one;         *)
(*   3. every such step is as the properties of MCFatesAlone say.          *)
(* Two OBs are enough: a step speaks of one OB, and of each other OB by    *)
(* itself; OpenProp of two.                                                *)
(* s7spec prove 'fates-*'                                                  *)
(***************************************************************************)
EXTENDS MCFatesAlone

APObs == {10, 20}
(* MCFatesAlone bounds TLC's states by it. *)
APMost == 0

Invariant == /\ Conserved
             /\ \A o \in Obs, f \in Fates : fates[o][f] >= 0

(* Any numbers of each OB. *)
\* @type: (Str -> Int, Str -> Int) => (Int -> (Str -> Int));
OfBoth(f, g) == [o \in Obs |-> IF o = 10 THEN f ELSE g]

AnyInit == /\ \E f, g \in [Fates -> Int] : fates = OfBoth(f, g)
           /\ occurred \in [Obs -> Int]
           /\ Invariant

(* Next says what changes, not to what: it does not go below zero.         *)
APNext == /\ \E f, g \in [Fates -> Int] : fates' = OfBoth(f, g)
          /\ occurred' \in [Obs -> Int]
          /\ Next
          /\ \A o \in Obs, f \in Fates : fates'[o][f] >= 0

Steps == /\ OverProp /\ ServedProp /\ RunsProp /\ MissedProp /\ OpenProp
         /\ LostProp /\ OccurProp
=============================================================================

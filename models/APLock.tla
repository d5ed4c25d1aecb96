------------------------------- MODULE APLock -------------------------------
(***************************************************************************)
(* A proof by Apalache that the counter lock (spec/properties, SFC 41 and  *)
(* 42) has the properties of MCLockAlone, for EVERY delay count and any    *)
(* number of waiting start events, in three priority classes:              *)
(*   1. Invariant holds in the initial state;                              *)
(*   2. every step from every state in which it holds ends in one;         *)
(*   3. every such step is as the ...Step formulas say.                    *)
(* The classes are 1 to 3, since only their order matters. A stack in      *)
(* ascending order is then never longer than three.                        *)
(* s7spec prove 'lock-*'                                                   *)
(***************************************************************************)
EXTENDS MCLockAlone

APClasses == 1..3

Invariant == /\ CountInv /\ NestedInv /\ OffInv
             /\ count >= 0
             /\ \A c \in Classes : waiting[c] >= 0
             /\ \A i \in DOMAIN running : running[i] \in Classes

\* @type: (Int, Int, Int) => (Int -> Int);
AsFunction(a, b, c) ==
    [d \in Classes |-> IF d = 1 THEN a ELSE IF d = 2 THEN b ELSE c]

(* Any state in which Invariant holds. *)
AnyState ==
    /\ on \in BOOLEAN
    /\ held \in BOOLEAN
    /\ asked \in BOOLEAN
    /\ count \in Nat
    /\ perhaps \in SUBSET Classes
    /\ \E a, b, c \in Nat : waiting = AsFunction(a, b, c)
    /\ \E a, b, c \in Classes : \E n \in 0..3 :
          running = SubSeq(<<a, b, c>>, 1, n)

AnyInit == AnyState /\ Invariant

(* Next of CounterLock. It leaves the arrivals open: any number, of any    *)
(* classes.                                                                *)
AnyNumbers == \E a, b, c \in Nat : waiting' = AsFunction(a, b, c)

APNext ==
    /\ asked' \in BOOLEAN
    /\ \/ Take \/ GiveBack \/ Leave \/ Pause \/ Stop \/ Restart \/ Nothing
       \/ AnyPerhaps /\ Fade
       \/ AnyNumbers /\ AnyPerhaps /\ (Arrive \/ Withdraw \/ Resume)
       \/ \E c \in Classes :
            (AnyNumbers /\ AnyPerhaps /\ Enter(c)) \/ Begin(c)

Steps == HeldStep /\ HighestStep /\ NoneLostStep /\ AtOnceStep
           /\ CountedStep /\ EndStep
=============================================================================

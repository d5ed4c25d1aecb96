------------------------ MODULE CanaryLazyExcept ------------------------
(***************************************************************************)
(* Tells whether the TLC at hand corrupts a function that it evaluates     *)
(* lazily when EXCEPT is applied to it.  `before` is total over Keys, so   *)
(* the invariant is false in the initial state and TLC must say so.  A TLC *)
(* with the defect loses part of `before` while it computes `after`, and   *)
(* reports success: it misses a safety violation.                          *)
(***************************************************************************)
EXTENDS Naturals

Keys == [{0} -> {0, 1}]
KeyA == [k \in {0} |-> 0]
KeyB == [k \in {0} |-> 1]
Row == [k \in {KeyA} |-> 1]

VARIABLES before, after

Init ==
    /\ before = [[k \in Keys |-> 0] EXCEPT ![KeyA] = Row]
    /\ after = [before EXCEPT ![KeyB] = 2]

Next == UNCHANGED <<before, after>>

\* False by construction: both domains are Keys.
DomainLost == DOMAIN before # Keys
=========================================================================

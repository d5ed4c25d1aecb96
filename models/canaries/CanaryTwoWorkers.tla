------------------------ MODULE CanaryTwoWorkers ------------------------
(***************************************************************************)
(* Tells whether the TLC at hand loses liveness violations when it runs    *)
(* with two workers.  The property is false (-1, 1, 0, 0, ... breaks it).  *)
(* The worker that explores the initial state hands out its successors and *)
(* is then kept busy by Slow, so the other worker is ahead of it: the      *)
(* order of exploration in which the defect shows.                         *)
(***************************************************************************)
EXTENDS Integers, FiniteSets

VARIABLE x

Init == x = -1

\* True for n in 0..16, after a while.
Slow(n) == Cardinality({s \in SUBSET (0..16) : n \in s}) > 0

Next ==
    \/ x' \in {0, 1, 2}
    \/ /\ x = -1
       /\ ~Slow(x + 2)
       /\ x' = x

OnceLeftStaysAtTwo == []((x = 1) => []((x = 0) => [](x = 2)))

\* Makes TLC build the tableau that the defect needs; always true.
Tautology == (x = x) ~> (x = x)
=========================================================================

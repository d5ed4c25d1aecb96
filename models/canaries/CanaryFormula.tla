-------------------------- MODULE CanaryFormula -------------------------
(***************************************************************************)
(* Tells whether the TLC at hand accepts a specification that it cannot    *)
(* handle: Spec has the conjunct [](x < 2), which neither constrains the   *)
(* next-state relation nor is a fairness condition.  A TLC that knows its  *)
(* limits refuses it; one with the defect ignores a part of the formula    *)
(* and reports success.                                                    *)
(***************************************************************************)
EXTENDS Naturals

VARIABLE x

Init == x = 0
Next == x < 3 /\ x' = x + 1
Spec == Init /\ [][Next]_x /\ WF_x(Next) /\ [](x < 2)

StartsSmall == x < 1
=========================================================================

-------------------------------- MODULE Airt --------------------------------
(***************************************************************************)
(* SFC 41 DIS_AIRT and SFC 42 EN_AIRT: the running OB holds back every     *)
(* interrupt and asynchronous error of a higher class; calls nest and are  *)
(* counted (section 4).  Requests says which OBs are held back.            *)
(*                                                                         *)
(* One count is enough: while it is above 0 nothing can interrupt the      *)
(* running OB, and it falls to 0 when that OB ends [AIRT-12].              *)
(* Left out: an upper limit of the count; no source has one [AIRT-14].     *)
(***************************************************************************)
EXTENDS Calls

(* The answers at this count. *)
\* @type: Int => Set(Int);
DisAirtAnswers(count) == {count + 1}

\* @type: Int => Set(Int);
EnAirtAnswers(count) == {IF count = 0 THEN NotDelayed ELSE count - 1}

(* [AIRT-05] All blocks of the OB count together: what a library block     *)
(* turns on and off again leaves the delay of its caller.                  *)
\* @type: Int => Int;
CountAfterEnAirt(count) == IF count > 1 THEN count - 1 ELSE 0

(* [AIRT-03] [AIRT-06] *)
DisAirt ==
    /\ delay' = delay + 1
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                   stack>>

(* [AIRT-03] [AIRT-07] *)
EnAirt ==
    /\ delay' = CountAfterEnAirt(delay)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                   stack>>
=============================================================================

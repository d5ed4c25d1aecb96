------------------------------- MODULE Calls --------------------------------
(***************************************************************************)
(* The common part of all calls of system functions: the caller, the       *)
(* possible answers, the STATUS of SFC 31 and SFC 34 (sections 1.5, 2,     *)
(* 7.4).                                                                   *)
(*                                                                         *)
(* Left out: the general error codes 8x7F and 8x22..8x45 [TINT-22].        *)
(***************************************************************************)
EXTENDS Codes, Cpu, Readings

(* A system function is called by the running OB; in HOLD none runs        *)
(* [OBS-45].                                                               *)
Called == stack # <<>> /\ mode # "HOLD"

(* [AMB-63] Any of several errors in a call may be answered; under (a) the *)
(* first in the order of the operands, which is the order of the codes.    *)
\* @type: Set(Int) => Set(Int);
Usual(errors) ==
    IF errors = {} THEN {OK}
    ELSE IF FirstErrorIsAnswered
    THEN { e \in errors : \A f \in errors : e <= f }
    ELSE errors

(* [AMB-61] A call for a deselected OB. *)
\* @type: (Int, Set(Int)) => Set(Int);
Answers(o, errors) ==
    IF o \notin TodObs \cup DintObs \/ ~Deselected(o) THEN Usual(errors)
    ELSE CASE DeselectedIsRefused  -> {BadOb}
           [] DeselectedIsOrdinary -> Usual(errors)
           [] OTHER                -> Usual(errors) \cup {BadOb}

(* [TINT-72] .. [TINT-79] [DINT-16] STATUS of an OB with these values of   *)
(* its bits. No test function is active [AMB-04]. The clock is base time,  *)
(* bit 6. A delay by SFC 41 does not show [AIRT-13].                       *)
\* @type: (Set(Int), Set(Int), Set(Int), Set(Int)) => Set(Int);
StatusOf(bit0, bit1, bit2, bit4) ==
    { a + b + c + d + (IF Bit5MeansNoTest THEN 32 ELSE 0)
      : a \in bit0, b \in bit1, c \in bit2, d \in bit4 }

(* [TINT-72] By default bit 0 of a deselected OB in RUN is not judged      *)
(* [AMB-03].                                                               *)
\* @type: Int => Set(Int);
StartupBit(o) == IF mode = "STARTUP" THEN {1}
                 ELSE IF ~Deselected(o) THEN {0}
                 ELSE IF Bit0MeansStartup THEN {0, 1} ELSE {1}

(* [TINT-73] *)
\* @type: Int => Set(Int);
BlockedBit(o) == {IF Blocked(o) THEN 2 ELSE 0}

(* [TINT-76] *)
\* @type: Int => Set(Int);
LoadedBit(o) == {IF o \in loaded THEN 16 ELSE 0}

(* bit2: its possible values.                                              *)
\* @type: (Int, Set(Int)) => Set(Int);
StatusWithBit2(o, bit2) ==
    StatusOf(StartupBit(o), BlockedBit(o), bit2, LoadedBit(o))
=============================================================================

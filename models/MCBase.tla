------------------------------- MODULE MCBase -------------------------------
(***************************************************************************)
(* What the TLC models have in common: a small world to choose from, and   *)
(* the words that their configurations put in the place of the large sets  *)
(* of module System.                                                       *)
(*                                                                         *)
(* The clock knows a few minutes around 2026-11-21 06:00 and two moments   *)
(* of each.  Time is absolute here: no view makes it relative, since       *)
(* start points are.                                                       *)
(***************************************************************************)
EXTENDS Properties

(* 2026-11-21 06:00 *)
Six == DayNumber(2026, 11, 21) * MinutesADay + 360

\* @type: (Int, Int) => $moment;
Moment(m, ms) == [min |-> Six + m, ms |-> ms]

(* The whole minutes from a to b, and the half minutes between them. *)
\* @type: (Int, Int) => Set($moment);
HalfMinutes(a, b) == { Moment(m, ms) : m \in a..b, ms \in {0, 30000} }

\* @type: Int => $date;
Date(m) == [ year |-> 2026, month |-> 11, day |-> 21, hour |-> 6,
             minute |-> m, second |-> 20, ms |-> 0 ]

(* It would be December 1, which is ahead. *)
WrongDate == [ Date(0) EXCEPT !.day = 31 ]
Monthly29 == [ Date(0) EXCEPT !.month = 12, !.day = 29 ]

NotConfigured == [ execution |-> "none", start |-> 0, active |-> FALSE,
                   deselected |-> FALSE ]
\* @type: (Str, Int) => $step7;
Activated(execution, m) ==
    [ NotConfigured EXCEPT !.execution = execution, !.start = Six + m,
                           !.active = TRUE ]

(* The runs of points that an OB remembers of earlier settings. *)
ShortMemory == 1
NoMemory == 0

(* One CPU of each kind whose rules differ. *)
TwoFamilies == {"S7-300", "S7-400"}

(* Codes that calls may answer, right or wrong. *)
CallRetVals == {OK, BadOb, BadSdt, BadPeriod, NotSet, PastStart, NotDelayed, 1}
DintRetVals == {OK, BadOb, BadDtime, NotStarted}
IrtRetVals == {OK, BadOb, BadMode}
AirtRetVals == {0, 1, 2, 3, 4, NotDelayed}
TodStatusWords == {-1, 0, 1, 2, 4, 5, 16, 17, 20, 21, 32, 64}
DintStatusWords == {-1, 0, 2, 4, 5, 16, 20, 21, 32}
IrtStatusWords == {-1, 0, 16, 18, 20, 22}

(* Where a model leaves something out. *)
\* @type: Set(Int);
NoObNumbers == {}
\* @type: Set($date);
NoSdts == {}
\* @type: Set(Int);
NoWords == {}
\* @type: Set($moment);
NoClockTargets == {}
\* @type: Set(<<Int, Int>>);
NoInterrupts == {}
\* @type: Set(Int);
NoStatusWords == {}
\* @type: Set(Int);
NoRetVals == {}
\* @type: Set(Int);
NoChangingObs == {}
\* @type: Set(Int);
NoDintObs == {}
\* @type: Set(Int);
NoBlockable == {}
\* @type: Set(Int);
NoDtimes == {}
\* @type: Set(Int);
NoSigns == {}
\* @type: Set(Int);
NoIrtModes == {}
NoHoldPossible == FALSE

(* At most n start events wait, and a few more that are open. *)
\* @type: Int => Bool;
Waiting(n) == /\ Cardinality({ r \in requests : ~r.open }) <= n
              /\ Cardinality(requests) <= n + 1

(* The state without what the last step was and entered. *)
View == cpuVars
=============================================================================

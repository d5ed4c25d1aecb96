----------------------------- MODULE APCalendar -----------------------------
(***************************************************************************)
(* What the proofs by Apalache use of the calendar: APSystem puts any      *)
(* minute that the lemma allows in the place of FirstPoint, and            *)
(* MCCalendarLemma checks by TLC that FirstPoint is such a minute.         *)
(***************************************************************************)
EXTENDS Calendar

(* What the proofs use of q, the first point of a series at or after m. *)
\* @type: (Int, Int, Int, Int) => Bool;
CalendarLemma(start, period, m, q) ==
    /\ q = Never \/ (m <= q /\ start <= q /\ q <= LastMinute)
    /\ period = Once => q = NotBefore(start, m)
    /\ period = Minutely =>
         q = IF m > LastMinute THEN Never ELSE IF m <= start THEN start ELSE m
    /\ period # EndOfMonth /\ m <= start => q = start
=============================================================================

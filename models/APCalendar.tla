----------------------------- MODULE APCalendar -----------------------------
(***************************************************************************)
(* The lemma that the proofs by Apalache use in place of the calendar.     *)
(* APSystem replaces FirstPoint by any minute that the lemma allows.       *)
(* MCCalendarLemma checks by TLC that FirstPoint is such a minute.         *)
(***************************************************************************)
EXTENDS Calendar

(* The lemma: q may be the first point of a series at or after m. *)
\* @type: (Int, Int, Int, Int) => Bool;
CalendarLemma(start, period, m, q) ==
    /\ q = Never \/ (m <= q /\ start <= q /\ q <= LastMinute)
    /\ period = Once => q = NotBefore(start, m)
    /\ period = Minutely =>
         q = IF m > LastMinute THEN Never ELSE IF m <= start THEN start ELSE m
    /\ period # EndOfMonth /\ m <= start => q = start
=============================================================================

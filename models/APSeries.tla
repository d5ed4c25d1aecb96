------------------------------ MODULE APSeries ------------------------------
(***************************************************************************)
(* A proof by Apalache of CalendarLemma's bounds for the series of one     *)
(* step (every minute, hour, day, week), for any start and any minute m.   *)
(* MCCalendarLemma checks the other series, day by day.                    *)
(* s7spec prove series-steps                                               *)
(***************************************************************************)
EXTENDS APCalendar

VARIABLES
    \* @type: Int;
    start,
    \* @type: Int;
    m

AnyInit == start \in Int /\ m \in Int /\ 0 <= start /\ start <= LastMinute

APNext == UNCHANGED <<start, m>>

\* @type: Int => Bool;
FirstOfStep(step) ==
    LET q == FirstStep(start, step, m)
    IN  /\ q = Never \/ (m <= q /\ start <= q /\ q <= LastMinute)
        /\ q # Never => q < (IF m <= start THEN start ELSE m) + step
        /\ q # Never => (q - start) % step = 0
        /\ m <= start => q = start
        /\ step = 1 /\ start < m =>
             q = IF m > LastMinute THEN Never ELSE m

Bounds == /\ FirstOfStep(1)
          /\ FirstOfStep(60)
          /\ FirstOfStep(MinutesADay)
          /\ FirstOfStep(7 * MinutesADay)
=============================================================================

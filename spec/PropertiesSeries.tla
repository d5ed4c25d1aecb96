-------------------------- MODULE PropertiesSeries --------------------------
(***************************************************************************)
(* The series of start points of a time-of-day interrupt, by the calendar: *)
(* which minutes are points; an active interrupt waits for the first point *)
(* that is ahead (section 1.1).                                            *)
(*                                                                         *)
(* Left out: that the closed formulas of Calendar are right for every day, *)
(* which models/MCCalendar checks.                                         *)
(***************************************************************************)
EXTENDS Steps

Minutes(days) == days * 1440

(* [TINT-32] [TINT-33] [TINT-34] [TINT-19] Minute m is a point.            *)
\* @type: ($tod, Int) => Bool;
OnSeries(t, m) ==
    LET since == m - t.start
        day   == m \div 1440
        first == t.start \div 1440
    IN  /\ since >= 0
        /\ t.period \notin {\h0201, \h0401} => since % 1440 = 0 \/ since = 0
        /\ CASE t.period = 0      -> since = 0
             [] t.period = \h0201 -> TRUE
             [] t.period = \h0401 -> since % 60 = 0
             [] t.period = \h1001 -> TRUE
             [] t.period \in {\h1201, \h1202} -> since % Minutes(7) = 0
             [] t.period = \h1401 -> DayOf(day) = DayOf(first)
             [] t.period = \h1801 -> /\ DayOf(day) = DayOf(first)
                                     /\ MonthOf(day) = MonthOf(first)
             [] OTHER             -> DayOf(day + 1) = 1

(* The longest way from one point to the next. *)
\* @type: $tod => Int;
Longest(t) ==
    LET first == t.start \div 1440
    IN  CASE t.period = \h0201 -> 1
          [] t.period = \h0401 -> 60
          [] t.period = \h1001 -> Minutes(1)
          [] t.period \in {\h1201, \h1202} -> Minutes(7)
          [] t.period = \h1801 ->
               IF MonthOf(first) = 2 /\ DayOf(first) = 29
               THEN Minutes(1461) ELSE Minutes(366)
          [] OTHER -> Minutes(31)

(* [TINT-24] Minute p is the first point from minute m on. *)
\* @type: ($tod, Int, Int) => Bool;
IsFirst(t, p, m) ==
    LET from == IF m < t.start THEN t.start ELSE m
    IN  IF p = Never
        THEN /\ from + Longest(t) > LastMinute
             /\ \A q \in from..LastMinute : ~OnSeries(t, q)
        ELSE OnSeries(t, p) /\ p >= from /\ p < from + Longest(t)

(* The first minute that is not before the clock. *)
Ahead == IF clock.ms = 0 THEN clock.min ELSE clock.min + 1

(* [TINT-10] [TINT-24] [TINT-32] [AMB-39] The first point after activation *)
(* is the next one of the series, never a past one.  In an interval that   *)
(* the clock repeats it may be a later one [AMB-57].                       *)
FirstPointProp ==
    [][ Did("ACT_TINT") /\ step'.value = 0 /\ ~tod[step'.ob].active =>
          LET t == tod'[step'.ob]
          IN  IF t.repeatTo < clock.min THEN IsFirst(t, t.next, Ahead)
              ELSE t.next >= Ahead ]_vars

(* [TINT-09] [TINT-10] [CLK-08] An active interrupt waits for the next     *)
(* point of its series.  The point that equals the clock may have been     *)
(* reached.  A once has its start and no other point.  In a time that the  *)
(* clock repeats, points may be left out [CLK-09] [AMB-56] [AMB-57].       *)
NextPointInv ==
    mode \in {"RUN", "STARTUP"} =>
      \A o \in TodObs :
        LET t == tod[o]
        IN  t.active =>
              IF t.period = Once THEN t.next \in {t.start, Never}
              ELSE IF clock.min <= t.repeatTo
              THEN t.next = Never \/ OnSeries(t, t.next)
              ELSE \/ IsFirst(t, t.next, Ahead)
                   \/ IsFirst(t, t.next, clock.min + 1)
=============================================================================

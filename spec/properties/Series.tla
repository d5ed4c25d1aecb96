-------------------------------- MODULE Series ------------------------------
(***************************************************************************)
(* The series of start points of a time-of-day interrupt, said by the      *)
(* calendar: which minutes are points, and which is the first from a       *)
(* minute on (section 1.1). The properties are about these series;         *)
(* models/MCCalendarLemma compares FirstPoint of Calendar with them.       *)
(*                                                                         *)
(* Left out: that the dates of Calendar are right for every day, which     *)
(* models/MCCalendar checks.                                               *)
(***************************************************************************)
EXTENDS Calendar

Minutes(days) == days * 1440

(* [TINT-32] [TINT-33] [TINT-34] [TINT-19] Minute m is a point.            *)
\* @type: (Int, Int, Int) => Bool;
OnSeries(start, period, m) ==
    LET since == m - start
        today == m \div 1440
        first == start \div 1440
    IN  /\ since >= 0
        /\ period \notin {\h0201, \h0401} => since % 1440 = 0 \/ since = 0
        /\ CASE period = 0      -> since = 0
             [] period = \h0201 -> TRUE
             [] period = \h0401 -> since % 60 = 0
             [] period = \h1001 -> TRUE
             [] period \in {\h1201, \h1202} -> since % Minutes(7) = 0
             [] period = \h1401 -> DayOf(today) = DayOf(first)
             [] period = MonthlyOrLast -> \/ DayOf(today) = DayOf(first)
                                          \/ /\ DayOf(today) < DayOf(first)
                                             /\ DayOf(today + 1) = 1
             [] period = NoPeriod -> FALSE
             [] period = \h1801 -> /\ DayOf(today) = DayOf(first)
                                   /\ MonthOf(today) = MonthOf(first)
             [] OTHER           -> DayOf(today + 1) = 1

(* The longest way from one point to the next. STEP 7 may set a monthly    *)
(* interrupt on a day that not every month has [AMB-05].                   *)
\* @type: (Int, Int) => Int;
Longest(start, period) ==
    LET first == start \div 1440
    IN  CASE period = \h0201 -> 1
          [] period = \h0401 -> 60
          [] period = \h1001 -> Minutes(1)
          [] period \in {\h1201, \h1202} -> Minutes(7)
          [] period = \h1401 ->
               IF DayOf(first) > 28 THEN Minutes(61) ELSE Minutes(31)
          [] period = \h1801 ->
               IF MonthOf(first) = 2 /\ DayOf(first) = 29
               THEN Minutes(1461) ELSE Minutes(366)
          [] OTHER -> Minutes(31)

(* [TINT-24] Minute p is the first point from minute m on. *)
\* @type: (Int, Int, Int, Int) => Bool;
IsFirst(start, period, p, m) ==
    LET from == IF m < start THEN start ELSE m
    IN  IF period = NoPeriod THEN p = Never
        ELSE IF p = Never
        THEN /\ from + Longest(start, period) > LastMinute
             /\ \A q \in from..LastMinute : ~OnSeries(start, period, q)
        ELSE /\ OnSeries(start, period, p)
             /\ p >= from /\ p < from + Longest(start, period)
=============================================================================

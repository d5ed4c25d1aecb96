--------------------------- MODULE MCCalendarLemma --------------------------
(***************************************************************************)
(* FirstPoint of Calendar is as CalendarLemma says, and is the first point *)
(* of Series, for each day from 1990-01-01 to 2089-12-31 on which minute m *)
(* lies.                                                                   *)
(*                                                                         *)
(* Minutes and starts by classes.  Of the two times of day FirstPoint asks *)
(* if that of m is past that of the start: one minute m is not, the other  *)
(* is.  Monthly: a start on each day of a month.  End of month asks for no *)
(* day.  Yearly: the first and the last days of a year and of February.    *)
(* All series: a start long ago, in this week, tomorrow, on the last day.  *)
(***************************************************************************)
EXTENDS MCCalendar, APCalendar, Series

(* The time of day of the start, and the minute after it. *)
TimeOfDay == 720
MinutesOfDay == {TimeOfDay, TimeOfDay + 1}

Shortly == {Once, Minutely, Hourly, Daily} \cup Weekly

(* The days on which any series may start ... *)
StartDays == { n \in { 0, day - 8, day - 7, day - 1, day, day + 1,
                       DaysInAll - 1 } : 0 <= n /\ n < DaysInAll }
(* ... the days of the month: January 1990 has them all ... *)
MonthDays == 0..30
(* ... and of a year: 1 January, 28 and 29 February, 1 March, 31 December, *)
(* of the leap year 1992.                                                  *)
YearDays == { DayNumber(1992, 1, 1), DayNumber(1992, 2, 28),
              DayNumber(1992, 2, 29), DayNumber(1992, 3, 1),
              DayNumber(1992, 12, 31) }

(* IsFirst of Series, which looks at each minute up to the end where none  *)
(* is a point: but for the short series, points have the start's time of   *)
(* day, so that one minute a day is enough.                                *)
\* @type: (Int, Int, Int, Int) => Bool;
IsFirstByDays(start, period, p, m) ==
    LET from == IF m < start THEN start ELSE m
    IN  IF p # Never \/ period \in {Minutely, Hourly}
        THEN IsFirst(start, period, p, m)
        ELSE /\ from + Longest(start, period) > LastMinute
             /\ \A n \in (from \div MinutesADay)..(DaysInAll - 1) :
                  LET q == n * MinutesADay + (start % MinutesADay)
                  IN  q < from \/ ~OnSeries(start, period, q)

(* Once is left to CalendarLemma, which is exact for it.                   *)
\* @type: (Int, Int) => Bool;
IsAsTheLemmaSays(startDay, period) ==
    LET start == startDay * MinutesADay + TimeOfDay
    IN  \A minute \in MinutesOfDay :
          LET m     == day * MinutesADay + minute
              first == FirstPoint(start, period, m)
          IN  /\ CalendarLemma(start, period, m, first)
              /\ period = Once \/ IsFirstByDays(start, period, first, m)

ShortLemmaInv ==
    \A n \in StartDays, period \in Shortly : IsAsTheLemmaSays(n, period)
MonthlyLemmaInv ==
    /\ \A n \in MonthDays \cup StartDays : IsAsTheLemmaSays(n, Monthly)
    /\ \A n \in StartDays : IsAsTheLemmaSays(n, EndOfMonth)
YearlyLemmaInv ==
    \A n \in YearDays \cup StartDays : IsAsTheLemmaSays(n, Yearly)

(* Past the last minute there is no point. *)
EndInv ==
    day = DaysInAll - 1 =>
      \A n \in StartDays, period \in PeriodCodes,
         m \in {LastMinute + 1, LastMinute + 2, Never + 1} :
        LET start == n * MinutesADay
        IN  CalendarLemma(start, period, m, FirstPoint(start, period, m))
=============================================================================

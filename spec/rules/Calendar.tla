------------------------------ MODULE Calendar ------------------------------
(***************************************************************************)
(* The calendar that the CPU clock counts: days, months and leap years     *)
(* from 1990-01-01 to 2089-12-31, and the series of start points of a      *)
(* time-of-day interrupt, SDT + k * PERIOD [TINT-32].                      *)
(*                                                                         *)
(* A minute is the number of minutes since 1990-01-01 00:00; start points  *)
(* lie on minutes [TINT-11].  A moment is a minute and the milliseconds in *)
(* it, since TLC's integers have 32 bits.                                  *)
(*                                                                         *)
(* Everything is closed-form. models/MCCalendar compares every day of the  *)
(* range with a clock that can only add a day.                             *)
(* Left out: time zones and daylight saving, which the CPU does not know   *)
(* [CLK-16].                                                               *)
(***************************************************************************)
EXTENDS Integers, Codes

(***************************************************************************)
(* @typeAlias: moment = { min: Int, ms: Int };                             *)
(* @typeAlias: date = { year: Int, month: Int, day: Int, hour: Int,        *)
(*                      minute: Int, second: Int, ms: Int };               *)
(***************************************************************************)

FirstYear   == 1990
LastYear    == 2089
MinutesADay == 1440
DaysInAll   == 36525
LastMinute  == DaysInAll * MinutesADay - 1

(* A minute that never comes. *)
Never == 99999999

-----------------------------------------------------------------------------
(* Days *)

(* Enough for 1990..2089: 2000 is a leap year, and 2100 lies beyond. *)
\* @type: Int => Bool;
LeapYear(y) == y % 4 = 0

\* @type: (Int, Int) => Int;
DaysInMonth(y, m) ==
    IF m = 2 THEN (IF LeapYear(y) THEN 29 ELSE 28)
             ELSE IF m \in {4, 6, 9, 11} THEN 30 ELSE 31

(* Years are counted from a March here, so that a leap day is their last   *)
(* day: four years have 1461 days, five months from March on have 153.     *)
(* Day 0 of this count is March 1, 1988, 671 days before January 1, 1990.  *)
MarchYear == 1988
MarchDays == 671

\* @type: Int => Int;
DaysBeforeMarchOf(y) == ((y - MarchYear) * 1461) \div 4

(* Month 0 is March, month 11 is February. *)
\* @type: Int => Int;
DaysBeforeMonthFromMarch(k) == (k * 153 + 2) \div 5

\* @type: (Int, Int, Int) => Int;
DayNumber(y, m, d) ==
    LET k == (m + 9) % 12
    IN  DaysBeforeMarchOf(IF m < 3 THEN y - 1 ELSE y)
          + DaysBeforeMonthFromMarch(k) + d - 1 - MarchDays

(* The way back from a day number: its year, its day there, its month.     *)
\* @type: Int => Int;
MarchYearOf(n) == MarchYear + ((n + MarchDays) * 4 + 3) \div 1461

\* @type: Int => Int;
DayFromMarch(n) == n + MarchDays - DaysBeforeMarchOf(MarchYearOf(n))

\* @type: Int => Int;
MonthFromMarch(n) == (DayFromMarch(n) * 5 + 2) \div 153

\* @type: Int => Int;
MonthOf(n) == ((MonthFromMarch(n) + 2) % 12) + 1

\* @type: Int => Int;
YearOf(n) == MarchYearOf(n) + (MonthFromMarch(n) \div 10)

\* @type: Int => Int;
DayOf(n) ==
    DayFromMarch(n) - DaysBeforeMonthFromMarch(MonthFromMarch(n)) + 1

-----------------------------------------------------------------------------
(* Dates that a program passes, right or wrong [TINT-39] *)

\* @type: $date => Bool;
ValidMinute(d) ==
    /\ FirstYear <= d.year /\ d.year <= LastYear
    /\ 1 <= d.month /\ d.month <= 12
    /\ 1 <= d.day /\ d.day <= DaysInMonth(d.year, d.month)
    /\ 0 <= d.hour /\ d.hour < 24
    /\ 0 <= d.minute /\ d.minute < 60

(* [AMB-79] Seconds and milliseconds that no date has. *)
\* @type: $date => Bool;
OddSeconds(d) == d.second \notin 0..59 \/ d.ms \notin 0..999

(* [TINT-11] Seconds and milliseconds are dropped. *)
\* @type: $date => Int;
MinuteOf(d) ==
    DayNumber(d.year, d.month, d.day) * MinutesADay + d.hour * 60 + d.minute

-----------------------------------------------------------------------------
(* Moments *)

\* @type: Int => $moment;
At(m) == [min |-> m, ms |-> 0]

\* @type: ($moment, $moment) => Bool;
Before(a, b) == a.min < b.min \/ (a.min = b.min /\ a.ms < b.ms)

(* t + (b - a) *)
\* @type: ($moment, $moment, $moment) => $moment;
Shifted(t, a, b) ==
    LET ms == t.ms + b.ms - a.ms + 60000
    IN  [ min |-> t.min + b.min - a.min + (ms \div 60000) - 1,
          ms  |-> ms % 60000 ]

\* @type: ($moment, Int) => $moment;
After(t, ms) == [ min |-> t.min + ((t.ms + ms) \div 60000),
                  ms  |-> (t.ms + ms) % 60000 ]

Aeon == 1000000000

(* ms from a to b, at most an aeon (11 days): TLC's integers have 32 bits. *)
\* @type: ($moment, $moment) => Int;
Span(a, b) == IF b.min - a.min > 16000 THEN Aeon
              ELSE (b.min - a.min) * 60000 + b.ms - a.ms

-----------------------------------------------------------------------------
(* The series of start points *)

\* @type: (Int, Int) => Int;
Earlier(a, b) == IF a <= b THEN a ELSE b

\* @type: (Int, Int) => Int;
NotBefore(p, m) == IF p >= m THEN p ELSE Never

(* First point at or after minute m of start, start + step, ... *)
\* @type: (Int, Int, Int) => Int;
FirstStep(start, step, m) ==
    IF m <= start THEN start
    ELSE LET p == start + ((m - start + step - 1) \div step) * step
         IN  IF p > LastMinute THEN Never ELSE p

OfYears  == {Yearly, YearlyOrDayBefore, YearlyOrDayAfter}
OfMonths == {Monthly, MonthlyOrLast, EndOfMonth} \cup OfYears

(* Months are counted from January 1990 on. *)
\* @type: Int => Int;
YearOfMonth(i) == FirstYear + (i \div 12)

\* @type: Int => Int;
DaysOfMonth(i) == DaysInMonth(YearOfMonth(i), (i % 12) + 1)

(* Minute t of day d of month i. The day after its last is the first day   *)
(* of the next month.                                                      *)
\* @type: (Int, Int, Int) => Int;
PointInMonth(i, d, t) ==
    IF YearOfMonth(i) > LastYear THEN Never
    ELSE DayNumber(YearOfMonth(i), (i % 12) + 1, d) * MinutesADay + t

(* [TINT-18] [AMB-05] [AMB-38] The point of month i for a start on day d   *)
(* at minute t. A month without day d has its point on its last day, or on *)
(* the day after it, or has none. Then the next month that has the day     *)
(* gives the point: of a yearly series a February of a leap year, else the *)
(* month after i, since no two months in a row lack a day.                 *)
\* @type: (Int, Int, Int, Int) => Int;
PointOfMonth(period, i, d, t) ==
    LET last == DaysOfMonth(i)
    IN  IF d <= last \/ period = YearlyOrDayAfter THEN PointInMonth(i, d, t)
        ELSE IF period \in {EndOfMonth, MonthlyOrLast, YearlyOrDayBefore}
        THEN PointInMonth(i, last, t)
        ELSE PointInMonth(
               i + (IF period = Yearly THEN 12 * (4 - (YearOfMonth(i) % 4))
                    ELSE 1), d, t)

(* The first point at or after minute m: in its month or year, or in the   *)
(* next one.                                                               *)
\* @type: (Int, Int, Int) => Int;
FirstInMonths(start, period, m) ==
    LET begun == start \div MinutesADay
        today == m \div MinutesADay
        width == IF period \in OfYears THEN 12 ELSE 1
        here  == (YearOf(today) - FirstYear) * 12
                   + MonthOf(IF width = 12 THEN begun ELSE today) - 1
        \* @type: Int => Int;
        point(i) ==
            PointOfMonth(period, i,
                         IF period = EndOfMonth THEN 31 ELSE DayOf(begun),
                         start % MinutesADay)
    IN  IF point(here) >= m THEN point(here) ELSE point(here + width)

(* [TINT-32] [TINT-33] [TINT-19] The first start point at or after minute  *)
(* m of an interrupt with this start and PERIOD; Never if there is none.   *)
(* End of month: only the time of day of the start counts [AMB-39].        *)
\* @type: (Int, Int, Int) => Int;
FirstPoint(start, period, m) ==
    IF m > LastMinute THEN Never
    ELSE CASE period = Once        -> NotBefore(start, m)
           [] period = Minutely    -> FirstStep(start, 1, m)
           [] period = Hourly      -> FirstStep(start, 60, m)
           [] period = Daily       -> FirstStep(start, MinutesADay, m)
           [] period \in Weekly    -> FirstStep(start, 7 * MinutesADay, m)
           [] period \in OfMonths  ->
                FirstInMonths(start, period, IF m <= start THEN start ELSE m)
           [] OTHER                -> Never
=============================================================================

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

\* @type: Int => Bool;
LeapYear(y) == (y % 4 = 0 /\ y % 100 # 0) \/ y % 400 = 0

\* @type: (Int, Int) => Int;
DaysInMonth(y, m) ==
    IF m = 2 THEN (IF LeapYear(y) THEN 29 ELSE 28)
             ELSE IF m \in {4, 6, 9, 11} THEN 30 ELSE 31

(* Leap days of the years 1 .. y. *)
\* @type: Int => Int;
LeapDays(y) == (y \div 4) - (y \div 100) + (y \div 400)

\* @type: Int => Int;
DaysBeforeYear(y) ==
    (y - FirstYear) * 365 + LeapDays(y - 1) - LeapDays(FirstYear - 1)

\* @type: Seq(Int);
DaysBeforeMonthTable ==
    <<0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334>>

\* @type: (Int, Int) => Int;
DaysBeforeMonth(y, m) ==
    DaysBeforeMonthTable[m] + (IF m > 2 /\ LeapYear(y) THEN 1 ELSE 0)

\* @type: (Int, Int, Int) => Int;
DayNumber(y, m, d) == DaysBeforeYear(y) + DaysBeforeMonth(y, m) + d - 1

(* The year, month and day of the month of a day number.  The first guess  *)
(* is right or one too small: a year has at most 366 days, a month 31.     *)
\* @type: Int => Int;
YearOf(n) ==
    LET guess == FirstYear + (n \div 366)
    IN  IF DaysBeforeYear(guess + 1) <= n THEN guess + 1 ELSE guess

\* @type: Int => Int;
MonthOf(n) ==
    LET y     == YearOf(n)
        rest  == n - DaysBeforeYear(y)
        guess == (rest \div 31) + 1
    IN  IF guess < 12 /\ DaysBeforeMonth(y, guess + 1) <= rest
        THEN guess + 1 ELSE guess

\* @type: Int => Int;
DayOf(n) ==
    n - DaysBeforeYear(YearOf(n)) - DaysBeforeMonth(YearOf(n), MonthOf(n)) + 1

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

(* Months since January 1990, and the first day of such a month. *)
\* @type: Int => Int;
MonthIndex(n) == (YearOf(n) - FirstYear) * 12 + MonthOf(n) - 1

\* @type: Int => Int;
YearOfIndex(i) == FirstYear + (i \div 12)

\* @type: Int => Int;
MonthOfIndex(i) == (i % 12) + 1

\* @type: (Int, Int) => Int;
Earlier(a, b) == IF a <= b THEN a ELSE b

(* The point of month i for a start on day d of the month at minute t of   *)
(* the day; Never where the month has no such day.  Day -d is day d or, in *)
(* shorter months, the last day.                                           *)
\* @type: (Int, Int, Int) => Int;
PointInMonth(i, d, t) ==
    LET y == YearOfIndex(i)
        m == MonthOfIndex(i)
        k == IF d > 0 THEN d ELSE Earlier(-d, DaysInMonth(y, m))
    IN  IF y > LastYear \/ k > DaysInMonth(y, m) THEN Never
        ELSE DayNumber(y, m, k) * MinutesADay + t

(* The point of year y; Never where the year has no such day.              *)
\* @type: (Int, Int, Int, Int) => Int;
PointInYear(y, m, d, t) ==
    IF y > LastYear \/ d > DaysInMonth(y, m) THEN Never
    ELSE DayNumber(y, m, d) * MinutesADay + t

(* [AMB-38] (c) Here day 29 of a common February is March 1, day -29 is    *)
(* February 28.                                                            *)
\* @type: (Int, Int, Int, Int) => Int;
PointInAnyYear(y, m, d, t) ==
    IF y > LastYear THEN Never
    ELSE LET k == IF d < 0 THEN Earlier(-d, DaysInMonth(y, m)) ELSE d
         IN  DayNumber(y, m, k) * MinutesADay + t

\* @type: (Int, Int) => Int;
NotBefore(p, m) == IF p >= m THEN p ELSE Never

(* First point at or after minute m of start, start + step, ... *)
\* @type: (Int, Int, Int) => Int;
FirstStep(start, step, m) ==
    IF m <= start THEN start
    ELSE LET p == start + ((m - start + step - 1) \div step) * step
         IN  IF p > LastMinute THEN Never ELSE p

(* At most two months in a row lack a day, so three candidates are enough. *)
\* @type: (Int, Int, Int) => Int;
FirstMonthly(d, t, m) ==
    LET i == MonthIndex(m \div MinutesADay)
    IN  Earlier(NotBefore(PointInMonth(i, d, t), m),
          Earlier(PointInMonth(i + 1, d, t), PointInMonth(i + 2, d, t)))

(* [AMB-38] February 29th: leap years only.  In 1990..2089 every fourth    *)
(* year is a leap year: five candidates.                                   *)
\* @type: (Int, Int, Int, Int) => Int;
FirstYearly(mo, d, t, m) ==
    LET y == YearOf(m \div MinutesADay)
    IN  Earlier(NotBefore(PointInYear(y, mo, d, t), m),
          Earlier(PointInYear(y + 1, mo, d, t),
            Earlier(PointInYear(y + 2, mo, d, t),
              Earlier(PointInYear(y + 3, mo, d, t),
                      PointInYear(y + 4, mo, d, t)))))

\* @type: (Int, Int, Int, Int) => Int;
FirstInAnyYear(mo, d, t, m) ==
    LET y == YearOf(m \div MinutesADay)
    IN  Earlier(NotBefore(PointInAnyYear(y, mo, d, t), m),
                PointInAnyYear(y + 1, mo, d, t))

(* [TINT-32] [TINT-33] [TINT-19] The first start point at or after minute  *)
(* m of an interrupt with this start and PERIOD; Never if there is none.   *)
(* End of month: only the time of day of the start counts [AMB-39].        *)
\* @type: (Int, Int, Int) => Int;
FirstPoint(start, period, m) ==
    LET from == IF m <= start THEN start ELSE m
        day  == start \div MinutesADay
        time == start % MinutesADay
    IN  IF m > LastMinute THEN Never
        ELSE CASE period = Once       -> NotBefore(start, m)
               [] period = Minutely   -> FirstStep(start, 1, m)
               [] period = Hourly     -> FirstStep(start, 60, m)
               [] period = Daily      -> FirstStep(start, MinutesADay, m)
               [] period \in Weekly   -> FirstStep(start, 7 * MinutesADay, m)
               [] period = Monthly    -> FirstMonthly(DayOf(day), time, from)
               [] period = Yearly     ->
                    FirstYearly(MonthOf(day), DayOf(day), time, from)
               [] period = YearlyOrDayBefore ->
                    FirstInAnyYear(MonthOf(day), -DayOf(day), time, from)
               [] period = YearlyOrDayAfter ->
                    FirstInAnyYear(MonthOf(day), DayOf(day), time, from)
               [] period = EndOfMonth -> FirstMonthly(-31, time, from)
               [] period = MonthlyOrLast ->
                    FirstMonthly(-DayOf(day), time, from)
               [] OTHER               -> Never
=============================================================================

----------------------------- MODULE MCCalendar -----------------------------
(***************************************************************************)
(* The calendar, for every day from 1990-01-01 to 2089-12-31: a clock that *)
(* can only add a day (and knows the lengths of the months) walks through  *)
(* the range; on every day the closed formulas of module Calendar must say *)
(* the same, and the first point of every series must be today's, where    *)
(* today has one, else tomorrow's first point [TINT-32] [TINT-33].         *)
(***************************************************************************)
EXTENDS Calendar

VARIABLES
    \* @type: Int;
    day,
    \* @type: $date;
    date

Midnight(y, m, d) == [ year |-> y, month |-> m, day |-> d, hour |-> 0,
                       minute |-> 0, second |-> 0, ms |-> 0 ]

Lengths == <<31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31>>

(* From 1990 to 2089 every fourth year is a leap year, 2000 included. *)
LastDay(y, m) == IF m = 2 /\ y % 4 = 0 THEN 29 ELSE Lengths[m]

Tomorrow(d) ==
    IF d.day < LastDay(d.year, d.month) THEN [d EXCEPT !.day = @ + 1]
    ELSE IF d.month < 12 THEN Midnight(d.year, d.month + 1, 1)
    ELSE Midnight(d.year + 1, 1, 1)

Init == day = 0 /\ date = Midnight(1990, 1, 1)
Next == day < DaysInAll - 1 /\ day' = day + 1 /\ date' = Tomorrow(date)
Spec == Init /\ [][Next]_<<day, date>>

-----------------------------------------------------------------------------

DaysInv ==
    /\ DayNumber(date.year, date.month, date.day) = day
    /\ YearOf(day) = date.year
    /\ MonthOf(day) = date.month
    /\ DayOf(day) = date.day
    /\ ValidMinute(date)
    /\ MinuteOf([date EXCEPT !.hour = 13, !.minute = 59]) = day * 1440 + 839

(* The day after the last of a month does not exist. *)
NoSuchDateInv ==
    /\ ValidMinute([date EXCEPT !.day = @ + 1])
         <=> date.day < LastDay(date.year, date.month)
    /\ ~ValidMinute([date EXCEPT !.hour = 24])
    /\ ~ValidMinute([date EXCEPT !.minute = 60])
    /\ OddSeconds([date EXCEPT !.second = 60])
    /\ ~ValidMinute([date EXCEPT !.month = 13])
    /\ ~ValidMinute([date EXCEPT !.day = 0])
    /\ date.month = 1 /\ date.day = 1 =>
         ~ValidMinute([ date EXCEPT
                          !.year = IF date.year = 1990 THEN 1989 ELSE 2090 ])

(* Starts: day number, date, minute of the day. *)
Starts == { <<0, Midnight(1990, 1, 1), 0>>,
            <<789, Midnight(1992, 2, 29), 1439>>,
            <<3682, Midnight(2000, 1, 31), 390>>,
            <<13482, Midnight(2026, 11, 30), 720>> }

Periods == {Once, Daily, \h1201, \h1202, Monthly, Yearly, EndOfMonth}

IsPointDay(s, period) ==
    LET first == s[2]
    IN  /\ day >= s[1]
        /\ CASE period = Once   -> day = s[1]
             [] period = Daily  -> TRUE
             [] period \in {\h1201, \h1202} -> (day - s[1]) % 7 = 0
             [] period = Monthly -> date.day = first.day
             [] period = Yearly  ->
                  date.day = first.day /\ date.month = first.month
             [] OTHER -> date.day = LastDay(date.year, date.month)

StartsInv == \A s \in Starts :
    day = s[1] => date = s[2]

SeriesInv ==
    \A s \in Starts, period \in Periods :
      LET start == s[1] * 1440 + s[3]
          today == day * 1440
          first == FirstPoint(start, period, today)
          next  == IF day = DaysInAll - 1 THEN Never
                   ELSE FirstPoint(start, period, today + 1440)
      IN  IF IsPointDay(s, period)
          THEN /\ first = today + s[3]
               /\ FirstPoint(start, period, first) = first
               /\ FirstPoint(start, period, first + 1) = next
          ELSE first = next

(* Hourly and every minute, from two minutes of the day on. *)
ShortSeriesInv ==
    \A s \in Starts :
      LET start == s[1] * 1440 + s[3]
          m     == day * 1440 + 100
          hour  == FirstPoint(start, Hourly, m)
      IN  IF m <= start
          THEN hour = start /\ FirstPoint(start, Minutely, m) = start
          ELSE /\ hour >= m /\ hour < m + 60 /\ hour % 60 = start % 60
               /\ FirstPoint(start, Minutely, m) = m
=============================================================================

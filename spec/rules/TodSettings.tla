----------------------------- MODULE TodSettings ----------------------------
(***************************************************************************)
(* The setting of a time-of-day interrupt, apart from the calls that make  *)
(* it: its start, its PERIOD and the series of its points (section 1.1).   *)
(* Calendar has the series itself, ServedPoints the next point.            *)
(*                                                                         *)
(* Left out: a CPU whose reference is local time.                          *)
(***************************************************************************)
EXTENDS Calendar, Cpu

NoSetting == [ set |-> FALSE, active |-> FALSE, start |-> 0, offset |-> 0,
               period |-> Once, next |-> Never, served |-> {}, earlier |-> {},
               repeatTo |-> -1, overTo |-> -1, called |-> FALSE ]

(* The next point. *)
\* @type: $tod => $moment;
NextMoment(t) == [min |-> t.next, ms |-> t.offset]

-----------------------------------------------------------------------------
(* The series of points *)

(* [AMB-37] A moment that equals the clock is not past; under (b) it is. *)
\* @type: ($moment, $moment) => Bool;
IsPast(point, now) ==
    Before(point, now) \/ (point = now /\ EqualIsPast)

(* The first minute with a point that is not past at moment m. *)
\* @type: ($tod, $moment) => Int;
FirstMinute(t, m) == IF IsPast([min |-> m.min, ms |-> t.offset], m)
                     THEN m.min + 1 ELSE m.min

(* [AMB-05] [AMB-38] [AMB-43] The series that belongs to a PERIOD. *)
\* @type: Int => Int;
SeriesOf(period) ==
    CASE period = Monthly /\ MonthlyFallsOnLastDay -> MonthlyOrLast
      [] period = Yearly /\ YearlyFallsOnDayBefore -> YearlyOrDayBefore
      [] period = Yearly /\ YearlyFallsOnDayAfter  -> YearlyOrDayAfter
      [] period = Hourly /\ Period0401IsDaily      -> Daily
      [] OTHER                                     -> period

(* [TINT-08] [AMB-32] A PERIOD with one point. *)
\* @type: Int => Bool;
HasOnePoint(period) == \/ period = Once
                       \/ period = EndOfMonth /\ EndOfMonthIsOnce

(* The first point of the series at or after minute m.  It may be one      *)
(* period after the start [AMB-36]; the start of an end-of-month interrupt *)
(* may be a point as well [AMB-39].                                        *)
\* @type: ($tod, Int) => Int;
InSeries(t, m) ==
    IF m > t.start THEN FirstPoint(t.start, SeriesOf(t.period), m)
    ELSE IF t.period = EndOfMonth /\ EndOfMonthRunsAtStart THEN t.start
    ELSE IF ~HasOnePoint(t.period) /\ SeriesBeginsAPeriodLater
    THEN FirstPoint(t.start, SeriesOf(t.period), t.start + 1)
    ELSE FirstPoint(t.start, SeriesOf(t.period), m)

\* @type: ($tod, Int) => Int;
PointFrom(t, m) ==
    IF t.period = EndOfMonth /\ EndOfMonthIsOnce
    THEN NotBefore(InSeries(t, t.start), m) ELSE InSeries(t, m)

(* The first start point of a setting with one point. *)
\* @type: $tod => $moment;
FirstMoment(t) ==
    [ min |-> IF t.period = Once THEN t.start ELSE PointFrom(t, t.start),
      ms  |-> t.offset ]
=============================================================================

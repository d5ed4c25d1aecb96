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

(* The first start point, and the point that is watched for. *)
\* @type: $tod => $moment;
FirstMoment(t) == [min |-> t.start, ms |-> t.offset]
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

(* [AMB-05] [AMB-43] The series that belongs to a PERIOD. *)
\* @type: Int => Int;
SeriesOf(period) ==
    IF period = Monthly /\ MonthlyFallsOnLastDay THEN MonthlyOrLast
    ELSE IF period = Hourly /\ Period0401IsDaily THEN Daily
    ELSE period

(* The first point of the series at or after minute m.  It may be one      *)
(* period after the start [AMB-36]; the start of an end-of-month interrupt *)
(* may be a point as well [AMB-39].                                        *)
\* @type: ($tod, Int) => Int;
PointFrom(t, m) ==
    IF m > t.start THEN FirstPoint(t.start, SeriesOf(t.period), m)
    ELSE IF t.period = EndOfMonth /\ EndOfMonthRunsAtStart THEN t.start
    ELSE IF t.period # Once /\ SeriesBeginsAPeriodLater
    THEN FirstPoint(t.start, SeriesOf(t.period), t.start + 1)
    ELSE FirstPoint(t.start, SeriesOf(t.period), m)
=============================================================================

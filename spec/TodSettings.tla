----------------------------- MODULE TodSettings ----------------------------
(***************************************************************************)
(* The setting of a time-of-day interrupt, apart from the calls that make  *)
(* it: its start, its PERIOD and the start point that is watched for       *)
(* (section 1.1).  Calendar has the series of points itself.               *)
(*                                                                         *)
(* Left out: a CPU whose reference is local time.                          *)
(***************************************************************************)
EXTENDS Calendar, Cpu

NoSetting == [ set |-> FALSE, active |-> FALSE, start |-> 0, offset |-> 0,
               period |-> Once, next |-> Never, served |-> {}, repeatTo |-> -1 ]

(* The first start point, and the point that is watched for. *)
\* @type: $tod => $moment;
FirstMoment(t) == [min |-> t.start, ms |-> t.offset]
\* @type: $tod => $moment;
NextMoment(t) == [min |-> t.next, ms |-> t.offset]

(* [AMB-57] In a time that the clock repeats, the OB may keep the memory of *)
(* the points that were served; elsewhere the memory has no meaning.       *)
\* @type: ($tod, $tod) => $tod;
WithMemory(new, old) ==
    IF MemoryOutlivesSetting /\ clock.min <= old.repeatTo
    THEN [new EXCEPT !.served = old.served, !.repeatTo = old.repeatTo]
    ELSE new

\* @type: $tod => $tod;
Forgotten(t) == [t EXCEPT !.served = {}, !.repeatTo = -1]

\* @type: $tod => $tod;
Unset(t) == WithMemory(NoSetting, t)

(* [AMB-08] A once interrupt that has been called is no longer set. *)
\* @type: $tod => $tod;
UsedUp(t) == IF OnceIsUnsetByItsRun THEN Unset(t)
             ELSE [t EXCEPT !.active = FALSE, !.next = Never]

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

(* The first point of the series at or after minute m.  It may be one       *)
(* period after the start [AMB-36]; the start of an end-of-month interrupt *)
(* may be a point as well [AMB-39].                                        *)
\* @type: ($tod, Int) => Int;
PointFrom(t, m) ==
    IF m > t.start THEN FirstPoint(t.start, SeriesOf(t.period), m)
    ELSE IF t.period = EndOfMonth /\ EndOfMonthRunsAtStart THEN t.start
    ELSE IF t.period # Once /\ SeriesBeginsAPeriodLater
    THEN FirstPoint(t.start, SeriesOf(t.period), t.start + 1)
    ELSE FirstPoint(t.start, SeriesOf(t.period), m)

-----------------------------------------------------------------------------
(* The next point *)

\* @type: ($tod, Int) => Bool;
WasServed(t, p) == \E i \in t.served : i.from <= p /\ p <= i.to

(* The first point from p on that was not served: p, or the first one after *)
(* a run of points that were.                                              *)
\* @type: ($tod, Int) => Int;
FirstUnserved(t, p) ==
    LET points == {p} \cup { PointFrom(t, i.to + 1)
                             : i \in { j \in t.served : j.to >= p } }
        free   == { q \in points : ~WasServed(t, q) }
    IN  CHOOSE q \in free : \A r \in free : q <= r

(* The first point at or after moment m that is served.  In a time that the *)
(* clock repeats, points that were served are not served again [CLK-09];   *)
(* the others may all be `over' [AMB-56].                                  *)
\* @type: ($tod, $moment, Bool) => Int;
NextPoint(t, m, over) ==
    LET p == PointFrom(t, FirstMinute(t, m))
    IN  IF p > t.repeatTo THEN p
        ELSE IF over THEN PointFrom(t, t.repeatTo + 1)
        ELSE FirstUnserved(t, p)

\* @type: ($tod, $moment) => $tod;
Armed(t, m) == [t EXCEPT !.next = NextPoint(t, m, UnservedAreOver(cpu))]
=============================================================================

------------------------------ MODULE APSample ------------------------------
(***************************************************************************)
(* The first point after an activation is that of the series, for Apalache *)
(* [TINT-10] [TINT-24]. The sample stands for the first point of a series: *)
(* FirstPoint and NextPoint give it where they are asked for it, and any   *)
(* point that the lemma allows elsewhere; IsFirst of Series says that a    *)
(* minute is it. models/MCCalendarLemma checks that FirstPoint of Calendar *)
(* gives the first point in the sense of Series.                           *)
(*                                                                         *)
(* Left out: times that the clock repeats, of which FirstPointProp says    *)
(* nothing but that the point is ahead.                                    *)
(***************************************************************************)
EXTENDS APPoint, APSystem

SampleConstants ==
    /\ AnyConstants
    /\ Sample = Gen(1)
    /\ CalendarLemma(Sample.start, Sample.period, Sample.from, Sample.point)

(* In place of IsFirst. A one-shot interrupt has its start: that says more *)
(* than IsFirst.                                                           *)
\* @type: (Int, Int, Int, Int) => Bool;
IsSampledFirst(start, period, p, m) ==
    IF period = Once THEN p = start /\ p >= m
    ELSE IsSample(start, period, m) => p = Sample.point

(* In place of NextPoint. *)
\* @type: ($tod, $moment, $cpu) => Int;
SampledNextPoint(t, m, c) ==
    LET from == FirstMinute(t, m)
    IN  IF from > t.repeatTo /\ IsSample(t.start, t.period, from)
        THEN Sample.point ELSE AnyNextPoint(t, m, c)

(* In place of FirstPoint. *)
\* @type: (Int, Int, Int) => Int;
SampledFirstPoint(start, period, m) ==
    IF IsSample(start, period, m) THEN Sample.point
                                  ELSE AnyFirstPoint(start, period, m)

(* sampled-point: by FirstPoint, NextPoint itself gives the sample. *)
SampledPointFollows ==
    LET t    == tod[10]
        from == FirstMinute(t, clock)
    IN  from > t.repeatTo /\ IsSample(t.start, t.period, from) =>
          NextPoint(t, clock, cpu) = Sample.point
=============================================================================

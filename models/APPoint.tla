------------------------------- MODULE APPoint ------------------------------
(***************************************************************************)
(* A sample of the first points of series: of one start, PERIOD and minute *)
(* m, any of each, the first point from m on. What holds for every sample  *)
(* holds for the calendar, whose first points are a function of the three. *)
(***************************************************************************)
EXTENDS Integers

CONSTANTS
    \* @type: {start: Int, period: Int, from: Int, point: Int};
    Sample

\* @type: (Int, Int, Int) => Bool;
IsSample(start, period, m) ==
    start = Sample.start /\ period = Sample.period /\ m = Sample.from
=============================================================================

------------------------------ MODULE StartInfo -------------------------------
(***************************************************************************)
(* The start information of an OB, as far as table 8.2 determines it: does *)
(* what a log says of a start fit the request that led to it?              *)
(*                                                                         *)
(* Left out: what the table leaves open is not judged.                     *)
(***************************************************************************)
EXTENDS LogEvents

(* Start information, table 8.2; what the table leaves open is not judged *)

\* @type: Int => Int;
EventOf(o) == CASE o \in 10..17 -> \h1111 + o - 10
                [] o \in 20..23 -> \h1121 + o - 20
                [] o \in 30..38 -> \h1131 + o - 30
                [] o \in 40..43 -> \h1141 + o - 40
                [] OTHER        -> -1

\* @type: (Int, Int) => Bool;
Fits(given, value) == given = -1 \/ value = -1 \/ given = value

(* [CLK-06] Bit k stands for OB 10 + k. *)
\* @type: Set(Int) => Int;
LateMask(obs) ==
    LET b(o, v) == IF o \in obs THEN v ELSE 0
    IN  b(10, 1) + b(11, 2) + b(12, 4) + b(13, 8) + b(14, 16) + b(15, 32)
          + b(16, 64) + b(17, 128)

\* @type: (Int, Int) => Bool;
FitsPeriod(given, period) ==
    \/ Fits(given, period)
    \/ Reading("AMB-01") = "c" /\ given \in Weekly /\ period \in Weekly

(* [CLK-07] [AMB-16] A time-of-day interrupt: its start point or later;     *)
(* after a skip the first point skipped.  OB 80 after a skip: the new time. *)
\* @type: ($request, $moment) => Bool;
FitsTime(r, time) ==
    LET exact == IF r.ob \in TodObs THEN r.follows \in Skips
                                    ELSE r.fault \in Skips /\ r.late # {}
    IN  \/ time = NoMoment
        \/ time = r.since
        \/ ~exact /\ ~Before(time, r.since) /\ ~Before(clock, time)

\* @type: ($request, $info) => Bool;
FitsRequest(r, i) ==
    /\ Fits(i.priority, r.class)
    /\ IF r.ob \in {TimeErrorOb, ProgramErrorOb}
       THEN \A f \in {i.flt_id, i.strt_info} :
              \/ Fits(f, r.fault)
              \/ r.fault \in ObNotLoaded /\ f \in ObNotLoaded  \* AMB-28
       ELSE EventOf(r.ob) = -1 \/ Fits(i.strt_info, EventOf(r.ob) % 256)
    /\ r.ob \in TodObs => FitsPeriod(i.period, r.word)
    /\ IF r.fault \in Skips /\ r.late # {}
       THEN Fits(i.error_info, LateMask(r.late))
       ELSE r.cause \in TodObs => FitsPeriod(i.error_info, r.word)
    /\ r.cause # 0 => Fits(i.ev, EventOf(r.cause))
    /\ CASE r.cause = 0            -> TRUE
         [] r.ob = ProgramErrorOb  -> Fits(i.ev_ob, r.during)
         [] OTHER                  -> Fits(i.ev_ob, r.cause)
    /\ FitsTime(r, i.time)
=============================================================================

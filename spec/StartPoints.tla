----------------------------- MODULE StartPoints ------------------------------
(***************************************************************************)
(* A start point of a time-of-day interrupt is reached: what follows where *)
(* the OB does not run, waits or runs (catalogue section 1.1), and which   *)
(* points were served, for a clock that is set back [CLK-09].              *)
(*                                                                         *)
(* Left out: how many requests a buffer holds [OBS-09]; see module Requests. *)
(***************************************************************************)
EXTENDS TimeOfDay

(* [CLK-10] [CLK-11] On an S7-300 points are served again after the clock   *)
(* was set back; other CPUs remember which were served [AMB-17].           *)
Remembers == cpu.family # "S7-300" \/ Reading("AMB-17") = "b"

(* [CLK-09] *)
\* @type: ($tod, Int) => $tod;
Served(t, p) ==
    IF ~Remembers \/ p < t.servedFrom THEN t
    ELSE [ t EXCEPT !.servedFrom = IF t.servedTo < 0 THEN p ELSE @,
                    !.servedTo   = IF p > @ THEN p ELSE @,
                    !.gapFrom    = IF @ <= p /\ p <= t.gapTo THEN p + 1 ELSE @ ]

(* Of the points from p until next the OB is called for the first alone.    *)
(* Of several gaps their hull is kept.                                     *)
\* @type: ($tod, Int, Int) => $tod;
ServedOnce(t, p, next) ==
    IF ~Remembers \/ p < t.servedFrom THEN t
    ELSE [ Served(t, p) EXCEPT !.gapFrom = IF t.gapTo < 0 THEN p + 1 ELSE @,
                               !.gapTo   = next - 1 ]

(* The point p of OB o leads to a start event ... *)
\* @type: (Int, Int) => Bool;
Ordinary(o, p) ==
    /\ requests' = Enter(requests, TodRequest(o, At(p), 0))
    /\ UNCHANGED stopCause

(* ... to a time error [TINT-14], with a run that follows it or without ... *)
\* @type: (Int, Int, Int, Bool) => Bool;
Overlap(o, p, fault, again) ==
    LET error == [ TimeError(fault, {o}, o, tod[o].period) EXCEPT
                     !.since = At(p) ]
        runs  == IF again
                 THEN Enter(requests, TodRequest(o, At(p), StillRunning))
                 ELSE requests
    IN  /\ requests'  = WithTimeError(runs, error)
        /\ stopCause' = StopOfTimeError

(* ... or to nothing. *)
Nothing == UNCHANGED <<requests, stopCause>>

(* [AMB-18] The OB waits already.  The size of the buffer is not known, so  *)
(* under (b) the run is kept or the buffer overflows [OBS-08].             *)
\* @type: (Int, Int) => Bool;
AgainWhilePending(o, p) ==
    CASE Reading("AMB-18") = "a" -> Overlap(o, p, StillRunning, FALSE)
      [] Reading("AMB-18") = "b" -> \/ Ordinary(o, p)
                                    \/ Overlap(o, p, BufferOverflow, FALSE)
      [] Reading("AMB-18") = "c" -> Nothing
      [] OTHER ->
           /\ requests' = EnterAll(requests,
                            LeftOpen(TodRequest(o, At(p), 0), tod[o].period))
           /\ UNCHANGED stopCause

\* @type: (Int, Int) => Bool;
AgainWhileOpen(o, p) ==
    /\ requests' \in EnterAmongOpen(TodRequest(o, At(p), 0), tod[o].period)
    /\ UNCHANGED stopCause

(* [TINT-09] [TINT-14] [TINT-19] [AMB-35] *)
\* @type: Int => Bool;
PointReached(o) ==
    LET p == tod[o].next
    IN  /\ Watching
        /\ clock = At(p)  \* no point is watched unless it is active
        /\ tod' = [tod EXCEPT ![o] =
                      Armed(Served(@, p), [min |-> p, ms |-> 1])]
        /\ IF Deselected(o) THEN Nothing
           ELSE IF mode = "STARTUP" /\ PendingIn(requests, o) THEN Nothing
           ELSE IF OnStack(o)
           THEN Overlap(o, p, StillRunning, ~PendingIn(requests, o))
           ELSE IF PendingIn(requests, o) THEN AgainWhilePending(o, p)
           ELSE IF OpenIn(requests, o) THEN AgainWhileOpen(o, p)
           ELSE Ordinary(o, p)
        /\ UNCHANGED <<cpu, loaded, mode, startup, clock, stack, delay>>
=============================================================================

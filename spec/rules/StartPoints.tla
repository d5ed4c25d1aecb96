----------------------------- MODULE StartPoints ------------------------------
(***************************************************************************)
(* A start point of a time-of-day interrupt is reached (section 1.1).      *)
(*                                                                         *)
(* Left out: the effect of a point on its OB (StartEvents).                *)
(***************************************************************************)
EXTENDS StartEvents, ServedPoints

(* [AMB-12] A start event is lost, and no earlier start event of its OB    *)
(* waits.                                                                  *)
\* @type: Int => Bool;
LostForGood(o) ==
    /\ Blocked(o) /\ LostEventEndsItsSource
    /\ ~PendingIn(requests, o) /\ ~OpenIn(requests, o)

(* A once may be used up when its point is reached [AMB-71]. *)
\* @type: (Int, $tod) => $tod;
AfterPoint(o, t) ==
    IF HasOnePoint(t.period) /\ (LostForGood(o) \/ OnceUsedUpAtItsPoint)
    THEN UsedUp(t) ELSE t

(* The OB is called for its point, unless it is blocked. *)
\* @type: Int => $tod;
AfterCallFor(o) == IF Blocked(o) THEN tod[o] ELSE Served(tod[o], tod[o].next)

(* The next point is armed. *)
\* @type: Int => Bool;
PassesItsPoint(o) ==
    LET t    == AfterCallFor(o)
        then == [clock EXCEPT !.ms = @ + 1]
    IN  \E c \in CpusThatShow({t}, then) :
          /\ cpu' = c
          /\ tod' = [tod EXCEPT ![o] = AfterPoint(o, Armed(t, then, c))]

(* In STARTUP one run is deferred [AMB-35]. *)
\* @type: Int => Bool;
RunIsDeferred(o) == mode = "STARTUP" /\ PendingIn(requests, o) /\ ~Idle(o)

(* [TINT-09] [TINT-14] The clock reaches the next point of an active       *)
(* interrupt.                                                              *)
\* @type: Int => Bool;
PointReached(o) ==
    /\ Watching
    /\ clock = NextMoment(tod[o])
    /\ PointsComeByNumber =>
         \A q \in TodObs : q < o => clock # NextMoment(tod[q])
    /\ PassesItsPoint(o)
    /\ IF ~RunIsDeferred(o) THEN Occurs(TodRequest(o, clock, 0))
       ELSE IF StartupDefersOneRun THEN Nothing
       ELSE Ordinary(TodRequest(o, clock, 0))
    /\ UNCHANGED <<loaded, modeVars, clock, dint, irt, runVars>>
=============================================================================

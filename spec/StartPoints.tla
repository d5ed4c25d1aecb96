----------------------------- MODULE StartPoints ------------------------------
(***************************************************************************)
(* A start point of a time-of-day interrupt is reached (section 1.1), and  *)
(* which points were served, for a clock that is set back [CLK-09].        *)
(*                                                                         *)
(* Left out: the effect of a point on its OB (StartEvents).                *)
(***************************************************************************)
EXTENDS StartEvents, TodSettings

(* [CLK-10] [CLK-11] On an S7-300 points are served again after the clock   *)
(* was set back; other CPUs remember which were served [AMB-17].           *)
Remembers == cpu.family # "S7-300" \/ S7300RemembersServed

(* [CLK-09] The OB is called for point p, which joins the runs of points    *)
(* beside it.  A point that is lost [IRT-18], or skipped without a run of  *)
(* its own, is over and yet was not served.                                *)
\* @type: ($tod, Int) => $tod;
Served(t, p) ==
    LET before == { i \in t.served : i.to < p /\ PointFrom(t, i.to + 1) >= p }
        after  == { i \in t.served : p < i.from /\ i.from <= PointFrom(t, p + 1) }
        first  == IF before = {} THEN p ELSE (CHOOSE i \in before : TRUE).from
        last   == IF after = {} THEN p ELSE (CHOOSE i \in after : TRUE).to
        run    == [from |-> first, to |-> last]
    IN  IF Remembers THEN [t EXCEPT !.served = (@ \ (before \cup after)) \cup {run}]
        ELSE t

(* [AMB-12] A start event is lost, and no earlier one of its OB waits. *)
\* @type: Int => Bool;
LostForGood(o) ==
    /\ Blocked(o) /\ LostEventEndsItsSource
    /\ ~PendingIn(requests, o) /\ ~OpenIn(requests, o)

(* A once may be used up when its point is reached [AMB-71]. *)
\* @type: (Int, $tod) => $tod;
AfterPoint(o, t) ==
    IF t.period = Once /\ (LostForGood(o) \/ OnceUsedUpAtItsPoint)
    THEN UsedUp(t) ELSE t

(* The setting of the OB when the point that it watches for is over. *)
\* @type: (Int, $tod) => $tod;
PastItsPoint(o, t) ==
    AfterPoint(o, Armed(IF Blocked(o) THEN t ELSE Served(t, t.next),
                        [clock EXCEPT !.ms = @ + 1]))

(* In STARTUP one run is deferred [AMB-35]. *)
\* @type: Int => Bool;
RunIsDeferred(o) == mode = "STARTUP" /\ PendingIn(requests, o) /\ ~Idle(o)

(* [TINT-09] [TINT-14] No point is watched for unless it is active. *)
\* @type: Int => Bool;
PointReached(o) ==
    /\ Watching
    /\ clock = NextMoment(tod[o])
    /\ PointsComeByNumber => \A q \in TodObs : q < o => clock # NextMoment(tod[q])
    /\ tod' = [tod EXCEPT ![o] = PastItsPoint(o, @)]
    /\ IF ~RunIsDeferred(o) THEN Occurs(TodRequest(o, clock, 0))
       ELSE IF StartupDefersOneRun THEN Nothing
       ELSE Ordinary(TodRequest(o, clock, 0))
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, runVars>>
=============================================================================

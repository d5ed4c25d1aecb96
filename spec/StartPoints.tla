----------------------------- MODULE StartPoints ------------------------------
(***************************************************************************)
(* A start point of a time-of-day interrupt is reached (catalogue section  *)
(* 1.1), and which points were served, for a clock that is set back        *)
(* [CLK-09].  What follows for its OB is said in StartEvents.              *)
(* Left out: what a point leads to (StartEvents).                          *)
(***************************************************************************)
EXTENDS TimeOfDay

(* [CLK-10] [CLK-11] On an S7-300 points are served again after the clock   *)
(* was set back; other CPUs remember which were served [AMB-17].           *)
Remembers == cpu.family # "S7-300" \/ S7300RemembersServed

(* [CLK-09] The OB is called for point p, which joins the runs of points    *)
(* beside it.  One that is lost [IRT-18] or skipped without a run of its    *)
(* own is over and yet was not served.                                      *)
\* @type: ($tod, Int) => $tod;
Served(t, p) ==
    LET before == { i \in t.served : i.to < p /\ PointFrom(t, i.to + 1) >= p }
        after  == { i \in t.served : p < i.from /\ i.from <= PointFrom(t, p + 1) }
        run    == [ from |-> IF before = {} THEN p ELSE (CHOOSE i \in before : TRUE).from,
                    to   |-> IF after = {} THEN p ELSE (CHOOSE i \in after : TRUE).to ]
    IN  IF Remembers THEN [t EXCEPT !.served = (@ \ (before \cup after)) \cup {run}]
        ELSE t

(* [AMB-12] A once that is lost is used up, unless an earlier run of it      *)
(* waits still.  [AMB-71] (b) Any once is, when its point is reached.      *)
\* @type: (Int, $tod) => $tod;
AfterPoint(o, t) ==
    IF /\ t.period = Once
       /\ \/ /\ Blocked(o) /\ LostEventEndsItsSource
             /\ ~PendingIn(requests, o) /\ ~OpenIn(requests, o)
          \/ OnceUsedUpAtItsPoint
    THEN UsedUp(t) ELSE t

(* [TINT-09] [TINT-14]; in STARTUP one run is deferred [AMB-35]. *)
\* @type: Int => Bool;
PointReached(o) ==
    LET p == tod[o].next
    IN  /\ Watching
        /\ clock = NextMoment(tod[o])  \* no point is watched unless it is active
        /\ PointsComeByNumber =>
             \A q \in TodObs : q < o => clock # NextMoment(tod[q])
        /\ tod' = [tod EXCEPT ![o] =
                      AfterPoint(o, Armed(IF Blocked(o) THEN @ ELSE Served(@, p),
                                          [clock EXCEPT !.ms = @ + 1]))]
        /\ IF mode = "STARTUP" /\ PendingIn(requests, o) /\ ~Idle(o)
           THEN IF StartupDefersOneRun THEN Nothing
                ELSE Ordinary(TodRequest(o, clock, 0))
           ELSE Occurs(TodRequest(o, clock, 0))
        /\ UNCHANGED <<cpu, loaded, mode, startup, clock, dint, irt, stack,
                       delay>>
=============================================================================

-------------------------------- MODULE Clock -------------------------------
(***************************************************************************)
(* Time passes, and the CPU clock is set by SFC 0, a programming device or *)
(* synchronisation, one rule for all [CLK-01] (sections 6 and 1.1).        *)
(*                                                                         *)
(* Left out: the limits of synchronisation, OB 87 [CLK-15].                *)
(***************************************************************************)
EXTENDS Delays, Skips

(* No start point is left behind: a point that equals the clock must have  *)
(* been dealt with, and the clock stops at the next point.                 *)
\* @type: $moment => Bool;
PassesNoPoint(t) ==
    Watching => \A o \in DOMAIN tod :
                  tod[o].active => /\ ~Before(NextMoment(tod[o]), t)
                                   /\ clock # NextMoment(tod[o])

(* The clock goes on to t while d ms elapse. *)
\* @type: ($moment, Int) => Bool;
TimePasses(t, d) ==
    /\ Before(clock, t)
    /\ PassesNoPoint(t)
    /\ PassesNoDelay(d)
    /\ clock' = t
    /\ dint'  = JobsAfter(d)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, tod, irt, outcomeVars, runVars>>

-----------------------------------------------------------------------------
(* The clock is set *)

\* @type: $moment => Bool;
IsBack(to) == Before(to, clock)

(* [AMB-59] A request stays when the clock is set back. *)
\* @type: $moment => Set($request);
RequestsThatStay(to) ==
    IF IsBack(to) /\ SetBackWithdrawsRuns
    THEN Close({ r \in requests : r.ob \notin TodObs }) ELSE requests

(* [AMB-40] (b) An S7-300 that is set back calls every active OB. *)
\* @type: $moment => Set(Int);
CalledBySetBack(to) ==
    IF /\ IsBack(to) /\ Watching
       /\ cpu.family = "S7-300" /\ SetBackCallsActiveObs
    THEN { o \in TodObs : /\ tod[o].active /\ ~Idle(o)
                          /\ ~PendingIn(RequestsThatStay(to), o) }
    ELSE {}

\* @type: $moment => Bool;
NothingSkipped(to) ==
    RequestsBecome(EnterAll(RequestsThatStay(to),
      { TodRequest(o, to, 0) : o \in CalledBySetBack(to) }))

(* [AMB-53] In HOLD the points that are skipped may wait for the release. *)
Deferring == IF mode # "HOLD" \/ ~SkipMayBeDeferred THEN {FALSE}
             ELSE IF SkipMayBeReported THEN BOOLEAN ELSE {TRUE}

(* [AMB-53] *)
\* @type: ($moment, Set(Int)) => Bool;
SomeSkipped(to, skipped) ==
    \/ /\ mode # "STARTUP" \/ SkipMayBeReported
       /\ Skip(SkippedByClock, to, skipped)
    \/ /\ mode = "STARTUP" /\ SkipMayBeDeferred
       /\ Defer(skipped)

(* The settings after the clock was set.  An OB whose skip is `held' keeps *)
(* its setting until the release.                                          *)
\* @type: ($moment, Bool, Set(Int)) => (Int -> $tod);
TodAfterClock(to, over, held) ==
    [ o \in DOMAIN tod |-> IF mode = "STOP" THEN Repeating(tod[o], to)
                           ELSE IF o \in held THEN tod[o]
                           ELSE Rearmed(o, to, over) ]

(* Set back, a CPU that remembers shows how it reads [AMB-56] [AMB-57]. *)
\* @type: $moment => Bool;
ClockSet(to) ==
    LET skipped == IF mode = "STOP" THEN {} ELSE SkippedBy(to)
        shows   == Remembers /\ IsBack(to)
    IN  /\ to # clock
        /\ clock' = to
        /\ \E shown \in IF shows THEN CpusShown ELSE {cpu}, held \in Deferring :
             /\ cpu' = shown
             /\ tod' = TodAfterClock(to, UnservedAreOver(shown),
                                     IF held THEN skipped ELSE {})
             /\ IF skipped = {} \/ held THEN NothingSkipped(to)
                                        ELSE SomeSkipped(to, skipped)
        /\ UNCHANGED <<loaded, modeVars, dint, irt, runVars>>
=============================================================================

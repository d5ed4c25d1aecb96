-------------------------------- MODULE Clock -------------------------------
(***************************************************************************)
(* Time passes, and the CPU clock is set by SFC 0, a programming device or *)
(* synchronisation, one rule for all [CLK-01] (catalogue section 6, and    *)
(* 1.1).                                                                   *)
(*                                                                         *)
(* Left out: the limits of synchronisation, OB 87 [CLK-15].                *)
(***************************************************************************)
EXTENDS TimeDelay

(* No start point is left behind: one that equals the clock must have been  *)
(* dealt with, and the clock stops at the next one.                        *)
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
    /\ UNCHANGED <<cpu, loaded, mode, startup, tod, irt, requests, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------
(* Points that the clock skips *)

(* The active interrupts with points between the old and the new time.  A   *)
(* point that equals the new time is reached, not skipped [AMB-37].        *)
\* @type: $moment => Set(Int);
SkippedBy(to) == { o \in DOMAIN tod : /\ tod[o].active
                                      /\ ~Deselected(o)
                                      /\ IsPast(NextMoment(tod[o]), to) }

\* @type: ($tod, $moment) => $tod;
Repeating(t, to) ==
    IF Remembers /\ Before(to, clock) /\ clock.min > t.repeatTo
    THEN [t EXCEPT !.repeatTo = clock.min] ELSE t

(* The interrupts after the clock was set. *)
\* @type: ($moment, Bool) => (Int -> $tod);
Rearmed(to, passing) ==
    [ o \in DOMAIN tod |->
        LET t    == Repeating(tod[o], to)
            next == NextPoint(t, to, passing)
        IN  IF ~t.active \/ next = t.next THEN t
            ELSE IF o \notin SkippedBy(to) THEN [t EXCEPT !.next = next]
            ELSE AfterPoint(o, [ (IF Blocked(o) THEN t ELSE Served(t, t.next))
                                 EXCEPT !.next = next ]) ]

(* [AMB-54] The order of several catch-ups. *)
\* @type: ($request, $request) => Bool;
Precedes(r, s) == CASE CatchUpsComeByPoint  -> Before(r.since, s.since)
                    [] CatchUpsComeByNumber -> r.ob < s.ob
                    [] OTHER                -> FALSE

\* @type: (Set($request), Set($request)) => Set($request);
WithCatchUps(q, runs) ==
    q \cup
      { [ r EXCEPT !.rank = PlaceIn(q, r)
            + Cardinality({ s \in runs : s.class = r.class /\ Precedes(s, r) }) ]
        : r \in runs }

(* [AMB-16] The time that OB 80 gives. *)
\* @type: (Set(Int), $moment) => $moment;
TimeOfSkip(skipped, now) ==
    IF SkipGivesNewTime THEN now
    ELSE LET points == { NextMoment(tod[o]) : o \in skipped }
         IN  CHOOSE m \in points : \A n \in points : ~Before(n, m)

(* [CLK-02] [CLK-03] [CLK-06] [OBS-32] [OBS-46] One OB 80 for all that is    *)
(* late, then one catch-up each, in any order.  Whether an OB that waits   *)
(* or runs gets one of its own is open [AMB-52] (if not, one that is left  *)
(* open and waits comes for sure), whether a blocked one is                *)
(* reported [AMB-50], and what follows HOLD [AMB-55]; a missing one is     *)
(* [AMB-51].                                                               *)
\* @type: (Int, $moment, Set(Int)) => Bool;
Skip(fault, now, skipped) ==
    LET silent == { o \in skipped : Blocked(o) }
        waits  == { o \in skipped \ silent : \/ OnStack(o)
                                             \/ PendingIn(requests, o)
                                             \/ OpenIn(requests, o) }
        absent == IF SkipOfMissingObIsSilent THEN skipped \ loaded ELSE {}
        held   == fault = SkippedInHold
    IN  \E merged \in MergedAmong(waits), unsaid \in UnreportedAmong(silent) :
          LET late == (skipped \ unsaid) \ absent
              runs == { [ TodRequest(o, NextMoment(tod[o]),
                                     IF o \in absent THEN 0 ELSE fault)
                          EXCEPT !.open = held /\ CatchUpAfterHoldIsOpen ]
                        : o \in IF held /\ NoCatchUpAfterHold THEN {}
                                ELSE skipped \ (silent \cup merged) }
              sure == { IF r.ob \in merged /\ ~PendingIn(requests, r.ob)
                             /\ { s \in requests : /\ s.ob = r.ob
                                                   /\ s.rank < r.rank } = {}
                        THEN [r EXCEPT !.open = FALSE] ELSE r : r \in requests }
              kept == WithCatchUps(sure, runs)
          IN  IF late = {}
              THEN requests' = kept /\ UNCHANGED stopCause /\ NothingEntered
              ELSE TimeErrorOccurs(kept, requests,
                     [ TimeError(fault, late, 0, 0) EXCEPT
                         !.since = TimeOfSkip(skipped, now) ])

(* [AMB-53] In STARTUP the runs may also be deferred without OB 80. *)
\* @type: Set(Int) => Bool;
Defer(skipped) ==
    /\ requests' = WithCatchUps(requests,
                     { TodRequest(o, NextMoment(tod[o]), 0)
                       : o \in { s \in skipped : ~PendingIn(requests, s)
                                                 /\ ~Blocked(s) } })
    /\ UNCHANGED stopCause
    /\ NothingEntered

-----------------------------------------------------------------------------
(* The clock is set *)

(* What waits when the clock is set back: it stays [AMB-59]; under AMB-40   *)
(* (b) an S7-300 calls every active time-of-day OB.                        *)
\* @type: $moment => Bool;
NothingSkipped(to) ==
    LET stay == IF Before(to, clock) /\ SetBackWithdrawsRuns
                THEN Close({ r \in requests : r.ob \notin TodObs }) ELSE requests
        all  == IF /\ Before(to, clock) /\ Watching
                   /\ cpu.family = "S7-300" /\ SetBackCallsActiveObs
                THEN { o \in TodObs : tod[o].active /\ ~Idle(o)
                                      /\ ~PendingIn(stay, o) }
                ELSE {}
    IN  /\ requests' = EnterAll(stay, { TodRequest(o, to, 0) : o \in all })
        /\ UNCHANGED stopCause
        /\ NothingEntered

(* [AMB-53] In HOLD the points that are skipped may also wait for release.  *)
\* @type: $moment => Bool;
ClockSet(to) ==
    LET skipped == IF mode = "STOP" THEN {} ELSE SkippedBy(to)
        back    == Remembers /\ Before(to, clock)
    IN  /\ to # clock
        /\ clock' = to
        /\ \E shown \in IF back THEN CpusShown ELSE {cpu},
              deferred \in IF mode # "HOLD" \/ ~SkipMayBeDeferred THEN {FALSE}
                           ELSE IF SkipMayBeReported THEN BOOLEAN ELSE {TRUE} :
             /\ cpu' = shown
             /\ tod' = [ o \in DOMAIN tod |->
                          IF mode = "STOP" THEN Repeating(tod[o], to)
                          ELSE IF deferred /\ o \in skipped THEN tod[o]
                          ELSE Rearmed(to, UnservedAreOver(shown))[o] ]
             /\ IF skipped = {} \/ deferred THEN NothingSkipped(to)
                ELSE \/ /\ mode # "STARTUP" \/ SkipMayBeReported
                        /\ Skip(SkippedByClock, to, skipped)
                     \/ /\ mode = "STARTUP" /\ SkipMayBeDeferred
                        /\ Defer(skipped)
        /\ UNCHANGED <<loaded, mode, startup, dint, irt, stack, delay>>
=============================================================================

-------------------------------- MODULE Clock -------------------------------
(***************************************************************************)
(* Time passes, and the CPU clock is set by SFC 0, a programming device or *)
(* synchronisation, one rule for all [CLK-01] (sections 6 and 1.1).        *)
(*                                                                         *)
(* Left out: the limits of synchronisation, OB 87 [CLK-15].                *)
(***************************************************************************)
EXTENDS StartPoints, TimeDelay

(* Time does not pass a start point: it stops at the next point, and a     *)
(* point that equals the clock must have been handled. Those that passed   *)
(* in STOP are noticed when RUN begins at the latest.                      *)
\* @type: $moment => Bool;
PassesNoPoint(t) ==
    Watching => /\ ~(resume.due /\ mode = "RUN")
                /\ \A o \in DOMAIN tod :
                     tod[o].active => \/ /\ ~Before(NextMoment(tod[o]), t)
                                         /\ clock # NextMoment(tod[o])
                                      \/ tod[o].held

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

(* [AMB-59] The requests that stay when the clock is set. *)
\* @type: $moment => Set($request);
RequestsThatStay(to) == IF WithdrawnBy(to) = {} THEN requests
                        ELSE Close(requests \ WithdrawnBy(to))

(* [AMB-40] (b) An S7-300 whose clock is set back calls every active OB,   *)
(* except that of a one-shot interrupt whose call runs [CLK-12].           *)
\* @type: $moment => Set(Int);
CalledBySetBack(to) ==
    IF /\ IsBack(to) /\ Watching
       /\ Family.repeats /\ SetBackCallsActiveObs
    THEN { o \in TodObs : /\ tod[o].active /\ ~tod[o].called /\ TakesEvents(o)
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
       /\ TimeErrorOb \notin Family.heldBack  \* [T15-117]
       /\ Defer(skipped)

(* [AMB-83] When the clock is set back in HOLD, the interrupts whose next  *)
(* point OB 80 will report though it is ahead again. A point that equals   *)
(* the clock may have passed or not.                                       *)
\* @type: $moment => Set(Set(Int));
HeldAfter(to) ==
    IF ~(mode = "HOLD" /\ IsBack(to)) THEN {Held}
    ELSE (IF SetBackKeepsHeld THEN {} ELSE {Held})
           \cup (IF SetBackForgetsHeld THEN {}
                 ELSE { Held \cup SkippedBy(clock) \cup equal
                        : equal \in SUBSET { o \in PointsAtClock :
                            tod[o].next = clock.min } })

(* [AMB-71] This call also consumes a one-shot interrupt. *)
\* @type: $tod => $tod;
CalledOnce(t) == IF OnceUsedUpAtItsPoint THEN UsedUp(t)
                                         ELSE [t EXCEPT !.next = Never]

(* [T15-93] [T15-94] [T15-95] Set back by so much, points are served       *)
(* again.                                                                  *)
\* @type: $moment => Set(Bool);
ServesAgain(to) ==
    IF Family.jump = 0 \/ ~IsBack(to) THEN {FALSE}
    ELSE { ~small : small \in SmallJumps(Span(to, clock)) }

(* [T15-94] The latest run of a one-shot interrupt whose point the clock   *)
(* will reach again. No text says whether it runs again.                   *)
\* @type: (Int, $moment) => Set($memory);
RanOnce(o, to) ==
    LET t    == tod[o]
        runs == { i \in Memory(t) : HasOnePoint(i.period)
                                     /\ ~Before(At(i.from), to) }
    IN  IF t.active \/ (t.set /\ t.served = {}) \/ mode = "STOP" THEN {}
        ELSE { i \in runs : \A j \in runs : j.from <= i.from }

(* [T15-94] The last point that the OB served, and will serve again.       *)
\* @type: $tod => Int;
ServedUntil(t) ==
    LET ends == { i.to : i \in t.served }
    IN  IF ends = {} THEN -1 ELSE CHOOSE p \in ends : \A q \in ends : q <= p

(* The setting of an OB that serves its points again: those up to overTo.  *)
(* One that is still held stays.                                           *)
\* @type: (Int, $moment, $cpu, Bool) => $tod;
Forgetful(o, to, c, runsAgain) ==
    LET t == [ tod[o] EXCEPT !.served = {}, !.merged = {}, !.earlier = {},
                             !.repeatTo = -1, !.overTo = ServedUntil(tod[o]),
                             !.held = @ /\ IsPast(NextMoment(tod[o]), to) ]
        i == CHOOSE r \in RanOnce(o, to) : TRUE
    IN  IF runsAgain
        THEN Armed([ t EXCEPT !.set = TRUE, !.active = TRUE,
                              !.start = i.start, !.zone = i.zone,
                              !.period = i.period, !.overTo = i.to ], to, c)
        ELSE IF ~t.active \/ t.held \/ mode = "STOP" \/ StaysUsed(o, to) THEN t
        ELSE Armed(t, to, c)

(* The settings after the clock was set. If a skip is `deferred', the      *)
(* setting of its OB stays until the release; so does one that is `held'.  *)
\* @type: ($moment, $cpu, Set(Int), Set(Int), Bool) => (Int -> $tod);
TodAfterClock(to, c, deferred, held, count) ==
    [ o \in DOMAIN tod |->
        IF mode = "STOP" THEN Repeating(o, tod[o], to, count)
        ELSE IF o \in held
        THEN Repeating(o, [tod[o] EXCEPT !.held = TRUE], to, count)
        ELSE IF o \in deferred THEN tod[o]
        ELSE IF o \in CalledBySetBack(to) /\ HasOnePoint(tod[o].period)
        THEN CalledOnce(SettingAt(o, to, count))
        ELSE Rearmed(o, to, c, count) ]

(* [AMB-56] Whether merged calls count as calls, if there are any.         *)
\* @type: $moment => Set(Bool);
MergedCount(to) ==
    IF IsBack(to) /\ \E o \in DOMAIN tod : tod[o].merged # {} THEN BOOLEAN
    ELSE {TRUE}

(* [CLK-01] *)
\* @type: $moment => Bool;
ClockSet(to) ==
    LET skipped == IF mode = "STOP" THEN {} ELSE SkippedBy(to) \ Held
        \* @type: Bool => Set($tod);
        active(count) == IF mode = "STOP" THEN {} ELSE ActiveAt(to, count)
    IN  /\ to # clock
        /\ clock' = to
        /\ \E count \in MergedCount(to), deferred \in Deferring,
              held \in HeldAfter(to), again \in ServesAgain(to) :
           \E c \in CpusThatShow(active(count), to),
              ones \in SUBSET (IF ~again THEN {}
                               ELSE { o \in TodObs : RanOnce(o, to) # {} }) :
             /\ cpu' = c
             /\ IF skipped = {} \/ deferred THEN NothingSkipped(to)
                                            ELSE SomeSkipped(to, skipped)
             /\ tod' = IF again
                       THEN [ o \in DOMAIN tod |->
                                Forgetful(o, to, c, o \in ones) ]
                       ELSE TodAfterClock(to, c, IF deferred THEN skipped
                                                 ELSE {}, held, count)
        /\ UNCHANGED <<loaded, modeVars, dint, irt, runVars>>
=============================================================================

-------------------------------- MODULE Clock -------------------------------
(***************************************************************************)
(* Time passes, and the CPU clock is set by SFC 0, a programming device or *)
(* synchronisation, one rule for all [CLK-01] (sections 6 and 1.1); local  *)
(* time is set (S7-1500).                                                  *)
(*                                                                         *)
(* Left out: the limits of synchronisation, OB 87 [CLK-15]; the rule of    *)
(* daylight saving, for which the world says when it applies.              *)
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

(* No source says whether a one-shot interrupt that has passed without a   *)
(* run is armed again when its point is ahead: these are not.              *)
\* @type: Set(Set(Int));
NotArmedAgain == SUBSET { o \in DOMAIN tod : Spent(o) }

(* [T15-94] The last point that the OB served, and will serve again.       *)
\* @type: $tod => Int;
ServedUntil(t) ==
    LET ends == { i.to : i \in t.served }
    IN  IF ends = {} THEN -1 ELSE CHOOSE p \in ends : \A q \in ends : q <= p

(* The setting of an OB that serves its points again: those up to overTo.  *)
(* What a small step repeated was not served by that. One that is still    *)
(* held stays, and so does one that is `staying'.                          *)
\* @type: (Int, $moment, $cpu, Bool, Set(Int)) => $tod;
Forgetful(o, to, c, runsAgain, staying) ==
    LET t == [ tod[o] EXCEPT !.served = {}, !.merged = {}, !.earlier = {},
                             !.repeatTo = -1,
                             !.overTo = LET u == ServedUntil(tod[o])
                                        IN  IF @ > u /\ @ > tod[o].repeatTo
                                            THEN @ ELSE u,
                             !.held = @ /\ IsPast(NextMoment(tod[o]), to) ]
        i == CHOOSE r \in RanOnce(o, to) : TRUE
    IN  IF runsAgain
        THEN Armed([ t EXCEPT !.set = TRUE, !.active = TRUE,
                              !.start = i.start, !.local = i.local,
                              !.zone = i.zone, !.period = i.period,
                              !.overTo = i.to ], to, c)
        ELSE IF \/ ~t.active \/ t.held \/ mode = "STOP" \/ o \in staying
                \/ StaysUsed(o, to) THEN t
        ELSE Armed(t, to, c)

(* The settings after the clock was set. If a skip is deferred, the        *)
(* setting of its OB is `staying' until the release; so is one that is     *)
(* `held', and one that is not armed again.                                *)
\* @type: ($moment, $cpu, Set(Int), Set(Int), Bool) => (Int -> $tod);
TodAfterClock(to, c, staying, held, count) ==
    [ o \in DOMAIN tod |->
        IF mode = "STOP" THEN Repeating(o, tod[o], to, count)
        ELSE IF o \in held
        THEN Repeating(o, [tod[o] EXCEPT !.held = TRUE], to, count)
        ELSE IF o \in CalledBySetBack(to) /\ HasOnePoint(tod[o].period)
        THEN CalledOnce(SettingAt(o, to, count))
        ELSE IF o \in staying THEN SettingAt(o, to, count)
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
              held \in HeldAfter(to), again \in ServesAgain(to),
              staying \in NotArmedAgain :
           \E c \in CpusThatShow(active(count), to),
              ones \in SUBSET (IF ~again THEN {}
                               ELSE { o \in TodObs : RanOnce(o, to) # {} }) :
             /\ cpu' = c
             /\ IF skipped = {} \/ deferred THEN NothingSkipped(to)
                                            ELSE SomeSkipped(to, skipped)
             /\ tod' = IF again
                       THEN [ o \in DOMAIN tod |->
                                Forgetful(o, to, c, o \in ones, staying) ]
                       ELSE TodAfterClock(to, c, staying \cup
                              (IF deferred THEN skipped ELSE {}), held, count)
        /\ UNCHANGED <<loaded, modeVars, dint, irt, runVars>>

-----------------------------------------------------------------------------
(* Local time is set, by daylight saving or to another zone. The clock,    *)
(* which is system time, goes on, and so do the interrupts that count by   *)
(* it [T15-99]. For those by local time it is as if the clock were set by  *)
(* so many minutes [T15-96] [T15-97] [T15-98]: their points are told by    *)
(* the clock of before, and then moved.                                    *)

\* @type: (Int, Int) => Int;
MovedMinute(m, d) == IF m \in {-1, Never} THEN m ELSE m - d

\* @type: (Set($run), Int) => Set($run);
MovedRuns(runs, d) ==
    { [i EXCEPT !.from = @ - d, !.to = @ - d] : i \in runs }

\* @type: ($memory, Int) => $memory;
MovedMemory(i, d) ==
    IF ~i.local THEN i
    ELSE [i EXCEPT !.from = @ - d, !.to = @ - d, !.zone = @ + d]

(* The setting by the clock when local time is d minutes further ahead.    *)
\* @type: ($tod, Int) => $tod;
Moved(t, d) ==
    LET u == [t EXCEPT !.earlier = { MovedMemory(i, d) : i \in @ }]
    IN  IF ~t.local THEN u
        ELSE [ u EXCEPT !.zone     = @ + d,
                        !.next     = MovedMinute(@, d),
                        !.served   = MovedRuns(@, d),
                        !.merged   = MovedRuns(@, d),
                        !.repeatTo = MovedMinute(@, d),
                        !.overTo   = MovedMinute(@, d) ]

(* [A15-20] Daylight saving skips the minutes from the one to the other,   *)
(* or doubles them. What another zone does to them is not known.           *)
\* @type: ($cpu, Int, Bool) => $cpu;
InZone(c, zone, daylight) ==
    [ c EXCEPT !.zone = zone,
               !.hour = IF ~daylight THEN NoHour
                        ELSE [ from |-> clock.min + cpu.zone,
                               to   |-> clock.min + zone ] ]

LocalObs == { o \in DOMAIN tod : tod[o].local }

(* [T15-97] Interrupts that serve their points again: all if daylight      *)
(* saving ends, [T15-98] some, or none, if a zone does.                    *)
\* @type: (Int, Bool) => Set(Set(Int));
ServedAgain(d, daylight) ==
    { CASE d > 0    -> {}
        [] daylight -> LocalObs
        [] OTHER    -> some : some \in SUBSET LocalObs }

(* One-shot interrupts by local time that ran, and may run again.          *)
\* @type: (Int, $moment) => Set(Int);
LocalOnes(d, to) ==
    IF d > 0 THEN {}
    ELSE { o \in TodObs : \E i \in RanOnce(o, to) : i.local }

(* The skipped points are caught up; in HOLD they wait for the release.    *)
\* @type: (Set(Int), Bool) => Bool;
SkippedLocally(skipped, daylight) ==
    IF skipped = {} \/ mode = "HOLD" THEN Nothing
    ELSE Skip(IF daylight THEN SkippedByDaylight ELSE SkippedByZone, clock,
              skipped)

(* [T15-96] [T15-97] [T15-98] Local time is zone minutes ahead from now    *)
(* on.                                                                     *)
\* @type: (Int, Bool) => Bool;
LocalTimeSet(zone, daylight) ==
    LET d  == zone - cpu.zone
        to == [clock EXCEPT !.min = @ + d]
        skipped == IF mode = "STOP" \/ d < 0 THEN {}
                   ELSE (SkippedBy(to) \cap LocalObs) \ Held
        \* @type: Bool => Set($tod);
        active(count) == { SettingAt(o, to, count)
                           : o \in { p \in LocalObs : tod[p].active } }
    IN  /\ Family.setsLocal /\ d # 0
        /\ clock' = clock
        /\ SkippedLocally(skipped, daylight)
        /\ \E count \in MergedCount(to), held \in HeldAfter(to),
              again \in ServedAgain(d, daylight),
              staying \in NotArmedAgain,
              ones \in SUBSET LocalOnes(d, to) :
           \E c \in CpusThatShow(active(count), to) :
             /\ cpu' = InZone(c, zone, daylight)
             /\ tod' = [ o \in DOMAIN tod |->
                  Moved(IF o \in again \cup ones
                        THEN Forgetful(o, to, c, o \in ones, staying)
                        ELSE IF ~tod[o].local THEN tod[o]
                        ELSE TodAfterClock(to, c, staying \cup
                               (IF mode = "HOLD" THEN skipped ELSE {}),
                               held, count)[o], d) ]
        /\ UNCHANGED <<loaded, modeVars, dint, irt, runVars>>
=============================================================================

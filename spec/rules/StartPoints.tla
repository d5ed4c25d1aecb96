----------------------------- MODULE StartPoints ------------------------------
(***************************************************************************)
(* The start points of time-of-day interrupts: points that the clock       *)
(* reaches (section 1.1), and points that it skips, set forward or in      *)
(* HOLD, with the OB 80 that reports them and the catch-ups (section 6).   *)
(*                                                                         *)
(* Left out: the effect of a point on its OB (StartEvents); the setting of *)
(* the clock itself (Clock).                                               *)
(***************************************************************************)
EXTENDS StartEvents, TodSettings

-----------------------------------------------------------------------------
(* Points that are reached *)

(* [AMB-12] A start event is lost, and no earlier start event of its OB    *)
(* waits.                                                                  *)
\* @type: Int => Bool;
LostForGood(o) ==
    /\ Blocked(o) /\ LostEventEndsItsSource
    /\ ~PendingIn(requests, o) /\ ~OpenIn(requests, o)

(* [AMB-71] A one-shot interrupt may be used up when its point is reached. *)
\* @type: (Int, $tod) => $tod;
AfterPoint(o, t) ==
    IF HasOnePoint(t.period) /\ (LostForGood(o) \/ OnceUsedUpAtItsPoint)
    THEN UsedUp(t) ELSE t

(* [AMB-56] The setting of an OB after point p, if a run for it comes;     *)
(* else it is t.                                                           *)
\* @type: (Int, $tod, Int, $tod) => $tod;
AfterRunFor(o, u, p, t) ==
    LET runs == { r \in requests' : r.ob = o /\ r.since.min = p }
    IN  IF runs = {} THEN t
        ELSE IF \E r \in runs : ~r.open THEN Served(u, p)
        ELSE Merged(u, [from |-> p, to |-> p])

(* The OB is called for its point, unless it is blocked. If it waits or    *)
(* runs, its call may be merged with another one.                          *)
\* @type: Int => $tod;
AfterCallFor(o) ==
    LET t == tod[o]
    IN  IF Blocked(o) THEN t
        ELSE AfterRunFor(o, t, t.next,
                         Merged(t, [from |-> t.next, to |-> t.next]))

(* The next point is armed. *)
\* @type: Int => Bool;
PassesItsPoint(o) ==
    LET t    == AfterCallFor(o)
        then == [clock EXCEPT !.ms = @ + 1]
    IN  \E c \in CpusThatShow({t}, then) :
          /\ cpu' = c
          /\ tod' = [tod EXCEPT ![o] = AfterPoint(o, Armed(t, then, c))]

(* In STARTUP one run is deferred [AMB-35]. On an S7-1500 the queue takes  *)
(* its points as in RUN [T15-118]; OB 80 waits [T15-117].                  *)
\* @type: Int => Bool;
RunIsDeferred(o) ==
    /\ mode = "STARTUP" /\ PendingIn(requests, o) /\ TakesEvents(o)
    /\ ~Family.keeps

(* [TINT-09] [TINT-14] The clock reaches the next point of an active       *)
(* interrupt.                                                              *)
\* @type: Int => Bool;
PointReached(o) ==
    /\ Watching
    /\ clock = NextMoment(tod[o])
    /\ ~tod[o].held
    /\ PointsComeByNumber =>
         \A q \in TodObs : q < o => clock # NextMoment(tod[q])
    /\ IF ~RunIsDeferred(o) THEN Occurs(TodRequest(o, clock, 0))
       ELSE IF StartupDefersOneRun THEN Nothing
       ELSE Ordinary(TodRequest(o, clock, 0))
    /\ PassesItsPoint(o)
    /\ UNCHANGED <<loaded, modeVars, clock, dint, irt, runVars>>

-----------------------------------------------------------------------------
(* Points that are skipped *)

(* The next point that can be skipped: the next point, or under AMB-58 (b) *)
(* also a point that was served before the clock was set back.             *)
\* @type: $tod => $moment;
NextSkipped(t) ==
    IF ~(ServedPointsAreSkipped /\ clock.min < t.repeatTo) THEN NextMoment(t)
    ELSE [NextMoment(t) EXCEPT !.min = Earlier(@, PointFrom(t, clock.min + 1))]

(* [AMB-83] [AMB-26] The interrupts whose next point passed in HOLD before *)
(* the clock was set back, or in STOP before a hot restart.                *)
Held == { o \in DOMAIN tod : tod[o].held }

(* The active interrupts with a point that equals the clock and was not    *)
(* reached yet.                                                            *)
PointsAtClock ==
    { o \in DOMAIN tod :
        /\ tod[o].active /\ ~Deselected(o) /\ clock.ms = tod[o].offset
        /\ tod[o].next <= clock.min
        /\ NextPoint(tod[o], clock, cpu) = clock.min }

(* The active interrupts with points between the old and the new time.  A  *)
(* point that equals the new time is reached, not skipped [AMB-37].        *)
\* @type: (Int, $moment) => Bool;
IsSkippedBy(o, to) == /\ tod[o].active
                      /\ ~Deselected(o)
                      /\ IsPast(NextSkipped(tod[o]), to)
\* @type: $moment => Set(Int);
SkippedBy(to) == { o \in DOMAIN tod : IsSkippedBy(o, to) }

-----------------------------------------------------------------------------
(* The settings after a skip *)

(* The last minute that has passed with its point, if it has one [AMB-14]. *)
(* In HOLD, and in STOP, the next point may have passed.                   *)
\* @type: $tod => Int;
PassedMinute(t) ==
    LET passed == t.held \/ (mode = "HOLD" /\ clock # NextMoment(t))
    IN  IF clock.ms < t.offset \/ (t.next = clock.min /\ ~passed)
        THEN clock.min - 1 ELSE clock.min

(* [AMB-56] [AMB-59] The merged points for which OB o was called: all that *)
(* `count', and those whose run waits.                                     *)
\* @type: (Int, Set($run), Bool) => Set($run);
CalledAmong(o, merged, count) ==
    LET waits == { r.since.min : r \in { q \in requests :
                                          q.ob = o /\ ~q.open } }
    IN  IF count THEN merged
        ELSE { [from |-> p, to |-> p]
               : p \in { q \in waits :
                          \E i \in merged : i.from <= q /\ q <= i.to } }

(* A clock that is set back repeats the time until now. *)
\* @type: (Int, $tod, $moment, Bool) => $tod;
Repeating(o, t, to, count) ==
    IF ~(Remembers /\ Before(to, clock)) THEN t
    ELSE [ t EXCEPT
             !.served   = IF t.merged = {} THEN @
                          ELSE JoinedAll(t, @ \cup
                                         CalledAmong(o, t.merged, count)),
             !.merged   = {},
             !.repeatTo = IF PassedMinute(t) > @ THEN PassedMinute(t) ELSE @,
             !.overTo   = IF PassedMinute(t) > @ THEN PassedMinute(t) ELSE @ ]

(* [AMB-59] (b) The runs that a clock set back withdraws. *)
\* @type: $moment => Set($request);
WithdrawnBy(to) == IF Before(to, clock) /\ SetBackWithdrawsRuns
                   THEN { r \in requests : r.ob \in TodObs } ELSE {}

(* The setting of an OB when the clock is set, before it is armed. *)
\* @type: (Int, $moment, Bool) => $tod;
SettingAt(o, to, count) ==
    LET points == PointsOf(WithdrawnBy(to), o)
        t      == Repeating(o, tod[o], to, count)
    IN  IF points = {} THEN t ELSE NotServed(t, points)

\* @type: ($moment, Bool) => Set($tod);
ActiveAt(to, count) ==
    { SettingAt(o, to, count) : o \in { p \in DOMAIN tod : tod[p].active } }

(* [CLK-12] A one-shot interrupt is used up by its call, and the call is   *)
(* not withdrawn [AMB-59].                                                 *)
\* @type: (Int, $moment) => Bool;
StaysUsed(o, to) ==
    CallUsesUp(o) /\ { r \in WithdrawnBy(to) : r.ob = o } = {}

(* The setting of an OB when the clock is at `to', after the skip. A       *)
(* skipped point counts as served only if its catch-up runs separately:    *)
(* neither merged with a pending run nor lost [AMB-56].                    *)
\* @type: (Int, $moment, $cpu, Bool) => $tod;
Rearmed(o, to, c, count) ==
    LET t    == SettingAt(o, to, count)
        next == NextPoint(t, to, c)
        p    == NextSkipped(t).min
        done == AfterRunFor(o, t, p, t)
    IN  IF ~t.active \/ next = t.next \/ StaysUsed(o, to) THEN t
        ELSE IF ~IsSkippedBy(o, to) THEN [t EXCEPT !.next = next]
        ELSE AfterPoint(o, [done EXCEPT !.next = next])

-----------------------------------------------------------------------------
(* Catch-ups *)

(* [AMB-54] The order of several catch-ups. *)
\* @type: ($request, $request) => Bool;
Precedes(r, s) == CASE CatchUpsComeByPoint  -> Before(r.since, s.since)
                    [] CatchUpsComeByNumber -> r.ob < s.ob
                    [] OTHER                -> FALSE

(* Those that have an order get places behind each other, without gaps.    *)
\* @type: (Set($request), Set($request)) => Set($request);
WithCatchUps(q, runs) ==
    LET \* @type: $request => Set($request);
        earlier(r) == { s \in runs : s.class = r.class /\ Precedes(s, r) }
        \* @type: $request => Int;
        place(r)   == IF earlier(r) = {} THEN PlaceIn(q, r)
                      ELSE Cardinality({ s.rank : s \in q }) + 1
                             + Cardinality(earlier(r))
    IN  IF CatchUpsComeTogether THEN EnterAll(q, runs)
        ELSE Close(q \cup { [r EXCEPT !.rank = place(r)] : r \in runs })

(* [CLK-03] One run for each OB, for its first skipped point [CLK-07];     *)
(* after HOLD it may be open or missing [AMB-55]. No OB 80 reports the     *)
(* `absent' OBs.                                                           *)
\* @type: (Int, Set(Int), Set(Int)) => Set($request);
CatchUps(fault, obs, absent) ==
    LET held == fault = SkippedInHold
    IN  IF held /\ NoCatchUpAfterHold THEN {}
        ELSE { [ TodRequest(o, NextSkipped(tod[o]),
                            IF o \in absent THEN 0 ELSE fault)
                 EXCEPT !.open = held /\ CatchUpAfterHoldIsOpen ] : o \in obs }

(* OBs without a catch-up of their own: their open requests are confirmed. *)
\* @type: Set(Int) => Set($request);
RequestsMerged(obs) ==
    Confirmed(requests, { o \in obs : ~PendingIn(requests, o) })

\* @type: Int => Bool;
WaitsOrRuns(o) == OnStack(o) \/ PendingIn(requests, o) \/ OpenIn(requests, o)

-----------------------------------------------------------------------------
(* The skip *)

(* [AMB-16] The time that OB 80 gives. *)
\* @type: (Set(Int), $moment) => $moment;
TimeOfSkip(skipped, now) ==
    IF SkipGivesNewTime THEN now
    ELSE LET points == { NextSkipped(tod[o]) : o \in skipped }
         IN  CHOOSE m \in points : \A n \in points : ~Before(n, m)

(* [T15-90] [T15-91] [T15-95] Whether the clock is set forward by so       *)
(* little that no OB 80 reports the skip. [T15-98] None reports that of a  *)
(* new zone, [T15-96] and perhaps none that of daylight saving [A15-10].   *)
\* @type: (Int, $moment) => Set(Bool);
Quietly(fault, now) ==
    CASE fault = SkippedByZone     -> {TRUE}
      [] fault = SkippedByDaylight -> DaylightIsQuiet
      [] Family.jump = 0 \/ fault # SkippedByClock -> {FALSE}
      [] OTHER -> SmallJumps(Span(clock, now))

(* [T15-91] [T15-119] [A15-08] The OBs that get a catch-up, of those       *)
(* reported. The first is among them by every letter: (a), (b) and (c).    *)
\* @type: Set(Int) => Set(Set(Int));
CaughtUpOf(obs) ==
    LET \* @type: Int => $moment;
        point(o) == NextSkipped(tod[o])
        earliest == { o \in obs : \A p \in obs : ~Before(point(p), point(o)) }
        heads == { o \in obs : \A p \in obs :
                     ClassOf(p) = ClassOf(o) => ~Before(point(p), point(o)) }
    IN  IF Family.jump = 0 \/ obs = {} \/ EachSkippedObIsCaughtUp THEN {obs}
        ELSE IF OnlyFirstSkippedIsCaughtUp THEN { {o} : o \in earliest }
        ELSE IF FirstOfEachClassIsCaughtUp
        THEN { s \in SUBSET heads :
                 \A h \in heads :
                   Cardinality({ o \in s : ClassOf(o) = ClassOf(h) }) = 1 }
        ELSE { s \in SUBSET obs : s \cap earliest # {} }

(* [CLK-02] [CLK-03] [CLK-06] [OBS-32] [OBS-46] One OB 80 for all that are *)
(* late, then one catch-up each.  An OB already waiting or running may get *)
(* its own catch-up or not [AMB-52].  A blocked one may be reported or not *)
(* [AMB-50], a missing one is [AMB-51].                                    *)
\* @type: (Int, $moment, Set(Int)) => Bool;
Skip(fault, now, skipped) ==
    LET blocked == { o \in skipped : Blocked(o) }
        busy    == { o \in skipped \ blocked : WaitsOrRuns(o) }
    IN  \E merged \in MergedAmong(busy), unsaid \in UnreportedAmong(blocked),
           quiet \in Quietly(fault, now) :
        \E caught \in IF quiet \/ fault = SkippedByDaylight
                     THEN {skipped \ (blocked \cup merged)}
                      ELSE CaughtUpOf(skipped \ (blocked \cup merged)) :
          LET absent == IF quiet THEN skipped
                        ELSE IF SkipOfMissingObIsSilent THEN skipped \ loaded
                        ELSE {}
              late == (skipped \ unsaid) \ absent
              runs == CatchUps(fault, caught, IF quiet THEN {} ELSE absent)
              kept == WithCatchUps(RequestsMerged(merged), runs)
          IN  IF late = {} THEN RequestsBecome(kept)
              ELSE TimeErrorOccurs(kept, requests,
                     [ TimeError(fault, late, 0, 0) EXCEPT
                         !.since = TimeOfSkip(skipped, now) ])

(* [AMB-53] In STARTUP the runs may also be deferred without OB 80. *)
\* @type: Set(Int) => Bool;
Defer(skipped) ==
    LET runs == { TodRequest(o, NextSkipped(tod[o]), 0)
                  : o \in { s \in skipped : ~PendingIn(requests, s)
                                            /\ ~Blocked(s) } }
    IN  RequestsBecome(WithCatchUps(requests, runs))

-----------------------------------------------------------------------------
(* Points that passed before HOLD ends, or in STOP *)

(* [AMB-83] [AMB-26] The setting of an OB whose next point passed in HOLD  *)
(* before the clock was set back, or in STOP: OB 80 has reported the       *)
(* point. A one-shot interrupt is not armed again [CLK-12].                *)
\* @type: (Int, $moment, $cpu) => $tod;
AfterHeld(o, to, c) ==
    LET t == [tod[o] EXCEPT !.held = FALSE]
        u == AfterRunFor(o, t, t.next, t)
    IN  AfterPoint(o, IF HasOnePoint(u.period) THEN [u EXCEPT !.next = Never]
                      ELSE Armed(u, to, c))

(* [AMB-26] [CLK-02] [T15-120] The points that passed in STOP are noticed, *)
(* in STARTUP or when RUN begins: OB 80 reports them.                      *)
NoticesPassed ==
    /\ resume.due /\ Watching
    /\ resume' = [resume EXCEPT !.due = FALSE]
    /\ IF Held = {} THEN Nothing
       ELSE Skip(IF Family.missesInStop THEN SkippedInHold ELSE SkippedByClock,
                 clock, Held)
    /\ \E c \in CpusThatShow({ tod[o] : o \in Held }, clock) :
         /\ cpu' = c
         /\ tod' = [ o \in DOMAIN tod |->
                       IF o \in Held THEN AfterHeld(o, clock, c) ELSE tod[o] ]
    /\ UNCHANGED <<loaded, mode, startup, clock, dint, irt, runVars>>
=============================================================================

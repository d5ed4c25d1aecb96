------------------------------ MODULE Elapsing ------------------------------
(***************************************************************************)
(* Time elapses from one line of a log to the next.  On the way start      *)
(* points are reached, delays end, and missing OBs are noticed.            *)
(*                                                                         *)
(* Two clocks run: `up' decides durations, the CPU clock decides moments.  *)
(* They need not agree.                                                    *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, fine points 1 and 2.               *)
(* Left out: the clock that is set between two lines (PartialLogs).        *)
(***************************************************************************)
EXTENDS Clock, Latency

-----------------------------------------------------------------------------
(* What is due now *)

(* Start points that equal the clock. *)
PointsNow ==
    IF ~Watching \/ (clock.ms # 0 /\ ~SecondsAreKept) THEN {}
    ELSE { o \in DOMAIN tod : /\ tod[o].active /\ ~tod[o].held
                              /\ NextMoment(tod[o]) = clock }

(* Delays that are over now; delays that may be over before line e. Under  *)
(* AMB-70 (a) calls in the last millisecond still see the job.             *)
OverNow == { o \in Jobs : dint[o].left = 0 }
\* @type: $event => Set(Int);
OverBefore(e) == IF CallsComeBeforeTheEnd /\ e.event # "start" THEN OverNow
                 ELSE { o \in Jobs : dint[o].left <= 1 }

MissingNow ==
    { r \in requests : MayBeMissed(r) }

(* The start event of OB o only makes it wait. *)
\* @type: Int => Bool;
OnlyWaits(o) == /\ o \in loaded /\ TakesEvents(o) /\ ~OnStack(o)
                /\ ~PendingIn(requests, o) /\ ~OpenIn(requests, o)

(* In the class of OB o another start event of this moment does more than  *)
(* make its OB wait, or calls OB 80 of that class [T15-30]. Their order    *)
(* decides which OB runs first.                                            *)
\* @type: Int => Bool;
OrderMatters(o) ==
    \E p \in PointsNow \cup OverNow :
      /\ ~OnlyWaits(p)
      /\ ClassOf(o) \in {ClassOf(p), ClassOf(TimeErrorOb)}

(* [AMB-44] (b) Missing OBs are noticed in the order of calls. A STOP      *)
(* keeps no order [AMB-87].                                                *)
\* @type: $request => Bool;
MissedInOrder(r) ==
    MissingNoticedWhenDue \/ StopsTheCpu(r) \/ HighestFirst(r)

-----------------------------------------------------------------------------
(* Open requests of one OB *)

(* A start event from outside on which only its own start depends. *)
\* @type: $request => Bool;
Outside(r) == r.ob \in ExternalObs /\ r.late = {} /\ r.follows = 0

\* @type: $request => $request;
Kind(r) == [AsItCame(r) EXCEPT !.since = At(0)]

(* Of open requests that differ only in their moment and place the first   *)
(* and the last are enough: behind the first all others still wait, and    *)
(* may do nothing; behind the last none of them does.                      *)
\* @type: Set($request) => Set($request);
FirstAndLast(q) ==
    LET many == { r \in q : r.open /\ Outside(r) }
    IN  IF Cardinality(many) < 3 THEN q
        ELSE (q \ many)
               \cup UNION { LET alike == { r \in many : Kind(r) = kind }
                            IN  { r \in alike :
                                    \/ \A s \in alike : r.rank <= s.rank
                                    \/ \A s \in alike : s.rank <= r.rank }
                            : kind \in { Kind(r) : r \in many } }

-----------------------------------------------------------------------------
(* Missing OBs, where nobody knows which start events wait (Merging)  *)

(* [OBS-20] Missing OBs that may have a request. OB 85 may come for each   *)
(* of them. The request stays: perhaps the CPU has not noticed it.         *)
PerhapsMissing ==
    IF terms.unsure = {} \/ Blocked(ProgramErrorOb) \/ ~Family.stops THEN {}
    ELSE { r \in MissingNow : /\ r.open /\ r.ob \in terms.unsure
                             /\ r.ob \in ExternalObs \ AsyncErrorObs }

(* A further OB 85 for each of them, unless there are as many already.     *)
FurtherErrors ==
    LET error(r) == AsItCame(ProgramError(r))
        alike(q, e) == Cardinality({ r \in q : AsItCame(r) = e })
    IN  { [e EXCEPT !.open = TRUE]
          : e \in { f \in { error(r) : r \in PerhapsMissing } :
                     alike(requests, f)
                       < Cardinality({ r \in PerhapsMissing :
                                         error(r) = f }) } }

PerhapsNoticed ==
    LET new   == FurtherErrors
        times == { IF WaitsAs(r) \in DOMAIN waiting THEN waiting[WaitsAs(r)]
                                                    ELSE 0
                   : r \in PerhapsMissing }
        least == CHOOSE m \in times : \A n \in times : m <= n
    IN  /\ new # {}
        /\ requests' = EnterAll(requests, new)
        /\ entered' = OpenEntries(new)
        /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                       runVars>>
        /\ NextEvent
        /\ waiting' = [ c \in Awaited' \cup WaitsGoOn |->
                          IF c \in DOMAIN waiting THEN waiting[c] ELSE least ]
        /\ Report(least)

(* [AMB-45] OB 85 may be pending already. If it is, it may report this     *)
(* missing OB as well.                                                     *)
\* @type: $request => Bool;
ReportedByTheSame(r) ==
    /\ ProgramErrorOb \in terms.unsure /\ ~OneOb85ForEach
    /\ OpenIn(requests, ProgramErrorOb)
    /\ ~PendingIn(requests, ProgramErrorOb) /\ ~OnStack(ProgramErrorOb)
    /\ ~Blocked(ProgramErrorOb) /\ r.ob \notin AsyncErrorObs
    /\ RequestsBecome(RequestsAfterCall(r))
    /\ tod' = TodAfterMissing(r)
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, runVars>>

(* [AMB-45] An OB 85 of its own, or none beside the one that waits or runs:  *)
(* an open request is both. An entry would tell.                             *)
\* @type: $request => Bool;
OwnOb85IsOpen(r) ==
    /\ ~DiagRecorded /\ ~OneOb85ForAll /\ ~OneOb85ForEach
    /\ ~(MissingIsTimeError /\ r.ob \in TodObs \cup DintObs)
    /\ r.ob \notin AsyncErrorObs \cup {70, 72}
    /\ ProgramErrorOb \in loaded /\ ~Blocked(ProgramErrorOb)
    /\ \/ r.open \/ OnStack(ProgramErrorOb)
       \/ PendingIn(requests, ProgramErrorOb)

\* @type: $request => Bool;
MissingOpenly(r) ==
    LET error == [ProgramError(r) EXCEPT !.open = TRUE]
    IN  /\ MayBeMissed(r)
        /\ requests' = Enter(RequestsAfterCall(r), error)
        /\ entered' = OpenEntries({error})
        /\ tod' = TodAfterMissing(r)
        /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, stopCause,
                       runVars>>

FindMissing ==
    \/ \E r \in FirstAndLast(MissingNow \ PerhapsMissing) :
         /\ MissedInOrder(r)
         /\ IF OwnOb85IsOpen(r) THEN MissingOpenly(r)
            ELSE Missing(r) \/ ReportedByTheSame(r)
         /\ RewaitMissing(r)
    \/ PerhapsNoticed

(* [AMB-55] An open request may turn out to have no effect just before the *)
(* next start point of its OB. Without it a lost point ends a one-shot     *)
(* interrupt.                                                              *)
DropsBeforePoint ==
    \E r \in requests : r.ob \in PointsNow /\ Drop(r) /\ Rewait

-----------------------------------------------------------------------------
(* Points without effect *)

(* An OB that may start at once starts within the latency, and so comes a  *)
(* STOP. Of a point before this moment line e sees neither.                *)
\* @type: $event => $moment;
Settled(e) == After(e.at, -terms.latency)

(* [AMB-18] Another start event of a waiting OB adds nothing to its        *)
(* crowds, which stand for any number of points; an error for which OB 80  *)
(* may start at once is over when the latency is.                          *)
\* @type: (Int, $event) => Bool;
Repeats(o, e) ==
    LET \* @type: $request => Bool;
        has(r) == \E q \in requests : /\ q.ob = r.ob /\ q.cause = r.cause
                                      /\ q.fault = r.fault /\ IsCrowd(q)
        again  == TodRequest(o, clock, 0)
        errors == EnterAll(requests, WithObToRun(ErrorsOf(again))) \ requests
    IN  /\ DOMAIN terms.crowds # {} /\ SecondRequestIsOpen /\ ~DiagRecorded
        /\ Before(clock, Settled(e))
        /\ PendingIn(requests, o) /\ ~OnStack(o) /\ TakesEvents(o)
        /\ has(again) /\ \A r \in errors : has(r) \/ MayStart(r)

(* The minutes from point to point; 0 where they are not always as many.   *)
\* @type: $tod => Int;
MinutesBetween(t) ==
    CASE SeriesOf(t.period) = Minutely  -> 1
      [] SeriesOf(t.period) = Hourly    -> 60
      [] SeriesOf(t.period) = Daily     -> MinutesADay
      [] SeriesOf(t.period) \in Weekly -> 7 * MinutesADay
      [] OTHER                          -> 0

(* All points up to a moment can be merged in one step [AMB-56].           *)
\* @type: Int => Bool;
MayMergeAll(o) == ~Remembers \/ MinutesBetween(tod[o]) > 0

(* [IRT-04] [AMB-35] The OBs whose next points have no effect: the start   *)
(* event is lost without an entry, deferred in STARTUP to a run that waits *)
(* already, or added to a crowd. There may be millions of them before the  *)
(* next line.                                                              *)
\* @type: $event => Set(Int);
PassedOver(e) ==
    IF ~Watching THEN {}
    ELSE { o \in DOMAIN tod :
             /\ tod[o].active /\ ~HasOnePoint(tod[o].period)
             /\ clock.min > tod[o].repeatTo /\ ~tod[o].held
             /\ \/ Blocked(o) /\ EntriesOfLost(o) = {}
                \/ RunIsDeferred(o) /\ StartupDefersOneRun /\ MayMergeAll(o)
                \/ Repeats(o, e) /\ MayMergeAll(o) }

(* Up to this moment they have none.                                       *)
\* @type: $event => $moment;
PassedUpTo(e) == IF \E o \in PassedOver(e) : Repeats(o, e) THEN Settled(e)
                                                          ELSE e.at

(* The setting of OB o when all its points before moment m are over.       *)
\* @type: (Int, $moment) => $tod;
PassedUntil(o, m) ==
    LET t    == tod[o]
        from == IF m.ms > t.offset THEN m.min + 1 ELSE m.min
        step == MinutesBetween(t)
        last == t.next + ((from - 1 - t.next) \div step) * step
        over == IF Blocked(o) \/ ~Remembers THEN t
                ELSE Merged(t, [from |-> t.next, to |-> last])
    IN  IF ~Before(NextMoment(t), m) THEN t
        ELSE [over EXCEPT !.next = PointFrom(t, from)]

\* @type: ($event, $moment) => Bool;
PassesNoOther(e, t) ==
    \A o \in DOMAIN tod \ PassedOver(e) :
      tod[o].active => \/ /\ ~Before(NextMoment(tod[o]), t)
                          /\ clock # NextMoment(tod[o])
                       \/ tod[o].held

(* Time passes, as in TimePasses, and points without effect pass with it. *)
\* @type: ($event, $moment, Int) => Bool;
PassesOver(e, t, d) ==
    /\ Before(clock, t) /\ PassesNoOther(e, t) /\ PassesNoDelay(d)
    /\ clock' = t
    /\ tod' = [ o \in DOMAIN tod |->
                  IF o \in PassedOver(e) THEN PassedUntil(o, t) ELSE tod[o] ]
    /\ dint' = JobsAfter(d)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, irt, outcomeVars, runVars>>

-----------------------------------------------------------------------------
(* The moment of a line *)

(* A line whose `at' is written in seconds or minutes stands for any       *)
(* moment of that step.                                                    *)
\* @type: $event => Bool;
IsOver(e) == Before(EndOfStep(e), clock)
\* @type: $event => Bool;
InStep(e) == e.step > 1 /\ ~Before(clock, e.at) /\ ~IsOver(e)

(* Without a counter, time elapses as the clock goes on from here.         *)
\* @type: $event => Bool;
Arrived(e) ==
    /\ clock = e.at \/ InStep(e)
    /\ up = e.up \/ (e.counter = NoMoment /\ Before(e.up, up))

(* Line e with the moment at which it may come first.                      *)
\* @type: $event => $event;
AtFirst(e) ==
    LET at == IF InStep(e) THEN clock ELSE e.at
        to == Shifted(up, clock, at)
    IN  [ e EXCEPT !.at = at,
                   !.up = IF e.counter = NoMoment /\ Before(@, to) THEN to
                                                                   ELSE @ ]

(* The same with a later moment of its step, up to which time elapses.     *)
\* @type: ($event, $moment) => $event;
AtLater(e, m) ==
    [ e EXCEPT !.at = m,
               !.up = IF e.counter # NoMoment THEN @
                                             ELSE Shifted(up, clock, m) ]

(* The moment of its step that its counter tells, as long as the clocks    *)
(* agree.                                                                  *)
\* @type: $event => $moment;
ByCounter(e) ==
    LET since == IF pace.up = NoMoment THEN At(0) ELSE pace.up
        m     == Shifted(pace.reads, since, e.counter)
    IN  IF e.step = 1 \/ Before(m, e.at) THEN e.at
        ELSE IF Before(EndOfStep(e), m) THEN EndOfStep(e) ELSE m

(* It decides how far the clock is set, which points of STEP 7 are past at *)
(* a restart [OBS-50], and of the points within the step [AMB-14] (c)      *)
(* which have come; for a call that may arm a point, whether the one at    *)
(* the begin of the step is past.                                          *)
\* @type: $event => Set($moment);
MomentsByCounter(e) ==
    LET m     == ByCounter(e)
        arms  == e.event \in {"SET_TINT", "SET_TINTL", "ACT_TINT"}
        \* @type: $tod => Bool;
        comes(t) == /\ t.active /\ ~t.held
                    /\ ~Before(NextMoment(t), clock)
                    /\ ~Before(m, NextMoment(t))
    IN  CASE e.event \in {"clock", "restart"}           -> {m}
          [] SecondsAreKept /\ arms                    -> {m}
          [] SecondsAreKept /\ \E o \in DOMAIN tod : comes(tod[o]) -> {m}
          [] clock.ms = 0 /\ arms /\ Before(clock, m)  -> {After(clock, 1)}
          [] OTHER                                     -> {}

(* A line in its step whose moment is known follows: what this one begins  *)
(* may last until then, or be waited for since then, for the latency.      *)
\* @type: $event => Set($moment);
MomentsBefore(e) ==
    LET ends  == e.event = "SRT_DINT" /\ e.dtime > 0 /\ e.dtime < e.step
        spans == IF ends THEN {0, e.dtime} ELSE {0}
    IN  IF e.until = NoMoment THEN {}
        ELSE UNION { { After(e.until, -d),
                       After(e.until, -d - terms.latency) } : d \in spans }

(* Later moments that make a difference: the end of the step; the first ms *)
(* behind a point, also where a call may arm one that has seconds          *)
(* [AMB-14] (c); where a delay is started, the moment from which it ends   *)
(* as another step begins; and those before a line whose moment is known.  *)
\* @type: $event => Set($moment);
LaterMoments(e) ==
    LET last  == e.step - 1
        point == clock.ms = 0 \/ e.event \in {"SET_TINTL", "ACT_TINT"}
        ends  == IF e.event # "SRT_DINT" \/ e.dtime <= 0 THEN {}
                 ELSE {last - ((e.dtime - 1) % e.step)}
        ms    == {last} \cup (IF point THEN {1} ELSE {}) \cup ends
        all   == IF e.counter # NoMoment THEN MomentsByCounter(e)
                 ELSE { After(e.at, d) : d \in ms } \cup MomentsBefore(e)
    IN  IF ~InStep(e) THEN {} ELSE { m \in all : Before(clock, m) }

-----------------------------------------------------------------------------
(* How far time can elapse in one step *)

(* The next start point, on the CPU clock. *)
\* @type: $event => $moment;
NextPointDue(e) ==
    LET obs == { p \in DOMAIN tod \ PassedOver(e) :
                   tod[p].active /\ ~tod[p].held }
        n   == { NextMoment(tod[o]) : o \in obs }
    IN  CHOOSE m \in n : \A k \in n : ~Before(k, m)

(* The end of the next delay, on the clock of `up'.                        *)
NextDelayOver ==
    LET n == { dint[o].left : o \in Jobs }
    IN  After(up, CHOOSE m \in n : \A k \in n : m <= k)

(* The moment on the clock of `up' at which the CPU clock is at b, on the  *)
(* way to line e. The clocks differ a little, so two moments come into     *)
(* question: one counted from now, one counted back from the line. The     *)
(* later one counts.                                                       *)
\* @type: ($moment, $event) => $moment;
UpAt(b, e) ==
    LET forward  == Shifted(up, clock, b)
        backward == Shifted(e.up, e.at, b)
        later    == IF Before(forward, backward) THEN backward ELSE forward
    IN  IF Before(later, e.up) THEN later ELSE e.up

-----------------------------------------------------------------------------
(* Steps *)

(* Time elapses to `until' on the clock of `up', and to `to' on the CPU    *)
(* clock, towards line e.                                                  *)
\* @type: ($event, $moment, $moment) => Bool;
ElapseTo(e, until, to) ==
    LET d == Span(up, until)
    IN  /\ InTime(d)
        /\ waiting' = [c \in DOMAIN waiting |-> waiting[c] + d]
        /\ reports' = ReportsAfter(d)
        /\ UNCHANGED eventVars
        /\ up' = until
        /\ IF to # clock
           THEN IF PassedOver(e) = {} THEN TimePasses(to, d)
                ELSE PassesOver(e, to, d)
           ELSE /\ dint' = JobsAfter(d)
                /\ NothingEntered
                /\ UNCHANGED <<deviceVars, modeVars, clock, tod, irt,
                               outcomeVars, runVars>>

(* Time elapses towards line e, but not beyond the next start point or the *)
(* next end of a delay.                                                    *)
\* @type: $event => Bool;
Advance(e) ==
    LET goal     == PassedUpTo(e)
        straight == clock = e.at \/ ~Watching \/ PassesNoOther(e, goal)
        point == IF straight THEN goal ELSE NextPointDue(e)
        there == IF point = e.at THEN e.up ELSE UpAt(point, e)
        over  == IF Jobs = {} THEN there ELSE NextDelayOver
        until == IF Before(over, there) THEN over ELSE there
        by    == After(clock, Span(up, until))
        to    == IF until = there \/ clock = e.at \/ ~Before(by, point)
                 THEN point ELSE by
        stale == IF requests = {} THEN {} ELSE Stale(Span(up, until))
    IN  IF stale # {} THEN Expire(stale) ELSE ElapseTo(e, until, to)

\* @type: Set(Int) => Int;
Least(obs) == CHOOSE o \in obs : \A p \in obs : o <= p

(* A missing OB can be noticed at line e as well as now.                     *)
\* @type: $event => Bool;
MissingMayWait(e) ==
    LET d == IF Before(e.up, up) THEN 0  \* a line without a moment (Likewise)
             ELSE Span(up, e.up)
        \* @type: $request => Bool;
        old(q) == Span(arrivals[AsItCame(q)], up) > terms.latency
        ages(q) == Span(arrivals[AsItCame(q)], up) + d > terms.latency
    IN  /\ terms.latency > 0 /\ ~NothingStandsBefore /\ ~Partial
        /\ mode = "RUN" /\ stack # <<>>
        /\ PointsNow = {} /\ OverBefore(e) = {}
        /\ clock = e.at \/ PassesNoOther(e, e.at)
        /\ Jobs = {} \/ Before(e.up, NextDelayOver)
        /\ InTime(d)
        /\ \A q \in MayStartNow : old(q) \/ ~ages(q)

(* Points before line e: by number, and by any order where OB 80 is called *)
(* in the class of one of them.                                            *)
NextPoints ==
    IF \E o \in PointsNow : ClassOf(o) = ClassOf(TimeErrorOb)
                              /\ OrderMatters(o)
    THEN PointsNow ELSE {Least(PointsNow)}

(* One step towards line e.                                                *)
\* @type: $event => Bool;
Towards(e) ==
    /\ UNCHANGED lineVars
    /\ IF resume.due /\ mode = "RUN"
       THEN NoticesPassed /\ Rewait /\ UNCHANGED up
       ELSE IF PointsNow # {} /\ clock # e.at
       THEN /\ UNCHANGED up
            /\ \/ \E o \in NextPoints : PointReached(o) /\ Rewait
               \/ DropsBeforePoint
       ELSE IF OverNow # {} /\ up # e.up
       THEN DelayElapses(Least(OverNow)) /\ Rewait /\ UNCHANGED up
       ELSE \/ ~MissingMayWait(e) /\ FindMissing /\ UNCHANGED up
            \/ Advance(e)

(* Time elapses on in the step of line e.                                  *)
\* @type: $event => Bool;
Lingers(e) == \E m \in LaterMoments(e) : Towards(AtLater(e, m))
=============================================================================

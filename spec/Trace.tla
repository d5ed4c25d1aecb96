-------------------------------- MODULE Trace -------------------------------
(***************************************************************************)
(* The specification as the explanation of a log, one line at a time.      *)
(*                                                                         *)
(* A line is an event record, Begin takes the header.  Before a line is    *)
(* observed time elapses to it, start points and ends of delays on the way *)
(* are reached, and hidden steps may happen: what a log never shows.  This *)
(* module takes a log that shows everything else; module Unrecorded adds   *)
(* the kinds of event that a log may leave out, and gives the trace        *)
(* checker's engine its operators.                                         *)
(*                                                                         *)
(* Other than in System an OB that may start need not start at once, but   *)
(* within the latency that the header states (AMB-69), and inside it a     *)
(* lower class may start first.                                            *)
(* Source: docs/log-format.md with its fine points; AMB-69.                *)
(***************************************************************************)
EXTENDS StartInfo

VARIABLES
    (* latency: ms from the moment an OB may start until it starts; cycle:  *)
    (* every start and end of OB 1 is in the log; records: the kinds of     *)
    (* event that are.                                                      *)
    \* @type: $terms;
    terms,
    (* Time elapsed since the log began, on a clock that nobody sets. *)
    \* @type: $moment;
    up,
    (* For each priority class with an OB that may start, and StopDuty for  *)
    (* a STOP that must come: the ms since when.                            *)
    \* @type: Int -> Int;
    waiting,
    (* "warm" or "cold": the restart whose first OB 1 is still to come;     *)
    (* "none" when it has come; "unknown" in a log that begins in RUN.      *)
    \* @type: Str;
    first,
    (* What was entered in the diagnostic buffer and has not been seen in   *)
    (* the log: for each entry how often, and the ms since when, if such    *)
    (* lines are recorded.                                                  *)
    \* @type: Set($report);
    reports

traceVars == <<terms, up, waiting, first, reports>>

StopDuty == 99

-----------------------------------------------------------------------------
(* The header *)

(* The state before a header is read. *)
Init ==
    /\ cpu = [ family |-> "", priority |-> [o \in {} |-> 0],
               step7 |-> [o \in {} |-> NoParameters],
               readings |-> [a \in {} |-> ""] ]
    /\ loaded = {} /\ mode = "STOP" /\ startup = "none" /\ clock = At(0)
    /\ tod = [o \in {} |-> NoSetting] /\ dint = NoJobs /\ irt = NoneBlocked
    /\ requests = {} /\ stack = <<>> /\ delay = 0 /\ stopCause = NoCause
    /\ entered = {}
    /\ terms = [latency |-> 0, cycle |-> FALSE, records |-> {}]
    /\ up = At(0) /\ waiting = [c \in {} |-> 0] /\ first = "unknown" /\ reports = {}

(* What the header says goes before its profile. *)
\* @type: $header => Set(<<Str, Str>>);
ReadingsOf(h) ==
    h.readings \cup { p \in Profile(h.profile) :
                        ~\E r \in h.readings : r[1] = p[1] }

\* @type: $header => $cpu;
CpuOf(h) ==
    [ family   |-> h.cpu,
      priority |-> [ o \in { p[1] : p \in h.priority } |->
                       (CHOOSE p \in h.priority : p[1] = o)[2] ],
      readings |-> [ a \in { r[1] : r \in ReadingsOf(h) } |->
                       (CHOOSE r \in ReadingsOf(h) : r[1] = a)[2] ],
      step7    |-> [ o \in TodObs |->
                       IF \E p \in h.step7 : p.ob = o
                       THEN LET s == CHOOSE p \in h.step7 : p.ob = o
                            IN  [ execution |-> s.execution,
                                  start |-> s.start, active |-> s.active,
                                  deselected |-> s.deselected ]
                       ELSE NoParameters ] ]

(* In RUN a once that STEP 7 set in the past has been called already, and   *)
(* so may a point have been that equals the clock.                         *)
\* @type: ($header, Int, Int) => $tod;
TodAtBegin(h, o, called) ==
    LET t == Configured(CpuOf(h).step7[o])
        n == PointFrom(t, h.clock.min + (IF h.clock.ms = 0 THEN called ELSE 1))
    IN  IF ~t.active THEN t
        ELSE IF h.mode = "RUN" /\ t.period = Once /\ n = Never THEN UsedUp(t)
        ELSE [t EXCEPT !.next = n]

(* In STOP nothing is set before the restart.  In STARTUP and RUN the CPU   *)
(* is found after a restart; which one is not known.  What STEP 7 sets is   *)
(* read by the letters of this header: hence the primes.                   *)
\* @type: $header => Bool;
Begin(h) ==
    /\ cpu'    = CpuOf(h)
    /\ loaded' = h.obs
    /\ mode'   = h.mode
    /\ startup' \in IF h.mode = "STARTUP" THEN {"warm", "cold"} ELSE {"none"}
    /\ clock'  = h.clock
    /\ \E called \in IF h.mode = "RUN" /\ h.clock.ms = 0 THEN {0, 1} ELSE {0} :
         tod' = [ o \in TodObs |-> IF h.mode = "STOP" THEN NoSetting
                                   ELSE TodAtBegin(h, o, called)' ]
    /\ dint' = NoJobs
    /\ irt' = NoneBlocked
    /\ requests' = IF h.mode # "STARTUP" THEN {} ELSE RestartRequests'
    /\ stack'  = IF h.mode = "RUN" THEN <<Frame(CycleOb, 1)>> ELSE <<>>
    /\ delay'  = 0
    /\ stopCause' = IF h.mode = "STARTUP" THEN RestartStop' ELSE NoCause
    /\ NothingEntered
    /\ terms'  = [latency |-> h.latency, records |-> h.records,
                  cycle |-> h.cycle /\ "ob" \in h.records]
    /\ up'     = At(0)
    /\ waiting' = [c \in {} |-> 0]
    /\ first'  = IF h.mode = "STARTUP" THEN startup' ELSE "unknown"
    /\ reports' = {}

-----------------------------------------------------------------------------
(* Waiting OBs *)

(* What is open is waited for apart: it need not come. *)
\* @type: $request => Int;
WaitsAs(r) == IF r.open THEN r.class + 100 ELSE r.class

Awaited == { WaitsAs(r) : r \in { q \in requests : MayStart(q) } }
             \cup (IF StopIsDue THEN {StopDuty} ELSE {})

(* Kinds of event that a log shows unless its header says otherwise. *)
Kinds == {"call", "ob", "clock", "mode", "interrupt", "load"}
Partial == ~(Kinds \subseteq terms.records)
DiagRecorded == "diag" \in terms.records

(* Where calls or changes of mode are not recorded, or neither OBs nor what  *)
(* starts them, nothing has to come within the latency: an OB may be held  *)
(* back by something unseen.                                               *)
Unbound == \/ ~({"call", "mode"} \subseteq terms.records)
           \/ {"ob", "interrupt"} \cap terms.records = {}

(* What enters an id in the diagnostic buffer may be unseen; DIS_IRT alone   *)
(* enters that entries are disabled.                                       *)
\* @type: Int => Bool;
CauseUnseen(id) == ~((IF id = EntriesDisabled THEN {"call"} ELSE Kinds \ {"load"})
                       \subseteq terms.records)

(* Only what a line of the log could tell is kept.  Where no line need      *)
(* tell, neither what was active nor how sure the entry is, and more than  *)
(* two of a kind are many.                                                 *)
\* @type: $entry => $entry;
AsReported(entry) ==
    LET told == [entry EXCEPT !.of.since = At(0), !.of.rank = 0, !.of.open = FALSE]
    IN  IF DiagRecorded THEN told
        ELSE [told EXCEPT !.open = FALSE, !.of.during = -1]

Many == 3

\* @type: Int => Int;
OneMore(times) == IF DiagRecorded \/ times < Many THEN times + 1 ELSE Many
\* @type: Int => Int;
OneLess(times) == IF DiagRecorded \/ times < Many THEN times - 1 ELSE Many

(* What this step enters is to be seen; its cause was `age' ms ago.  Where   *)
(* causes may be unseen, entries are not matched one by one.               *)
\* @type: Int => Bool;
Report(age) ==
    LET new == { AsReported(n) : n \in { m \in entered' : /\ m.id \in JudgedEntries
                                                           /\ ~CauseUnseen(m.id) } }
        a   == IF DiagRecorded THEN age ELSE 0
        same(n) == { r \in reports : r.entry = n /\ r.age = a }
        times(n) == IF same(n) = {} THEN 1 ELSE OneMore((CHOOSE r \in same(n) : TRUE).times)
    IN  reports' = IF new = {} THEN reports
                   ELSE (reports \ UNION { same(n) : n \in new })
                          \cup { [entry |-> n, age |-> a, times |-> times(n)]
                                 : n \in new }

(* OB 1 starts, or a restart begins. *)
NextFirst ==
    first' = IF mode = "STOP" /\ mode' = "STARTUP" THEN startup'
             ELSE IF stack = <<>> /\ OnStack(CycleOb)' THEN "none" ELSE first

(* Waiting goes on for what still may start, and begins for what now may.   *)
Rewait ==
    /\ NextFirst
    /\ waiting' = IF Unbound \/ (requests' = {} /\ stopCause' = NoCause)
                  THEN [c \in {} |-> 0]
                  ELSE [ c \in Awaited' |->
                           IF c \in DOMAIN waiting THEN waiting[c] ELSE 0 ]
    /\ Report(0)

(* An OB that is found missing has kept OB 85, or the STOP, waiting.        *)
\* @type: $request => Bool;
RewaitMissing(r) ==
    LET since == IF WaitsAs(r) \in DOMAIN waiting THEN waiting[WaitsAs(r)] ELSE 0
    IN  /\ UNCHANGED first
        /\ waiting' = [ c \in Awaited' |->
                          LET before == IF c \in DOMAIN waiting THEN waiting[c]
                                                                ELSE 0
                          IN  IF c > r.class /\ since > before THEN since
                                                               ELSE before ]
        /\ Report(since)

-----------------------------------------------------------------------------
(* Time elapses *)

(* The moment on the clock of `up' when the CPU clock, now at a, is at b;   *)
(* not beyond the moment `last'.                                           *)
\* @type: ($moment, $moment, $moment) => $moment;
UpAt(a, b, last) ==
    LET t == Shifted(up, a, b) IN IF Before(t, last) THEN t ELSE last

(* Start points that equal the clock. *)
PointsNow ==
    IF ~Watching \/ (clock.ms # 0 /\ ~SecondsAreKept) THEN {}
    ELSE { o \in DOMAIN tod : tod[o].active /\ NextMoment(tod[o]) = clock }

(* Delays that are over now, and those that may be over before the line e.  *)
(* Under AMB-70 (a) calls in the last millisecond still see the job.       *)
OverNow == { o \in Jobs : dint[o].left = 0 }
\* @type: $event => Set(Int);
OverBefore(e) == IF CallsComeBeforeTheEnd /\ e.event # "start" THEN OverNow
                 ELSE { o \in Jobs : dint[o].left <= 1 }

\* @type: Int => Bool;
InTime(d) ==
    /\ { c \in DOMAIN waiting : waiting[c] + d > terms.latency /\ c < 100 } = {}
    /\ \/ reports = {} \/ ~DiagRecorded
       \/ { r \in reports : /\ ~r.entry.open
                            /\ r.entry.id \in DemandedEntries
                            /\ r.age + d > terms.latency } = {}

(* What was entered grows older; what need not come is forgotten. *)
\* @type: Int => Set($report);
ReportsAfter(d) ==
    IF reports = {} \/ ~DiagRecorded THEN reports
    ELSE { [r EXCEPT !.age = @ + d]
           : r \in { q \in reports : q.age + d <= terms.latency } }

(* What was open and could have started, but has not in time. *)
\* @type: Int => Set($request);
Stale(d) ==
    { r \in requests : /\ r.open
                       /\ WaitsAs(r) \in DOMAIN waiting
                       /\ waiting[WaitsAs(r)] + d > terms.latency
                       /\ MayStart(r) }

\* @type: Set($request) => Bool;
Expire(stale) ==
    /\ requests' = Close(requests \ stale)
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, stack,
                   delay, stopCause>>
    /\ Rewait
    /\ UNCHANGED up

(* The moments of the next start point, and of the next end of a delay on   *)
(* the clock of `up'.                                                      *)
NextPointDue ==
    LET n == { NextMoment(tod[o]) : o \in { p \in DOMAIN tod : tod[p].active } }
    IN  CHOOSE m \in n : \A k \in n : ~Before(k, m)

\* @type: ($moment, Int) => $moment;
After(t, ms) == [ min |-> t.min + ((t.ms + ms) \div 60000),
                  ms  |-> (t.ms + ms) % 60000 ]

NextDelayOver ==
    LET n == { dint[o].left : o \in Jobs }
    IN  After(up, CHOOSE m \in n : \A k \in n : m <= k)

(* Time elapses to `until' on the clock of `up', the CPU clock to `to'. *)
\* @type: ($moment, $moment) => Bool;
ElapseTo(until, to) ==
    LET d == Span(up, until)
    IN  /\ InTime(d)
        /\ waiting' = [c \in DOMAIN waiting |-> waiting[c] + d]
        /\ reports' = ReportsAfter(d)
        /\ UNCHANGED first
        /\ up' = until
        /\ IF to # clock THEN TimePasses(to, d)
           ELSE /\ dint' = JobsAfter(d)
                /\ NothingEntered
                /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, irt,
                               requests, stack, delay, stopCause>>

(* Time elapses towards the line e, no further than to the next start point *)
(* or end of a delay.  Durations are those of `up', moments those of the   *)
(* clock; the two need not agree.                                          *)
\* @type: $event => Bool;
Advance(e) ==
    LET straight == clock = e.at \/ PassesNoPoint(e.at)
        point == IF straight THEN e.at ELSE NextPointDue
        there == IF straight THEN e.up ELSE UpAt(clock, point, e.up)
        over  == IF Jobs = {} THEN there ELSE NextDelayOver
        until == IF Before(over, there) THEN over ELSE there
        by    == After(clock, Span(up, until))
        to    == IF until = there \/ clock = e.at \/ ~Before(by, point)
                 THEN point ELSE by
        stale == IF requests = {} THEN {} ELSE Stale(Span(up, until))
    IN  IF stale # {} THEN Expire(stale) ELSE ElapseTo(until, to)

\* @type: $event => Bool;
Arrived(e) == clock = e.at /\ up = e.up

MissingNow ==
    { r \in requests : r.ob \notin loaded /\ MayStart(r) }

FindMissing ==
    \E r \in MissingNow : Missing(r) /\ RewaitMissing(r)

\* @type: Set(Int) => Int;
Least(obs) == CHOOSE o \in obs : \A p \in obs : o <= p

(* One step towards the line e.  An OB that is found missing on the way may *)
(* leave nothing to wait for.                                              *)
\* @type: $event => Bool;
Towards(e) ==
    /\ UNCHANGED terms
    /\ IF PointsNow # {} /\ clock # e.at
       THEN PointReached(Least(PointsNow)) /\ Rewait /\ UNCHANGED up
       ELSE IF OverNow # {} /\ up # e.up
       THEN DelayElapses(Least(OverNow)) /\ Rewait /\ UNCHANGED up
       ELSE \/ FindMissing /\ UNCHANGED up
            \/ Advance(e)

-----------------------------------------------------------------------------
(* Hidden steps: what may happen just before a line and is never seen *)

(* The boundaries of the cycle and of the startup OB; the end of a cycle    *)
(* matters only where it ends a delay.                                     *)
HiddenBoundary ==
    \/ ~terms.cycle /\ CycleStarts
    \/ ~terms.cycle /\ delay > 0 /\ Len(stack) = 1 /\ End(CycleOb)
    \/ mode = "STARTUP" /\ \E o \in StartupObs : StartupStarts(o) \/ End(o)

\* @type: $event => Bool;
HiddenBefore(e) ==
    /\ UNCHANGED <<terms, up>>
    /\ \/ \E o \in PointsNow : PointReached(o) /\ Rewait
       \/ \E o \in OverBefore(e) : DelayElapses(o) /\ Rewait
       \/ FindMissing
       \/ HiddenBoundary /\ Rewait

(* Cheap to evaluate: may a hidden step be possible? *)
\* @type: $event => Bool;
HidesBefore(e) == \/ stack = <<>>
                  \/ delay > 0
                  \/ requests # {}
                  \/ mode = "STARTUP"
                  \/ PointsNow # {}
                  \/ OverBefore(e) # {}

-----------------------------------------------------------------------------
(* Lines *)

(* The event of OB 1, table 7.5: that of the first one after a restart, and  *)
(* that of the others.  Where the log begins in RUN it is not known.       *)
CycleEvents == CASE first = "warm" -> {1}
                 [] first = "cold" -> {4}
                 [] first = "none" -> {3}
                 [] OTHER          -> 1..4

\* @type: $event => Bool;
IsStart(e) ==
    CASE e.ob = CycleOb ->
           /\ Fits(e.info.priority, 1)
           /\ e.info.strt_info \in {-1} \cup CycleEvents
           /\ ~Before(clock, e.info.time)
           /\ \/ CycleStarts
              \/ /\ ~terms.cycle /\ stack = <<Frame(CycleOb, 1)>>
                 /\ delay' = 0
                 /\ NothingEntered
                 /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint,
                                irt, requests, stack, stopCause>>
      [] e.ob \in StartupObs ->
           /\ Fits(e.info.priority, 27)
           /\ e.info.strt_info \in {-1} \cup (IF e.ob = 100 THEN \h81..\h82
                                                          ELSE \h85..\h86)
           /\ ~Before(clock, e.info.time)
           /\ StartupStarts(e.ob)
      [] OTHER ->
           \E r \in { q \in requests : q.ob = e.ob /\ FitsRequest(q, e.info) } :
             Start(r)

\* @type: $event => Bool;
IsClock(e) ==
    IF e.to = clock THEN UNCHANGED cpuVars /\ NothingEntered ELSE ClockSet(e.to)

(* The cause is that of the rule, if a rule stops the CPU.  The switch may   *)
(* be turned at any time, in STOP without effect.                          *)
\* @type: $event => Bool;
IsStop(e) ==
    /\ IF mode = "STOP" THEN UNCHANGED cpuVars /\ NothingEntered ELSE Stop
    /\ \/ e.cause = -1
       \/ /\ { r \in MissingNow : ~r.open } = {}
          /\ stopCause \in {NoCause, OtherErrorOb, e.cause}
       \/ delay > 0 /\ ~StopIsNotDelayed  \* the rule may come later

(* An entry of the diagnostic buffer has a cause that was not yet reported. *)
\* @type: $event => Bool;
IsEntry(e) ==
    LET fits == { r \in reports : FitsEntry(r.entry, e) }
    IN  /\ UNCHANGED cpuVars
        /\ NothingEntered
        /\ IF e.id \notin JudgedEntries THEN UNCHANGED reports
           ELSE \E r \in { q \in fits : \A p \in fits : p.age <= q.age } :
                  reports' = (reports \ {r}) \cup
                               IF OneLess(r.times) = 0 THEN {}
                               ELSE {[r EXCEPT !.times = OneLess(@)]}

\* @type: $event => Bool;
Shows(e) ==
    /\ CASE e.event = "DIS_AIRT" ->
              \E ret \in Given(e.ret, {delay + 1}) : DisAirt(ret)
         [] e.event = "EN_AIRT" ->
              \E ret \in Given(e.ret, {NotDelayed, delay - 1}) : EnAirt(ret)
         [] e.event = "start" -> IsStart(e)
         [] e.event = "end" -> End(e.ob)
         [] e.event = "SET_TINT" ->
              \E ret \in Given(e.ret, Answers(e.ob,
                                   SetErrors(e.ob, e.sdt, e.period))) :
                SetTint(e.ob, e.sdt, e.period, ret)
         [] e.event = "CAN_TINT" ->
              \E ret \in Given(e.ret, CanAnswers(e.ob)) :
                CanTint(e.ob, ret)
         [] e.event = "ACT_TINT" ->
              \E ret \in Given(e.ret, ActAnswers(e.ob)) : ActTint(e.ob, ret)
         [] e.event = "QRY_TINT" ->
              \E ret \in Given(e.ret, Answers(e.ob, ObErrors(e.ob))) :
                QryTint(e.ob, ret, e.status)
         [] e.event = "SRT_DINT" ->
              \E ret \in Given(e.ret, Answers(e.ob, SrtErrors(e.ob, e.dtime))) :
                SrtDint(e.ob, e.dtime, e.sign, ret)
         [] e.event = "CAN_DINT" ->
              \E ret \in Given(e.ret, Answers(e.ob, CanDintErrors(e.ob))) :
                CanDint(e.ob, ret)
         [] e.event = "QRY_DINT" ->
              \E ret \in Given(e.ret, Answers(e.ob, DintErrors(e.ob))) :
                QryDint(e.ob, ret, e.status)
         [] e.event = "DIS_IRT" ->
              \E ret \in Given(e.ret, Usual(IrtErrors(e.mode, e.ob, DisModes))) :
                DisIrt(e.mode, e.ob, ret)
         [] e.event = "EN_IRT" ->
              \E ret \in Given(e.ret, Usual(IrtErrors(e.mode, e.ob, EnModes))) :
                EnIrt(e.mode, e.ob, ret)
         [] e.event = "interrupt" ->
              Interrupt(e.ob, IF e.flt_id = -1 THEN 0 ELSE e.flt_id)
         [] e.event = "clock" -> IsClock(e)
         [] e.event = "load" -> LoadedAre(loaded \cup {e.ob})
         [] e.event = "delete" -> LoadedAre(loaded \ {e.ob})
         [] e.event = "restart" -> Restart(e.type)
         [] e.event = "run" -> Run /\ stopCause = NoCause  \* [OBS-22] [OBS-25]
         [] e.event = "hold" -> Hold
         [] e.event = "release" -> Release
         [] e.event = "stop" -> IsStop(e)
         [] e.event = "diag" -> IsEntry(e)
    /\ IF e.event = "diag" THEN UNCHANGED <<waiting, first>> ELSE Rewait
    /\ UNCHANGED <<terms, up>>

(* What tells two explanations of a log apart. *)
Distinct == <<cpu.readings, loaded, mode, startup, clock, tod, dint, irt,
              requests, stack, delay, stopCause, up, waiting, first, reports>>
=============================================================================

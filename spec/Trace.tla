-------------------------------- MODULE Trace -------------------------------
(***************************************************************************)
(* The specification as the explanation of a log, one line at a time.      *)
(*                                                                         *)
(* A line is an event record, Begin takes the header.  Before a line is    *)
(* observed time elapses to it, start points on the way are reached, and   *)
(* silent steps may happen: what a log does not show.  The trace checker's *)
(* engine evaluates Begin, Elapse, Silent and Observe on the set of states *)
(* that explain the log so far; a log is accepted while that set is not    *)
(* empty.                                                                  *)
(*                                                                         *)
(* Other than in System an OB that may start need not start at once, but   *)
(* within the latency that the header states (AMB-69), and inside it a     *)
(* lower class may start first.                                            *)
(*                                                                         *)
(* Left out: kinds of event that are not recorded; events of functions     *)
(* that the specification does not have yet.                               *)
(***************************************************************************)
EXTENDS StartInfo

VARIABLES
    (* latency: ms from the moment an OB may start until it starts; cycle:  *)
    (* every start and end of OB 1 is in the log.                           *)
    \* @type: $terms;
    terms,
    (* Time elapsed since the log began, on a clock that nobody sets. *)
    \* @type: $moment;
    up,
    (* For each priority class with an OB that may start, and StopDuty for  *)
    (* a STOP that must come: the ms since when.                            *)
    \* @type: Int -> Int;
    waiting

traceVars == <<terms, up, waiting>>

StopDuty == 99

-----------------------------------------------------------------------------
(* The header *)

(* The state before a header is read. *)
Init ==
    /\ cpu = [ family |-> "", priority |-> [o \in {} |-> 0],
               step7 |-> [o \in {} |-> NoParameters],
               readings |-> [a \in {} |-> ""] ]
    /\ loaded = {} /\ mode = "STOP" /\ startup = "none" /\ clock = At(0)
    /\ tod = [o \in {} |-> NoSetting] /\ requests = {}
    /\ stack = <<>> /\ delay = 0 /\ stopCause = NoCause
    /\ terms = [latency |-> 0, cycle |-> FALSE]
    /\ up = At(0) /\ waiting = [c \in {} |-> 0]

\* @type: $header => $cpu;
CpuOf(h) ==
    [ family   |-> h.cpu,
      priority |-> [ o \in { p[1] : p \in h.priority } |->
                       (CHOOSE p \in h.priority : p[1] = o)[2] ],
      readings |-> [ a \in { r[1] : r \in h.readings } |->
                       (CHOOSE r \in h.readings : r[1] = a)[2] ],
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
        n == FirstPoint(t.start, t.period, MinuteFrom(h.clock) + called)
    IN  IF ~t.active THEN t
        ELSE IF h.mode = "RUN" /\ t.period = Once /\ n = Never THEN NoSetting
        ELSE [t EXCEPT !.next = n]

(* In STOP nothing is set before the restart.  In STARTUP and RUN the CPU   *)
(* is found after a restart; which one is not known.                       *)
\* @type: $header => Bool;
Begin(h) ==
    /\ cpu'    = CpuOf(h)
    /\ loaded' = h.obs
    /\ mode'   = h.mode
    /\ startup' \in IF h.mode = "STARTUP" THEN {"warm", "cold"} ELSE {"none"}
    /\ clock'  = h.clock
    /\ \E called \in IF h.mode = "RUN" /\ h.clock.ms = 0 THEN {0, 1} ELSE {0} :
         tod' = [ o \in TodObs |-> IF h.mode = "STOP" THEN NoSetting
                                   ELSE TodAtBegin(h, o, called) ]
    /\ requests' = IF h.mode # "STARTUP" THEN {} ELSE RestartRequests'
    /\ stack'  = IF h.mode = "RUN" THEN <<Frame(CycleOb, 1)>> ELSE <<>>
    /\ delay'  = 0
    /\ stopCause' = IF h.mode = "STARTUP" THEN RestartStop' ELSE NoCause
    /\ terms'  = [latency |-> h.latency, cycle |-> h.cycle]
    /\ up'     = At(0)
    /\ waiting' = [c \in {} |-> 0]

-----------------------------------------------------------------------------
(* Waiting OBs *)

(* What is open is waited for apart: it need not come. *)
\* @type: $request => Int;
WaitsAs(r) == IF r.open THEN r.class + 100 ELSE r.class

Awaited == { WaitsAs(r) : r \in { q \in requests : MayStart(q) } }
             \cup (IF stopCause # NoCause /\ Undelayed THEN {StopDuty} ELSE {})

(* Waiting goes on for what still may start, and begins for what now may.   *)
Rewait ==
    waiting' = IF requests' = {} /\ stopCause' = NoCause
               THEN [c \in {} |-> 0]
               ELSE [ c \in Awaited' |->
                        IF c \in DOMAIN waiting THEN waiting[c] ELSE 0 ]

(* An OB that is found missing has kept OB 85, or the STOP, waiting.        *)
\* @type: $request => Bool;
RewaitMissing(r) ==
    waiting' = [ c \in Awaited' |->
                   LET before == IF c \in DOMAIN waiting THEN waiting[c] ELSE 0
                       since  == WaitsAs(r)
                   IN  IF since \in DOMAIN waiting /\ c > r.class
                            /\ waiting[since] > before
                       THEN waiting[since] ELSE before ]

-----------------------------------------------------------------------------
(* Time elapses *)

Aeon == 1000000000

(* ms from a to b, at most an aeon (11 days), which no latency reaches. *)
\* @type: ($moment, $moment) => Int;
Span(a, b) == IF b.min - a.min > 16000 THEN Aeon
              ELSE (b.min - a.min) * 60000 + b.ms - a.ms

(* The moment on the clock of `up' when the CPU clock, now at a, is at b;   *)
(* not beyond the moment `last'.                                           *)
\* @type: ($moment, $moment, $moment) => $moment;
UpAt(a, b, last) ==
    LET ms == up.ms + b.ms - a.ms + 60000
        t  == [ min |-> up.min + b.min - a.min + (ms \div 60000) - 1,
                ms  |-> ms % 60000 ]
    IN  IF Before(t, last) THEN t ELSE last

(* Start points that equal the clock. *)
PointsNow == IF clock.ms # 0 \/ ~Watching THEN {}
             ELSE { o \in DOMAIN tod : tod[o].active /\ tod[o].next = clock.min }

\* @type: Int => Bool;
InTime(d) ==
    { c \in DOMAIN waiting : waiting[c] + d > terms.latency /\ c < 100 } = {}

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
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, stack, delay,
                   stopCause>>
    /\ Rewait
    /\ UNCHANGED <<terms, up>>

(* Time elapses to t on the clock of `up'. *)
\* @type: $moment => Bool;
ElapseTo(t) ==
    LET d == Span(up, t)
    IN  /\ InTime(d)
        /\ waiting' = [c \in DOMAIN waiting |-> waiting[c] + d]
        /\ up' = t
        /\ UNCHANGED terms

NextDue == LET n == { tod[o].next : o \in { p \in DOMAIN tod : tod[p].active } }
           IN  CHOOSE m \in n : \A k \in n : m <= k

\* @type: $event => Bool;
Arrived(e) == clock = e.at /\ up = e.up

MissingNow ==
    { r \in requests : r.ob \notin loaded /\ MayStart(r) }

FindMissing ==
    \E r \in MissingNow : Missing(r) /\ RewaitMissing(r)

(* One step towards the line e: the next start point, or the line itself.   *)
(* Durations are those of `up', moments those of the clock.  An OB that is  *)
(* found missing on the way may leave nothing to wait for.                 *)
\* @type: $event => Bool;
Elapse(e) ==
    IF PointsNow # {} /\ clock # e.at
    THEN /\ PointReached(CHOOSE o \in PointsNow :
                           \A p \in PointsNow : o <= p)
         /\ Rewait
         /\ UNCHANGED <<terms, up>>
    ELSE \/ FindMissing /\ UNCHANGED <<terms, up>>
         \/ LET straight == clock = e.at \/ PassesNoPoint(e.at)
                until    == IF straight THEN e.up
                            ELSE UpAt(clock, At(NextDue), e.up)
                stale    == IF requests = {} THEN {}
                            ELSE Stale(Span(up, until))
            IN  IF stale # {} THEN Expire(stale)
                ELSE /\ ElapseTo(until)
                     /\ IF clock = e.at THEN UNCHANGED cpuVars
                        ELSE TimePasses(IF straight THEN e.at ELSE At(NextDue))

-----------------------------------------------------------------------------
(* Silent steps: what may happen just before a line, unseen *)

(* The boundaries of the cycle and of the startup OB; the end of a cycle    *)
(* matters only where it ends a delay.                                     *)
HiddenBoundary ==
    \/ ~terms.cycle /\ CycleStarts
    \/ ~terms.cycle /\ delay > 0 /\ Len(stack) = 1 /\ End(CycleOb)
    \/ mode = "STARTUP" /\ \E o \in StartupObs : StartupStarts(o) \/ End(o)

Silent ==
    /\ UNCHANGED <<terms, up>>
    /\ \/ \E o \in PointsNow : PointReached(o) /\ Rewait
       \/ FindMissing
       \/ HiddenBoundary /\ Rewait

(* Cheap to evaluate: may a silent step be possible? *)
Stirs == \/ clock.ms = 0
         \/ stack = <<>>
         \/ delay > 0
         \/ requests # {}
         \/ mode = "STARTUP"

-----------------------------------------------------------------------------
(* Lines *)

\* @type: $event => Bool;
IsStart(e) ==
    CASE e.ob = CycleOb ->
           /\ Fits(e.info.priority, 1)
           /\ e.info.strt_info \in {-1} \cup (1..4)
           /\ \/ CycleStarts
              \/ /\ ~terms.cycle /\ stack = <<Frame(CycleOb, 1)>>
                 /\ delay' = 0
                 /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod,
                                requests, stack, stopCause>>
      [] e.ob \in StartupObs ->
           /\ Fits(e.info.priority, 27)
           /\ e.info.strt_info \in {-1} \cup (IF e.ob = 100 THEN \h81..\h82
                                                          ELSE \h85..\h86)
           /\ StartupStarts(e.ob)
      [] OTHER ->
           \E r \in { q \in requests : q.ob = e.ob /\ FitsRequest(q, e.info) } :
             Start(r)

\* @type: $event => Bool;
IsClock(e) ==
    IF e.to = clock THEN UNCHANGED cpuVars ELSE ClockSet(e.to)

(* The cause is that of the rule, if a rule stops the CPU. *)
\* @type: $event => Bool;
IsStop(e) ==
    /\ Stop
    /\ \/ e.cause = -1
       \/ /\ { r \in MissingNow : ~r.open } = {}
          /\ stopCause \in {NoCause, OtherErrorOb, e.cause}
       \/ delay > 0  \* the rule may come when the delay ends [AMB-49]

\* @type: $event => Bool;
Observe(e) ==
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
              \E ret \in Given(e.ret, Answers(e.ob, CanErrors(e.ob))) :
                CanTint(e.ob, ret)
         [] e.event = "ACT_TINT" ->
              \E ret \in Given(e.ret, ActAnswers(e.ob)) : ActTint(e.ob, ret)
         [] e.event = "QRY_TINT" ->
              \E ret \in Given(e.ret, Answers(e.ob, ObErrors(e.ob))) :
                QryTint(e.ob, ret, e.status)
         [] e.event = "interrupt" ->
              Interrupt(e.ob, IF e.flt_id = -1 THEN 0 ELSE e.flt_id)
         [] e.event = "clock" -> IsClock(e)
         [] e.event = "load" -> LoadedAre(loaded \cup {e.ob})
         [] e.event = "delete" -> LoadedAre(loaded \ {e.ob})
         [] e.event = "restart" -> Restart(e.type)
         [] e.event = "run" -> Run /\ stopCause = NoCause  \* [OBS-25]
         [] e.event = "hold" -> Hold
         [] e.event = "release" -> Release
         [] e.event = "stop" -> IsStop(e)
    /\ Rewait
    /\ UNCHANGED <<terms, up>>

Next == Silent

(* What tells two explanations of a log apart. *)
Distinct == <<cpu.readings, loaded, mode, startup, clock, tod, requests, stack,
              delay, stopCause, up, waiting>>
=============================================================================

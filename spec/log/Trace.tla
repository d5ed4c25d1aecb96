------------------------------- MODULE Trace --------------------------------
(***************************************************************************)
(* The specification explains a log one line at a time. Begin takes the    *)
(* CPU from the header. Before each further line time elapses to it        *)
(* (Towards), and hidden steps may happen (HiddenBefore). Then the line is *)
(* observed (Shows).                                                       *)
(*                                                                         *)
(* Source: docs/checking/log-format.md with its fine points; AMB-69.       *)
(* Left out: kinds of event that the log does not have completely          *)
(* (PartialLogs).                                                          *)
(***************************************************************************)
EXTENDS Lines

-----------------------------------------------------------------------------
(* The header *)

(* The state before a header is read.                                      *)
Init ==
    /\ cpu = [ family |-> "", priority |-> [o \in {} |-> 0],
               step7 |-> [o \in {} |-> NoParameters],
               readings |-> [a \in {} |-> ""],
               classes |-> [o \in {} |-> 0],
               queues |-> [o \in {} |-> NoQueue], zone |-> 0, hour |-> NoHour ]
    /\ loaded = {} /\ mode = "STOP" /\ startup = "none" /\ resume = NothingKept
    /\ clock = At(0)
    /\ tod = [o \in {} |-> NoSetting] /\ dint = NoJobs /\ irt = NoneBlocked
    /\ requests = {} /\ stack = <<>> /\ delay = 0 /\ stopCause = NoCause
    /\ entered = {}
    /\ terms = [latency |-> 0, cycle |-> FALSE, records |-> {},
                loose |-> FALSE, crowds |-> [r \in {} |-> 0],
                unsure |-> {}, early |-> {}, dropped |-> [o \in {} |-> 0]]
    /\ up = At(0) /\ waiting = [c \in {} |-> 0] /\ reports = {}
    /\ first = "unknown" /\ overruns = 0 /\ changes = {} /\ pace = NoPace
    /\ arrivals = [r \in {} |-> At(0)]

(* A letter of the header overrides the letter of its profile. *)
\* @type: $header => Set(<<Str, Str>>);
ReadingsOf(h) ==
    LET told == h.readings \cup { p \in Profile(h.profile) :
                                    ~\E r \in h.readings : r[1] = p[1] }
    IN  told \cup { p \in FamilyOf(h.cpu).letters :
                      ~\E r \in told : r[1] = p[1] }

(* [DINT-02] [OBS-06] The time-delay interrupts that STEP 7 deselects: they  *)
(* have class 0, also on a CPU whose classes are fixed.                      *)
\* @type: $header => Set(Int);
OffBy(h) ==
    { s.ob : s \in { q \in h.step7 : q.ob \in OldDintObs /\ q.deselected } }

(* [T15-10] *)
\* @type: $header => Set(Int);
TodObsOf(h) ==
    OldTodObs \cup { c[1] : c \in { d \in h.classes : d[2] = 10 } }

\* @type: $header => $cpu;
CpuOf(h) ==
    [ family   |-> h.cpu,
      priority |-> [ o \in { p[1] : p \in h.priority } \cup OffBy(h) |->
                       IF o \in OffBy(h) THEN 0
                       ELSE (CHOOSE p \in h.priority : p[1] = o)[2] ],
      readings |-> [ a \in { r[1] : r \in ReadingsOf(h) } |->
                       (CHOOSE r \in ReadingsOf(h) : r[1] = a)[2] ],
      classes  |-> [ o \in { c[1] : c \in h.classes } |->
                       (CHOOSE c \in h.classes : c[1] = o)[2] ],
      queues   |-> [ o \in { q.ob : q \in h.queue } |->
                       LET q == CHOOSE p \in h.queue : p.ob = o
                       IN  [ size |-> IF Kinds \subseteq h.records
                                      THEN q.events ELSE 0,
                             limit |-> q.threshold,
                             told |-> q.overflow ] ],
      step7    |-> [ o \in TodObsOf(h) |->
                       IF \E p \in h.step7 : p.ob = o
                       THEN LET s == CHOOSE p \in h.step7 : p.ob = o
                            IN  [ execution |-> s.execution,
                                  start |-> s.start, active |-> s.active,
                                  deselected |-> s.deselected,
                                  local |-> s.local ]
                       ELSE NoParameters ],
      zone     |-> h.zone,
      hour     |-> NoHour ]

(* If the log begins in RUN, a one-shot interrupt that STEP 7 set to a     *)
(* past moment has already run, and the earlier points of others may have  *)
(* been served or not [CLK-09]. A point that equals the clock may have     *)
(* been reached or not.                                                    *)
\* @type: ($header, $tod, Int) => $tod;
TodAtBegin(h, t, called) ==
    LET m == h.clock.min + (IF h.clock.ms = 0 THEN called ELSE 1)
        n == PointFrom(t, m)
    IN  IF ~t.active THEN t
        ELSE IF h.mode = "RUN" /\ HasOnePoint(t.period) /\ n = Never
        THEN UsedUp(t)
        ELSE IF h.mode = "RUN" /\ Remembers /\ t.start < m
        THEN [ t EXCEPT !.next = n,
                        !.merged = {[from |-> t.start, to |-> m - 1]} ]
        ELSE [t EXCEPT !.next = n]

(* Nothing tells when an OB has to start if calls, changes of the mode or  *)
(* changes of the clock may be unseen; nor if both OBs and start events    *)
(* may be unseen.                                                          *)
\* @type: $header => Bool;
LooseBy(h) == \/ ~({"call", "mode", "clock"} \subseteq h.records)
              \/ {"ob", "interrupt"} \cap h.records = {}

(* In STOP nothing is set before the restart, unless what passes in STOP   *)
(* may matter: then the parameters of STEP 7 hold. In STARTUP and RUN the  *)
(* CPU has just been restarted, warm or cold; which is not known. Some     *)
(* operators are primed: the letters of this header already decide how     *)
(* STEP 7's parameters are read.                                           *)
\* @type: $header => Bool;
Begin(h) ==
    /\ cpu' \in UNION { UNION { CpusByHardware(d) : d \in CpusByReference(c) }
                        : c \in UNION { CpusByDelays(b)
                                        : b \in CpusByLeapDay(CpuOf(h)) } }
    /\ loaded' = h.obs
    /\ mode'   = IF "mode" \in h.records THEN h.mode ELSE "RUN"
    /\ startup' \in IF h.mode = "STARTUP" THEN {"warm", "cold"} ELSE {"none"}
    /\ resume'   = NothingKept'
    /\ clock'  = h.clock
    /\ \E called \in IF h.mode = "RUN" /\ h.clock.ms = 0 THEN {0, 1} ELSE {0},
          set \in SettingsByStep7' :
         tod' = [ o \in TodObs' |->
                    IF /\ h.mode = "STOP"
                       /\ ~(HotRestartExists \/ Family.missesInStop)'
                    THEN NoSetting
                    ELSE TodAtBegin(h, set[o], called)' ]
    /\ dint' = NoJobs'
    /\ irt' = NoneBlocked
    /\ requests' = IF h.mode # "STARTUP" THEN {} ELSE RestartRequests'
    /\ stack'  = IF mode' = "RUN" THEN <<Frame(CycleOb, 1)>>
                 ELSE IF h.mode = "STARTUP" /\ LooseBy(h)
                 THEN <<Frame(StartupOb(startup'), StartupClass')>> ELSE <<>>
    /\ delay'  = 0
    /\ stopCause' = IF h.mode = "STARTUP" THEN RestartStop' ELSE NoCause
    /\ NothingEntered
    /\ terms'  = [latency |-> h.latency,
                  records |-> h.records,
                  cycle |-> h.cycle /\ "ob" \in h.records,
                  loose |-> LooseBy(h), crowds |-> [r \in {} |-> 0],
                  unsure |-> {}, early |-> {},
                  dropped |-> [o \in DOMAIN cpu'.queues |-> 0]]
    /\ up'     = At(0)
    /\ waiting' = [ c \in IF stopCause' = NoCause THEN {} ELSE {StopDuty}
                     |-> 0 ]
    /\ first'  = IF h.mode = "STARTUP" THEN startup' ELSE "unknown"
    /\ overruns' = 0
    /\ arrivals' = [r \in { AsItCame(q) : q \in requests' } |-> At(0)]
    /\ changes' = {}
    /\ pace' = [NoPace EXCEPT !.reads = h.clock]
    /\ reports' = {}

-----------------------------------------------------------------------------
(* Points and delays of the moment of a line *)

(* Line e depends on whether OB o waits, or changes its queue. *)
\* @type: ($event, Int) => Bool;
Touches(e, o) ==
    CASE e.event \in {"DIS_IRT", "EN_IRT"} -> MarkedIn(Meant(e.mode, e.ob), o)
      [] e.event = "interrupt"            -> ClassOf(e.ob) = ClassOf(o)
      [] e.event \in CallEvents \cup {"start", "end", "load", "delete",
                                      "state"} -> e.ob = o
      [] OTHER                            -> e.event \notin {"diag", "done"}

(* A start event of this moment may come before or after line e. Where the *)
(* order makes no difference, it comes after: an OB that waits later       *)
(* allows no less.                                                         *)
\* @type: ($event, Int) => Bool;
ComesBefore(e, o) ==
    \/ Partial \/ PointsComeByNumber
    \/ ~OnlyWaits(o) \/ OrderMatters(o) \/ Touches(e, o)

-----------------------------------------------------------------------------
(* Hidden steps: a log never shows them *)

(* [T15-132] Before a time error the end of OB 1 matters on an S7-1500,    *)
(* whose OB 80 tells that no OB was running. Line e makes one, or a start  *)
(* event of an OB that waits already; or in HOLD there may be one.         *)
\* @type: $event => Bool;
BoundaryIsTold(e) ==
    /\ Family.byKind /\ ~terms.cycle /\ mode = "RUN" /\ Len(stack) = 1
    /\ \/ e.event \in {"hold", "zone"}
       \/ e.event = "clock" /\ SkippedBy(e.to) # {}
       \/ /\ e.event = "interrupt"
          /\ e.ob = TimeErrorOb \/ \E r \in requests : r.ob = e.ob
       \/ \E o \in PointsNow \cup OverBefore(e) : ~OnlyWaits(o)

(* Cycle and startup OBs start and end. The end of a cycle matters only if *)
(* it ends a delay, if another cycle OB follows [T15-79], or if it is told.*)
\* @type: $event => Bool;
HiddenBoundary(e) ==
    \/ ~terms.cycle /\ \E o \in CycleObs : CycleStarts(o)
    \/ /\ ~terms.cycle /\ Len(stack) = 1
       /\ delay > 0 \/ CycleObs # {CycleOb} \/ BoundaryIsTold(e)
       /\ \E o \in CycleObs : End(o)
    \/ mode = "STARTUP" /\ \E o \in StartupObs : StartupStarts(o) \/ End(o)
    \/ resume.due /\ NoticesPassed

(* [DINT-06] *)
\* @type: $event => Bool;
EndsEarly(e) ==
    \E o \in OverBefore(e) \ OverNow :
      /\ DelayElapses(o) /\ Rewait
      /\ terms' = [ terms EXCEPT !.early =
                       EarlyDelays \cup {[ob |-> o, since |-> clock]} ]

(* A missing OB can be noticed behind line e as well as before it: the line  *)
(* makes another OB wait, of a class of its own, or calls for another OB.    *)
\* @type: $event => Bool;
LeavesMissing(e) ==
    CASE e.event = "interrupt" ->
           /\ e.ob \notin AsyncErrorObs
           /\ ~ClassIsTaken(ClassOf(e.ob))
      [] e.event \in CallEvents ->
           /\ e.event \notin {"DIS_AIRT", "EN_AIRT", "DIS_IRT", "EN_IRT"}
           /\ ~MissingNoticedAtActivation /\ ~MissingNoticedAtSrtDint
           /\ \A r \in MissingNow : r.ob # e.ob
      [] OTHER -> FALSE

\* @type: $event => Bool;
HiddenBefore(e) ==
    /\ UNCHANGED <<pace, up>>
    /\ \/ EndsEarly(e)
       \/ /\ UNCHANGED terms
          /\ \/ \E o \in PointsNow :
                  ComesBefore(e, o) /\ PointReached(o) /\ Rewait
             \/ \E o \in OverNow :
                  ComesBefore(e, o) /\ DelayElapses(o) /\ Rewait
             \/ ~(MissingMayWait(e) /\ LeavesMissing(e)) /\ FindMissing
             \/ DropsBeforePoint
             \/ HiddenBoundary(e) /\ Rewait

(* Quick to evaluate: may a hidden step be possible?                       *)
\* @type: $event => Bool;
HidesBefore(e) == \/ stack = <<>>
                  \/ delay > 0 \/ CycleObs # {CycleOb}
                  \/ requests # {}
                  \/ mode = "STARTUP" \/ resume.due
                  \/ PointsNow # {}
                  \/ OverBefore(e) # {}
                  \/ BoundaryIsTold(e)

(* Two explanations of a log differ if these values differ.                *)
Distinct == <<cpu.readings, loaded, mode, startup, resume, clock, tod, dint,
              irt, requests, stack, delay, stopCause, up, waiting, first,
              overruns, arrivals, changes, reports, terms.crowds,
              terms.unsure, terms.dropped, EarlyDelays>>

(* The same between two lines. If loading is not recorded, an OB is loaded *)
(* or deleted unseen as soon as something depends on it. So the loaded OBs *)
(* do not matter here.                                                     *)
DistinctAfterLine ==
    <<cpu.readings,
      IF Unseen("load") /\ ~DeletedObTakesRequests THEN {} ELSE loaded,
      mode, startup, resume, clock, tod, dint, irt, requests, stack, delay,
      stopCause, up, waiting, first, overruns, arrivals, changes, reports,
      terms.crowds, terms.unsure, terms.dropped, EarlyDelays>>
=============================================================================

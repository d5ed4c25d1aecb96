----------------------------- MODULE LooseLogs ------------------------------
(***************************************************************************)
(* Logs that do not tell when an OB has to start. They leave out calls,    *)
(* changes of the mode or of the clock, or both OBs and start events; or   *)
(* they have too many explanations (Merging).                              *)
(*                                                                         *)
(* Only facts that hold no matter what happened unseen are checked:        *)
(* answers that no setting allows, OBs that nothing can have started,      *)
(* classes, modes, missing OBs, start information. No start event is timed *)
(* and nothing is due, so one state explains such a log. It holds          *)
(* possibilities: `requests' has a mark for each OB that may have been     *)
(* requested; tod, dint, irt and delay are the settings by the calls in    *)
(* the log. If changes of the mode may be unseen, `mode' is always RUN and *)
(* forbids nothing.                                                        *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, fine point 9.                      *)
(* Left out: the order of requests; info.time; entries, but of DIS_IRT.    *)
(***************************************************************************)
EXTENDS Lines

-----------------------------------------------------------------------------
(* Possibilities *)

ModeKnown  == ~Unseen("mode")
StackKnown == ModeKnown /\ ~Unseen("ob")
IrtKnown   == ModeKnown /\ ~Unseen("call")
Interrupting == \E i \in 2..Len(stack) : stack[i].ob \notin SyncErrorObs

\* @type: Int => Bool;
MayBeLoaded(o) == o \in loaded \/ Unseen("load")
\* @type: Int => Bool;
MayBeMissing(o) == o \notin loaded \/ Unseen("load")

(* The mark of an OB that may have been requested.                         *)
\* @type: (Int, Int) => $request;
Mark(o, fault) == [NoRequest EXCEPT !.ob = o, !.fault = fault, !.open = TRUE]
\* @type: Int => Bool;
Marked(o) == \E r \in requests : r.ob = o

(* STEP 7 may have set the interrupt again, at an unseen restart.          *)
\* @type: Int => Bool;
SetByStep7(o) == ~ModeKnown /\ Configured(cpu.step7[o], Monthly).set

(* A one-shot interrupt may already have run; an unseen restart clears     *)
(* every setting.                                                          *)
\* @type: Int => Bool;
MayBeSet(o) == Unseen("call") \/ tod[o].set \/ SetByStep7(o)
\* @type: Int => Bool;
MayBeUnset(o) ==
    \/ Unseen("call") \/ ~tod[o].set \/ HasOnePoint(tod[o].period)
    \/ CanTintNeedsActive \/ ~ModeKnown
\* @type: Int => Bool;
MayBePast(o) == \/ Unseen("call") \/ SetByStep7(o)
                \/ tod[o].set /\ HasOnePoint(tod[o].period)

\* @type: Int => Bool;
MayBeActive(o) == \/ Unseen("call") \/ tod[o].active
                  \/ SetByStep7(o) /\ cpu.step7[o].active
\* @type: Int => Bool;
MayBeInactive(o) ==
    \/ Unseen("call") \/ ~tod[o].active \/ HasOnePoint(tod[o].period)
    \/ MayBeMissing(o) /\ MissingObEndsItsSource
    \/ ~ModeKnown \/ PointFrom(tod[o], clock.min + 1) = Never

\* @type: Int => Bool;
MayBeStarted(o) == Unseen("call") \/ dint[o].started \/ Marked(o)
\* @type: Int => Bool;
MayBeOver(o) == \/ Unseen("call") \/ ~dint[o].started
                \/ dint[o].left <= 1 \/ ~ModeKnown

(* [AIRT-04] The counts of delays. The OB may have ended unseen.           *)
Counts == {delay} \cup (IF StackKnown /\ (terms.cycle \/ Interrupting)
                        THEN {} ELSE {0})

(* [OBS-52] A hot restart, whose lines may be missing, brings back what    *)
(* was before: another count, and the OBs that ran.                        *)
HotUnseen     == ~ModeKnown /\ HotRestartExists
CountsUnknown == Unseen("call") \/ HotUnseen

(* [OBS-25] STARTUP may be over.                                           *)
MayRun == \/ Unseen("load") \/ stopCause = NoCause
          \/ ~ModeKnown /\ RestartStop = NoCause

(* Start events of the OB may have come.                                   *)
\* @type: Int => Bool;
MayBeRequested(o) ==
    /\ ~Deselected(o)
    /\ CASE o \in TodObs      -> MayBeActive(o) \/ Marked(o)
         [] o \in DintObs     -> \/ Unseen("call")
                                 \/ Marked(o)
                                 \/ dint[o].started /\ dint[o].left = 1
         [] o \in ExternalObs -> Unseen("interrupt") \/ Marked(o)
         [] OTHER             -> FALSE

(* The OBs of time-of-day and time-delay interrupts that may be due.       *)
MayBeDue == { o \in TodObs \cup DintObs : MayBeRequested(o) }
As85 == { o \in MayBeDue \cup ExternalObsAs85 : MayBeRequested(o) }
MissingMayBeRequested == \E o \in As85 : MayBeMissing(o)

-----------------------------------------------------------------------------
(* Calls *)

(* What is possible of a fact that may hold, and may not. *)
\* @type: (Bool, Bool) => Set(Bool);
Either(may, mayNot) == (IF may THEN {TRUE} ELSE {})
                         \cup (IF mayNot THEN {FALSE} ELSE {})

(* The answers of SFC 41 and 42 at any count, one at each; RET_VAL ends at *)
(* 32767. TLC takes seconds for a UNION of so many sets.                   *)
AnyDisAirtAnswer == { CHOOSE r \in DisAirtAnswers(c) : TRUE : c \in 0..32766 }
AnyEnAirtAnswer  == { CHOOSE r \in EnAirtAnswers(c) : TRUE : c \in 0..32768 }

(* [T15-103] Local time may have been set unseen, to any that a header may *)
(* name: a start by it may be past or not.                                 *)
\* @type: $event => Bool;
ByUnseenZone(e) ==
    /\ Unseen("clock")
    /\ \/ e.event = "SET_TINTL" /\ e.local = 1
       \/ e.event = "SET_TINT" /\ SdtIsLocal(e.ob)

(* The answers that some unseen events allow. *)
\* @type: $event => Set(Int);
LooseAnswers(e) ==
    LET o == e.ob
        \* @type: Set(Set(Int)) => Set(Int);
        any(errors) == UNION { Answers(o, s) : s \in errors }
    IN  CASE e.event = "CAN_TINT" /\ o \in TodObs ->
               any({ CanErrorsIf(isSet)
                     : isSet \in Either(MayBeSet(o), MayBeUnset(o)) })
          [] e.event = "ACT_TINT" /\ o \in TodObs ->
               OpenCodes(UNION {
                 SettingAnswersIf(missing, o, ActErrorsIf(isSet, isPast))
                 : missing \in Either(MayBeMissing(o), MayBeLoaded(o)),
                   isSet   \in Either(MayBeSet(o), MayBeUnset(o)),
                   isPast  \in Either(MayBePast(o), TRUE) })
          [] e.event = "CAN_DINT" /\ o \in DintObs ->
               OpenCodes(any({ CanDintErrorsIf(started)
                 : started \in Either(MayBeStarted(o), MayBeOver(o)) }))
          [] e.event = "DIS_AIRT" -> IF CountsUnknown THEN AnyDisAirtAnswer
               ELSE UNION { DisAirtAnswers(c) : c \in Counts }
          [] e.event = "EN_AIRT" -> IF CountsUnknown THEN AnyEnAirtAnswer
               ELSE UNION { EnAirtAnswers(c) : c \in Counts }
          [] ByUnseenZone(e) ->
               UNION { SetAnswers(o, e.sdt, zone, e.period)
                       : zone \in {-720, 840} }
                 \cup (IF e.event = "SET_TINT" \/ SkippedTimeIsTaken THEN {}
                       ELSE AnyCode)
          [] OTHER                -> AnswersTo(e)

\* @type: Int => Set(Bool);
LooseActive(o) == IF o \in TodObs THEN Either(MayBeActive(o), MayBeInactive(o))
                                  ELSE Either(MayBeStarted(o), MayBeOver(o))

\* @type: Int => Set(Int);
LooseStatuses(o) ==
    StatusOf(o, IF ModeKnown THEN StartupBit(o) ELSE {0, 1},
             UNION { BlockedBitIf(b, d)
                     : b \in {Blocked(o)} \cup
                         Either(Unseen("call"), Unseen("call") \/ ~ModeKnown),
                       d \in {TRUE, FALSE} },
             { IF a THEN 4 ELSE 0 : a \in LooseActive(o) },
             IF Unseen("load") THEN {0, 16} ELSE LoadedBit(o))

(* The settings that follow from the answer. *)
\* @type: ($event, Int) => (Int -> $tod);
TodAfterAnswer(e, ret) ==
    CASE e.ob \notin TodObs -> tod
      [] e.event = "CAN_TINT" /\ ret = NotSet /\ CanTintNeedsActive ->
           [tod EXCEPT ![e.ob].active = FALSE]  \* [AMB-09] it may be set
      [] \/ e.event = "CAN_TINT" /\ ret = OK
         \/ e.event \in {"CAN_TINT", "ACT_TINT"} /\ ret = NotSet ->
           [tod EXCEPT ![e.ob] = NoSetting]
      [] e.event = "ACT_TINT" /\ ret = OK ->
           [tod EXCEPT ![e.ob].set = TRUE, ![e.ob].active = TRUE]
      [] OTHER -> tod

(* If the answer is not in the log, one stands for all that set nothing.   *)
\* @type: $event => Set(Int);
AnswersTried(e) ==
    LET counts == e.event \in {"DIS_AIRT", "EN_AIRT"}
        all    == LooseAnswers(e) \cup FailuresOf(e)
        idle   == all \ {OK, NotSet}
    IN  IF e.ret # -1 THEN all \cap {e.ret}
        ELSE IF Unseen("call") \/ (counts /\ CountsUnknown) THEN {-1}
        ELSE IF counts \/ idle = {} THEN all
        ELSE (all \ idle) \cup {CHOOSE ret \in idle : TRUE}

(* Calls whose answer depends on an earlier setting. *)
\* @type: $event => Bool;
IsLooseAnswer(e) ==
    /\ \E ret \in AnswersTried(e) :
         /\ tod'   = TodAfterAnswer(e, ret)
         /\ dint'  = IF e.event = "CAN_DINT" /\ ret = OK
                     THEN [dint EXCEPT ![e.ob] = NoJob] ELSE dint
         /\ delay' = CASE CountsUnknown -> 0
                       [] \/ IsGeneralError(ret)
                          \/ e.event \notin {"DIS_AIRT", "EN_AIRT"} -> delay
                       [] OTHER -> IF ret > 32767 THEN 0 ELSE ret
    /\ e.event \in {"QRY_TINT", "QRY_DINT"} /\ e.ret = OK /\ e.status # -1 =>
         e.status \in LooseStatuses(e.ob)
    /\ Nothing /\ UNCHANGED <<deviceVars, modeVars, clock, irt, stack>>

\* @type: $event => Bool;
LooseSet(e) ==
    \E ret \in LooseAnswers(e) \cup FailuresOf(e) :
      /\ e.ret \in {-1, ret}
      /\ IF IsGeneralError(ret) THEN Fails(ret)
         ELSE IF e.event = "SET_TINT"
         THEN SetTint(e.ob, e.sdt, e.period, ret)
         ELSE SetTintL(e.ob, e.sdt, TRUE, e.period, e.activate = 1, ret)

(* [A15-13] What an S7-1500 answers depends on whether the OB is loaded,   *)
(* which no line tells.                                                    *)
\* @type: $event => Bool;
AnswerNeedsLoad(e) ==
    /\ Unseen("load") /\ ~Family.stops /\ e.ob \in TodObs \cup DintObs
    /\ e.event \in {"SET_TINT", "SET_TINTL", "SRT_DINT"}

\* @type: $event => Bool;
LooseUnseenLoad(e) ==
    /\ AnswerNeedsLoad(e)
    /\ loaded' = (loaded \ {e.ob}) \cup ({e.ob} \ loaded)
    /\ NothingEntered
    /\ UNCHANGED <<cpu, modeVars, clock, settingVars, outcomeVars, runVars,
                   up, waiting, reports, lineVars, eventVars>>

\* @type: $event => Bool;
LooseCall(e) ==
    /\ Called
    /\ IF ByUnseenZone(e) THEN LooseSet(e)
       ELSE IF e.event \in {"SET_TINT", "SET_TINTL", "SRT_DINT",
                            "DIS_IRT", "EN_IRT"}
       THEN IsCall(e) ELSE IsLooseAnswer(e)

-----------------------------------------------------------------------------
(* Starts *)

(* [OBS-20] OB 85 may still wait for an OB that was missing and is loaded. *)
\* @type: Int => Bool;
LooseLoad(o) ==
    /\ loaded'   = loaded \cup {o}
    /\ requests' = IF o \in As85 \ loaded
                   THEN requests \cup { [ Mark(ProgramErrorOb, UnknownFault)
                                         EXCEPT !.cause = o ] }
                   ELSE requests
    /\ NothingEntered
    /\ UNCHANGED <<cpu, modeVars, clock, settingVars, stopCause, runVars>>

LoadedTooLate ==
    { IF r.cause \in TodObs \cup DintObs THEN r.cause ELSE 0
      : r \in { q \in requests : q.ob = ProgramErrorOb /\ q.cause # 0 } }

(* OB 80 and OB 85 may have been requested for what may be due now, and    *)
(* wait still when its interrupt is cancelled or set anew; so may its OB   *)
(* [AMB-11] (a) [AMB-71] (b).                                              *)
DueMarks ==
    LET obs == MayBeDue \cap TodObs
        \* @type: (Int, Int) => $request;
        due(error, o) == [Mark(error, UnknownFault) EXCEPT !.cause = o]
        stays == ~TodCallsWithdrawRuns \/ OnceUsedUpAtItsPoint
    IN  IF Unseen("call") \/ mode = "STOP" THEN {}
        ELSE { due(TimeErrorOb, o) : o \in obs }
               \cup { Mark(o, 0) : o \in { p \in obs : stays } }
               \cup { due(ProgramErrorOb, o)
                      : o \in { p \in obs : MayBeMissing(p) } }
WasDue == { r.cause : r \in { q \in requests : q.ob = TimeErrorOb } } \ {0}

(* What OB 80 reports of points that an unseen setting of the clock skips. *)
SkipsInHold == IF ModeKnown /\ mode # "STOP" THEN {} ELSE {SkippedInHold}
UnseenJumps == {SkippedByClock} \cup SkipsInHold
                 \cup (IF Family.setsLocal THEN {SkippedByDaylight} ELSE {})

(* The OBs that may have caused OB 80 or OB 85. 0 stands for all causes    *)
(* but time-of-day and time-delay interrupts.                              *)
\* @type: (Int, Int) => Set(Int);
MayCause(o, fault) ==
    LET told(f) == fault \in {UnknownFault} \cup f
        outside == \/ Unseen("interrupt")
                   \/ \E r \in requests : /\ r.ob = o /\ r.cause = 0
                                          /\ told({r.fault})
        skipped == Unseen("clock") /\ told(UnseenJumps)
        others  == /\ told({StillRunning, BufferOverflow})
                   /\ \E r \in requests : r.ob \in ExternalObs
    IN  IF o = TimeErrorOb
        THEN (IF told({StillRunning, BufferOverflow}) THEN MayBeDue \cup WasDue
                                                      ELSE {})
               \cup (IF \/ outside \/ others
                        \/ skipped /\ MayBeDue \cap TodObs # {}
                     THEN {0} ELSE {})
        ELSE (IF told(ObNotLoaded)
              THEN { c \in MayBeDue : MayBeMissing(c) } \cup LoadedTooLate
              ELSE {})
               \cup (IF outside \/ (told(ObNotLoaded) /\ MissingMayBeRequested)
                     THEN {0} ELSE {})

(* The requests by which the OB of the line may start.                     *)
\* @type: $event => Set($request);
LooseRequests(e) ==
    LET fault  == IF e.ob \in {TimeErrorOb, ProgramErrorOb} THEN ToldFault(e)
                  ELSE 0
        causes == IF fault # 0 THEN MayCause(e.ob, fault)
                  ELSE IF MayBeRequested(e.ob) THEN {0} ELSE {}
    IN  { [UnseenRequest(e.ob, fault, class) EXCEPT !.cause = cause]
          : class \in ClassesOf(e.ob, fault), cause \in causes }

\* @type: $event => Bool;
LooseInterruptStarts(e) == \E r \in LooseRequests(e) :
      /\ FitsRequest(r, e)
      /\ MayBeLoaded(e.ob) /\ ~Deselected(e.ob)
      /\ ModeAllows(r)
      /\ StackKnown => \/ Preempts(r)
                       \/ mode = "STARTUP" /\ Len(stack) = 1  \* OB 10x is over
      /\ StackKnown /\ ~Unseen("call") => 0 \in Counts
      /\ e.ob \in TodObs => e.info.period \in {-1} \cup PeriodCodes
      /\ e.ob \in DintObs => e.info.dtime \in {-1} \cup DelayTimes
      /\ stack' = IF Unseen("ob") THEN stack
                  ELSE Append(stack, Frame(e.ob, r.class))
      /\ delay' = 0

-----------------------------------------------------------------------------
(* OBs start and end *)

(* Cycle and startup OBs stand first in the stack: their order is unseen.  *)
(* [OBS-52] Behind that of a hot restart the interrupted OBs go on.        *)
\* @type: Int => Seq($frame);
StackAround(o) == IF HotUnseen /\ o = StartupOb("hot") THEN stack
                                                       ELSE <<stack[1]>>

(* A count above 0 lasts [AMB-25] (b).                                     *)
\* @type: Int => Int;
CountAfter(o) == IF CountOutlives(o) THEN delay ELSE 0

\* @type: $event => Bool;
LooseFirstStarts(e) ==
    /\ ModeKnown => mode = IF e.ob \in CycleObs THEN "RUN" ELSE "STARTUP"
    /\ e.ob \in CycleObs => MayRun
    /\ StackKnown => Len(stack) = 1
    /\ Fits(e.info.priority, IF e.ob \in CycleObs THEN 1 ELSE StartupClass)
    /\ e.ob # CycleOb => MayBeLoaded(e.ob)
    /\ stack' = StackAround(e.ob)
    /\ delay' = CountAfter(e.ob)

\* @type: $event => Bool;
LooseStart(e) ==
    /\ IF e.ob \in CycleObs \cup StartupObs THEN LooseFirstStarts(e)
       ELSE \/ LooseInterruptStarts(e)
            \/ (Unseen("interrupt") \/ Marked(e.ob)) /\ ErrorObStartsUnseen(e)
    /\ Nothing /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars>>

\* @type: $event => Bool;
LooseEnd(e) ==
    /\ ModeKnown => mode \notin {"STOP", "HOLD"}
    /\ \/ Unseen("ob") /\ UNCHANGED stack
       \/ /\ Running.ob = e.ob /\ Len(stack) > 1
          /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
       \/ /\ e.ob \in CycleObs \cup StartupObs
          /\ ModeKnown =>
               /\ Len(stack) = 1
               /\ mode = IF e.ob \in CycleObs THEN "RUN" ELSE "STARTUP"
          /\ stack' = StackAround(e.ob)
    /\ delay' = CountAfter(e.ob)
    /\ Nothing /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars>>

-----------------------------------------------------------------------------
(* Modes *)

(* [AMB-26] [OBS-52] A hot restart. OB 80 may report points of the STOP.   *)
LooseResumes ==
    LET old == IF ModeKnown THEN resume.requests ELSE requests
    IN  /\ RestartExists("hot")
        /\ startup' = "hot"
        /\ requests' = { r \in old : Outlives(r) }
             \cup (IF MayBeDue \cap TodObs = {} THEN {}
                   ELSE {Mark(TimeErrorOb, SkippedByClock)})
        /\ IF HotRestartKeepsSettings
           THEN /\ dint' = IF ModeKnown THEN resume.dint ELSE dint
                /\ UNCHANGED <<irt, tod>>
           ELSE /\ dint' = NoJobs /\ irt' = NoneBlocked
                /\ tod' \in SettingsByStep7
        /\ resume' = [resume EXCEPT !.dint = NoJobs, !.requests = {}]
        /\ stopCause' = RestartStop
        /\ delay' = 0
        /\ UNCHANGED <<loaded, clock>>

(* [T15-120] What OB 80 may report of the points of STEP 7 that passed in   *)
(* a STOP, which may have begun unseen.                                    *)
Misses == mode # "STOP" \/ Family.missesInStop
MissedInStopMarks ==
    { r \in requests :
        /\ r = Mark(TimeErrorOb, SkippedInHold)
        /\ Family.missesInStop /\ ~StopPointsAreNothing
        /\ \E o \in TodObs : /\ cpu.step7[o].active
                             /\ cpu.step7[o].execution # "once" }

\* @type: $event => Bool;
LooseRestart(e) ==
    /\ ModeKnown => mode = "STOP"
    /\ IF e.type = "hot" THEN LooseResumes
       ELSE /\ Resets(e.type) /\ resume' = NothingKept
            /\ requests' = RestartRequests \cup MissedInStopMarks
            /\ tod' \in SettingsByStep7
    /\ mode' = IF ModeKnown THEN "STARTUP" ELSE "RUN"
    /\ stack' = IF HotUnseen /\ e.type = "hot" THEN stack
                ELSE <<Frame(StartupOb(e.type), StartupClass)>>
    /\ NothingEntered /\ UNCHANGED cpu

\* @type: $event => Bool;
LooseRun(e) ==
    /\ ModeKnown => mode = "STARTUP"
    /\ MayRun
    /\ mode' = "RUN" /\ startup' = "none"
    /\ stack' = IF HotUnseen THEN stack
                ELSE IF resume.stack = <<>> THEN <<Frame(CycleOb, 1)>>
                ELSE resume.stack
    /\ delay' = IF resume.stack = <<>> THEN delay ELSE resume.delay
    /\ resume' = NothingKept
    /\ Nothing /\ UNCHANGED <<deviceVars, clock, settingVars>>

(* An unseen hot restart may bring all back that waits.                    *)
LooseStop ==
    IF ModeKnown /\ mode # "STOP" THEN Stop
    ELSE IF HotUnseen THEN UNCHANGED cpuVars /\ NothingEntered
    ELSE /\ Clears /\ requests' = MissedInStopMarks
         /\ stack' = IF ModeKnown THEN stack ELSE <<Frame(CycleOb, 1)>>
         /\ UNCHANGED modeVars

LooseRelease ==
    /\ ModeKnown => mode = "HOLD"
    /\ mode' = IF ModeKnown /\ startup # "none" THEN "STARTUP"  \* [T15-121]
                                               ELSE "RUN"
    /\ requests' = IF MayBeDue \cap TodObs # {}
                   THEN requests \cup {Mark(TimeErrorOb, SkippedInHold)}
                   ELSE requests
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, startup, resume, clock, settingVars, stopCause,
                   runVars>>

-----------------------------------------------------------------------------
(* The clock, start events, entries, the state of an OB *)

(* [TINT-11] [AMB-37] Between now and t lies a whole minute: a possible    *)
(* point.                                                                  *)
\* @type: $moment => Bool;
PassesMinute(t) ==
    IsPast(IF SecondsAreKept THEN clock
           ELSE At(IF clock.ms = 0 THEN clock.min ELSE clock.min + 1), t)

(* Between now and t an interrupt that may be active may have a point.     *)
\* @type: $moment => Bool;
PassesPoint(t) ==
    /\ PassesMinute(t)
    /\ \E o \in MayBeDue \cap TodObs :
         \/ Unseen("call")
         \/ \E s \in {tod[o]} \cup { set[o] : set \in SettingsByStep7 } :
              s.active /\ ~Before(t, [ min |-> PointFrom(s, clock.min),
                                      ms |-> s.offset ])

(* The marks of OB 80 where the CPU may skip points up to moment t with    *)
(* these faults: by a setting of the clock, in an unseen HOLD, or in STOP.  *)
(* [AMB-83] In the millisecond of the release a point may count.           *)
\* @type: ($moment, Set(Int)) => Set($request);
SkipMarks(t, faults) ==
    LET \* @type: Int => Bool;
        passes(f) == PassesPoint(IF f = SkippedInHold
                                 THEN [t EXCEPT !.ms = @ + 1] ELSE t)
    IN  IF ~Misses THEN {}
        ELSE { Mark(TimeErrorOb, f) : f \in { g \in faults : passes(g) } }

(* Settings of the clock; a hot restart finds points that passed in STOP.  *)
UnseenSkips == SkipsInHold \cup (IF HotUnseen THEN {SkippedByClock} ELSE {})

(* An unseen setting of the clock may have skipped any point.              *)
JumpMarks == IF Unseen("clock") /\ Misses /\ MayBeDue \cap TodObs # {}
             THEN { Mark(TimeErrorOb, f) : f \in UnseenJumps } ELSE {}

MayBeLocal == \/ Unseen("call") \/ LocalObs # {}
              \/ \E o \in TodObs : cpu.step7[o].local

\* @type: $event => Bool;
LooseClock(e) ==
    /\ clock' = e.to
    /\ requests' = requests
                     \cup SkipMarks(e.to, {SkippedByClock} \cup SkipsInHold)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, settingVars, stopCause, runVars>>

(* OB 80 may report what daylight saving skips, and behind HOLD what a     *)
(* zone skips of the interrupts by local time [T15-119].                   *)
\* @type: $event => Bool;
LooseZone(e) ==
    /\ cpu' = InZone(cpu, e.zone, e.reason = "daylight")
    /\ tod' = [o \in DOMAIN tod |-> Moved(tod[o], e.zone - cpu.zone)]
    /\ requests' = requests
         \cup (IF mode = "STOP" THEN {}
               ELSE {Mark(TimeErrorOb, SkippedByDaylight)})
         \cup (IF ~MayBeLocal THEN {}
               ELSE SkipMarks([clock EXCEPT !.min = @ + e.zone - cpu.zone],
                              SkipsInHold))
    /\ NothingEntered
    /\ UNCHANGED <<loaded, modeVars, clock, dint, irt, stopCause, runVars>>

\* @type: $event => Bool;
LooseEvent(e) ==
    /\ e.ob \in SyncErrorObs => Watching
    /\ requests' =
         IF mode = "STOP" \/ (IrtKnown /\ Blocked(e.ob)) THEN requests
         ELSE requests \cup {Mark(e.ob, IF e.flt_id = -1 THEN 0 ELSE e.flt_id)}
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                   runVars>>

(* [AMB-33] OB 85 may be missing, or be blocked and stop the CPU.          *)
MayStopByOb85 == MayBeMissing(ProgramErrorOb) \/ BlockedOb85StopsTheCpu

(* An unseen event may have caused this entry. [OBS-26] That of a STOP by  *)
(* two excesses of the cycle time is 4568, too, though OB 80 is loaded.    *)
\* @type: $event => Bool;
LooseEntry(e) ==
    /\ e.id - ErrorEntry \in ObNotLoaded =>
         \/ MissingMayBeRequested
         \/ Mark(ProgramErrorOb, e.id - ErrorEntry) \in requests
    /\ e.id = NoTimeErrorOb =>
         \/ MayBeMissing(TimeErrorOb) \/ Unseen("interrupt")
         \/ Mark(TimeErrorOb, CycleTimeExceeded) \in requests
         \/ mode = "STOP"
    /\ e.id = NoProgramErrorOb => MayStopByOb85
    /\ NothingEntered /\ UNCHANGED <<cpuVars, reports>>

(* [OBS-60] In STOP, which may be unseen, only `loaded' is judged.         *)
\* @type: $event => Bool;
LooseState(e) ==
    /\ Unseen("load") \/ FitsTruth(e.loaded, e.ob \in loaded)
    /\ IrtKnown /\ mode # "STOP" =>
         /\ FitsTruth(e.blocked, Blocked(e.ob))
         /\ FitsTruth(e.entries_off, Silenced(e.ob))
         /\ e.ob \in TodObs \cup DintObs =>
              \E a \in LooseActive(e.ob) : FitsTruth(e.active, a)
         /\ FitsLeft(e)
    /\ UNCHANGED cpuVars /\ NothingEntered

-----------------------------------------------------------------------------
(* Lines *)

\* @type: $event => Bool;
LooseShows(e) ==
    /\ CASE e.event \in CallEvents -> LooseCall(e)
         [] e.event = "start"      -> LooseStart(e)
         [] e.event = "end"        -> LooseEnd(e)
         [] e.event = "interrupt"  -> LooseEvent(e)
         [] e.event = "clock"      -> LooseClock(e)
         [] e.event = "zone"       -> LooseZone(e)
         [] e.event = "load"       -> LooseLoad(e.ob)
         [] e.event = "delete"     -> LoadedAre(loaded \ {e.ob})
         [] e.event = "restart"    -> LooseRestart(e)
         [] e.event = "run"        -> LooseRun(e)
         [] e.event = "hold"       ->
              IF ModeKnown THEN Hold ELSE UNCHANGED cpuVars /\ NothingEntered
         [] e.event = "release"    -> LooseRelease
         [] e.event = "stop"       -> LooseStop
         [] e.event = "diag"       -> IF CauseUnseen(e.id) THEN LooseEntry(e)
                                      ELSE IsEntry(e)
         [] e.event = "state"      -> LooseState(e)
         [] e.event = "done"       -> UNCHANGED cpuVars /\ NothingEntered
    /\ UNCHANGED <<terms, up, waiting, eventVars>>
    /\ IF e.event = "diag" THEN TRUE ELSE Report(0)

-----------------------------------------------------------------------------
(* Time *)

(* A delay ends at the earliest when so many ms have elapsed. An unseen    *)
(* HOLD may have made it longer.                                           *)
\* @type: (Int, Bool) => (Int -> $job);
LooseJobs(d, known) ==
    [ o \in DintObs |->
        IF o \notin Jobs THEN dint[o]
        ELSE [ dint[o] EXCEPT !.left = IF known /\ @ - d > 1 THEN @ - d
                                                             ELSE Gone ] ]

(* Without `up' in a line nobody knows how much time has elapsed if the    *)
(* clock may have been set.                                                *)
\* @type: $event => Bool;
LooseElapse(e) ==
    LET d     == Span(up, e.up)
        known == ~Unseen("clock") \/ e.counter # NoMoment
        until == IF e.counter = NoMoment THEN e.at ELSE ByCounter(e)
    IN  /\ known => EntriesLate(d) = {}
        /\ clock' = e.at
        /\ up' = e.up
        /\ dint' = LooseJobs(d, known)
        /\ requests' = requests
             \cup { Mark(o, 0) : o \in { j \in DintObs :
                                   dint'[j].started /\ dint'[j].left = Gone } }
             \cup SkipMarks(until, UnseenSkips) \cup JumpMarks \cup DueMarks
        /\ reports' = IF known THEN ReportsAfter(d) ELSE reports
        /\ NothingEntered
        /\ UNCHANGED <<deviceVars, modeVars, tod, irt, stopCause, runVars,
                       lineVars, waiting, eventVars>>
=============================================================================

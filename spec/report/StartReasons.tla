---------------------------- MODULE StartReasons ----------------------------
(***************************************************************************)
(* Reasons why the start of an OB is rejected: its start event has not     *)
(* come, or it may not start by it. They follow from the state before the  *)
(* line, from the line e, and from the lines before it, `past' (PastLines).*)
(*                                                                         *)
(* Source: requirements, sections 1 to 6, tables 7.2 and 7.5.              *)
(* Left out: a start that comes too late, other lines (Reasons).           *)
(***************************************************************************)
EXTENDS PartialLogs, BlockReasons

-----------------------------------------------------------------------------
(* An OB of a higher class goes first: at the end of a delay, or of an OB. *)
\* @type: Seq($event) => Set(Str);
HighestClassFirst(past) ==
    {"OBS-03"} \cup When(LastOf(past, {"EN_AIRT"})
                           > LastOf(past, {"start", "end", "run"}),
                         {"AIRT-08"})

-----------------------------------------------------------------------------
(* Time: a series, a delay, a clock that was set, a HOLD, a STARTUP *)

(* The requirements of STEP 7's setting of an interrupt. *)
\* @type: (Int, Seq($event)) => Set(Str);
Step7Requirements(o, past) ==
    LET call == LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT"}, o)
    IN  When(cpu.step7[o].execution # "none",
             IF LastReset(past) > call THEN {"OBS-50"}
             ELSE IF call = 0 THEN {"TINT-06"} ELSE {"TINT-38"})

(* The rules that say when an interrupt of this PERIOD is due. *)
\* @type: (Int, Int, Seq($event)) => Set(Str);
SeriesRequirements(o, period, past) ==
    LET set == LastWith(past, {"SET_TINT"}, o)
        late == OnLateDay(cpu.step7[o]) /\ LastReset(past) >= set
    IN  {"TINT-32"}
          \cup When(late, {"AMB-86"})
          \cup When(period = Hourly, {"TINT-34"})
          \cup When(period = EndOfMonth, {"TINT-19"})
          \cup When(/\ period = Monthly /\ ~late
                    /\ DayOf(tod[o].start \div MinutesADay) > 28, {"TINT-18"})
          \cup When(period \notin {Once, EndOfMonth}, {"TINT-33"})
          \cup When(LastStart(past, o) <= set, {"TINT-24"})
          \cup When(/\ set > 0
                    /\ past[set].sdt.second # 0 \/ past[set].sdt.ms # 0,
                    {"TINT-11"})

(* The rules that say when the delay of a job is over. *)
\* @type: (Int, Seq($event)) => Set(Str);
OfDelay(o, past) ==
    LET srt == LastWith(past, {"SRT_DINT"}, o)
    IN  When(LastOf(past, {"clock"}) > srt \/ Unseen("clock"), {"DINT-18"})
          \cup When(LastOf(past, {"hold"}) > srt, {"DINT-19"})
          \cup When(TimesSince(past, {"SRT_DINT"}, o, LastStart(past, o)) > 1,
                    {"DINT-07"}
                      \cup When(DintCallsWithdrawRuns(cpu), {"DINT-15"}))

-----------------------------------------------------------------------------
(* Since a line *)

(* The line at position i comes after position `last', and at most a       *)
(* second before moment t. Later, all that waited for it has run.          *)
\* @type: (Seq($event), Int, Int, $moment) => Bool;
IsJustBefore(past, i, last, t) ==
    i > last /\ (Before(t, past[i].at) \/ Span(past[i].at, t) <= 1000)

(* Just before moment t, and since position `last', the CPU has gone on to *)
(* RUN, and the clock was not set in RUN; or HOLD has come.                *)
\* @type: (Seq($event), Int, Int, $moment) => Set(Str);
SinceRun(past, o, last, t) ==
    LET run  == LastOf(past, {"run"})
        hold == LastOf(past, {"hold", "release"})
    IN  When(/\ IsJustBefore(past, run, last, t)
             /\ LastOf(past, {"clock"}) < run,
             {"OBS-44"} \cup When(o \in TodObs, {"TINT-13"})
                        \cup When(o \in DintObs, {"DINT-11"})
                        \cup When(o \in ExternalObs, {"OBS-42"}))
          \cup When(IsJustBefore(past, hold, last, t),
                    {"OBS-45"} \cup When(o \in TodObs, {"OBS-46"})
                               \cup When(o \in DintObs, {"DINT-19"}))

(* The start event came before the last change to RUN.                     *)
\* @type: ($request, Seq($event)) => Bool;
CameBeforeRun(r, past) ==
    LET run == LastOf(past, {"run"})
    IN  run > 0 /\ ~Before(past[run].at, r.since)

(* Since position `last' the clock was set.                                *)
\* @type: (Seq($event), Int) => Set(Str);
SinceClock(past, last) ==
    LET how == ClockWasSet(past, last)
    IN  IF how = 0 THEN {}
        ELSE IF how > 0 THEN {"CLK-03", "CLK-08"}
        ELSE IF ~Family.repeats THEN {"CLK-09"}
        ELSE IF Remembers THEN {"CLK-11"} ELSE {"CLK-10"}

-----------------------------------------------------------------------------
(* Time-of-day interrupts *)

(* The program has changed the catch-up in OB 80 [CLK-04].                 *)
\* @type: (Int, Seq($event)) => Bool;
TouchedInOb80(o, past) ==
    LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT", "DIS_IRT"}, o)
      > LastStart(past, TimeErrorOb)
    /\ LastStart(past, TimeErrorOb) > 0

(* The OB has just run, and no start point has come since. *)
\* @type: (Int, Seq($event)) => Bool;
RanForPoint(o, past) ==
    LET last == LastStart(past, o)
    IN  /\ last > 0 /\ past[last].at.min < tod[o].next
        /\ clock.min - past[last].at.min \in {0, 1}
        /\ PointFrom(tod[o], past[last].at.min + 1) = tod[o].next

(* A one-shot interrupt has run: it is used up, also where the clock was   *)
(* set since, or where it was caught up.                                   *)
\* @type: (Int, Seq($event)) => Set(Str);
AfterOnce(o, past) ==
    LET how == ClockWasSet(past, StartBefore(past, o))
    IN  {"TINT-08"}
          \cup When(how < 0, {"CLK-12"}) \cup When(how > 0, {"CLK-13"})
          \cup When(cpu.step7[o].execution = "once" /\
                      LastWith(past, {"SET_TINT"}, o) = 0, {"OBS-56"})

(* The settings and activations of an interrupt that decide whether it is  *)
(* set: the last one counts.                                               *)
\* @type: (Int, Seq($event)) => Set(Str);
WhetherSet(o, past) ==
    LET last  == LastWith(past, {"SET_TINT", "CAN_TINT", "start"}, o)
        reset == LastReset(past)
        once  == When(cpu.step7[o].execution = "once", {"OBS-56"})
    IN  IF reset > last THEN {"OBS-50"} \cup once
        ELSE IF LastHot(past) > last THEN {"AMB-26", "OBS-52"}
        ELSE IF last = 0
        THEN IF cpu.step7[o].execution = "none" THEN {"TINT-07"}
             ELSE {"TINT-04", "TINT-06"} \cup once
        ELSE CASE past[last].event = "start"    -> AfterOnce(o, past)
               [] past[last].event = "CAN_TINT" -> {"TINT-50"}
               [] Worked(past[last])            -> {"TINT-30"}
               [] OTHER                         -> {"TINT-31"}

(* Why a point of a time-of-day interrupt has not led to a start event.    *)
\* @type: (Int, Seq($event)) => Set(Str);
NoTodRequest(o, past) ==
    LET last == LastWith(past, {"SET_TINT", "CAN_TINT", "start"}, o)
    IN  IF Deselected(o)
        THEN {"TINT-02", "OBS-25"} \cup When(ClassOf(o) = 0, {"OBS-06"})
        ELSE IF LostMeanwhile(past, o) THEN {"IRT-04", "IRT-18"}
        ELSE IF OnStack(o) THEN {"OBS-02", "TINT-14"}
        ELSE IF \/ ~tod[o].set
                \/ ~tod[o].active /\ LastReset(past) > last
        THEN WhetherSet(o, past)
               \cup When(last = 0 \/ past[last].event # "start", {"TINT-02"})
               \cup When(last = 0, {"TINT-05"})
               \cup When(TouchedInOb80(o, past), {"CLK-04", "TINT-54"})
        ELSE IF ~tod[o].active
        THEN {"TINT-02", "TINT-05"}
               \cup When(LastWith(past, {"ACT_TINT"}, o) > 0, {"TINT-31"})
               \cup When(TouchedInOb80(o, past), {"CLK-04"})
               \cup When(LastOf(past, {"clock"}) > last, {"CLK-14"})
        ELSE LET again == RanForPoint(o, past)
                 from  == IF again THEN StartBefore(past, o)
                          ELSE LastStart(past, o)
                 moved == SinceClock(past, from)
                            \cup SinceRun(past, o, from, clock)
                 special ==
                   moved
                     \cup When(Blocked(TimeErrorOb), {"OBS-33"})
                     \cup When(ClockWasSet(past, from) # 0
                                 /\ TouchedInOb80(o, past),
                               {"CLK-04", "TINT-54"})
                     \cup When(clock.min <= tod[o].repeatTo
                                 /\ WasServed(tod[o], clock.min, cpu),
                               {"CLK-09"})
                     \cup When(again, {"OBS-07"})
                     \cup When(again /\ moved = {}, {"TINT-09", "TINT-32"})
                     \cup When(again /\ moved = {}
                                 /\ LastStart(past, TimeErrorOb) > from,
                               {"TINT-14"})
             IN  IF special # {} THEN special
                 ELSE SeriesRequirements(o, tod[o].period, past)
                        \cup Step7Requirements(o, past)
                        \cup When(~HasOnePoint(tod[o].period), {"TINT-10"})

-----------------------------------------------------------------------------
(* Time-delay interrupts *)

\* @type: (Int, Seq($event)) => Set(Str);
NoDintRequest(o, past) ==
    LET last == LastWith(past, {"SRT_DINT", "CAN_DINT", "start"}, o)
    IN  IF LostMeanwhile(past, o) THEN {"IRT-04", "DINT-20"}
        ELSE IF OnStack(o) THEN {"OBS-02", "DINT-10"}
        ELSE IF dint[o].started
        THEN {"DINT-03", "DINT-06"} \cup OfDelay(o, past)
        ELSE IF LastOf(past, {"restart"}) > last THEN {"DINT-02", "DINT-13"}
        ELSE IF last = 0 THEN {"DINT-02"}
        ELSE IF past[last].event = "CAN_DINT" THEN {"DINT-02", "DINT-14"}
        ELSE {"DINT-02", "DINT-03"}
               \cup When(LastStart(past, TimeErrorOb) > StartBefore(past, o),
                         {"DINT-10"})

-----------------------------------------------------------------------------
(* OB 80 and OB 85 *)

(* The rule of a fault of OB 80; `cause' is the OB that was to start.      *)
\* @type: (Int, Int) => Set(Str);
OfFault(fault, cause) ==
    CASE fault = SkippedByClock -> {"CLK-02"}
      [] fault = SkippedInHold  -> {"OBS-46"}
      [] fault = SkippedByDaylight -> {"T15-96"}
      [] fault = SkippedByZone  -> {"T15-98"}
      [] fault = BufferOverflow -> {"OBS-08"}
      [] fault = StillRunning   -> When(cause \in TodObs, {"TINT-14"})
                                     \cup When(cause \in DintObs, {"DINT-10"})
      [] OTHER                  -> {}

(* The OB runs, and the clock was set back since: whether its point comes  *)
(* again decides whether it is still in process.                           *)
\* @type: (Seq($event), Int) => Set(Str);
ComesAgain(past, o) ==
    When(o \in TodObs /\ ClockWasSet(past, LastStart(past, o)) < 0,
         SinceClock(past, LastStart(past, o)))

(* The fault in the line decides; without a fault, the lines before it. *)
\* @type: ($event, Seq($event)) => Set(Str);
NoTimeError(e, past) ==
    LET fault   == e.info.flt_id
        last    == LastStart(past, TimeErrorOb)
        set     == LastOf(past, {"clock"})
        release == LastOf(past, {"release"})
    IN  IF TimeErrorOb \notin loaded THEN {"OBS-22", "OBS-30"}
        ELSE {"OBS-30"}
          \cup UNION { OfFault(fault, stack[i].ob) : i \in DOMAIN stack }
          \cup OfFault(fault, 0)
          \cup When(fault = StillRunning,
                    UNION { ComesAgain(past, stack[i].ob)
                            : i \in DOMAIN stack })
          \cup When(LostMeanwhile(past, TimeErrorOb), {"OBS-33", "IRT-04"})
          \cup When(fault = -1 /\ set > last, {"CLK-02", "OBS-32"})
          \cup When(fault \in {-1} \cup Skips /\ release > last, {"OBS-46"})
          \cup When(/\ fault \in {-1, SkippedByClock} /\ set > last
                    /\ \E o \in TodObs : tod[o].set /\ ~tod[o].active,
                    {"CLK-14"})
          \cup When(/\ fault = SkippedByClock /\ set > last
                    /\ \E o \in TodObs : Deselected(o), {"OBS-25", "OBS-06"})
          \cup When(fault \in {-1, SkippedByClock} /\ set > 0, {"OBS-32"})
          \cup When(fault = SkippedByClock /\ ~Family.repeats
                      /\ \E i \in DOMAIN past :
                           past[i].event = "clock"
                             /\ Before(past[i].to, past[i].at), {"CLK-09"})
          \cup When(past # <<>> /\ past[Len(past)].event = "interrupt"
                      /\ past[Len(past)].ob \notin loaded,
                    IF past[Len(past)].ob \in AsyncErrorObs THEN {"OBS-23"}
                    ELSE {"OBS-20", "OBS-24"})
          \cup When(/\ fault = SkippedByClock
                    /\ LastOf(past, {"zone"}) <= set
                    /\ \/ set = 0 \/ LastOf(past, {"DIS_AIRT"}) > set
                    /\ \E r \in requests : r.ob \in TodObs,
                    {"CLK-18"})

(* The missing OBs whose interrupt was activated or started. *)
\* @type: Seq($event) => Set(Str);
NoProgramError(past) ==
    LET tods  == { o \in TodObs \ loaded : LastWith(past, {"ACT_TINT"}, o) > 0
                                          \/ tod[o].active }
        dints == { o \in DintObs \ loaded :
                     LastWith(past, {"SRT_DINT"}, o) > 0 }
        others == { o \in ExternalObs \ loaded :
                      LastWith(past, {"interrupt"}, o) > 0 }
    IN  {"OBS-20"}
          \cup When(tods # {}, {"TINT-16", "TINT-17"})
          \cup When(dints # {}, {"DINT-09"})
          \cup When(\E o \in tods \cup dints \cup others : Blocked(o),
                    {"IRT-01"})
          \cup When(others \cap AsyncErrorObs # {}, {"OBS-23"})
          \cup When(LostMeanwhile(past, ProgramErrorOb), {"IRT-04"})
          \cup When(delay > 0 /\ { r \in requests : r.ob \notin loaded } # {},
                    {"AIRT-01", "AIRT-09"})
          \cup When(\E r \in MissingNow : ~MissedInOrder(r),
                    HighestClassFirst(past))
          \cup When(MissingObEndsItsSource, {"OBS-28"})
          \cup When(MissingIsTimeError, {"OBS-24"})

-----------------------------------------------------------------------------

(* The start information of a cycle OB or a startup OB: it may be wrong,   *)
(* and the OB might start with another one.                                *)
\* @type: $event => Set(Str);
OfInfoAlone(e) ==
    When(~Fits(e.info.priority, DefaultClass(e.ob)), {"OBS-04"})
      \cup When(\/ e.info.strt_info # -1
                \/ /\ e.info.time # NoMoment
                   /\ ~JustBefore(e.info.time, e),
                {"OBS-10"})

\* @type: $event => Bool;
DiffersInInfoAlone(e) ==
    OfInfoAlone(e) # {} /\ ENABLED IsStart([e EXCEPT !.info = NoInfo])

\* @type: ($event, Seq($event)) => Set(Str);
WithoutRequest(e, past) ==
    LET o == e.ob
    IN  CASE mode = "STOP"                -> {"OBS-41"}
          [] mode = "HOLD"                ->
               {"OBS-45"} \cup When(o \in DintObs, {"DINT-12", "DINT-19"})
          [] ClassOf(o) = 0               -> {"OBS-06", "TINT-02", "OBS-25"}
          [] Blocked(o)                   -> ThoughBlocked(past, o)
          [] mode = "STARTUP" /\ o \in TodObs  -> {"OBS-42", "TINT-13"}
          [] mode = "STARTUP" /\ o \in DintObs ->
               {"OBS-42", "DINT-12", "DINT-11"}
          [] o \in TodObs                 -> NoTodRequest(o, past)
          [] o \in DintObs                -> NoDintRequest(o, past)
          [] o = TimeErrorOb              -> NoTimeError(e, past)
          [] o = ProgramErrorOb           -> NoProgramError(past)
          [] o \in CycleObs \cup StartupObs ->
               OfInfoAlone(e)
                 \cup When(~DiffersInInfoAlone(e),
                           IF mode = "STARTUP" THEN {"OBS-42"} ELSE {"OBS-03"})
                 \cup When(mode = "STARTUP" /\ o \in OldStartupObs
                             /\ startup # "begun"
                             /\ o # StartupOb(startup), {"OBS-57"})
          [] LostMeanwhile(past, o)       -> {"IRT-04", "IRT-15"}
          [] mode = "STARTUP" /\ o \notin AsyncErrorObs -> {"OBS-42"}
          [] LastWith(past, {"interrupt"}, o)
               \in (LastStart(past, o) + 1)..LastOf(past, {"restart"}) ->
               {"OBS-52", "OBS-07"}
          [] OTHER                        ->
               {"OBS-01", "OBS-07"} \cup When(o \in AsyncErrorObs, {"OBS-29"})
                 \cup SinceRun(past, o, LastStart(past, o), clock)

-----------------------------------------------------------------------------
(* The class of an error that came in STARTUP, in RUN [AMB-88] *)

(* The request came in the STARTUP that has led to RUN. *)
\* @type: ($request, Seq($event)) => Bool;
CameInStartup(r, past) ==
    LET run == LastOf(past, {"run"})
    IN  /\ Family.raises /\ mode = "RUN" /\ r.ob \in AsyncErrorObs
        /\ LastOf(past, {"restart"}) \in 1..run
        /\ ~Before(past[run].at, r.since)

(* Its class is that of STARTUP or that of RUN, or either. *)
\* @type: Set(Str);
OfKeptClass == {"AMB-88"} \cup When(~ErrorTakesClassOfRun, {"OBS-43"})
                         \cup When(~ErrorKeepsItsClass, {"OBS-31"})

(* The OB that runs has kept the class of STARTUP. *)
\* @type: Seq($event) => Bool;
KeepsItsClass(past) ==
    /\ Family.raises /\ mode = "RUN"
    /\ Running.ob \in AsyncErrorObs /\ Running.class = 28
    /\ LastOf(past, {"restart"}) > 0
    /\ LastWith(past, {"interrupt"}, Running.ob) < LastOf(past, {"run"})

-----------------------------------------------------------------------------
(* Start information that does not fit the request *)

\* @type: ($request, $event, Seq($event)) => Set(Str);
InterruptInfo(r, e, past) ==
    LET i == e.info
    IN  When(~Fits(i.priority, r.class),
             IF CameInStartup(r, past) THEN OfKeptClass
             ELSE IF r.ob = TimeErrorOb THEN {"OBS-31"}
             ELSE {"OBS-04"} \cup When(r.ob \in DintObs, {"DINT-01"})
                    \cup When(r.ob \in DOMAIN cpu.priority, {"OBS-05"})
                    \cup When(r.ob \in AsyncErrorObs /\ mode = "STARTUP",
                              {"OBS-43"}))
          \cup When(/\ r.ob \notin AsyncErrorObs
                    /\ ~FitsNumber(i.strt_info, r.ob),
                    {"OBS-10"} \cup When(r.ob \in TodObs, {"TINT-23"})
                      \cup When(r.ob \in DintObs, {"DINT-03"})
                      \cup When(r.ob \in ExternalObs /\ EventsOf(r.ob) # {},
                                {"OBS-04"}))
          \cup When(r.ob \in TodObs /\ ~FitsPeriod(i.period, r.word),
                    {"TINT-25", "TINT-33"})
          \cup When(r.ob \in DintObs /\ ~Fits(i.sign, r.word),
                    {"DINT-03", "DINT-07", "DINT-22"})
          \cup When(r.ob \in DintObs /\ ~FitsDtime(i.dtime, r.dtime),
                    {"DINT-03", "DINT-07"})
          \cup When(~FitsTime(r, e),
                    CASE r.follows \in Skips -> {"CLK-07"}
                      [] r.fault \in Skips   -> {"CLK-06"}
                      [] r.ob \in TodObs     ->
                           {"OBS-10", "TINT-09", "TINT-24"}
                      [] r.ob \in DintObs    -> {"OBS-10", "DINT-03"}
                      [] OTHER               -> {"OBS-10"})

(* OB 80 and OB 85. *)
\* @type: ($request, $info) => Set(Str);
ErrorInfo(r, i) ==
    LET rule == IF r.ob = TimeErrorOb THEN {"OBS-30"} ELSE {"OBS-20"}
    IN  When(~FitsFault(r.fault, i.flt_id) \/ ~FitsFault(r.fault, i.strt_info),
             rule \cup OfFault(r.fault, r.cause))
          \cup When(~FitsCause(r, i), rule \cup OfFault(r.fault, r.cause)
                                          \cup When(r.cause = 0, {"OBS-10"}))
          \cup When(~Fits(i.priority, r.class),
                    When(r.fault = BufferOverflow, {"OBS-08"})
                      \cup When(r.fault = SkippedInHold, {"OBS-46"}))
          \cup When(~FitsMask(r, i.error_info),
                    {"CLK-06", "OBS-32"}
                      \cup When(r.fault = SkippedInHold, {"OBS-46"}))

\* @type: ($request, $event, Seq($event)) => Set(Str);
InfoRequirements(r, e, past) ==
    LET ids == InterruptInfo(r, e, past)
                 \cup When(r.ob \in AsyncErrorObs, ErrorInfo(r, e.info))
    IN  IF ids = {} THEN {"OBS-10"} ELSE ids

-----------------------------------------------------------------------------

(* The first condition of a start that the request does not meet.          *)
\* @type: ($request, $event, Seq($event)) => Set(Str);
StartRequirements(r, e, past) ==
    IF ~ModeAllows(r)
    THEN CASE mode = "STARTUP" -> {"OBS-42"}
                \cup When(r.ob \in TodObs, {"TINT-13"})
                \cup When(r.ob \in DintObs, {"DINT-11", "DINT-12"})
           [] mode = "HOLD" -> {"OBS-45"}
           [] OTHER         -> {"OBS-41"}
    ELSE IF r.ob \notin loaded
    THEN {"OBS-20"} \cup When(r.ob \in TodObs, {"TINT-16"})
                    \cup When(r.ob \in DintObs, {"DINT-02", "DINT-09"})
                    \cup When(r.ob \in AsyncErrorObs, {"OBS-23"})
                    \cup When(r.ob = ProgramErrorOb, {"OBS-21"})
                    \cup When(r.ob = TimeErrorOb, {"OBS-22"})
    ELSE IF Blocked(r.ob) /\ r \notin requests THEN ThoughBlocked(past, r.ob)
    ELSE IF ~Undelayed
    THEN {"AIRT-01", "AIRT-03"} \cup When(r.ob \in AsyncErrorObs, {"AIRT-09"})
    ELSE IF r.class = Running.class
    THEN {"OBS-02"}
           \cup When(r.ob \in TodObs,
                     IF OnStack(r.ob) THEN {"TINT-14", "TINT-15"}
                     ELSE {"TINT-12"})
           \cup When(r.ob \in AsyncErrorObs, {"OBS-11"})
           \cup When({r.ob, Running.ob} \cap DOMAIN cpu.priority # {},
                     {"OBS-05"})
    ELSE IF ~Preempts(r)
    THEN {"OBS-01"}
           \cup When({r.ob, Running.ob} \cap DOMAIN cpu.priority # {},
                     {"OBS-05"})
           \cup When(KeepsItsClass(past), OfKeptClass)
           \cup When(/\ LastOf(past, {"DIS_IRT"}) > LastStart(past, Running.ob)
                     /\ Blocked(Running.ob), {"IRT-08", "OBS-03"})
    ELSE IF ~Reported(r)
    THEN IF r.follows \in Skips THEN OfFault(r.follows, 0) \cup {"CLK-03"}
         ELSE IF r.follows \in LocalSkips THEN OfFault(r.follows, 0)
         ELSE {"TINT-15"}
    ELSE IF ~InTurn(r)
    THEN {"OBS-02"} \cup When(r.ob \in TodObs, {"TINT-12"})
                    \cup When(r.ob \in AsyncErrorObs, {"OBS-11"})
                    \cup When(CameInStartup(r, past), OfKeptClass)
                    \cup When(r.ob \in DOMAIN cpu.priority, {"OBS-05"})
                    \cup When(r.follows \in Skips, {"CLK-03"})
    ELSE IF ~HighestFirst(r) THEN HighestClassFirst(past)
    ELSE InfoRequirements(r, e, past)

(* How many of these conditions the request meets. *)
\* @type: ($request, Int) => Int;
Depth(r, fault) ==
    IF ~ModeAllows(r) THEN 1 ELSE IF r.ob \notin loaded THEN 2
    ELSE IF ~Undelayed THEN 3 ELSE IF ~Preempts(r) THEN 4
    ELSE IF ~Reported(r) THEN 5 ELSE IF ~InTurn(r) THEN 6
    ELSE IF ~HighestFirst(r) THEN 7
    ELSE IF ~FitsFault(r.fault, fault) THEN 8 ELSE 9

(* The requests by which the OB of the line might start; a request may     *)
(* have come unseen.                                                       *)
\* @type: $event => Set($request);
Candidates(e) ==
    IF terms.loose THEN LooseRequests(e)
    ELSE { r \in requests : r.ob = e.ob }
           \cup (IF Unseen("interrupt") THEN MayHaveOccurred(e) ELSE {})

(* [OBS-61] OB 121 and OB 122.                                             *)
\* @type: $event => Set(Str);
OfErrorOb(e) ==
    {"OBS-61"} \cup When(e.ob \notin loaded, {"OBS-27", "OBS-63"})
               \cup When(mode = "HOLD", {"OBS-45"})

\* @type: ($event, Seq($event)) => Set(Str);
OfStart(e, past) ==
    LET all  == Candidates(e)
        fault == e.info.flt_id
        best == { r \in all :
                    \A q \in all : Depth(q, fault) <= Depth(r, fault) }
    IN  IF e.ob \in SyncErrorObs THEN OfErrorOb(e)
        ELSE IF all = {} \/ mode = "STOP" THEN WithoutRequest(e, past)
        ELSE UNION { StartRequirements(r, e, past) : r \in best }
               \cup When(e.info.dtime \notin {-1} \cup DelayTimes, {"DINT-04"})
               \cup When(e.info.period \notin {-1} \cup PeriodCodes,
                         {"TINT-33"})
=============================================================================

------------------------------ MODULE Reasons -------------------------------
(***************************************************************************)
(* The requirements that someone who knows the log would cite for a line:  *)
(* why it is rejected (Deciding), why it comes too late                    *)
(* (LateRequirements), why it is possible (WhyPossible). They follow from  *)
(* the state just before the line, from the line e, and from the lines     *)
(* before it, `past'.                                                      *)
(*                                                                         *)
(* No action uses this module.                                             *)
(* Source: the requirement IDs.                                            *)
(* Left out: the lines that are allowed instead (Explain).                 *)
(***************************************************************************)
EXTENDS StartReasons, NextLines

-----------------------------------------------------------------------------
(* RET_VAL *)

\* @type: ($event, Int) => Set(Str);
SetRequirements(e, ret) ==
    CASE ret = OK        -> {"TINT-30"}
      [] ret = BadOb     -> {"TINT-35"}
      [] ret = BadSdt    ->
           CASE e.period = Monthly /\ e.sdt.day > 28 -> {"TINT-18"}
             [] e.period = EndOfMonth -> {"TINT-19", "TINT-39"}
             [] e.period = Yearly     -> {"TINT-32", "TINT-39"}
             [] OTHER                 -> {"TINT-39", "TINT-35"}
      [] ret = BadPeriod -> {"TINT-33"}
      [] ret = PastStart ->
           {"TINT-36"} \cup When(~HasOnePoint(e.period), {"TINT-37"})
      [] OTHER           -> {"TINT-22"}

\* @type: ($event, Int) => Set(Str);
ActRequirements(e, ret) ==
    LET on == e.ob \in TodObs /\ tod[e.ob].active
    IN  CASE ret = OK -> {"TINT-60"} \cup When(on, {"TINT-63"})
          [] ret = PastStart ->
               IF e.ob \in TodObs /\ ~HasOnePoint(tod[e.ob].period)
               THEN {"TINT-62"} ELSE {"TINT-61"}
          [] ret = NotSet -> {"TINT-61", "TINT-64"}
          [] ret = BadOb  -> {"TINT-61"}
          [] OTHER -> {"TINT-22"}

\* @type: ($event, Int) => Set(Str);
SrtRequirements(e, ret) ==
    CASE ret = OK       -> {"DINT-03", "DINT-07"}
      [] ret = BadOb    -> {"DINT-05"}
      [] ret = BadDtime -> {"DINT-04"}
      [] OTHER          -> {"DINT-21"}

\* @type: ($event, Int) => Set(Str);
IrtRequirements(e, ret) ==
    CASE ret = OK /\ e.event = "EN_IRT"  -> {"IRT-13", "IRT-24"}
      [] ret = OK      -> {"IRT-06"}
      [] ret = BadMode -> {"IRT-12"}
      [] ret = BadOb   -> {"IRT-11", "IRT-12"}
                            \cup When(e.ob \in 120..122, {"IRT-23"})
      [] OTHER         -> {"IRT-22"}

(* A general error code. *)
\* @type: $event => Set(Str);
GeneralRequirements(e) ==
    {"AMB-81"} \cup
      CASE e.event \in {"DIS_AIRT", "EN_AIRT"}              -> {"AIRT-16"}
        [] e.event \in {"DIS_IRT", "EN_IRT"}                -> {"IRT-22"}
        [] e.event \in {"SRT_DINT", "CAN_DINT", "QRY_DINT"} -> {"DINT-21"}
        [] OTHER                                            -> {"TINT-22"}

\* @type: ($event, Int) => Set(Str);
AnswerRequirements(e, ret) ==
    CASE IsGeneralError(ret) -> GeneralRequirements(e)
      [] e.event = "SET_TINT" -> SetRequirements(e, ret)
      [] e.event = "CAN_TINT" ->
           IF ret = OK THEN {"TINT-50", "TINT-52"} ELSE {"TINT-51"}
      [] e.event = "ACT_TINT" -> ActRequirements(e, ret)
      [] e.event = "QRY_TINT" -> {"TINT-70"}
      [] e.event = "SRT_DINT" -> SrtRequirements(e, ret)
      [] e.event = "CAN_DINT" -> {"DINT-14"}
           \cup When(ret = NotStarted, {"DINT-15"})
      [] e.event = "QRY_DINT" -> {"DINT-16"}
      [] e.event \in {"DIS_IRT", "EN_IRT"} -> IrtRequirements(e, ret)
      [] e.event = "DIS_AIRT" -> {"AIRT-03", "AIRT-06"}
                                   \cup When(delay = 0, {"AIRT-04"})
      [] OTHER                -> {"AIRT-03", "AIRT-07"}
                                   \cup When(delay = 0, {"AIRT-04"})

\* @type: $event => Set(Str);
WrongAnswer(e) ==
    AnswerRequirements(e, e.ret)
      \cup UNION { AnswerRequirements(e, r) : r \in RightAnswers(e) }
      \cup When(/\ e.event \notin {"DIS_IRT", "EN_IRT", "DIS_AIRT", "EN_AIRT"}
                /\ e.ob \in TodObs \cup DintObs
                /\ Deselected(e.ob), {"OBS-25"})

-----------------------------------------------------------------------------
(* STATUS *)

(* The requirements that decide whether a time-of-day interrupt is active. *)
\* @type: (Int, Seq($event)) => Set(Str);
ActiveRequirements(o, past) ==
    LET last  == LastWith(past,
                          {"SET_TINT", "CAN_TINT", "ACT_TINT", "start"}, o)
        reset == LastOf(past, {"restart"})
    IN  IF tod[o].active /\ ~HasOnePoint(tod[o].period) /\ tod[o].next = Never
        THEN {}  \* a series without a further point
        ELSE IF reset > last THEN {"OBS-50", "TINT-38"}
        ELSE IF last = 0 THEN {"TINT-06"}
        ELSE CASE past[last].event = "start"    -> {"TINT-08", "TINT-64"}
               [] past[last].event = "CAN_TINT" -> {"TINT-50"}
               [] past[last].event = "SET_TINT" ->
                    IF Worked(past[last]) THEN {"TINT-05", "TINT-31"}
                    ELSE {"TINT-31", "TINT-35"}
               [] OTHER -> IF Blocked(o) \/ LostMeanwhile(past, o)
                           THEN {"IRT-04", "IRT-18", "TINT-08"}
                           ELSE {"TINT-60"}

(* The requirements that decide whether a delay is started. *)
\* @type: (Int, Seq($event)) => Set(Str);
StartedRequirements(o, past) ==
    LET last  == LastWith(past, {"SRT_DINT", "CAN_DINT", "start"}, o)
    IN  IF LastOf(past, {"restart"}) > last THEN {"DINT-13", "OBS-52"}
        ELSE IF Blocked(o) THEN {"IRT-04", "DINT-20"}
        ELSE IF last > 0 /\ past[last].event = "CAN_DINT" THEN {"DINT-14"}
        ELSE {}

(* The requirements of each wrong bit.                                     *)
\* @type: ($event, Int, Seq($event)) => Set(Str);
WrongBits(e, right, past) ==
    LET wrong(bit) == (e.status \div bit) % 2 # (right \div bit) % 2
        tods  == e.event = "QRY_TINT"
        valid == e.ob \in TodObs \cup DintObs
    IN  IF ~valid THEN {}
        ELSE When(tods /\ wrong(1), {"TINT-72"})
               \cup When(wrong(2),
                         {"IRT-17"} \cup When(IrtLines(past, e.ob) # {},
                                            BlockRequirements(past, e.ob)))
               \cup When(tods /\ wrong(2), {"TINT-73"})
               \cup When(tods /\ wrong(4),
                         {"TINT-74"} \cup ActiveRequirements(e.ob, past))
               \cup When(tods /\ wrong(8), {"TINT-75", "AMB-82"})
               \cup When(tods /\ wrong(16), {"TINT-76"})
               \cup When(tods /\ wrong(32), {"TINT-77"})
               \cup When(tods /\ wrong(64), {"TINT-78", "AMB-80"})
               \cup When(tods /\ e.status >= 128, {"TINT-79"})
               \cup When(~tods, {"DINT-16"})
               \cup When(~tods /\ wrong(4), StartedRequirements(e.ob, past))

(* The right value with the fewest wrong bits counts. *)
\* @type: ($event, Seq($event)) => Set(Str);
WrongStatus(e, past) ==
    LET sets == { WrongBits(e, s, past) : s \in RightStatuses(e) }
    IN  IF sets = {} THEN {"TINT-71"}
        ELSE CHOOSE s \in sets :
               \A t \in sets : Cardinality(s) <= Cardinality(t)

-----------------------------------------------------------------------------

\* @type: ($event, Seq($event)) => Set(Str);
OfCall(e, past) ==
    IF mode = "STOP" THEN {"OBS-41"}
    ELSE IF mode = "HOLD" THEN {"OBS-45"}
    ELSE IF Failed THEN {"OBS-61"}
    ELSE IF ~Called THEN {IF mode = "STARTUP" THEN "OBS-42" ELSE "OBS-01"}
    ELSE IF StandsBefore(e) THEN {"AIRT-08"}
    ELSE IF AnswerRight(e) THEN WrongStatus(e, past) ELSE WrongAnswer(e)

-----------------------------------------------------------------------------
(* Lines that come too late: something had to come before *)

Due == { r \in requests : MayGoOnWaiting(r) /\ ~r.open }

(* The due requests that are late by this line. *)
\* @type: $event => Set($request);
Late(e) ==
    { r \in Due : /\ WaitsAs(r) \in DOMAIN waiting
                  /\ waiting[WaitsAs(r)] + Span(up, e.up) > terms.latency }

\* @type: $event => Set($report);
ReportsLate(e) == EntriesLate(Span(up, e.up))

-----------------------------------------------------------------------------
(* Late OBs *)

(* The OB was held back until now, or was held back wrongly. *)
\* @type: ($request, Seq($event)) => Set(Str);
HeldBack(r, past) ==
    LET last  == LastStart(past, r.ob)
        delayed == LastOf(past, {"DIS_AIRT"})
    IN  ThoughNotBlocked(past, r.ob)
          \cup When(delayed > last, {"AIRT-02", "AIRT-08"})
          \cup When(/\ delayed > last
                    /\ LastOf(past, {"EN_AIRT"}) < LastOf(past, {"end"}),
                    {"AIRT-04"})
          \cup When(r.ob \in DOMAIN cpu.priority, {"OBS-05"})
          \cup When(Running.ob \notin {0, CycleOb} \cup StartupObs, {"OBS-01"})
          \cup When(/\ past # <<>> /\ past[Len(past)].event = "end"
                    /\ ~Before(past[Len(past)].at, r.since), {"OBS-03"})

\* @type: ($request, Seq($event)) => Set(Str);
LateTod(r, past) ==
    LET o    == r.ob
        last == LastStart(past, o)
        act  == LastWith(past, {"ACT_TINT"}, o)
        special ==
          SinceRun(past, o, last)
            \cup When(ClockWasSet(past, last) < 0, SinceClock(past, last))
            \cup When(cpu.step7[o].execution = "once" /\ last = 0, {"OBS-56"})
            \cup When(Blocked(o) \/ LastIn(IrtLines(past, o)) > last,
                      {"IRT-18"})
            \cup When(~TodCallsWithdrawRuns, {"TINT-50"})
            \cup When(~SecondRequestIsOpen, {"OBS-07"})
            \cup When(act > 0 /\ past[act].ret = -1, {"TINT-60"})
            \cup HeldBack(r, past)
    IN  special \cup Step7Requirements(o, past)
          \cup (IF HasOnePoint(r.word) THEN {"TINT-23"} ELSE {"TINT-09"})
          \cup When(special = {},
                    {"TINT-23"} \cup SeriesRequirements(o, r.word, past))

\* @type: ($request, Seq($event)) => Set(Str);
LateDint(r, past) ==
    {"DINT-06"} \cup (SinceRun(past, r.ob, LastStart(past, r.ob))
                       \ {"DINT-19"})
                \cup OfDelay(r.ob, past)
                \cup When(dint[r.ob].started
                            \/ LastWith(past, {"CAN_DINT"}, r.ob) > 0,
                          {"DINT-15"})
                \cup When(dint[r.ob].started, {"DINT-08"})
                \cup When(OfDelay(r.ob, past) = {}, {"DINT-03"})

\* @type: ($request, Seq($event)) => Set(Str);
LateRequirement(r, past) ==
    CASE r.ob \notin loaded          ->
           IF r.ob \in AsyncErrorObs THEN {"OBS-23", "OBS-21"}
           ELSE {"OBS-20"} \cup When(r.ob \in TodObs, {"TINT-16"})
                  \cup When(r.ob \in DintObs, {"DINT-09"})
                  \cup When(ProgramErrorOb \notin loaded, {"OBS-21"})
      [] r.follows = SkippedInHold   -> {"CLK-03", "OBS-46"}
      [] r.follows = SkippedByClock  -> {"CLK-03"}
      [] r.follows = StillRunning    ->
           When(r.ob \in TodObs, {"TINT-14"})
             \cup When(r.ob \in DintObs, {"DINT-10"})
             \cup When(LastIn(IrtLines(past, TimeErrorOb)) > 0, {"OBS-33"})
      [] r.ob \in DintObs            ->
           LateDint(r, past) \cup HeldBack(r, past)
      [] r.ob \in TodObs             -> LateTod(r, past)
      [] r.fault = SkippedByClock    -> {"CLK-02"} \cup HeldBack(r, past)
      [] r.fault = SkippedInHold     -> {"OBS-46"}
      [] r.ob = TimeErrorOb          ->
           {"OBS-30"} \cup When(r.cause \in TodObs, {"TINT-14"})
             \cup When(r.cause \in DintObs, {"DINT-10"}) \cup HeldBack(r, past)
      [] r.ob = ProgramErrorOb       -> {"OBS-20"} \cup HeldBack(r, past)
           \cup When(r.cause \in TodObs, {"TINT-16"})
           \cup When(r.cause \in DintObs, {"DINT-09"})
      [] OTHER                       ->
           SinceRun(past, r.ob, LastStart(past, r.ob))
             \cup (IF HeldBack(r, past) = {} THEN {"OBS-01", "OBS-03"}
                   ELSE HeldBack(r, past))

(* The requirements of a STOP that is due. *)
StopRequirements ==
    CASE stopCause = NoTimeErrorOb    -> {"OBS-22", "CLK-05"}
      [] stopCause = NoProgramErrorOb -> {"OBS-21"}
      [] stopCause = DeselectedLoaded -> {"OBS-25"}
      [] stopCause \in CausesOfSyncErrors -> {"OBS-27", "OBS-63"}
      [] OTHER                        -> {"OBS-23"}

-----------------------------------------------------------------------------
(* Late entries *)

\* @type: ($entry, Seq($event)) => Set(Str);
EntryRequirements(entry, past) ==
    CASE entry.id = EntriesDisabled  -> {"IRT-09"}
      [] entry.id = NoTimeErrorOb    -> {"OBS-22"}
      [] entry.id = NoProgramErrorOb -> {"OBS-21"}
      [] entry.of.ob = TimeErrorOb   ->
           {"OBS-30"}
             \cup When(Blocked(TimeErrorOb),
                       {"OBS-33"} \cup BlockRequirements(past, TimeErrorOb))
      [] OTHER                       -> {"OBS-20"}

-----------------------------------------------------------------------------

\* @type: ($event, Seq($event)) => Set(Str);
LateRequirements(e, past) ==
    UNION { LateRequirement(r, past) : r \in Late(e) }
      \cup UNION { EntryRequirements(r.entry, past) : r \in ReportsLate(e) }
      \cup When(StopDuty \in DOMAIN waiting, StopRequirements)
      \cup When(CallDuty \in DOMAIN waiting,
                {"OBS-61"} \cup When(delay > 0, {"AIRT-10"})
                  \cup When(irt.blocked # {}, {"IRT-05"}))

\* @type: ($event, Seq($event)) => Set(Str);
OfEntry(e, past) ==
    LET fault == e.id - ErrorEntry
        quiet == Silenced(TimeErrorOb) \/ Silenced(ProgramErrorOb)
    IN  CASE e.id = EntriesDisabled ->
               {"IRT-09"} \cup When(LastOf(past, {"EN_IRT"}) > 0, {"IRT-19"})
          [] e.id = NoTimeErrorOb       -> {"OBS-22"}
          [] e.id = NoProgramErrorOb    -> {"OBS-21"}
          [] e.id = DeselectedLoaded    -> {"OBS-25"}
          [] e.id \in CausesOfSyncErrors -> {"OBS-27", "OBS-63"}
          [] fault \in ObNotLoaded      ->
               {"OBS-20"} \cup When(quiet, {"IRT-09"})
          [] fault = SkippedByClock     ->
               {"OBS-30", "CLK-02"} \cup When(quiet, {"IRT-09"})
          [] fault = SkippedInHold      -> {"OBS-30", "OBS-46"}
          [] fault = BufferOverflow     -> {"OBS-30", "OBS-08"}
          [] OTHER                      ->
               {"OBS-30"} \cup When(quiet, {"IRT-09"})

(* The fields that are wrong.                                              *)
\* @type: $event => Set(Str);
OfState(e) ==
    {"OBS-60"}
      \cup When(~FitsTruth(e.blocked, Blocked(e.ob)), {"IRT-17"})
      \cup When(~FitsTruth(e.entries_off, Silenced(e.ob)), {"IRT-20"})
      \cup When(~FitsActive(e),
                IF e.ob \in TodObs THEN {"TINT-74"} ELSE {"DINT-16"})
      \cup When(~FitsLeft(e), {"DINT-17"})

\* @type: ($event, Seq($event)) => Set(Str);
Deciding(e, past) ==
    CASE ~KeepsPace(e)           -> {"CLK-01"}
      [] e.event \in CallEvents -> OfCall(e, past)
      [] e.event = "state"       -> OfState(e)
      [] e.event = "interrupt"   -> CASE e.ob = TimeErrorOb -> {"OBS-30"}
                                      [] e.ob \in SyncErrorObs -> {"OBS-61"}
                                      [] OTHER -> {"OBS-20"}
      [] e.event = "start"   ->
           OfStart(e, past) \cup When(stopCause # NoCause, StopRequirements)
      [] e.event = "diag"    -> OfEntry(e, past)
      [] e.event = "end"     -> IF mode = "HOLD" THEN {"OBS-45"}
                                ELSE IF mode = "STOP" THEN {"OBS-41"}
                                ELSE IF Failed THEN {"OBS-61"}
                                ELSE IF Running.ob = CycleOb \/ stack = <<>>
                                THEN {"OBS-01", "OBS-03"} ELSE {"OBS-03"}
      [] e.event = "restart" ->
           {"OBS-40"} \cup When(e.type = "cold", {"OBS-57"})
      [] e.event = "run"     -> IF stopCause # NoCause THEN StopRequirements
                                ELSE IF mode = "STARTUP" THEN {"OBS-42"}
                                ELSE {"OBS-40"}
      [] e.event = "stop"    ->
           IF mode = "STOP" THEN {"OBS-40"}
           ELSE IF {e.cause, stopCause} \cap CausesOfSyncErrors # {}
           THEN {"OBS-27", "OBS-63"}
           ELSE {"OBS-21", "OBS-22"}
                  \cup When(e.cause = DeselectedLoaded, {"OBS-25"})
                  \cup When(e.cause = NoTimeErrorOb, {"OBS-26"})
      [] OTHER               -> {"OBS-40"}

(* How far this state is from one that allows the line. The reasons of the *)
(* nearest states count.                                                   *)
\* @type: $event => Int;
Distance(e) ==
    CASE e.event \in CallEvents ->
           IF ~Called THEN 3
           ELSE IF BeforeItsEnd(e) THEN 2
           ELSE IF AnswerRight(e) THEN 0 ELSE 1
      [] e.event = "start" ->
           LET all == { Depth(r, e.info.flt_id) : r \in Candidates(e) }
           IN  IF mode = "STOP" THEN 11
               ELSE IF all = {} THEN IF mode = "RUN" THEN 9 ELSE 10
               ELSE 9 - (CHOOSE d \in all : \A k \in all : k <= d)
      [] e.event = "end" -> IF OnStack(e.ob) THEN 0 ELSE 1
      [] OTHER -> 0

-----------------------------------------------------------------------------
(* Why a line is possible *)

(* The requests by which the OB of the line starts. *)
\* @type: $event => Set($request);
Starting(e) ==
    { r \in requests : /\ r.ob = e.ob /\ MayStart(r)
                       /\ FitsFault(r.fault, e.info.flt_id) }

\* @type: ($event, Seq($event)) => Set(Str);
OfOrdinaryStart(e, past) ==
    CASE e.ob = CycleOb        -> {"OBS-01"}
      [] e.ob \in StartupObs   -> {"OBS-42"}
      [] e.ob \in SyncErrorObs -> {"OBS-61", "OBS-62"}
      [] e.ob \in ExternalObs \ {TimeErrorOb, ProgramErrorOb} ->
           {"OBS-01", "OBS-07"}
      [] OTHER -> UNION { LateRequirement(r, past) : r \in Starting(e) }

\* @type: $event => Set(Str);
OfInterrupt(e) ==
    CASE e.ob \in SyncErrorObs ->
           {"OBS-61"} \cup When(e.ob \notin loaded, {"OBS-27", "OBS-63"})
             \cup When(delay > 0, {"AIRT-10"})
             \cup When(irt.blocked # {}, {"IRT-05"})
      [] mode = "STOP"    -> {"OBS-41"}
      [] Deselected(e.ob) -> {"OBS-06"}
      [] Blocked(e.ob)    ->
           {"IRT-01", "IRT-04"} \cup When(Silenced(e.ob), {"IRT-09"})
      [] mode = "HOLD"    -> {"OBS-45"}
      [] mode = "STARTUP" ->
           {IF e.ob \in AsyncErrorObs THEN "OBS-43" ELSE "OBS-42"}
      [] OTHER            ->
           {"OBS-07"}
             \cup When(e.ob \in AsyncErrorObs, {"OBS-29"})
             \cup When(e.ob \notin loaded,
                       CASE e.ob = TimeErrorOb    -> {"OBS-22"}
                         [] e.ob = ProgramErrorOb -> {"OBS-21"}
                         [] e.ob \in AsyncErrorObs \cup {70, 72} -> {"OBS-23"}
                         [] OTHER                 -> {"OBS-20"})
             \cup When(~Undelayed, {"AIRT-01"})

\* @type: $moment => Set(Str);
OfClock(to) ==
    {"CLK-01"}
      \cup When(mode # "STOP" /\ SkippedBy(to) # {},
                {"CLK-02", "CLK-03"}
                  \cup When(TimeErrorOb \notin loaded, {"CLK-05"}))
      \cup When(mode # "STOP" /\ IsBack(to)
                  /\ \E o \in TodObs : tod[o].active,
                IF Family.repeats THEN {"CLK-10"} ELSE {"CLK-09"})

\* @type: ($event, Seq($event)) => Set(Str);
WhyPossible(e, past) ==
    CASE e.event \in CallEvents -> AnswerRequirements(e, e.ret)
      [] e.event = "start"      -> OfOrdinaryStart(e, past)
      [] e.event = "end"        -> {"OBS-03"} \cup When(delay > 0, {"AIRT-04"})
      [] e.event = "interrupt"  -> OfInterrupt(e)
      [] e.event = "clock"      -> OfClock(e.to)
      [] e.event = "restart"    -> {"OBS-40", "OBS-50"}
                                     \cup When(e.type = "cold", {"OBS-57"})
      [] e.event = "run"        -> {"OBS-42"}
      [] e.event = "hold"       -> {"OBS-45"}
      [] e.event = "release"    ->
           {"OBS-45"} \cup When(SkippedBy(clock) # {}, {"OBS-46"})
      [] e.event = "stop"       -> IF stopCause # NoCause THEN StopRequirements
                                   ELSE {"OBS-47"}
      [] e.event = "load"       -> {"OBS-20"}
      [] e.event = "delete"     -> IF PendingIn(requests, e.ob) THEN {"AMB-66"}
                                   ELSE {"OBS-20"}
      [] e.event = "diag"       -> OfEntry(e, past)
      [] OTHER                  -> {"OBS-60"}
=============================================================================

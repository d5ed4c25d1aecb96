------------------------------ MODULE Reasons -------------------------------
(***************************************************************************)
(* The requirements that someone who knows the log would cite for a line:  *)
(* why it is rejected (DecidingRules), why it comes too late (LateRules),  *)
(* why it is possible (PossibleRules). They follow from                    *)
(* the state just before the line, from the line e, and from the lines     *)
(* before it, `past'.                                                      *)
(*                                                                         *)
(* No action uses this module.                                             *)
(* Source: the requirement IDs.                                            *)
(* Left out: the lines that are allowed instead (Explain).                 *)
(***************************************************************************)
EXTENDS StartReasons, NextLines, FamilyReasons, OrderOfReasons

-----------------------------------------------------------------------------
(* RET_VAL *)

\* @type: ($event, Int) => Set(Str);
SetRequirements(e, ret) ==
    CASE ret = OK        -> {"TINT-30"}
      [] ret = BadOb     -> {"TINT-01", "TINT-35"}
      [] ret = BadSdt    ->
           CASE e.period = Monthly    -> {"TINT-18", "TINT-39"}
             [] e.period = EndOfMonth -> {"TINT-19", "TINT-39"}
             [] e.period = Yearly     -> {"TINT-32", "TINT-39"}
             [] OTHER                 -> {"TINT-39", "TINT-35"}
      [] ret = BadPeriod -> {"TINT-33", "TINT-35"}
      [] ret = PastStart ->
           {"TINT-36"} \cup When(~HasOnePoint(e.period), {"TINT-37"})
                       \cup When(/\ MinuteOf(e.sdt) = clock.min
                                 /\ e.sdt.second # 0 \/ e.sdt.ms # 0,
                                 {"TINT-11"})
      [] OTHER           -> {"TINT-22"}

\* @type: ($event, Int, Seq($event)) => Set(Str);
CanRequirements(e, ret, past) ==
    CASE ret = OK    -> {"TINT-50"} \cup When(e.ob \in TodObs /\ tod[e.ob].set
                                               /\ ~tod[e.ob].active,
                                             {"TINT-52"})
      [] ret = BadOb -> {"TINT-01", "TINT-51"}
      [] ret = NotSet -> {"TINT-51"} \cup WhetherSet(e.ob, past)
                           \cup When(tod[e.ob].set /\ ~tod[e.ob].active,
                                     {"TINT-52"})
      [] OTHER -> {"TINT-22"}

\* @type: ($event, Int, Seq($event)) => Set(Str);
ActRequirements(e, ret, past) ==
    CASE ret = OK -> {"TINT-60"} \cup When(tod[e.ob].active, {"TINT-63"})
      [] ret = PastStart ->
           IF ~HasOnePoint(tod[e.ob].period) THEN {"TINT-62"}
           ELSE {"TINT-61"}
                  \cup When(LastStart(past, e.ob)
                              > LastWith(past, {"SET_TINT"}, e.ob),
                            {"TINT-64"})
                  \cup When(tod[e.ob].active, {"TINT-63"})
      [] ret = NotSet ->
           LET why == WhetherSet(e.ob, past)
           IN  {"TINT-61"} \cup why
                 \cup When({"TINT-08", "OBS-56"} \cap why # {}, {"TINT-64"})
                 \cup When(tod[e.ob].active, {"TINT-63"})
      [] ret = BadOb  -> {"TINT-01", "TINT-61"}
      [] OTHER -> {"TINT-22"}

\* @type: ($event, Int, Seq($event)) => Set(Str);
SrtRequirements(e, ret, past) ==
    CASE ret = OK       ->
           {"DINT-03"} \cup When(dint[e.ob].started, {"DINT-07"})
                       \cup When(OnStack(e.ob), {"DINT-08"})
      [] ret = BadOb    -> {"DINT-05"}
      [] ret = BadDtime -> {"DINT-04"}
      [] OTHER          -> {"DINT-21"}

(* A job is running, waits, or is over.                                    *)
\* @type: ($event, Int, Seq($event)) => Set(Str);
CanDintRequirements(e, ret, past) ==
    LET srt == LastWith(past, {"SRT_DINT"}, e.ob)
    IN  CASE ret = BadOb      -> {"DINT-05", "DINT-14"}
          [] ret = NotStarted ->
               {"DINT-14"}
                 \cup When(\/ LastStart(past, e.ob) > srt
                           \/ PendingIn(requests, e.ob) \/ Unseen("ob"),
                           {"DINT-15"})
                 \cup When(LastReset(past) > srt, {"DINT-13", "OBS-52"})
                 \cup When(LastHot(past) > srt, {"OBS-52"})
                 \cup When(SetInStartup(past, srt), {"OBS-55", "DINT-11"})
                 \cup When(dint[e.ob].started /\ dint[e.ob].left <= 2,
                           {"DINT-06"})
          [] OTHER            -> {"DINT-14"}

(* The class, or the OB, that MODE asks OB_NR for. *)
\* @type: $event => Set(Str);
NumberRequirements(e) ==
    CASE e.ob \in 120..122   -> {"IRT-05", "IRT-23"}
      [] Level(e.mode) = 0 -> {"IRT-06"}
      [] Level(e.mode) = 1 -> {"IRT-07"}
      [] OTHER             -> {"IRT-08"}

\* @type: ($event, Int) => Set(Str);
IrtRequirements(e, ret) ==
    CASE e.event = "EN_IRT" /\ ret \in {BadOb, BadMode}
           /\ e.mode \in DisModes \ EnModes -> {"IRT-13", "AMB-76"}
      [] ret = OK      ->
           OfMode(e)
             \cup When(e.event = "EN_IRT",
                       {IF Meant(e.mode, e.ob) \cap irt.blocked = {}
                        THEN "IRT-24" ELSE "IRT-15"})
      [] ret = BadMode ->
           {"IRT-12"} \cup When(e.event = "EN_IRT", {"IRT-13"})
                      \cup When(/\ e.event = "DIS_IRT" /\ e.mode \in DisModes
                                /\ WithoutEntries(e.mode),
                                {"IRT-09"})
      [] ret = BadOb   -> {"IRT-12"} \cup NumberRequirements(e)
      [] OTHER         -> {"IRT-22"}

(* A general error code. *)
\* @type: $event => Set(Str);
GeneralRequirements(e) ==
    {"AMB-81"} \cup
      CASE e.event \in {"DIS_AIRT", "EN_AIRT"}              -> {"AIRT-16"}
        [] e.event \in {"DIS_IRT", "EN_IRT"}                -> {"IRT-22"}
        [] e.event \in {"SRT_DINT", "CAN_DINT", "QRY_DINT"} -> {"DINT-21"}
        [] OTHER                                            -> {"TINT-22"}

(* What has ended the count of SFC 41, or would have: the end of its OB,   *)
(* or a restart.                                                           *)
\* @type: ($event, Seq($event)) => Set(Str);
CountRequirements(e, past) ==
    LET last  == LastOf(past, {"DIS_AIRT"})
        ended == e.ret = IF e.event = "DIS_AIRT" THEN 1 ELSE NotDelayed
    IN  {"AIRT-03"}
          \cup When(last > 0 /\ LastOf(past, {"restart"}) > last, {"OBS-54"})
          \cup When(/\ LastHot(past) <= last
                    /\ \/ last > 0 /\ LastOf(past, {"end", "run"}) > last
                       \/ delay > 0 /\ ended, {"AIRT-04"})

(* [A15-24] A call without a text may answer any code of a number that no  *)
(* OB has, of which nothing can be set or started.                         *)
\* @type: ($event, Int) => Bool;
IsOfNoOb(e, ret) ==
    /\ ret # BadOb
    /\ \/ e.event = "ACT_TINT" /\ e.ob \notin TodObs
       \/ e.event = "CAN_DINT" /\ e.ob \notin DintObs

\* @type: ($event, Int, Seq($event)) => Set(Str);
AnswerRequirements(e, ret, past) ==
    CASE IsGeneralError(ret) -> GeneralRequirements(e)
      [] IsOfNoOb(e, ret)    -> {"A15-24"}
      [] e.event = "SET_TINT" -> SetRequirements(e, ret)
      [] e.event = "SET_TINTL" -> {"T15-141"} \cup SetRequirements(e, ret)
      [] e.event = "CAN_TINT" -> CanRequirements(e, ret, past)
      [] e.event = "ACT_TINT" -> ActRequirements(e, ret, past)
      [] e.event = "QRY_TINT" ->
           {"TINT-70"} \cup When(ret = BadOb, {"TINT-01"})
      [] e.event = "SRT_DINT" -> SrtRequirements(e, ret, past)
      [] e.event = "CAN_DINT" -> CanDintRequirements(e, ret, past)
      [] e.event = "QRY_DINT" ->
           {"DINT-16"} \cup When(ret = BadOb, {"DINT-05"})
      [] e.event \in {"DIS_IRT", "EN_IRT"} -> IrtRequirements(e, ret)
      [] e.event = "DIS_AIRT" -> {"AIRT-06"} \cup CountRequirements(e, past)
      [] OTHER                -> {"AIRT-07"} \cup CountRequirements(e, past)

(* What decides is an error that had to come, or one that did not apply;   *)
(* the rule of success only where success was right.                       *)
\* @type: ($event, Seq($event)) => Set(Str);
WrongAnswer(e, past) ==
    LET right   == RightAnswers(e)
        telling == {e.ret} \cup right
        told    == IF BadOb \in right THEN right
                   ELSE IF OK \in right \/ telling = {OK} THEN telling
                   ELSE telling \ {OK}
    IN  UNION { AnswerRequirements(e, r, past) : r \in told }
          \cup When(/\ e.event \notin {"DIS_IRT", "EN_IRT", "DIS_AIRT",
                                       "EN_AIRT"}
                    /\ e.ob \in TodObs \cup DintObs
                    /\ Deselected(e.ob), {"OBS-25"})

-----------------------------------------------------------------------------
(* STATUS *)

(* The requirements that decide whether a time-of-day interrupt is active. *)
\* @type: (Int, Seq($event)) => Set(Str);
ActiveRequirements(o, past) ==
    LET last  == LastWith(past,
                          {"SET_TINT", "CAN_TINT", "ACT_TINT", "start"}, o)
        reset == LastReset(past)
        once  == When(cpu.step7[o].execution = "once", {"OBS-56"})
    IN  IF tod[o].active /\ ~HasOnePoint(tod[o].period) /\ tod[o].next = Never
        THEN {}  \* a series without a further point
        ELSE IF reset > last THEN {"OBS-50", "TINT-38"} \cup once
        ELSE IF LastHot(past) > last THEN {"AMB-26", "OBS-52"}
        ELSE IF PendingIn(requests, o) /\ HasOnePoint(tod[o].period)
        THEN {"TINT-08"}
        ELSE IF last = 0 THEN {"TINT-06"} \cup once
        ELSE CASE past[last].event = "start"    ->
                    IF tod[o].set /\ ~HasOnePoint(tod[o].period)
                    THEN {"TINT-09"}
                           \cup SinceClock(past, StartBefore(past, o))
                    ELSE AfterOnce(o, past)
               [] past[last].event = "CAN_TINT" -> {"TINT-50"}
               [] NameOf(past[last]) = "SET_TINT" /\ past[last].activate # 1 ->
                    IF Worked(past[last]) THEN {"TINT-05", "TINT-31"}
                    ELSE {"TINT-31", "TINT-35"}
               [] OTHER ->
                    IF Blocked(o) \/ LostMeanwhile(past, o)
                    THEN {"IRT-04", "IRT-18", "TINT-08"}
                    ELSE {"TINT-60"}
                           \cup When(SetInStartup(past, last), {"OBS-55"})

(* The requirements that decide whether a delay is started. *)
\* @type: (Int, Seq($event)) => Set(Str);
StartedRequirements(o, past) ==
    LET last  == LastWith(past, {"SRT_DINT", "CAN_DINT", "start"}, o)
    IN  IF LastOf(past, {"restart"}) > last THEN {"DINT-13", "OBS-52"}
        ELSE IF Blocked(o) THEN {"IRT-04", "DINT-20"}
        ELSE IF last > 0 /\ past[last].event = "CAN_DINT" THEN {"DINT-14"}
        ELSE When(SetInStartup(past, last), {"OBS-55"})

(* The requirements that decide whether the OB shows as blocked: a delay   *)
(* by SFC 41 does not show.                                                *)
\* @type: (Int, Seq($event)) => Set(Str);
ShownBlocked(o, past) ==
    IF delay > 0 /\ ~Blocked(o) THEN {"AIRT-13"}
    ELSE {"IRT-17"} \cup When(IrtLines(past, o) # {},
                              BlockRequirements(past, o))

(* The requirements of each wrong bit.                                     *)
\* @type: ($event, Int, Seq($event)) => Set(Str);
WrongBits(e, right, past) ==
    LET wrong(bit) == (e.status \div bit) % 2 # (right \div bit) % 2
        tods  == e.event = "QRY_TINT"
        valid == e.ob \in TodObs \cup DintObs
    IN  IF ~valid THEN {}
        ELSE When(tods /\ wrong(1), {"TINT-72"})
               \cup When(wrong(2), ShownBlocked(e.ob, past))
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
    ELSE IF AnswerRight(e) THEN WrongStatus(e, past) ELSE WrongAnswer(e, past)

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
          \cup When(delayed > last,
                    {"AIRT-02"} \cup When(~Blocked(r.ob), {"AIRT-08"})
                      \cup When(r.ob \in AsyncErrorObs, {"AIRT-09"}))
          \cup When(/\ delayed > last
                    /\ LastOf(past, {"EN_AIRT"}) < LastOf(past, {"end"}),
                    {"AIRT-04"})
          \cup When(r.ob \in DOMAIN cpu.priority, {"OBS-05"})
          \cup When(/\ Running.ob \notin {0} \cup CycleObs \cup StartupObs
                    /\ r.ob # TimeErrorOb, {"OBS-01"})
          \cup When(/\ past # <<>> /\ past[Len(past)].event = "end"
                    /\ ~Before(past[Len(past)].at, r.since),
                    IF ClassOf(past[Len(past)].ob) = r.class
                    THEN {"OBS-02"} \cup When(r.ob \in TodObs, {"TINT-12"})
                                    \cup When(r.ob \in AsyncErrorObs,
                                              {"OBS-11"})
                    ELSE {"OBS-03"})

(* [A15-17] A point that comes again had not run, and the clock was set    *)
(* back by less than the step of the family.                               *)
\* @type: ($request, Seq($event)) => Bool;
ComesAgainUnserved(r, past) ==
    LET set == LastOf(past, {"clock"})
    IN  /\ Family.byKind /\ set > 0
        /\ ~Before(past[set].at, r.since)
        /\ OfTheJump(past) = {"T15-93"}

\* @type: ($request, Seq($event)) => Set(Str);
LateTod(r, past) ==
    LET o    == r.ob
        last == LastStart(past, o)
        act  == LastWith(past, {"ACT_TINT"}, o)
        calls == LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT"}, o)
        special ==
          (SinceRun(past, o, last, r.since)
             \ When(~CameBeforeRun(r, past), {"TINT-13"}))
            \cup When(ClockWasSet(past, last) # 0,
                      IF ComesAgainUnserved(r, past) THEN {"A15-17"}
                      ELSE SinceClock(past, last))
            \cup When(ClockWasSet(past, StartBefore(past, o)) > 0, {"CLK-08"})
            \cup When(/\ cpu.step7[o].execution = "once"
                      /\ last <= LastReset(past), {"OBS-56"})
            \cup When(LastReset(past) > calls /\ calls > 0, {"OBS-50"})
            \cup When(SetInStartup(past, act), {"OBS-55"})
            \cup When(~Blocked(o) /\ LastIn(IrtLines(past, o)) > last,
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
    LET srt  == LastWith(past, {"SRT_DINT"}, r.ob)
        last == LastStart(past, r.ob)
    IN  {"DINT-06"}
                \cup (IF LastHot(past) > srt THEN {"DINT-13"}
                      ELSE SinceRun(past, r.ob, LastIn({last, srt}), r.since)
                             \ {"DINT-19"})
                \cup OfDelay(r.ob, past)
                \cup When(dint[r.ob].started
                            \/ LastWith(past, {"CAN_DINT"}, r.ob) > 0,
                          {"DINT-15"})
                \cup When(\/ dint[r.ob].started
                          \/ LastStart(past, r.ob) \in 1..srt, {"DINT-08"})
                \cup When(SetInStartup(past, srt), {"OBS-55"})
                \cup When(OfDelay(r.ob, past) = {}, {"DINT-03"})

(* The rules by which OB 85 is called in place of a missing OB.            *)
\* @type: Int => Set(Str);
OfMissing(o) ==
    {"OBS-20"} \cup When(o \in TodObs, {"TINT-16", "TINT-17"})
               \cup When(o \in DintObs, {"DINT-09"})

\* @type: ($request, Seq($event)) => Set(Str);
LateRequirement(r, past) ==
    CASE r.ob \notin loaded          ->
           IF r.ob \in AsyncErrorObs THEN {"OBS-23", "OBS-21"}
           ELSE OfMissing(r.ob)
                  \cup When(ProgramErrorOb \notin loaded, {"OBS-21"})
      [] r.follows \in Skips         ->
           {"CLK-03"} \cup When(r.follows = SkippedInHold, {"OBS-46"})
                      \cup When(HasOnePoint(r.word), {"CLK-13"})
                      \cup When(TouchedInOb80(r.ob, past), {"CLK-04"})
      [] r.follows \in LocalSkips    -> OfFault(r.follows, 0)
      [] r.follows = StillRunning    ->
           OfFault(r.follows, r.ob)
             \cup When(r.ob \in ExternalObs, {"OBS-30", "AMB-77"})
             \cup When(LastIn(IrtLines(past, TimeErrorOb)) > 0, {"OBS-33"})
      [] r.ob \in DintObs            ->
           LateDint(r, past) \cup HeldBack(r, past)
      [] r.ob \in TodObs             -> LateTod(r, past)
      [] r.ob = TimeErrorOb          ->
           {"OBS-30"} \cup OfFault(r.fault, r.cause) \cup HeldBack(r, past)
             \cup When(r.fault = StillRunning, ComesAgain(past, r.cause))
             \cup When(LastOf(past, {"hold"}) > LastStart(past, r.ob),
                       {"OBS-45"})
      [] r.ob = ProgramErrorOb       ->
           OfMissing(r.cause) \cup HeldBack(r, past)
             \cup ThoughNotBlocked(past, r.cause)
             \cup When(MissingObEndsItsSource, {"OBS-28"})
      [] OTHER                       ->
           SinceRun(past, r.ob, LastStart(past, r.ob), r.since)
             \cup When(r.ob \in AsyncErrorObs, {"OBS-29"})
             \cup (IF HeldBack(r, past) = {} THEN {"OBS-01", "OBS-03"}
                   ELSE HeldBack(r, past))

(* A time error stops the CPU: the last line, or an OB that runs, has      *)
(* caused it.                                                              *)
\* @type: Seq($event) => Set(Str);
OfTimeErrorStop(past) ==
    LET last == IF past = <<>> THEN "" ELSE past[Len(past)].event
    IN  {"OBS-22"}
          \cup (CASE last = "clock"   -> {"CLK-05"}
                  [] last = "release" -> {"OBS-46"}
                  [] OTHER -> UNION { OfFault(StillRunning, stack[i].ob)
                                      : i \in DOMAIN stack })
          \cup When(overruns = 2, {"OBS-26"})
          \cup When(delay > 0, {"AIRT-11"})

(* The requirements of a STOP that is due. *)
\* @type: Seq($event) => Set(Str);
StopRequirements(past) ==
    CASE stopCause = NoTimeErrorOb    -> OfTimeErrorStop(past)
      [] stopCause = NoProgramErrorOb ->
           {"OBS-21"}
             \cup When(past # <<>> /\ past[Len(past)].event = "interrupt",
                       {"OBS-20"})
             \cup When(\E o \in TodObs \ loaded : tod[o].active, {"TINT-16"})
             \cup When(\E o \in DintObs \ loaded :
                         LastWith(past, {"SRT_DINT"}, o) > 0, {"DINT-09"})
      [] stopCause = DeselectedLoaded ->
           {"OBS-25"} \cup When(\E o \in loaded : ClassOf(o) = 0, {"OBS-06"})
      [] stopCause \in CausesOfSyncErrors ->
           IF \E o \in SyncErrorObs \cap loaded : CauseOf(o) = stopCause
           THEN {"AMB-85", "OBS-63"} ELSE {"OBS-27", "OBS-63"}
      [] OTHER                        -> {"OBS-23"}

-----------------------------------------------------------------------------
(* Late entries *)

\* @type: ($entry, Seq($event)) => Set(Str);
EntryRequirements(entry, past) ==
    CASE entry.id = EntriesDisabled  -> {"IRT-09"}
      [] entry.id = NoTimeErrorOb    -> {"OBS-22"}
      [] entry.id = NoProgramErrorOb -> {"OBS-21"}
      [] entry.of.ob = TimeErrorOb   ->
           {"OBS-30"} \cup OfFault(entry.of.fault, entry.of.cause)
             \cup When(Blocked(TimeErrorOb),
                       {"OBS-33"} \cup BlockRequirements(past, TimeErrorOb))
             \cup When(LastOf(past, {"restart"})
                         > LastIn(IrtLines(past, TimeErrorOb))
                       /\ IrtLines(past, TimeErrorOb) # {},
                       {"IRT-03", "OBS-53"})
      [] OTHER                       ->
           OfMissing(entry.of.cause)
             \cup When(Blocked(ProgramErrorOb),
                       BlockRequirements(past, ProgramErrorOb))

-----------------------------------------------------------------------------

(* A line in seconds that stands for a moment behind this one tells least. *)
\* @type: $event => Int;
LateDistance(e) == IF IsOver(e) THEN 1 ELSE 0

\* @type: ($event, Seq($event)) => Set(Str);
LateRules(e, past) ==
    IF IsOver(e) THEN {"CLK-01"}
    ELSE UNION { LateRequirement(r, past) \cup SinceHotRestart(r.ob, past)
            : r \in Late(e) }
      \cup UNION { EntryRequirements(r.entry, past) : r \in ReportsLate(e) }
      \cup When(StopDuty \in DOMAIN waiting, StopRequirements(past))
      \cup When(CallDuty \in DOMAIN waiting,
                {"OBS-61"} \cup When(delay > 0, {"AIRT-10"})
                  \cup When(irt.blocked # {}, {"IRT-05"}))

(* The entries that the line may show, were its fields right.              *)
\* @type: $event => Set($report);
EntriesMeant(e) ==
    { r \in reports : FitsEntry(r.entry, [e EXCEPT !.info = NoInfo, !.ob = 0,
                                                   !.priority = -1]) }

\* @type: ($report, $event) => Set(Str);
EntryInfo(r, e) == ErrorInfo(r.entry.of, e.info)
                     \cup When(~FitsMoment(r, e), {"OBS-10"})

(* The entries that the log has to show, and does not show by this line.   *)
\* @type: Seq($event) => Set(Str);
OfEntriesDue(past) ==
    IF ~DiagRecorded THEN {}
    ELSE UNION { EntryRequirements(r.entry, past) : r \in reports }
           \cup When(\E o \in AsyncErrorObs \ loaded :
                       LastWith(past, {"interrupt"}, o) > 0, {"OBS-23"})

\* @type: ($event, Seq($event)) => Set(Str);
OfEntry(e, past) ==
    LET fault == e.id - ErrorEntry
        quiet == Silenced(TimeErrorOb) \/ Silenced(ProgramErrorOb)
        meant == EntriesMeant(e)
    IN  CASE e.id = EntriesDisabled ->
               {"IRT-09"} \cup When(LastOf(past, {"EN_IRT"}) > 0, {"IRT-19"})
          [] e.id \in CausesOfRules ->
               (CASE e.id = NoTimeErrorOb    -> {"OBS-22"}
                  [] e.id = NoProgramErrorOb -> {"OBS-21"}
                  [] e.id = DeselectedLoaded -> {"OBS-25"}
                  [] OTHER                   -> {"OBS-27", "OBS-63"})
                 \cup When(stopCause # NoCause, StopRequirements(past))
                 \cup OfEntriesDue(past)
          [] meant # {}             ->
               UNION { EntryInfo(r, e) : r \in meant }
                 \cup When(\A r \in meant : EntryInfo(r, e) = {},
                           IF fault \in ObNotLoaded THEN {"OBS-20"}
                           ELSE {"OBS-30"})
          [] OTHER                  ->
               (IF fault \in ObNotLoaded THEN OfMissing(0) ELSE {"OBS-30"})
                 \cup OfFault(fault, 0)
                 \cup When(quiet, {"IRT-09"})
                 \cup When(LastOf(past, {"hold"}) > LastOf(past, {"release"}),
                           {"OBS-45"})
                 \cup OfEntriesDue(past)

(* The fields that are wrong.                                              *)
\* @type: ($event, Seq($event)) => Set(Str);
OfState(e, past) ==
    {"OBS-60"}
      \cup When(~FitsTruth(e.blocked, Blocked(e.ob)),
                ShownBlocked(e.ob, past))
      \cup When(~FitsTruth(e.entries_off, Silenced(e.ob)), {"IRT-20"})
      \cup When(~FitsActive(e),
                IF e.ob \in TodObs
                THEN {"TINT-74"} \cup ActiveRequirements(e.ob, past)
                ELSE {"DINT-16"} \cup StartedRequirements(e.ob, past))
      \cup When(~FitsLeft(e), {"DINT-17"})

\* @type: ($event, Seq($event)) => Set(Str);
OfEnd(e, past) ==
    CASE mode = "HOLD" -> {"OBS-45"}
      [] mode = "STOP" -> {"OBS-41"}
      [] Failed -> {"OBS-61"}
      [] mode = "STARTUP" /\ e.ob \in CycleObs -> {"OBS-42"}
      [] OTHER ->
           {"OBS-03"}
             \cup When(Running.ob \in {0} \cup CycleObs, {"OBS-01"})
             \cup When(LastWith(past, {"CAN_TINT"}, Running.ob)
                         > LastStart(past, Running.ob), {"TINT-53"})

(* The cause that the line names, and the one that is due. *)
\* @type: ($event, Seq($event)) => Set(Str);
OfStop(e, past) ==
    IF mode = "STOP" THEN {"OBS-40"}
    ELSE (CASE e.cause = NoTimeErrorOb    -> {"OBS-22"} \cup When(overruns > 0,
                                                           {"OBS-26"})
            [] e.cause = NoProgramErrorOb -> {"OBS-21"}
            [] e.cause = DeselectedLoaded -> {"OBS-25"}
            [] OTHER                      -> {"OBS-27", "OBS-63"})
           \cup When(stopCause # NoCause, StopRequirements(past))

\* @type: ($event, Seq($event)) => Set(Str);
DecidingRules(e, past) ==
    CASE ~KeepsPace(e)           -> {"CLK-01"}
      [] e.event \in CallEvents -> OfCall(e, past)
      [] e.event = "state"       -> OfState(e, past)
      [] e.event = "interrupt"   ->
           CASE e.ob = TimeErrorOb -> {"OBS-30"} \cup OfFault(e.flt_id, 0)
             [] e.ob \in SyncErrorObs -> {"OBS-61"}
             [] OTHER -> {"OBS-20"}
      [] e.event = "start"   ->
           OfStart(e, past)
             \cup When(stopCause # NoCause, StopRequirements(past))
      [] e.event = "diag"    -> OfEntry(e, past)
      [] e.event = "end"     -> OfEnd(e, past)
      [] e.event = "restart" ->
           {"OBS-40"} \cup When(e.type # "warm", {"OBS-57"})
      [] e.event = "run"     -> IF stopCause # NoCause
                                THEN StopRequirements(past)
                                ELSE IF mode = "STARTUP" THEN {"OBS-42"}
                                ELSE {"OBS-40"}
      [] e.event = "stop"    -> OfStop(e, past)
      [] OTHER               ->
           {"OBS-40"} \cup When(mode = "HOLD", {"OBS-45"})
                      \cup When(mode = "STARTUP", {"OBS-42"})

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
               ELSE IF /\ e.ob \in CycleObs \cup StartupObs
                       /\ DiffersInInfoAlone(e) THEN 0
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
    CASE e.ob \in CycleObs    -> {"OBS-01"}
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

(* The log's last line of SFC 41 and 42 has left a delay, which is over: an *)
(* end of the OB that is not in the log has ended it.                      *)
\* @type: Seq($event) => Bool;
DelayEndedUnseen(past) ==
    LET last == LastOf(past, {"DIS_AIRT", "EN_AIRT"})
    IN  /\ delay = 0 /\ last > 0
        /\ past[last].ret \notin {0, NotDelayed}
        /\ past[last].event = "EN_AIRT" => past[last].ret > 0
        /\ LastOf(past, {"start", "end", "run", "stop", "restart"}) < last

\* @type: ($event, Seq($event)) => Set(Str);
PossibleRules(e, past) ==
    When(/\ e.event \in {"start", "DIS_AIRT", "EN_AIRT"}
         /\ DelayEndedUnseen(past), {"AIRT-04"}) \cup
    CASE e.event \in CallEvents -> AnswerRequirements(e, e.ret, past)
      [] e.event = "start"      -> OfOrdinaryStart(e, past)
      [] e.event = "end"        -> {"OBS-03"} \cup When(delay > 0, {"AIRT-04"})
      [] e.event = "interrupt"  -> OfInterrupt(e)
      [] e.event = "clock"      -> OfClock(e.to)
      [] e.event = "zone"       ->
           IF e.reason = "zone" THEN {"T15-98", "T15-103"}
           ELSE {IF e.zone > cpu.zone THEN "T15-96" ELSE "T15-97"}
      [] e.event = "restart"    ->
           {"OBS-40"} \cup (IF e.type = "hot" THEN {"OBS-52", "OBS-53"}
                           ELSE {"OBS-50"})
                      \cup When(e.type # "warm", {"OBS-57"})
      [] e.event = "run"        -> {"OBS-42"}
      [] e.event = "hold"       -> {"OBS-45"}
      [] e.event = "release"    ->
           {"OBS-45"} \cup When(SkippedBy(clock) # {}, {"OBS-46"})
      [] e.event = "stop"       -> IF stopCause # NoCause
                                   THEN StopRequirements(past)
                                   ELSE {"OBS-47"}
      [] e.event = "load"       -> {"OBS-20"}
      [] e.event = "delete"     -> IF PendingIn(requests, e.ob) THEN {"AMB-66"}
                                   ELSE {"OBS-20"}
      [] e.event = "diag"       -> OfEntry(e, past)
      [] e.event = "done"       -> {}
      [] OTHER                  -> {"OBS-60"}

-----------------------------------------------------------------------------
(* What a hot restart keeps                                                *)

(* The line shows a setting, a job, a block, a count, a request or an OB   *)
(* that a hot restart keeps [OBS-52] [OBS-54].                             *)
\* @type: $event => Bool;
DependsOnKept(e) ==
    LET \* @type: Int => Bool;
        wrong(bit) == \A s \in RightStatuses(e) :
                        (e.status \div bit) % 2 # (s \div bit) % 2
    IN  CASE e.event = "QRY_TINT" -> e.ob \in TodObs /\ (wrong(2) \/ wrong(4))
          [] e.event = "QRY_DINT" -> /\ e.ob \in DintObs
                                     /\ wrong(2) \/ wrong(4)
          [] e.event \in CallEvents ->
               \A ret \in {e.ret} \cup RightAnswers(e) :
                 \/ ret \in {OK, NotSet, NotStarted, PastStart, NotDelayed}
                 \/ e.event \in {"DIS_AIRT", "EN_AIRT"} /\ ret <= 32767
          [] e.event = "start" ->  \* not where start information is wrong
               \/ delay > 0
               \/ \A r \in Candidates(e) : Depth(r, e.info.flt_id) < 9
          [] OTHER             -> e.event = "end"

-----------------------------------------------------------------------------
(* By the words of the family                                              *)

\* @type: ($event, Seq($event)) => Set(Str);
Deciding(e, past) ==
    LET kept == When(e.event = "start" /\ delay > 0, SinceHotRestart(0, past))
    IN  Cited(e, past,
              DecidingRules(e, past)
                \cup When(DependsOnKept(e),
                          IF kept = {} THEN SinceHotRestart(e.ob, past)
                          ELSE kept))

\* @type: ($event, Seq($event)) => Set(Str);
LateRequirements(e, past) == Cited(e, past, LateRules(e, past))
\* @type: ($event, Seq($event)) => Set(Str);
WhyPossible(e, past) == Cited(e, past, PossibleRules(e, past))
=============================================================================

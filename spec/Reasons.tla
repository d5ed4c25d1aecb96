------------------------------- MODULE Reasons ------------------------------
(***************************************************************************)
(* The requirements that decide about a line of a log which has no         *)
(* explanation: those that a person would name who knows the log.  They    *)
(* follow from the state before the line, from the line e, and from the    *)
(* lines before it, `past': the latest ones, and of older ones the last    *)
(* of each event, OB and MODE.                                             *)
(*                                                                         *)
(* No action uses what is said here.                                       *)
(* Source: the requirement IDs of the catalogue.                           *)
(* Left out: what is allowed instead, which is in Explain.                 *)
(***************************************************************************)
EXTENDS Unrecorded

-----------------------------------------------------------------------------
(* The lines before *)

\* @type: Set(Int) => Int;
LastIn(positions) ==
    IF positions = {} THEN 0
    ELSE CHOOSE i \in positions : \A k \in positions : k <= i

(* The last of these events; of those of an OB; 0 if there is none. *)
\* @type: (Seq($event), Set(Str)) => Int;
LastOf(past, names) == LastIn({ i \in DOMAIN past : past[i].event \in names })
\* @type: (Seq($event), Set(Str), Int) => Int;
LastWith(past, names, o) ==
    LastIn({ i \in DOMAIN past : past[i].event \in names /\ past[i].ob = o })

\* @type: (Seq($event), Int) => Int;
LastStart(past, o) == LastWith(past, {"start"}, o)

(* How often since the position i. *)
\* @type: (Seq($event), Set(Str), Int, Int) => Int;
TimesSince(past, names, o, i) ==
    Cardinality({ k \in DOMAIN past : /\ k > i /\ past[k].ob = o
                                     /\ past[k].event \in names })

\* @type: $event => Bool;
Worked(e) == e.ret \in {OK, -1}

(* Requirements that count only under a condition. *)
\* @type: (Bool, Set(Str)) => Set(Str);
When(condition, ids) == IF condition THEN ids ELSE {}

(* The last time that the clock was set: 1 forward, -1 back, 0 not, since   *)
(* the position i.                                                         *)
\* @type: (Seq($event), Int) => Int;
ClockWasSet(past, i) ==
    LET k == LastOf(past, {"clock"})
    IN  IF k <= i THEN 0 ELSE IF Before(past[k].to, past[k].at) THEN -1 ELSE 1

-----------------------------------------------------------------------------
(* SFC 39 and SFC 40 in the past *)

\* @type: ($event, Int) => Bool;
Means(e, o) == /\ e.event \in {"DIS_IRT", "EN_IRT"} /\ Worked(e)
               /\ CASE Level(e.mode) = 0 -> TRUE
                    [] Level(e.mode) = 1 -> ClassNumber(o) = e.ob
                    [] OTHER             -> o = e.ob

\* @type: (Seq($event), Int) => Set(Int);
IrtLines(past, o) == { i \in DOMAIN past : Means(past[i], o) }

\* @type: $event => Set(Str);
OfMode(e) ==
    IF e.event = "EN_IRT"
    THEN {"IRT-13"} \cup When(Level(e.mode) = 1, {"IRT-14"})
    ELSE CASE Level(e.mode) = 0 -> {"IRT-06"}
           [] Level(e.mode) = 1 -> {"IRT-07"}
           [] OTHER             -> {"IRT-08"}

(* What decides whether the OB is blocked. *)
\* @type: (Seq($event), Int) => Set(Str);
BlockRequirements(past, o) ==
    LET lines == IrtLines(past, o)
        last  == LastIn(lines)
        dis   == { i \in lines : past[i].event = "DIS_IRT" }
    IN  IF lines = {} THEN {"IRT-01"}
        ELSE IF LastOf(past, {"restart"}) > last THEN {"IRT-03", "OBS-53"}
        ELSE OfMode(past[last])
               \cup When(LastOf(past, {"end", "hold"}) > last, {"IRT-02", "IRT-03"})
               \cup When(Cardinality({ Level(past[i].mode) : i \in lines }) > 1,
                         {"IRT-20"})
               \cup When(Cardinality(dis) > 1 /\ last \notin dis, {"IRT-16"})

(* The OB is blocked and starts all the same. *)
\* @type: (Seq($event), Int) => Set(Str);
ThoughBlocked(past, o) ==
    IF DisIrtStopsCatchUp /\ o \in TodObs THEN {"IRT-01", "CLK-04"}
    ELSE {"IRT-01", "IRT-04"} \cup BlockRequirements(past, o)
           \cup When(o = TimeErrorOb, {"OBS-33"})

(* What came while the OB was blocked is lost, and nothing else has come. *)
\* @type: (Seq($event), Int) => Bool;
LostMeanwhile(past, o) ==
    LET last == LastIn(IrtLines(past, o))
    IN  /\ last > 0 /\ past[last].event = "EN_IRT"
        /\ last > LastStart(past, o)
        /\ last > LastWith(past, {"interrupt", "SRT_DINT", "ACT_TINT"}, o)

(* A start event of an OB that is not blocked has not had its effect. *)
\* @type: (Seq($event), Int) => Set(Str);
ThoughNotBlocked(past, o) ==
    LET lines == IrtLines(past, o)
        last  == LastIn(lines)
        other == LastOf(past, {"DIS_IRT"})
    IN  IF Blocked(o) THEN {"IRT-01"}  \* it came before
        ELSE IF last > LastStart(past, o)
        THEN {"IRT-15"} \cup BlockRequirements(past, o)
        ELSE IF lines = {} /\ irt.blocked # {} /\ other > 0
        THEN OfMode(past[other]) \cup {"IRT-11"}
        ELSE {}

-----------------------------------------------------------------------------
(* Calls *)

\* @type: $event => Set(Int);
RightAnswers(e) ==
    IF Unseen("call") THEN PossibleAnswers(e)
    ELSE CASE e.event = "SET_TINT" ->
                Answers(e.ob, SetErrors(e.ob, e.sdt, e.period))
           [] e.event = "CAN_TINT" -> CanAnswers(e.ob)
           [] e.event = "ACT_TINT" -> ActAnswers(e.ob)
           [] e.event = "QRY_TINT" -> Answers(e.ob, ObErrors(e.ob))
           [] e.event = "SRT_DINT" -> Answers(e.ob, SrtErrors(e.ob, e.dtime))
           [] e.event = "CAN_DINT" -> Answers(e.ob, CanDintErrors(e.ob))
           [] e.event = "QRY_DINT" -> Answers(e.ob, DintErrors(e.ob))
           [] e.event = "DIS_IRT"  -> Usual(IrtErrors(e.mode, e.ob, DisModes))
           [] e.event = "EN_IRT"   -> Usual(IrtErrors(e.mode, e.ob, EnModes))
           [] e.event = "DIS_AIRT" -> {delay + 1}
           [] OTHER -> {IF delay = 0 THEN NotDelayed ELSE delay - 1}

(* [AMB-70] (b) The delay has to end before this call. *)
\* @type: $event => Bool;
BeforeItsEnd(e) ==
    e.event \in {"SRT_DINT", "CAN_DINT", "QRY_DINT"} /\ ~Ended(e.ob)

\* @type: $event => Set(Int);
RightStatuses(e) == IF Unseen("call") THEN PossibleStatuses(e.ob)
                    ELSE IF e.event = "QRY_TINT" THEN Statuses(e.ob)
                    ELSE DintStatuses(e.ob)

\* @type: $event => Bool;
AnswerRight(e) == e.ret = -1 \/ e.ret \in RightAnswers(e)

\* @type: ($event, Int) => Set(Str);
SetRequirements(e, ret) ==
    CASE ret = OK        -> {"TINT-30"}
      [] ret = BadOb     -> {"TINT-35"}
      [] ret = BadSdt    -> CASE e.period = Monthly /\ e.sdt.day > 28 -> {"TINT-18"}
                              [] e.period = EndOfMonth -> {"TINT-19", "TINT-39"}
                              [] e.period = Yearly     -> {"TINT-32", "TINT-39"}
                              [] OTHER                 -> {"TINT-39", "TINT-35"}
      [] ret = BadPeriod -> {"TINT-33"}
      [] ret = PastStart -> {"TINT-36"} \cup When(e.period # Once, {"TINT-37"})
      [] OTHER           -> {"TINT-22"}

\* @type: ($event, Int) => Set(Str);
ActRequirements(e, ret) ==
    LET on == e.ob \in TodObs /\ tod[e.ob].active
    IN  CASE ret = OK -> {"TINT-60"} \cup When(on, {"TINT-63"})
          [] ret = PastStart -> IF e.ob \in TodObs /\ tod[e.ob].period # Once
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
      [] OTHER         -> {"IRT-22"}

\* @type: ($event, Int) => Set(Str);
AnswerRequirements(e, ret) ==
    CASE e.event = "SET_TINT" -> SetRequirements(e, ret)
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

(* What made a time-of-day interrupt active or not. *)
\* @type: (Int, Seq($event)) => Set(Str);
ActiveRequirements(o, past) ==
    LET last  == LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT", "start"}, o)
        reset == LastOf(past, {"restart"})
    IN  IF tod[o].active /\ tod[o].period # Once /\ tod[o].next = Never
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

\* @type: (Int, Seq($event)) => Set(Str);
StartedRequirements(o, past) ==
    LET last  == LastWith(past, {"SRT_DINT", "CAN_DINT", "start"}, o)
    IN  IF LastOf(past, {"restart"}) > last THEN {"DINT-13", "OBS-52"}
        ELSE IF Blocked(o) THEN {"IRT-04", "DINT-20"}
        ELSE IF last > 0 /\ past[last].event = "CAN_DINT" THEN {"DINT-14"} ELSE {}

(* The requirements of each wrong bit of STATUS. *)
\* @type: ($event, Int, Seq($event)) => Set(Str);
WrongBits(e, right, past) ==
    LET wrong(bit) == (e.status \div bit) % 2 # (right \div bit) % 2
        tods  == e.event = "QRY_TINT"
        valid == e.ob \in TodObs \cup DintObs
    IN  IF ~valid THEN {}
        ELSE When(tods /\ wrong(1), {"TINT-72"})
               \cup When(wrong(2), {"IRT-17"} \cup
                    When(IrtLines(past, e.ob) # {}, BlockRequirements(past, e.ob)))
               \cup When(tods /\ wrong(2), {"TINT-73"})
               \cup When(tods /\ wrong(4), {"TINT-74"}
                                             \cup ActiveRequirements(e.ob, past))
               \cup When(tods /\ wrong(8), {"TINT-75"})
               \cup When(tods /\ wrong(16), {"TINT-76"})
               \cup When(tods /\ wrong(32), {"TINT-77"})
               \cup When(tods /\ wrong(64), {"TINT-78"})
               \cup When(tods /\ e.status >= 128, {"TINT-79"})
               \cup When(~tods, {"DINT-16"})
               \cup When(~tods /\ wrong(4), StartedRequirements(e.ob, past))

(* The status that differs least. *)
\* @type: ($event, Seq($event)) => Set(Str);
WrongStatus(e, past) ==
    LET sets == { WrongBits(e, s, past) : s \in RightStatuses(e) }
    IN  IF sets = {} THEN {"TINT-71"}
        ELSE CHOOSE s \in sets : \A t \in sets : Cardinality(s) <= Cardinality(t)

\* @type: ($event, Seq($event)) => Set(Str);
OfCall(e, past) ==
    IF mode = "STOP" THEN {"OBS-41"}
    ELSE IF mode = "HOLD" THEN {"OBS-45"}
    ELSE IF ~Called THEN {IF mode = "STARTUP" THEN "OBS-42" ELSE "OBS-01"}
    ELSE IF AnswerRight(e) THEN WrongStatus(e, past) ELSE WrongAnswer(e)

-----------------------------------------------------------------------------
(* Starts without a start event *)

(* What STEP 7 has to do with an interrupt. *)
\* @type: (Int, Seq($event)) => Set(Str);
Step7Requirements(o, past) ==
    LET call == LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT"}, o)
    IN  When(cpu.step7[o].execution # "none",
             IF LastOf(past, {"restart"}) > call THEN {"OBS-50"}
             ELSE IF call = 0 THEN {"TINT-06"} ELSE {"TINT-38"})

(* The rules that say when an interrupt of this PERIOD is due. *)
\* @type: (Int, Int, Seq($event)) => Set(Str);
SeriesRequirements(o, period, past) ==
    LET set == LastWith(past, {"SET_TINT"}, o)
    IN  {"TINT-32"}
          \cup (CASE period = Hourly     -> {"TINT-34"}
                  [] period = EndOfMonth -> {"TINT-19"}
                  [] period = Monthly    -> {"TINT-18"}
                  [] OTHER               -> {"TINT-24"})
          \cup When(period \in Weekly \cup {Hourly, Yearly, Minutely, Daily},
                    {"TINT-33"})
          \cup When(/\ set > 0
                    /\ past[set].sdt.second # 0 \/ past[set].sdt.ms # 0,
                    {"TINT-11"})

(* What the program or the clock has done to a catch-up [CLK-04].           *)
\* @type: (Int, Seq($event)) => Bool;
TouchedInOb80(o, past) ==
    LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT", "DIS_IRT"}, o)
      > LastStart(past, TimeErrorOb)
    /\ LastStart(past, TimeErrorOb) > 0

(* The last start but one. *)
\* @type: (Seq($event), Int) => Int;
StartBefore(past, o) ==
    LastIn({ i \in DOMAIN past : /\ i < LastStart(past, o) /\ past[i].ob = o
                                 /\ past[i].event = "start" })

(* The OB has just run, and no start point has come since. *)
\* @type: (Int, Seq($event)) => Bool;
RanForPoint(o, past) ==
    LET last == LastStart(past, o)
    IN  /\ last > 0 /\ past[last].at.min < tod[o].next
        /\ clock.min - past[last].at.min \in {0, 1}
        /\ PointFrom(tod[o], past[last].at.min + 1) = tod[o].next

(* Since the line at `last': the CPU has gone on to RUN. *)
\* @type: (Seq($event), Int, Int) => Set(Str);
SinceRun(past, o, last) ==
    When(LastOf(past, {"run"}) > last,
             {"OBS-44"} \cup When(o \in TodObs, {"TINT-13"})
                        \cup When(o \in DintObs, {"DINT-11"})
                        \cup When(o \in ExternalObs, {"OBS-42"}))
          \cup When(LastOf(past, {"hold", "release"}) > last,
                    {"OBS-45"} \cup When(o \in TodObs, {"OBS-46"})
                               \cup When(o \in DintObs, {"DINT-19"}))

(* ... or the clock was set. *)
\* @type: (Seq($event), Int) => Set(Str);
SinceClock(past, last) ==
    LET how == ClockWasSet(past, last)
    IN  IF how = 0 THEN {}
        ELSE IF how > 0 THEN {"CLK-03"}
        ELSE IF cpu.family # "S7-300" THEN {"CLK-09"}
        ELSE IF Remembers THEN {"CLK-11"} ELSE {"CLK-10"}

(* Why a point of a time-of-day interrupt has not led to a start event.     *)
\* @type: (Int, Seq($event)) => Set(Str);
NoTodRequest(o, past) ==
    LET last == LastWith(past, {"SET_TINT", "CAN_TINT", "start"}, o)
    IN  IF Deselected(o) THEN {"TINT-02", "OBS-25"}
        ELSE IF LostMeanwhile(past, o) THEN {"IRT-04", "IRT-18"}
        ELSE IF OnStack(o) THEN {"OBS-02", "TINT-14"}
        ELSE IF ~tod[o].active /\ LastOf(past, {"restart"}) > last
        THEN {"TINT-02", "OBS-50"}
        ELSE IF ~tod[o].set
        THEN IF last = 0 THEN {"TINT-02", "TINT-05"}
             ELSE IF past[last].event = "start" THEN {"TINT-08", "CLK-12"}
             ELSE IF past[last].event = "SET_TINT" THEN {"TINT-31"}
             ELSE {"TINT-02", "TINT-50", "TINT-54"}
        ELSE IF ~tod[o].active THEN {"TINT-02", "TINT-05", "TINT-31"}
        ELSE LET again == RanForPoint(o, past)
                 from  == IF again THEN StartBefore(past, o) ELSE LastStart(past, o)
                 moved == SinceClock(past, from) \cup SinceRun(past, o, from)
                 special ==
                   moved
                     \cup When(Blocked(TimeErrorOb), {"OBS-33"})
                     \cup When(ClockWasSet(past, from) # 0
                                 /\ TouchedInOb80(o, past), {"CLK-04", "TINT-54"})
                     \cup When(clock.min <= tod[o].repeatTo
                                 /\ WasServed(tod[o], clock.min), {"CLK-09"})
                     \cup When(again, {"OBS-07"})
                     \cup When(again /\ moved = {}, {"TINT-10", "TINT-32"})
                     \cup When(again /\ moved = {}
                                 /\ LastStart(past, TimeErrorOb) > from, {"TINT-14"})
             IN  IF special # {} THEN special
                 ELSE SeriesRequirements(o, tod[o].period, past)
                        \cup Step7Requirements(o, past)
                        \cup When(tod[o].period # Once, {"TINT-10"})

(* When the delay of a job is over. *)
\* @type: (Int, Seq($event)) => Set(Str);
OfDelay(o, past) ==
    LET srt == LastWith(past, {"SRT_DINT"}, o)
    IN  When(LastOf(past, {"clock"}) > srt \/ Unseen("clock"), {"DINT-18"})
          \cup When(LastOf(past, {"hold"}) > srt, {"DINT-19"})
          \cup When(TimesSince(past, {"SRT_DINT"}, o, LastStart(past, o)) > 1,
                    {"DINT-07"} \cup When(DintCallsWithdrawRuns, {"DINT-15"}))

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
        ELSE {"DINT-02"}
               \cup When(LastStart(past, TimeErrorOb) > StartBefore(past, o),
                         {"DINT-10"})


(* The fault of OB 80 that the line names, or what has happened. *)
\* @type: ($event, Seq($event)) => Set(Str);
NoTimeError(e, past) ==
    LET fault == e.info.flt_id
        last  == LastStart(past, TimeErrorOb)
    IN  IF TimeErrorOb \notin loaded THEN {"OBS-22", "OBS-30"}
        ELSE {"OBS-30"}
          \cup When(LostMeanwhile(past, TimeErrorOb), {"OBS-33", "IRT-04"})
          \cup When(fault \in {-1, SkippedByClock} /\ LastOf(past, {"clock"}) > last,
                    {"CLK-02", "OBS-32"})
          \cup When(fault \in {-1, SkippedInHold} /\ LastOf(past, {"release"}) > last,
                    {"OBS-46"})
          \cup When(fault = StillRunning,
                    When(\E o \in TodObs : OnStack(o), {"TINT-14"})
                      \cup When(\E o \in DintObs : OnStack(o), {"DINT-10"}))
          \cup When(fault = SkippedByClock, {"CLK-02"})
          \cup When(fault = SkippedInHold, {"OBS-46"})
          \cup When(fault = BufferOverflow, {"OBS-08"})
          \cup When(/\ fault \in {-1, SkippedByClock}
                    /\ ~\E o \in TodObs : tod[o].active, {"CLK-14"})
          \cup When(/\ fault = SkippedByClock
                    /\ LastOf(past, {"DIS_AIRT"}) > LastOf(past, {"clock"}), {"CLK-18"})

(* Missing OBs that were armed. *)
\* @type: Seq($event) => Set(Str);
NoProgramError(past) ==
    LET tods  == { o \in TodObs \ loaded : LastWith(past, {"ACT_TINT"}, o) > 0
                                          \/ tod[o].active }
        dints == { o \in DintObs \ loaded : LastWith(past, {"SRT_DINT"}, o) > 0 }
    IN  {"OBS-20"}
          \cup When(tods # {}, {"TINT-16", "TINT-17"})
          \cup When(dints # {}, {"DINT-09"})
          \cup When(\E o \in tods \cup dints : Blocked(o), {"IRT-01"})
          \cup When(delay > 0 /\ { r \in requests : r.ob \notin loaded } # {},
                    {"AIRT-01", "AIRT-09"})
          \cup When(MissingObEndsItsSource, {"OBS-28"})
          \cup When(MissingIsTimeError, {"OBS-24"})

\* @type: ($event, Seq($event)) => Set(Str);
WithoutRequest(e, past) ==
    LET o == e.ob
    IN  CASE mode = "STOP"                -> {"OBS-41"}
          [] mode = "HOLD"                -> {"OBS-45"}
          [] ClassOf(o) = 0               -> {"OBS-06", "TINT-02", "OBS-25"}
          [] Blocked(o)                   -> ThoughBlocked(past, o)
          [] mode = "STARTUP" /\ o \in TodObs  -> {"OBS-42", "TINT-13"}
          [] mode = "STARTUP" /\ o \in DintObs -> {"OBS-42", "DINT-12", "DINT-11"}
          [] o \in TodObs                 -> NoTodRequest(o, past)
          [] o \in DintObs                -> NoDintRequest(o, past)
          [] o = TimeErrorOb              -> NoTimeError(e, past)
          [] o = ProgramErrorOb           -> NoProgramError(past)
          [] o \in {CycleOb} \cup StartupObs ->
               IF mode = "STARTUP" THEN {"OBS-42"}
               ELSE {"OBS-03"} \cup When(stack = <<>>, {"OBS-10"})
          [] LostMeanwhile(past, o)       -> {"IRT-04", "IRT-15"}
          [] OTHER                        ->
               {"OBS-01", "OBS-07"} \cup SinceRun(past, o, LastStart(past, o))
                 \cup When(LastOf(past, {"restart"}) > LastWith(past, {"interrupt"}, o),
                           {"OBS-52"})

-----------------------------------------------------------------------------
(* Starts that have a start event *)

(* Start information of an interrupt. *)
\* @type: ($request, $info) => Set(Str);
InterruptInfo(r, i) ==
    When(~Fits(i.priority, r.class),
         IF r.ob = TimeErrorOb THEN {"OBS-31"}
         ELSE {"OBS-04"} \cup When(r.ob \in DOMAIN cpu.priority, {"OBS-05"})
                \cup When(r.ob \in AsyncErrorObs /\ mode = "STARTUP", {"OBS-43"}))
      \cup When(r.ob \notin AsyncErrorObs /\ ~FitsNumber(i.strt_info, r.ob),
                {"OBS-10"} \cup When(r.ob \in TodObs, {"TINT-23"})
                  \cup When(r.ob \in DintObs, {"DINT-03"})
                  \cup When(r.ob \in ExternalObs, {"OBS-04"}))
      \cup When(r.ob \in TodObs /\ ~FitsPeriod(i.period, r.word),
                {"TINT-25", "TINT-33"})
      \cup When(/\ r.ob \in DintObs
                /\ ~(Fits(i.sign, r.word) /\ FitsDtime(i.dtime, r.dtime)),
                {"DINT-03", "DINT-07", "DINT-22"})
      \cup When(~FitsTime(r, i.time),
                CASE r.follows \in Skips -> {"CLK-07"}
                  [] r.fault \in Skips   -> {"CLK-06"}
                  [] r.ob \in TodObs     -> {"TINT-09", "TINT-24"}
                  [] OTHER               -> {"OBS-10"})

(* ... and of OB 80 and OB 85. *)
\* @type: ($request, $info) => Set(Str);
ErrorInfo(r, i) ==
    LET rule == IF r.ob = TimeErrorOb THEN {"OBS-30"} ELSE {"OBS-20"}
    IN  When(~FitsFault(r.fault, i.flt_id) \/ ~FitsFault(r.fault, i.strt_info),
             rule \cup When(r.fault = SkippedByClock, {"CLK-02"})
                  \cup When(r.fault = SkippedInHold, {"OBS-46"})
                  \cup When(r.fault = BufferOverflow, {"OBS-08"})
                  \cup When(r.fault = StillRunning,
                            When(r.cause \in TodObs, {"TINT-14"})
                              \cup When(r.cause \in DintObs, {"DINT-10"})))
          \cup When(~FitsCause(r, i), rule \cup {"OBS-10"})
          \cup When(~Fits(i.priority, r.class),
                    When(r.fault = BufferOverflow, {"OBS-08"})
                      \cup When(r.fault = SkippedInHold, {"OBS-46"}))
          \cup When(~FitsMask(r, i.error_info),
                    {"CLK-06", "OBS-32"}
                      \cup When(r.fault = SkippedInHold, {"OBS-46"}))

(* The start information that a request does not fit. *)
\* @type: ($request, $info) => Set(Str);
InfoRequirements(r, i) ==
    LET ids == InterruptInfo(r, i) \cup When(r.ob \in AsyncErrorObs, ErrorInfo(r, i))
    IN  IF ids = {} THEN {"OBS-10"} ELSE ids

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
    THEN {"OBS-02"} \cup When(r.ob \in TodObs, {"TINT-12"})
                    \cup When(r.ob \in AsyncErrorObs, {"OBS-11"})
    ELSE IF ~Preempts(r)
    THEN {"OBS-01"}
           \cup When(/\ LastOf(past, {"DIS_IRT"}) > LastStart(past, Running.ob)
                     /\ Blocked(Running.ob), {"IRT-08", "OBS-03"})
    ELSE IF ~Reported(r)
    THEN IF r.follows \in Skips THEN {"CLK-02", "CLK-03"} ELSE {"TINT-15"}
    ELSE IF ~InTurn(r)
    THEN {"OBS-02"} \cup When(r.ob \in TodObs, {"TINT-12"})
                    \cup When(r.follows \in Skips, {"CLK-03"})
    ELSE InfoRequirements(r, e.info)

(* How many of these conditions the request meets. *)
\* @type: ($request, Int) => Int;
Depth(r, fault) ==
    IF ~ModeAllows(r) THEN 1 ELSE IF r.ob \notin loaded THEN 2
    ELSE IF ~Undelayed THEN 3 ELSE IF ~Preempts(r) THEN 4
    ELSE IF ~Reported(r) THEN 5 ELSE IF ~InTurn(r) THEN 6
    ELSE IF ~FitsFault(r.fault, fault) THEN 7 ELSE 8

(* The requests by which the OB of the line might start, also those that   *)
(* may have come unseen.                                                   *)
\* @type: $event => Set($request);
Candidates(e) == { r \in requests : r.ob = e.ob }
                   \cup (IF Partial THEN MayHaveOccurred(e) ELSE {})

\* @type: ($event, Seq($event)) => Set(Str);
OfStart(e, past) ==
    LET all  == Candidates(e)
        fault == e.info.flt_id
        best == { r \in all : \A q \in all : Depth(q, fault) <= Depth(r, fault) }
    IN  IF all = {} \/ mode = "STOP" THEN WithoutRequest(e, past)
        ELSE UNION { StartRequirements(r, e, past) : r \in best }
               \cup When(e.info.dtime \notin {-1} \cup DelayTimes, {"DINT-04"})

-----------------------------------------------------------------------------
(* Other lines *)

(* Of a STOP that is due. *)
StopRequirements ==
    CASE stopCause = NoTimeErrorOb    -> {"OBS-22", "CLK-05"}
      [] stopCause = NoProgramErrorOb -> {"OBS-21"}
      [] stopCause = DeselectedLoaded -> {"OBS-25"}
      [] OTHER                        -> {"OBS-23"}

\* @type: ($event, Seq($event)) => Set(Str);
OfEntry(e, past) ==
    LET fault == e.id - ErrorEntry
        quiet == Silenced(TimeErrorOb) \/ Silenced(ProgramErrorOb)
    IN  CASE e.id = EntriesDisabled ->
               {"IRT-09"} \cup When(LastOf(past, {"EN_IRT"}) > 0, {"IRT-19"})
          [] e.id = NoTimeErrorOb       -> {"OBS-22"}
          [] e.id = NoProgramErrorOb    -> {"OBS-21"}
          [] e.id = DeselectedLoaded    -> {"OBS-25"}
          [] fault \in ObNotLoaded      -> {"OBS-20"} \cup When(quiet, {"IRT-09"})
          [] fault = SkippedByClock     ->
               {"OBS-30", "CLK-02"} \cup When(quiet, {"IRT-09"})
          [] fault = SkippedInHold      -> {"OBS-30", "OBS-46"}
          [] fault = BufferOverflow     -> {"OBS-30", "OBS-08"}
          [] OTHER                      -> {"OBS-30"} \cup When(quiet, {"IRT-09"})

\* @type: ($event, Seq($event)) => Set(Str);
Deciding(e, past) ==
    CASE e.event \in CallEvents -> OfCall(e, past)
      [] e.event = "start"   ->
           OfStart(e, past) \cup When(stopCause # NoCause, StopRequirements)
      [] e.event = "diag"    -> OfEntry(e, past)
      [] e.event = "end"     -> IF mode = "HOLD" THEN {"OBS-45"}
                                ELSE IF mode = "STOP" THEN {"OBS-41"}
                                ELSE IF Running.ob = CycleOb \/ stack = <<>>
                                THEN {"OBS-01", "OBS-03"} ELSE {"OBS-03"}
      [] e.event = "restart" -> {"OBS-40"} \cup When(e.type = "cold", {"OBS-57"})
      [] e.event = "run"     -> IF stopCause # NoCause THEN StopRequirements
                                ELSE IF mode = "STARTUP" THEN {"OBS-42"}
                                ELSE {"OBS-40"}
      [] e.event = "stop"    -> IF mode = "STOP" THEN {"OBS-40"}
                                ELSE {"OBS-21", "OBS-22"}
      [] OTHER               -> {"OBS-40"}

(* Of the states before the line those count that come nearest to it: the   *)
(* least number.                                                           *)
\* @type: $event => Int;
Distance(e) ==
    CASE e.event \in CallEvents ->
           IF ~Called THEN 3
           ELSE IF BeforeItsEnd(e) THEN 2
           ELSE IF AnswerRight(e) THEN 0 ELSE 1
      [] e.event = "start" ->
           LET all == { Depth(r, e.info.flt_id) : r \in Candidates(e) }
           IN  IF mode = "STOP" THEN 10
               ELSE IF all = {} THEN IF mode = "RUN" THEN 8 ELSE 9
               ELSE 8 - (CHOOSE d \in all : \A k \in all : k <= d)
      [] e.event = "end" -> IF OnStack(e.ob) THEN 0 ELSE 1
      [] OTHER -> 0

-----------------------------------------------------------------------------
(* Lines that come too late: something that had to happen has not.  The     *)
(* state is the one in which time could not go on.                         *)

Due == { r \in requests : MayStart(r) /\ ~r.open }

(* Of what is due, what the line shows to be late. *)
\* @type: $event => Set($request);
Late(e) ==
    { r \in Due : /\ WaitsAs(r) \in DOMAIN waiting
                  /\ waiting[WaitsAs(r)] + Span(up, e.up) > terms.latency }

\* @type: $event => Set($report);
ReportsLate(e) == { r \in reports : /\ DiagRecorded /\ ~r.entry.open
                                   /\ r.entry.id \in DemandedEntries
                                   /\ r.age + Span(up, e.up) > terms.latency }

(* What held the OB back until now, or should not have. *)
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
            \cup When(Blocked(o) \/ LastIn(IrtLines(past, o)) > last, {"IRT-18"})
            \cup When(~TodCallsWithdrawRuns, {"TINT-50"})
            \cup When(~SecondRequestIsOpen, {"OBS-07"})
            \cup When(act > 0 /\ past[act].ret = -1, {"TINT-60"})
            \cup HeldBack(r, past)
    IN  special \cup Step7Requirements(o, past)
          \cup (IF r.word = Once THEN {"TINT-23"} ELSE {"TINT-09"})
          \cup When(special = {},
                    {"TINT-23"} \cup SeriesRequirements(o, r.word, past))

\* @type: ($request, Seq($event)) => Set(Str);
LateDint(r, past) ==
    {"DINT-06"} \cup (SinceRun(past, r.ob, LastStart(past, r.ob)) \ {"DINT-19"})
                \cup OfDelay(r.ob, past)
                \cup When(dint[r.ob].started
                            \/ LastWith(past, {"CAN_DINT"}, r.ob) > 0, {"DINT-15"})
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
           When(r.ob \in TodObs, {"TINT-14"}) \cup When(r.ob \in DintObs, {"DINT-10"})
             \cup When(LastIn(IrtLines(past, TimeErrorOb)) > 0, {"OBS-33"})
      [] r.ob \in DintObs            -> LateDint(r, past) \cup HeldBack(r, past)
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

\* @type: ($entry, Seq($event)) => Set(Str);
EntryRequirements(entry, past) ==
    CASE entry.id = EntriesDisabled  -> {"IRT-09"}
      [] entry.id = NoTimeErrorOb    -> {"OBS-22"}
      [] entry.id = NoProgramErrorOb -> {"OBS-21"}
      [] entry.of.ob = TimeErrorOb   ->
           {"OBS-30"} \cup When(Blocked(TimeErrorOb),
                                {"OBS-33"} \cup BlockRequirements(past, TimeErrorOb))
      [] OTHER                       -> {"OBS-20"}

\* @type: ($event, Seq($event)) => Set(Str);
LateRequirements(e, past) ==
    UNION { LateRequirement(r, past) : r \in Late(e) }
      \cup UNION { EntryRequirements(r.entry, past) : r \in ReportsLate(e) }
      \cup When(StopDuty \in DOMAIN waiting, StopRequirements)
=============================================================================

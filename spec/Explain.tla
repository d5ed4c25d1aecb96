------------------------------- MODULE Explain ------------------------------
(***************************************************************************)
(* Why a line of a log has no explanation: what a state that explained the *)
(* log until then would have allowed, and the requirements that decide.    *)
(* The trace checker evaluates these operators in the states before the    *)
(* line; they say what the guards of the actions say, and no action uses   *)
(* them.                                                                   *)
(*                                                                         *)
(* Left out: the first false conjunct of every action.                     *)
(***************************************************************************)
EXTENDS Unrecorded

(* What may be observed: an event with its OB, and one field of it. *)
\* @type: (Str, Int, Str, Int) => $allowed;
Allowed(event, ob, field, value) ==
    [event |-> event, ob |-> ob, field |-> field, value |-> value]

-----------------------------------------------------------------------------
(* Headers that this specification cannot judge *)

\* @type: $header => Set(Str);
NotCovered(h) ==
    { r[1] : r \in { q \in h.readings : q[2] \notin Letters(q[1]) } }

-----------------------------------------------------------------------------
(* Calls *)

\* @type: $event => Set(Int);
RightAnswers(e) ==
    CASE e.event = "SET_TINT" ->
           Answers(e.ob, SetErrors(e.ob, e.sdt, e.period))
      [] e.event = "CAN_TINT" -> Answers(e.ob, CanErrors(e.ob))
      [] e.event = "ACT_TINT" -> ActAnswers(e.ob)
      [] e.event = "QRY_TINT" -> Answers(e.ob, ObErrors(e.ob))
      [] e.event = "SRT_DINT" -> Answers(e.ob, SrtErrors(e.ob, e.dtime))
      [] e.event = "CAN_DINT" -> Answers(e.ob, CanDintErrors(e.ob))
      [] e.event = "QRY_DINT" -> Answers(e.ob, DintErrors(e.ob))
      [] e.event = "DIS_IRT"  -> Usual(IrtErrors(e.mode, e.ob, DisModes))
      [] e.event = "EN_IRT"   -> Usual(IrtErrors(e.mode, e.ob, EnModes))
      [] e.event = "DIS_AIRT" -> {delay + 1}
      [] OTHER -> {IF delay = 0 THEN NotDelayed ELSE delay - 1}

\* @type: ($event, Int) => Set(Str);
SetRequirements(e, ret) ==
    CASE ret = OK        -> {"TINT-30"}
      [] ret = BadOb     -> {"TINT-35"}
      [] ret = BadSdt    -> IF e.period = Monthly /\ e.sdt.day > 28
                            THEN {"TINT-18"} ELSE {"TINT-39"}
      [] ret = BadPeriod -> {"TINT-33"}
      [] ret = PastStart -> {"TINT-36"}
      [] OTHER           -> {"TINT-22"}

\* @type: ($event, Int) => Set(Str);
ActRequirements(e, ret) ==
    CASE ret = OK -> {"TINT-60"}
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

(* The requirement of each wrong bit of STATUS. *)
\* @type: Set(<<Int, Str>>);
TodStatusBits ==
    { <<1, "TINT-72">>, <<2, "TINT-73">>, <<4, "TINT-74">>, <<8, "TINT-75">>,
      <<16, "TINT-76">>, <<32, "TINT-77">>, <<64, "TINT-78">> }
\* @type: Set(<<Int, Str>>);
DintStatusBits == { <<bit, "DINT-16">> : bit \in {1, 2, 4, 8, 16, 32, 64} }
                    \cup {<<2, "IRT-17">>}

\* @type: (Str, Int, Int) => Set(Str);
StatusRequirements(event, status, right) ==
    LET wrong(bit) == (status \div bit) % 2 # (right \div bit) % 2
        ids == IF event = "QRY_TINT" THEN TodStatusBits ELSE DintStatusBits
    IN  { p[2] : p \in { q \in ids : wrong(q[1]) } }
          \cup (IF status >= 128 THEN {"TINT-79"} ELSE {})

\* @type: ($event, Int) => Set(Str);
AnswerRequirements(e, ret) ==
    CASE e.event = "SET_TINT" -> SetRequirements(e, ret)
      [] e.event = "CAN_TINT" ->
           IF ret = OK THEN {"TINT-50", "TINT-52"} ELSE {"TINT-51"}
      [] e.event = "ACT_TINT" -> ActRequirements(e, ret)
      [] e.event = "QRY_TINT" -> {"TINT-70"}
      [] e.event = "SRT_DINT" -> SrtRequirements(e, ret)
      [] e.event = "CAN_DINT" -> {"DINT-14"}
           \cup (IF ret = NotStarted THEN {"DINT-15"} ELSE {})
      [] e.event = "QRY_DINT" -> {"DINT-16"}
      [] e.event \in {"DIS_IRT", "EN_IRT"} -> IrtRequirements(e, ret)
      [] e.event = "DIS_AIRT" -> {"AIRT-03", "AIRT-06"}
                                   \cup (IF delay = 0 THEN {"AIRT-04"} ELSE {})
      [] OTHER                -> {"AIRT-03", "AIRT-07"}
                                   \cup (IF delay = 0 THEN {"AIRT-04"} ELSE {})

\* @type: $event => Set(Int);
RightStatuses(e) == IF e.event = "QRY_TINT" THEN Statuses(e.ob)
                                            ELSE DintStatuses(e.ob)

\* @type: $event => Bool;
AnswerRight(e) == e.ret = -1 \/ e.ret \in RightAnswers(e)

-----------------------------------------------------------------------------
(* What may be observed in this state *)

Startable == { r \in requests : MayStart(r) /\ r.ob \in loaded }

\* @type: $request => $allowed;
StartOf(r) == IF r.fault = 0 THEN Allowed("start", r.ob, "", 0)
              ELSE Allowed("start", r.ob, "flt_id", r.fault)

Possible ==
    { StartOf(r) : r \in Startable }
      \cup (IF stack = <<>> THEN {} ELSE {Allowed("end", Running.ob, "", 0)})
      \cup (IF Called THEN {Allowed("call", Running.ob, "", 0)} ELSE {})
      \cup (IF mode = "STOP" THEN {Allowed("restart", 0, "", 0)}
            ELSE {Allowed("stop", 0, IF stopCause > 0 THEN "cause" ELSE "",
                          IF stopCause > 0 THEN stopCause ELSE 0)})
      \cup (IF ENABLED Run THEN {Allowed("run", 0, "", 0)} ELSE {})

\* @type: $event => Set($allowed);
Expected(e) ==
    IF e.event \in CallEvents /\ Called
    THEN IF AnswerRight(e)
         THEN { Allowed(e.event, e.ob, "status", s) : s \in RightStatuses(e) }
         ELSE { Allowed(e.event, e.ob, "ret", r) : r \in RightAnswers(e) }
    ELSE Possible

-----------------------------------------------------------------------------
(* The requirements that decide about a line *)

(* The rules that say when an interrupt of this PERIOD is due. *)
\* @type: Int => Set(Str);
SeriesRequirements(period) ==
    {"TINT-11", "TINT-32", "TINT-33"}
      \cup (CASE period = Hourly     -> {"TINT-34"}
              [] period = EndOfMonth -> {"TINT-19"}
              [] period = Monthly    -> {"TINT-18"}
              [] OTHER               -> {"TINT-24"})

(* Why a point of a time-of-day interrupt has not led to a start event.     *)
\* @type: Int => Set(Str);
NoTodRequest(o) ==
    IF Deselected(o) THEN {"TINT-02"}
    ELSE IF OnStack(o) THEN {"OBS-02", "TINT-14"}
    ELSE IF ~tod[o].set THEN {"TINT-02", "TINT-08", "TINT-50", "TINT-54"}
    ELSE IF ~tod[o].active THEN {"TINT-05"}
    ELSE SeriesRequirements(tod[o].period)
           \cup {"TINT-10", "CLK-03"}
           \cup (IF tod[o].repeatTo >= clock.min THEN {"CLK-09"} ELSE {})

\* @type: Int => Set(Str);
NoDintRequest(o) ==
    IF OnStack(o) THEN {"OBS-02", "DINT-10"}
    ELSE IF ~dint[o].started THEN {"DINT-02", "DINT-13", "DINT-14"}
    ELSE {"DINT-03", "DINT-06"} \cup (IF mode = "HOLD" THEN {"DINT-19"} ELSE {})

\* @type: Int => Set(Str);
WithoutRequest(o) ==
    CASE Blocked(o)            -> {"IRT-01", "IRT-04"}
      [] o \in TodObs          -> NoTodRequest(o)
      [] o \in DintObs         -> NoDintRequest(o)
      [] o = TimeErrorOb       -> {"OBS-30", "CLK-02", "OBS-32"}
      [] o = ProgramErrorOb    -> {"OBS-20"}
      [] o \in {CycleOb} \cup StartupObs ->
           IF mode = "STARTUP" THEN {"OBS-42"} ELSE {"OBS-03"}
      [] OTHER                 -> {"OBS-01", "OBS-07"}

(* The start information that a request does not fit. *)
\* @type: ($request, $info) => Set(Str);
InfoRequirements(r, i) ==
    (IF Fits(i.priority, r.class) THEN {} ELSE {"OBS-04"})
      \cup (IF r.ob \in TodObs /\ ~FitsPeriod(i.period, r.word)
            THEN {"TINT-25", "TINT-33"} ELSE {})
      \cup (IF r.ob \in DintObs /\ ~(Fits(i.sign, r.word) /\ Fits(i.dtime, r.dtime))
            THEN {"DINT-03", "DINT-07"} ELSE {})
      \cup (IF FitsTime(r, i.time) THEN {}
            ELSE IF r.follows \in Skips THEN {"CLK-07"}
            ELSE IF r.ob \in TodObs THEN {"TINT-09", "TINT-24"} ELSE {"OBS-10"})
      \cup (IF r.fault \in Skips THEN {"CLK-06"} ELSE {})
      \cup (IF r.ob = TimeErrorOb THEN {"OBS-30"}
            ELSE IF r.ob \in TodObs THEN {"TINT-23"} ELSE {"OBS-10"})

\* @type: ($request, $event) => Set(Str);
StartRequirements(r, e) ==
    IF ~ModeAllows(r) THEN (IF mode = "STARTUP" THEN {"OBS-42"}
                              \cup (IF r.ob \in TodObs THEN {"TINT-13"} ELSE {})
                              \cup (IF r.ob \in DintObs THEN {"DINT-12"} ELSE {})
                            ELSE IF mode = "HOLD" THEN {"OBS-45"}
                            ELSE {"OBS-41"})
    ELSE IF r.ob \notin loaded THEN {"TINT-16", "OBS-20"}
    ELSE IF ~Undelayed THEN {"AIRT-01", "AIRT-03"}
           \cup (IF r.ob \in AsyncErrorObs THEN {"AIRT-09"} ELSE {})
    ELSE IF r.class = Running.class THEN {"OBS-01", "OBS-02"}
           \cup (IF r.ob \in TodObs THEN {"TINT-12"} ELSE {})
    ELSE IF ~Preempts(r) THEN {"OBS-01"}
    ELSE IF ~Reported(r) THEN (IF r.follows \in Skips THEN {"CLK-03"}
                                                      ELSE {"TINT-15"})
    ELSE IF ~InTurn(r) THEN {"OBS-02"}
    ELSE InfoRequirements(r, e.info)

\* @type: $event => Set(Str);
Deciding(e) ==
    CASE e.event \in CallEvents /\ ~Called ->
           IF mode = "STOP" THEN {"OBS-41"} ELSE {"OBS-42"}
      [] e.event \in CallEvents /\ Called /\ ~AnswerRight(e) ->
           AnswerRequirements(e, e.ret)
             \cup UNION { AnswerRequirements(e, r) : r \in RightAnswers(e) }
      [] e.event \in CallEvents /\ Called /\ AnswerRight(e) ->
           UNION { StatusRequirements(e.event, e.status, s)
                   : s \in RightStatuses(e) }
      [] e.event = "start" ->
           IF mode = "STOP" THEN {"OBS-41"}
           ELSE IF ~\E r \in requests : r.ob = e.ob THEN WithoutRequest(e.ob)
           ELSE UNION { StartRequirements(r, e)
                        : r \in { q \in requests : q.ob = e.ob } }
      [] e.event = "diag"    ->
           IF e.id = EntriesDisabled THEN {"IRT-09"}
           ELSE IF e.id - ErrorEntry \in (\hA1..\hA3) THEN {"OBS-20"}
           ELSE {"OBS-30"}
      [] e.event = "end"     -> {"OBS-03"}
      [] e.event = "restart" -> {"OBS-40"}
      [] e.event = "run"     -> IF stopCause # NoCause THEN {"OBS-25"}
                                ELSE IF mode = "STARTUP" THEN {"OBS-42"}
                                ELSE {"OBS-40"}
      [] e.event = "stop"    -> IF mode = "STOP" THEN {"OBS-40"}
                                ELSE {"OBS-21", "OBS-22"}
      [] OTHER               -> {"OBS-40"}

-----------------------------------------------------------------------------
(* Lines that come too late: something that had to happen has not.          *)

Due == { r \in requests : MayStart(r) /\ ~r.open }

(* Points and delays on the way to the line lead to something that is late  *)
(* as well.                                                                *)
\* @type: $event => Set(Int);
DueOnTheWay(e) ==
    { o \in DOMAIN tod : /\ Watching /\ tod[o].active
                         /\ ~Before(e.at, At(tod[o].next)) }

\* @type: $event => Set(Int);
OverOnTheWay(e) == { o \in Jobs : dint[o].left <= Span(up, e.up) }

ReportsDue == { r \in reports : /\ DiagRecorded /\ ~r.entry.open
                               /\ r.entry.id \in DemandedEntries }

(* All that may start is named: which class was late first depends on the   *)
(* time that had passed when the line was reached.                         *)
\* @type: $event => Set($allowed);
TooLate(e) ==
    { StartOf(r) : r \in { q \in Due : q.ob \in loaded } }
      \cup { Allowed("start", ProgramErrorOb, "", 0)
             : r \in { q \in Due : /\ q.ob \notin loaded
                                   /\ q.ob \notin AsyncErrorObs } }
      \cup { Allowed("start", o, "", 0)
             : o \in DueOnTheWay(e) }
      \cup { Allowed("start", o, "", 0) : o \in OverOnTheWay(e) }
      \cup { Allowed("diag", 0, "id", r.entry.id) : r \in ReportsDue }
      \cup (IF StopDuty \notin DOMAIN waiting THEN {}
            ELSE {Allowed("stop", 0, "cause", stopCause)})

\* @type: $request => Set(Str);
LateRequirement(r) ==
    CASE r.ob \notin loaded          ->
           IF r.ob \in AsyncErrorObs THEN {"OBS-23", "OBS-21"}
           ELSE {"TINT-16", "OBS-20", "OBS-21"}
      [] r.follows \in Skips         -> {"CLK-03"}
      [] r.follows = StillRunning    -> {"TINT-14"}
      [] r.ob \in DintObs            -> {"DINT-03", "DINT-11"}
      [] r.ob \in TodObs             ->
           {"TINT-09", "TINT-23"} \cup SeriesRequirements(r.word)
             \cup (IF cpu.step7[r.ob].execution = "once" THEN {"OBS-56"} ELSE {})
      [] r.fault = SkippedByClock    -> {"CLK-02"}
      [] r.fault = SkippedInHold     -> {"OBS-46"}
      [] r.ob = TimeErrorOb          -> {"TINT-14", "OBS-30"}
      [] r.ob = ProgramErrorOb       -> {"OBS-20"}
      [] OTHER                       -> {"AIRT-02", "AIRT-08", "OBS-01", "OBS-03"}

\* @type: Int => Set(Str);
PointRequirements(o) ==
    IF OnStack(o)
    THEN {"TINT-14"} \cup (IF TimeErrorOb \in loaded THEN {} ELSE {"OBS-22"})
    ELSE IF o \notin loaded
    THEN {"TINT-16", "OBS-20"}
           \cup (IF ProgramErrorOb \in loaded THEN {} ELSE {"OBS-21"})
    ELSE {"TINT-09", "TINT-23"} \cup SeriesRequirements(tod[o].period)
           \cup (IF clock.min < tod[o].servedTo \/ ~Remembers
                 THEN {"CLK-10"} ELSE {})

\* @type: Int => Set(Str);
DelayRequirements(o) ==
    IF OnStack(o)
    THEN {"DINT-10"} \cup (IF TimeErrorOb \in loaded THEN {} ELSE {"OBS-22"})
    ELSE IF o \notin loaded
    THEN {"DINT-09", "OBS-20"}
           \cup (IF ProgramErrorOb \in loaded THEN {} ELSE {"OBS-21"})
    ELSE {"DINT-03"}

\* @type: $entry => Set(Str);
EntryRequirements(entry) ==
    CASE entry.id = EntriesDisabled  -> {"IRT-09"}
      [] entry.id = NoTimeErrorOb    -> {"OBS-22"}
      [] entry.id = NoProgramErrorOb -> {"OBS-21"}
      [] entry.of.ob = TimeErrorOb   -> {"OBS-30"}
      [] OTHER                       -> {"OBS-20"}

\* @type: $event => Set(Str);
LateRequirements(e) ==
    UNION { LateRequirement(r) : r \in Due }
      \cup UNION { DelayRequirements(o) : o \in OverOnTheWay(e) }
      \cup UNION { EntryRequirements(r.entry) : r \in ReportsDue }
      \cup UNION { PointRequirements(o) : o \in DueOnTheWay(e) }
      \cup (IF StopDuty \notin DOMAIN waiting THEN {}
            ELSE CASE stopCause = NoTimeErrorOb    -> {"OBS-22", "CLK-05"}
                   [] stopCause = NoProgramErrorOb -> {"OBS-21"}
                   [] stopCause = DeselectedLoaded -> {"OBS-25"}
                   [] OTHER                        -> {"OBS-23"})
=============================================================================

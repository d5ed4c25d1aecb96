------------------------------- MODULE Explain ------------------------------
(***************************************************************************)
(* The report of a line that has no explanation: the lines that the        *)
(* specification allows in its place, and the situation of the CPU.        *)
(* Module Reasons has the requirements that decide.                        *)
(*                                                                         *)
(* The engine evaluates these operators in the states before the line.     *)
(* They repeat the guards of the actions; no action uses them.             *)
(* Source: docs/checking/reports.md, `expected' and `state' of a verdict.  *)
(* Left out: the conjunct of an action that is false; the engine finds it  *)
(* in the action itself.                                                   *)
(***************************************************************************)
EXTENDS Reasons, Merging

(* An event that may be observed, with its OB and one of its fields. *)
\* @type: (Str, Int, Str, Int) => $allowed;
Allowed(event, ob, field, value) ==
    [ event |-> event, ob |-> ob, field |-> field, value |-> value,
      time |-> NoMoment ]

-----------------------------------------------------------------------------
(* Headers that this specification cannot judge *)

\* @type: $header => Set(Str);
NotCovered(h) ==
    { r[1] : r \in { q \in h.readings : q[2] \notin Letters(q[1]) } }
      \cup (IF h.profile \in {""} \cup ProfileNames THEN {} ELSE {h.profile})
      \cup (IF h.cpu \in FamilyNames THEN {} ELSE {h.cpu})

\* @type: Str => <<Str, Str>>;
DefaultOf(a) == <<a, Defaults[a]>>

(* The RET_VALs of each call, except SFC 41, which answers a count. *)
AnswersOfCalls ==
    { <<"SET_TINT", {OK, BadOb, BadSdt, BadPeriod, PastStart}>>,
      <<"SET_TINTL", {OK, BadOb, BadSdt, BadPeriod, PastStart}>>,
      <<"CAN_TINT", {OK, BadOb} \cup CanErrorsIf(FALSE)>>,
      <<"ACT_TINT", {OK, BadOb} \cup ActErrorsIf(FALSE, FALSE)
                      \cup ActErrorsIf(TRUE, TRUE)>>,
      <<"QRY_TINT", {OK, BadOb}>>,
      <<"SRT_DINT", {OK, BadOb, BadDtime}>>,
      <<"CAN_DINT", {OK, BadOb} \cup CanDintErrorsIf(FALSE)>>,
      <<"QRY_DINT", {OK, BadOb}>>,
      <<"DIS_IRT", {OK, BadOb, BadMode}>>,
      <<"EN_IRT", {OK, BadOb, BadMode}>>,
      <<"EN_AIRT", EnAirtAnswers(0) \cup EnAirtAnswers(1)>> }

(* The numbers that a log can give to an OB. *)
ObNumbersOfLogs == 1..122
(* [T15-10] Those of OBs with an event class of their own; each class,     *)
(* its first OB and how many OBs of it a CPU has at most.                  *)
FirstNumbered == 123
LastNumbered  == 32767
EventClasses ==
    { <<"tod", 10, 20>>, <<"dint", 20, 20>>, <<"cyclic", 30, 20>>,
      <<"hardware", 40, 50>>, <<"startup", 100, 100>>, <<"cycle", 1, 100>> }

\* @type: (Int, Int) => <<Int, Int>>;
WithClass(o, class) == <<o, class>>

(* The words of a log, by which the reader takes lines or refuses them. Of *)
(* a header: families, those whose priority classes can be set, these      *)
(* classes, the OBs that it lacks and its default classes; profiles; the   *)
(* letters of each question; families with SET_TINTL, and with numbered    *)
(* OBs and parameters of queues [T15-68], and their OBs. Of lines: OBs by  *)
(* their kind, the startup OB of each restart.                             *)
Words ==
    [ families |-> FamilyNames,
      restarts |-> { <<f.name, f.restarts>> : f \in KnownFamilies },
      settable |-> { f.name : f \in { g \in KnownFamilies : g.settable } },
      classes  |-> { <<f.name, { <<o, ClassesToSet(f, o)>>
                                 : o \in { p \in ObNumbersOfLogs :
                                             ClassesToSet(f, p) # {} } }>>
                     : f \in KnownFamilies },
      unknown  |-> { <<f.name, f.unknown>> : f \in KnownFamilies },
      local    |-> { f.name : f \in { g \in KnownFamilies : g.setsLocal } },
      usual    |-> { <<f.name, { WithClass(o, DefaultClassOf(f, o))
                                 : o \in Blockable \cup SyncErrorObs }>>
                     : f \in KnownFamilies },
      obs      |-> ObNumbersOfLogs,
      numbered |-> { f.name : f \in { g \in KnownFamilies : g.byKind } },
      numbers  |-> {FirstNumbered, LastNumbered},
      events   |-> EventClasses,
      queued   |-> OldTodObs \cup (30..38) \cup (40..47),
      tod_obs  |-> TodObs,
      dint_obs |-> DintObs,
      external |-> ExternalObs \cup SyncErrorObs,
      faulty   |-> {TimeErrorOb, ProgramErrorOb},
      startup  |-> { <<t, StartupOb(t)>> : t \in RestartTypes },
      profiles |-> ProfileNames,
      choices  |-> { <<q[1], q[3]>> : q \in Questions } ]

(* What else can stand in their place: the letters that formulas tell      *)
(* apart, and the defaults; PERIODs and the answers of calls.              *)
Alternatives ==
    [ letters  |-> { <<a, Letters(a)>> : a \in Ambiguities },
      defaults |-> { DefaultOf(a) : a \in Ambiguities },
      periods  |-> PeriodCodes,
      answers  |-> AnswersOfCalls ]

-----------------------------------------------------------------------------
(* Events that may be observed in this state *)

Startable ==
    { r \in requests : MayStart(r) /\ r.ob \in loaded /\ HighestFirst(r) }

\* @type: $request => $allowed;
StartOf(r) == IF r.fault = 0 THEN Allowed("start", r.ob, "", 0)
              ELSE Allowed("start", r.ob, "flt_id", r.fault)

(* OtherErrorOb and NoCause stand for no event of the log. *)
Stopping == IF stopCause > 0 /\ CauseHolds(stopCause)
            THEN Allowed("stop", 0, "cause", stopCause)
            ELSE Allowed("stop", 0, "", 0)

ErrorObCalled == IF ErrorObIsDue
                 THEN {Allowed("start", Running.error, "", 0)} ELSE {}

Possible ==
    { StartOf(r) : r \in Startable }
      \cup ErrorObCalled
      \cup { Allowed("start", o, "", 0)
             : o \in { c \in CycleObs : /\ terms.cycle
                                        /\ ENABLED CycleStarts(c) } }
      \cup (IF stack = <<>> \/ mode = "HOLD" \/ Failed THEN {}
            ELSE {Allowed("end", Running.ob, "", 0)})
      \cup (IF Called THEN {Allowed("call", Running.ob, "", 0)} ELSE {})
      \cup (IF mode = "STOP" THEN {Allowed("restart", 0, "", 0)}
            ELSE {Stopping})
      \cup (IF mode = "HOLD" THEN {Allowed("release", 0, "", 0)} ELSE {})
      \cup (IF stopCause = NoCause /\ ENABLED Run
            THEN {Allowed("run", 0, "", 0)} ELSE {})

(* The right values of fields of a line: of each wrong one. A moment stands *)
(* in `time', every other value in `value'.                               *)
\* @type: ($event, Int, Str, Bool, Int) => Set($allowed);
Right(e, o, field, fits, value) ==
    IF fits THEN {} ELSE {Allowed(e.event, o, field, value)}

\* @type: ($event, Int, Bool, $moment) => Set($allowed);
RightTime(e, o, fits, moment) ==
    IF fits THEN {}
    ELSE {[Allowed(e.event, o, "time", -1) EXCEPT !.time = moment]}

(* Of the event of an OB, one value that may stand for it.                 *)
\* @type: Int => Int;
EventOf(o) == IF EventsOf(o) = {} THEN -1 ELSE Least(EventsOf(o))

\* @type: ($request, $event) => Set($allowed);
RightError(r, e) ==
    LET i == e.info
        right(field, fits, value) == Right(e, r.ob, field, fits, value)
        ranIn == IF r.during > 0 THEN ClassOf(r.during) ELSE r.during
        during == InByte(IF r.ob = ProgramErrorOb \/ TimeErrorNamesRunningOb
                         THEN r.during ELSE r.cause)
    IN  right("flt_id", FitsFault(r.fault, i.flt_id), r.fault)
          \cup right("strt_info", FitsFault(r.fault, i.strt_info), r.fault)
          \cup right("error_info", FitsMask(r, i.error_info),
                     LateMask(r.late))
          \cup (IF FitsCause(r, i) THEN {}
                ELSE IF r.cause = 0
                THEN right("ev_ob", Fits(i.ev_ob, InByte(r.during)), r.during)
                ELSE right("ev", FitsEvent(i.ev, r.cause), EventOf(r.cause))
                       \cup right("ev_ob", Fits(i.ev_ob, during), during)
                       \cup right("error_info", Fits(i.error_info, r.word),
                                  r.word))
          \cup (IF FitsRunning(r, i) THEN {}
                ELSE right("csg_ob", Fits(i.csg_ob, r.during), r.during)
                       \cup right("csg_priority",
                                  Fits(i.csg_priority, ranIn), ranIn))

(* Of a tag that is true or false the other value is right.                *)
\* @type: ($request, $event) => Set($allowed);
RightTags(r, e) ==
    LET i == e.info
        truth(field, given, values) ==
          Right(e, r.ob, field, given = -1 \/ given \in values, 1 - given)
    IN  IF r.ob \in TodObs
        THEN truth("caught_up", i.caught_up, CaughtUps(r))
               \cup truth("second_time", i.second_time, SecondTimes(r))
        ELSE IF r.ob \in DintObs \/ FitsDropped(r, i) THEN {}
        ELSE { Allowed(e.event, r.ob, "event_count", n)
               : n \in 0..terms.dropped[r.ob] }

\* @type: ($request, $event) => Set($allowed);
RightInterrupt(r, e) ==
    LET i == e.info
        right(field, fits, value) == Right(e, r.ob, field, fits, value)
    IN  right("strt_info", FitsNumber(i.strt_info, r.ob),
              Least(NumbersOf(r.ob)))
          \cup right("period", r.ob \in TodObs => FitsPeriod(i.period, r.word),
                     r.word)
          \cup right("sign", r.ob \in DintObs => Fits(i.sign, r.word), r.word)
          \cup right("dtime", r.ob \in DintObs => FitsDtime(i.dtime, r.dtime),
                     r.dtime)
          \cup RightTags(r, e)

(* The OB of the line may start by this request, with other information.   *)
\* @type: ($request, $event) => Set($allowed);
RightInfo(r, e) ==
    (IF r.ob \in {TimeErrorOb, ProgramErrorOb} THEN RightError(r, e)
                                              ELSE RightInterrupt(r, e))
      \cup Right(e, r.ob, "priority", Fits(e.info.priority, r.class), r.class)
      \cup RightTime(e, r.ob, FitsTime(r, e), r.since)

(* The entry of the line may come, with other fields.                      *)
\* @type: ($report, $event) => Set($allowed);
RightEntry(r, e) ==
    LET of == r.entry.of
    IN  IF of.ob = 0 THEN RightTime(e, 0, FitsMoment(r, e), r.since)
        ELSE Right(e, 0, "ob", FitsOb(r.entry, e.ob), of.ob)
               \cup Right(e, of.ob, "priority",
                          /\ Fits(e.priority, of.class)
                          /\ Fits(e.info.priority, of.class), of.class)
               \cup RightError(of, e)
               \cup RightTime(e, of.ob, FitsMoment(r, e), r.since)

(* [OBS-04] [OBS-10] Of a cycle OB or a startup OB, that no request starts. *)
\* @type: $event => Set($allowed);
RightStart(e) ==
    IF ~DiffersInInfoAlone(e) THEN {}
    ELSE { Allowed(e.event, e.ob, "strt_info", v)
           : v \in { b \in 1..255 :
                       ENABLED IsStart([e EXCEPT !.info.strt_info = b]) } }
           \cup { Allowed(e.event, e.ob, "priority", v)
                  : v \in { c \in 1..28 :
                            ENABLED IsStart([e EXCEPT !.info.priority = c]) } }

(* The start or the entry that may come in place of the line, and the      *)
(* field that is wrong, if a field is.                                     *)
\* @type: $event => Set($allowed);
WithRightFields(e) ==
    CASE e.event = "start" /\ e.ob \in CycleObs \cup StartupObs ->
           RightStart(e)
      [] e.event = "start" ->
           LET all  == { q \in Startable : q.ob = e.ob }
               told == { q \in all : FitsFault(q.fault, e.info.flt_id) }
           IN  UNION { RightInfo(r, e)
                       : r \in IF told = {} THEN all ELSE told }
      [] e.event = "diag" ->
           UNION { RightEntry(r, e) : r \in EntriesMeant(e) }
      [] OTHER -> {}

(* The right value of each wrong field. *)
\* @type: $event => Set($allowed);
ExpectedState(e) ==
    LET truth(field, given, value) ==
          IF FitsTruth(given, value) THEN {}
          ELSE {Allowed("state", e.ob, field, IF value THEN 1 ELSE 0)}
    IN  truth("loaded", e.loaded, e.ob \in loaded)
          \cup truth("blocked", e.blocked, Blocked(e.ob))
          \cup truth("entries_off", e.entries_off, Silenced(e.ob))
          \cup (IF FitsActive(e) THEN {}
                ELSE {Allowed("state", e.ob, "active", 1 - e.active)})
          \cup (IF FitsLeft(e) THEN {}
                ELSE {Allowed("state", e.ob, "left", dint[e.ob].left)})

\* @type: $event => Set($allowed);
Expected(e) ==
    IF BeforeItsEnd(e) THEN {}
    ELSE IF ~KeepsPace(e) THEN {Allowed("clock", 0, "", 0)}
    ELSE IF e.event = "state" THEN ExpectedState(e)
    ELSE IF e.event \in CallEvents /\ Called /\ ~StandsBefore(e)
    THEN IF AnswerRight(e)
         THEN { Allowed(e.event, e.ob, "status", s) : s \in RightStatuses(e) }
         ELSE { Allowed(e.event, e.ob, "ret", r) : r \in RightAnswers(e) }
                \cup (IF stopCause = NoCause THEN {} ELSE {Stopping})
    ELSE IF WithRightFields(e) # {} THEN WithRightFields(e)
    ELSE Possible
           \cup (IF e.event = "diag" /\ DiagRecorded
                 THEN { Allowed("diag", 0, "id", r.entry.id) : r \in reports }
                 ELSE {})

(* The events that had to come before this line. *)
\* @type: $event => Set($allowed);
TooLate(e) ==
    IF IsOver(e) THEN {Allowed("clock", 0, "", 0)}
    ELSE { StartOf(r) : r \in { q \in Late(e) : q.ob \in loaded } }
      \cup { Allowed("start", ProgramErrorOb, "", 0)
             : r \in { q \in Late(e) : /\ q.ob \notin loaded
                                      /\ q.ob \notin AsyncErrorObs } }
      \cup { Allowed("diag", 0, "id", r.entry.id) : r \in ReportsLate(e) }
      \cup ErrorObCalled
      \cup (IF StopDuty \in DOMAIN waiting THEN {Stopping} ELSE {})

-----------------------------------------------------------------------------
(* The situation, for people to read *)

(* @typeAlias: waiting = { ob: Int, class: Int, rank: Int, fault: Int,     *)
(*                         since: $moment, cause: Int, late: Set(Int),     *)
(*                         follows: Int, open: Bool, ready: Bool,          *)
(*                         missing: Bool };                                *)
\* @type: $request => $waiting;
WaitingAs(r) ==
    [ ob |-> r.ob, class |-> r.class, rank |-> r.rank, fault |-> r.fault,
      since |-> r.since, cause |-> r.cause, late |-> r.late,
      follows |-> r.follows, open |-> r.open, ready |-> MayStart(r),
      missing |-> r.ob \notin loaded ]

\* @type: Int => <<Int, Int>>;
WaitedFor(c) == <<c, waiting[c]>>

(* [OBS-52] [OBS-54] What a hot restart brings back: OBs that go on, with  *)
(* their delay count, start events, delays.                                *)
BroughtBack ==
    [ running |-> resume.stack,
      delay   |-> resume.delay,
      pending |-> { r.ob : r \in { q \in resume.requests : Outlives(q) } },
      dint    |-> IF HotRestartKeepsSettings
                  THEN { o \in DOMAIN resume.dint : resume.dint[o].started }
                  ELSE {} ]

(* Modes, clock, running and waiting OBs, blocks, settings and jobs. *)
Situation ==
    [ mode     |-> mode,
      clock    |-> clock,
      running  |-> stack,
      delay    |-> delay,
      loaded   |-> loaded,
      blocked  |-> { o \in Blockable : Blocked(o) },
      silenced |-> { o \in Blockable : Silenced(o) },
      stop     |-> stopCause,
      latency  |-> terms.latency,
      kept     |-> BroughtBack,
      waited   |-> { WaitedFor(c) : c \in DOMAIN waiting },
      pending  |-> { WaitingAs(r) : r \in requests },
      tod      |-> { [ ob |-> o,
                       active |-> tod[o].active,
                       period |-> ShownPeriod(tod[o].period),
                       start  |-> FirstMoment(tod[o]),
                       next   |-> NextMoment(tod[o]),
                       armed  |-> tod[o].active /\ tod[o].next # Never ]
                     : o \in { p \in DOMAIN tod : tod[p].set } },
      dint     |-> { [ ob |-> o, left |-> dint[o].left,
                       dtime |-> dint[o].dtime, sign |-> dint[o].sign ]
                     : o \in { p \in DOMAIN dint : dint[p].started } } ]
=============================================================================

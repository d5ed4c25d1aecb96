----------------------------- MODULE NextLines ------------------------------
(***************************************************************************)
(* Candidates for the next line of a log: events with operands and values. *)
(* The engine tries each by the operators that judge a log, so a candidate *)
(* need not be possible.                                                   *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, events.                            *)
(* Left out: lines of kind `state', which never have to come; `done',      *)
(* which ends the log; most operands of calls and clocks, and most codes   *)
(* where any is right: a few represent the others.                         *)
(***************************************************************************)
EXTENDS PartialLogs

-----------------------------------------------------------------------------
(* The right answer *)

\* @type: $event => Set(Int);
RightAnswers(e) == IF terms.loose THEN LooseAnswers(e) ELSE AnswersTo(e)

\* @type: $event => Set(Int);
RightStatuses(e) == IF terms.loose THEN LooseStatuses(e.ob) ELSE StatusesOf(e)

\* @type: $event => Bool;
AnswerRight(e) == e.ret = -1 \/ e.ret \in RightAnswers(e)

(* [AMB-70] (b) The delay has to end before this call. *)
\* @type: $event => Bool;
BeforeItsEnd(e) ==
    e.event \in {"SRT_DINT", "CAN_DINT", "QRY_DINT"} /\ ~Ended(e.ob)

-----------------------------------------------------------------------------
(* Representative operands *)

\* @type: Str => $event;
Line(name) == [NoEvent EXCEPT !.event = name]

\* @type: (Str, Int) => $event;
LineOf(name, o) == [NoEvent EXCEPT !.event = name, !.ob = o]

(* The least of these OBs, if there is one.                                *)
\* @type: Set(Int) => Set(Int);
OneOf(obs) == IF obs = {} THEN {} ELSE {Least(obs)}

(* No interrupt has this OB.                                               *)
StrangeOb == 9
StrangePeriod == \h0002

(* The loaded OBs, a missing OB, and a number that no interrupt has. *)
\* @type: Set(Int) => Set(Int);
ObOperands(obs) ==
    (obs \cap loaded) \cup OneOf(obs \ loaded) \cup {StrangeOb}

\* @type: Int => $date;
DateAt(minute) ==
    LET day == minute \div MinutesADay
        rest == minute % MinutesADay
    IN  [ year |-> YearOf(day), month |-> MonthOf(day), day |-> DayOf(day),
          hour |-> rest \div 60, minute |-> rest % 60, second |-> 0, ms |-> 0 ]

(* The next minute, the minute before, the end of the year, no date. *)
NextMinute  == Earlier(clock.min + 1, LastMinute)
SdtOperands ==
    LET next == DateAt(NextMinute)
    IN  { next, DateAt(IF clock.min = 0 THEN 0 ELSE clock.min - 1),
          [next EXCEPT !.month = 12, !.day = 31, !.hour = 23, !.minute = 59],
          [next EXCEPT !.month = 13] }

DtimeOperands == {0, 1, 1000, 60000, 60001}
DisModeOperands == {0, 1, 2, 3, \h80, \h81, \h82}
EnModeOperands  == {0, 1, 2, 3}

(* Numbers of classes are OB numbers, too.                                 *)
IrtOperands == ObOperands(Blockable)
                 \cup { ClassNumber(o) : o \in Blockable \cap loaded }

CallLines ==
    {Line("DIS_AIRT"), Line("EN_AIRT")}
      \cup { [LineOf("SET_TINT", o) EXCEPT !.sdt = DateAt(NextMinute),
                                           !.period = Once]
             : o \in ObOperands(TodObs) }
      \cup { [LineOf("SET_TINT", o) EXCEPT !.sdt = d, !.period = p]
             : o \in OneOf(TodObs \cap loaded), d \in SdtOperands,
               p \in PeriodCodes \cup {StrangePeriod} }
      \cup { [LineOf("SET_TINTL", o) EXCEPT !.sdt = DateAt(NextMinute),
                 !.local = l, !.period = p, !.activate = a]
             : o \in IF Family.setsLocal THEN OneOf(TodObs \cap loaded)
                     ELSE {},
               p \in {Once, Minutely}, l \in {0, 1}, a \in {0, 1} }
      \cup { LineOf(name, o) : name \in {"CAN_TINT", "ACT_TINT", "QRY_TINT"},
                               o \in ObOperands(TodObs) }
      \cup { [LineOf("SRT_DINT", o) EXCEPT !.dtime = d, !.sign = 0]
             : o \in ObOperands(DintObs), d \in DtimeOperands }
      \cup { LineOf(name, o) : name \in {"CAN_DINT", "QRY_DINT"},
                               o \in ObOperands(DintObs) }
      \cup { [LineOf("DIS_IRT", o) EXCEPT !.mode = m]
             : o \in IrtOperands, m \in DisModeOperands }
      \cup { [LineOf("EN_IRT", o) EXCEPT !.mode = m]
             : o \in IrtOperands, m \in EnModeOperands }

(* A minute forward and back; onto each start point, and beyond it.        *)
ClockTimes ==
    LET watched == { o \in TodObs : tod[o].active /\ tod[o].next # Never }
        points  == { NextMoment(tod[o]) : o \in watched }
    IN  { m \in {After(clock, 60000), After(clock, -60000)} \cup points
                  \cup { After(p, 1) : p \in points }
            : m.min \in 0..LastMinute }

-----------------------------------------------------------------------------
(* Lines *)

(* Faults of OB 80 and 85 that come from outside.                          *)
ObsWithFault  == {TimeErrorOb, ProgramErrorOb}
\* @type: Set(<<Int, Int>>);
OutsideFaults == {<<TimeErrorOb, CycleTimeExceeded>>, <<TimeErrorOb, \h0B>>,
                  <<ProgramErrorOb, \hA3>>}

(* Lines that do not depend on the state just before them. *)
NextLines ==
    { LineOf("start", o) : o \in loaded \cup {CycleOb} }
      \cup { LineOf("end", o) : o \in { stack[i].ob : i \in DOMAIN stack }
                                        \cup CycleObs \cup StartupObs }
      \cup { LineOf("interrupt", o)
             : o \in (ExternalObs \cup SyncErrorObs) \ ObsWithFault }
      \cup { [LineOf("interrupt", f[1]) EXCEPT !.flt_id = f[2]]
             : f \in OutsideFaults }
      \cup { [Line("clock") EXCEPT !.to = m] : m \in ClockTimes }
      \cup { [Line("zone") EXCEPT !.zone = zone, !.reason = reason]
             : zone \in IF ~Family.setsLocal THEN {}
                       ELSE {cpu.zone - 60, cpu.zone + 60} \cap ((-720)..840),
               reason \in {"zone", "daylight"} }
      \cup { LineOf("load", o)
             : o \in (Blockable \cup StartupObs \cup SyncErrorObs) \ loaded }
      \cup { LineOf("delete", o) : o \in loaded \ {CycleOb} }
      \cup { [Line("restart") EXCEPT !.type = t]
             : t \in {"warm", "cold"} \cup (IF HotRestartExists THEN {"hot"}
                                          ELSE {}) }
      \cup { Line(name) : name \in {"run", "hold", "release", "stop"} }
      \cup (IF stopCause \in {NoCause, OtherErrorOb} THEN {}
            ELSE {[Line("stop") EXCEPT !.cause = stopCause]})
      \cup { [Line("diag") EXCEPT !.id = r.entry.id]
             : r \in IF DiagRecorded THEN reports ELSE {} }
      \cup (IF mode \in {"STOP", "HOLD"} THEN {} ELSE CallLines)

(* Answers to the call e. Where any code is right, those that calls have   *)
(* and one more represent the others [T15-143].                            *)
\* @type: $event => Set(Int);
ShownAnswers(e) ==
    LET right == Given(e.ret, RightAnswers(e))
        some  == {NotDelayed, BadOb, BadSdt, BadPeriod, NotSet, PastStart,
                  \h80FF}
    IN  IF AnyCode \subseteq right THEN (right \ AnyCode) \cup some
        ELSE right

(* The line with each answer that the CPU may give.                        *)
\* @type: $event => Set($event);
WithAnswers(e) ==
    CASE e.event \in {"QRY_TINT", "QRY_DINT"} ->
           UNION { { [e EXCEPT !.ret = r, !.status = s]
                     : s \in IF r = OK THEN RightStatuses(e) ELSE {-1} }
                   : r \in ShownAnswers(e) }
      [] e.event \in CallEvents ->
           { [e EXCEPT !.ret = r] : r \in ShownAnswers(e) }
      [] e.event = "start" /\ e.ob \in ObsWithFault ->
           { [e EXCEPT !.info.flt_id = r.fault]
             : r \in { q \in requests : q.ob = e.ob } }
      [] OTHER -> {e}

(* A line that stands for e: the same silent steps are possible before it. *)
\* @type: $event => $event;
Likewise(e) == IF Partial \/ e.step > 1 \/ PointsNow # {} \/ OverNow # {}
               THEN e
               ELSE Line(IF e.event = "start" THEN e.event ELSE "")

-----------------------------------------------------------------------------
(* Times *)

\* @type: ($event, { at: $moment, up: $moment }) => $event;
Dated(e, time) == [e EXCEPT !.at = time.at, !.up = time.up]

\* @type: $event => { at: $moment, up: $moment };
TimeOf(e) == [at |-> e.at, up |-> e.up]

Present == [at |-> clock, up |-> up]

(* The CPU clock at its end.                                               *)
EndOfTime ==
    LET end == [min |-> LastMinute, ms |-> 59999]
    IN  [at |-> end, up |-> Shifted(up, clock, end)]

(* d ms from now. *)
\* @type: Int => { at: $moment, up: $moment };
Later(d) == [at |-> After(clock, d), up |-> After(up, d)]

(* The latest moment at which nothing is overdue. It is used in states in  *)
(* which time cannot go on.                                                *)
LastInTime ==
    LET ages == { waiting[c] : c \in { k \in DOMAIN waiting : k < 100 } }
                  \cup { r.age : r \in EntriesLate(terms.latency) }
                  \cup {0}
    IN  Later(terms.latency - (CHOOSE a \in ages : \A b \in ages : b <= a))

(* A moment at which all that waits now is late. *)
TooLateNow == Later(terms.latency + 1)
=============================================================================

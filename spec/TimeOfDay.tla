----------------------------- MODULE TimeOfDay ------------------------------
(***************************************************************************)
(* SFC 28 SET_TINT, SFC 29 CAN_TINT, SFC 30 ACT_TINT and SFC 31 QRY_TINT:  *)
(* what they answer and what they change (catalogue sections 1.2 to 1.5).  *)
(*                                                                         *)
(* Left out: the library function S_LTINT [TINT-40]; a CPU whose reference *)
(* is local time, STATUS bit 6 [TINT-78].                                  *)
(***************************************************************************)
EXTENDS Irt

NoSetting == [ set |-> FALSE, active |-> FALSE, start |-> 0, offset |-> 0,
               period |-> Once, next |-> Never, served |-> {}, repeatTo |-> -1 ]

(* [AMB-57] Inside a repeated interval the OB may keep the memory of the    *)
(* points that were served; elsewhere it has no meaning.                   *)
\* @type: ($tod, $tod) => $tod;
WithMemory(new, old) ==
    IF MemoryOutlivesSetting /\ clock.min <= old.repeatTo
    THEN [new EXCEPT !.served = old.served, !.repeatTo = old.repeatTo]
    ELSE new

\* @type: $tod => $tod;
Forgotten(t) == [t EXCEPT !.served = {}, !.repeatTo = -1]

\* @type: $tod => $tod;
Unset(t) == WithMemory(NoSetting, t)

(* [AMB-08] A once interrupt that has been called is no longer set. *)
\* @type: $tod => $tod;
UsedUp(t) == IF OnceIsUnsetByItsRun THEN Unset(t)
             ELSE [t EXCEPT !.active = FALSE, !.next = Never]

-----------------------------------------------------------------------------
(* The next start point *)

(* The first start point, and the one that is watched for. *)
\* @type: $tod => $moment;
FirstMoment(t) == [min |-> t.start, ms |-> t.offset]
\* @type: $tod => $moment;
NextMoment(t) == [min |-> t.next, ms |-> t.offset]

(* [AMB-37] Equal is not past; under (b) it is. *)
\* @type: ($moment, $moment) => Bool;
IsPast(point, now) ==
    Before(point, now) \/ (point = now /\ EqualIsPast)

(* The first minute with a point that is not past at moment m. *)
\* @type: ($tod, $moment) => Int;
FirstMinute(t, m) == IF IsPast([min |-> m.min, ms |-> t.offset], m)
                     THEN m.min + 1 ELSE m.min

(* [AMB-05] [AMB-43] The series that belongs to a PERIOD. *)
\* @type: Int => Int;
SeriesOf(period) ==
    IF period = Monthly /\ MonthlyFallsOnLastDay THEN MonthlyOrLast
    ELSE IF period = Hourly /\ Period0401IsDaily THEN Daily
    ELSE period

(* [AMB-36] [AMB-39] The first point of the series at or after minute m.    *)
(* Under AMB-36 (b) the first run is one period after the start, under     *)
(* AMB-39 (b) the start of an end-of-month interrupt is a point as well.   *)
\* @type: ($tod, Int) => Int;
PointFrom(t, m) ==
    IF m > t.start THEN FirstPoint(t.start, SeriesOf(t.period), m)
    ELSE IF t.period = EndOfMonth /\ EndOfMonthRunsAtStart THEN t.start
    ELSE IF t.period # Once /\ SeriesBeginsAPeriodLater
    THEN FirstPoint(t.start, SeriesOf(t.period), t.start + 1)
    ELSE FirstPoint(t.start, SeriesOf(t.period), m)

\* @type: ($tod, Int) => Bool;
WasServed(t, p) == \E i \in t.served : i.from <= p /\ p <= i.to

(* The first point at or after moment m that is served.  In an interval     *)
(* that the clock repeats, points that were served are not served again     *)
(* [CLK-09]; whether the others are is a matter of reading [AMB-56].       *)
\* @type: ($tod, $moment, Bool) => Int;
NextPoint(t, m, passing) ==
    LET p == PointFrom(t, FirstMinute(t, m))
    IN  IF p > t.repeatTo THEN p
        ELSE IF passing
        THEN PointFrom(t, t.repeatTo + 1)
        ELSE LET points == {p} \cup { PointFrom(t, i.to + 1)
                                     : i \in { j \in t.served : j.to >= p } }
                 free   == { q \in points : ~WasServed(t, q) }
             IN  CHOOSE q \in free : \A r \in free : q <= r

\* @type: ($tod, $moment) => $tod;
Armed(t, m) == [t EXCEPT !.next = NextPoint(t, m, UnservedAreOver(cpu))]

-----------------------------------------------------------------------------
(* Start events that wait are withdrawn with their setting [AMB-11]. *)

\* @type: Int => Set($request);
Withdrawn(o) == IF TodCallsWithdrawRuns THEN Withdraw(requests, o)
                                        ELSE requests

(* A once interrupt of which nothing more is sure to come: its point was     *)
(* skipped, and no catch-up follows or it is open whether one does [AMB-48] *)
(* [AMB-55].  No source says whether it is still active.                   *)
\* @type: Int => Bool;
Spent(o) ==
    /\ o \in TodObs /\ tod[o].active /\ ~Deselected(o)
    /\ tod[o].period = Once /\ tod[o].next = Never
    /\ ~PendingIn(requests, o) /\ ~OnStack(o)
    /\ LostEventEndsItsSource

\* @type: Int => Set(Int);
ObErrors(o) == IF o \notin TodObs THEN {BadOb} ELSE {}

-----------------------------------------------------------------------------
(* SFC 28 *)

(* [TINT-33] [AMB-01] *)
ValidPeriods ==
    CASE OnlyPeriod1201IsWeekly -> PeriodCodes \ {\h1202}
      [] OnlyPeriod1202IsWeekly -> PeriodCodes \ {\h1201}
      [] OTHER                  -> PeriodCodes

(* [TINT-18] [TINT-39] [AMB-05] *)
\* @type: ($date, Int) => Bool;
ValidSdt(sdt, period) ==
    /\ ValidDate(sdt)
    /\ period = Monthly /\ MonthlyEndsWithDay28 => sdt.day <= 28
    /\ period = Yearly /\ YearlyNotOnLeapDay => sdt.month # 2 \/ sdt.day # 29
    /\ period = EndOfMonth /\ EndOfMonthTakesNoOtherDay =>
         sdt.day = DaysInMonth(sdt.year, sdt.month)

\* @type: $date => $moment;
ExactMoment(sdt) == [min |-> MinuteOf(sdt), ms |-> sdt.second * 1000 + sdt.ms]

(* [TINT-35] [TINT-36] [TINT-37]; seconds are dropped first [AMB-14]. *)
\* @type: (Int, $date, Int) => Set(Int);
SetErrors(o, sdt, period) ==
    LET judged == period = Once \/ EveryPastStartIsRefused
        past   == IsPast(IF SecondsAreDroppedFirst THEN At(MinuteOf(sdt))
                         ELSE ExactMoment(sdt), clock)
    IN  ObErrors(o)
          \cup (IF ValidSdt(sdt, period) THEN {} ELSE {BadSdt})
          \cup (IF period \in ValidPeriods THEN {} ELSE {BadPeriod})
          \cup (IF judged /\ ValidDate(sdt) /\ past THEN {PastStart} ELSE {})

(* [TINT-30] [TINT-31] [TINT-05] [TINT-38] On an error nothing changes      *)
(* [AMB-20].                                                               *)
\* @type: (Int, $date, Int, Int) => Bool;
SetTint(o, sdt, period, ret) ==
    /\ Called
    /\ ret \in Answers(o, SetErrors(o, sdt, period))
    /\ IF ret = OK
       THEN /\ tod' = [tod EXCEPT ![o] =
                         [ Unset(tod[o]) EXCEPT
                             !.set    = TRUE,
                             !.start  = MinuteOf(sdt),
                             !.offset = IF SecondsAreKept
                                        THEN ExactMoment(sdt).ms ELSE 0,
                             !.period = period ]]
            /\ requests' = Withdrawn(o)
       ELSE IF o \in TodObs /\ RefusedSetTintCancels
       THEN /\ tod' = [tod EXCEPT ![o] = Unset(tod[o])]
            /\ requests' = Withdrawn(o)
       ELSE UNCHANGED <<tod, requests>>
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, dint, irt, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------
(* SFC 29 *)

(* [TINT-51] [TINT-52] [AMB-09] *)
\* @type: Int => Set(Int);
CanErrors(o) ==
    IF o \notin TodObs THEN {BadOb}
    ELSE IF \/ ~tod[o].set
            \/ CanTintNeedsActive /\ ~tod[o].active
         THEN {NotSet} ELSE {}

\* @type: Int => Set(Int);
CanAnswers(o) ==
    Answers(o, CanErrors(o))
      \cup (IF Spent(o) /\ OnceIsUnsetByItsRun THEN {NotSet} ELSE {})

(* [TINT-50] [TINT-54]; an OB that runs is not stopped [TINT-53]. *)
\* @type: (Int, Int) => Bool;
CanTint(o, ret) ==
    /\ Called
    /\ ret \in CanAnswers(o)
    /\ IF ret = OK THEN /\ tod' = [tod EXCEPT ![o] = Unset(tod[o])]
                        /\ requests' = Withdrawn(o)
                   ELSE UNCHANGED <<tod, requests>>
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, dint, irt, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------
(* SFC 30 *)

(* [TINT-61] [TINT-62] *)
\* @type: Int => Set(Int);
ActErrors(o) ==
    IF o \notin TodObs THEN {BadOb}
    ELSE IF ~tod[o].set THEN {NotSet}
    ELSE IF /\ ~tod[o].active
            /\ tod[o].period = Once
            /\ IsPast(FirstMoment(tod[o]), clock)
         THEN {PastStart} ELSE {}

(* An active once whose start event waits: open [AMB-60]. *)
\* @type: Int => Set(Int);
ActAnswers(o) ==
    IF Spent(o)
    THEN Answers(o, {}) \cup {IF OnceIsUnsetByItsRun THEN NotSet ELSE PastStart}
    ELSE IF /\ o \in TodObs /\ tod[o].active /\ tod[o].period = Once
       /\ PendingIn(requests, o)
    THEN CASE WaitingOnceIsAhead -> Answers(o, {})
           [] WaitingOnceIsPast  -> Answers(o, {PastStart})
           [] OTHER              -> Answers(o, {}) \cup {PastStart}
    ELSE Answers(o, ActErrors(o))

(* On an active interrupt no effect [TINT-63], but under AMB-10 (b).        *)
\* @type: $tod => $tod;
AfterActivation(t) ==
    IF ~t.active
    THEN Armed(WithMemory([ Forgotten(t) EXCEPT !.active = TRUE ], t), clock)
    ELSE IF ActTintComputesAnew THEN Armed(t, clock) ELSE t

(* [AMB-15] (b) In OB 80 it keeps a catch-up from coming [CLK-04]. *)
\* @type: Int => Set($request);
RequestsAfterAct(o) ==
    IF ActTintStopsCatchUp /\ Running.ob = TimeErrorOb
    THEN Close({ r \in requests : r.ob # o \/ r.follows \notin Skips })
    ELSE requests

(* [TINT-60] [TINT-10] [TINT-24]; a missing OB is noticed later [TINT-17],   *)
(* but under AMB-06 (b).                                                   *)
\* @type: (Int, Int) => Bool;
ActTint(o, ret) ==
    /\ Called
    /\ ret \in ActAnswers(o)
    /\ IF ret = OK
       THEN /\ tod' = [tod EXCEPT ![o] = AfterActivation(@)]
            /\ IF o \notin loaded /\ MissingNoticedAtActivation
               THEN ProgramErrorOccurs(RequestsAfterAct(o), TodRequest(o, clock, 0))
               ELSE /\ requests' = RequestsAfterAct(o)
                    /\ UNCHANGED stopCause /\ NothingEntered
       ELSE UNCHANGED tod /\ Nothing
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, dint, irt, stack, delay>>

-----------------------------------------------------------------------------
(* SFC 31 *)

(* [TINT-74] [AMB-34] [AMB-71] Bit 2 of a once that waits or runs, and of   *)
(* an interrupt without a further point [AMB-68].                          *)
\* @type: Int => Set(Int);
ActiveBit(o) ==
    IF ~tod[o].active THEN {0}
    ELSE IF tod[o].next # Never THEN {4}
    ELSE IF tod[o].period # Once
    THEN CASE EndedSeriesIsActive   -> {4}
           [] EndedSeriesIsInactive -> {0}
           [] OTHER                 -> {0, 4}
    ELSE IF Spent(o) THEN {0, 4}
    ELSE IF WaitingOnceIsActive THEN {4}
    ELSE IF OnStack(o) THEN {0, 4} ELSE {0}

\* @type: Int => Set(Int);
Statuses(o) == StatusWithBit2(o, ActiveBit(o))

(* [TINT-70] [TINT-71]; status is -1 where it is not given. *)
\* @type: (Int, Int, Int) => Bool;
QryTint(o, ret, status) ==
    /\ Called
    /\ ret \in Answers(o, ObErrors(o))
    /\ ret = OK => status = -1 \/ status \in Statuses(o)
    /\ NothingEntered
    /\ UNCHANGED cpuVars

=============================================================================

----------------------------- MODULE TimeOfDay ------------------------------
(***************************************************************************)
(* SFC 28 SET_TINT, SFC 29 CAN_TINT, SFC 30 ACT_TINT and SFC 31 QRY_TINT:  *)
(* their answers and their effects (sections 1.2 to 1.5); SET_TINTL of the *)
(* S7-1500.                                                                *)
(*                                                                         *)
(* Left out: the library function S_LTINT [TINT-40].                       *)
(***************************************************************************)
EXTENDS Calls, StartEvents, TodSettings

(* [TINT-35] [TINT-51] [TINT-61] [TINT-70] *)
\* @type: Int => Set(Int);
ObErrors(o) == IF o \notin TodObs THEN {BadOb} ELSE {}

(* [AMB-11] A waiting start event is withdrawn with its setting. *)
\* @type: Int => Set($request);
Withdrawn(o) == IF TodCallsWithdrawRuns THEN Withdraw(requests, o)
                                        ELSE requests

(* [AMB-57] The setting, without the points whose run a call withdraws.    *)
\* @type: Int => $tod;
Uncalled(o) ==
    IF ~TodCallsWithdrawRuns THEN tod[o]
    ELSE NotServed(tod[o], PointsOf(requests, o))

(* [T15-22] [A15-19] The minute from which the points count: at the end of *)
(* a month perhaps the time of day alone.                                  *)
\* @type: $tod => Set(Int);
StartsOf(t) ==
    IF ~(Family.timeAlone /\ t.period = EndOfMonth) THEN {t.start}
    ELSE (IF CallTakesTheDate THEN {} ELSE {t.start % MinutesADay})
           \cup (IF CallTakesTimeAlone THEN {} ELSE {t.start})

(* [TINT-30] [TINT-50] A call sets the interrupt anew or unsets it. *)
\* @type: (Int, $tod) => Bool;
SettingBecomes(o, t) ==
    /\ tod' \in { [tod EXCEPT ![o] = [t EXCEPT !.start = start]]
                 : start \in StartsOf(t) }
    /\ requests' = Withdrawn(o)

(* [AMB-20] A refused call changes nothing. *)
SettingStays == UNCHANGED <<tod, requests>>

-----------------------------------------------------------------------------
(* SFC 28 *)

(* [TINT-33] [AMB-01] *)
ValidPeriods ==
    CASE OnlyPeriod1201IsWeekly -> PeriodCodes \ {\h1202}
      [] OnlyPeriod1202IsWeekly -> PeriodCodes \ {\h1201}
      [] OTHER ->
           IF Family.openCodes /\ Period1202IsRefused
           THEN PeriodCodes \ {\h1202} ELSE PeriodCodes

(* [T15-23] [A15-02] *)
OpenLeapDay == Family.openCodes /\ LeapDayIsRefused
OpenLateDays == Family.openCodes /\ LateDaysAreTaken

(* [TINT-18] [TINT-39] [AMB-05] [AMB-38] [AMB-39] *)
\* @type: ($date, Int) => Bool;
ValidSdt(sdt, period) ==
    /\ ValidMinute(sdt)
    /\ period = Monthly /\ MonthlyEndsWithDay28 /\ ~OpenLateDays =>
         sdt.day <= 28
    /\ period = Yearly /\ (YearlyNotOnLeapDay \/ OpenLeapDay) =>
         sdt.month # 2 \/ sdt.day # 29
    /\ period = EndOfMonth
         /\ \/ EndOfMonthTakesNoOtherDay
            \/ Family.timeAlone /\ CallRefusesOtherDays  \* [A15-19]
       =>
         sdt.day = DaysInMonth(sdt.year, sdt.month)

(* SDT with its seconds [AMB-14]. *)
\* @type: $date => $moment;
ExactMoment(sdt) == [min |-> MinuteOf(sdt), ms |-> sdt.second * 1000 + sdt.ms]

(* The start with its seconds dropped [AMB-14]; for a one-shot             *)
(* end-of-month interrupt, its only point [AMB-32].                        *)
\* @type: ($date, Int) => $moment;
StartMoment(sdt, period) ==
    IF period = EndOfMonth /\ EndOfMonthIsOnce
    THEN FirstMoment([NoSetting EXCEPT !.period = period,
                                       !.start  = MinuteOf(sdt)])
    ELSE IF SecondsAreDroppedFirst THEN At(MinuteOf(sdt)) ELSE ExactMoment(sdt)

(* [TINT-36] [TINT-37] [AMB-02] SDT is of a time that is zone minutes      *)
(* ahead of the clock, here and below [T15-20].                            *)
\* @type: ($date, Int, Int) => Bool;
StartIsPast(sdt, zone, period) ==
    /\ HasOnePoint(period) \/ EveryPastStartIsRefused
    /\ ValidMinute(sdt)
    /\ IsPast([StartMoment(sdt, period) EXCEPT !.min = ByTheClock(@, zone)],
              clock)

(* [TINT-35] *)
\* @type: (Int, $date, Int, Int) => Set(Int);
SetErrors(o, sdt, zone, period) ==
    ObErrors(o)
      \cup (IF ValidSdt(sdt, period) THEN {} ELSE {BadSdt})
      \cup (IF period \in ValidPeriods THEN {} ELSE {BadPeriod})
      \cup (IF StartIsPast(sdt, zone, period) THEN {PastStart} ELSE {})

(* [T15-32] [T15-23] [A15-22] [A15-02] A PERIOD 1202, yearly on February   *)
(* 29, and monthly from day 29 on may be refused.                          *)
\* @type: (Int, $date, Int, Set(Int)) => Set(Int);
OpenErrors(o, sdt, period, errors) ==
    IF ~Family.openCodes THEN {}
    ELSE IF period = \h1202 /\ ~Period1202IsWeekly
    THEN SettingAnswers(o, errors \cup {BadPeriod})
    ELSE IF /\ period = Yearly /\ sdt.month = 2 /\ sdt.day = 29
            /\ ~LeapDayIsTaken
    THEN SettingAnswers(o, errors \cup {BadSdt})
    ELSE IF period = Monthly /\ sdt.day > 28 /\ LateDaysHaveSomeCode
    THEN AnyCode ELSE {}

(* [TINT-11] [AMB-79] Seconds that no date has are dropped like any, or    *)
(* are an error.                                                           *)
\* @type: (Int, $date, Int, Int) => Set(Int);
SetAnswers(o, sdt, zone, period) ==
    LET errors == SetErrors(o, sdt, zone, period)
    IN  (IF ~OddSeconds(sdt) THEN SettingAnswers(o, errors)
         ELSE (IF OddSecondsMayPass THEN SettingAnswers(o, errors) ELSE {})
                \cup (IF OddSecondsMayBeWrong
                      THEN SettingAnswers(o, errors \cup {BadSdt}) ELSE {}))
          \cup OpenErrors(o, sdt, period, errors)

(* [TINT-31] Set anew, it is not active. *)
\* @type: ($tod, $date, Bool, Int) => $tod;
SetAnew(t, sdt, local, period) ==
    [ Unset(t) EXCEPT !.set    = TRUE,
                      !.start  = MinuteOf(sdt),
                      !.local  = local,
                      !.zone   = ZoneOf(local),
                      !.offset = IF SecondsAreKept THEN ExactMoment(sdt).ms
                                                   ELSE 0,
                      !.period = period ]

(* [T15-21] [A15-01] Whether SDT of SET_TINT is local time.                *)
\* @type: Int => Bool;
SdtIsLocal(o) ==
    /\ Family.setsLocal
    /\ \/ SetTintTakesLocal
       \/ SetTintTakesItsBase /\ o \in TodObs /\ cpu.step7[o].local

\* @type: (Int, $date, Int) => Set(Int);
SetTintAnswers(o, sdt, period) ==
    SetAnswers(o, sdt, ZoneOf(SdtIsLocal(o)), period)

(* [TINT-30] [TINT-05] [TINT-38] A refused call changes nothing, or it     *)
(* cancels the old setting [AMB-20].                                       *)
\* @type: (Int, $date, Int, Int) => Bool;
SetTint(o, sdt, period, ret) ==
    /\ IF ret = OK
       THEN SettingBecomes(o, SetAnew(Uncalled(o), sdt, SdtIsLocal(o), period))
       ELSE IF o \in TodObs /\ RefusedSetTintCancels
       THEN SettingBecomes(o, Unset(Uncalled(o)))
       ELSE SettingStays
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, stopCause, runVars>>

(* [A15-20] The log has told that daylight saving skipped this local time; *)
(* or that it doubled it.                                                  *)
\* @type: $date => Bool;
IsSkipped(sdt) == cpu.hour.from <= MinuteOf(sdt) /\ MinuteOf(sdt) < cpu.hour.to
\* @type: $date => Bool;
IsDoubled(sdt) == cpu.hour.to <= MinuteOf(sdt) /\ MinuteOf(sdt) < cpu.hour.from

(* [T15-141] [A15-20] A local time that is skipped may be refused by any   *)
(* code; if it is doubled, the first one is past for a one-shot interrupt. *)
(* Nobody knows of one that is still ahead: a CPU that refuses such times  *)
(* may refuse it.                                                          *)
\* @type: (Int, $date, Bool, Int) => Set(Int);
SetLocalAnswers(o, sdt, local, period) ==
    LET usual == SetAnswers(o, sdt, ZoneOf(local), period)
        early == SetAnswers(o, sdt, cpu.zone + cpu.hour.from - cpu.hour.to,
                            period)
    IN  CASE ~Family.setsLocal -> {}
          [] ~local \/ ~ValidMinute(sdt) -> usual
          [] IsSkipped(sdt) ->
               (IF SkippedTimeIsRefused THEN {} ELSE usual)
                 \cup (IF SkippedTimeIsTaken THEN {} ELSE AnyCode)
          [] IsDoubled(sdt) ->
               (IF DoubledTimeIsTheFirst THEN {} ELSE usual)
                 \cup (IF DoubledTimeIsTheLast THEN {} ELSE early)
          [] OTHER ->
               usual \cup (IF SkippedTimeIsRefused THEN AnyCode ELSE {})

(* [T15-08] [T15-09] SET_TINTL activates as well, if it is told so.        *)
\* @type: (Int, $date, Bool, Int, Bool, Int) => Bool;
SetTintL(o, sdt, local, period, activate, ret) ==
    /\ IF ret # OK
       THEN IF o \in TodObs /\ RefusedSetTintCancels
            THEN SettingBecomes(o, Unset(Uncalled(o))) /\ UNCHANGED cpu
            ELSE SettingStays /\ UNCHANGED cpu
       ELSE \E start \in StartsOf(SetAnew(Uncalled(o), sdt, local, period)) :
              LET t == [ SetAnew(Uncalled(o), sdt, local, period) EXCEPT
                           !.start = start, !.active = activate ]
              IN  \E c \in IF activate THEN CpusThatShow({t}, clock)
                                       ELSE {cpu} :
                    /\ cpu' = c
                    /\ tod' = [ tod EXCEPT ![o] =
                                  IF activate THEN Armed(t, clock, c) ELSE t ]
                    /\ requests' = Withdrawn(o)
    /\ NothingEntered
    /\ UNCHANGED <<loaded, modeVars, clock, dint, irt, stopCause, runVars>>

-----------------------------------------------------------------------------
(* SFC 29 *)

(* The errors that follow from what is known of the setting. *)
\* @type: Bool => Set(Int);
CanErrorsIf(isSet) == IF isSet THEN {} ELSE {NotSet}

(* [TINT-51] [TINT-52] [AMB-09] *)
\* @type: Int => Set(Int);
CanErrors(o) ==
    IF o \notin TodObs THEN {BadOb}
    ELSE CanErrorsIf(tod[o].set /\ (~CanTintNeedsActive \/ tod[o].active))

(* Whether a one-shot interrupt that is over is still set is open [AMB-48] *)
(* [AMB-55].                                                               *)
\* @type: Int => Set(Int);
CanAnswers(o) ==
    Answers(o, CanErrors(o))
      \cup (IF Spent(o) /\ OnceIsUnsetByItsRun THEN {NotSet} ELSE {})

(* [TINT-50] [TINT-54] An OB that runs is not stopped [TINT-53]. *)
\* @type: (Int, Int) => Bool;
CanTint(o, ret) ==
    /\ IF ret = OK THEN SettingBecomes(o, Unset(Uncalled(o))) ELSE SettingStays
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, stopCause, runVars>>

-----------------------------------------------------------------------------
(* SFC 30 *)

(* The errors that follow from what is known of the setting. *)
\* @type: (Bool, Bool) => Set(Int);
ActErrorsIf(isSet, isPast) ==
    IF isPast THEN {PastStart} ELSE IF isSet THEN {} ELSE {NotSet}

(* [TINT-61] [TINT-62] *)
\* @type: Int => Set(Int);
ActErrors(o) ==
    IF o \notin TodObs THEN {BadOb}
    ELSE ActErrorsIf(tod[o].set, /\ tod[o].set
                                 /\ ~tod[o].active
                                 /\ HasOnePoint(tod[o].period)
                                 /\ IsPast(FirstMoment(tod[o]), clock))

(* A one-shot interrupt that is over may still be active [AMB-48]          *)
(* [AMB-55].                                                               *)
\* @type: Int => Set(Int);
ActAnswersWhenSpent(o) ==
    SettingAnswers(o, {})
      \cup SettingAnswers(o, {IF OnceIsUnsetByItsRun THEN NotSet
                                                     ELSE PastStart})

(* [AMB-60] The call of an active one-shot interrupt waits or runs, or its *)
(* point has passed without one.                                           *)
\* @type: Int => Set(Int);
ActAnswersWhenCalled(o) ==
    CASE CalledOnceIsAhead -> SettingAnswers(o, {})
      [] CalledOnceIsPast  -> SettingAnswers(o, {PastStart})
      [] OTHER             -> SettingAnswers(o, {})
                                \cup SettingAnswers(o, {PastStart})

(* [TINT-61] *)
\* @type: Int => Set(Int);
ActAnswers(o) ==
    OpenCodes(IF /\ Spent(o)
                 /\ OpenIn(requests, o) \/ IsPast(FirstMoment(tod[o]), clock)
              THEN ActAnswersWhenSpent(o) \cup ActAnswersWhenCalled(o)
              ELSE IF Spent(o) THEN ActAnswersWhenSpent(o)
              ELSE IF o \in TodObs /\ CallUsesUp(o)
              THEN ActAnswersWhenCalled(o)
              ELSE SettingAnswers(o, ActErrors(o)))

(* [AMB-10] (b) In repeated time an active one is activated anew [AMB-57]. *)
\* @type: Int => Bool;
IsActivatedAnew(o) == /\ ActTintComputesAnew /\ ~CallUsesUp(o)
                      /\ clock.min <= tod[o].repeatTo

(* [TINT-63] An inactive interrupt gets its next point. An active one      *)
(* stays, or its next point is computed anew.                              *)
\* @type: Int => $tod;
ActiveSetting(o) ==
    IF tod[o].active /\ ~IsActivatedAnew(o) THEN tod[o]
    ELSE WithMemory([tod[o] EXCEPT !.active = TRUE], tod[o])

\* @type: (Int, $cpu) => $tod;
AfterActivation(o, c) ==
    IF tod[o].active /\ (CallUsesUp(o) \/ ~ActTintComputesAnew) THEN tod[o]
    ELSE Armed(ActiveSetting(o), clock, c)

(* [AMB-15] (b) Called in OB 80, it cancels a catch-up [CLK-04]. *)
\* @type: Int => Set($request);
RequestsAfterAct(o) ==
    IF ActTintStopsCatchUp /\ InTimeErrorOb
    THEN Close({ r \in requests : r.ob # o \/ ~IsCatchUp(r) })
    ELSE requests

(* [TINT-60] A missing OB is noticed later [TINT-17], or at once [AMB-06]. *)
\* @type: Int => Bool;
Activates(o) ==
    /\ \E c \in CpusThatShow({ActiveSetting(o)}, clock) :
         /\ cpu' = c
         /\ tod' = [tod EXCEPT ![o] = AfterActivation(o, c)]
    /\ IF o \notin loaded /\ MissingNoticedAtActivation
       THEN ProgramErrorOccurs(RequestsAfterAct(o), TodRequest(o, clock, 0))
       ELSE RequestsBecome(RequestsAfterAct(o))

(* [TINT-60] *)
\* @type: (Int, Int) => Bool;
ActTint(o, ret) ==
    /\ IF ret = OK THEN Activates(o) ELSE UNCHANGED <<cpu, tod>> /\ Nothing
    /\ UNCHANGED <<loaded, modeVars, clock, dint, irt, runVars>>

-----------------------------------------------------------------------------
(* SFC 31 *)

(* [AMB-68] Bit 2 of a series without a further point. *)
BitOfEndedSeries == CASE EndedSeriesIsActive   -> {4}
                      [] EndedSeriesIsInactive -> {0}
                      [] OTHER                 -> {0, 4}

(* [AMB-34] Bit 2 of an active one-shot interrupt whose point has passed;  *)
(* it may wait.                                                            *)
\* @type: Int => Set(Int);
BitOfPassedOnce(o) ==
    IF Spent(o) THEN {0, 4}
    ELSE IF ~PendingIn(requests, o) \/ WaitingOnceIsActive THEN {4}
    ELSE IF WaitingOnceIsInactive THEN {0} ELSE {0, 4}

(* [TINT-74] Bit 2. *)
\* @type: Int => Set(Int);
ActiveBit(o) ==
    IF ~tod[o].active THEN {0}
    ELSE IF tod[o].next # Never THEN {4}
    ELSE IF ~HasOnePoint(tod[o].period) THEN BitOfEndedSeries
    ELSE BitOfPassedOnce(o)

(* [TINT-71] *)
\* @type: Int => Set(Int);
Statuses(o) == StatusWithBit2(o, ActiveBit(o))

\* @type: Int => Set(Int);
QryAnswers(o) == OpenCodes(Answers(o, ObErrors(o)))

(* [TINT-70] [TINT-71] -1: the status is not given. *)
\* @type: (Int, Int, Int) => Bool;
QryTint(o, ret, status) ==
    /\ ret = OK => status = -1 \/ status \in Statuses(o)
    /\ NothingEntered
    /\ UNCHANGED cpuVars
=============================================================================

------------------------------ MODULE MCTables ------------------------------
(***************************************************************************)
(* The tables of the specification, written down a second time: the        *)
(* letters of open questions and the answers of module Readings under      *)
(* each, from docs/rules/readings.md; OBs, their classes and the numbers   *)
(* of SFC 39, months, from docs/rules/requirements.md. So a wrong letter   *)
(* or number shows even if no behaviour of another model depends on it.    *)
(*                                                                         *)
(* The CPU is in STOP and nothing happens: each state is a CPU.            *)
(***************************************************************************)
EXTENDS MCEffects

MCLoads == {{}}
MCStep7Settings ==
    { [ o \in OldTodObs |-> [NotConfigured EXCEPT !.deselected = (o = 17)] ] }
MCPriorities == { [o \in {57} |-> 0] }
MCPowerOnMoments == {Moment(0, 30000)}
\* @type: Set(Str);
NoRestartTypes == {}

(* A log's header may name these letters; a CPU or a profile these words.  *)
MCReadingSets ==
    { [a \in {} |-> ""] }
      \cup UNION { { [x \in {a} |-> letter] : letter \in Letters(a) }
                   : a \in Ambiguities }
      \cup { [x \in {"AMB-06"} |-> "delay"], [x \in {"AMB-38"} |-> "before"],
             [x \in {"AMB-38"} |-> "after"], [x \in {"AMB-80"} |-> "base"],
             [x \in {"AMB-80"} |-> "local"] }

-----------------------------------------------------------------------------

Digits == {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"}
Numbers == { p \o d \o e : p \in {"AMB-", "A15-"}, d, e \in Digits }

(* 88 questions and 24 about the S7-1500, a row each; no formula asks four *)
(* of the 88. A default is a letter that a header may name. A profile      *)
(* names a letter where the default rejects what its edition prints.       *)
LettersAgree ==
    /\ Cardinality(Questions) = 88 + 24
    /\ Cardinality({ q[1] : q \in Questions }) = 88 + 24
    /\ \A q \in Questions : q[1] \in Numbers /\ q[2] \in q[3]
    /\ Cardinality(Ambiguities) = 88 - 4 + 24
    /\ \A a \in Ambiguities : Defaults[a] \in Letters(a)
    /\ \A name \in ProfileNames : \A p \in Profile(name) :
         /\ p[1] \in Ambiguities /\ p[2] # Defaults[p[1]]
         /\ p[2] \in Letters(p[1]) \/ p = <<"AMB-06", "delay">>
    /\ Profile("") = {}

(* An S7-1500, and that the others have none of its facts.                 *)
ModernAgrees ==
    /\ \A f \in KnownFamilies :
         LET isS71500 == f.name = "S7-1500"
         IN  /\ f.byKind <=> isS71500
             /\ f.raises <=> ~isS71500
             /\ f.inherits <=> ~isS71500
             /\ f.stops <=> ~isS71500
             /\ f.heldBack = IF isS71500 THEN {80} ELSE {}
             /\ f.keeps <=> isS71500
             /\ f.jump = IF isS71500 THEN 20000 ELSE 0
             /\ f.queues <=> isS71500
             /\ f.openCodes <=> isS71500
             /\ f.showsDelay <=> isS71500
             /\ f.timeAlone <=> isS71500
             /\ f.setsLocal <=> isS71500
             /\ f.holdsStartup <=> isS71500
             /\ f.missesInStop <=> isS71500
             /\ isS71500 <=> f.unknown # {}
             /\ isS71500 <=> f.letters # {}
    /\ LET f == FamilyOf("S7-1500")
       IN  /\ f.settable /\ ~f.repeats /\ f.restarts = {"warm"}
           /\ f.lacks = {60, 70, 72, 81, 84, 85, 87}
           /\ {85, 101, 102} \subseteq f.unknown
           /\ f.unknown \cap {1, 10, 20, 35, 40, 80, 82, 100, 121} = {}
           /\ \A p \in f.letters :
                p[1] \in Ambiguities /\ p[2] \in RowOf(p[1])[3]
           /\ ClassesToSet(f, 10) = 2..24 /\ ClassesToSet(f, 20) = 2..24
           /\ ClassesToSet(f, 40) = 2..26 /\ ClassesToSet(f, 82) = 2..26
           /\ ClassesToSet(f, 121) = 2..26 /\ ClassesToSet(f, 80) = {}
           /\ ClassesToSet(FamilyOf("S7-400"), 10) = {0} \cup (2..23)

(* [OBS-04] [OBS-05] [AMB-65] [AMB-73] [CLK-09] [CLK-10] An S7-300, and    *)
(* two other families, which differ in nothing here.                       *)
FamiliesAgree ==
    /\ FamilyNames = {"S7-300", "S7-400", "CPU 318", "S7-1500"}
    /\ Cardinality(KnownFamilies) = 4
    /\ ModernAgrees
    /\ \A f \in { g \in KnownFamilies : g.name # "S7-1500" } :
         LET isS7300 == f.name = "S7-300"
         IN  /\ f.errorClass = IF isS7300 THEN 26 ELSE 25
             /\ f.settable <=> ~isS7300
             /\ f.lacks = IF isS7300 THEN {30, 31, 32, 33, 34, 60, 70, 72}
                                    ELSE {60, 70, 72}
             /\ f.restarts = CASE isS7300 -> {"warm"}
                               [] f.name = "S7-400" -> {"warm", "cold", "hot"}
                               [] OTHER -> {"warm", "cold"}
             /\ f.repeats <=> isS7300

(* [OBS-04] Table 7.1; [OBS-05] OB 57 has the class that is set. *)
ClassesInv ==
    /\ ClassOf(1) = 1
    /\ \A o \in 10..17 : ClassOf(o) = 2
    /\ \A i \in 1..4 : ClassOf(19 + i) = <<3, 4, 5, 6>>[i]
    /\ \A i \in 1..9 : ClassOf(29 + i) = <<7, 8, 9, 10, 11, 12, 13, 14, 15>>[i]
    /\ \A i \in 1..8 : ClassOf(39 + i) = <<16, 17, 18, 19, 20, 21, 22, 23>>[i]
    /\ ClassOf(55) = 2 /\ ClassOf(56) = 2 /\ ClassOf(57) = 0
    /\ ClassOf(60) = 25 /\ ClassOf(70) = 25 /\ ClassOf(72) = 28
    /\ ClassOf(80) = 26
    /\ \A o \in 81..87 : ClassOf(o) = IF cpu.family = "S7-300" THEN 26 ELSE 25
    /\ \A o \in StartupObs : ClassOf(o) = 27

(* [IRT-11] The OBs of each class number. *)
\* @type: Int => Set(Int);
OfClass(n) == CASE n = 10 -> 10..17 [] n = 20 -> 20..23 [] n = 30 -> 30..38
                [] n = 40 -> 40..47 [] n = 50 -> 55..57 [] n = 60 -> {60}
                [] n = 70 -> {70, 72} [] OTHER -> 80..87
ClassNumbers == {10, 20, 30, 40, 50, 60, 70, 80}

(* [IRT-06] .. [IRT-09] [IRT-13] What SFC 39 and 40 take, and whom they    *)
(* mean, where nothing else is read than by default.                       *)
NumbersInv ==
    /\ TodObs = 10..17 /\ DintObs = 20..23  \* [TINT-01] [DINT-01]
    /\ UNION { OfClass(n) : n \in ClassNumbers } = Blockable
    /\ ExternalObs = UNION { OfClass(n) : n \in ClassNumbers \ {10, 20} }
    /\ \A o \in Blockable : o \in OfClass(ClassNumber(o))
    /\ cpu.readings = [a \in {} |-> ""] =>
         /\ \A m \in 0..255 :
              /\ m \in DisModes <=> m % 128 < 3
              /\ m \in EnModes <=> m < 3
              /\ WithoutEntries(m) <=> m \in 128..255
         /\ \A n \in -1..130 :
              /\ NumberFits(0, n)
              /\ NumberFits(1, n) <=> n \in ClassNumbers
              /\ NumberFits(2, n) <=> n \in Blockable
              /\ Meant(130, n) = {n}
         /\ \A n \in ClassNumbers : Meant(129, n) = OfClass(n)
         /\ Meant(0, 0) = Blockable

(* The tables say what the formulas say of which they are made; the proofs *)
(* have these formulas in their place (APSystem).                          *)
TablesAgree ==
    \A f \in KnownFamilies :
        /\ FamilyOf(f.name) = f
        /\ \A o \in Tabled :
              DefaultClasses[f.name][o] = DefaultClassOf(f, o)

(* [TINT-39] The lengths of the months. *)
MonthsAgree ==
    \A m \in 1..12 :
      /\ DaysInMonth(1990, m)
           = <<31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31>>[m]
      /\ DaysInMonth(1992, m) = DaysInMonth(1990, m) + (IF m = 2 THEN 1 ELSE 0)

(* A letter that is named counts, and it alone. *)
NamedInv == \A a \in Ambiguities : \A letter \in Letters(a) :
              ReadingOf(ReadAs(a, letter, cpu), a) = letter

(* TLC takes only formulas that depend on the state for an invariant. *)
LettersInv == mode = "STOP" => LettersAgree
MonthsInv  == mode = "STOP" => MonthsAgree
FamiliesInv == mode = "STOP" => FamiliesAgree /\ TablesAgree

-----------------------------------------------------------------------------
(* Readings *)

\* @type: (Set(Set(Int)), Set(Int)) => Bool;
MayBe(parts, part) == part \in parts

SettingsInv ==
    /\ Holds("AMB-01", "c", {"a"}, OnlyPeriod1201IsWeekly)
    /\ Holds("AMB-01", "c", {"b"}, OnlyPeriod1202IsWeekly)
    /\ Holds("AMB-01", "c", {"c"}, BothPeriodsAreWeekly)
    /\ Holds("AMB-02", "b", {"a"}, EveryPastStartIsRefused)
    /\ Holds("AMB-03", "a", {"b", "c"}, Bit0ShowsDeselection)
    /\ Holds("AMB-03", "a", {"d"}, Bit0IsZeroInStartup)
    /\ Holds("AMB-04", "a", {"b"}, Bit5MeansNoTest)
    /\ Holds("AMB-05", "a", {"a"}, MonthlyEndsWithDay28)
    /\ Holds("AMB-05", "a", {"c"}, MonthlyFallsOnLastDay)
    /\ Holds("AMB-08", "a", {"a"}, OnceIsUnsetByItsRun)
    /\ Holds("AMB-09", "a", {"b"}, CanTintNeedsActive)
    /\ Holds("AMB-10", "a", {"b"}, ActTintComputesAnew)
    /\ Holds("AMB-12", "a", {"a"}, LostEventEndsItsSource)
    /\ Holds("AMB-14", "a", {"a"}, SecondsAreDroppedFirst)
    /\ Holds("AMB-14", "a", {"c"}, SecondsAreKept)
    /\ Holds("AMB-20", "a", {"b"}, RefusedSetTintCancels)
    /\ Holds("AMB-29", "a", {"b"}, PointsComeByNumber)
    /\ Holds("AMB-32", "a", {"b"}, EndOfMonthIsOnce)
    /\ Holds("AMB-34", "c", {"a"}, WaitingOnceIsActive)
    /\ Holds("AMB-34", "c", {"b"}, WaitingOnceIsInactive)
    /\ Holds("AMB-35", "a", {"a"}, StartupDefersOneRun)
    /\ Holds("AMB-36", "a", {"b"}, SeriesBeginsAPeriodLater)
    /\ Holds("AMB-37", "a", {"b"}, EqualIsPast)
    /\ Holds("AMB-38", "a", {"b"}, YearlyNotOnLeapDay)
    /\ Holds("AMB-38", "a", {"before"}, YearlyFallsOnDayBefore)
    /\ Holds("AMB-38", "a", {"after"}, YearlyFallsOnDayAfter)
    /\ Holds("AMB-38", "a", {"c"}, Cardinality(CpusByLeapDay(cpu)) = 2)
    /\ Holds("AMB-39", "a", {"b"}, EndOfMonthRunsAtStart)
    /\ Holds("AMB-39", "a", {"c"}, EndOfMonthTakesNoOtherDay)
    /\ Holds("AMB-43", "a", {"b"}, Period0401IsDaily)
    /\ Holds("AMB-60", "c", {"a"}, CalledOnceIsAhead)
    /\ Holds("AMB-60", "c", {"b"}, CalledOnceIsPast)
    /\ Holds("AMB-61", "c", {"a"}, DeselectedIsRefused)
    /\ Holds("AMB-61", "c", {"b"}, DeselectedIsOrdinary)
    /\ Holds("AMB-62", "a", {"b"}, NoneHasItsDate)
    /\ Holds("AMB-63", "b", {"a"}, FirstErrorIsAnswered)
    /\ Holds("AMB-68", "c", {"a"}, EndedSeriesIsActive)
    /\ Holds("AMB-68", "c", {"b"}, EndedSeriesIsInactive)
    /\ Holds("AMB-71", "d", {"b"}, OnceUsedUpAtItsPoint)
    /\ Holds("AMB-71", "d", {"a", "b", "d"}, OnceMayEndAtItsStart)
    /\ Holds("AMB-71", "d", {"c", "d"}, OnceMayEndAtItsEnd)
    /\ Holds("AMB-79", "c", {"a", "c"}, OddSecondsMayPass \/ SecondsAreKept)
    /\ Holds("AMB-79", "c", {"b", "c"}, OddSecondsMayBeWrong)
         \/ SecondsAreKept
    /\ SecondsAreKept => OddSecondsMayBeWrong /\ ~OddSecondsMayPass
    /\ Holds("AMB-80", "a", {"a", "base"}, ReferenceIsBaseTime)
    /\ Holds("AMB-80", "a", {"local"}, ReferenceIsLocalTime)
    /\ Holds("AMB-80", "a", {"b"}, Cardinality(CpusByReference(cpu)) = 2)
    /\ Holds("AMB-81", "a", {"b"}, CallsMayFail)
    /\ Holds("AMB-82", "a", {"b"}, Bit3IsOpen)
    /\ Holds("AMB-86", "a", {"a", "d"}, Step7MayLeaveMonthsOut)
    /\ Holds("AMB-86", "a", {"b", "d"}, Step7MayTakeLastDay)
    /\ Holds("AMB-86", "a", {"c", "d"}, Step7MayNeverRun)

ClockInv ==
    /\ Holds("AMB-15", "a", {"b"}, ActTintStopsCatchUp)
    /\ Holds("AMB-15", "a", {"c"}, DisIrtStopsCatchUp)
    /\ Holds("AMB-16", "a", {"a"}, SkipGivesNewTime)
    /\ Holds("AMB-17", "a", {"b"}, S7300RemembersServed)
    /\ Holds("AMB-40", "a", {"b"}, SetBackCallsActiveObs)
    /\ Holds("AMB-50", "c", {"a", "c"}, MayBe(UnreportedAmong({10}), {}))
    /\ Holds("AMB-50", "c", {"b", "c"}, MayBe(UnreportedAmong({10}), {10}))
    /\ Holds("AMB-51", "a", {"b"}, SkipOfMissingObIsSilent)
    /\ Holds("AMB-52", "c", {"a", "c"}, MayBe(MergedAmong({10}), {}))
    /\ Holds("AMB-52", "c", {"b", "c"}, MayBe(MergedAmong({10}), {10}))
    /\ Holds("AMB-53", "c", {"a", "c"}, SkipMayBeDeferred)
    /\ Holds("AMB-53", "c", {"b", "c"}, SkipMayBeReported)
    /\ Holds("AMB-54", "c", {"a"}, CatchUpsComeByPoint)
    /\ Holds("AMB-54", "c", {"b"}, CatchUpsComeByNumber)
    /\ Holds("AMB-55", "c", {"b"}, NoCatchUpAfterHold)
    /\ Holds("AMB-55", "c", {"c"}, CatchUpAfterHoldIsOpen)
    /\ Holds("AMB-56", "c", {"b"}, UnservedAreOver(cpu))
    /\ Holds("AMB-56", "c", {"d"}, UnservedAreOverToLastCall(cpu))
    /\ Holds("AMB-57", "c", {"a"}, NewSettingForgets(cpu))
    /\ Holds("AMB-56", "c", {"a", "b", "d"}, Cardinality(CpusByMemory) = 2)
    /\ Holds("AMB-57", "c", {"a", "b"}, Cardinality(CpusByMemory) = 3)
    /\ \A c \in CpusByMemory : /\ ReadingOf(c, "AMB-56") \in {"a", "b", "d"}
                               /\ ReadingOf(c, "AMB-57") \in {"a", "b"}
    /\ Holds("AMB-58", "a", {"b"}, ServedPointsAreSkipped)
    /\ Holds("AMB-59", "a", {"b"}, SetBackWithdrawsRuns)
    /\ Holds("AMB-83", "c", {"a"}, SetBackForgetsHeld)
    /\ Holds("AMB-83", "c", {"b"}, SetBackKeepsHeld)

DispatchInv ==
    /\ Holds("AMB-06", "a", {"b"}, MissingNoticedAtActivation)
    /\ Holds("AMB-06", "a", {"b", "delay"}, MissingNoticedAtSrtDint)
    /\ Holds("AMB-06", "a", {"c"}, MissingIsTimeError)
    /\ Holds("AMB-07", "a", {"b"}, DelaysNeverStopTheCpu)
    /\ Holds("AMB-11", "d", {"b", "c", "d"}, TodCallsWithdrawRuns)
    /\ Holds("AMB-11", "d", {"b"}, DintCallsWithdrawRuns(cpu))
    /\ Holds("AMB-11", "d", {"d"}, Cardinality(CpusByDintCalls) = 2)
    /\ Holds("AMB-11", "d", {"b", "d"},
             \E c \in CpusByDintCalls : DintCallsWithdrawRuns(c))
    /\ Holds("AMB-13", "d", {"a", "d"}, Class28InStartup)
    /\ Holds("AMB-13", "d", {"b", "d"}, Class28OnOverflow)
    /\ Holds("AMB-18", "d", {"a"}, SecondRequestIsTimeError)
    /\ Holds("AMB-18", "d", {"b"}, SecondRequestIsBuffered)
    /\ Holds("AMB-18", "d", {"c"}, SecondRequestIsMerged)
    /\ Holds("AMB-18", "d", {"b", "d"}, BuffersMayOverflow)
    /\ Holds("AMB-18", "d", {"d"}, SecondRequestIsOpen)
    /\ Holds("AMB-19", "a", {"b"}, EveryPointRunsLater)
    /\ Holds("AMB-19", "a", {"c"}, OnlyFirstPointIsReported)
    /\ Holds("AMB-25", "a", {"b"}, CountOutlivesTheCycle)
    /\ Holds("AMB-27", "b", {"a"}, TimeErrorNamesRunningOb)
    /\ Holds("AMB-28", "c", {"a"}, MissingObIsFaultA1)
    /\ Holds("AMB-28", "c", {"c"}, MissingObIsEitherFault)
    /\ Holds("AMB-31", "b", {"a"}, DtimeIsElapsedTime)
    /\ Holds("AMB-44", "b", {"a"}, MissingNoticedWhenDue)
    /\ Holds("AMB-45", "c", {"a"}, OneOb85ForAll)
    /\ Holds("AMB-45", "c", {"b"}, OneOb85ForEach)
    /\ Holds("AMB-46", "a", {"b"}, MissingObEndsItsSource)
    /\ Holds("AMB-47", "c", {"a"}, OverlappingDelayRuns)
    /\ Holds("AMB-47", "c", {"b"}, OverlappingDelayRunsNot)
    /\ Holds("AMB-48", "c", {"a"}, LateRunOutlivesBlock)
    /\ Holds("AMB-48", "c", {"b"}, LateRunIsLostWithOb80)
    /\ Holds("AMB-49", "c", {"a"}, StopIsNotDelayed)
    /\ Holds("AMB-49", "c", {"b"}, StopAwaitsTheDelay)
    /\ Holds("AMB-65", "a", {"a"}, S7300RestartsCold)
    /\ Holds("AMB-66", "a", {"b"}, DeletedObTakesRequests)
    /\ Holds("AMB-67", "c", {"b"}, OutsideRunEventsAreLost)
    /\ Holds("AMB-67", "c", {"c"}, OutsideRunEventsAreOpen)
    /\ Holds("AMB-69", "c", {"a"}, DelayBeginsWaitsAnew)
    /\ Holds("AMB-69", "c", {"b"}, NothingStandsBefore)
    /\ Holds("AMB-87", "c", {"a"}, MissingOb85StopsAtOnce)
    /\ Holds("AMB-87", "c", {"b"}, MissingOb85StopsInTurn)
    /\ Holds("AMB-26", "a", {"a"}, HotRestartKeepsSettings)
    /\ Holds("AMB-88", "c", {"a"}, ErrorKeepsItsClass)
    /\ Holds("AMB-88", "c", {"b"}, ErrorTakesClassOfRun)
    /\ Holds("AMB-70", "c", {"a"}, CallsComeBeforeTheEnd)
    /\ Holds("AMB-70", "c", {"b"}, CallsComeAfterTheEnd)
    /\ Holds("AMB-74", "a", {"b"}, RestartedJobKeepsSign)
    /\ Holds("AMB-75", "a", {"a"}, ErrorObsAreNotReported)
    /\ Holds("AMB-84", "d", {"a"}, HeldErrorStopsAtOnce)
    /\ Holds("AMB-84", "d", {"b"}, HeldErrorStopsLater)
    /\ Holds("AMB-84", "d", {"c"}, HeldErrorIsLost)
    /\ Holds("AMB-77", "d", {"a"}, ExternalAgainIsTimeError)
    /\ Holds("AMB-77", "d", {"b"}, ExternalAgainIsBuffered)
    /\ Holds("AMB-77", "d", {"c"}, ExternalAgainIsLost)

BlocksInv ==
    /\ Holds("AMB-21", "a", {"b"}, BlocksHaveLevels)
    /\ Holds("AMB-22", "a", {"b"}, Mode0TakesOb0Alone)
    /\ Holds("AMB-23", "a", {"b"}, BlockedErrorStopsTheCpu)
    /\ Holds("AMB-33", "a", {"b"}, BlockedOb85StopsTheCpu)
    /\ Holds("AMB-41", "a", {"a"}, DisIrtIsEntered)
    /\ Holds("AMB-41", "a", {"b"}, LostEventIsEntered)
    /\ Holds("AMB-42", "a", {"b"}, EnIrtMode1Blocks)
    /\ Holds("AMB-72", "a", {"b"}, DisIrtDropsRequests)
    /\ Holds("AMB-73", "a", {"b"}, LackingObsAreRefused)
    /\ Holds("AMB-76", "a", {"b"}, EnIrtTakesMode8x)

ModernInv ==
    /\ Holds("A15-01", "a", {"b"}, SetTintTakesLocal)
    /\ Holds("A15-01", "a", {"c"}, SetTintTakesItsBase)
    /\ Holds("A15-17", "b", {"a"}, SmallJumpEndsUnserved(cpu))
    /\ Holds("A15-17", "b", {"c"}, Cardinality({ ReadingOf(c, "A15-17")
                                                : c \in CpusByMemory }) = 2)
    /\ Holds("A15-20", "f", {"a"}, SkippedTimeIsRefused)
    /\ Holds("A15-20", "f", {"b"}, SkippedTimeIsTaken)
    /\ Holds("A15-20", "f", {"d"}, DoubledTimeIsTheFirst)
    /\ Holds("A15-20", "f", {"e"}, DoubledTimeIsTheLast)
    /\ Holds("A15-02", "f", {"b"}, LateDaysAreTaken)
    /\ Holds("A15-02", "f", {"c"}, LateDaysHaveSomeCode)
    /\ Holds("A15-02", "f", {"d"}, LeapDayIsTaken)
    /\ Holds("A15-02", "f", {"e"}, LeapDayIsRefused)
    /\ Holds("A15-03", "c", {"a"}, OverflowIsEnteredAlone)
    /\ Holds("A15-03", "c", {"b"}, OverflowCallsOb80)
    /\ Holds("A15-04", "a", {"b"}, DelaysStandStill)
    /\ Holds("A15-06", "c", {"a"}, OverflowIsEnteredOnce)
    /\ Holds("A15-07", "a", {"a"}, RunningEventCountsNot)
    /\ Holds("A15-07", "a", {"b"}, RunningEventCounts)
    /\ Holds("A15-16", "a", {"a"}, CaughtUpIsOfTheClock)
    /\ Holds("A15-18", "c", {"a"}, FirstAloneIsSecondTime)
    /\ Holds("A15-18", "c", {"b"}, EachIsSecondTime)
    /\ Holds("A15-05", "c", {"b"}, WithItsHardware(cpu) # cpu)
    /\ Holds("A15-08", "d", {"a"}, EachSkippedObIsCaughtUp)
    /\ Holds("A15-08", "d", {"b"}, OnlyFirstSkippedIsCaughtUp)
    /\ Holds("A15-08", "d", {"c"}, FirstOfEachClassIsCaughtUp)
    /\ Holds("A15-10", "c", {"a"}, DaylightIsQuiet = {TRUE})
    /\ Holds("A15-10", "c", {"b"}, DaylightIsQuiet = {FALSE})
    /\ Holds("A15-11", "c", {"a"}, CatchUpNeedsNoOb80)
    /\ Holds("A15-11", "c", {"b"}, CatchUpNeedsOb80)
    /\ Holds("A15-12", "c", {"a"}, StopPointsAreNothing)
    /\ Holds("A15-12", "c", {"b"}, StopPointsAreReported)
    /\ Holds("A15-13", "c", {"a"}, MissingIsRefused)
    /\ Holds("A15-13", "c", {"b"}, MissingIsNotRefused)
    /\ Holds("A15-14", "a", {"b"}, QueueIsUnknown)
    /\ Holds("A15-15", "c", {"a"}, OverloadIsReportedOnce)
    /\ Holds("A15-15", "c", {"b"}, OverloadIsReportedAgain)
    /\ Holds("A15-19", "d", {"a"}, CallTakesTimeAlone)
    /\ Holds("A15-19", "d", {"b"}, CallTakesTheDate)
    /\ Holds("A15-19", "d", {"c"}, CallRefusesOtherDays)
    /\ Holds("A15-21", "f", {"a"}, NumberedHaveAClass)
    /\ Holds("A15-21", "f", {"b"}, NumberedHaveNoClass)
    /\ Holds("A15-21", "f", {"d"}, Mode8xIsKnown)
    /\ Holds("A15-21", "f", {"e"}, Mode8xIsUnknown)
    /\ Holds("A15-22", "c", {"a"}, Period1202IsRefused)
    /\ Holds("A15-22", "c", {"b"}, Period1202IsWeekly)
    /\ Holds("A15-23", "c", {"a"}, LowErrorObRunsAtOnce)
    /\ Holds("A15-23", "c", {"b"}, LowErrorObAwaitsItsTurn)
    /\ Holds("A15-24", "c", {"b", "c"}, CodesAreOpen)

ReadingsInv == /\ SettingsInv /\ ClockInv /\ DispatchInv /\ BlocksInv
               /\ ModernInv

(* LooseLogs takes one answer of SFC 41 and one of SFC 42 at each count.   *)
OneAnswerInv ==
    \A c \in {delay} \cup 0..40 : /\ Cardinality(DisAirtAnswers(c)) = 1
                                 /\ Cardinality(EnAirtAnswers(c)) = 1
=============================================================================

------------------------------- MODULE Readings -------------------------------
(***************************************************************************)
(* The questions that the sources leave open: the letters of the answers   *)
(* and the default, in one table; the letter of the CPU at hand; and a     *)
(* name for each possible answer, a predicate that says how the CPU at     *)
(* hand reads it. Only Profiles knows letters, too.                        *)
(* docs/rules/readings.md has the questions with their sources.            *)
(*                                                                         *)
(* A question with two answers has one predicate; its negation is the      *)
(* other answer. A question with more answers has several predicates; if   *)
(* none holds, the answer is the remaining one, often "either".            *)
(* Left out: questions that no formula tells apart have no names.          *)
(***************************************************************************)
EXTENDS State, Profiles, Families

-----------------------------------------------------------------------------
(* The questions *)

AB   == {"a", "b"}
ABC  == {"a", "b", "c"}
ABCD == {"a", "b", "c", "d"}
AToF == ABCD \cup {"e", "f"}

(* A row for each question: its default letter, which holds where neither  *)
(* a header nor a model names another, and the letters of its answers,     *)
(* which a header may name.                                                *)
\* @type: Set(<<Str, Str, Set(Str)>>);
Questions ==
  { <<"AMB-01", "c", ABC>>,
    <<"AMB-02", "b", AB>>,
    <<"AMB-03", "a", ABCD>>,
    <<"AMB-04", "a", ABC>>,
    <<"AMB-05", "a", ABC>>,
    <<"AMB-06", "a", ABC>>,
    <<"AMB-07", "a", AB>>,
    <<"AMB-08", "a", AB>>,
    <<"AMB-09", "a", AB>>,
    <<"AMB-10", "a", AB>>,
    <<"AMB-11", "d", ABCD>>,
    <<"AMB-12", "a", AB>>,
    <<"AMB-13", "d", ABCD>>,
    <<"AMB-14", "a", ABC>>,
    <<"AMB-15", "a", ABC>>,
    <<"AMB-16", "a", AB>>,
    <<"AMB-17", "a", AB>>,
    <<"AMB-18", "d", ABCD>>,
    <<"AMB-19", "a", ABC>>,
    <<"AMB-20", "a", AB>>,
    <<"AMB-21", "a", AB>>,
    <<"AMB-22", "a", AB>>,
    <<"AMB-23", "a", AB>>,
    <<"AMB-24", "a", AB>>,
    <<"AMB-25", "a", AB>>,
    <<"AMB-26", "a", AB>>,
    <<"AMB-27", "b", AB>>,
    <<"AMB-28", "c", ABC>>,
    <<"AMB-29", "a", AB>>,
    <<"AMB-30", "a", AB>>,
    <<"AMB-31", "b", AB>>,
    <<"AMB-32", "a", AB>>,
    <<"AMB-33", "a", AB>>,
    <<"AMB-34", "c", ABC>>,
    <<"AMB-35", "a", AB>>,
    <<"AMB-36", "a", AB>>,
    <<"AMB-37", "a", AB>>,
    <<"AMB-38", "a", ABC>>,
    <<"AMB-39", "a", ABC>>,
    <<"AMB-40", "a", AB>>,
    <<"AMB-41", "a", AB>>,
    <<"AMB-42", "a", AB>>,
    <<"AMB-43", "a", AB>>,
    <<"AMB-44", "b", AB>>,
    <<"AMB-45", "c", ABC>>,
    <<"AMB-46", "a", AB>>,
    <<"AMB-47", "c", ABC>>,
    <<"AMB-48", "c", ABC>>,
    <<"AMB-49", "c", ABC>>,
    <<"AMB-50", "c", ABC>>,
    <<"AMB-51", "a", AB>>,
    <<"AMB-52", "c", ABC>>,
    <<"AMB-53", "c", ABC>>,
    <<"AMB-54", "c", ABC>>,
    <<"AMB-55", "c", ABC>>,
    <<"AMB-56", "c", ABCD>>,
    <<"AMB-57", "c", ABC>>,
    <<"AMB-58", "a", AB>>,
    <<"AMB-59", "a", AB>>,
    <<"AMB-60", "c", ABC>>,
    <<"AMB-61", "c", ABC>>,
    <<"AMB-62", "a", AB>>,
    <<"AMB-63", "b", AB>>,
    <<"AMB-64", "a", AB>>,
    <<"AMB-65", "a", AB>>,
    <<"AMB-66", "a", AB>>,
    <<"AMB-67", "c", ABC>>,
    <<"AMB-68", "c", ABC>>,
    <<"AMB-69", "c", ABC>>,
    <<"AMB-70", "c", ABC>>,
    <<"AMB-71", "d", ABCD>>,
    <<"AMB-72", "a", AB>>,
    <<"AMB-73", "a", AB>>,
    <<"AMB-74", "a", AB>>,
    <<"AMB-75", "a", AB>>,
    <<"AMB-76", "a", AB>>,
    <<"AMB-77", "d", ABCD>>,
    <<"AMB-78", "a", AB>>,
    <<"AMB-79", "c", ABC>>,
    <<"AMB-80", "a", AB>>,
    <<"AMB-81", "a", AB>>,
    <<"AMB-82", "a", AB>>,
    <<"AMB-83", "c", ABC>>,
    <<"AMB-84", "d", ABCD>>,
    <<"AMB-85", "c", ABC>>,
    <<"AMB-86", "a", ABCD>>,
    <<"AMB-87", "c", ABC>>,
    <<"AMB-88", "c", ABC>>,
    <<"A15-01", "a", ABC>>,
    <<"A15-02", "f", AToF>>,
    <<"A15-03", "c", ABC>>,
    <<"A15-04", "a", ABC>>,
    <<"A15-05", "c", ABC>>,
    <<"A15-06", "c", ABC>>,
    <<"A15-07", "a", ABC>>,
    <<"A15-08", "d", ABCD>>,
    <<"A15-09", "c", ABC>>,
    <<"A15-10", "c", ABC>>,
    <<"A15-11", "c", ABC>>,
    <<"A15-12", "c", ABC>>,
    <<"A15-13", "c", ABC>>,
    <<"A15-14", "a", AB>>,
    <<"A15-15", "c", ABC>>,
    <<"A15-16", "a", ABC>>,
    <<"A15-17", "b", ABC>>,
    <<"A15-18", "c", ABC>>,
    <<"A15-19", "d", ABCD>>,
    <<"A15-20", "f", AToF>>,
    <<"A15-21", "f", AToF>>,
    <<"A15-22", "c", ABC>>,
    <<"A15-23", "c", ABC>>,
    <<"A15-24", "c", ABC>> }

(* No formula asks these; docs/rules/readings.md says why. *)
\* @type: Set(Str);
NotAsked == {"AMB-24", "AMB-30", "AMB-64", "AMB-78"}

\* @type: Str => <<Str, Str, Set(Str)>>;
RowOf(a) == CHOOSE q \in Questions : q[1] = a

\* @type: Set(Str);
Ambiguities == { q[1] : q \in Questions } \ NotAsked

\* @type: Str -> Str;
Defaults == [a \in Ambiguities |-> RowOf(a)[2]]

(* The letters that formulas tell apart. *)
\* @type: Str => Set(Str);
Letters(a) == IF a \in Ambiguities THEN RowOf(a)[3] ELSE {RowOf(a)[2]}

-----------------------------------------------------------------------------
(* Looking a letter up *)

(* The letter by which a CPU reads a question, and that of this CPU. *)
\* @type: ($cpu, Str) => Str;
ReadingOf(c, a) == IF a \in DOMAIN c.readings THEN c.readings[a]
                                              ELSE Defaults[a]
\* @type: Str => Str;
Reading(a) == ReadingOf(cpu, a)

(* (a) nothing of the set, (b) all of it, or any part. *)
\* @type: (Str, Set(Int)) => Set(Set(Int));
PartBy(letter, whole) ==
    { part \in SUBSET whole : CASE letter = "a" -> part = {}
                               [] letter = "b" -> part = whole
                               [] OTHER        -> TRUE }

(* The CPU c with a letter of its own. *)
\* @type: (Str, Str, $cpu) => $cpu;
ReadAs(a, letter, c) ==
    [ c EXCEPT !.readings = [ x \in DOMAIN c.readings \cup {a} |->
                                IF x = a THEN letter ELSE c.readings[x] ] ]

(* The CPUs that c may turn out to be, if its letter is the open one. *)
\* @type: ($cpu, Str, Str, Set(Str)) => Set($cpu);
Turned(c, a, open, letters) ==
    IF ReadingOf(c, a) # open THEN {c}
    ELSE { ReadAs(a, letter, c) : letter \in letters }

-----------------------------------------------------------------------------
(* The answers by name *)

(* [AMB-01] One of the PERIODs 1201 and 1202 is weekly, or both are. *)
OnlyPeriod1201IsWeekly == Reading("AMB-01") = "a"
OnlyPeriod1202IsWeekly == Reading("AMB-01") = "b"
BothPeriodsAreWeekly   == Reading("AMB-01") = "c"

(* [AMB-02] SET_TINT answers 80A1 for any PERIOD, not for one-shot         *)
(* interrupts alone.                                                       *)
EveryPastStartIsRefused == Reading("AMB-02") = "a"
(* [AMB-03] STATUS bit 0 is 1 for a deselected OB; or it is 0 in STARTUP,  *)
(* too.                                                                    *)
Bit0ShowsDeselection == Reading("AMB-03") \in {"b", "c"}
Bit0IsZeroInStartup  == Reading("AMB-03") = "d"
(* [AMB-04] STATUS bit 5 is 1 where no test function blocks the OB. *)
Bit5MeansNoTest == Reading("AMB-04") = "b"
(* [AMB-05] Monthly on day 31: refused; or on the last day of any month.   *)
MonthlyEndsWithDay28   == Reading("AMB-05") = "a"
MonthlyFallsOnLastDay  == Reading("AMB-05") = "c"

(* [AMB-06] A missing OB is noticed by the call that activates or starts;  *)
(* "delay": by SRT_DINT alone.  Or it leads to OB 80 in place of OB 85.    *)
MissingNoticedAtActivation == Reading("AMB-06") = "b"
MissingNoticedAtSrtDint    == Reading("AMB-06") \in {"b", "delay"}
MissingIsTimeError         == Reading("AMB-06") = "c"

(* [AMB-07] A time-delay OB without OB 80 or OB 85 does not stop the CPU. *)
DelaysNeverStopTheCpu == Reading("AMB-07") = "b"
(* [AMB-08] A one-shot interrupt that has run is no longer set; else its   *)
(* date stays.                                                             *)
OnceIsUnsetByItsRun == Reading("AMB-08") = "a"
(* [AMB-09] CAN_TINT answers 80A0 unless the interrupt is active. *)
CanTintNeedsActive == Reading("AMB-09") = "b"
(* [AMB-10] ACT_TINT on an active interrupt computes its next point anew. *)
ActTintComputesAnew == Reading("AMB-10") = "b"

(* [AMB-11] A call that cancels an interrupt withdraws its waiting run.    *)
(* For a delay this may be open: a CPU shows one way and keeps to it.      *)
TodCallsWithdrawRuns  == Reading("AMB-11") # "a"
\* @type: $cpu => Bool;
DintCallsWithdrawRuns(c) == ReadingOf(c, "AMB-11") = "b"
CpusByDintCalls == Turned(cpu, "AMB-11", "d", {"b", "c"})
(* [AMB-12] A one-shot interrupt or a delay is over when its start event   *)
(* is lost.                                                                *)
LostEventEndsItsSource == Reading("AMB-12") = "a"
(* [AMB-13] When OB 80 has class 28. *)
Class28InStartup  == Reading("AMB-13") \in {"a", "d"}
Class28OnOverflow == Reading("AMB-13") \in {"b", "d"}
(* [AMB-14] Seconds of SDT are dropped before it is judged; or never. *)
SecondsAreDroppedFirst == Reading("AMB-14") = "a"
SecondsAreKept         == Reading("AMB-14") = "c"
(* [AMB-15] In OB 80 these calls keep a catch-up from coming, too. *)
ActTintStopsCatchUp == Reading("AMB-15") = "b"
DisIrtStopsCatchUp  == Reading("AMB-15") = "c"
(* [AMB-16] After a skip OB 80 gives the new time, not the first point. *)
SkipGivesNewTime == Reading("AMB-16") = "a"
(* [AMB-17] An S7-300 does not serve a point again either. *)
S7300RemembersServed == Reading("AMB-17") = "b"

(* [AMB-18] An OB that waits already gets another start event. *)
SecondRequestIsTimeError == Reading("AMB-18") = "a"
SecondRequestIsBuffered  == Reading("AMB-18") = "b"
SecondRequestIsMerged    == Reading("AMB-18") = "c"
BuffersMayOverflow       == Reading("AMB-18") \in {"b", "d"}
SecondRequestIsOpen      == Reading("AMB-18") = "d"
(* [AMB-19] Several points come during one run of the OB. *)
EveryPointRunsLater      == Reading("AMB-19") = "b"
OnlyFirstPointIsReported == Reading("AMB-19") = "c"

(* [AMB-20] A SET_TINT that is refused cancels the old setting. *)
RefusedSetTintCancels == Reading("AMB-20") = "b"
(* [AMB-21] SFC 39 blocks on three levels, all of which must be open. *)
BlocksHaveLevels == Reading("AMB-21") = "b"
(* [AMB-22] MODE 0 with an OB number other than 0 is refused. *)
Mode0TakesOb0Alone == Reading("AMB-22") = "b"
(* [AMB-23] An error without its OB stops the CPU also if it is blocked.   *)
BlockedErrorStopsTheCpu == Reading("AMB-23") = "b"
(* [AMB-25] The delay count outlives the end of OB 1. *)
CountOutlivesTheCycle == Reading("AMB-25") = "b"
(* [AMB-26] A hot restart keeps settings, jobs, blocks and requests. *)
HotRestartKeepsSettings == Reading("AMB-26") = "a"
(* [AMB-27] OB 80 names the OB that ran, not the requested OB. *)
TimeErrorNamesRunningOb == Reading("AMB-27") = "a"

(* [AMB-28] A missing OB is fault A1; or A1 and A2 are alike. *)
MissingObIsFaultA1     == Reading("AMB-28") = "a"
MissingObIsEitherFault == Reading("AMB-28") = "c"

(* [AMB-29] Points of one moment come in the order of their OBs' numbers. *)
PointsComeByNumber == Reading("AMB-29") = "b"
(* [AMB-31] DTIME in the start information is the time that has elapsed. *)
DtimeIsElapsedTime == Reading("AMB-31") = "a"
(* [AMB-32] PERIOD 2001 is executed once, at the first end of a month. *)
EndOfMonthIsOnce == Reading("AMB-32") = "b"
(* [AMB-33] OB 85 blocked stops the CPU. *)
BlockedOb85StopsTheCpu == Reading("AMB-33") = "b"

(* [AMB-34] STATUS bit 2 of a one-shot interrupt that waits is 1; or 0;    *)
(* else either.                                                            *)
WaitingOnceIsActive   == Reading("AMB-34") = "a"
WaitingOnceIsInactive == Reading("AMB-34") = "b"

(* [AMB-35] The points that pass in STARTUP lead to one run for each OB. *)
StartupDefersOneRun == Reading("AMB-35") = "a"
(* [AMB-36] A periodic interrupt first runs one period after its start. *)
SeriesBeginsAPeriodLater == Reading("AMB-36") = "b"
(* [AMB-37] A point that equals the clock is past. *)
EqualIsPast == Reading("AMB-37") = "b"
(* [AMB-38] Yearly on February 29 is refused; or falls on a day beside it. *)
YearlyNotOnLeapDay     == Reading("AMB-38") = "b"
YearlyFallsOnDayBefore == Reading("AMB-38") = "before"
YearlyFallsOnDayAfter  == Reading("AMB-38") = "after"
\* @type: $cpu => Set($cpu);
CpusByLeapDay(c) == Turned(c, "AMB-38", "c", {"before", "after"})
(* [AMB-39] An end-of-month interrupt that starts on another day. *)
EndOfMonthRunsAtStart == Reading("AMB-39") = "b"
EndOfMonthTakesNoOtherDay == Reading("AMB-39") = "c"
(* [AMB-40] A clock that is set back calls every active OB of an S7-300. *)
SetBackCallsActiveObs == Reading("AMB-40") = "b"
(* [AMB-41] An entry 5380 for the call; else for each event that is lost. *)
DisIrtIsEntered     == Reading("AMB-41") = "a"
LostEventIsEntered  == Reading("AMB-41") = "b"
(* [AMB-42] EN_IRT with MODE 1 blocks. *)
EnIrtMode1Blocks == Reading("AMB-42") = "b"
(* [AMB-43] PERIOD 0401 is daily. *)
Period0401IsDaily == Reading("AMB-43") = "b"
(* [AMB-44] A missing OB is noticed when due, though it could not start.   *)
MissingNoticedWhenDue == Reading("AMB-44") = "a"
(* [AMB-45] One OB 85 for all missing OBs; or one for each. *)
OneOb85ForAll  == Reading("AMB-45") = "a"
OneOb85ForEach == Reading("AMB-45") = "b"
(* [AMB-46] After a missing OB its interrupt is no longer active. *)
MissingObEndsItsSource == Reading("AMB-46") = "b"
(* [AMB-47] A delay that is over while its OB runs: a second run; or none. *)
OverlappingDelayRuns == Reading("AMB-47") = "a"
OverlappingDelayRunsNot == Reading("AMB-47") = "b"

(* [AMB-48] The run that a blocked OB 80 would report comes; or it is lost. *)
LateRunOutlivesBlock == Reading("AMB-48") = "a"
LateRunIsLostWithOb80 == Reading("AMB-48") = "b"

(* [AMB-49] DIS_AIRT does not delay a STOP by rule; or it does; else it may. *)
StopIsNotDelayed   == Reading("AMB-49") = "a"
StopAwaitsTheDelay == Reading("AMB-49") = "b"

(* [AMB-50] The blocked OBs whose skipped point OB 80 does not report. *)
\* @type: Set(Int) => Set(Set(Int));
UnreportedAmong(blocked) == PartBy(Reading("AMB-50"), blocked)

(* [AMB-51] The skip of a missing OB is not reported. *)
SkipOfMissingObIsSilent == Reading("AMB-51") = "b"

(* [AMB-52] The OBs that wait or run and get no catch-up of their own. *)
\* @type: Set(Int) => Set(Set(Int));
MergedAmong(busy) == PartBy(Reading("AMB-52"), busy)

(* [AMB-53] A skip in STARTUP or HOLD may be deferred; or reported at once. *)
SkipMayBeDeferred == Reading("AMB-53") # "b"
SkipMayBeReported == Reading("AMB-53") # "a"

(* [AMB-54] Catch-ups come by their first point; or by number; or together. *)
CatchUpsComeByPoint  == Reading("AMB-54") = "a"
CatchUpsComeByNumber == Reading("AMB-54") = "b"
CatchUpsComeTogether == Reading("AMB-54") = "c"

(* [AMB-55] After HOLD there is no catch-up; or it is open. *)
NoCatchUpAfterHold     == Reading("AMB-55") = "b"
CatchUpAfterHoldIsOpen == Reading("AMB-55") = "c"

(* [AMB-56] In repeated time unserved points are over: all of them; or     *)
(* those up to the last call of the OB.                                    *)
\* @type: $cpu => Bool;
UnservedAreOver(c) == ReadingOf(c, "AMB-56") = "b"
\* @type: $cpu => Bool;
UnservedAreOverToLastCall(c) == ReadingOf(c, "AMB-56") = "d"

(* [AMB-57] A new setting forgets the points that earlier settings served. *)
\* @type: $cpu => Bool;
NewSettingForgets(c) == ReadingOf(c, "AMB-57") = "a"

(* [AMB-56] [AMB-57] [A15-17] An open reading shows one way, and the CPU   *)
(* keeps to it.                                                            *)
CpusByMemory ==
    UNION { UNION { Turned(d, "A15-17", "c", {"a", "b"})
                    : d \in Turned(c, "AMB-57", "c", {"a", "b"}) }
            : c \in Turned(cpu, "AMB-56", "c", {"a", "b", "d"}) }

(* [AMB-58] A clock set forward skips points that were served already. *)
ServedPointsAreSkipped == Reading("AMB-58") = "b"
(* [AMB-59] A clock that is set back withdraws time-of-day runs that wait. *)
SetBackWithdrawsRuns == Reading("AMB-59") = "b"
(* [AMB-60] ACT_TINT on an active one-shot interrupt whose call waits or   *)
(* runs: 0000; or 80A1.                                                    *)
CalledOnceIsAhead == Reading("AMB-60") = "a"
CalledOnceIsPast  == Reading("AMB-60") = "b"

(* [AMB-61] A call for a deselected OB is refused; or judged as any other. *)
DeselectedIsRefused  == Reading("AMB-61") = "a"
DeselectedIsOrdinary == Reading("AMB-61") = "b"

(* [AMB-62] The date that STEP 7 gives an interrupt with execution "none". *)
NoneHasItsDate == Reading("AMB-62") = "b"
(* [AMB-63] Of several errors the first is answered. *)
FirstErrorIsAnswered == Reading("AMB-63") = "a"
(* [AMB-65] An S7-300 has the cold restart. *)
S7300RestartsCold == Reading("AMB-65") = "a"
(* [AMB-66] An OB that is deleted takes the requests for it along. *)
DeletedObTakesRequests == Reading("AMB-66") = "b"

(* [AMB-67] Outside events in STARTUP or HOLD are lost; or may be.         *)
OutsideRunEventsAreLost == Reading("AMB-67") = "b"
OutsideRunEventsAreOpen == Reading("AMB-67") = "c"

(* [AMB-68] A series without a further point is active; or it is not. *)
EndedSeriesIsActive   == Reading("AMB-68") = "a"
EndedSeriesIsInactive == Reading("AMB-68") = "b"

(* [AMB-69] Nothing stands before the start of an OB that may start; or    *)
(* each delay begins its wait anew.                                        *)
NothingStandsBefore  == Reading("AMB-69") = "b"
DelayBeginsWaitsAnew == Reading("AMB-69") = "a"
(* [AMB-70] Calls in the last millisecond of a delay.                      *)
CallsComeBeforeTheEnd == Reading("AMB-70") = "a"
CallsComeAfterTheEnd  == Reading("AMB-70") = "b"

(* [AMB-71] A one-shot interrupt is used up at its point, or when its OB   *)
(* starts or ends.                                                         *)
OnceUsedUpAtItsPoint  == Reading("AMB-71") = "b"
OnceMayEndAtItsStart  == Reading("AMB-71") # "c"
OnceMayEndAtItsEnd    == Reading("AMB-71") \in {"c", "d"}

(* [AMB-72] DIS_IRT drops a request that waits already. *)
DisIrtDropsRequests == Reading("AMB-72") = "b"
(* [AMB-73] DIS_IRT and EN_IRT refuse the OBs that the CPU lacks. *)
LackingObsAreRefused == Reading("AMB-73") = "b"
(* [AMB-74] SRT_DINT on a running job leaves its SIGN. *)
RestartedJobKeepsSign == Reading("AMB-74") = "b"
(* [AMB-75] OB 70, 72, 84 and 87 are not missed; else OB 85 reports them. *)
ErrorObsAreNotReported == Reading("AMB-75") = "a"
(* [AMB-76] EN_IRT takes the MODEs 80 to 82. *)
EnIrtTakesMode8x == Reading("AMB-76") = "b"

(* [AMB-77] An event from outside comes while its OB runs. *)
ExternalAgainIsTimeError == Reading("AMB-77") = "a"
ExternalAgainIsBuffered  == Reading("AMB-77") = "b"
ExternalAgainIsLost      == Reading("AMB-77") = "c"
(* [AMB-79] Seconds that no date has are dropped like any; or refused. *)
OddSecondsMayPass     == Reading("AMB-79") # "b" /\ ~SecondsAreKept
OddSecondsMayBeWrong  == Reading("AMB-79") # "a" \/ SecondsAreKept
(* [AMB-80] The reference of the clock may be local time, which STATUS bit *)
(* 6 shows. A CPU keeps to one reference.                                  *)
ReferenceIsBaseTime  == Reading("AMB-80") \in {"a", "base"}
ReferenceIsLocalTime == Reading("AMB-80") = "local"
\* @type: $cpu => Set($cpu);
CpusByReference(c) == Turned(c, "AMB-80", "b", {"base", "local"})
(* [AMB-81] A call may answer a general error code. *)
CallsMayFail == Reading("AMB-81") = "b"
(* [AMB-82] STATUS bit 3 is either. *)
Bit3IsOpen == Reading("AMB-82") = "b"
(* [AMB-85] In an error OB the other error calls its OB; or it stops the   *)
(* CPU.                                                                    *)
OtherErrorObIsCalled == Reading("AMB-85") # "b"
OtherErrorStops      == Reading("AMB-85") # "a"
(* [AMB-83] A point that passed in HOLD before the clock was set back is   *)
(* no longer one; or OB 80 reports it all the same; or either.             *)
SetBackForgetsHeld == Reading("AMB-83") = "a"
SetBackKeepsHeld   == Reading("AMB-83") = "b"

(* [AMB-84] An error in HOLD whose OB is missing: STOP at once, STOP after *)
(* the release, it is lost; or AMB-67 is asked and STOP may come at once.  *)
HeldErrorStopsAtOnce == Reading("AMB-84") = "a"
HeldErrorStopsLater  == Reading("AMB-84") = "b"
HeldErrorIsLost      == Reading("AMB-84") = "c"

(* [AMB-86] STEP 7 sets a monthly interrupt on day 29 to 31: months        *)
(* without the day may be left out, unless AMB-05 (c) leaves none out; may *)
(* have a point on their last day; or there may be no point.               *)
Step7MayLeaveMonthsOut == Reading("AMB-86") \in {"a", "d"}
Step7MayTakeLastDay    == Reading("AMB-86") \in {"b", "d"}
Step7MayNeverRun       == Reading("AMB-86") \in {"c", "d"}
(* [AMB-87] A missing OB 85 stops the CPU when its event comes, or when it *)
(* would be called; else either.                                           *)
MissingOb85StopsAtOnce == Reading("AMB-87") = "a"
MissingOb85StopsInTurn == Reading("AMB-87") = "b"
(* [AMB-88] An error from STARTUP that runs in RUN has the class of        *)
(* STARTUP; or that of RUN; else either.                                   *)
ErrorKeepsItsClass  == Reading("AMB-88") = "a"
ErrorTakesClassOfRun == Reading("AMB-88") = "b"
-----------------------------------------------------------------------------
(* The answers about an S7-1500                                            *)

(* [A15-01] SDT of SET_TINT is local time; or the base is that which STEP  *)
(* 7 gives the OB.                                                         *)
SetTintTakesLocal    == Reading("A15-01") = "b"
SetTintTakesItsBase  == Reading("A15-01") = "c"
(* [A15-02] Monthly from day 29 on is taken; or refused by some code.      *)
(* Yearly on February 29 is taken; or refused.                             *)
LateDaysAreTaken     == Reading("A15-02") = "b"
LateDaysHaveSomeCode == Reading("A15-02") = "c"
LeapDayIsTaken       == Reading("A15-02") = "d"
LeapDayIsRefused     == Reading("A15-02") = "e"
(* [A15-03] An overflow of the queue is an entry alone; or it calls OB 80. *)
OverflowIsEnteredAlone == Reading("A15-03") = "a"
OverflowCallsOb80      == Reading("A15-03") = "b"
(* [A15-04] Under DIS_AIRT the delays of an S7-1500 stand still. A CPU     *)
(* keeps to it.                                                            *)
DelaysStandStill == Reading("A15-04") = "b"
\* @type: $cpu => Set($cpu);
CpusByDelays(c) == Turned(c, "A15-04", "c", {"a", "b"})
(* [A15-05] Hardware interrupts have class 16; or 18. A CPU keeps to it.   *)
\* @type: $cpu => $cpu;
WithItsHardware(c) ==
    IF ReadingOf(c, "A15-05") # "b" THEN c
    ELSE [ c EXCEPT !.priority =
             [ o \in DOMAIN c.priority \cup (40..47)
                        \cup { p \in DOMAIN c.classes : c.classes[p] = 40 } |->
                 IF o \in DOMAIN c.priority THEN c.priority[o] ELSE 18 ] ]
\* @type: $cpu => Set($cpu);
CpusByHardware(c) ==
    IF ~FamilyOf(c.family).byKind THEN {c}
    ELSE { WithItsHardware(d) : d \in Turned(c, "A15-05", "c", {"a", "b"}) }
(* [A15-06] 3507 is entered once until the queue is empty.                 *)
OverflowIsEnteredOnce == Reading("A15-06") = "a"
(* [A15-07] The event that runs takes a place of its queue; or it does not. *)
RunningEventCounts    == Reading("A15-07") = "b"
RunningEventCountsNot == Reading("A15-07") = "a"
(* [A15-08] After OB 80 with 05 or 06 each skipped OB is caught up; or the *)
(* first alone; or the first of each class; else the first and any others. *)
EachSkippedObIsCaughtUp    == Reading("A15-08") = "a"
OnlyFirstSkippedIsCaughtUp == Reading("A15-08") = "b"
FirstOfEachClassIsCaughtUp == Reading("A15-08") = "c"
(* [A15-09] Whether a jump of the clock by so many ms is a small one.      *)
\* @type: Int => Set(Bool);
SmallJumps(ms) ==
    LET limit == FamilyOf(cpu.family).jump
    IN  IF ms # limit THEN {ms < limit}
        ELSE CASE Reading("A15-09") = "a" -> {FALSE}
               [] Reading("A15-09") = "b" -> {TRUE}
               [] OTHER                   -> {FALSE, TRUE}
(* [A15-10] Whether no OB 80 reports what daylight saving skips.           *)
\* @type: Set(Bool);
DaylightIsQuiet == CASE Reading("A15-10") = "a" -> {TRUE}
                     [] Reading("A15-10") = "b" -> {FALSE}
                     [] OTHER                   -> {FALSE, TRUE}
(* [A15-11] After a large jump without OB 80 the catch-ups come; or not.   *)
CatchUpNeedsNoOb80 == Reading("A15-11") = "a"
CatchUpNeedsOb80   == Reading("A15-11") = "b"
(* [A15-12] Points of STEP 7 that passed in STOP are nothing; or OB 80     *)
(* reports them.                                                           *)
StopPointsAreNothing  == Reading("A15-12") = "a"
StopPointsAreReported == Reading("A15-12") = "b"
(* [A15-13] A call for an OB that is missing answers 8090; or it does not. *)
MissingIsRefused    == Reading("A15-13") = "a"
MissingIsNotRefused == Reading("A15-13") = "b"
(* [A15-14] The parameters of the queue are not those of a migrated        *)
(* program, and not known.                                                 *)
QueueIsUnknown == Reading("A15-14") = "b"
(* [A15-15] OB 80 reports an overload once; or each event of it.           *)
OverloadIsReportedOnce  == Reading("A15-15") = "a"
OverloadIsReportedAgain == Reading("A15-15") = "b"
(* [A15-16] CaughtUp tells a clock that was set forward, nothing else.     *)
CaughtUpIsOfTheClock == Reading("A15-16") = "a"
(* [A15-17] In time that a small jump repeats, the points up to the last   *)
(* one that was served are over.                                           *)
\* @type: $cpu => Bool;
SmallJumpEndsUnserved(c) == ReadingOf(c, "A15-17") = "a"
(* [A15-18] SecondTime is told of the first repeated run alone; or of each. *)
FirstAloneIsSecondTime == Reading("A15-18") = "a"
EachIsSecondTime       == Reading("A15-18") = "b"
(* [A15-19] An end-of-month interrupt that a call sets: the date does not  *)
(* count; or the first end of a month from SDT on; or 8091.                *)
CallTakesTimeAlone == Reading("A15-19") = "a"
CallTakesTheDate   == Reading("A15-19") = "b"
CallRefusesOtherDays == Reading("A15-19") = "c"
(* [A15-20] SET_TINTL refuses a local time that daylight saving skips; or  *)
(* takes it. One that is doubled is the first one; or the second.          *)
SkippedTimeIsRefused  == Reading("A15-20") = "a"
SkippedTimeIsTaken    == Reading("A15-20") = "b"
DoubledTimeIsTheFirst == Reading("A15-20") = "d"
DoubledTimeIsTheLast  == Reading("A15-20") = "e"
(* [A15-21] A class of SFC 39 and 40 has the OBs from 123 on; or it has    *)
(* not. DIS_IRT takes the MODEs 80 to 82; or it refuses them.              *)
NumberedHaveAClass  == Reading("A15-21") = "a"
NumberedHaveNoClass == Reading("A15-21") = "b"
Mode8xIsKnown   == Reading("A15-21") = "d"
Mode8xIsUnknown == Reading("A15-21") = "e"
(* [A15-22] PERIOD 1202 is refused; or it is weekly.                       *)
Period1202IsRefused == Reading("A15-22") = "a"
Period1202IsWeekly  == Reading("A15-22") = "b"
(* [A15-23] An OB 121 or 122 that is not above the OB at fault runs at     *)
(* once; or waits for its turn.                                            *)
LowErrorObRunsAtOnce    == Reading("A15-23") = "a"
LowErrorObAwaitsItsTurn == Reading("A15-23") = "b"
(* [A15-24] The codes and STATUS bits of calls without a text are open.    *)
CodesAreOpen == Reading("A15-24") # "a"
=============================================================================

------------------------------ MODULE MCEffects -----------------------------
(***************************************************************************)
(* What the letters of open questions change: an answer, a setting, a      *)
(* point, a start event (docs/rules/readings.md).  The models of           *)
(* behaviours read most questions by default.  Here a CPU reads one        *)
(* otherwise, and each rule is asked by itself.                            *)
(*                                                                         *)
(* The CPU is in STOP at 06:00:30.  Nothing is loaded, set or blocked, and *)
(* nothing waits.  STEP 7 deselects OB 17, class 0 deselects OB 57.        *)
(***************************************************************************)
EXTENDS MCBase

(* The answer holds under these letters of the question; `usual' is the    *)
(* letter where none is named.                                             *)
\* @type: (Str, Str, Set(Str), Bool) => Bool;
Holds(question, usual, letters, answer) ==
    LET letter == IF question \in DOMAIN cpu.readings
                  THEN cpu.readings[question] ELSE usual
    IN  question \in Ambiguities /\ (answer <=> letter \in letters)

(* The minute of 06:00 on this day. *)
\* @type: (Int, Int, Int) => Int;
SixOn(y, m, d) == DayNumber(y, m, d) * MinutesADay + 360

\* @type: (Int, Int, Int) => $date;
DateOn(y, m, d) == [Date(0) EXCEPT !.year = y, !.month = m, !.day = d]

-----------------------------------------------------------------------------
(* Calls *)

(* [AMB-63] [AMB-61] Several errors, and calls for a deselected OB. *)
AnswersAgree ==
    /\ Usual({}) = {OK}
    /\ Usual({BadSdt}) = {BadSdt}
    /\ Holds("AMB-63", "b", {"a"}, Usual({BadOb, BadSdt, BadPeriod}) = {BadOb})
    /\ Holds("AMB-63", "b", {"b"}, Usual({BadOb, BadSdt}) = {BadOb, BadSdt})
    /\ \A o \in {10, 20, 99} : Answers(o, {}) = {OK}
    /\ Holds("AMB-61", "c", {"a", "c"}, BadOb \in Answers(17, {}))
    /\ Holds("AMB-61", "c", {"b", "c"}, OK \in Answers(17, {}))
    /\ Answers(57, {BadSdt}) = {BadSdt}

(* [TINT-33] [TINT-18] [TINT-35] SFC 28: PERIOD and SDT ... *)
OperandsAgree ==
    /\ {Once, Minutely, Hourly, Daily, Monthly, Yearly, EndOfMonth}
         \subseteq ValidPeriods
    /\ \hFFFF \notin ValidPeriods
    /\ Holds("AMB-01", "c", {"a", "c"}, \h1201 \in ValidPeriods)
    /\ Holds("AMB-01", "c", {"b", "c"}, \h1202 \in ValidPeriods)
    /\ \A p \in PeriodCodes : ValidSdt(DateOn(2027, 2, 28), p)
    /\ \A d \in 29..31 :
         Holds("AMB-05", "a", {"b", "c"},
               ValidSdt(DateOn(2026, 12, d), Monthly))
    /\ ValidSdt(DateOn(2028, 2, 29), Daily)
    /\ Holds("AMB-38", "a", {"b"}, ~ValidSdt(DateOn(2028, 2, 29), Yearly))
    /\ Holds("AMB-39", "a", {"c"}, ~ValidSdt(DateOn(2026, 12, 30), EndOfMonth))

(* [TINT-36] [TINT-37] ... and whether the start is past. *)
PastAgrees ==
    LET late == [Date(0) EXCEPT !.second = 40]
        odd  == [Date(1) EXCEPT !.second = 75]
        new  == SetAnew(NoSetting, late, FALSE, Hourly)
    IN  /\ StartIsPast(Date(0), 0, Once)
        /\ ~StartIsPast(Date(1), 0, Once)
        /\ Holds("AMB-14", "a", {"a"}, StartIsPast(late, 0, Once))
        /\ Holds("AMB-02", "b", {"a"}, StartIsPast(Date(0), 0, Minutely))
        /\ Holds("AMB-37", "a", {"b"}, IsPast(clock, clock))
        /\ SetAnswers(10, Date(1), 0, Once) = {OK}
        /\ IF SecondsAreKept THEN SetAnswers(10, odd, 0, Once) = {BadSdt}
           ELSE /\ Holds("AMB-79", "c", {"a", "c"},
                         OK \in SetAnswers(10, odd, 0, Once))
                /\ Holds("AMB-79", "c", {"b", "c"},
                         BadSdt \in SetAnswers(10, odd, 0, Once))
        /\ Holds("AMB-14", "a", {"c"}, new.offset = 40000)
        /\ Holds("AMB-14", "a", {"a", "b"}, new.offset = 0)
        /\ new.set /\ ~new.active /\ new.start = Six /\ new.period = Hourly
        /\ CanAnswers(10) = {NotSet} /\ CanAnswers(20) = {BadOb}
        /\ ActAnswers(10) = {NotSet} /\ ActAnswers(20) = {BadOb}

(* [TINT-61] [TINT-74] SFC 30 of a one-shot interrupt whose call waits or  *)
(* runs; STATUS.                                                           *)
StatusAgrees ==
    /\ Holds("AMB-60", "c", {"a", "c"}, OK \in ActAnswersWhenCalled(10))
    /\ Holds("AMB-60", "c", {"b", "c"}, PastStart \in ActAnswersWhenCalled(10))
    /\ Holds("AMB-68", "c", {"a", "c"}, 4 \in BitOfEndedSeries)
    /\ Holds("AMB-68", "c", {"b", "c"}, 0 \in BitOfEndedSeries)
    /\ Holds("AMB-04", "a", {"b"}, 36 \in StatusWithBit2(10, {4}))
    /\ Holds("AMB-82", "a", {"b"}, 12 \in StatusWithBit2(10, {4}))
    /\ Holds("AMB-80", "a", {"b", "local"}, 68 \in StatusWithBit2(10, {4}))
    /\ Holds("AMB-80", "a", {"local"}, 4 \notin StatusWithBit2(10, {4}))
         \/ Bit5MeansNoTest
    /\ StatusWithBit2(20, {0}) \subseteq {0, 8, 32}
    /\ \E s \in StatusWithBit2(17, {0}) : s % 2 = 1
    /\ Holds("AMB-03", "a", {"a", "d"},
             \E s \in StatusWithBit2(17, {0}) : s % 2 = 0)

(* [IRT-12] [IRT-13] SFC 39 and 40. *)
BlockingAgrees ==
    /\ NumberFits(0, 0)
    /\ Holds("AMB-22", "a", {"a"}, NumberFits(0, 10))
    /\ \A o \in {60, 70, 72} : Holds("AMB-73", "a", {"a"}, NumberFits(2, o))
    /\ NumberFits(2, 35) /\ NumberFits(1, 30)
    /\ IF cpu.family = "S7-300"
       THEN Holds("AMB-73", "a", {"a"}, NumberFits(2, 34))
       ELSE NumberFits(2, 34)
    /\ Holds("AMB-21", "a", {"a"}, Meant(1, 20) = 20..23)
    /\ Holds("AMB-21", "a", {"b"}, Meant(1, 20) = {ClassMark(20)})
    /\ Holds("AMB-76", "a", {"b"}, {128, 129, 130} \subseteq EnModes)
    /\ Holds("AMB-42", "a", {"b"}, IrtAfterEnIrt(1, {20}).blocked # {})
    /\ IrtAfterEnIrt(2, {20}).blocked = {}
    /\ \A o \in {1, 10, 17, 20, 23, 30, 47, 61, 73, 80, 87, 88, 90, 100, 122} :
         IrtErrors(7, o, DisModes) = {BadMode}
    /\ IrtErrors(7, 24, DisModes) = {BadMode, BadOb}
    /\ Holds("AMB-41", "a", {"a"}, EntriesOfDisIrt(130) # {})
    /\ EntriesOfDisIrt(2) = {}

-----------------------------------------------------------------------------
(* Settings and their points *)

(* [TINT-25] [TINT-06] Execution of STEP 7. *)
ConfiguredAgrees ==
    /\ \A p \in PeriodTable :
         p[1] # "weekly" => PeriodOf(Activated(p[1], 0), NoPeriod) = p[2]
    /\ LET weekly == PeriodOf(Activated("weekly", 0), NoPeriod)
       IN  /\ Holds("AMB-01", "c", {"b"}, weekly = \h1202)
           /\ Holds("AMB-01", "c", {"a", "c"}, weekly = \h1201)
    /\ Configured(NotConfigured, NoPeriod) = NoSetting
    /\ Holds("AMB-62", "a", {"b"},
             Configured([NotConfigured EXCEPT !.start = Six], NoPeriod).set)
    /\ LET late == Activated("monthly", 8 * 1440)
       IN  /\ PeriodOf(late, NoPeriod) = NoPeriod
           /\ PeriodOf(late, MonthlyOrLast) = MonthlyOrLast

(* The first point, from minute m on, of a series that starts at 06:00. *)
\* @type: (Int, Int, Int) => Int;
From(start, period, m) ==
    PointFrom([NoSetting EXCEPT !.start = start, !.period = period], m)

(* [TINT-32] [TINT-33] *)
SeriesAgree ==
    LET leap == SixOn(2028, 2, 29)
        last == SixOn(2026, 11, 30)
        end  == SixOn(2026, 12, 31)
    IN  /\ From(Six, Once, 0) = Six /\ From(Six, Once, Six + 1) = Never
        /\ HasOnePoint(Once) /\ ~HasOnePoint(Daily)
        /\ Holds("AMB-36", "a", {"a"}, From(Six, Daily, 0) = Six)
        /\ Holds("AMB-36", "a", {"b"}, From(Six, Daily, Six) = Six + 1440)
        /\ Holds("AMB-43", "a", {"a"}, From(Six, Hourly, Six + 1) = Six + 60)
        /\ Holds("AMB-43", "a", {"b"}, From(Six, Hourly, Six + 1) = Six + 1440)
        /\ Holds("AMB-39", "a", {"b"}, From(Six, EndOfMonth, 0) = Six)
        /\ Holds("AMB-36", "a", {"b"}, From(last, EndOfMonth, 0) # last)
             \/ EndOfMonthRunsAtStart
        /\ From(Six, EndOfMonth, Six + 1) = last
        /\ Holds("AMB-32", "a", {"a"}, From(Six, EndOfMonth, last + 1) = end)
        /\ Holds("AMB-32", "a", {"b"}, From(Six, EndOfMonth, last + 1) = Never)
        /\ Holds("AMB-05", "a", {"c"}, From(end, Monthly, SixOn(2027, 2, 1))
                                         = SixOn(2027, 2, 28))
        /\ Holds("AMB-05", "a", {"a", "b"},
                 From(end, Monthly, SixOn(2027, 2, 1)) = SixOn(2027, 3, 31))
        /\ Holds("AMB-38", "a", {"before"}, From(leap, Yearly, leap + 1)
                                              = SixOn(2029, 2, 28))
        /\ Holds("AMB-38", "a", {"after"}, From(leap, Yearly, leap + 1)
                                             = SixOn(2029, 3, 1))
        /\ From(leap, Yearly, SixOn(2029, 3, 2)) \in
             { SixOn(2030, 2, 28), SixOn(2030, 3, 1), SixOn(2032, 2, 29) }
        /\ "AMB-38" \in DOMAIN cpu.readings /\ cpu.readings["AMB-38"] = "c" =>
             { c.readings["AMB-38"] : c \in CpusByLeapDay(cpu) }
               = {"before", "after"}

(* [TINT-08] A one-shot interrupt that is used up. *)
OnceAgrees ==
    LET once == [ NoSetting EXCEPT !.set = TRUE, !.active = TRUE,
                                   !.start = Six, !.next = Six ]
        over == UsedUp(once)
        past == AfterPoint(10, once)
        back == CalledOnce(once)
    IN  /\ ~over.active /\ over.next = Never
        /\ Holds("AMB-08", "a", {"a"}, ~over.set)
        /\ Holds("AMB-71", "d", {"b"}, ~past.active)
        /\ past.active => past = once
        /\ AfterPoint(10, [once EXCEPT !.period = Hourly]).active
        /\ Holds("AMB-71", "d", {"b"}, ~back.active)
        /\ back.next = Never

-----------------------------------------------------------------------------
(* Start events *)

(* [OBS-10] [OBS-30] [OBS-31] Their data. *)
EventsAgree ==
    LET \* @type: Int => $request;
        late(o) == TimeError(StillRunning, {o}, o, 0)
        missing == ProgramError(TodRequest(10, At(Six), 0))
    IN  /\ DintRequest(20).since = clock /\ DintRequest(20).ob = 20
        /\ ExternalRequest(40, 0).since = clock
        /\ TodRequest(10, At(Six), 5).since = At(Six)
        /\ TodRequest(10, At(Six), 5).follows = 5
        /\ late(10).since = clock /\ late(10).cause = 10
        /\ missing.since = clock /\ missing.cause = 10
        /\ Holds("AMB-28", "c", {"a"}, missing.fault = \hA1)
        /\ Holds("AMB-28", "c", {"b", "c"}, missing.fault = \hA2)
        /\ late(10).class = 26
        /\ Holds("AMB-13", "d", {"b", "d"},
                 ErrorClass(80, BufferOverflow) = 28)
        /\ ErrorClass(82, 0) = ClassOf(82)
        /\ LET inStartup ==
                 { [NoRequest EXCEPT !.ob = o, !.class = 28, !.rank = o]
                   : o \in {80, 82} }
               \* @type: Set(Set(<<Int, Int>>));
               classes == { { <<r.ob, r.class>> : r \in q }
                            : q \in RequestsInRun(inStartup) }
               kept  == {<<80, 28>>, <<82, 28>>}
               taken == {<<80, 26>>, <<82, ClassOf(82)>>}
           IN  /\ Holds("AMB-88", "c", {"a"}, classes = {kept})
               /\ Holds("AMB-88", "c", {"b"}, classes = {taken})
               /\ Holds("AMB-88", "c", {"c"},
                        /\ kept \in classes /\ taken \in classes
                        /\ Cardinality(classes) = 4)
               /\ RequestsInRun({}) = {{}}

(* [OBS-22] [OBS-23] [IRT-01] Errors that stop the CPU. *)
StopsAgree ==
    /\ TimeErrorStops(TimeError(StillRunning, {10}, 10, 0))
    /\ Holds("AMB-07", "a", {"a"},
             TimeErrorStops(TimeError(StillRunning, {20}, 20, 0)))
    /\ BlockedOb85Stops <=> \/ Reading("AMB-33") = "b"
                            \/ Reading("AMB-23") = "b"
    /\ 81 \in ErrorObsNotMissed
    /\ \A o \in {70, 72, 84, 87} :
         /\ Holds("AMB-75", "a", {"a"}, o \in ErrorObsNotMissed)
         /\ Holds("AMB-75", "a", {"b"}, o \in ErrorObsAs85)
    /\ ErrorObsNotMissed \cup ErrorObsAs85 = {70, 72, 81, 84, 87}
    /\ {82, 83, 86} \subseteq ErrorObsThatStop
    /\ Holds("AMB-75", "a", {"a"}, 84 \in ErrorObsThatStop)

(* [CLK-03] [CLK-06] [OBS-46] Skips, their mask and their catch-ups. *)
SkipsAgree ==
    LET \* @type: Int => Set($request);
        after(fault) == CatchUps(fault, {10}, {})
        r == TodRequest(11, At(Six + 1), SkippedByClock)
        s == TodRequest(10, At(Six + 2), SkippedByClock)
        t == [ NoSetting EXCEPT !.period = Minutely, !.start = Six,
                                !.next = Six + 3, !.repeatTo = Six + 2 ]
    IN  /\ { <<c.ob, c.open>> : c \in after(SkippedByClock) } = {<<10, FALSE>>}
        /\ LateMask({10, 13}) = 2 ^ 0 + 2 ^ 3
        /\ \A o \in 10..17 : LateMask({o}) = 2 ^ (o - 10)
        /\ Holds("AMB-55", "c", {"b"}, after(SkippedInHold) = {})
        /\ Holds("AMB-55", "c", {"c"}, \E c \in after(SkippedInHold) : c.open)
        /\ \A c \in CatchUps(SkippedByClock, {10}, {10}) : c.follows = 0
        /\ Holds("AMB-54", "c", {"a"}, Precedes(r, s))
        /\ Holds("AMB-54", "c", {"b"}, Precedes(s, r))
        /\ Holds("AMB-58", "a", {"b"}, NextSkipped(t).min = Six + 1)
        /\ Holds("AMB-58", "a", {"a"}, NextSkipped(t).min = Six + 3)
        /\ Holds("AMB-16", "a", {"a"}, TimeOfSkip({10}, clock) = clock)
        /\ cpu.family = "S7-300" => Holds("AMB-17", "a", {"b"}, Remembers)
        /\ cpu.family # "S7-300" => Remembers

EffectsInv ==
    /\ AnswersAgree /\ OperandsAgree /\ PastAgrees /\ StatusAgrees
    /\ BlockingAgrees /\ ConfiguredAgrees /\ SeriesAgree /\ OnceAgrees
    /\ EventsAgree /\ StopsAgree /\ SkipsAgree
=============================================================================

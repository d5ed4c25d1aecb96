---------------------------- MODULE ReportedData ----------------------------
(***************************************************************************)
(* What the CPU tells of a start event: the start information of its OB,   *)
(* and entries of the diagnostic buffer.                                   *)
(*                                                                         *)
(* The start information of a line has to fit the request by which the OB  *)
(* starts. Each entry that a line shows needs a cause. If the log records  *)
(* entries, each cause leads to an entry within the latency.               *)
(*                                                                         *)
(* Source: requirements, table 7.2 (start information), table 7.5 (event   *)
(* ids); docs/checking/log-format.md, fine point 9.                        *)
(* Left out: bytes that table 7.2 leaves open; entries of other events.    *)
(* Table 7.5 has those of OB 80, OB 85, STOP by rule and SFC 39.           *)
(***************************************************************************)
EXTENDS Calendar, Requests, LogState

-----------------------------------------------------------------------------
(* Events of an OB *)

(* Table 7.5. Parameters decide which of the four hardware events leads to *)
(* which of OB 40 to 47.                                                   *)
\* @type: Int => Set(Int);
EventsByNumber(o) ==
    CASE o \in 10..17 -> {\h1111 + o - 10}
      [] o \in 20..23 -> {\h1121 + o - 20}
      [] o \in 30..38 -> {\h1131 + o - 30}
      [] o \in 40..47 -> \h1141..\h1144
      [] OTHER        -> {}
(* [T15-133] An OB from 123 on has event F of its class, a hardware        *)
(* interrupt of an S7-1500 always the first.                               *)
\* @type: Int => Set(Int);
EventsOf(o) == IF Family.byKind /\ Kin(o) \in 40..47 THEN {\h1141}
               ELSE IF o \in NumberedObs THEN {\h110F + (Kin(o) \div 10) * 16}
               ELSE EventsByNumber(o)
EventsOfInterrupts == UNION { EventsByNumber(o) : o \in 10..47 }
(* Events of the OBs whose interrupts calls set. Only the CPU makes the    *)
(* errors of these events: such an error does not come from outside.       *)
EventsOfCalls == UNION { EventsByNumber(o) : o \in 10..23 }

(* The table names no event for the other OBs. The events of interrupts    *)
(* are not theirs.                                                         *)
\* @type: (Int, Int) => Bool;
FitsEvent(given, o) ==
    given = -1 \/ IF EventsOf(o) = {} THEN given \notin EventsOfInterrupts
                                     ELSE given \in EventsOf(o)

(* [T15-133] The number of an OB in a byte.                                *)
\* @type: Int => Int;
InByte(o) == IF o > 254 THEN 255 ELSE o

(* [T15-133] The second byte of the event; of OB 57 it is told alone.      *)
\* @type: Int => Set(Int);
NumbersOf(o) == IF Family.byKind /\ o = 57 THEN {\h67}
                ELSE { ev % 256 : ev \in EventsOf(o) }
\* @type: (Int, Int) => Bool;
FitsNumber(given, o) == NumbersOf(o) # {} => given \in {-1} \cup NumbersOf(o)

-----------------------------------------------------------------------------
(* Fields of the start information *)

\* @type: (Int, Int) => Bool;
Fits(given, value) == given = -1 \/ value = -1 \/ given = value

\* @type: (Int, Int) => Bool;
FitsPeriod(given, period) ==
    \/ Fits(given, period)
    \/ BothPeriodsAreWeekly /\ given \in Weekly /\ period \in Weekly

(* The latest moment for which line e may stand: its `at' may be written   *)
(* in seconds or minutes.                                                  *)
\* @type: $event => $moment;
EndOfStep(e) == After(e.at, e.step - 1)

(* The clock shows `to' at most so many ms after `time'. *)
\* @type: ($moment, $moment, Int) => Bool;
Within(time, to, ms) == Before(time, to) => Span(time, to) <= ms

(* The same moment, as far as line e and the ones before it tell.          *)
\* @type: ($moment, $moment, $event) => Bool;
IsNear(a, b, e) == Within(a, b, e.step - 1) /\ Within(b, a, e.step - 1)

(* [OBS-10] A time within the latency before line e, by the clock as it is *)
(* or as it was before it was set.                                         *)
\* @type: ($moment, $event) => Bool;
JustBefore(time, e) ==
    \/ /\ ~Before(EndOfStep(e), time)
       /\ Within(time, clock, terms.latency + e.step - 1)
    \/ \E c \in changes :
         LET ago == Span(c.up, up)
         IN  /\ ago <= terms.latency
             /\ ~Before(c.from, time)
             /\ Within(time, c.from, terms.latency - ago)

(* [DINT-06] A delay may have ended 1 ms early, though no line of that     *)
(* millisecond shows it.                                                   *)
\* @type: $request => Bool;
MayBeEarlier(r) ==
    LET o == IF r.ob \in DintObs THEN r.ob ELSE r.cause
    IN  o \in DintObs /\ [ob |-> o, since |-> r.since] \notin terms.early

(* [CLK-07] [AMB-16] A catch-up shows the first skipped point, an OB 80    *)
(* for skipped points the new time. Any other start shows the moment of    *)
(* its start event or a later one [OBS-10]; if the clock was set back, it  *)
(* may show an earlier one. The moment of an unseen start event is not     *)
(* known.                                                                  *)
\* @type: ($request, $event) => Bool;
FitsTime(r, e) ==
    LET time  == e.info.time
        exact == IF r.ob \in TodObs THEN r.follows \in Skips
                                    ELSE r.fault \in Skips /\ r.late # {}
        shown == IF MayBeEarlier(r) THEN After(time, 1)
                 ELSE IF /\ r.ob = ProgramErrorOb /\ r.cause # 0
                         /\ r.class \in DOMAIN waiting
                 THEN After(time, waiting[r.class])  \* noticed meanwhile
                 ELSE time
    IN  \/ time = NoMoment \/ r.since = NoMoment
        \/ time = r.since
        \/ /\ ~exact \/ r.fault = SkippedInHold
           /\ IsNear(time, r.since, e)
           /\ ~Before(EndOfStep(e), time) \/ Before(clock, r.since)
        \/ r.follows \in LocalSkips  \* no text says by which local time
        \/ /\ ~exact
           /\ \/ ~Before(shown, r.since) /\ ~Before(EndOfStep(e), time)
              \/ /\ changes # {} \/ Before(clock, r.since)
                 /\ JustBefore(time, e)

(* [AMB-31] Under (a) the OB may have waited since the delay was over.     *)
\* @type: (Int, Int) => Bool;
FitsDtime(given, dtime) ==
    Fits(given, dtime) \/ (DtimeIsElapsedTime /\ given > dtime)

-----------------------------------------------------------------------------
(* Errors: OB 80 and OB 85 *)

(* [AMB-28] *)
\* @type: (Int, Int) => Bool;
FitsFault(fault, value) ==
    \/ Fits(value, fault)
    \/ fault \in ObNotLoaded /\ value \in ObNotLoaded /\ MissingObIsEitherFault

(* [AMB-27] The OB that caused the error.                                  *)
\* @type: ($request, $info) => Bool;
FitsCause(r, i) ==
    \/ /\ r.cause = 0
       /\ r.fault = CycleTimeExceeded => Fits(i.ev_ob, InByte(r.during))
       /\ r.fault \in FaultsOfStart => i.ev \notin EventsOfCalls
    \/ /\ r.cause # 0
       /\ FitsEvent(i.ev, r.cause)
       /\ Fits(i.ev_ob,
               InByte(IF r.ob = ProgramErrorOb \/ TimeErrorNamesRunningOb
                      THEN r.during ELSE r.cause))
       /\ IF r.cause \in TodObs THEN FitsPeriod(i.error_info, r.word)
          ELSE r.cause \in DintObs => Fits(i.error_info, r.word)

(* [CLK-06] At least one OB is late, even if the log does not tell which.  *)
(* [T15-92] The 20 bytes have bits for OB 10 to 17 alone.                  *)
\* @type: ($request, Int) => Bool;
FitsMask(r, given) ==
    \/ r.fault \in Skips
    \/ r.fault = SkippedByDaylight /\ r.late # {}
    => IF r.late # {} THEN Fits(given, LateMask(r.late))
       ELSE given \in {-1} \cup ((IF TodObs = OldTodObs THEN 1 ELSE 0)..255)

(* [T15-132] The OB that was being processed, and its priority. An error   *)
(* from outside, but of the cycle time, may name any OB: its line does not *)
(* tell which one ran. If the error is unseen, `during' is -1.             *)
\* @type: ($request, $info) => Bool;
FitsRunning(r, i) ==
    \/ /\ r.during = 0 /\ r.cause = 0 /\ r.late = {}
       /\ r.fault # CycleTimeExceeded
    \/ /\ Fits(i.csg_ob, r.during)
       /\ Fits(i.csg_priority, IF r.during > 0 THEN ClassOf(r.during)
                                ELSE r.during)

(* The fields that the start information and the entry of an error share. *)
\* @type: ($request, $info) => Bool;
FitsError(r, i) ==
    /\ Fits(i.priority, r.class)
    /\ FitsFault(r.fault, i.flt_id)
    /\ FitsFault(r.fault, i.strt_info)
    /\ FitsCause(r, i)
    /\ FitsMask(r, i.error_info)
    /\ FitsRunning(r, i)

-----------------------------------------------------------------------------

(* [T15-90] [T15-131] [A15-16] What CaughtUp may tell of a run: 1, true.   *)
\* @type: $request => Set(Int);
CaughtUps(r) ==
    CASE r.since = NoMoment -> {0, 1}
      [] r.follows \in {SkippedByClock} \cup LocalSkips -> {1}
      [] r.follows = SkippedInHold \/ ~CaughtUpIsOfTheClock -> {0, 1}
      [] OTHER -> {0}

(* The point of a run by local time came before daylight saving changed.   *)
\* @type: $request => Bool;
BeforeTheHour(r) == /\ tod[r.ob].local /\ cpu.hour.from > cpu.hour.to
                    /\ r.since.min <= cpu.hour.to - cpu.zone

(* It has waited for longer than the clock has gone on since its point: it *)
(* came before the clock was set back. For less, and it is no catch-up: it *)
(* came before the clock was set forward, and perhaps back as well.        *)
\* @type: $request => Bool;
BeforeTheStep(r) ==
    LET came   == AsItCame(r)
        waited == Span(arrivals[came], up)
        passed == Span(r.since, clock)
    IN  /\ came \in DOMAIN arrivals
        /\ \/ waited > passed + terms.latency
           \/ r.follows = 0 /\ passed > waited + terms.latency

(* [T15-94] [A15-18] What SecondTime may tell of a run: the first for a    *)
(* point that the OB serves again has it. No text says what a run has that *)
(* waited while the time was set back, or a catch-up of such a point.      *)
\* @type: $request => Set(Int);
SecondTimes(r) ==
    LET t     == tod[r.ob]
        point == r.since.min
        again == t.repeatTo < t.overTo /\ point <= t.overTo
        begins == ~\E i \in t.served \cup t.merged : i.from < point
    IN  IF \/ r.since = NoMoment \/ Before(clock, r.since)
           \/ BeforeTheStep(r) \/ BeforeTheHour(r) THEN {0, 1}
        ELSE IF 1 \in CaughtUps(r) /\ t.overTo >= 0 THEN {0, 1}
        ELSE IF ~again THEN {0}
        ELSE IF begins \/ EachIsSecondTime THEN {1}
        ELSE IF FirstAloneIsSecondTime THEN {0} ELSE {0, 1}

(* [T15-69] [T15-70] A run shows some or all events that were dropped.     *)
\* @type: ($request, $info) => Bool;
FitsDropped(r, i) == HasQueue(r.ob) /\ ~Unseen("interrupt")
                       => i.event_count <= terms.dropped[r.ob]

(* [T15-71] [T15-131] *)
\* @type: ($request, $info) => Bool;
FitsTags(r, i) ==
    IF r.ob \in TodObs
    THEN /\ i.caught_up # -1 => i.caught_up \in CaughtUps(r)
         /\ i.second_time # -1 => i.second_time \in SecondTimes(r)
         /\ i.event_count = -1
    ELSE /\ i.caught_up = -1 /\ i.second_time = -1
         /\ IF r.ob \in DintObs THEN i.event_count = -1
            ELSE FitsDropped(r, i)

(* [T15-135] An S7-1500 tells of a start by 20 bytes or by tags, and these *)
(* have no PERIOD, no DTIME and no time.                                   *)
\* @type: $info => Bool;
HasOneLayout(i) ==
    LET tags  == {i.caught_up, i.second_time, i.event_count, i.csg_ob,
                  i.csg_priority}
        bytes == {i.period, i.dtime, i.time.min}
    IN  Family.byKind => tags = {-1} \/ bytes = {-1}

(* [DINT-03] *)
\* @type: ($request, $info) => Bool;
FitsInterrupt(r, i) ==
    /\ FitsTags(r, i)
    /\ Fits(i.priority, r.class)
    /\ FitsNumber(i.strt_info, r.ob)
    /\ r.ob \in TodObs => FitsPeriod(i.period, r.word)
    /\ r.ob \in DintObs => Fits(i.sign, r.word) /\ FitsDtime(i.dtime, r.dtime)

\* @type: ($request, $event) => Bool;
FitsRequest(r, e) ==
    /\ IF r.ob \in {TimeErrorOb, ProgramErrorOb} THEN FitsError(r, e.info)
                                                 ELSE FitsInterrupt(r, e.info)
    /\ HasOneLayout(e.info)
    /\ FitsTime(r, e)

-----------------------------------------------------------------------------
(* Start events that no line shows *)

(* The fault in the start information of OB 80 or OB 85, or UnknownFault. *)
\* @type: $event => Int;
ToldFault(e) == IF e.info.flt_id # -1 THEN e.info.flt_id ELSE UnknownFault

(* The request of an unseen start event. Its unknown fields fit every      *)
(* line.                                                                   *)
\* @type: (Int, Int, Int) => $request;
UnseenRequest(o, fault, class) ==
    [ NoRequest EXCEPT !.ob = o, !.fault = fault, !.class = class, !.word = -1,
                       !.dtime = -1, !.during = -1, !.since = NoMoment ]

(* An error may have come in STARTUP. *)
\* @type: (Int, Int) => Set(Int);
ClassesOf(o, fault) ==
    IF o \in AsyncErrorObs THEN {ErrorClass(o, fault), 28} ELSE {ClassOf(o)}

-----------------------------------------------------------------------------
(* Entries of the diagnostic buffer *)

(* Entries that have to come, if the log has entries. *)
DemandedEntries == { ErrorEntry + f : f \in (1..11) \cup (\hA1..\hA3) }
                     \cup {EntriesDisabled, NoTimeErrorOb, NoProgramErrorOb}
(* Entries that need a cause: these, 454A, 4562 and 4563.                  *)
JudgedEntries == DemandedEntries \cup CausesOfRules

(* OB number 0 or 16#FF stands for no OB. No text says which OB the entry  *)
(* of an event names that a queue has dropped [T15-72].                    *)
\* @type: ($entry, Int) => Bool;
FitsOb(entry, o) ==
    \/ o \in {0, 255, entry.of.ob}
    \/ /\ Family.queues /\ entry.id = ErrorEntry + BufferOverflow
       /\ o = entry.of.cause

\* @type: ($entry, $event) => Bool;
FitsEntry(entry, e) ==
    /\ \/ e.id = entry.id
       \/ /\ e.id - ErrorEntry \in ObNotLoaded
          /\ FitsFault(entry.id - ErrorEntry, e.id - ErrorEntry)
    /\ \/ entry.of.ob = 0
       \/ /\ FitsOb(entry, e.ob)
          /\ Fits(e.priority, entry.of.class)
          /\ FitsError(entry.of, e.info)

(* An unseen event may have caused this entry. Only DIS_IRT causes the     *)
(* entry of disabled entries, if no lost event does [AMB-41]. Unseen       *)
(* starts and ends of OBs, and unseen loading, are steps with entries of   *)
(* their own (PartialLogs).                                                *)
\* @type: Int => Bool;
CauseUnseen(id) ==
    LET kinds == IF id = EntriesDisabled /\ ~LostEventIsEntered THEN {"call"}
                 ELSE Kinds \ {"ob", "load"}
    IN  ~(kinds \subseteq terms.records)

-----------------------------------------------------------------------------
(* Entries that the log has not shown yet *)

(* The fields of an entry that a line can show. If the log has no such     *)
(* lines, the active OB and the certainty of the entry do not matter.      *)
\* @type: $entry => $entry;
AsReported(entry) ==
    LET told == [ entry EXCEPT !.of.since = At(0), !.of.rank = 0,
                               !.of.open = FALSE ]
    IN  IF DiagRecorded THEN told
        ELSE [told EXCEPT !.open = FALSE, !.of.during = -1]

(* If the log has no such lines, three equal entries stand for any number. *)
Many == 3

\* @type: Int => Int;
OneMore(times) == IF DiagRecorded \/ times < Many THEN times + 1 ELSE Many
\* @type: Int => Int;
OneLess(times) == IF DiagRecorded \/ times < Many THEN times - 1 ELSE Many

(* [OBS-26] The cycle time was exceeded twice in a cycle: the CPU may stop, *)
(* and the STOP has one entry, which the log may show before or after it.  *)
ExceededTwice    == overruns = 2
EntryOfCycleTime == [id |-> NoTimeErrorOb, of |-> NoRequest, open |-> TRUE]

EntriesOfCycleTime ==
    IF ~ExceededTwice /\ ExceededTwice' THEN {EntryOfCycleTime} ELSE {}

(* [OBS-08] OB 85 does not wait for an error that its buffer has no room   *)
(* for; the error may have an entry of its own.                            *)
EntriesOfOverflow ==
    IF \A n \in entered' : \/ n.id # ErrorEntry + BufferOverflow
                           \/ n.of.cause # ProgramErrorOb
    THEN {}
    ELSE {[ id |-> ErrorEntry + \hA3, open |-> TRUE,
            of |-> ExternalRequest(ProgramErrorOb, \hA3) ]}

(* [AMB-49] The entry of a STOP that waits for the end of a delay comes    *)
(* with the STOP; not at all if the CPU is stopped before. [OBS-26] So     *)
(* does the entry of a STOP by the cycle time.                             *)
\* @type: $report => Bool;
WaitsWithStop(r) ==
    \/ r.entry.id = stopCause /\ ~StopIsDue
    \/ /\ r.entry = AsReported(EntryOfCycleTime)
       /\ ExceededTwice /\ mode # "STOP"

\* @type: $report => $report;
AfterStop(r) == IF WaitsWithStop(r) THEN [r EXCEPT !.entry.open = TRUE] ELSE r

(* Behind a clock that is set back the moments of entries that may come at *)
(* any time later tell nothing.                                            *)
Unreported ==
    CASE DiagRecorded /\ mode # "STOP" /\ mode' = "STOP" ->
           { AfterStop(r) : r \in reports }
      [] ~DiagRecorded /\ reports # {} /\ Before(clock', clock) ->
           { [r EXCEPT !.since = NoMoment] : r \in reports }
      [] OTHER -> reports

(* The moment that an entry of this step shows; its cause was `age' ms     *)
(* ago. Of entries that may come at any time later it is kept to the full  *)
(* second.                                                                 *)
\* @type: ($entry, Int) => $moment;
MomentOf(n, age) ==
    LET of == IF n.of.ob = 0 THEN clock' ELSE n.of.since
        m  == IF of = NoMoment THEN of ELSE After(of, -age)
    IN  IF DiagRecorded THEN m ELSE [m EXCEPT !.ms = @ - (@ % 1000)]

\* @type: Set($moment) => $moment;
Earliest(moments) ==
    CHOOSE m \in moments : \A n \in moments : ~Before(n, m)

(* The entries of this step have to be shown; their cause was `age' ms     *)
(* ago. Entries that an unseen event may have caused are not kept.         *)
\* @type: Int => Bool;
Report(age) ==
    LET shown == { m \in entered' \cup EntriesOfCycleTime
                                 \cup EntriesOfOverflow :
                     m.id \in JudgedEntries /\ ~CauseUnseen(m.id) }
        new == { AsReported(n) : n \in shown }
        a   == IF DiagRecorded THEN age ELSE 0
        same(n) == { r \in Unreported : r.entry = n /\ r.age = a }
        times(n) == IF same(n) = {} THEN 1
                    ELSE OneMore((CHOOSE r \in same(n) : TRUE).times)
        since(n) == Earliest({ r.since : r \in same(n) }
                               \cup { MomentOf(m, age)
                                      : m \in { k \in shown :
                                                  AsReported(k) = n } })
    IN  reports' = IF new = {} THEN Unreported
                   ELSE (Unreported \ UNION { same(n) : n \in new })
                          \cup { [ entry |-> n, age |-> a, times |-> times(n),
                                   since |-> since(n) ] : n \in new }

(* The entries that would be too late in d ms. *)
\* @type: Int => Set($report);
EntriesLate(d) ==
    IF reports = {} \/ ~DiagRecorded THEN {}
    ELSE { r \in reports : /\ ~r.entry.open /\ ~WaitsWithStop(r)
                           /\ r.entry.id \in DemandedEntries
                           /\ r.age + d > terms.latency }

(* [T15-72] The entry of an overflow may come with the end of the OB.      *)
\* @type: $report => Bool;
MayComeLate(r) == /\ r.entry.id = ErrorEntry + BufferOverflow
                  /\ r.entry.open /\ HasQueue(r.entry.of.cause)

(* The entries grow older. An entry that need not come is forgotten after  *)
(* the latency.                                                            *)
\* @type: Int => Set($report);
ReportsAfter(d) ==
    IF reports = {} \/ ~DiagRecorded THEN reports
    ELSE { IF WaitsWithStop(r) THEN r ELSE [r EXCEPT !.age = @ + d]
           : r \in { q \in reports : \/ q.age + d <= terms.latency
                                    \/ WaitsWithStop(q) \/ MayComeLate(q) } }

-----------------------------------------------------------------------------

(* [OBS-10] An entry shows the moment of its cause or a later one; of a    *)
(* skip, by the new time [CLK-06].                                         *)
\* @type: ($report, $event) => Bool;
FitsMoment(r, e) ==
    LET time  == e.info.time
        early == MayBeEarlier([r.entry.of EXCEPT !.since = r.since])
        shown == IF early THEN After(time, 1) ELSE time
    IN  \/ time = NoMoment \/ r.since = NoMoment \/ Unseen("clock")
        \/ IsNear(time, r.since, e)
        \/ ~Before(shown, r.since) /\ ~Before(EndOfStep(e), time)
        \/ /\ r.entry.of.fault \notin Skips
           /\ changes # {} \/ Before(clock, r.since)
           /\ JustBefore(time, e)

(* A line shows the oldest entry that no line has shown yet. An entry that *)
(* need not come may be passed over.                                       *)
\* @type: $event => Bool;
IsEntry(e) ==
    LET fits == { r \in reports : FitsEntry(r.entry, e) /\ FitsMoment(r, e) }
    IN  /\ UNCHANGED cpuVars
        /\ NothingEntered
        /\ IF e.id \notin JudgedEntries THEN UNCHANGED reports
           ELSE \E r \in { q \in fits : \A p \in fits :
                                        p.age <= q.age \/ p.entry.open } :
                  reports' = (reports \ {r}) \cup
                               IF OneLess(r.times) = 0 THEN {}
                               ELSE {[r EXCEPT !.times = OneLess(@)]}
=============================================================================

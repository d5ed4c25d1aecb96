------------------------------ MODULE StartInfo -------------------------------
(***************************************************************************)
(* The start information of an OB: does the information of a line fit the  *)
(* request by which the OB starts?                                         *)
(*                                                                         *)
(* Source: requirements, table 7.2 (start information), table 7.5 (event   *)
(* ids).                                                                   *)
(* Left out: the bytes that table 7.2 leaves open.                         *)
(***************************************************************************)
EXTENDS Calendar, Requests, LogState

-----------------------------------------------------------------------------
(* Events of an OB *)

(* Table 7.5. Parameters decide which of the four hardware events leads to *)
(* which of OB 40 to 47.                                                   *)
\* @type: Int => Set(Int);
EventsOf(o) == CASE o \in 10..17 -> {\h1111 + o - 10}
                 [] o \in 20..23 -> {\h1121 + o - 20}
                 [] o \in 30..38 -> {\h1131 + o - 30}
                 [] o \in 40..47 -> \h1141..\h1144
                 [] OTHER        -> {}
EventsOfInterrupts == UNION { EventsOf(o) : o \in 10..47 }
(* Events of the OBs that calls start. The CPU itself makes the errors of  *)
(* these events: such an error does not come from outside.                 *)
EventsOfCalls == UNION { EventsOf(o) : o \in 10..23 }

(* The table names no event for the other OBs: none of these events is     *)
(* theirs.                                                                 *)
\* @type: (Int, Int) => Bool;
FitsEvent(given, o) ==
    given = -1 \/ IF EventsOf(o) = {} THEN given \notin EventsOfInterrupts
                                     ELSE given \in EventsOf(o)

\* @type: (Int, Int) => Bool;
FitsNumber(given, o) ==
    EventsOf(o) # {} => given \in {-1} \cup { ev % 256 : ev \in EventsOf(o) }

-----------------------------------------------------------------------------
(* Fields of the start information *)

\* @type: (Int, Int) => Bool;
Fits(given, value) == given = -1 \/ value = -1 \/ given = value

(* [CLK-06] Bit k stands for OB 10 + k. *)
\* @type: Set(Int) => Int;
LateMask(obs) ==
    LET b(o, v) == IF o \in obs THEN v ELSE 0
    IN  b(10, 1) + b(11, 2) + b(12, 4) + b(13, 8) + b(14, 16) + b(15, 32)
          + b(16, 64) + b(17, 128)

\* @type: (Int, Int) => Bool;
FitsPeriod(given, period) ==
    \/ Fits(given, period)
    \/ BothPeriodsAreWeekly /\ given \in Weekly /\ period \in Weekly

(* The latest moment for which line e may stand: its `at' may be written   *)
(* in seconds or minutes.                                                  *)
\* @type: $event => $moment;
Latest(e) == After(clock, e.step - 1)

(* The clock shows `to' at most so many ms after `time'. *)
\* @type: ($moment, $moment, Int) => Bool;
Within(time, to, ms) == Before(time, to) => Span(time, to) <= ms

(* [OBS-10] A time within the latency before line e, by the clock as it is *)
(* or as it was before it was set.                                         *)
\* @type: ($moment, $event) => Bool;
JustBefore(time, e) ==
    \/ ~Before(Latest(e), time) /\ Within(time, clock, terms.latency)
    \/ \E c \in changes :
         LET ago == Span(c.up, up)
         IN  /\ ago <= terms.latency
             /\ ~Before(c.from, time)
             /\ Within(time, c.from, terms.latency - ago)

(* [DINT-06] The end of a delay may have been 1 ms early, though no line   *)
(* of that millisecond made it so.                                         *)
\* @type: $request => Bool;
MayBeEarlier(r) ==
    LET o == IF r.ob \in DintObs THEN r.ob ELSE r.cause
    IN  o \in DintObs /\ [ob |-> o, since |-> r.since] \notin terms.early

(* [CLK-07] [AMB-16] A catch-up shows the first skipped point, an OB 80    *)
(* for skipped points the new time. Another start shows the moment of its  *)
(* start event or a later one [OBS-10]. A clock that was set back may be   *)
(* before that moment. The moment of an unseen start event is not known.   *)
\* @type: ($request, $event) => Bool;
FitsTime(r, e) ==
    LET time  == e.info.time
        exact == IF r.ob \in TodObs THEN r.follows \in Skips
                                    ELSE r.fault \in Skips /\ r.late # {}
        shown == IF MayBeEarlier(r) THEN After(time, 1) ELSE time
    IN  \/ time = NoMoment \/ r.since = NoMoment
        \/ time = r.since
        \/ /\ ~exact
           /\ \/ ~Before(shown, r.since) /\ ~Before(Latest(e), time)
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
       /\ r.fault = CycleTimeExceeded => Fits(i.ev_ob, r.during)
       /\ r.fault \in FaultsOfStart => i.ev \notin EventsOfCalls
    \/ /\ r.cause # 0
       /\ FitsEvent(i.ev, r.cause)
       /\ Fits(i.ev_ob, IF r.ob = ProgramErrorOb \/ TimeErrorNamesRunningOb
                        THEN r.during ELSE r.cause)
       /\ IF r.cause \in TodObs THEN FitsPeriod(i.error_info, r.word)
          ELSE r.cause \in DintObs => Fits(i.error_info, r.word)

(* [CLK-06] At least one OB is late, even if the log does not tell which. *)
\* @type: ($request, Int) => Bool;
FitsMask(r, given) ==
    r.fault \in Skips => IF r.late # {} THEN Fits(given, LateMask(r.late))
                                        ELSE given \in {-1} \cup (1..255)

(* The fields that the start information and the entry of an error share. *)
\* @type: ($request, $info) => Bool;
FitsError(r, i) ==
    /\ Fits(i.priority, r.class)
    /\ FitsFault(r.fault, i.flt_id)
    /\ FitsFault(r.fault, i.strt_info)
    /\ FitsCause(r, i)
    /\ FitsMask(r, i.error_info)

-----------------------------------------------------------------------------

(* [DINT-03] *)
\* @type: ($request, $info) => Bool;
FitsInterrupt(r, i) ==
    /\ Fits(i.priority, r.class)
    /\ FitsNumber(i.strt_info, r.ob)
    /\ r.ob \in TodObs => FitsPeriod(i.period, r.word)
    /\ r.ob \in DintObs => Fits(i.sign, r.word) /\ FitsDtime(i.dtime, r.dtime)

\* @type: ($request, $event) => Bool;
FitsRequest(r, e) ==
    /\ IF r.ob \in {TimeErrorOb, ProgramErrorOb} THEN FitsError(r, e.info)
                                                 ELSE FitsInterrupt(r, e.info)
    /\ FitsTime(r, e)
=============================================================================

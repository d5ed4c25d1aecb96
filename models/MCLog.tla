-------------------------------- MODULE MCLog --------------------------------
(***************************************************************************)
(* The explanations of small logs: a header, then lines in any order, at   *)
(* few moments. Between two lines explanations may be merged or reduced to *)
(* definite facts: what they allowed before, they allow after it           *)
(* (Merging). An explanation meets one without a start event of its own,   *)
(* or with two of them in the other order.                                 *)
(*                                                                         *)
(* In one model the lines are written in seconds.                          *)
(*                                                                         *)
(* Left out: other explanations to meet; what a merge allows some lines    *)
(* later; logs that leave kinds out.                                       *)
(***************************************************************************)
EXTENDS PartialLogs, Merging

VARIABLES
    (* The line that time elapses to; NoEvent between two lines.           *)
    \* @type: $event;
    line,
    (* How many lines have been explained.                                 *)
    \* @type: Int;
    lines

Begun == DayNumber(2026, 11, 21) * MinutesADay + 360
\* @type: (Int, Int) => $moment;
AtMinute(m, ms) == [min |-> Begun + m, ms |-> ms]

\* @type: (Int, Str, Bool) => $obStep7;
Each(o, execution, deselected) ==
    [ ob |-> o, execution |-> execution, start |-> Begun, active |-> TRUE,
      deselected |-> deselected, local |-> FALSE ]
\* @type: (Str, Set($obStep7)) => $header;
Of(m, settings) ==
    [ NoHeader EXCEPT !.cpu = "S7-300", !.obs = {1, 10, 80, 85, 100},
                      !.clock = AtMinute(0, 30000), !.mode = m,
                      !.latency = 10, !.step7 = settings, !.records = Kinds ]

(* The points of a minute interrupt come; or the CPU must stop; or OB 40   *)
(* and OB 41 of one class are requested.                                   *)
Interrupted == [ Of("RUN", {}) EXCEPT !.cpu = "S7-400",
                                      !.priority = {<<41, 16>>},
                                      !.obs = {1, 40, 41, 80, 85, 100} ]
Headers == { Of("RUN", {Each(10, "minute", FALSE)}),
             Of("STARTUP", {Each(10, "minute", TRUE)}), Interrupted }

(* Lines at the beginning, and some minutes later.                         *)
Later == AtMinute(10, 30000)
\* @type: (Str, Int, Int) => $event;
Line(event, o, ret) ==
    [NoEvent EXCEPT !.event = event, !.ob = o, !.ret = ret]
Lines == { Line("DIS_AIRT", 0, 1), Line("EN_AIRT", 0, 0), Line("stop", 0, -1) }
           \cup IF cpu.step7[10].active
                THEN { Line(event, 0, -1) : event \in {"run", "done"} }
                       \cup { Line(event, o, -1) : event \in {"start", "end"},
                                                  o \in {10, 80, 100} }
                ELSE { Line(event, o, -1)
                       : event \in {"interrupt", "start"}, o \in {40, 41} }
                       \cup { Line("end", 40, -1) }
(* The unit of `at', in ms. *)
Unit == 1
\* @type: ($event, $moment) => $event;
ToBeAt(e, m) ==
    LET at == [m EXCEPT !.ms = @ - (@ % Unit)]
    IN  [ e EXCEPT !.at = at, !.step = Unit,
                   !.up = Shifted(At(0), AtMinute(0, 30000), at) ]
LinesAt(m) == { ToBeAt(e, m) : e \in Lines }

logVars == <<cpuVars, entered, terms, pace, up, waiting, eventVars, reports>>
LogVars == <<logVars, line, lines>>

LogInit == Init /\ line = NoEvent /\ lines = 0

(* How many lines have been explained when another one is taken, and       *)
(* afterwards. A merge stands for the lines that lack.                     *)
TakesAt == 0..2
AfterMerge == 4

Opens == /\ terms.records = {} /\ \E h \in Headers : Begin(h)
         /\ UNCHANGED <<line, lines>>
Between == terms.records # {} /\ line = NoEvent
Takes == /\ Between /\ ~terms.loose
         /\ lines \in TakesAt /\ UNCHANGED lines
         /\ line' \in LinesAt(clock) \cup LinesAt(Later)
         /\ UNCHANGED logVars
Elapses == /\ line # NoEvent /\ ~Arrived(line)
           /\ Towards(AtFirst(line)) /\ UNCHANGED <<line, lines>>
Hides == /\ line # NoEvent /\ Arrived(line)
         /\ HiddenBefore(line) \/ Lingers(line)
         /\ UNCHANGED <<line, lines>>
Explains == /\ line # NoEvent /\ Arrived(line)
            /\ Shows(line) /\ NextPace(line)
            /\ line' = NoEvent /\ lines' = lines + 1

(* Another explanation of the same lines: without r, or with r and s in    *)
(* each other's place.                                                     *)
\* @type: $request => $waits;
Without(r) ==
    LET left == Close(requests \ {r})
    IN  [ Waits EXCEPT
            !.requests = left,
            !.arrivals = [ q \in { AsItCame(t) : t \in left } |-> @[q] ],
            !.waiting  = [ c \in DOMAIN @ \ ({r.class, r.class + 100}
                                   \ { WaitsAs(q) : q \in left }) |-> @[c] ] ]
\* @type: ($request, $request) => $waits;
Exchanged(r, s) ==
    [ Waits EXCEPT !.requests = (@ \ {r, s}) \cup
                                  { [r EXCEPT !.rank = s.rank],
                                    [s EXCEPT !.rank = r.rank] } ]
FromOutside == IF cpu.step7[10].active THEN {}
               ELSE { r \in requests : Outside(r) }
Twins == { Without(r) : r \in FromOutside }
           \cup UNION { { Exchanged(r, s)
                          : s \in { q \in FromOutside :
                                     /\ q.class = r.class
                                     /\ q.rank = r.rank + 1 } }
                        : r \in FromOutside }

Merges == /\ Between /\ lines < AfterMerge /\ lines' = AfterMerge
          /\ UNCHANGED line
          /\ \/ Crowd
             \/ ~terms.loose /\ \E w \in Twins \ {Waits} : Meet({Waits, w})
             \/ LastResort

LogNext == Opens \/ Takes \/ Elapses \/ Hides \/ Explains \/ Merges
LogSpec == LogInit /\ [][LogNext]_LogVars

-----------------------------------------------------------------------------
(* In the places of the first two in a model that goes on after a merge:   *)
(* OB 41 and OB 81 are missing, and OB 85 is there; AMB-45 in two ways.    *)

\* @type: (Set(Int), Str) => $header;
Missing41(obs, letter) ==
    [ Interrupted EXCEPT !.obs = {1, 40, 85, 100} \cup obs,
                         !.readings = {<<"AMB-45", letter>>} ]
MissingHeaders == {Missing41({}, "b"), Missing41({80}, "c")}
MissingLines ==
    { Line("interrupt", o, -1) : o \in {41, 81} }
      \cup { [Line("DIS_IRT", o, 0) EXCEPT !.mode = 2] : o \in {80, 85} }
TwoAndTwo == {0, 1, 3, 4}
AfterTwo == 3

(* In their places in a model where OB 11 waits since 06:01, and at 06:02  *)
(* it is due again, which calls OB 80, and OB 10 of the same class is due. *)
OrderHeader ==
    [ Of("STARTUP", { Each(11, "minute", FALSE),
                      [Each(10, "daily", FALSE) EXCEPT !.start = Begun + 2] })
      EXCEPT !.cpu = "S7-1500", !.priority = {<<10, 22>>},
             !.obs = {1, 10, 11, 80, 100} ]
(* OB 10 waits, and OB 11 has the class of OB 80.                          *)
OtherNumbers ==
    [ OrderHeader EXCEPT
        !.priority = {<<11, 22>>},
        !.step7 = { Each(10, "minute", FALSE),
                    [Each(11, "daily", FALSE) EXCEPT !.start = Begun + 2] } ]
OrderHeaders == {OrderHeader, OtherNumbers}
OrderLines == { Line(event, 0, -1) : event \in {"run", "done"} }
TheTwoPoints == AtMinute(2, 0)
BehindThem == AtMinute(2, 5)
OneLine == {0}
TwoLines == 0..2
NoMerge == 0

(* In their places in a model of lines in seconds: the point of OB 10 and  *)
(* the end of a delay come in the second of the later lines. OB 10 shows   *)
(* when its point came, and OB 20 may start 10 ms later.                   *)
InSeconds == 1000
ThePoint == AtMinute(1, 0)
SecondsHeaders == { [ Of("RUN", {Each(10, "minute", FALSE)}) EXCEPT
                        !.obs = {1, 10, 20, 80, 85, 100} ] }
SecondsLines ==
    { [Line("SRT_DINT", 20, 0) EXCEPT !.dtime = 30500, !.sign = 0],
      Line("DIS_AIRT", 0, 1), Line("EN_AIRT", 0, 0), Line("done", 0, -1),
      [Line("start", 10, -1) EXCEPT !.info.time = ThePoint] }
      \cup { Line(event, o, -1) : event \in {"start", "end"}, o \in {10, 20} }

(* In their places in a model where OB 82 is missing, or OB 10.            *)
StopHeaders == { [Interrupted EXCEPT !.obs = {1, 80, 85, 100}],
                 [Of("RUN", {Each(10, "minute", FALSE)}) EXCEPT
                     !.obs = {1, 80, 100}] }
StopLines == { Line("DIS_AIRT", 0, 1), Line("EN_AIRT", 0, 0),
               Line("interrupt", 82, -1), Line("stop", 0, -1) }
SomeMsLater == AtMinute(1, 5)

-----------------------------------------------------------------------------

(* [OBS-25] A STOP that is due as the log begins is due from then on.      *)
BeginsDueProp ==
    [][ Opens /\ stopCause' # NoCause => StopDuty \in DOMAIN waiting' ]_LogVars

(* [AMB-69] (c) The STOP for an OB that is missing is due since this OB    *)
(* was: a delay that began meanwhile does not hold it back [AMB-49].       *)
DueSinceProp ==
    [][ line # NoEvent /\ line' = line
        /\ stopCause = NoCause /\ stopCause' # NoCause =>
          \A r \in requests \ requests' :
            WaitsAs(r) \in DOMAIN waiting /\ MayGoOnWaiting(r) =>
              /\ StopDuty \in DOMAIN waiting'
              /\ waiting'[StopDuty] >= waiting[WaitsAs(r)] ]_LogVars

(* [T15-30] Of the points of a moment, one calls OB 80: any other one of   *)
(* the class of OB 80 may have come before it, as their order decides      *)
(* which OB runs first.                                                    *)
EitherFirstProp ==
    [][ \A r \in requests' \ requests :
          r.ob = TimeErrorOb /\ r.fault = StillRunning =>
            \A o \in PointsNow \cap PointsNow' :
              ClassOf(o) = r.class =>
                ENABLED ((Elapses \/ Hides) /\ tod'[o] # tod[o]) ]_LogVars

(* A line stands for moments of its step alone: while it is explained, the *)
(* clock is in its step or before it.                                      *)
InStepInv == line # NoEvent /\ ~Before(clock, line.at)
                => Span(line.at, clock) < line.step

(* It stands for any of them: what a line of this very moment explains,    *)
(* explains it. Where nothing has to come, time elapses to the last one.   *)
AnyMomentInv ==
    line # NoEvent /\ ~Before(clock, line.at) =>
      /\ LET exact == [ line EXCEPT !.at = clock, !.step = 1,
                                    !.up = Shifted(@, line.at, clock) ]
         IN  Arrived(exact) /\ ENABLED Observe(exact) => ENABLED Observe(line)
      /\ LET last == line.step - 1 - Span(line.at, clock)
         IN  /\ last > 0 /\ requests = {} /\ stopCause = NoCause
             /\ Jobs = {} /\ PointsNow = {}
             => ENABLED (Hides /\ clock' = After(clock, last))

(* Every line of this moment that was allowed is allowed after a merge, as *)
(* is that time elapses. By definite facts alone a call may answer any     *)
(* count of delays; TLC takes seconds to say so. A line of a set is        *)
(* evaluated once; below ENABLED one of LET is evaluated at each use.      *)
MergingProp ==
    [][ Merges =>
          /\ \A e \in LinesAt(clock) :
               \/ terms'.loose /\ e.event \in CallEvents
               \/ ENABLED Observe(e) => (ENABLED Observe(e))'
          /\ \A e \in {ToBeAt(Line("stop", 0, -1), Later)} :
               ENABLED (Elapse(e) /\ up' # up) => (ENABLED Elapse(e))'
    ]_LogVars
=============================================================================

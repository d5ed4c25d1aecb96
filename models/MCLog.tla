-------------------------------- MODULE MCLog --------------------------------
(***************************************************************************)
(* The explanations of small logs: a header, then lines in any order, at   *)
(* few moments. Between two lines explanations may be merged: what they    *)
(* allowed before, they allow after it (Merging).                          *)
(*                                                                         *)
(* Left out: merging of several explanations; what a merge allows some     *)
(* lines later.                                                            *)
(***************************************************************************)
EXTENDS Trace, Merging

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
      deselected |-> deselected ]
\* @type: (Str, Set($obStep7)) => $header;
Of(m, settings) ==
    [ NoHeader EXCEPT !.cpu = "S7-300", !.obs = {1, 10, 80, 85, 100},
                      !.clock = AtMinute(0, 30000), !.mode = m,
                      !.latency = 10, !.step7 = settings, !.records = Kinds ]

(* The points of a minute interrupt come; or the CPU must stop.            *)
Headers == { Of("RUN", {Each(10, "minute", FALSE)}),
             Of("STARTUP", {Each(10, "minute", TRUE)}) }

(* Lines at the beginning, and some minutes later.                         *)
Later == AtMinute(10, 30000)
\* @type: (Str, Int, Int) => $event;
Line(event, o, ret) ==
    [NoEvent EXCEPT !.event = event, !.ob = o, !.ret = ret]
Lines == { Line("DIS_AIRT", 0, 1), Line("EN_AIRT", 0, 0), Line("stop", 0, -1),
           Line("run", 0, -1), Line("done", 0, -1) }
           \cup { Line(event, o, -1) : event \in {"start", "end"},
                                       o \in {10, 80, 100} }
LinesAt(m) == { [ e EXCEPT !.at = m, !.up = Shifted(At(0),
                                              AtMinute(0, 30000), m) ]
                : e \in Lines }

logVars == <<cpuVars, entered, terms, pace, up, waiting, eventVars, reports>>
LogVars == <<logVars, line, lines>>

LogInit == Init /\ line = NoEvent /\ lines = 0

Opens == /\ terms.records = {} /\ \E h \in Headers : Begin(h)
         /\ UNCHANGED <<line, lines>>
Between == terms.records # {} /\ line = NoEvent
Takes == /\ Between /\ lines < 3 /\ UNCHANGED lines
         /\ line' \in LinesAt(clock) \cup LinesAt(Later)
         /\ UNCHANGED logVars
Elapses == /\ line # NoEvent /\ ~Arrived(line)
           /\ Towards(line) /\ UNCHANGED <<line, lines>>
Hides == /\ line # NoEvent /\ Arrived(line)
         /\ HiddenBefore(line) /\ UNCHANGED <<line, lines>>
Explains == /\ line # NoEvent /\ Arrived(line)
            /\ Shows(line) /\ NextPace(line)
            /\ line' = NoEvent /\ lines' = lines + 1
Merges == Between /\ Crowd /\ UNCHANGED <<line, lines>>

LogNext == Opens \/ Takes \/ Elapses \/ Hides \/ Explains \/ Merges
LogSpec == LogInit /\ [][LogNext]_LogVars

-----------------------------------------------------------------------------

(* [OBS-25] A STOP that is due as the log begins is due from then on.      *)
BeginsDueProp ==
    [][ Opens /\ stopCause' # NoCause => StopDuty \in DOMAIN waiting' ]_LogVars

(* Every line of this moment that was allowed is allowed after a merge, as *)
(* is that time elapses.                                                   *)
MergingProp ==
    [][ Merges =>
          /\ \A e \in LinesAt(clock) : ENABLED Shows(e) => (ENABLED Shows(e))'
          /\ \A e \in LinesAt(Later) :
               ENABLED Towards(e) => (ENABLED Towards(e))' ]_LogVars
=============================================================================

------------------------------ MODULE LogState ------------------------------
(***************************************************************************)
(* The state of an explanation, beside the state of the CPU.               *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, header and fine points 1, 2 and 9. *)
(* Left out: nothing.                                                      *)
(***************************************************************************)
EXTENDS Cpu, LogEvents

VARIABLES
    (* latency: an OB starts at most so many ms after it may. cycle: the    *)
    (* log has every start and end of OB 1. records: the kinds of event     *)
    (* that the log has completely. loose: the log does not tell when an OB *)
    (* has to start (LooseLogs). After Widening: endless, open requests     *)
    (* that stand for any number; unsure, OBs for which some explanations   *)
    (* had a request and others had none. early: the delays that were over  *)
    (* 1 ms before their time, and the moments when they were.              *)
    \* @type: $terms;
    terms,
    (* The time elapsed since the log began, on a clock that nobody sets.   *)
    \* @type: $moment;
    up,
    (* For each priority class: the ms that an OB has waited that may       *)
    (* start. For StopDuty: the ms that a STOP has been due.                *)
    \* @type: Int -> Int;
    waiting,
    (* "warm" or "cold": the first OB 1 after this restart is still to      *)
    (* come.  "none": it has come.  "unknown": the log begins in RUN.       *)
    \* @type: Str;
    first,
    (* How often the cycle time was exceeded in this cycle, twice at most.  *)
    \* @type: Int;
    overruns,
    (* The moment at which each waiting request came, on the clock of `up'. *)
    \* @type: $request -> $moment;
    arrivals,
    (* The settings of the clock within the last `latency' ms: its reading  *)
    (* before, and the moment on the clock of `up'.                         *)
    \* @type: Set($change);
    changes,
    (* Both clocks at the last line that has `up'. Setting the CPU clock    *)
    (* moves this reading, too.                                             *)
    \* @type: $reading;
    pace,
    (* The entries of the diagnostic buffer that the log has not shown yet: *)
    (* the number of each, and, if the log has such lines, the ms since its *)
    (* cause.                                                               *)
    \* @type: Set($report);
    reports

(* Only lines change these variables, ...                                  *)
lineVars == <<terms, pace>>
(* ... and only events change these: they stay while time elapses. *)
eventVars == <<first, overruns, arrivals, changes>>

NoReading == [clock |-> NoMoment, up |-> NoMoment, step |-> 1]

(* A request without the fields that change while it waits.                *)
\* @type: $request => $request;
AsItCame(r) == [r EXCEPT !.rank = 0, !.open = FALSE]

-----------------------------------------------------------------------------
(* Kinds of event that the log has completely *)

(* All kinds that a header without `records' names. *)
Kinds == {"call", "ob", "clock", "mode", "interrupt", "load"}

(* Events of this kind may be missing in the log.                          *)
\* @type: Str => Bool;
Unseen(kind) == kind \notin terms.records

Partial == ~(Kinds \subseteq terms.records)
DiagRecorded == "diag" \in terms.records

(* [DINT-06] The early delays whose start events may still wait.           *)
EarlyDelays ==
    { d \in terms.early : \E r \in requests : r.since = d.since }
=============================================================================

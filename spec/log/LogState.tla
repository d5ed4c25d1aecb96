------------------------------ MODULE LogState ------------------------------
(***************************************************************************)
(* The records that stand for the lines of a log, and the state of an      *)
(* explanation, beside the state of the CPU.                               *)
(*                                                                         *)
(* A field that a line does not give has the value -1 or, as a moment,     *)
(* NoMoment.  The trace checker's engine fills the records from the log.   *)
(* `up' of an event is the time that has elapsed since the log began;      *)
(* `counter' is what the line itself gives as `up'. `step' is the unit in  *)
(* which `at' is written, in ms; `until', of a line in seconds or minutes, *)
(* the `at' of the first one behind it in its step that is written finer,  *)
(* if it has come already. 0 is false, 1 is true.                          *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, the fields of header and events;   *)
(* fine points 1, 2 and 9.                                                 *)
(* Left out: fields whose name begins with x_.                             *)
(***************************************************************************)
EXTENDS Cpu

-----------------------------------------------------------------------------
(* Lines *)

(***************************************************************************)
(* @typeAlias: terms = { latency: Int, cycle: Bool,                        *)
(*                       records: Set(Str), loose: Bool,                   *)
(*                       crowds: $request -> Int,                          *)
(*                       unsure: Set(Int),                                 *)
(*                       early: Set({ ob: Int, since: $moment }),          *)
(*                       dropped: Int -> Int };                            *)
(* @typeAlias: obStep7 = { ob: Int, execution: Str, start: Int,            *)
(*                         active: Bool, deselected: Bool, local: Bool };  *)
(* @typeAlias: header = { cpu: Str, obs: Set(Int), clock: $moment,         *)
(*                        mode: Str, latency: Int, zone: Int, cycle: Bool, *)
(*                        priority: Set(<<Int, Int>>),                     *)
(*                        classes: Set(<<Int, Int>>),                      *)
(*                        queue: Set({ ob: Int, events: Int,               *)
(*                                     threshold: Int, overflow: Int }),   *)
(*                        step7: Set($obStep7),                            *)
(*                        readings: Set(<<Str, Str>>), profile: Str,       *)
(*                        records: Set(Str) };                             *)
(* @typeAlias: allowed = { event: Str, ob: Int, field: Str, value: Int,    *)
(*                         time: $moment };                                *)
(* @typeAlias: info = { strt_info: Int, flt_id: Int, priority: Int,        *)
(*                      period: Int, sign: Int, dtime: Int,                *)
(*                      error_info: Int, ev: Int, ev_ob: Int,              *)
(*                      time: $moment, caught_up: Int, second_time: Int,   *)
(*                      event_count: Int, csg_ob: Int,                     *)
(*                      csg_priority: Int };                               *)
(* @typeAlias: event = { event: Str, at: $moment, step: Int,               *)
(*                       until: $moment, up: $moment,                      *)
(*                       counter: $moment, ob: Int, sdt: $date,            *)
(*                       period: Int, local: Int, activate: Int,           *)
(*                       zone: Int, reason: Str,                           *)
(*                       dtime: Int, sign: Int, mode: Int,                 *)
(*                       ret: Int, status: Int, to: $moment, type: Str,    *)
(*                       cause: Int, flt_id: Int, id: Int, priority: Int,  *)
(*                       info: $info, active: Int, blocked: Int,           *)
(*                       loaded: Int, entries_off: Int, left: Int };       *)
(* @typeAlias: pace = { clock: $moment, up: $moment, step: Int,            *)
(*                      reads: $moment };                                  *)
(* @typeAlias: change = { from: $moment, up: $moment };                    *)
(* @typeAlias: tag = { of: $request, nth: Int };                           *)
(* @typeAlias: waits = { requests: Set($request), waiting: Int -> Int,     *)
(*   arrivals: $request -> $moment, reports: Set($report),                 *)
(*   crowds: $request -> Int };                                            *)
(* @typeAlias: report = { entry: $entry, age: Int, times: Int,             *)
(*                        since: $moment };                                *)
(***************************************************************************)

\* @type: $moment;
NoMoment == [min |-> -1, ms |-> 0]

\* @type: $date;
NoDate == [ year |-> 0, month |-> 0, day |-> 0, hour |-> 0, minute |-> 0,
            second |-> 0, ms |-> 0 ]

\* @type: $info;
NoInfo == [ strt_info |-> -1, flt_id |-> -1, priority |-> -1, period |-> -1,
            sign |-> -1, dtime |-> -1, error_info |-> -1, ev |-> -1,
            ev_ob |-> -1, time |-> NoMoment, caught_up |-> -1,
            second_time |-> -1, event_count |-> -1, csg_ob |-> -1,
            csg_priority |-> -1 ]

\* @type: $event;
NoEvent == [ event |-> "", at |-> NoMoment, step |-> 1,
             until |-> NoMoment, up |-> NoMoment, counter |-> NoMoment,
             ob |-> 0, sdt |-> NoDate, period |-> -1,
             local |-> -1, activate |-> -1, zone |-> -9999, reason |-> "",
             dtime |-> -1, sign |-> -1,
             mode |-> -1, ret |-> -1,
             status |-> -1, to |-> NoMoment, type |-> "", cause |-> -1,
             flt_id |-> -1, id |-> -1, priority |-> -1, info |-> NoInfo,
             active |-> -1, blocked |-> -1, loaded |-> -1,
             entries_off |-> -1, left |-> -1 ]

(* The values that a field may have: the given value, or all that are      *)
(* possible.                                                               *)
\* @type: (Int, Set(Int)) => Set(Int);
Given(value, possible) == IF value = -1 THEN possible ELSE {value}

-----------------------------------------------------------------------------
(* The header *)

\* @type: $header;
NoHeader == [ cpu |-> "", obs |-> {}, clock |-> NoMoment, mode |-> "",
              latency |-> 0, zone |-> 0, cycle |-> FALSE,
              priority |-> {}, classes |-> {}, queue |-> {}, step7 |-> {},
              readings |-> {}, profile |-> "", records |-> {} ]

\* @type: $queue;
NoQueue == [size |-> 1, limit |-> 0, told |-> 0]

(* STEP 7 has set nothing.                                                 *)
NoParameters == [ execution |-> "none", start |-> 0, active |-> FALSE,
                  deselected |-> FALSE, local |-> FALSE ]

-----------------------------------------------------------------------------
(* The state of an explanation *)

VARIABLES
    (* latency: an OB starts at most so many ms after it may. cycle: the   *)
    (* log has every start and end of OB 1. records: the kinds of event    *)
    (* that the log has completely. loose: the log does not tell when an   *)
    (* OB has to start (LooseLogs). After Merging: crowds, the requests    *)
    (* that stand for several, each with their number, or with 0 for any   *)
    (* number; unsure, the OBs for which some explanations had a           *)
    (* request and others had none. early: the delays that were over 1 ms  *)
    (* before their time, each with the moment. dropped: of each OB with a *)
    (* queue, how many start events this queue has dropped that no run has *)
    (* shown.                                                              *)
    \* @type: $terms;
    terms,
    (* The time elapsed since the log began, on a clock that nobody sets.   *)
    \* @type: $moment;
    up,
    (* For each priority class: the ms that an OB has waited that may       *)
    (* start. For StopDuty: the ms that a STOP has been due.                *)
    \* @type: Int -> Int;
    waiting,
    (* "warm", "cold" or "hot": the first OB 1 after this restart is still  *)
    (* to come. "none": it has come, or an OB 1 has ended. "unknown": the   *)
    (* log begins in RUN.                                                   *)
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
    (* moves this reading, too. reads: what the clock read then, as elapsed *)
    (* by `up' since the last line that tells it to the ms.                 *)
    \* @type: $pace;
    pace,
    (* The entries of the diagnostic buffer that the log has not shown     *)
    (* yet, each with its number and the first moment that it may show; if *)
    (* the log has such lines, also with the ms since its cause.           *)
    \* @type: Set($report);
    reports

(* Only lines change these variables.                                      *)
lineVars == <<terms, pace>>
(* Only events change these; they stay while time elapses.                 *)
eventVars == <<first, overruns, arrivals, changes>>

NoPace == [ clock |-> NoMoment, up |-> NoMoment, step |-> 1,
            reads |-> [min |-> 0, ms |-> 0] ]

(* A request without the fields that change while it waits.                *)
\* @type: $request => $request;
AsItCame(r) == [ r EXCEPT !.rank = 0, !.open = FALSE,
                          !.late = IF r.ob = TimeErrorOb THEN @ ELSE {} ]

-----------------------------------------------------------------------------
(* Kinds of event that the log has completely *)

(* All kinds that a header without `records' names. *)
Kinds == {"call", "ob", "clock", "mode", "interrupt", "load"}

(* Events of this kind may be missing in the log.                          *)
\* @type: Str => Bool;
Unseen(kind) == kind \notin terms.records

Partial == ~(Kinds \subseteq terms.records)
DiagRecorded == "diag" \in terms.records

(* Only definite facts count (LooseLogs).                                    *)
Loose == terms.loose

(* [DINT-06] The early delays whose start events may still wait.           *)
EarlyDelays ==
    { d \in terms.early : \E r \in requests : r.since = d.since }
=============================================================================

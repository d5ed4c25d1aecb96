-------------------------------- MODULE State ---------------------------------
(***************************************************************************)
(* The state of an S7-300/400 CPU, with all that its interrupts depend on. *)
(*                                                                         *)
(* Left out: the step that was taken last (System); the explanation of a   *)
(* log (LogState).                                                         *)
(* Sources: requirements, section 5.1.                                     *)
(***************************************************************************)
VARIABLES
    (* The CPU at hand. family: its name in module Families; priority:      *)
    (* the classes that differ from the default [OBS-05]; step7: the STEP 7 *)
    (* parameters of the time-of-day interrupts; readings: the letters that *)
    (* differ from the default; classes: for each OB from 123 on the first  *)
    (* OB of its event class [T15-11], 10, 20, 30 or 40; queues: for OBs    *)
    (* whose parameters are known [T15-68], how many events wait (0: a log  *)
    (* may miss some), by how many there OB 80 is called (0: by none), and  *)
    (* whether what is beyond is entered as 3507 (1, 0; -1 is not known);   *)
    (* zone: the minutes by which local time is ahead of the clock, which   *)
    (* may be set [T15-103]; hour: if daylight saving did it last, the      *)
    (* local minutes before and after [A15-20], else 0 and 0. Nothing else  *)
    (* changes, but: where the default is "either", the CPU may show its    *)
    (* letter later.                                                        *)
    \* @type: $cpu;
    cpu,
    (* The OBs that are loaded. *)
    \* @type: Set(Int);
    loaded,
    (* [OBS-40] "STOP", "STARTUP", "RUN" or "HOLD". *)
    \* @type: Str;
    mode,
    (* The startup OB of this STARTUP: "warm", "cold" or "hot" before it    *)
    (* starts, after that "begun", or of a hot restart "resuming"; "none"   *)
    (* outside STARTUP.                                                     *)
    \* @type: Str;
    startup,
    (* [OBS-52] [OBS-54] What a hot restart brings back: the OBs that STOP  *)
    (* has interrupted and the delay count, until RUN; the jobs and the     *)
    (* start events that waited, until the restart. due: it has started,    *)
    (* and the points that passed in STOP are still to be noticed [AMB-26]. *)
    (* last: the startup or cycle OB that has ended last, where the CPU has *)
    (* several of its class [T15-79] [T15-116]; 0: none of this mode.       *)
    \* @type: $resume;
    resume,
    (* The CPU clock. *)
    \* @type: $moment;
    clock,
    (* The time-of-day interrupts. next: the minute of the next point       *)
    (* (Never: none), offset: its ms, 0 but under AMB-14 (c). start: the    *)
    (* minute from which points count, by a local time that is zone minutes *)
    (* ahead of the clock [T15-20], if local; else zone is 0. On S7-400 and *)
    (* CPU 318 [CLK-09]: served, the points for which the OB was called, as *)
    (* runs of minutes without an unserved point between; merged, in the    *)
    (* same way the points that came while the OB waited or ran, and had no *)
    (* run of their own for sure; repeatTo, the last minute that the clock  *)
    (* had reached before it was set back, -1 if it was not; overTo, the    *)
    (* same since this setting was made; alone, the last point that is      *)
    (* served again [T15-94]. held: the next point passed in HOLD, and the  *)
    (* clock was set back [AMB-83], or in STOP before a restart [AMB-26]    *)
    (* [T15-120].                                                           *)
    \* @type: Int -> $tod;
    tod,
    (* The time-delay interrupts: the job of SFC 32, if it is started, with *)
    (* the ms that are left [DINT-03].                                      *)
    \* @type: Int -> $job;
    dint,
    (* SFC 39/40: the blocked OBs, and those of them without entries in    *)
    (* the diagnostic buffer [IRT-20].  See Blocked.                       *)
    \* @type: $irt;
    irt,
    (* [OBS-07] The start events that wait for their OB to start.  See      *)
    (* module Requests.                                                     *)
    \* @type: Set($request);
    requests,
    (* The running OB is the last one; the others it has interrupted.       *)
    (* error: the error OB that it calls and that has not started, else 0.  *)
    (* told: see `late' in module Requests.                                 *)
    \* @type: Seq($frame);
    stack,
    (* [AIRT-03] The delay count of SFC 41/42. *)
    \* @type: Int;
    delay,
    (* The event id of the error for which the CPU must go to STOP; NoCause *)
    (* if there is none.                                                    *)
    \* @type: Int;
    stopCause,
    (* The entries of the last step in the diagnostic buffer: no rule       *)
    (* depends on them. open: the sources leave open whether it is entered. *)
    \* @type: Set($entry);
    entered

-----------------------------------------------------------------------------
(* Variables in groups; types, for Apalache's type checker (Snowcat) *)

(***************************************************************************)
(* @typeAlias: step7 = { execution: Str, start: Int, active: Bool,         *)
(*                       deselected: Bool, local: Bool };                  *)
(* @typeAlias: cpu = { family: Str, priority: Int -> Int,                  *)
(*                     step7: Int -> $step7, readings: Str -> Str,         *)
(*                     classes: Int -> Int, queues: Int -> $queue,         *)
(*                     zone: Int, hour: $run };                            *)
(* @typeAlias: queue = { size: Int, limit: Int, told: Int };               *)
(* @typeAlias: run = { from: Int, to: Int };                               *)
(* @typeAlias: tod = { set: Bool, active: Bool, start: Int,                *)
(*                  local: Bool, zone: Int,                                *)
(*                  offset: Int, period: Int, next: Int,                   *)
(*                  served: Set($run), merged: Set($run),                  *)
(*                  earlier: Set($memory), repeatTo: Int, overTo: Int,     *)
(*                  called: Bool, held: Bool };                            *)
(* @typeAlias: memory = { from: Int, to: Int, start: Int, local: Bool,     *)
(*                  zone: Int, period: Int };                              *)
(* @typeAlias: job = { started: Bool, left: Int, dtime: Int, sign: Int };  *)
(* @typeAlias: resume = { stack: Seq($frame), delay: Int,                    *)
(*                      dint: Int -> $job, requests: Set($request),        *)
(*                      due: Bool, last: Int };                            *)
(* @typeAlias: irt = { blocked: Set(Int), silent: Set(Int) };              *)
(* @typeAlias: request = { ob: Int, class: Int, rank: Int, fault: Int,     *)
(*                         since: $moment, word: Int, dtime: Int,          *)
(*                         late: Set(Int), cause: Int, during: Int,        *)
(*                         follows: Int, open: Bool };                     *)
(* @typeAlias: entry = { id: Int, of: $request, open: Bool };              *)
(* @typeAlias: frame = { ob: Int, class: Int, error: Int, told: Set(Int) };*)
(* @typeAlias: step = { event: Str, ob: Int, value: Int, sdt: $date,       *)
(*                      operand: Int, sign: Int };                         *)
(***************************************************************************)

\* @type: <<$cpu, Set(Int)>>;
deviceVars  == <<cpu, loaded>>
\* @type: <<Str, Str, $resume>>;
modeVars    == <<mode, startup, resume>>
\* @type: <<Int -> $tod, Int -> $job, $irt>>;
settingVars == <<tod, dint, irt>>
\* @type: <<Set($request), Int>>;
outcomeVars == <<requests, stopCause>>
\* @type: <<Seq($frame), Int>>;
runVars     == <<stack, delay>>

(* The whole CPU without `entered', which only an observer sees. *)
cpuVars == <<deviceVars, modeVars, clock, settingVars, outcomeVars, runVars>>

NothingEntered == entered' = {}
=============================================================================

--------------------------------- MODULE Cpu --------------------------------
(***************************************************************************)
(* The state of an S7-300/400 CPU as far as its interrupts depend on it,   *)
(* and the words to speak of it: OBs, priority classes, readings.          *)
(*                                                                         *)
(* Sources: catalogue sections 0.3, 5.1, table 8.1.                        *)
(* Left out: synchronous errors (OB 121, 122), which run in the class of   *)
(* the OB that causes them [AIRT-10]; OB 90; hot restart (AMB-26).         *)
(***************************************************************************)
EXTENDS Integers, FiniteSets, Sequences, Typedefs, Codes, Calendar

VARIABLES
    (* The CPU at hand; never changes.  family: "S7-300", "S7-400" or       *)
    (* "CPU 318"; priority: the classes that differ from the default        *)
    (* [OBS-05]; step7: the STEP 7 parameters of the time-of-day            *)
    (* interrupts; readings: the letters of the ambiguities that are not    *)
    (* read by their default.  Only where the default is "either" a letter  *)
    (* may be found later, when the CPU shows it.                           *)
    \* @type: $cpu;
    cpu,
    (* The OBs that are loaded. *)
    \* @type: Set(Int);
    loaded,
    (* [OBS-40] "STOP", "STARTUP", "RUN" or "HOLD". *)
    \* @type: Str;
    mode,
    (* The startup OB of this STARTUP: "warm" or "cold" where it is still   *)
    (* to come, "begun", or "none" outside STARTUP.                         *)
    \* @type: Str;
    startup,
    (* The CPU clock. *)
    \* @type: $moment;
    clock,
    (* The time-of-day interrupts.  next: the point that is watched for     *)
    (* (Never: none).  On S7-400 and CPU 318 [CLK-09]: servedFrom ..         *)
    (* servedTo, the points for which the OB was called, but for gapFrom .. *)
    (* gapTo, 0 .. -1 for none; repeatTo, the last minute that the clock    *)
    (* had reached before it was set back, -1 if it was not.                *)
    \* @type: Int -> $tod;
    tod,
    (* [OBS-07] The start events that wait for their OB to start.  See      *)
    (* module Requests.                                                     *)
    \* @type: Set($request);
    requests,
    (* The running OB is the last one; the others it has interrupted.       *)
    \* @type: Seq($frame);
    stack,
    (* [AIRT-03] The delay count of SFC 41/42. *)
    \* @type: Int;
    delay,
    (* The event id of the error for which the CPU must go to STOP; NoCause *)
    (* if there is none.                                                    *)
    \* @type: Int;
    stopCause

cpuVars == <<cpu, loaded, mode, startup, clock, tod, requests, stack,
             delay, stopCause>>

-----------------------------------------------------------------------------
(* Readings of the ambiguities *)

(* The letter by which an ambiguity is read where the header says nothing.  *)
\* @type: Str => Str;
DefaultReading(a) ==
    CASE a \in {"AMB-02", "AMB-27", "AMB-31", "AMB-44", "AMB-63"} -> "b"
      [] a \in {"AMB-01", "AMB-11", "AMB-28", "AMB-45", "AMB-47", "AMB-48",
                "AMB-49", "AMB-50", "AMB-52", "AMB-53", "AMB-54", "AMB-55",
                "AMB-56", "AMB-57", "AMB-60", "AMB-61", "AMB-67", "AMB-68",
                "AMB-70"} -> "c"
      [] a \in {"AMB-13", "AMB-18", "AMB-77"} -> "d"
      [] OTHER -> "a"

\* @type: Str => Str;
Reading(a) == IF a \in DOMAIN cpu.readings THEN cpu.readings[a]
                                           ELSE DefaultReading(a)

-----------------------------------------------------------------------------
(* OBs *)

(* [TINT-01] [AMB-64] Offered by every CPU; models use fewer. *)
TodObs == 10..17

CycleOb   == 1
TimeErrorOb == 80
ProgramErrorOb == 85
(* [OBS-29] Asynchronous errors with an OB of their own. *)
AsyncErrorObs == 80..87
StartupObs == {100, 102}
(* Start events from outside. *)
ExternalObs == (30..38) \cup (40..47) \cup (55..57) \cup {60, 70, 72}
                 \cup AsyncErrorObs

\* @type: Str => Int;
StartupOb(type) == IF type = "warm" THEN 100 ELSE 102

(* [OBS-04] Table 8.1. *)
\* @type: Int => Int;
DefaultClass(o) ==
    CASE o = CycleOb       -> 1
      [] o \in 10..17      -> 2
      [] o \in 20..23      -> o - 17
      [] o \in 30..38      -> o - 23
      [] o \in 40..47      -> o - 24
      [] o \in 55..57      -> 2
      [] o \in {60, 70}    -> 25
      [] o = 72            -> 28
      [] o = TimeErrorOb   -> 26
      [] o \in 81..87      -> IF cpu.family = "S7-300" THEN 26 ELSE 25
      [] OTHER             -> 27

(* [OBS-05] *)
\* @type: Int => Int;
ClassOf(o) == IF o \in DOMAIN cpu.priority THEN cpu.priority[o]
                                           ELSE DefaultClass(o)

(* [OBS-43] [OBS-31] [AMB-13] The class in which the start event of an      *)
(* asynchronous error is handled.                                          *)
\* @type: (Int, Int) => Int;
ErrorClass(o, fault) ==
    LET r == Reading("AMB-13")
    IN  IF o = TimeErrorOb
        THEN IF \/ mode = "STARTUP" /\ r \in {"a", "d"}
                \/ fault = BufferOverflow /\ r \in {"b", "d"}
             THEN 28 ELSE 26
        ELSE IF mode = "STARTUP" THEN 28 ELSE ClassOf(o)

(* [OBS-06] [TINT-02] (c) *)
\* @type: Int => Bool;
Deselected(o) == \/ o \in TodObs /\ cpu.step7[o].deselected
                 \/ ClassOf(o) = 0

-----------------------------------------------------------------------------
(* The stack *)

NoFrame == [ob |-> 0, class |-> 0]

Running == IF stack = <<>> THEN NoFrame ELSE stack[Len(stack)]

\* @type: Int => Bool;
OnStack(o) == \E i \in DOMAIN stack : stack[i].ob = o

\* @type: (Int, Int) => $frame;
Frame(o, class) == [ob |-> o, class |-> class]

(* The clock is watched for start points [OBS-41] [OBS-44]. *)
Watching == mode \in {"RUN", "STARTUP"}
=============================================================================

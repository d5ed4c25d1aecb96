--------------------------------- MODULE Cpu --------------------------------
(***************************************************************************)
(* The state of an S7-300/400 CPU as far as its interrupts depend on it,   *)
(* and the words to speak of it: OBs, priority classes, the stack.         *)
(*                                                                         *)
(* Sources: catalogue section 5.1, table 7.1.                              *)
(* Left out: synchronous errors (OB 121, 122), which run in the class of   *)
(* the OB that causes them [AIRT-10]; OB 90; hot restart (AMB-26).         *)
(***************************************************************************)
EXTENDS Integers, FiniteSets, Sequences, Typedefs, Codes, Calendar, Readings

VARIABLES
    (* The CPU at hand.  family: "S7-300", "S7-400" or "CPU 318"; priority: *)
    (* the classes that differ from the default [OBS-05]; step7: the STEP 7 *)
    (* parameters of the time-of-day interrupts; readings: the letters of   *)
    (* the ambiguities that are not read by their default.  It never        *)
    (* changes, but that where the default is "either" a letter may be      *)
    (* found later, when the CPU shows it.                                  *)
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
    (* The time-of-day interrupts.  next: the minute of the point that is   *)
    (* watched for (Never: none), offset: its ms, 0 but under AMB-14 (c).   *)
    (* On S7-400 and CPU 318 [CLK-09]: served, the points for which the OB  *)
    (* was called, as runs of minutes without a point between that was not  *)
    (* served; repeatTo, the last minute that the clock had reached before  *)
    (* it was set back, -1 if it was not.                                   *)
    \* @type: Int -> $tod;
    tod,
    (* The time-delay interrupts: the job of SFC 32, if it is started, with *)
    (* the ms that are left [DINT-03].                                      *)
    \* @type: Int -> $job;
    dint,
    (* SFC 39/40: what is blocked, and of that what is not entered in the   *)
    (* diagnostic buffer [IRT-20].  See Blocked.                            *)
    \* @type: $irt;
    irt,
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
    stopCause,
    (* What the last step entered in the diagnostic buffer: no rule depends *)
    (* on it.  open: the sources leave open whether it is entered.          *)
    \* @type: Set($entry);
    entered

cpuVars == <<cpu, loaded, mode, startup, clock, tod, dint, irt, requests,
             stack, delay, stopCause>>

NothingEntered == entered' = {}

(* The letter by which an ambiguity is read. *)
\* @type: Str => Str;
Reading(a) == IF a \in DOMAIN cpu.readings THEN cpu.readings[a]
                                           ELSE Defaults[a]

-----------------------------------------------------------------------------
(* OBs *)

(* [TINT-01] [DINT-01] [AMB-64] Offered by every CPU; models use fewer. *)
TodObs  == 10..17
DintObs == 20..23

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

(* [OBS-04] Table 7.1. *)
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

(* [OBS-06] [TINT-02] (c) [DINT-02] *)
\* @type: Int => Bool;
Deselected(o) == \/ o \in TodObs /\ cpu.step7[o].deselected
                 \/ ClassOf(o) = 0

-----------------------------------------------------------------------------
(* SFC 39/40: what is blocked *)

(* [IRT-11] The class number of an OB; not its priority class. *)
\* @type: Int => Int;
ClassNumber(o) == IF o \in 55..57 THEN 50 ELSE (o \div 10) * 10

(* [IRT-11] The OBs that can be blocked; models use fewer. *)
Blockable == (10..17) \cup (20..23) \cup ExternalObs

(* [AMB-21] (b) Marks in irt for a whole class and for everything, apart    *)
(* from the OBs.                                                           *)
\* @type: Int => Int;
ClassMark(number) == 1000 + number
AllMark == 2000

\* @type: (Set(Int), Int) => Bool;
MarkedIn(marks, o) ==
    /\ marks # {}
    /\ \/ o \in marks
       \/ ClassMark(ClassNumber(o)) \in marks
       \/ AllMark \in marks

(* [IRT-01] [IRT-02] New start events of the OB are lost. *)
\* @type: Int => Bool;
Blocked(o) == MarkedIn(irt.blocked, o)

(* [IRT-09] Nor are they entered in the diagnostic buffer. *)
\* @type: Int => Bool;
Silenced(o) == MarkedIn(irt.silent, o)

(* Start events of the OB come to nothing. *)
\* @type: Int => Bool;
Idle(o) == Deselected(o) \/ Blocked(o)

-----------------------------------------------------------------------------
(* The stack *)

NoFrame == [ob |-> 0, class |-> 0]

Running == IF stack = <<>> THEN NoFrame ELSE stack[Len(stack)]

\* @type: Int => Bool;
OnStack(o) == \E i \in DOMAIN stack : stack[i].ob = o

\* @type: (Int, Int) => $frame;
Frame(o, class) == [ob |-> o, class |-> class]

(* The clock is watched for start points, and delays run, [OBS-41] [OBS-44]; *)
(* neither in HOLD [OBS-45] [DINT-19].                                      *)
Watching == mode \in {"RUN", "STARTUP"}
=============================================================================

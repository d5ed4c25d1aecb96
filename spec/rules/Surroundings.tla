---------------------------- MODULE Surroundings ----------------------------
(***************************************************************************)
(* The surroundings of a CPU: the CPUs and loaded OBs to begin with, the   *)
(* operands that a program may pass, the events of the world. Models       *)
(* replace these sets by small ones.                                       *)
(*                                                                         *)
(* Left out: the moments of calls and events (System).                     *)
(***************************************************************************)
EXTENDS Calendar, Cpu

(* CPUs and OBs loaded. *)
Families == FamilyNames
\* @type: Set(Int -> $step7);
Step7Settings ==
    [ OldTodObs -> [ execution : {"none", "once", "minute", "hourly", "daily",
                               "weekly", "monthly", "yearly", "end_of_month"},
                  start : 0..LastMinute, active : BOOLEAN,
                  deselected : BOOLEAN, local : {FALSE} ] ]
Loads == SUBSET (TodObs \cup ExternalObs \cup StartupObs)

(* Priority classes other than the defaults [OBS-05]; none. *)
\* @type: Set(Int -> Int);
Priorities == { [o \in {} |-> 0] }

(* [T15-11] OBs from 123 on with their event class; none. *)
\* @type: Set(Int -> Int);
ObClasses == { [o \in {} |-> 0] }

(* [T15-68] OBs whose queue has known parameters; none. *)
\* @type: Set(Int -> $queue);
Queues == { [o \in {} |-> [size |-> 1, limit |-> 0, told |-> 0]] }

(* Readings other than the defaults; none. *)
\* @type: Set(Str -> Str);
ReadingSets == { [a \in {} |-> ""] }

(* Operands of calls. *)
ObNumbers == -32768..32767
\* @type: Set($date);
Sdts == [ year : 1990..2089, month : 1..99, day : 1..99, hour : 0..99,
          minute : 0..99, second : 0..99, ms : 0..999 ]
Words == 0..65535
(* [T15-09] SET_TINTL sets by local time, or not.                          *)
Locals == {FALSE}
Dtimes == -60000..600000
Signs == Words
IrtModes == 0..255

(* Possible answers; an observer does not know the rules. *)
RetVals == Words
StatusWords == {-1} \cup Words

(* Moments to which time may pass, at which it begins, and to which the    *)
(* clock may be set.                                                       *)
\* @type: Set($moment);
Moments == [min : 0..LastMinute, ms : 0..59999]
\* @type: Set($moment);
PowerOnMoments == Moments
\* @type: Set($moment);
ClockTargets == Moments

(* [T15-20] [T15-103] The minutes by which local time is ahead of the      *)
(* clock, to begin with and later.                                         *)
Zones == {0}

(* Start events from outside, with the fault id of OB 80 and 85; errors of *)
(* the running OB.                                                         *)
\* @type: Set(<<Int, Int>>);
Interrupts == ((ExternalObs \cup SyncErrorObs) \X {0})
                \cup ({TimeErrorOb, ProgramErrorOb} \X (0..255))

(* Whether the CPU may be put on HOLD. *)
HoldPossible == TRUE

(* OBs that are loaded and deleted while the CPU is at work. *)
ChangingObs == TodObs \cup ExternalObs \cup StartupObs
=============================================================================

----------------------------- MODULE CounterLock ----------------------------
(***************************************************************************)
(* SFC 41 and 42 as a lock that is counted (section 4): the running        *)
(* program takes it and gives it back; while it is held nothing starts and *)
(* no waiting start event is lost; when the count is 0, or the program has *)
(* ended, a program of a higher class starts before anything else.         *)
(*                                                                         *)
(* An abstract specification: models/MCRefineLock shows that System        *)
(* implements it.  Programs and start events are here no more than their   *)
(* priority classes.                                                       *)
(* Left out: HOLD; calls that withdraw start events; missing OBs and the   *)
(* STOP that they lead to.                                                 *)
(***************************************************************************)
EXTENDS Integers, Sequences

CONSTANT
    (* Priority classes. *)
    \* @type: Set(Int);
    Classes

VARIABLES
    (* The CPU is not in STOP. *)
    \* @type: Bool;
    on,
    (* How often the lock was taken and not given back. *)
    \* @type: Int;
    count,
    (* The classes of the programs: the last one runs, the others are       *)
    (* interrupted.                                                         *)
    \* @type: Seq(Int);
    running,
    (* The number of start events that wait in each class ...               *)
    \* @type: Int -> Int;
    waiting,
    (* ... and the classes in which a program may start without one that is *)
    (* sure to wait.                                                        *)
    \* @type: Set(Int);
    perhaps

lockVars == <<on, count, running, waiting, perhaps>>

RunningClass == IF running = <<>> THEN 0 ELSE running[Len(running)]

(* The classes that would interrupt the running program without the lock. *)
Held == { c \in Classes : waiting[c] > 0 /\ c > RunningClass }

(* An open lock holds nothing back; otherwise nothing else happens. *)
Settled == on /\ (count = 0 => Held = {})

Init == /\ on = FALSE
        /\ count = 0
        /\ running = <<>>
        /\ waiting = [c \in Classes |-> 0]
        /\ perhaps = {}

(* [AIRT-03] *)
Take == /\ Settled /\ running # <<>>
        /\ count' = count + 1
        /\ UNCHANGED <<on, running, waiting, perhaps>>

(* [AIRT-03] [AIRT-07] *)
GiveBack == /\ Settled /\ count > 0
            /\ count' = count - 1
            /\ UNCHANGED <<on, running, waiting, perhaps>>

(* [AIRT-02] Start events come at any time; none is lost. *)
Arrive == /\ Settled
          /\ \A c \in Classes : waiting'[c] >= waiting[c]
          /\ UNCHANGED <<on, count, running>>

(* [AIRT-01] [AIRT-08] While the lock is open a waiting program starts,    *)
(* the highest class first and by itself.                                  *)
\* @type: Int => Bool;
Enter(c) == /\ on /\ count = 0
            /\ c > RunningClass
            /\ \A d \in Held : d <= c
            /\ \/ waiting[c] > 0 /\ waiting' = [waiting EXCEPT ![c] = @ - 1]
               \/ c \in perhaps  /\ waiting' = waiting
            /\ running' = Append(running, c)
            /\ UNCHANGED <<on, count>>

(* A start event that is not sure to wait may come to nothing. *)
Fade == /\ on /\ count = 0
        /\ perhaps # {}
        /\ UNCHANGED <<on, count, running, waiting>>

(* The cycle, and the start of the CPU. *)
\* @type: Int => Bool;
Begin(c) == /\ Settled /\ running = <<>>
            /\ running' = <<c>>
            /\ UNCHANGED <<on, count, waiting, perhaps>>

(* [AIRT-04] The end of a program opens the lock. *)
Leave == /\ Settled /\ running # <<>>
         /\ running' = SubSeq(running, 1, Len(running) - 1)
         /\ count' = 0
         /\ UNCHANGED <<on, waiting, perhaps>>

(* [AIRT-11] STOP is not held back, and leaves nothing. *)
Stop == /\ on /\ on' = FALSE
        /\ count' = 0
        /\ running' = <<>>
        /\ waiting' = [c \in Classes |-> 0]
        /\ perhaps' = {}

Restart == /\ ~on /\ on' = TRUE
           /\ UNCHANGED <<count, running, waiting, perhaps>>

Next == \/ Take \/ GiveBack \/ Arrive \/ Leave \/ Fade \/ Stop \/ Restart
        \/ \E c \in Classes : Enter(c) \/ Begin(c)

Spec == Init /\ [][Next]_lockVars
=============================================================================

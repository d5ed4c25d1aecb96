----------------------------- MODULE CounterLock ----------------------------
(***************************************************************************)
(* SFC 41 and 42 as a lock that is counted (section 4): the running        *)
(* program takes it and gives it back; while it is held nothing starts and *)
(* no waiting start event is lost; when the count is 0, or the program has *)
(* ended, a program of a higher class starts before anything else.         *)
(*                                                                         *)
(* An abstract specification: System implements it, see models/APRefine    *)
(* and models/MCRefineLock.  Programs and start events are here no more    *)
(* than their priority classes.                                            *)
(* Left out: start events whose OB is missing; which call withdraws which  *)
(* start event.                                                            *)
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
    (* It is in HOLD. *)
    \* @type: Bool;
    held,
    (* How often the lock was taken and not given back. *)
    \* @type: Int;
    count,
    (* The classes of the programs: the last one runs, the others are       *)
    (* interrupted.                                                         *)
    \* @type: Seq(Int);
    running,
    (* The number of start events that wait in each class.                  *)
    \* @type: Int -> Int;
    waiting,
    (* The classes in which a program may start although no start event is  *)
    (* definitely waiting.                                                  *)
    \* @type: Set(Int);
    perhaps,
    (* The last step was a call that withdraws start events, or a deletion. *)
    \* @type: Bool;
    asked

lock == <<on, held, count, running, waiting, perhaps>>
lockVars == <<lock, asked>>

RunningClass == IF running = <<>> THEN 0 ELSE running[Len(running)]

(* The classes that would interrupt the running program without the lock. *)
Held == { c \in Classes : waiting[c] > 0 /\ c > RunningClass }

(* An open lock holds nothing back; otherwise a program does nothing.      *)
Settled == on /\ (count = 0 /\ ~held => Held = {})
Working == Settled /\ ~held

(* More start events wait.  The sources leave open what else may wait.     *)
More == \A c \in Classes : waiting'[c] >= waiting[c]

Init == /\ on = FALSE /\ held = FALSE
        /\ count = 0
        /\ running = <<>>
        /\ waiting = [c \in Classes |-> 0]
        /\ perhaps = {}
        /\ asked = FALSE

(* [AIRT-03] *)
Take == /\ Working /\ running # <<>>
        /\ count' = count + 1
        /\ UNCHANGED <<on, held, running, waiting, perhaps>>

(* [AIRT-03] [AIRT-07] *)
GiveBack == /\ Working /\ count > 0
            /\ count' = count - 1
            /\ UNCHANGED <<on, held, running, waiting, perhaps>>

(* [AIRT-02] Start events come at any time; none is lost. *)
Arrive == on /\ More /\ UNCHANGED <<on, held, count, running>>

(* [TINT-50] [DINT-14] A call withdraws start events, or their program is  *)
(* deleted.                                                                *)
Withdraw == /\ Settled /\ asked'
            /\ \A c \in Classes : waiting'[c] <= waiting[c]
            /\ perhaps' \subseteq perhaps
            /\ UNCHANGED <<on, held, count, running>>

(* [AIRT-01] [AIRT-08] While the lock is open a waiting program starts,    *)
(* the highest class first and by itself.  Other start events of its own   *)
(* may go with it [TINT-08].                                               *)
\* @type: Int => Bool;
Enter(c) == /\ on /\ ~held /\ count = 0
            /\ c > RunningClass
            /\ \A d \in Held : d <= c
            /\ \A d \in Classes :
                 IF d = c THEN waiting'[d] <= waiting[d]
                          ELSE waiting'[d] = waiting[d]
            /\ waiting'[c] < waiting[c] \/ c \in perhaps
            /\ running' = Append(running, c)
            /\ UNCHANGED <<on, held, count>>

(* A start event that is not sure to wait may come to nothing. *)
Fade == /\ on /\ ~held /\ count = 0
        /\ perhaps # {}
        /\ UNCHANGED <<on, held, count, running, waiting>>

(* The cycle, and the start of the CPU. *)
\* @type: Int => Bool;
Begin(c) == /\ Working /\ running = <<>>
            /\ running' = <<c>>
            /\ UNCHANGED <<on, held, count, waiting, perhaps>>

(* [AIRT-04] The end of a program opens the lock. *)
Leave == /\ Working /\ running # <<>>
         /\ running' = SubSeq(running, 1, Len(running) - 1)
         /\ count' = 0
         /\ UNCHANGED <<on, held, waiting, perhaps>>

(* [OBS-45] Nothing starts in HOLD; what waits goes on waiting.  At its    *)
(* end more may wait [OBS-46].                                             *)
Pause == /\ Working /\ held' = TRUE
         /\ UNCHANGED <<on, count, running, waiting, perhaps>>
Resume == /\ on /\ held /\ held' = FALSE
          /\ More
          /\ UNCHANGED <<on, count, running>>

(* [AIRT-11] STOP is not held back, and leaves nothing. *)
Stop == /\ on /\ on' = FALSE
        /\ held' = FALSE
        /\ count' = 0
        /\ running' = <<>>
        /\ waiting' = [c \in Classes |-> 0]
        /\ perhaps' = {}

Restart == /\ ~on /\ on' = TRUE
           /\ UNCHANGED <<held, count, running, waiting, perhaps>>

(* A step of which the lock sees nothing. *)
Nothing == UNCHANGED lock

Next == \/ Take \/ GiveBack \/ Arrive \/ Withdraw \/ Leave \/ Fade
        \/ Pause \/ Resume \/ Stop \/ Restart \/ Nothing
        \/ \E c \in Classes : Enter(c) \/ Begin(c)

Spec == Init /\ [][Next]_lockVars
=============================================================================

---------------------------- MODULE MCLockAlone ----------------------------
(***************************************************************************)
(* CounterLock by itself, with two classes: whatever one step may change,  *)
(* from every state.  System refines it (MCRefineLock); that says nothing  *)
(* of what CounterLock allows beyond System.  Here it is.                  *)
(***************************************************************************)
EXTENDS CounterLock

Deepest == 2
Most    == 2
Programs == { <<>> } \cup { <<c>> : c \in Classes }
              \cup { <<c, d>> : c, d \in Classes }

(* CounterLock leaves open what else arrives: every next state is tried.     *)
AnyNext == /\ on' \in BOOLEAN
           /\ count' \in 0..Deepest
           /\ running' \in Programs
           /\ perhaps' \in SUBSET Classes
           /\ waiting' \in [Classes -> 0..Most]
           /\ Next

AloneSpec == Init /\ [][AnyNext]_lockVars

(* The count is of the program that runs, and of no other [AIRT-04].         *)
CountInv == count > 0 => on /\ running # <<>>

(* What runs was not interrupted by its own class [OBS-01].                  *)
NestedInv == \A i \in 2..Len(running) : running[i] > running[i - 1]

OffInv == ~on => running = <<>> /\ \A c \in Classes : waiting[c] = 0

Starts == Len(running') > Len(running)

(* Nothing starts while the lock is held [AIRT-01]. *)
HeldProp == [][ Starts => count = 0 ]_lockVars

(* What starts has the highest class of what waits [OBS-04]. *)
HighestProp ==
    [][ Starts => \A c \in Held : c <= running'[Len(running')] ]_lockVars

(* What waits is taken by its start and by STOP alone [AIRT-02]. *)
NoneLostProp ==
    [][ \A c \in Classes :
          waiting'[c] < waiting[c] =>
            \/ ~on'
            \/ Starts /\ running'[Len(running')] = c
                      /\ waiting'[c] = waiting[c] - 1 ]_lockVars

(* What interrupts goes first when the lock opens [AIRT-08]. *)
AtOnceProp ==
    [][ on /\ count = 0 /\ Held # {} =>
          Starts \/ ~on' \/ UNCHANGED <<on, count, running, waiting>> ]_lockVars

(* One call counts one [AIRT-03]; the end of the program counts all back.    *)
CountedProp ==
    [][ count' # count =>
          \/ count' \in {count - 1, count + 1} /\ running' = running
          \/ count' = 0 /\ (Len(running') < Len(running)) ]_lockVars
=============================================================================

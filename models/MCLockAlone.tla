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

(* CounterLock leaves open what else arrives: every next state is tried.   *)
AnyNext == /\ on' \in BOOLEAN
           /\ count' \in 0..Deepest
           /\ running' \in Programs
           /\ perhaps' \in SUBSET Classes
           /\ waiting' \in [Classes -> 0..Most]
           /\ Next

AloneSpec == Init /\ [][AnyNext]_lockVars

(* The count is of the program that runs, and of no other [AIRT-04].       *)
CountInv == count > 0 => on /\ running # <<>>

(* What runs was not interrupted by its own class [OBS-01].                *)
NestedInv ==
    \A i, j \in DOMAIN running : i < j => running[i] < running[j]

OffInv == ~on => running = <<>> /\ \A c \in Classes : waiting[c] = 0

Starts == Len(running') > Len(running)

(* Nothing starts while the lock is held [AIRT-01]. *)
HeldStep == Starts => count = 0

(* What starts has the highest class of what waits [OBS-04]. *)
HighestStep == Starts => \A c \in Held : c <= running'[Len(running')]

(* What waits is taken by its start and by STOP alone [AIRT-02]. *)
NoneLostStep ==
    \A c \in Classes :
      waiting'[c] < waiting[c] =>
        \/ ~on'
        \/ Starts /\ running'[Len(running')] = c
                  /\ waiting'[c] = waiting[c] - 1

(* What interrupts goes first when the lock opens [AIRT-08]. *)
AtOnceStep ==
    on /\ count = 0 /\ Held # {} =>
      Starts \/ ~on' \/ UNCHANGED <<on, count, running, waiting>>

(* One call counts one [AIRT-03]; the end of the program counts all back.  *)
CountedStep ==
    count' # count =>
      \/ count' \in {count - 1, count + 1} /\ running' = running
      \/ count' = 0 /\ (Len(running') < Len(running))

HeldProp     == [][HeldStep]_lockVars
HighestProp  == [][HighestStep]_lockVars
NoneLostProp == [][NoneLostStep]_lockVars
AtOnceProp   == [][AtOnceStep]_lockVars
CountedProp  == [][CountedStep]_lockVars
=============================================================================

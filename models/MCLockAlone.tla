---------------------------- MODULE MCLockAlone ----------------------------
(***************************************************************************)
(* CounterLock by itself, with two classes: every step from every state.   *)
(* System refines CounterLock (MCRefineLock), but CounterLock allows more  *)
(* than System. This model checks all that it allows.                      *)
(***************************************************************************)
EXTENDS CounterLock

Deepest == 2
Most    == 2

(* Next of CounterLock. It leaves the arrivals open: any number, of any    *)
(* classes.                                                                *)
AnyPerhaps == perhaps' \in SUBSET Classes
AnyWaiting == waiting' \in [Classes -> 0..Most]

AnyNext ==
    /\ asked' \in BOOLEAN
    /\ \/ Take \/ GiveBack \/ Leave \/ Pause \/ Stop \/ Restart \/ Nothing
       \/ AnyPerhaps /\ Fade
       \/ AnyWaiting /\ AnyPerhaps /\ (Arrive \/ Withdraw \/ Resume)
       \/ \E c \in Classes :
            (AnyWaiting /\ AnyPerhaps /\ Enter(c)) \/ Begin(c)

AtMost == count <= Deepest

AloneSpec == Init /\ [][AnyNext]_lockVars

(* The count belongs to the running program alone [AIRT-04].               *)
CountInv == count > 0 => on /\ running # <<>>

(* No OB is interrupted by an OB of its own class [OBS-01].                *)
NestedInv ==
    \A i, j \in DOMAIN running : i < j => running[i] < running[j]

OffInv == ~on => /\ ~held /\ running = <<>>
                 /\ \A c \in Classes : waiting[c] = 0

Starts == Len(running') > Len(running)

(* Nothing starts while the lock is held [AIRT-01], or in HOLD [OBS-45]. *)
HeldStep == Starts => count = 0 /\ ~held

(* The highest waiting class starts first [OBS-04]. *)
HighestStep == Starts => \A c \in Held : c <= running'[Len(running')]

(* Only its start, a call, its deletion and STOP remove a waiting start    *)
(* event [AIRT-02]; no call while another has to start [AIRT-08].          *)
NoneLostStep ==
    \A c \in Classes :
      waiting'[c] < waiting[c] =>
        \/ ~on'
        \/ Starts /\ running'[Len(running')] = c
        \/ Settled /\ asked' /\ UNCHANGED <<on, held, count, running>>

(* When the lock opens, the interrupting class goes first [AIRT-08]; more  *)
(* start events may come.                                                  *)
AtOnceStep ==
    on /\ ~held /\ count = 0 /\ Held # {} =>
      \/ Starts \/ ~on'
      \/ More /\ UNCHANGED <<on, held, count, running>>

(* One call counts one [AIRT-03]. The end of the program resets the count. *)
CountedStep ==
    count' # count =>
      \/ count' \in {count - 1, count + 1} /\ running' = running
      \/ count' = 0 /\ (Len(running') < Len(running))

(* A program ends by itself, not in HOLD [OBS-45] and not while another    *)
(* has to start [AIRT-08]; it takes no start event along.                  *)
EndStep ==
    on' /\ Len(running') < Len(running) =>
      /\ Working
      /\ running' = SubSeq(running, 1, Len(running) - 1)
      /\ waiting' = waiting

(* A lock that forbids too much violates no step. The program may take it  *)
(* and give it back, and end; what is held starts; STOP may come.          *)
PossibleInv ==
    /\ Working /\ running # <<>> =>
         /\ ENABLED (AnyNext /\ count' = count + 1)
         /\ ENABLED (AnyNext /\ on' /\ Len(running') < Len(running))
    /\ Working /\ count > 0 =>
         ENABLED (AnyNext /\ count' = count - 1 /\ running' = running)
    /\ Working /\ running = <<>> => ENABLED (AnyNext /\ Starts)
    /\ Working => ENABLED (AnyNext /\ held')
    /\ on /\ held => ENABLED (AnyNext /\ on' /\ ~held')
    /\ on /\ ~held /\ count = 0 /\ Held # {} => ENABLED (AnyNext /\ Starts)
    /\ ENABLED (AnyNext /\ on' # on)

HeldProp     == [][HeldStep]_lockVars
EndProp      == [][EndStep]_lockVars
HighestProp  == [][HighestStep]_lockVars
NoneLostProp == [][NoneLostStep]_lockVars
AtOnceProp   == [][AtOnceStep]_lockVars
CountedProp  == [][CountedStep]_lockVars
=============================================================================

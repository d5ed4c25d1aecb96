---------------------------- MODULE MCRefineLock ----------------------------
(***************************************************************************)
(* System implements CounterLock: delays nested two deep in OB 1, a time-  *)
(* of-day OB, a hardware OB and OB 80, on an S7-300 and an S7-400, with    *)
(* start events of every class meanwhile (section 4).                      *)
(***************************************************************************)
EXTENDS MCBase, LockMapping

MCTodObs == {10}
MCFamilies == TwoFamilies
MCLoads == {{10, 40, 80, 85, 100}, {40, 80, 85, 100}}
(* In its place for an S7-1500: no OB 85, and OB 40 is above OB 80. *)
NewerLoads == {{10, 40, 80, 100}, {40, 80, 100}}
NewerPriorities == { [o \in {40} |-> 23] }
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)]}
MCMoments == HalfMinutes(0, 1)
(* The full lane. *)
WideMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}
(* DIS_AIRT answers at most 2: no program nests deeper. *)
MCRetVals == {0, 1, 2, NotDelayed}

MCClasses == 1..28

Lock == INSTANCE CounterLock WITH
            Classes <- MCClasses,
            on      <- mode # "STOP",
            held    <- mode = "HOLD",
            count   <- delay,
            running <- [i \in DOMAIN stack |-> stack[i].class],
            waiting <- [c \in MCClasses |-> WaitingIn(c)],
            perhaps <- { c \in MCClasses : PerhapsIn(c) },
            asked   <- MayWithdraw

LockSpec == Lock!Spec

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ Waiting(IF mode = "HOLD" THEN 1 ELSE 2)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

------------------------------- MODULE MCClock --------------------------------
(***************************************************************************)
(* The clock set forward and back, exactly onto points, over the points of *)
(* two interrupts, with OB 80 and without, while OBs wait and run (section *)
(* 6).                                                                     *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10, 11}
MCFamilies == TwoFamilies
MCLoads == {{10, 11, 80, 85}, {10, 11, 85}}
LoadsWithoutTod == {{80, 85}}
MCStep7Settings ==
    {[o \in TodObs |-> IF o = 10 THEN Activated("minute", 0)
                                 ELSE Activated("once", 2)]}
ServedAndLater ==
    {[o \in TodObs |-> IF o = 10 THEN Activated("hourly", 1)
                                 ELSE Activated("once", 2)]}
OnceIsSkipped ==
    {[o \in TodObs |-> IF o = 10 THEN Activated("minute", 0)
                                 ELSE Activated("once", 1)]}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(0, 0), Moment(1, 30000), Moment(2, 0)}
MCRestartTypes == {"warm"}

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments

(* The full lane: `clock-wide'. *)
BackAndOverBoth == {Moment(0, 0), Moment(2, 30000)}
WideClockTargets == MCClockTargets \cup {Moment(0, 30000), Moment(1, 0)}
Wide == /\ Waiting(3)
        /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

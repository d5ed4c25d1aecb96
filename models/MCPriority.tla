----------------------------- MODULE MCPriority -----------------------------
(***************************************************************************)
(* Priority classes that are set (section 5.1): a time-of-day OB above a   *)
(* hardware OB, another that shares its class with one, and an OB that     *)
(* class 0 deselects.                                                      *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10, 11}
MCFamilies == {"S7-400"}
MCPriorities ==
    { [o \in {10, 11, 40, 41} |-> CASE o = 10 -> 3 [] o = 11 -> 20
                                    [] o = 40 -> 3 [] OTHER   -> 0] }
MCLoads == {{10, 11, 40, 80, 85}}
(* [OBS-25] An OB of class 0 is loaded. *)
ZeroLoads == {{10, 41, 80, 85}}
MCStep7Settings ==
    {[o \in TodObs |-> Activated("minute", IF o = 10 THEN 1 ELSE 2)]}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>, <<41, 0>>}
MCRestartTypes == {"warm"}

Bounded == /\ delay <= 1
           /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

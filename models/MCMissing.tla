------------------------------ MODULE MCMissing -------------------------------
(***************************************************************************)
(* OBs that are not loaded: the OB that is called in their place, and the  *)
(* STOP (section 5.2).                                                     *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-400"}
MCLoads == {{80}, {10, 80}, {80, 85}}
MCChangingObs == {80}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)],
                    [o \in TodObs |-> Activated("once", 1)]}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>, <<81, 0>>, <<82, 0>>}
MCRestartTypes == {"warm"}

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay <= 1
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

--------------------------------- MODULE MCIrt --------------------------------
(***************************************************************************)
(* DIS_IRT and EN_IRT with right and wrong operands, of everything, a      *)
(* class, an OB, with and without entries, over points, hardware           *)
(* interrupts, time errors and missing OBs (section 3).                    *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCBlockable == {10, 80, 85}
MCFamilies == {"S7-400"}
MCLoads == {{10, 80}, {85}}
MCStep7Settings == {[o \in TodObs |-> Activated("once", 1)],
                    [o \in TodObs |-> Activated("minute", 1)]}
MCObNumbers == {1, 10, 80}
MCIrtModes == {1, 3, 130}
MCMoments == {Moment(0, 30000), Moment(1, 0), Moment(1, 30000)}
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>, <<80, 1>>}
MCRestartTypes == {"warm"}

Bounded == /\ delay = 0
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

--------------------------------- MODULE MCIrt --------------------------------
(***************************************************************************)
(* DIS_IRT and EN_IRT with right and wrong operands, of everything, a      *)
(* class, an OB, with and without entries, over points, delays, hardware   *)
(* interrupts, time errors and missing OBs (section 3).                    *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCDintObs == {20}
MCBlockable == {10, 40, 80, 85}
MCFamilies == {"S7-400"}
MCLoads == {{10, 40, 80, 85, 100}, {40}, {10}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)],
                    [o \in TodObs |-> Activated("once", 1)]}
MCObNumbers == {0, 10, 80}
MCIrtModes == {0, 1, 3, 128, 130}
MCMoments == HalfMinutes(0, 1) \cup {Moment(2, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(1, 30000)}
MCInterrupts == {<<40, 0>>, <<80, 1>>}
MCRestartTypes == {"warm"}

Bounded == /\ delay = 0
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

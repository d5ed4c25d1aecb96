-------------------------------- MODULE MCTod ---------------------------------
(***************************************************************************)
(* SET, CAN, ACT and QRY_TINT with right and wrong operands, before and    *)
(* after start points, while the OB waits and while it runs (section 1).   *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 40, 80, 85, 100}}
MCStep7Settings == {[o \in TodObs |-> NotConfigured]}
MCObNumbers == {10, 99}
MCSdts == {Date(0), Date(1), WrongDate, Monthly29}
MCWords == {Once, Minutely, Monthly, \hFFFF}
MCMoments == HalfMinutes(0, 1)
MCPowerOnMoments == {Moment(0, 0)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

Bounded == delay <= 1 /\ Cardinality(requests) <= 2
=============================================================================

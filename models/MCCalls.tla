------------------------------- MODULE MCCalls -------------------------------
(***************************************************************************)
(* Every call of SFC 28 to 34, 39 and 40 with right and wrong operands and *)
(* every answer, around one start point and the end of one delay (sections *)
(* 1 to 3): small, for a quick look.                                       *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCDintObs == {20}
MCBlockable == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> NotConfigured]}
MCObNumbers == {10, 20, 99}
MCSdts == {Date(1), WrongDate}
MCWords == {Once, Minutely, \hFFFF}
MCDtimes == {0, 30000}
MCSigns == {1}
MCIrtModes == {2, 3}
MCMoments == {Moment(1, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCRestartTypes == {"warm"}
MCRetVals == {OK, BadOb, BadSdt, BadPeriod, NotSet, PastStart, 1, 2,
              NotDelayed}
MCStatusWords == {0, 4, 5, 16, 18, 20, 22}
(* Bits 3 and 6, and one that is always 0. *)
OpenStatusWords == {0, 8, 24, 80, 88, 128}
JustOK == {OK}

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay = 0
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

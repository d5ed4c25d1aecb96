------------------------------ MODULE MCLostPoint ----------------------------
(***************************************************************************)
(* A one-shot interrupt whose point passes in HOLD, so that its run is     *)
(* open [AMB-55]; then the clock is set back, the OB is blocked and its    *)
(* point comes again (sections 3, 5.4 and 6).                              *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCBlockable == {10}
MCFamilies == TwoFamilies
\* @type: Set(Str);
JustS7300 == {"S7-300"}
MCLoads == {{10, 80}}
MCStep7Settings == {[o \in TodObs |-> Activated("once", 1)]}
MCObNumbers == {10}
MCIrtModes == {2}
MCMoments == {Moment(0, 30000), Moment(1, 0), Moment(1, 30000)}
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(0, 30000)}
MCRestartTypes == {"warm"}
MCRetVals == {OK}
MayBePast == {OK, NotSet, PastStart}
\* @type: Bool;
Holding == TRUE

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay = 0
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
(* The OB may be missing while two start events of it wait. *)
LoadsWithOb85 == {{10, 80, 85}}
BoundedByTwo == /\ delay = 0
                /\ Waiting(2)
                /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

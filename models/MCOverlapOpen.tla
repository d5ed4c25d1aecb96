----------------------------- MODULE MCOverlapOpen ---------------------------
(***************************************************************************)
(* The points of OB 10 come while it runs, and it is deleted.  An OB 85    *)
(* that ends may have been for its later run, which is open then [AMB-45]; *)
(* and the next point comes (sections 1.1 and 5.2).                        *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 80, 85}}
MCChangingObs == {10}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 1)]}
MCMoments == { Moment(m, 0) : m \in 0..3 }
MCPowerOnMoments == {Moment(0, 0)}
MCInterrupts == {<<85, 0>>}
MCRestartTypes == {"warm"}

(* The same of a delay. *)
DelayObs == {20}
DelayLoads == {{20, 80, 85}}
DelayStep7Settings == {[o \in TodObs |-> NotConfigured]}
DelayDtimes == {30000}
DelaySigns == {1}
DelayMoments == {Moment(0, 30000), Moment(1, 0)}
JustOK == {OK}

(* [AMB-11] CAN_DINT takes an open run away, behind which OB 40 waits, in  *)
(* the same class.                                                         *)
S7400 == {"S7-400"}
SameClass == {[o \in {40} |-> 3]}
BesideLoads == {{20, 40, 80, 85}}
BesideInterrupts == {<<40, 0>>, <<85, 0>>}
OneMoment == {Moment(0, 30000)}

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay = 0
           /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

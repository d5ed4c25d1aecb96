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

(* In their place where OB 40 and OB 33 are missing, and OB 35 between     *)
(* them is loaded. Each has one start event at a time.                     *)
BetweenLoads == {{35, 80, 85}}
BetweenEvents == {<<40, 0>>, <<35, 0>>, <<33, 0>>}
BetweenMoments == {Moment(0, 30000)}
BetweenStep7 == {[o \in TodObs |-> NotConfigured]}
BetweenRetVals == {0, 1}
BetweenBounded == /\ delay <= 1 /\ Len(stack) <= 2
                  /\ Cardinality(requests) <= 4
                  /\ \A r, s \in requests : r.ob = s.ob => r = s
=============================================================================

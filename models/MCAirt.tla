-------------------------------- MODULE MCAirt --------------------------------
(***************************************************************************)
(* Delays nested three deep, in OB 1, a time-of-day OB, a hardware OB and  *)
(* OB 80, with points that fall due meanwhile (section 4).                 *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 40, 80, 85, 100}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)]}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

(* Behaviours after a STOP are left to MCRestart. *)
Shallow == /\ delay <= 1
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments

(* The count goes on, in OB 1 alone. *)
NotSetUp == {[o \in TodObs |-> NotConfigured]}
DeepRetVals == (0..42) \cup {NotDelayed}
Deep == delay <= 40

Bounded == /\ delay <= 3
           /\ Waiting(3)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

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

(* What follows a STOP is left to MCRestart. *)
Bounded == /\ delay = 0
           /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

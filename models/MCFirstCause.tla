---------------------------- MODULE MCFirstCause ----------------------------
(***************************************************************************)
(* A point of OB 10 passes in HOLD under a delay, so that a run is open    *)
(* [AMB-55]. OB 80 is deleted, and the next point is a time error, if the  *)
(* run waits: it stops the CPU. But the missing OB of another error        *)
(* stopped it before, under the same delay: the first cause stays          *)
(* (sections 4, 5.2 and 5.4).                                              *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 80}}
MCChangingObs == {80}
\* @type: Bool;
Holding == TRUE
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 1)]}
MCMoments == { Moment(m, 0) : m \in 0..2 }
MCPowerOnMoments == {Moment(0, 0)}
MCInterrupts == {<<82, 0>>}
MCRestartTypes == {"warm"}
MCRetVals == {1}

(* [AMB-44] (a) A missing OB is noticed under a delay, [AMB-49] (b) and    *)
(* the STOP waits for its end. MissingProp, which is of the defaults, is   *)
(* left out.                                                               *)
StopWaits == {[a \in {"AMB-44", "AMB-49"} |->
                 IF a = "AMB-44" THEN "a" ELSE "b"]}

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay <= 1
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

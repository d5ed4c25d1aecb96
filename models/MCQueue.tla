------------------------------- MODULE MCQueue ------------------------------
(***************************************************************************)
(* Two time-of-day OBs of one class wait for a hardware OB and for each    *)
(* other over several points: the order of start events, and the points    *)
(* kept of those that come while their OB runs (section 5.1).              *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10, 11}
MCFamilies == {"S7-300"}
MCLoads == {{10, 11, 40, 80, 85}}
MCStep7Settings ==
    {[o \in TodObs |-> Activated("minute", IF o = 10 THEN 1 ELSE 2)]}
MCMoments == { Moment(m, 0) : m \in 0..3 } \cup {Moment(0, 30000)}
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

Bounded == /\ delay = 0
           /\ Waiting(3)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

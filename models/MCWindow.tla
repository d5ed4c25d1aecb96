------------------------------ MODULE MCWindow ------------------------------
(***************************************************************************)
(* Dispatch without the order of classes, as inside the latency of a log   *)
(* (AMB-69): a lower class may start before a higher one that waits.  Even *)
(* so a late run comes after its OB 80 [TINT-15] [CLK-03].                 *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-400"}
MCLoads == {{10, 40, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)]}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(2, 0), Moment(2, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

\* @type: $request => Bool;
AnyOrder(r) == TRUE

Bounded == /\ delay <= 1
           /\ Waiting(2)
           /\ mode = "STOP" => clock = Moment(0, 30000)
=============================================================================

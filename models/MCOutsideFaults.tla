--------------------------- MODULE MCOutsideFaults ---------------------------
(***************************************************************************)
(* OB 80 with fault 05 or 06 for a cause outside the log, beside faults of *)
(* the clock and HOLD: only the latter name the late OBs (section 5.3).    *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 80}, {10}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 1)]}
MCMoments == {Moment(1, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(2, 30000)}
MCInterrupts == {<<80, SkippedByClock>>, <<80, SkippedInHold>>}
(* A fault of the world alone. *)
\* @type: Set(<<Int, Int>>);
TooLongACycle == {<<80, CycleTimeExceeded>>}
MCRestartTypes == {"warm"}
\* @type: Bool;
Holding == TRUE

Bounded == /\ delay = 0
           /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

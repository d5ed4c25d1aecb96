----------------------------- MODULE MCWithdrawn -----------------------------
(***************************************************************************)
(* Calls for interrupts whose start events wait or are over (sections 1.3, *)
(* 1.4 and 2.3): CAN_TINT beside a delay in the same class, CAN_DINT for   *)
(* an OB that has no delay, and calls for a one-shot interrupt that its    *)
(* clock has passed while its OB runs.                                     *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCDintObs == {20}
MCFamilies == {"S7-400"}
(* OB 10 and OB 20 share a class. *)
MCPriorities == {[o \in {10} |-> 3]}
MCLoads == {{10, 20, 40, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 1)]}
MCObNumbers == {10, 20, 80}
MCDtimes == {60000}
MCSigns == {1}
MCMoments == {Moment(1, 0), Moment(1, 30000)}
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>, <<80, 10>>}
MCRestartTypes == {"warm"}
MCRetVals == {OK, 1, BadOb, NotStarted}

(* A one-shot interrupt that runs for an earlier setting. *)
OnceFamilies == {"S7-300"}
OncePriorities == {[o \in {} |-> 0]}
OnceLoads == {{10, 80}}
OnceStep7Settings == {[o \in TodObs |-> Activated("once", 1)]}
OnceSdts == {Date(2)}
OnceWords == {Once}
OnceTargets == {Moment(3, 0)}
OnceNumbers == {10}
OnceRetVals == {OK, BadOb, NotSet, PastStart}

(* OB 40 runs alone, and what it holds back waits. *)
Bounded == /\ delay <= 1
           /\ Waiting(2)
           /\ DintObs = {} \/ Running.ob \notin TodObs \cup DintObs
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

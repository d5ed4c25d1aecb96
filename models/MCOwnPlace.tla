----------------------------- MODULE MCOwnPlace -----------------------------
(***************************************************************************)
(* Two time-of-day OBs wait behind a hardware OB for the same point, and   *)
(* the clock is set back: on an S7-300 the point comes again. A start      *)
(* event that comes again has a place of its own, although those of two    *)
(* OBs for one point share a place [OBS-02] [AMB-29].                      *)
(***************************************************************************)
EXTENDS MCBase, Inductive

MCTodObs == {10, 11}
MCFamilies == {"S7-300"}
MCLoads == {{10, 11, 40, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 1)]}
MCMoments == HalfMinutes(0, 1)
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ Waiting(3)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

---------------------------- MODULE MCRefineTod -----------------------------
(***************************************************************************)
(* System implements LifeCycle for OB 10 on an S7-300 and an S7-400: set,  *)
(* cancelled and activated at any time, once and every minute, blocked and *)
(* enabled, with the clock set forward and back, behind a hardware OB.     *)
(***************************************************************************)
EXTENDS MCBase, LifeMapping

MCTodObs == {10}
MCFamilies == TwoFamilies
MCLoads == {{10, 40, 80, 85}}
MCBlockable == {10}
MCIrtModes == {2}
MCStep7Settings == {[o \in TodObs |-> Activated("once", 0)]}
MCObNumbers == {10}
MCSdts == {Date(1)}
MCWords == {Once, Minutely}
(* Calls with an error change nothing: MCTod. *)
MCRetVals == {OK}
MCMoments == {Moment(1, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(0, 30000), Moment(1, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

(* OB 10 is missing, loaded and deleted, and there is HOLD. *)
MissingLoads == {{40, 80, 85}}
OneFamily == {"S7-300"}
ForwardTargets == {Moment(1, 30000)}
PossibleHold == TRUE

LifeVars == <<vars, past>>
LifeInit == Init /\ past = "none"
LifeNext == Next /\ past' = PastAfter
LifeSpec == LifeInit /\ [][LifeNext]_LifeVars

Life == INSTANCE LifeCycle WITH
            on      <- mode # "STOP",
            doomed  <- stopCause # NoCause,
            loaded  <- 10 \in loaded,
            setting <- Setting10,
            once    <- Once10,
            blocked <- Blocked(10),
            waiting <- Waiting10,
            perhaps <- OpenIn(requests, 10),
            running <- OnStack(10)

CycleSpec == Life!Spec

LifeView == <<cpuVars, past>>

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments /\ past = "none"
=============================================================================

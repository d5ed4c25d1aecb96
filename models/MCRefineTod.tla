---------------------------- MODULE MCRefineTod -----------------------------
(***************************************************************************)
(* System implements LifeCycle for OB 10 on an S7-300 and an S7-400: set,  *)
(* cancelled and activated at any time, once and every minute, blocked and *)
(* enabled, with the clock set forward and back, behind a hardware OB.     *)
(*                                                                         *)
(* `past' is history: an observer could keep it.                           *)
(***************************************************************************)
EXTENDS MCBase

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

VARIABLE
    \* @type: Str;
    past

LifeVars == <<vars, past>>

(* A start event of OB 10 occurs. *)
Occurs10 == \/ Did("reached") /\ step'.ob = 10
            \/ Did("clock") /\ mode # "STOP" /\ Skipped(10)

LifeInit == Init /\ past = "none"
LifeNext ==
    /\ Next
    /\ past' = IF Did("end") /\ step'.ob = 10 THEN "served"
               ELSE IF step'.event \in {"SET_TINT", "CAN_TINT"}
                       /\ PendingIn(requests, 10)
               THEN "cancelled"
               ELSE IF Occurs10 /\ Blocked(10) THEN "lost"
               ELSE IF step'.event \in {"stop", "switch"}
                       /\ (PendingIn(requests, 10) \/ OnStack(10))
               THEN "cleared"
               ELSE past
LifeSpec == LifeInit /\ [][LifeNext]_LifeVars

Life == INSTANCE LifeCycle WITH
            on      <- mode # "STOP",
            setting <- IF ~tod[10].set THEN "unset"
                       ELSE IF tod[10].called THEN "called"
                       ELSE IF tod[10].active THEN "active" ELSE "set",
            once    <- tod[10].set /\ tod[10].period = Once,
            blocked <- Blocked(10),
            waiting <- Cardinality({ r \in requests : r.ob = 10 /\ ~r.open }),
            perhaps <- OpenIn(requests, 10),
            running <- OnStack(10)

CycleSpec == Life!Spec

LifeView == <<cpuVars, past>>

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments /\ past = "none"
=============================================================================

--------------------------------- MODULE MCAll --------------------------------
(***************************************************************************)
(* Everything at once: two time-of-day OBs, one of them missing, a delay   *)
(* OB, a hardware OB, SFC 39/40, delays nested three deep, the clock set   *)
(* forward and back, STOP and restart.                                     *)
(*                                                                         *)
(* Bounded: `spent' counts the interventions of program and world;         *)
(* behaviours with more than Budget of them are left out. Steps of the CPU *)
(* itself are not bounded. SFC 41/42 are not counted, but only OB 40 calls *)
(* them, up to three calls deep.                                           *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10, 11}
MCDintObs == {20}
MCBlockable == {10, 11, 20, 40, 80, 85}
MCFamilies == TwoFamilies
MCLoads == {{10, 20, 40, 80, 85}}
MCStep7Settings ==
    {[o \in TodObs |-> IF o = 10 THEN Activated("minute", 1)
                                 ELSE Activated("once", 1)]}
MCObNumbers == {10, 20}
MCDtimes == {30000}
MCSigns == {1}
MCIrtModes == {0, 2}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(0, 30000), Moment(2, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}
AllRetVals == {0, 1, 2, 3, NotSet, NotDelayed}

VARIABLE
    \* @type: Int;
    spent

Budget == 2

Interventions == {"CAN_TINT", "ACT_TINT", "SRT_DINT", "CAN_DINT", "DIS_IRT",
                  "EN_IRT", "interrupt", "clock", "switch"}

BudgetInit == Init /\ spent = 0
BudgetNext ==
    /\ Next
    /\ step'.event \in {"DIS_AIRT", "EN_AIRT"} => Running.ob = 40
    /\ spent' = IF step'.event \in Interventions THEN spent + 1 ELSE spent
BudgetSpec == BudgetInit /\ [][BudgetNext]_<<vars, spent>>

BudgetView == <<cpuVars, spent>>

Bounded == spent <= Budget /\ delay <= 3
=============================================================================

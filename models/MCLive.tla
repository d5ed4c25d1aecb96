------------------------------- MODULE MCLive -------------------------------
(***************************************************************************)
(* Liveness on an S7-300 and an S7-400: points of every minute, a hardware *)
(* OB, delays of SFC 41, the clock set forward and back, STOP and restart; *)
(* and a delay interrupt in their place; and two hardware interrupts under *)
(* delays that nest.                                                       *)
(*                                                                         *)
(* There is no constraint: it would hide behaviours in which an event      *)
(* never comes. The world is finite by itself: the clock ends at the       *)
(* last moment, programs nest two delays, and `budget' limits the events   *)
(* from outside. There is no view either, though no property depends on    *)
(* `step'.                                                                 *)
(***************************************************************************)
EXTENDS MCBase, Liveness

MCTodObs == {10}
MCFamilies == TwoFamilies
MCLoads == {{10, 40, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 1)]}
MCMoments == {Moment(1, 0), Moment(2, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(2, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}
(* DIS_AIRT answers at most 2. *)
MCRetVals == {0, 1, 2}

(* `live-delay': a delay that the program starts and cancels. *)
MCDintObs == {20}
DelayLoads == {{20, 40, 80, 85}}
DelayStep7 == {[o \in TodObs |-> NotConfigured]}
DelayDtimes == {30000}
DelaySigns == {1}
DelayMoments == HalfMinutes(1, 1)
DelayRetVals == {OK}
OneFamily == {"S7-300"}

(* `live-released': DIS_AIRT answers at most 3. *)
NestedInterrupts == {<<40, 0>>, <<82, 0>>}
NestedLoads == {{40, 80, 82, 85}}
NestedMoments == {Moment(0, 30000)}
NestedRetVals == 0..3

MCBudget == 2
TwoEvents == 2
(* Enough for the negative controls. `live-point' has it, too: its         *)
(* states are those of `live', and a second event, for which TLC takes     *)
(* longer than for any other model, is left to the full lane.              *)
OneEvent == 1

VARIABLE
    (* How many more interrupts, settings of the clock and STOPs there may  *)
    (* be.                                                                  *)
    \* @type: Int;
    budget

liveVars == <<vars, budget>>

Taken == IF Did("interrupt") \/ Did("clock") \/ Did("switch") THEN 1 ELSE 0

LiveInit == Init /\ budget = MCBudget
LiveNext == /\ Next
            /\ budget' = budget - Taken
            /\ budget' >= 0

(* [DINT-03] [DINT-10] A delay that is over may end, also in its own OB.   *)
MayEndInv ==
    \A o \in Jobs : Settled /\ dint[o].left <= 1 => ENABLED DelayElapses(o)

(* For properties that need all of Fairness, fairness of the CPU and its   *)
(* programs, or of dispatch alone.                                         *)
LiveSpec     == LiveInit /\ [][LiveNext]_liveVars /\ Fairness
CpuSpec      == LiveInit /\ [][LiveNext]_liveVars /\ CpuFairness
DispatchSpec == LiveInit /\ [][LiveNext]_liveVars /\ DispatchFairness
=============================================================================

---------------------------- MODULE MCClockBack -----------------------------
(***************************************************************************)
(* No start point is served twice on an S7-400 or CPU 318, however the     *)
(* clock is set back and forward [CLK-09].  The history `served' notes for *)
(* which points an OB was definitely requested, until a restart.           *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-400"}
MCLoads == {{10, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)]}
MCMoments == HalfMinutes(0, 3)
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(0, 30000), Moment(1, 0), Moment(2, 30000)}
MCRestartTypes == {"warm"}

VARIABLE
    \* @type: Set($moment);
    served

New == { r.since : r \in { q \in NewOf(10) : ~q.open } }

HistoryInit == Init /\ served = {}
HistoryNext ==
    /\ Next
    /\ served' = IF Did("restart") THEN {}
                 ELSE IF step'.event \in {"reached", "clock"}
                 THEN served \cup New ELSE served
HistorySpec == HistoryInit /\ [][HistoryNext]_<<vars, served>>

NoRepeatProp ==
    [][ step'.event \in {"reached", "clock"}
          => New \cap served = {} ]_<<vars, served>>

HistoryView == <<cpuVars, served>>

(* A stop ends the search: served points are forgotten then. *)
Bounded == /\ delay = 0
           /\ Waiting(3)
           /\ mode = "STOP" => clock \in PowerOnMoments /\ served = {}
=============================================================================

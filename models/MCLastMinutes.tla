----------------------------- MODULE MCLastMinutes ---------------------------
(***************************************************************************)
(* Interrupts of every PERIOD that are set and activated in the last       *)
(* minutes of 2089, and a clock that is set there: the last points of the  *)
(* series, and that none is left (sections 1.1 and 6).                     *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 80}}
LoadsWithoutTod == {{80}}
MCStep7Settings == {[o \in TodObs |-> NotConfigured]}
MCObNumbers == {10}
\* @type: (Int, Int) => $date;
LateDate(day, minute) ==
    [ year |-> 2089, month |-> 12, day |-> day, hour |-> 23,
      minute |-> minute, second |-> 0, ms |-> 0 ]
MCSdts == {LateDate(28, 58), LateDate(31, 58), LateDate(31, 59)}
MCWords == PeriodCodes
MCRetVals == {OK}
AllRetVals == {OK, BadSdt, BadPeriod, NotSet, PastStart}
LeapDay == {[LateDate(29, 58) EXCEPT !.year = 2088, !.month = 2]}
LastOfFebruary == { [LateDate(29, 58) EXCEPT !.year = year, !.month = 2]
                    : year \in {2088, 2089} }
\* @type: (Int, Int) => $moment;
Late(m, ms) == [min |-> LastMinute + m, ms |-> ms]
MCMoments == { Late(m, ms) : m \in {-1, 0}, ms \in {0, 30000} }
MCPowerOnMoments == {Late(-2, 30000)}
MCClockTargets == {Late(-1, 0), Late(0, 30000)}
MCRestartTypes == {"warm"}

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

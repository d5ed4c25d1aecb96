------------------------------ MODULE MCCatchUps ------------------------------
(***************************************************************************)
(* A clock set forward, or HOLD, skips points of two time-of-day OBs: OB   *)
(* 80 reports both, and their catch-ups come in any order [AMB-54].        *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10, 11}
MCFamilies == {"S7-300"}
MCLoads == {{10, 11, 80}}
MCStep7Settings ==
    {[o \in TodObs |-> Activated("minute", IF o = 10 THEN 1 ELSE 2)]}
MCMoments == { Moment(m, 0) : m \in 1..4 }
MCPowerOnMoments == {Moment(0, 30000)}
(* Runs that are deferred in STARTUP are of start events without an order. *)
MCClockTargets == IF mode = "STARTUP" THEN {} ELSE {Moment(4, 0)}
(* The clock is set back in HOLD: on an S7-300 points come again.          *)
BackInHold == IF mode = "HOLD" THEN MCPowerOnMoments ELSE {}
MCRestartTypes == {"warm"}
\* @type: Bool;
Holding == TRUE

(* Two of three OBs have one point. *)
ThreeTodObs == {10, 11, 12}
ThreeLoads == {{10, 11, 12, 80}}
TwoTogether ==
    {[o \in TodObs |-> Activated("minute", IF o = 12 THEN 2 ELSE 1)]}

(* Calls of SFC 39 and 40 for an OB. *)
OfAnOb == {2}
JustOK == {OK}

(* A skipped OB, or the OB 80 that is to report it, is blocked. *)
RemembersServed == {"S7-400"}
SkippedAndError == {10, 80}
FewMoments == {Moment(1, 0), Moment(4, 0)}
OneWaits == /\ delay = 0
            /\ Waiting(1)
            /\ mode = "STOP" => clock \in PowerOnMoments

Bounded == /\ delay = 0
           /\ Waiting(3)
           /\ mode = "STOP" => clock \in PowerOnMoments
LastMoment == {Moment(4, 0)}
NoStop == /\ delay = 0
          /\ Waiting(3)
          /\ mode = "STOP" => step.event = "power on"
=============================================================================

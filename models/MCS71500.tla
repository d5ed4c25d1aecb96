------------------------------ MODULE MCS71500 ------------------------------
(***************************************************************************)
(* An S7-1500: a minute interrupt whose clock is set by 10 s, 20 s and     *)
(* more, forward and back; a hardware interrupt above OB 80; OB 80 loaded  *)
(* or missing; STARTUP, HOLD.                                              *)
(***************************************************************************)
EXTENDS MCBase, PropertiesS71500

MCTodObs == {10}
(* In its place where two interrupts are skipped. *)
TwoTodObs == {10, 11}
MCFamilies == {"S7-1500"}
MCLoads == {{10, 11, 40, 80, 82, 100}}
(* In its place: OB 80 and others may be missing. *)
FewLoads == MCLoads \cup {{10, 11, 40}}
MCStep7Settings ==
    { [ o \in TodObs |-> IF o = 10 THEN Activated("minute", 0)
                         ELSE Activated("once", 1) ] }
MCPriorities == { [o \in {40} |-> 23] }
MCMoments == { Moment(0, 30000), Moment(0, 55000), Moment(1, 0),
               Moment(1, 5000), Moment(1, 15000) }
MCPowerOnMoments == {Moment(0, 55000)}
MCClockTargets == { Moment(0, 30000), Moment(0, 55000), Moment(1, 5000),
                    Moment(1, 15000) }
MCInterrupts == {<<40, 0>>, <<82, 0>>, <<80, 1>>, <<121, 0>>, <<122, 0>>}
MCRestartTypes == {"warm", "cold"}
FarMoments == {Moment(0, 30000), Moment(1, 0), Moment(1, 15000)}
FarTargets == {Moment(0, 30000), Moment(1, 15000)}
JustWarm == {"warm"}
MayBeHeld == TRUE
NestedRetVals == {0, 1, 2, NotDelayed}
JustOb40 == {<<40, 0>>}
NothingSet == {[o \in TodObs |-> NotConfigured]}

Bounded == /\ delay = 0
           /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments

(* In its place where SFC 41 and 42 are called. *)
Nested == /\ delay <= 2
          /\ Waiting(2)
          /\ mode = "STOP" => clock \in PowerOnMoments
(* In their place where local time is 61 minutes ahead. The starts are     *)
(* 06:01, and 07:02, which is 06:01 where it is local time.                *)
ClockAndLocal == {0, 61}
LocalSdts == {Date(1), [Date(2) EXCEPT !.hour = 7]}
LocalPeriods == {Once, Daily, EndOfMonth}
LocalMoments == {Moment(0, 55000), Moment(1, 0), Moment(1, 15000)}
JustOb10 == {10}
LocalRetVals == {OK, PastStart, NotSet}
(* In their place where points pass in STOP. *)
StopMoments == {Moment(0, 30000), Moment(1, 0), Moment(1, 5000)}
StopTargets == {Moment(0, 30000), Moment(0, 55000)}
AnyStop == delay = 0 /\ Waiting(2)
=============================================================================

--------------------------- MODULE MCRefineEvents ---------------------------
(***************************************************************************)
(* System implements Conservation for the start events of a time-of-day    *)
(* OB, a hardware OB and OB 80 on an S7-300 and an S7-400, with DIS_IRT,   *)
(* CAN_TINT, the clock set forward, and STOP.                              *)
(***************************************************************************)
EXTENDS MCBase, FatesMapping

MCTodObs == {10}
MCFamilies == TwoFamilies
MCLoads == {{10, 40, 80, 85}}
MCBlockable == {10, 40}
MCIrtModes == {0}
MCStep7Settings == { [o \in TodObs |-> Activated("minute", 1)],
                     [o \in TodObs |-> Activated("once", 0)] }
MCObNumbers == {0, 10}
(* Calls with an error change nothing: MCTod. *)
MCRetVals == {OK}
MCMoments == {Moment(1, 0), Moment(2, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(2, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

MCCountedObs == {10, 40, 80}

(* OB 10 or OB 80 is missing, OB 40 is deleted and loaded, there is HOLD.  *)
MissingLoads == {{40, 80, 85}, {10, 40, 85}}
DeletedObs == {40}
OneFamily == {"S7-300"}
OneSetting == {[o \in TodObs |-> Activated("minute", 1)]}
PossibleHold == TRUE
AllCountedObs == {10, 40, 80, 85}

(* [IRT-09] OB 80 is blocked without entries; two OBs of one class, whose   *)
(* buffer may overflow then.                                               *)
SilentModes == {\h82}
OneClass == {[o \in {41} |-> 16]}
OnlyS7400 == {"S7-400"}
OneClassLoads == {{40, 41, 80, 85}}
NoSetting10 == {[o \in TodObs |-> NotConfigured]}
TimeErrorAlone == {80}
TwoInterrupts == {<<40, 0>>, <<41, 0>>}
TwoCountedObs == {40, 41}

EventsInit == /\ Init
              /\ occurred = NoneYet /\ served = NoneYet /\ lost = NoneYet
              /\ missed = NoneYet /\ withdrawn = NoneYet
              /\ cleared = NoneYet
EventsNext == Next /\ HistoryCounts
EventsSpec == EventsInit /\ [][EventsNext]_<<vars, history>>

Events == INSTANCE Conservation WITH Obs <- CountedObs, fates <- AllFates

ConservationSpec == Events!Spec

EventsView == <<cpuVars, history>>

(* At most two start events, OB 80 not counted; nothing after a STOP. *)
Bounded == /\ occurred[10] + occurred[40] <= 2
           /\ mode = "STOP" => clock \in PowerOnMoments /\ occurred = NoneYet

(* The full lane: three. *)
Wide == /\ occurred[10] + occurred[40] <= 3
        /\ mode = "STOP" => clock \in PowerOnMoments /\ occurred = NoneYet

(* Of two OBs of one class. *)
BoundedOfOneClass ==
    /\ occurred[40] + occurred[41] <= 2
    /\ mode = "STOP" => clock \in PowerOnMoments /\ occurred = NoneYet
=============================================================================

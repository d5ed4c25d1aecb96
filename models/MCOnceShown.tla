------------------------------ MODULE MCOnceShown ----------------------------
(***************************************************************************)
(* On an S7-400 the clock passes the new point of a one-shot interrupt     *)
(* while its OB runs for an earlier setting, so that the catch-up may      *)
(* merge [AMB-52]. Then the clock is set back before the point: the CPU    *)
(* has to show whether it is over [AMB-56] (sections 1 and 6).             *)
(***************************************************************************)
EXTENDS MCBase, Inductive

MCTodObs == {10}
MCFamilies == {"S7-400"}
MCLoads == {{10, 80}}
MCStep7Settings == {[o \in TodObs |-> Activated("once", 1)]}
MCObNumbers == {10}
MCSdts == {Date(2)}
MCWords == {Once}
MCMoments == {Moment(1, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
(* Behaviours in STARTUP are left to MCRestart. *)
MCClockTargets == IF mode = "RUN" THEN {Moment(1, 30000), Moment(3, 0)}
                  ELSE {}
MCRestartTypes == {"warm"}
MCRetVals == {OK, NotSet}

(* In their places where calls and STOP take a run away. OB 10 may be      *)
(* missing, which takes none away.                                         *)
EachMinuteOrOnce ==
    {[o \in TodObs |-> Activated("minute", 0)]} \cup MCStep7Settings
WithOrWithoutOb10 == {{10, 80}, {80, 85}}
JustMinutely == {Minutely}
OverOnePoint == IF mode = "RUN" THEN {Moment(1, 30000)} ELSE {}
WithOb80 == delay = 0 /\ Cardinality(requests) <= 2

(* Points pass while OB 10 waits under a delay: their calls may merge.     *)
JustEachMinute == {[o \in TodObs |-> Activated("minute", 0)]}
ThreeMoments == {Moment(1, 0), Moment(2, 0), Moment(3, 0)}
CountRetVals == {0, 1}
UnderDelay == /\ delay <= 1 /\ Cardinality({ r \in requests : r.ob = 10 }) <= 3

(* Also after a STOP; the clock is set at most twice. *)
Anywhere == delay = 0 /\ Waiting(1)

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay = 0
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

------------------------------- MODULE MCHold -------------------------------
(***************************************************************************)
(* HOLD and release, with points that pass meanwhile and the clock set in  *)
(* HOLD (section 5.4).                                                     *)
(***************************************************************************)
EXTENDS MCBase, Inductive

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 40, 80, 85}, {10, 40, 85}}
LoadsWithoutTod == {{40, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)]}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(2, 0)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

(* [AMB-83] Back before the point that passed. *)
BackTargets == {Moment(0, 30000)}
(* [AMB-84] Errors whose OBs are missing. *)
MissingErrors == {<<80, 1>>, <<82, 0>>, <<85, \hA3>>}
LoadsWithoutErrors == {{10, 40}}
HardwareAndTimeErrors == {<<40, 0>>, <<80, 1>>}
JustTheirObs == {{40, 80}}
OneMoment == {Moment(0, 30000)}
LoadsWithTod == {{10, 80}}
(* A program error in STARTUP, RUN and HOLD. *)
ProgramErrors == {<<85, 8>>}
LoadsWithStartup == {{80, 85, 100}}
TwoWait == delay <= 1 /\ Waiting(2)
NothingSet == {[o \in TodObs |-> NotConfigured]}

\* @type: Bool;
Holding == TRUE

Bounded == /\ delay <= 1
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

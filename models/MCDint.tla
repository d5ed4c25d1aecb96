-------------------------------- MODULE MCDint --------------------------------
(***************************************************************************)
(* SRT, CAN and QRY_DINT with right and wrong operands, delays that elapse *)
(* while the OB waits, runs, is missing, in STARTUP and around HOLD, with  *)
(* a clock that is set meanwhile (section 2).                              *)
(***************************************************************************)
EXTENDS MCBase, Inductive

MCTodObs == {10}
MCDintObs == {20}
MCFamilies == {"S7-300"}
MCLoads == {{20, 40, 80, 85, 100}, {20, 40}}
MCStep7Settings == {[o \in TodObs |-> NotConfigured]}
MCObNumbers == {20, 99}
MCDtimes == {0, 30000, 60001}
MCSigns == {1, 2}
MCMoments == {Moment(0, 0), Moment(0, 29999), Moment(0, 30000), Moment(1, 0)}
MCPowerOnMoments == {Moment(0, 0)}
MCClockTargets == {Moment(1, 0)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

\* @type: Bool;
Holding == TRUE

(* Also STATUS words with bit 5. *)
AllStatusWords == {0, 4, 16, 20, 32, 36, 48, 52}

LoadsWithoutDint == {{40, 80, 85, 100}}
LoadsWithoutBoth == {{40, 80, 100}}
LoadsWithoutTimeError == {{20, 40, 85, 100}}

(* DIS_IRT of one OB: OB 20, or an error OB, too. *)
OfAnOb == {2}
DelayAndTimeError == {20, 80}
DelayAndProgramError == {20, 85}

(* DIS_IRT of everything blocks OB 85. *)
Ob85Alone == {85}
ModesOfAll == {0, 128}

(* Two delays, which may end together. *)
TwoDintObs == {20, 21}
TwoLoads == {{20, 21, 80}}
OneDtime == {30000}
OneSign == {1}
TwoEnds == {Moment(0, 30000), Moment(1, 0)}
(* [OBS-05] The class of one of them is set. *)
SettableFamily == {"S7-400"}
ClassOfOne == {[o \in {20} |-> 9]}
JustOK == {OK}
TogetherBounded == /\ delay = 0
                   /\ Waiting(2)
                   /\ mode = "STOP" => clock \in PowerOnMoments

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay = 0
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

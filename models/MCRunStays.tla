----------------------------- MODULE MCRunStays -----------------------------
(***************************************************************************)
(* SFC 28 and SFC 29 leave the run of an earlier setting that waits, by    *)
(* the reading (a) of AMB-11 (section 1). A one-shot interrupt is set anew *)
(* while its OB waits: the new setting is activated by its own start       *)
(* alone.                                                                  *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 80}}
MCReadingSets == { [a \in {"AMB-11"} |-> "a"] }
MCStep7Settings == {[o \in TodObs |-> Activated("once", 1)]}
MCObNumbers == {10}
MCSdts == {Date(2)}
MCWords == {Once}
MCMoments == {Moment(1, 0), Moment(2, 0), Moment(2, 30000)}
MCPowerOnMoments == {Moment(0, 30000)}
MCRestartTypes == {"warm"}
MCRetVals == {OK, 1, NotSet, PastStart, NotDelayed}

(* [AMB-11] (a) A call that sets or cancels withdraws nothing. *)
RunStaysProp ==
    [][ step'.event \in {"SET_TINT", "CAN_TINT"} => requests' = requests ]_vars

(* [TINT-61] [TINT-37] SFC 30 answers for the new setting: the run that    *)
(* waits is of an earlier one.                                             *)
OwnStartProp ==
    [][ Did("ACT_TINT") /\ tod[step'.ob].set /\ ~tod[step'.ob].active =>
          step'.value = IF Before(At(tod[step'.ob].start), clock)
                        THEN PastStart ELSE OK ]_vars

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay <= 1
           /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments
=============================================================================

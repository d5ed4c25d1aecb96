------------------------------- MODULE APAirt -------------------------------
(***************************************************************************)
(* The world of MCAirt for Apalache: a bounded check of StackInv [OBS-01]  *)
(* and AirtInv [AIRT-12], not a proof.                                     *)
(* Its next-state relation leaves out what the model's bounds exclude in   *)
(* MCAirt (SFC 28-31, clock set, HOLD, load), since Apalache unfolds every *)
(* action before it sees that nothing can take it.                         *)
(* models/apalache.sh check                                                *)
(***************************************************************************)
EXTENDS MCBase

APTodObs == {10}
APFamilies == {"S7-300"}
\* @type: Set(Set(Int));
APLoads == {{10, 40, 80, 85, 100}}
APStep7Settings == {[o \in TodObs |-> Activated("minute", 0)]}
APMoments == HalfMinutes(0, 2)
APPowerOnMoments == {Moment(0, 30000)}
\* @type: Set(<<Int, Int>>);
APInterrupts == {<<40, 0>>}
APRestartTypes == {"warm"}

APNext ==
    \/ Respond
    \/ /\ ~Pressing
       /\ \/ \E ret \in AirtRetVals :
               \/ DisAirt(ret) /\ Seen("DIS_AIRT", 0, ret)
               \/ EnAirt(ret) /\ Seen("EN_AIRT", 0, ret)
          \/ Proceed
          \/ Interrupt(40, 0) /\ Seen("interrupt", 40, 0)
          \/ Restart("warm") /\ Seen("restart", 0, 0)
          \/ Time
=============================================================================

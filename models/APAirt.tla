------------------------------- MODULE APAirt -------------------------------
(***************************************************************************)
(* The world of MCAirt for Apalache: a bounded check of StackInv [OBS-01]  *)
(* and AirtInv [AIRT-12], not a proof.                                     *)
(* apalache-mc check --config=models/APAirt.cfg --length=6                 *)
(*   --inv=StackInv models/APAirt.tla      (models/apalache.sh check)      *)
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
=============================================================================

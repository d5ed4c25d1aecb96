--------------------------- MODULE PropertiesAirt ---------------------------
(***************************************************************************)
(* SFC 41/42 (section 4).                                                  *)
(*                                                                         *)
(* Left out: the order of starts after a delay (PropertiesObs).            *)
(***************************************************************************)
EXTENDS Steps

(* [AIRT-12] A delay belongs to a running OB, or lasts over cycles [AMB-25]. *)
AirtInv == delay > 0 => stack # <<>> \/ CountOutlivesTheCycle

(* [AIRT-04] The end of an OB ends its delay. [OBS-62] That of an error OB *)
(* does not end the delay of the OB below.                                 *)
AirtEndProp ==
    [][ Did("end") =>
          IF step'.ob \in SyncErrorObs THEN delay' = delay
          ELSE \/ delay' = 0
               \/ CountOutlivesTheCycle /\ step'.ob = CycleOb ]_vars

(* [AIRT-01] [AIRT-09] Nothing starts while a delay is on, no OB 80 either. *)
AirtHoldsProp == [][Dispatched => delay = 0]_vars

(* [AIRT-02] A delay loses nothing: requests leave only by a start, a      *)
(* missing OB, a withdrawal, or a STOP.                                    *)
AirtKeepsProp ==
    [][ \/ Did("end") /\ step'.ob # ProgramErrorOb
        \/ step'.event \in {"DIS_AIRT", "EN_AIRT", "DIS_IRT", "EN_IRT",
                            "QRY_TINT", "QRY_DINT", "ACT_TINT", "time",
                            "reached", "elapsed", "interrupt", "clock",
                            "hold", "release", "load", "run"}
          => \A r \in requests : ~r.open =>
               \E q \in requests' : Content(q) = Content(r) /\ ~q.open ]_vars

(* [AIRT-03] [AIRT-05] [AIRT-06] [AIRT-07] Counting: a call of EN_AIRT     *)
(* takes one call of DIS_AIRT back, whatever block of the OB made it.      *)
AirtCountProp ==
    [][ /\ Did("DIS_AIRT") => delay' = delay + 1 /\ step'.value = delay'
        /\ Did("EN_AIRT") =>
             IF delay = 0 THEN step'.value = \h8080 /\ delay' = 0
             ELSE delay' = delay - 1 /\ step'.value = delay'
        /\ delay' > delay => Did("DIS_AIRT") ]_vars
=============================================================================

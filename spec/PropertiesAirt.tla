--------------------------- MODULE PropertiesAirt ---------------------------
(***************************************************************************)
(* SFC 41/42 (section 4).                                                  *)
(*                                                                         *)
(* Left out: the order of starts after a delay (PropertiesObs).            *)
(***************************************************************************)
EXTENDS Steps

(* [AIRT-12] A delay belongs to a running OB. *)
AirtInv == delay > 0 => stack # <<>>

(* [AIRT-04] The end of an OB ends its delay. *)
AirtEndProp == [][Did("end") => delay' = 0]_vars

(* [AIRT-01] Nothing starts while a delay is on. *)
AirtHoldsProp == [][Dispatched => delay = 0]_vars

(* [AIRT-02] A delay loses nothing: requests leave only by a start, a       *)
(* missing OB, a withdrawal, or the end of all.                            *)
AirtKeepsProp ==
    [][ \/ Did("end") /\ step'.ob # ProgramErrorOb
        \/ step'.event \in {"DIS_AIRT", "EN_AIRT", "time", "interrupt",
                         "QRY_TINT", "ACT_TINT"}
          => { r \in requests : ~r.open } \subseteq requests' ]_vars

(* [AIRT-03] [AIRT-06] [AIRT-07] Counting. *)
AirtCountProp ==
    [][ /\ Did("DIS_AIRT") => delay' = delay + 1 /\ step'.value = delay'
        /\ Did("EN_AIRT") =>
             IF delay = 0 THEN step'.value = \h8080 /\ delay' = 0
             ELSE delay' = delay - 1 /\ step'.value = delay'
        /\ delay' > delay => Did("DIS_AIRT") ]_vars
=============================================================================

------------------------------ MODULE APS71500 ------------------------------
(***************************************************************************)
(* The counting of SFC 41 and 42 on an S7-1500 [T15-50] [T15-51] [T15-55], *)
(* for Apalache: one step of System from ANY state in which the invariant  *)
(* holds, in the world of APSystem.                                        *)
(*                                                                         *)
(* Classes are any that can be set [T15-60] [T15-62]. Open questions are   *)
(* read by default, those of the family by its letters.                    *)
(* Left out: OBs from 123 on, queues whose parameters are known, local     *)
(* time; and what is not about delays, which TLC checks in models of the   *)
(* family.                                                                 *)
(***************************************************************************)
EXTENDS APSystem

NewerAmbiguities == { "AMB-11", "AMB-27", "AMB-55", "AMB-56", "AMB-57",
                      "AMB-65", "A15-04" }

(* [T15-120] Points that passed in STOP may be due. *)
MayBeDue == BOOLEAN

NewerCpu ==
    \E set \in SUBSET {10, 11, 20, 21, 40}, c, d, e, f, g \in Nat,
       x, y \in Executions, s, t \in Nat, a, b \in BOOLEAN,
       shown \in SUBSET {"AMB-11", "AMB-57", "A15-04"},
       u \in {"b", "c"}, v, w \in {"a", "b"} :
      /\ s <= LastMinute /\ t <= LastMinute
      /\ c \in 2..24 /\ d \in 2..24 /\ e \in 2..24 /\ f \in 2..24
      /\ g \in 2..26
      /\ AnyCpu =
           [ family |-> "S7-1500",
             priority |->
               [ o \in set |-> IF o = 10 THEN c ELSE IF o = 11 THEN d
                               ELSE IF o = 20 THEN e ELSE IF o = 21 THEN f
                               ELSE g ],
             step7 |-> [ o \in TodObs |->
                           IF o = 10 THEN Setting(x, s, a, FALSE)
                                     ELSE Setting(y, t, b, FALSE) ],
             readings |-> [ r \in shown \cup {"AMB-27", "AMB-55", "AMB-56",
                                              "AMB-65"} |->
                              CASE r = "AMB-11" -> u
                                [] r = "AMB-57" -> v
                                [] r = "A15-04" -> w
                                [] r = "AMB-65" -> "b"
                                [] OTHER        -> "a" ],
             classes |-> [o \in {} |-> 0],
             queues |-> [o \in {} |-> [size |-> 1, limit |-> 0, told |-> 0]],
             zone |-> 0, hour |-> NoHour ]
=============================================================================

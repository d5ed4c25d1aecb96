---------------------------- MODULE MCFatesAlone ---------------------------
(***************************************************************************)
(* Conservation by itself, with two OBs and two start events in all: every *)
(* step from every state. System refines Conservation (MCRefineEvents),    *)
(* but Conservation allows more than System. This model checks all that it *)
(* allows.                                                                 *)
(***************************************************************************)
EXTENDS Conservation

Most == 2

WithAnother(s) ==
    s \cup { [f EXCEPT ![o] = OneMore(f[o], g)]
             : f \in s, o \in Obs, g \in Fates }
Nobody == [o \in Obs |-> [f \in Fates |-> 0]]
AllFates == WithAnother(WithAnother({Nobody}))

(* Conservation leaves open some next states: each is tried.               *)
AnyNext == /\ fates' \in AllFates
           /\ occurred' \in [Obs -> 0..Most]
           /\ Next

AloneSpec == Init /\ [][AnyNext]_tokenVars

Changes(o, f) == fates'[o][f] - fates[o][f]

(* A fate at its end stays. *)
Over == {"served", "lost", "withdrawn", "cleared", "merged"}
OverProp == [][ \A o \in Obs, f \in Over : Changes(o, f) >= 0 ]_tokenVars

(* Only a running start event is served. *)
ServedProp ==
    [][ \A o \in Obs :
          Changes(o, "served") > 0 =>
            Changes(o, "running") = -Changes(o, "served") ]_tokenVars

(* Only a waiting or open start event runs, one at a time. *)
RunsProp ==
    [][ \A o \in Obs :
          Changes(o, "running") > 0 =>
            /\ Changes(o, "running") = 1
            /\ Changes(o, "waiting") + Changes(o, "open") < 0 ]_tokenVars

(* A lost start event never waited: DIS_IRT takes nothing back [IRT-16]. *)
LostProp ==
    [][ \A o \in Obs :
          Changes(o, "lost") > 0 => occurred'[o] > occurred[o] ]_tokenVars

(* At most two start events of an OB at a time, and none disappears.       *)
OccurProp == [][ \A o \in Obs : occurred'[o] - occurred[o] \in 0..2 ]_tokenVars
=============================================================================

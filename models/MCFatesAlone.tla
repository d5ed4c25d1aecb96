---------------------------- MODULE MCFatesAlone ---------------------------
(***************************************************************************)
(* Conservation by itself, with two OBs and two start events in all, or    *)
(* with one OB and four: every step from every state. System refines       *)
(* Conservation (MCRefineEvents), but Conservation allows more than        *)
(* System. This model checks all that it allows.                           *)
(***************************************************************************)
EXTENDS Conservation

CONSTANT
    (* Start events in all. *)
    \* @type: Int;
    Most

WithAnother(s) ==
    s \cup { [f EXCEPT ![o][g] = @ + 1]
             : f \in s, o \in Obs, g \in Fates }
Nobody == [o \in Obs |-> [f \in Fates |-> 0]]
UpTo[n \in 0..Most] == IF n = 0 THEN {Nobody} ELSE WithAnother(UpTo[n - 1])
AllFates == UpTo[Most]

(* Conservation leaves open some next states: each is tried.               *)
AnyNext == /\ fates' \in AllFates
           /\ occurred' \in [Obs -> 0..Most]
           /\ Next

AloneSpec == Init /\ [][AnyNext]_tokenVars

(* A fate at its end stays. *)
Over == {"served", "lost", "missed", "withdrawn", "cleared", "merged"}
OverProp == [][ \A o \in Obs, f \in Over : Change(o, f) >= 0 ]_tokenVars

(* Only a running start event is served. *)
ServedProp ==
    [][ \A o \in Obs :
          Change(o, "served") > 0 =>
            Change(o, "running") = -Change(o, "served") ]_tokenVars

(* Only a waiting or open start event runs, one at a time. *)
RunsProp ==
    [][ \A o \in Obs :
          Change(o, "running") > 0 =>
            /\ Change(o, "running") = 1
            /\ Change(o, "waiting") + Change(o, "open") < 0 ]_tokenVars

(* A missing OB was to run, or an error without its OB occurs [OBS-20].    *)
MissedProp ==
    [][ \A o \in Obs :
          Change(o, "missed") > 0 =>
            \/ occurred'[o] > occurred[o]
            \/ Change(o, "waiting") + Change(o, "open") < 0 ]_tokenVars

(* An open start event never waited before, but for an OB that another may *)
(* have reported [AMB-45].                                                 *)
OpenProp ==
    [][ \A o \in Obs :
          Change(o, "open") > 0 =>
            \/ occurred'[o] > occurred[o]
            \/ \E p \in Obs : Change(p, "served") > 0 ]_tokenVars

(* A lost start event never waited: DIS_IRT takes nothing back [IRT-16]. *)
LostProp ==
    [][ \A o \in Obs :
          Change(o, "lost") > 0 => occurred'[o] > occurred[o] ]_tokenVars

(* At most three start events of an OB at a time, and none disappears.     *)
OccurProp == [][ \A o \in Obs : occurred'[o] - occurred[o] \in 0..3 ]_tokenVars
=============================================================================

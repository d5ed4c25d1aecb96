----------------------------- MODULE Properties -----------------------------
(***************************************************************************)
(* The properties of the system, of states (...Inv) and of steps           *)
(* (...Prop), in other terms than those of the actions. A property of      *)
(* steps speaks of `step', as an observer sees it, and of the states       *)
(* around it.                                                              *)
(*                                                                         *)
(* models/ checks them. For each guard of an action and for each rule a    *)
(* negative control violates one of them.                                  *)
(* Left out: liveness (Liveness).                                          *)
(* Source: requirements, sections 1 to 6.                                  *)
(***************************************************************************)
EXTENDS PropertiesObs, PropertiesAirt, PropertiesModes, PropertiesTod,
        PropertiesClock, PropertiesDint, PropertiesIrt

\* @type: $moment => Bool;
IsMoment(t) == t.min \in 0..LastMinute /\ t.ms \in 0..59999

(* The codes, and those of settings of STEP 7 that are no codes [AMB-86].  *)
Periods == PeriodCodes \cup LateMonthlies

TypeInv ==
    /\ mode \in {"STOP", "STARTUP", "RUN", "HOLD"}
    /\ startup \in {"none", "warm", "cold", "hot", "begun", "resuming"}
    /\ IsMoment(clock)
    /\ DOMAIN tod = TodObs
    /\ \A o \in TodObs :
         /\ tod[o].start \in 0..LastMinute
         /\ tod[o].period \in Periods
         /\ tod[o].next = Never \/ tod[o].next \in 0..LastMinute
    /\ \A r \in requests : r.rank >= 1 /\ r.class \in 1..29
    /\ delay >= 0
=============================================================================

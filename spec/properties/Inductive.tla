----------------------------- MODULE Inductive ------------------------------
(***************************************************************************)
(* An inductive invariant: whatever state it holds in, reachable or not,   *)
(* it holds after every step of System.  The rules of priority classes,    *)
(* delays, queues, settings and modes rest on it.                          *)
(*                                                                         *)
(* models/MCInductive checks the step for all states of small domains.     *)
(* Left out: times, points served, and the classes of settable priorities. *)
(***************************************************************************)
EXTENDS PropertiesObs, PropertiesAirt, PropertiesIrt

(* [OBS-41] In STOP no OB runs or waits, no delay is active and no STOP is *)
(* due.                                                                    *)
StoppedInv == mode = "STOP" => /\ stack = <<>> /\ requests = {} /\ delay = 0
                               /\ stopCause = NoCause /\ startup = "none"

(* [OBS-42] [OBS-43] STARTUP and its OB belong together. *)
StartingInv ==
    /\ (mode = "STARTUP") = (startup # "none")
    /\ \A i \in DOMAIN stack :
         IF mode = "STARTUP" THEN stack[i].ob \in StartupObs \cup AsyncErrorObs
                             ELSE stack[i].ob \notin StartupObs

(* [TINT-05] [TINT-31] [TINT-50] An active interrupt is set; an inactive   *)
(* interrupt is not watched and does not wait.                             *)
ActiveInv ==
    \A o \in TodObs :
      /\ tod[o].active => tod[o].set
      /\ ~tod[o].active => /\ tod[o].next = Never
                           /\ \/ MissingObEndsItsSource  \* [AMB-46]
                              \/ { r \in requests : r.ob = o } = {}

(* [TINT-02] (c) [OBS-06] A deselected OB does not wait. *)
DeselectedWaitsInv == \A r \in requests : ~Deselected(r.ob)

(* [OBS-07] A request has its place in the queue of its class. *)
PlaceInv == \A r \in requests : r.rank >= 1 /\ r.class >= 1

(* [OBS-01] [AIRT-12] [OBS-02] [IRT-20] and all of the above. *)
IndInv == /\ StackInv
          /\ AirtInv
          /\ delay >= 0
          /\ StoppedInv
          /\ StartingInv
          /\ QueueInv
          /\ PlaceInv
          /\ ActiveInv
          /\ DeselectedWaitsInv
          /\ SilentInv
=============================================================================

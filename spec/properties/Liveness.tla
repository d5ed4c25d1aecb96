------------------------------ MODULE Liveness ------------------------------
(***************************************************************************)
(* Events that must happen in the end, and the fairness that they need.    *)
(*                                                                         *)
(* Fairness is weak throughout: an action that stays possible happens.     *)
(* Nothing is assumed of the surroundings: no interrupt, call, STOP,       *)
(* restart or setting of the clock has to come. Interrupts must not come   *)
(* without end either: a CPU that is flooded with interrupts of high       *)
(* classes serves no low class. Models allow a finite number               *)
(* (models/MCLive).                                                        *)
(* Left out: HOLD, which only the operator ends; open requests, whose      *)
(* effect the sources leave open.                                          *)
(* Source: requirements [OBS-03] [AIRT-08] [TINT-02] [DINT-03].            *)
(***************************************************************************)
EXTENDS System

-----------------------------------------------------------------------------
(* Assumptions *)

(* [AIRT-08] [OBS-03] The CPU dispatches: it cannot wait for ever with an  *)
(* OB that may start or a STOP that is due.                                *)
DispatchFairness == WF_cpuVars(Respond)

(* Programs end: a running OB that is not interrupted for ever comes to    *)
(* its end, however many calls it makes; STARTUP ends and OB 1 starts      *)
(* again. Cycle monitoring [OBS-26] enforces it on a real CPU.             *)
ProgramFairness == WF_cpuVars(Proceed)

(* Time passes, and points and delays come with it, unless the CPU has to  *)
(* do something at once.                                                   *)
TimeFairness == WF_cpuVars(Time)

CpuFairness == DispatchFairness /\ ProgramFairness
Fairness    == CpuFairness /\ TimeFairness

-----------------------------------------------------------------------------
(* Properties *)

WatchedObs == TodObs \cup DintObs \cup { i[1] : i \in Interrupts }
                \cup {TimeErrorOb}

(* [OBS-07] [OBS-02] No OB waits for ever: it starts, a call withdraws its *)
(* start event or a STOP clears it.                                        *)
ServedLive == \A o \in WatchedObs : PendingIn(requests, o)
                                       ~> ~PendingIn(requests, o)

(* [OBS-01] [AIRT-01] A running higher class, a delay or the mode could    *)
(* hold it back.                                                           *)
\* @type: Int => Bool;
Free(o) == mode = "RUN" /\ delay = 0 /\ Running.class < ClassOf(o)

(* Only dispatch is assumed: the OB starts if its class is free again and  *)
(* again.                                                                  *)
ServedWhenFreeLive ==
    \A o \in WatchedObs : []<>Free(o) => ( PendingIn(requests, o)
                                             ~> ~PendingIn(requests, o) )

(* [AIRT-02] [AIRT-03] [AIRT-04] A delay comes to its end, and then all    *)
(* that it held back is released.                                          *)
ReleasedLive == delay > 0 ~> delay = 0 /\ ~Pressing

(* The CPU always comes back to its cycle with no request left: it never   *)
(* goes round for ever between OB 80 and an interrupt.                     *)
BackToCycleLive == []<>(Running.class <= 1 /\ requests = {})

(* [TINT-09] The point that is watched for comes, or the interrupt is      *)
(* cancelled, set anew or stopped.                                         *)
\* @type: (Int, $moment) => Bool;
Watched(o, t) == Watching /\ tod[o].active /\ NextMoment(tod[o]) = t
PointLive == \A o \in TodObs : \A t \in Moments :
               Watched(o, t) ~> ~Watched(o, t)

(* [DINT-03] [DINT-06] A delay that runs and whose end the clock can reach *)
(* comes to its end, or it is cancelled, started anew or stopped.          *)
\* @type: (Int, $moment) => Bool;
Runs(o, t) == Watching /\ dint[o].started /\ After(clock, dint[o].left) = t
DelayLive == \A o \in DintObs : \A t \in Moments :
               Runs(o, t) ~> \/ ~dint[o].started \/ ~Watching
                             \/ step.event = "SRT_DINT" /\ step.ob = o
=============================================================================

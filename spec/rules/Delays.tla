------------------------------- MODULE Delays -------------------------------
(***************************************************************************)
(* The jobs of SFC 32: a delay that runs, and its end (section 2).         *)
(* Elapsed time is apart from the CPU clock, which may be set [DINT-18].   *)
(*                                                                         *)
(* Left out: the effect of the end on its OB (StartEvents).                *)
(***************************************************************************)
EXTENDS StartEvents

NoJob  == [started |-> FALSE, left |-> 0, dtime |-> 0, sign |-> 0]
NoJobs == [o \in DintObs |-> NoJob]

(* [AMB-12] (b) The delay is over and its start event lost; the job is     *)
(* still started.                                                          *)
Gone == -1

(* The jobs that time brings nearer to their end. *)
Jobs == IF Watching
        THEN { o \in DintObs : dint[o].started /\ dint[o].left >= 0 }
        ELSE {}

(* Time does not pass the end of a delay; a delay that is over must have   *)
(* been handled.                                                           *)
\* @type: Int => Bool;
PassesNoDelay(d) ==
    d = 0 \/ \A o \in Jobs : dint[o].left > 0 /\ d <= dint[o].left

(* The jobs when d ms have elapsed. *)
\* @type: Int => (Int -> $job);
JobsAfter(d) == IF d = 0 \/ Jobs = {} THEN dint
                ELSE [ o \in DOMAIN dint |->
                         IF o \in Jobs THEN [dint[o] EXCEPT !.left = @ - d]
                                       ELSE dint[o] ]

(* A job ends with its delay, unless its start event is lost and it stays  *)
(* [AMB-12].                                                               *)
\* @type: (Int, $job) => $job;
AfterItsEnd(o, job) ==
    IF Blocked(o) /\ ~LostEventEndsItsSource
    THEN [job EXCEPT !.left = Gone] ELSE NoJob

(* [DINT-06] A delay may be over up to 1 ms early [DINT-10] [DINT-11]      *)
(* [DINT-20].                                                              *)
\* @type: Int => Bool;
DelayElapses(o) ==
    /\ o \in Jobs
    /\ dint[o].left <= 1
    /\ dint' = [dint EXCEPT ![o] = AfterItsEnd(o, @)]
    /\ Occurs(DintRequest(o))
    /\ UNCHANGED <<deviceVars, modeVars, clock, tod, irt, runVars>>
=============================================================================

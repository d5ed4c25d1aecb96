------------------------------ MODULE TimeDelay -----------------------------
(***************************************************************************)
(* SFC 32 SRT_DINT, SFC 33 CAN_DINT and SFC 34 QRY_DINT, and the delay     *)
(* that elapses (catalogue section 2).  Elapsed time is apart from the CPU *)
(* clock, which may be set [DINT-18].                                      *)
(*                                                                         *)
(* Left out: nothing.                                                      *)
(***************************************************************************)
EXTENDS StartPoints

NoJob == [started |-> FALSE, left |-> 0, dtime |-> 0, sign |-> 0]

(* [AMB-12] (b) Elapsed and lost, and yet still started. *)
Gone == -1

(* [AMB-70] (b) In its last millisecond a job counts as elapsed: calls come *)
(* after that.                                                             *)
\* @type: Int => Bool;
Ended(o) == CallsComeAfterTheEnd /\ o \in DintObs
              => ~(dint[o].started /\ dint[o].left \in 0..1)

\* @type: Int => Set(Int);
DintErrors(o) == IF o \notin DintObs THEN {BadOb} ELSE {}

-----------------------------------------------------------------------------
(* SFC 32 *)

(* [DINT-04] DTIME, in ms. *)
DelayTimes == 1..60000

(* [DINT-05] *)
\* @type: (Int, Int) => Set(Int);
SrtErrors(o, dtime) ==
    DintErrors(o) \cup (IF dtime \in DelayTimes THEN {} ELSE {BadDtime})

(* [DINT-07] [DINT-22] [AMB-74] Started anew, it begins from the start. *)
\* @type: ($job, Int, Int) => $job;
StartedWith(job, dtime, sign) ==
    [ started |-> TRUE, left |-> dtime, dtime |-> dtime,
      sign |-> IF job.started /\ RestartedJobKeepsSign THEN job.sign ELSE sign ]

(* [AMB-11] A run that waits stays, but under (b). *)
\* @type: Int => Set($request);
DintWithdrawn(o) == IF DintCallsWithdrawRuns THEN Withdraw(requests, o)
                                               ELSE requests

(* [DINT-03] [DINT-08]; a missing OB is noticed later, but under AMB-06 (b).  *)
\* @type: (Int, Int, Int, Int) => Bool;
SrtDint(o, dtime, sign, ret) ==
    /\ Called /\ Ended(o)
    /\ ret \in Answers(o, SrtErrors(o, dtime))
    /\ IF ret = OK
       THEN /\ dint' = [dint EXCEPT ![o] = StartedWith(@, dtime, sign)]
            /\ IF o \notin loaded /\ MissingNoticedAtSrtDint
               THEN ProgramErrorOccurs(DintWithdrawn(o),
                      [ NoRequest EXCEPT !.ob = o, !.word = dint'[o].sign ])
               ELSE /\ requests' = DintWithdrawn(o)
                    /\ UNCHANGED stopCause /\ NothingEntered
       ELSE UNCHANGED dint /\ Nothing
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, irt, stack, delay>>

-----------------------------------------------------------------------------
(* SFC 33 *)

(* [DINT-14] [DINT-15] Once it has elapsed, the job is no longer started.    *)
\* @type: Int => Set(Int);
CanDintErrors(o) ==
    IF o \notin DintObs THEN {BadOb}
    ELSE IF \/ dint[o].started
            \/ DintCallsWithdrawRuns /\ PendingIn(requests, o)
         THEN {} ELSE {NotStarted}

\* @type: (Int, Int) => Bool;
CanDint(o, ret) ==
    /\ Called /\ Ended(o)
    /\ ret \in Answers(o, CanDintErrors(o))
    /\ IF ret = OK THEN /\ dint' = [dint EXCEPT ![o] = NoJob]
                        /\ requests' = DintWithdrawn(o)
                   ELSE UNCHANGED <<dint, requests>>
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, irt, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------
(* SFC 34 *)

(* [DINT-16] *)
\* @type: Int => Set(Int);
DintStatuses(o) == StatusWithBit2(o, IF dint[o].started THEN {4} ELSE {0})

\* @type: (Int, Int, Int) => Bool;
QryDint(o, ret, status) ==
    /\ Called /\ Ended(o)
    /\ ret \in Answers(o, DintErrors(o))
    /\ ret = OK => status = -1 \/ status \in DintStatuses(o)
    /\ NothingEntered
    /\ UNCHANGED cpuVars

-----------------------------------------------------------------------------
(* Time elapses *)

(* The jobs that time brings nearer to their end. *)
Jobs == IF Watching THEN { o \in DintObs : dint[o].started /\ dint[o].left >= 0 }
                    ELSE {}

(* No delay is left behind; one that is over must have been dealt with. *)
\* @type: Int => Bool;
PassesNoDelay(d) == d = 0 \/ \A o \in Jobs : dint[o].left > 0 /\ d <= dint[o].left

(* The jobs when d ms have elapsed. *)
\* @type: Int => (Int -> $job);
JobsAfter(d) == IF d = 0 \/ Jobs = {} THEN dint
                ELSE [ o \in DOMAIN dint |->
                         IF o \in Jobs THEN [dint[o] EXCEPT !.left = @ - d]
                                       ELSE dint[o] ]

(* [DINT-06] Up to 1 ms before its end a delay may be over.  [DINT-10]      *)
(* [DINT-11] [DINT-20] What follows is said in StartEvents.                *)
\* @type: Int => Bool;
DelayElapses(o) ==
    /\ o \in Jobs
    /\ dint[o].left <= 1
    /\ dint' = [dint EXCEPT ![o] =
                  IF Blocked(o) /\ ~LostEventEndsItsSource
                  THEN [@ EXCEPT !.left = Gone] ELSE NoJob]
    /\ Occurs(DintRequest(o))
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, irt, stack, delay>>
=============================================================================

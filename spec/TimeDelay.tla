------------------------------ MODULE TimeDelay -----------------------------
(***************************************************************************)
(* SFC 32 SRT_DINT, SFC 33 CAN_DINT and SFC 34 QRY_DINT: their answers and *)
(* their effects (section 2).                                              *)
(*                                                                         *)
(* Left out: nothing.                                                      *)
(***************************************************************************)
EXTENDS Calls, Delays

(* [AMB-70] (b) In its last millisecond a job counts as elapsed: calls come *)
(* after that.                                                             *)
\* @type: Int => Bool;
Ended(o) == CallsComeAfterTheEnd /\ o \in DintObs
              => ~(dint[o].started /\ dint[o].left \in 0..1)

\* @type: Int => Set(Int);
DintErrors(o) == IF o \notin DintObs THEN {BadOb} ELSE {}

(* [AMB-11] A run that waits stays, but under (b). *)
\* @type: Int => Set($request);
DintWithdrawn(o) == IF DintCallsWithdrawRuns THEN Withdraw(requests, o)
                                             ELSE requests

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

(* [DINT-03] [DINT-08] A missing OB is noticed later, or at once [AMB-06]. *)
\* @type: (Int, Int, Int) => Bool;
StartsJob(o, dtime, sign) ==
    /\ dint' = [dint EXCEPT ![o] = StartedWith(@, dtime, sign)]
    /\ IF o \notin loaded /\ MissingNoticedAtSrtDint
       THEN ProgramErrorOccurs(DintWithdrawn(o),
              [NoRequest EXCEPT !.ob = o, !.word = dint'[o].sign])
       ELSE RequestsBecome(DintWithdrawn(o))

(* [DINT-03] *)
\* @type: (Int, Int, Int, Int) => Bool;
SrtDint(o, dtime, sign, ret) ==
    /\ Called /\ Ended(o)
    /\ ret \in Answers(o, SrtErrors(o, dtime))
    /\ IF ret = OK THEN StartsJob(o, dtime, sign) ELSE dint' = dint /\ Nothing
    /\ UNCHANGED <<deviceVars, modeVars, clock, tod, irt, runVars>>

-----------------------------------------------------------------------------
(* SFC 33 *)

(* [DINT-14] [DINT-15] Once it has elapsed, the job is no longer started.    *)
\* @type: Int => Set(Int);
CanDintErrors(o) ==
    IF o \notin DintObs THEN {BadOb}
    ELSE IF \/ dint[o].started
            \/ DintCallsWithdrawRuns /\ PendingIn(requests, o)
         THEN {} ELSE {NotStarted}

(* [DINT-14] *)
\* @type: (Int, Int) => Bool;
CanDint(o, ret) ==
    /\ Called /\ Ended(o)
    /\ ret \in Answers(o, CanDintErrors(o))
    /\ dint'     = IF ret = OK THEN [dint EXCEPT ![o] = NoJob] ELSE dint
    /\ requests' = IF ret = OK THEN DintWithdrawn(o) ELSE requests
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, tod, irt, stopCause, runVars>>

-----------------------------------------------------------------------------
(* SFC 34 *)

(* [DINT-16] *)
\* @type: Int => Set(Int);
DintStatuses(o) == StatusWithBit2(o, IF dint[o].started THEN {4} ELSE {0})

(* [DINT-16] -1: the status is not given. *)
\* @type: (Int, Int, Int) => Bool;
QryDint(o, ret, status) ==
    /\ Called /\ Ended(o)
    /\ ret \in Answers(o, DintErrors(o))
    /\ ret = OK => status = -1 \/ status \in DintStatuses(o)
    /\ NothingEntered
    /\ UNCHANGED cpuVars
=============================================================================

------------------------------ MODULE TimeDelay -------------------------------
(***************************************************************************)
(* Time-delay interrupts: the delay that runs and ends, and SFC 32         *)
(* SRT_DINT, SFC 33 CAN_DINT and SFC 34 QRY_DINT with their answers and    *)
(* their effects (section 2). Elapsed time is apart from the CPU clock,    *)
(* which may be set [DINT-18].                                             *)
(*                                                                         *)
(* Left out: the effect of the end of a delay on its OB (StartEvents).     *)
(***************************************************************************)
EXTENDS Calls, StartEvents

NoJob  == [started |-> FALSE, left |-> 0, dtime |-> 0, sign |-> 0]
NoJobs == [o \in DintObs |-> NoJob]

(* [AMB-12] (b) The delay is over and its start event lost; the job is     *)
(* still started.                                                          *)
Gone == -1

(* The jobs whose delay is running. Perhaps none does under a delay of     *)
(* interrupts [T15-39] [A15-04].                                           *)
Jobs == IF Watching /\ ~(delay > 0 /\ Family.byKind /\ DelaysStandStill)
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

-----------------------------------------------------------------------------
(* The calls *)

(* [AMB-70] (b) No call comes in the last millisecond of a job: the job    *)
(* ends first.                                                             *)
\* @type: Int => Bool;
Ended(o) == CallsComeAfterTheEnd /\ o \in DintObs
              => ~(dint[o].started /\ dint[o].left \in 0..1)

(* [DINT-05] [DINT-14] [DINT-16] *)
\* @type: Int => Set(Int);
DintErrors(o) == IF o \notin DintObs THEN {BadOb} ELSE {}

(* [DINT-15] The delay is over and its OB is pending, definitely or        *)
(* perhaps.                                                                *)
\* @type: Int => Bool;
Elapsed(o) == PendingIn(requests, o) \/ OpenIn(requests, o)

(* [AMB-11] The waiting run is withdrawn or stays; a call shows which. *)
\* @type: Int => Set($cpu);
CpusThatShowRun(o) == IF Elapsed(o) THEN CpusByDintCalls ELSE {cpu}

(* [AMB-11] *)
\* @type: (Int, $cpu) => Set($request);
DintWithdrawn(o, c) == IF DintCallsWithdrawRuns(c) THEN Withdraw(requests, o)
                                                   ELSE requests

-----------------------------------------------------------------------------
(* SFC 32 *)

(* [DINT-04] DTIME, in ms. *)
DelayTimes == 1..60000

(* [DINT-05] *)
\* @type: (Int, Int) => Set(Int);
SrtErrors(o, dtime) ==
    DintErrors(o) \cup (IF dtime \in DelayTimes THEN {} ELSE {BadDtime})

\* @type: (Int, Int) => Set(Int);
SrtAnswers(o, dtime) == OpenCodes(SettingAnswers(o, SrtErrors(o, dtime)))

(* [DINT-07] [DINT-22] [AMB-74] Started anew, it begins from the start. *)
\* @type: ($job, Int, Int) => $job;
StartedWith(job, dtime, sign) ==
    [ started |-> TRUE, left |-> dtime, dtime |-> dtime,
      sign |-> IF job.started /\ RestartedJobKeepsSign
               THEN job.sign ELSE sign ]

(* [DINT-03] [DINT-08] A missing OB is noticed later, or at once [AMB-06]. *)
\* @type: (Int, Int, Int) => Bool;
StartsJob(o, dtime, sign) ==
    /\ dint' = [dint EXCEPT ![o] = StartedWith(@, dtime, sign)]
    /\ \E c \in CpusThatShowRun(o) :
         /\ cpu' = c
         /\ IF o \notin loaded /\ MissingNoticedAtSrtDint
            THEN ProgramErrorOccurs(DintWithdrawn(o, c),
                   [NoRequest EXCEPT !.ob = o, !.word = dint'[o].sign])
            ELSE RequestsBecome(DintWithdrawn(o, c))

(* [DINT-03] *)
\* @type: (Int, Int, Int, Int) => Bool;
SrtDint(o, dtime, sign, ret) ==
    /\ Ended(o)
    /\ IF ret = OK THEN StartsJob(o, dtime, sign)
       ELSE UNCHANGED <<cpu, dint>> /\ Nothing
    /\ UNCHANGED <<loaded, modeVars, clock, tod, irt, runVars>>

-----------------------------------------------------------------------------
(* SFC 33 *)

(* The errors that follow from what is known of the job. *)
\* @type: Bool => Set(Int);
CanDintErrorsIf(started) == IF started THEN {} ELSE {NotStarted}

(* [DINT-14] [DINT-15] Whether the call finds the job started. While its   *)
(* OB waits, a job that is over can be cancelled, or is no longer started  *)
(* [AMB-11]; if the OB may wait, both are possible.                        *)
\* @type: (Int, $cpu) => Set(Bool);
FoundStarted(o, c) ==
    IF dint[o].started THEN {TRUE}
    ELSE IF ~DintCallsWithdrawRuns(c) THEN {FALSE}
    ELSE IF PendingIn(requests, o) THEN {TRUE}
    ELSE IF OpenIn(requests, o) THEN {TRUE, FALSE} ELSE {FALSE}

(* [DINT-14] [DINT-15] *)
\* @type: (Int, $cpu) => Set(Int);
CanDintAnswersOf(o, c) ==
    IF o \notin DintObs THEN OpenCodes(Answers(o, {BadOb}))
    ELSE UNION { OpenCodes(Answers(o, CanDintErrorsIf(started)))
                 : started \in FoundStarted(o, c) }

\* @type: Int => Set(Int);
CanDintAnswers(o) ==
    UNION { CanDintAnswersOf(o, c) : c \in CpusThatShowRun(o) }

(* [DINT-14] *)
\* @type: (Int, Int) => Bool;
CanDint(o, ret) ==
    /\ Ended(o)
    /\ \E c \in CpusThatShowRun(o) :
         /\ ret \in CanDintAnswersOf(o, c)
         /\ cpu'      = IF ret = BadOb THEN cpu ELSE c
         /\ requests' = IF ret = BadOb THEN requests ELSE DintWithdrawn(o, c)
    /\ dint' = IF ret = OK THEN [dint EXCEPT ![o] = NoJob] ELSE dint
    /\ NothingEntered
    /\ UNCHANGED <<loaded, modeVars, clock, tod, irt, stopCause, runVars>>

-----------------------------------------------------------------------------
(* SFC 34 *)

(* [DINT-16] [AMB-34] While its OB waits, bit 2 is either. *)
\* @type: Int => Set(Int);
DintStatuses(o) ==
    StatusWithBit2(o, IF dint[o].started THEN {4}
                      ELSE IF Elapsed(o) THEN {0, 4} ELSE {0})

\* @type: Int => Set(Int);
QryDintAnswers(o) == OpenCodes(Answers(o, DintErrors(o)))

(* [DINT-16] -1: the status is not given. *)
\* @type: (Int, Int, Int) => Bool;
QryDint(o, ret, status) ==
    /\ Ended(o)
    /\ ret = OK => status = -1 \/ status \in DintStatuses(o)
    /\ NothingEntered
    /\ UNCHANGED cpuVars
=============================================================================

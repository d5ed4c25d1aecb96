------------------------------- MODULE APAirt -------------------------------
(***************************************************************************)
(* Delays in RUN for Apalache: a bounded check of StackInv [OBS-01] and    *)
(* AirtInv [AIRT-12], not a proof. It begins in RUN, in OB 1, half a       *)
(* minute before a point of OB 10; OB 40 is requested from outside.        *)
(* Left out: STOP, restart, STARTUP and missing OBs, which MCAirt has,     *)
(* since Apalache unfolds every action into every step.                    *)
(* models/apalache.sh check                                                *)
(***************************************************************************)
EXTENDS MCBase

APTodObs == {10}
APDintObs == {20}
APBlockable == {10, 40}

APInit ==
    /\ cpu = [ family |-> "S7-300", priority |-> [o \in {} |-> 0],
               step7 |-> [o \in TodObs |-> Activated("minute", 0)],
               readings |-> [a \in {} |-> ""],
               classes |-> [o \in {} |-> 0],
               queues |->
                 [o \in {} |-> [size |-> 1, limit |-> 0, told |-> 0]],
               zone |-> 0, hour |-> NoHour ]
    /\ loaded = {1, 10, 40, 80, 85}
    /\ mode = "RUN"
    /\ startup = "none"
    /\ resume = NothingKept
    /\ clock = Moment(0, 30000)
    /\ tod = [ o \in TodObs |->
                 [ NoSetting EXCEPT !.set = TRUE, !.active = TRUE,
                                    !.start = Six, !.period = Minutely,
                                    !.next = Six + 1 ] ]
    /\ dint = NoJobs
    /\ irt = NoneBlocked
    /\ requests = {}
    /\ stack = <<Frame(CycleOb, 1)>>
    /\ delay = 0
    /\ stopCause = NoCause
    /\ entered = {}
    /\ step = Step("run", 0, 0)

(* Points and the clock without the calendar: a point of OB 10 comes at    *)
(* any time. Apalache would copy the calendar for each use.                *)
PointAtAnyTime ==
    /\ Occurs(TodRequest(10, clock, 0))
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, runVars>>
ClockGoesOn ==
    /\ \E t \in HalfMinutes(1, 2) : Before(clock, t) /\ clock' = t
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, settingVars, outcomeVars, runVars>>

(* Time may pass although an OB is to start: System allows less, so an     *)
(* invariant of this model is one of System.                               *)
APNext ==
    \/ \E r \in requests : Start(r) /\ Seen("start", r.ob, r.class)
    \/ \E ret \in DisAirtAnswers(delay) : DisAirt /\ Seen("DIS_AIRT", 0, ret)
    \/ \E ret \in EnAirtAnswers(delay) : EnAirt /\ Seen("EN_AIRT", 0, ret)
    \/ CycleStarts(CycleOb) /\ Seen("start", CycleOb, 1)
    \/ \E o \in {1, 10, 40, 80} : End(o) /\ Seen("end", o, 0)
    \/ Interrupt(40, 0) /\ Seen("interrupt", 40, 0)
    \/ PointAtAnyTime /\ Seen("reached", 10, clock.min)
    \/ ClockGoesOn /\ Seen("time", 0, 0)

StackAndAirtInv == StackInv /\ AirtInv
=============================================================================

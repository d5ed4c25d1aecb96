------------------------------- MODULE System -------------------------------
(***************************************************************************)
(* The CPU and its surroundings as one system. An OB that may start starts *)
(* at once, the highest class first [AIRT-08] [OBS-01]; everything else    *)
(* waits. Each action is one way in which the CPU or the world acts, and   *)
(* Next is their disjunction.                                              *)
(*                                                                         *)
(* `step' is the last step as an observer sees it: the event, its OB, a    *)
(* value (RET_VAL of a call, class of a start), SDT, another operand       *)
(* (PERIOD, DTIME, MODE or the STATUS that came back) and SIGN. The state  *)
(* does not depend on it; properties use it.                               *)
(*                                                                         *)
(* Source: requirements, sections 5 and 6.                                 *)
(* Left out: start information (ReportedData); the latency of a real CPU   *)
(* (Latency).                                                              *)
(***************************************************************************)
EXTENDS Surroundings, Airt, Irt, TimeOfDay, Clock, Scheduler, SyncErrors,
        Modes

VARIABLE
    \* @type: $step;
    step

vars == <<cpuVars, entered, step>>

-----------------------------------------------------------------------------

NoOperand == [ year |-> 0, month |-> 0, day |-> 0, hour |-> 0, minute |-> 0,
               second |-> 0, ms |-> 0 ]

\* @type: (Str, Int, Int) => $step;
Step(event, ob, value) ==
    [ event |-> event, ob |-> ob, value |-> value, sdt |-> NoOperand,
      operand |-> 0, sign |-> 0 ]

\* @type: (Str, Int, Int) => Bool;
Seen(event, ob, value) == step' = Step(event, ob, value)

Init ==
    /\ cpu \in [ family : Families, priority : Priorities,
                 step7 : Step7Settings, readings : ReadingSets,
                 classes : ObClasses, queues : Queues, zone : Zones,
                 hour : {NoHour} ]
    /\ loaded \in Loads
    /\ mode = "STOP"
    /\ startup = "none"
    /\ resume = NothingKept
    /\ clock \in PowerOnMoments
    /\ tod = [o \in TodObs |-> NoSetting]
    /\ dint = NoJobs
    /\ irt = NoneBlocked
    /\ requests = {}
    /\ stack = <<>>
    /\ delay = 0
    /\ stopCause = NoCause
    /\ entered = {}
    /\ step = Step("power on", 0, 0)

-----------------------------------------------------------------------------
(* What must happen at once *)

Pressing == \/ \E r \in requests : MayStart(r)
            \/ ErrorObIsDue
            \/ StopIsDue
            \/ resume.due /\ mode = "RUN"

(* [AIRT-08] The highest class first. *)
\* @type: $request => Bool;
First(r) == \A q \in requests : MayStart(q) => q.class <= r.class

StartsOb ==
    /\ ~StopIsDue
    /\ \/ \E r \in requests :
            First(r) /\ Start(r) /\ Seen("start", r.ob, r.class)
       \/ \E o \in SyncErrorObs :
            ErrorObStarts(o) /\ Seen("start", o, Running.class)

MissesOb ==
    /\ stopCause = NoCause
    /\ \E r \in requests :
         First(r) /\ Missing(r) /\ Seen("missing", r.ob, r.class)

DropsRequest ==
    /\ stopCause = NoCause
    /\ \E r \in requests :
         First(r) /\ Drop(r) /\ Seen("dropped", r.ob, r.class)

StopsByRule ==
    /\ stopCause # NoCause
    /\ Stop /\ Seen("stop", 0, stopCause)

Respond == StartsOb \/ MissesOb \/ DropsRequest \/ StopsByRule

-----------------------------------------------------------------------------
(* Calls of the program that runs *)

Settled == ~Pressing

(* A call is possible. Its possible answers are told first, so that TLC    *)
(* does not try the others.                                                *)
Calling == Settled /\ Called

(* SET_TINT and SET_TINTL, in whose step `sign' is 1 if it activates.      *)
CallSetTint ==
    /\ Calling
    /\ \E o \in ObNumbers, sdt \in Sdts, period \in Words :
         \/ \E ret \in RetVals \cap SetTintAnswers(o, sdt, period) :
              /\ SetTint(o, sdt, period, ret)
              /\ step' = [ Step("SET_TINT", o, ret) EXCEPT
                             !.sdt = sdt, !.operand = period ]
         \/ \E local \in Locals :
            \E ret \in RetVals \cap SetLocalAnswers(o, sdt, local, period),
               sign \in {0, 1} :
              /\ SetTintL(o, sdt, local, period, sign = 1, ret)
              /\ step' = [ Step("SET_TINTL", o, ret) EXCEPT
                             !.sdt = sdt, !.operand = period, !.sign = sign ]

CallCanTint ==
    /\ Calling
    /\ \E o \in ObNumbers : \E ret \in RetVals \cap CanAnswers(o) :
         CanTint(o, ret) /\ Seen("CAN_TINT", o, ret)

CallActTint ==
    /\ Calling
    /\ \E o \in ObNumbers : \E ret \in RetVals \cap ActAnswers(o) :
         ActTint(o, ret) /\ Seen("ACT_TINT", o, ret)

(* The STATUS of a call that is refused is nobody's concern.               *)
\* @type: Int => Set(Int);
StatusWordsFor(ret) ==
    IF ret = OK THEN StatusWords ELSE StatusWords \cap {-1}

CallQryTint ==
    /\ Calling
    /\ \E o \in ObNumbers : \E ret \in RetVals \cap QryAnswers(o) :
       \E status \in StatusWordsFor(ret) :
         /\ QryTint(o, ret, status)
         /\ step' = [Step("QRY_TINT", o, ret) EXCEPT !.operand = status]

CallSrtDint ==
    /\ Calling
    /\ \E o \in ObNumbers, dtime \in Dtimes :
       \E ret \in RetVals \cap SrtAnswers(o, dtime), sign \in Signs :
         /\ SrtDint(o, dtime, sign, ret)
         /\ step' = [ Step("SRT_DINT", o, ret) EXCEPT
                        !.operand = dtime, !.sign = sign ]

CallCanDint ==
    /\ Calling
    /\ \E o \in ObNumbers : \E ret \in RetVals \cap CanDintAnswers(o) :
         CanDint(o, ret) /\ Seen("CAN_DINT", o, ret)

CallQryDint ==
    /\ Calling
    /\ \E o \in ObNumbers : \E ret \in RetVals \cap QryDintAnswers(o) :
       \E status \in StatusWordsFor(ret) :
         /\ QryDint(o, ret, status)
         /\ step' = [Step("QRY_DINT", o, ret) EXCEPT !.operand = status]

CallDisIrt ==
    /\ Calling
    /\ \E o \in ObNumbers, m \in IrtModes :
       \E ret \in RetVals \cap DisIrtAnswers(m, o) :
         /\ DisIrt(m, o, ret)
         /\ step' = [Step("DIS_IRT", o, ret) EXCEPT !.operand = m]

CallEnIrt ==
    /\ Calling
    /\ \E o \in ObNumbers, m \in IrtModes :
       \E ret \in RetVals \cap EnIrtAnswers(m, o) :
         /\ EnIrt(m, o, ret)
         /\ step' = [Step("EN_IRT", o, ret) EXCEPT !.operand = m]

CallDisAirt ==
    /\ Calling
    /\ \E ret \in RetVals \cap DisAirtAnswers(delay) :
         DisAirt /\ Seen("DIS_AIRT", 0, ret)

CallEnAirt ==
    /\ Calling
    /\ \E ret \in RetVals \cap EnAirtAnswers(delay) :
         EnAirt /\ Seen("EN_AIRT", 0, ret)

(* [AMB-81] Any call; which one is nobody's concern. *)
CallFails ==
    /\ Calling
    /\ \E ret \in RetVals : Fails(ret) /\ Seen("fails", 0, ret)

Call == \/ CallSetTint \/ CallCanTint \/ CallActTint \/ CallQryTint
        \/ CallSrtDint \/ CallCanDint \/ CallQryDint
        \/ CallDisIrt \/ CallEnIrt \/ CallDisAirt \/ CallEnAirt
        \/ CallFails

-----------------------------------------------------------------------------
(* The CPU goes on: cycle and startup OBs start when nothing else does,    *)
(* and any OB may end.                                                     *)

CycleBegins ==
    /\ Settled
    /\ \E o \in CycleObs : CycleStarts(o) /\ Seen("start", o, 1)

StartupBegins ==
    /\ Settled
    /\ \E o \in StartupObs : StartupStarts(o) /\ Seen("start", o, StartupClass)

EndsOb ==
    /\ Settled
    /\ \E o \in { stack[i].ob : i \in DOMAIN stack } :
         End(o) /\ Seen("end", o, 0)

GoesToRun == Settled /\ Run /\ Seen("run", 0, 0)

Proceed == CycleBegins \/ StartupBegins \/ EndsOb \/ GoesToRun

-----------------------------------------------------------------------------
(* The world acts *)

(* An instruction of the running OB may fail, too. *)
EventFromOutside ==
    /\ Settled
    /\ \E i \in Interrupts :
         /\ IF i[1] \in SyncErrorObs THEN InstructionFails(i[1])
                                    ELSE Interrupt(i[1], i[2])
         /\ Seen("interrupt", i[1], i[2])

ClockIsSet ==
    /\ Settled
    /\ \E to \in ClockTargets : ClockSet(to) /\ Seen("clock", 0, 0)

(* Somebody sets local time, or the CPU does by its rule of daylight       *)
(* saving: `operand' is 1.                                                 *)
LocalTimeIsSet ==
    /\ Settled
    /\ \E zone \in Zones, rule \in {0, 1} :
         /\ LocalTimeSet(zone, rule = 1)
         /\ step' = [Step("zone", 0, zone) EXCEPT !.operand = rule]

BlockIsLoaded ==
    /\ Settled
    /\ \E o \in ChangingObs :
         LoadedAre(loaded \cup {o}) /\ Seen("load", o, 0)

BlockIsDeleted ==
    /\ Settled
    /\ \E o \in ChangingObs :
         LoadedAre(loaded \ {o}) /\ Seen("delete", o, 0)

CpuIsRestarted ==
    /\ Settled
    /\ \E type \in RestartTypes : Restart(type) /\ Seen("restart", 0, 0)

SwitchIsTurned == Settled /\ Stop /\ Seen("switch", 0, 0)

CpuIsHeld == Settled /\ HoldPossible /\ Hold /\ Seen("hold", 0, 0)

CpuIsReleased == Settled /\ HoldPossible /\ Release /\ Seen("release", 0, 0)

World == \/ EventFromOutside \/ ClockIsSet \/ LocalTimeIsSet
         \/ BlockIsLoaded \/ BlockIsDeleted
         \/ CpuIsRestarted \/ SwitchIsTurned \/ CpuIsHeld \/ CpuIsReleased

-----------------------------------------------------------------------------
(* Time *)

(* [AMB-26] The points of a STOP are noticed in STARTUP, or as RUN begins. *)
PointIsReached ==
    /\ ~StopIsDue
    /\ \/ /\ Settled
          /\ \E o \in TodObs : PointReached(o) /\ Seen("reached", o, clock.min)
       \/ NoticesPassed /\ Seen("noticed", 0, 0)

DelayIsOver ==
    /\ Settled
    /\ \E o \in DintObs : DelayElapses(o) /\ Seen("elapsed", o, dint[o].left)

TimeGoesOn ==
    /\ Settled
    /\ \E t \in Moments : TimePasses(t, Span(clock, t)) /\ Seen("time", 0, 0)

Time == PointIsReached \/ DelayIsOver \/ TimeGoesOn

-----------------------------------------------------------------------------

Next == Respond \/ Call \/ Proceed \/ World \/ Time

Spec == Init /\ [][Next]_vars
=============================================================================

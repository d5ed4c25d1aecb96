------------------------------- MODULE System -------------------------------
(***************************************************************************)
(* The CPU and its surroundings as one system: what may happen, and what   *)
(* must happen first.  An OB that may start does so at once, the highest   *)
(* class first [AIRT-08] [OBS-01]; everything else waits.  (How much later *)
(* a real CPU may be is for module Trace.)                                 *)
(*                                                                         *)
(* `step' is what an observer would see of the last step: the event, its   *)
(* OB, a value (RET_VAL of a call, class of a start), SDT, another operand *)
(* (PERIOD, DTIME, MODE or the STATUS that came back) and SIGN.  The state *)
(* does not depend on it; properties speak of it.                          *)
(*                                                                         *)
(* The sets below are what a program may pass and what the world may do;   *)
(* models replace them by small ones.                                      *)
(* Source: catalogue sections 5 and 6.                                     *)
(* Left out: start information (StartInfo).                                *)
(***************************************************************************)
EXTENDS Modes

VARIABLE
    \* @type: $step;
    step

vars == <<cpuVars, entered, step>>

-----------------------------------------------------------------------------
(* Surroundings *)

(* CPUs and OBs loaded. *)
Families == {"S7-300", "S7-400", "CPU 318"}
\* @type: Set(Int -> $step7);
Step7Settings ==
    [ TodObs -> [ execution : {"none", "once", "minute", "hourly", "daily",
                               "weekly", "monthly", "yearly", "end_of_month"},
                  start : 0..LastMinute, active : BOOLEAN,
                  deselected : BOOLEAN ] ]
Loads == SUBSET (TodObs \cup ExternalObs \cup StartupObs)

(* Priority classes other than the defaults [OBS-05]; none. *)
\* @type: Set(Int -> Int);
Priorities == { [o \in {} |-> 0] }

(* Readings other than the defaults; none. *)
\* @type: Set(Str -> Str);
ReadingSets == { [a \in {} |-> ""] }

(* Operands of calls. *)
ObNumbers == -32768..32767
\* @type: Set($date);
Sdts == [ year : 1990..2089, month : 1..99, day : 1..99, hour : 0..99,
          minute : 0..99, second : 0..99, ms : 0..999 ]
Words == 0..65535
Dtimes == -60000..600000
Signs == Words
IrtModes == 0..255

(* What calls may answer, for an observer who does not know the rules. *)
RetVals == Words
StatusWords == {-1} \cup Words

(* Moments to which time may pass, at which it begins, and to which the     *)
(* clock may be set.                                                       *)
\* @type: Set($moment);
Moments == [min : 0..LastMinute, ms : 0..59999]
\* @type: Set($moment);
PowerOnMoments == Moments
\* @type: Set($moment);
ClockTargets == Moments

(* Start events from outside, with the fault id of OB 80 and 85. *)
\* @type: Set(<<Int, Int>>);
Interrupts == (ExternalObs \X {0}) \cup ({TimeErrorOb, ProgramErrorOb} \X (0..255))

RestartTypes == {"warm", "cold"}

(* Whether the CPU may be put on HOLD. *)
HoldPossible == TRUE

(* OBs that are loaded and deleted while the CPU is at work. *)
ChangingObs == TodObs \cup ExternalObs \cup StartupObs

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
                 step7 : Step7Settings, readings : ReadingSets ]
    /\ loaded \in Loads
    /\ mode = "STOP"
    /\ startup = "none"
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
            \/ StopIsDue

(* [AIRT-08] The highest class first. *)
\* @type: $request => Bool;
First(r) == \A q \in requests : MayStart(q) => q.class <= r.class

Respond ==
    \/ /\ stopCause = NoCause
       /\ \E r \in requests :
            /\ First(r)
            /\ \/ Start(r) /\ Seen("start", r.ob, r.class)
               \/ Missing(r) /\ Seen("missing", r.ob, r.class)
               \/ Drop(r) /\ Seen("dropped", r.ob, r.class)
    \/ /\ stopCause # NoCause
       /\ Stop /\ Seen("stop", 0, stopCause)

-----------------------------------------------------------------------------
(* What may happen otherwise *)

Call ==
    \E ret \in RetVals :
      \/ DisAirt(ret) /\ Seen("DIS_AIRT", 0, ret)
      \/ EnAirt(ret) /\ Seen("EN_AIRT", 0, ret)
      \/ \E o \in ObNumbers :
           \/ \E sdt \in Sdts, period \in Words :
                /\ SetTint(o, sdt, period, ret)
                /\ step' = [ Step("SET_TINT", o, ret) EXCEPT
                               !.sdt = sdt, !.operand = period ]
           \/ \E dtime \in Dtimes, sign \in Signs :
                /\ SrtDint(o, dtime, sign, ret)
                /\ step' = [ Step("SRT_DINT", o, ret) EXCEPT
                               !.operand = dtime, !.sign = sign ]
           \/ CanDint(o, ret) /\ Seen("CAN_DINT", o, ret)
           \/ \E m \in IrtModes :
                \/ /\ DisIrt(m, o, ret)
                   /\ step' = [Step("DIS_IRT", o, ret) EXCEPT !.operand = m]
                \/ /\ EnIrt(m, o, ret)
                   /\ step' = [Step("EN_IRT", o, ret) EXCEPT !.operand = m]
           \/ CanTint(o, ret) /\ Seen("CAN_TINT", o, ret)
           \/ ActTint(o, ret) /\ Seen("ACT_TINT", o, ret)
           \/ \E status \in StatusWords :
                \/ /\ QryTint(o, ret, status)
                   /\ step' = [Step("QRY_TINT", o, ret) EXCEPT !.operand = status]
                \/ /\ QryDint(o, ret, status)
                   /\ step' = [Step("QRY_DINT", o, ret) EXCEPT !.operand = status]

(* OB 1 and the startup OB start when nothing else does; any OB may end. *)
Proceed ==
    \/ CycleStarts /\ Seen("start", CycleOb, 1)
    \/ \E o \in StartupObs : StartupStarts(o) /\ Seen("start", o, 27)
    \/ \E o \in { stack[i].ob : i \in DOMAIN stack } :
         End(o) /\ Seen("end", o, 0)
    \/ Run /\ Seen("run", 0, 0)

World ==
    \/ \E i \in Interrupts :
         Interrupt(i[1], i[2]) /\ Seen("interrupt", i[1], i[2])
    \/ \E to \in ClockTargets : ClockSet(to) /\ Seen("clock", 0, 0)
    \/ \E o \in ChangingObs :
         \/ LoadedAre(loaded \cup {o}) /\ Seen("load", o, 0)
         \/ LoadedAre(loaded \ {o}) /\ Seen("delete", o, 0)
    \/ \E type \in RestartTypes : Restart(type) /\ Seen("restart", 0, 0)
    \/ Stop /\ Seen("switch", 0, 0)
    \/ HoldPossible /\ \/ Hold /\ Seen("hold", 0, 0)
                       \/ Release /\ Seen("release", 0, 0)

Time ==
    \/ \E o \in TodObs : PointReached(o) /\ Seen("reached", o, clock.min)
    \/ \E o \in DintObs : DelayElapses(o) /\ Seen("elapsed", o, dint[o].left)
    \/ \E t \in Moments : TimePasses(t, Span(clock, t)) /\ Seen("time", 0, 0)

Next == \/ Respond
        \/ ~Pressing /\ (Call \/ Proceed \/ World \/ Time)

Spec == Init /\ [][Next]_vars
=============================================================================

------------------------------- MODULE MCBase -------------------------------
(***************************************************************************)
(* The common part of the TLC models: a small world to choose from, and    *)
(* the small sets that their configurations put in the place of the large  *)
(* sets of module System.                                                  *)
(*                                                                         *)
(* The clock knows a few minutes around 2026-11-21 06:00 and two moments   *)
(* of each.  Time is absolute here: no view makes it relative, since       *)
(* start points are.                                                       *)
(***************************************************************************)
EXTENDS Properties, MCLetters

(* 2026-11-21 06:00 *)
Six == DayNumber(2026, 11, 21) * MinutesADay + 360

\* @type: (Int, Int) => $moment;
Moment(m, ms) == [min |-> Six + m, ms |-> ms]

(* The whole minutes from a to b, and the half minutes between them. *)
\* @type: (Int, Int) => Set($moment);
HalfMinutes(a, b) == { Moment(m, ms) : m \in a..b, ms \in {0, 30000} }

\* @type: Int => $date;
Date(m) == [ year |-> 2026, month |-> 11, day |-> 21, hour |-> 6,
             minute |-> m, second |-> 20, ms |-> 0 ]

(* It would be December 1, which is ahead. *)
WrongDate == [ Date(0) EXCEPT !.day = 31 ]
Monthly29 == [ Date(0) EXCEPT !.month = 12, !.day = 29 ]

NotConfigured == [ execution |-> "none", start |-> 0, active |-> FALSE,
                   deselected |-> FALSE, local |-> FALSE ]
\* @type: (Str, Int) => $step7;
Activated(execution, m) ==
    [ NotConfigured EXCEPT !.execution = execution, !.start = Six + m,
                           !.active = TRUE ]

(* The runs of points that an OB remembers of earlier settings. *)
ShortMemory == 1
NoMemory == 0

(* One CPU of each kind whose rules differ. *)
TwoFamilies == {"S7-300", "S7-400"}
Just1500 == {"S7-1500"}
(* The letters that an S7-1500 has by default. *)
LettersOf1500 ==
    { [ a \in { p[1] : p \in FamilyOf("S7-1500").letters } |->
          (CHOOSE p \in FamilyOf("S7-1500").letters : p[1] = a)[2] ] }

(* Codes that calls may answer, right or wrong. *)
CallRetVals == {OK, BadOb, BadSdt, BadPeriod, NotSet, PastStart, NotDelayed, 1}
DintRetVals == {OK, BadOb, BadDtime, NotStarted}
IrtRetVals == {OK, BadOb, BadMode}
AirtRetVals == {0, 1, 2, 3, 4, NotDelayed}
(* General errors of some parameters; of parameter 0 there is none.        *)
GeneralRetVals == {0, 1, NotDelayed, \h8022, \h8122, \h8146, \h8F7F}
TodStatusWords == {-1, 0, 1, 2, 4, 5, 16, 17, 20, 21, 32, 64}
DintStatusWords == {-1, 0, 2, 4, 5, 16, 20, 21, 32}
IrtStatusWords == {-1, 0, 16, 18, 20, 22}

(* Where a model leaves something out. *)
\* @type: Set(Int);
NoObNumbers == {}
\* @type: Set($date);
NoSdts == {}
\* @type: Set(Int);
NoWords == {}
\* @type: Set($moment);
NoClockTargets == {}
\* @type: Set(<<Int, Int>>);
NoInterrupts == {}
\* @type: Set(Int);
NoStatusWords == {}
\* @type: Set(Int);
NoRetVals == {}
\* @type: Set(Int);
NoChangingObs == {}
\* @type: Set(Int);
NoDintObs == {}
\* @type: Set(Int);
NoBlockable == {}
\* @type: Set(Int);
NoDtimes == {}
\* @type: Set(Int);
NoSigns == {}
\* @type: Set(Int);
NoIrtModes == {}
NoHoldPossible == FALSE
(* A point that equals the clock when HOLD ends counts as reached after    *)
(* HOLD. Such a model has one in the full lane without this [AMB-83].      *)
\* @type: Set(Int);
NothingAtRelease == {}

(* At most n start events wait, and a few more that are open. *)
\* @type: Int => Bool;
Waiting(n) == /\ Cardinality({ r \in requests : ~r.open }) <= n
              /\ Cardinality(requests) <= n + 1

(* The state without `step' and `entered'. *)
View == cpuVars

(* What Apalache proves of a step is proved of each step of the model: it  *)
(* begins in the world and within the bounds of models/APSystem.           *)
ProvedProp ==
    [][ /\ TodObs \subseteq {10, 11}
        /\ DintObs \subseteq {20, 21}
        /\ { i[1] : i \in Interrupts } \subseteq {40, 80, 85}
        /\ loaded \subseteq {10, 11, 20, 21, 40, 80, 85, 100, 102}
        /\ DOMAIN cpu.priority \subseteq {10, 11, 20, 21, 40, 85}
        /\ DOMAIN cpu.readings \subseteq {"AMB-11", "AMB-56", "AMB-57"}
        /\ Cardinality(requests) <= 4
        /\ Len(stack) <= 9
        /\ \A o \in TodObs : /\ Cardinality(tod[o].served) <= 2
                             /\ Cardinality(tod[o].merged) <= 2
                             /\ Cardinality(tod[o].earlier) <= 2 ]_vars

-----------------------------------------------------------------------------
(* Possible steps. A rule that forbids too much violates no property of    *)
(* steps. TLC alone checks these: they use ENABLED.                        *)

(* The world, or the CPU by itself, can make a step with this event. *)
\* @type: Str => Bool;
MayAct(event) == ENABLED (World /\ step'.event = event)
\* @type: Str => Bool;
MayProceed(event) == ENABLED (Proceed /\ step'.event = event)

(* [OBS-47] [OBS-45] [OBS-42] [AIRT-08] The CPU is never stuck, and the    *)
(* world may always act.                                                   *)
PossibleInv ==
    IF Pressing THEN ENABLED Next
    ELSE /\ mode # "STOP" => MayAct("switch")
         /\ mode = "STOP" /\ RestartTypes # {} => MayAct("restart")
         /\ mode # "STOP" /\ Interrupts # {} => MayAct("interrupt")
         /\ ClockTargets \ {clock} # {} => MayAct("clock")
         /\ /\ mode = "STARTUP" /\ stack = <<>>
            /\ StartupsAhead \cap loaded = {}
            => MayProceed("run")
         /\ mode = "RUN" /\ stack = <<>> => MayProceed("start")
         /\ mode \in {"STARTUP", "RUN"} /\ stack # <<>> => MayProceed("end")
         /\ (\E t \in Moments : Before(clock, t)) => ENABLED Time

(* [OBS-45] HOLD may be entered in RUN, and left. [OBS-46] [AMB-83] A point *)
(* that equals the clock then has passed, or is reached afterwards.        *)
HeldInv ==
    LET \* @type: (Int, Bool) => Bool;
        left(o, waits) ==
          ENABLED (CpuIsReleased /\ (tod'[o].next = tod[o].next <=> waits))
    IN  Settled =>
          /\ mode = "RUN" => ENABLED CpuIsHeld
          /\ mode = "HOLD" =>
               /\ ENABLED CpuIsReleased
               /\ \A o \in TodObs :
                    /\ tod[o].active /\ ~Deselected(o) /\ ~tod[o].held
                    /\ At(tod[o].next) = clock
                    => left(o, TRUE) /\ left(o, FALSE)

(* [AMB-71] A one-shot interrupt may be used up when its OB starts or when *)
(* it ends.                                                                *)
OnceEndsInv ==
    \A o \in TodObs :
      LET starts(called) == ENABLED ( /\ StartsOb /\ Started(o)
                                      /\ tod'[o].called = called )
      IN  tod[o].active /\ tod[o].period = Once /\ PendingIn(requests, o)
            => (starts(TRUE) <=> starts(FALSE))

(* [AMB-48] [AMB-55] [A15-12] However far the clock is set, a one-shot     *)
(* interrupt that has passed without a run may stay over; and if its start *)
(* is ahead then and was never reached, it may be armed again.             *)
SpentInv ==
    requests = {} /\ stack = <<>> =>
      \A o \in { p \in TodObs : Spent(p) }, m \in ClockTargets \ {clock} :
        LET \* @type: Int => Bool;
            passes(next) == ENABLED (ClockSet(m) /\ tod'[o].next = next)
        IN  /\ passes(Never)
            /\ /\ mode # "STOP" /\ Before(m, At(tod[o].start))
               /\ tod[o].served = {}
               => passes(tod[o].start)

(* The class of the error may overflow. *)
\* @type: (Int, Int) => Bool;
MayOverflowBy(o, fault) ==
    ENABLED ( /\ Interrupt(o, fault)
              /\ \E n \in entered' :
                   n.of.fault = BufferOverflow /\ n.of.cause = o )

(* [OBS-08] An error may overflow its class where a start event of that    *)
(* waits, or an OB of it runs.                                             *)
OverflowsInv ==
    mode = "RUN" /\ Settled =>
      \A i \in Interrupts :
        LET class == ErrorClass(i[1], i[2])
        IN  /\ i[1] \in AsyncErrorObs \ {TimeErrorOb}
            /\ class \in { r.class : r \in requests }
                          \cup { stack[k].class : k \in DOMAIN stack }
            => MayOverflowBy(i[1], i[2])

(* [AMB-49] (b) A time error without OB 80 that waits for the end of a     *)
(* delay fills its class: the next error of the class may overflow.        *)
StandingErrorProp ==
    [][ \A n \in entered', i \in Interrupts :
          /\ n.of.ob = TimeErrorOb /\ stopCause' = NoTimeErrorOb
          /\ delay' > 0 /\ ~StopIsNotDelayed
          /\ i[1] # TimeErrorOb /\ ErrorClass(i[1], i[2])' = n.of.class
          => MayOverflowBy(i[1], i[2])' ]_vars

(* [AIRT-08] [OBS-02] [OBS-20] Each definite start event that nothing of a *)
(* higher class and nothing before it in its class keeps from starting can *)
(* be the next: its OB starts or is missing. [T15-91] A late run waits for *)
(* its OB 80, and keeps nothing from starting as long, whatever its class. *)
StartableInv ==
    LET \* @type: $request => Bool;
        inMode(r) == \/ mode = "RUN"
                     \/ mode = "STARTUP"
                          /\ r.ob \in AsyncErrorObs \ Family.heldBack
        \* @type: $request => Bool;
        waits(r) == /\ r.follows # 0
                    /\ \/ Top(stack).ob = TimeErrorOb
                       \/ \E q \in requests :
                            /\ q.ob = TimeErrorOb /\ r.ob \in q.late
                            /\ q.fault = r.follows
    IN  stopCause = NoCause /\ delay = 0 =>
          \A r \in requests :
            /\ inMode(r) /\ ~r.open /\ ~waits(r)
            /\ r.class > Top(stack).class
            /\ \A q \in requests :
                 \/ ~inMode(q) \/ waits(q)
                 \/ q.class < r.class
                 \/ q.class = r.class /\ (q.open \/ q.rank >= r.rank)
            => ENABLED ( /\ Respond /\ step'.ob = r.ob
                         /\ step'.event \in {"start", "missing"} )

(* [AMB-49] [OBS-23] Under a delay a missing OB 82, 83 or 86 may stop the  *)
(* CPU at once, whatever waits or runs.                                    *)
StopsAtOnceInv ==
    /\ mode \in {"STARTUP", "RUN"} /\ stopCause = NoCause /\ delay > 0
    /\ ~StopAwaitsTheDelay
    => \A r \in requests :
         ~r.open /\ r.ob \in {82, 83, 86} \ loaded =>
           ENABLED (MissesOb /\ step'.ob = r.ob /\ stopCause' # NoCause)

(* [TINT-22] [DINT-21] [IRT-22] [AIRT-14] Where nothing is pressing, the   *)
(* running OB can call SFC 41 and 42, whatever the count is, and the other *)
(* functions with each of the model's operands: each has one of the        *)
(* model's answers at least.                                               *)
AnsweredInv ==
    Settled /\ stack # <<>> /\ mode \in {"STARTUP", "RUN"} =>
      /\ ENABLED CallDisAirt /\ ENABLED CallEnAirt
      /\ \A o \in ObNumbers :
           /\ \A sdt \in Sdts, period \in Words :
                \E ret \in RetVals \cap SetTintAnswers(o, sdt, period) :
                  ENABLED SetTint(o, sdt, period, ret)
           /\ \E ret \in RetVals \cap CanAnswers(o) : ENABLED CanTint(o, ret)
           /\ \E ret \in RetVals \cap ActAnswers(o) : ENABLED ActTint(o, ret)
           /\ \E ret \in RetVals \cap QryAnswers(o) :
                ENABLED QryTint(o, ret, -1)
           /\ \A dtime \in Dtimes, sign \in Signs :
                \E ret \in RetVals \cap SrtAnswers(o, dtime) :
                  ENABLED SrtDint(o, dtime, sign, ret)
           /\ \E ret \in RetVals \cap CanDintAnswers(o) :
                ENABLED CanDint(o, ret)
           /\ \E ret \in RetVals \cap QryDintAnswers(o) :
                ENABLED QryDint(o, ret, -1)
           /\ \A m \in IrtModes :
                /\ \E ret \in RetVals \cap DisIrtAnswers(m, o) :
                     ENABLED DisIrt(m, o, ret)
                /\ \E ret \in RetVals \cap EnIrtAnswers(m, o) :
                     ENABLED EnIrt(m, o, ret)

-----------------------------------------------------------------------------
(* Steps.  These are no properties of spec/, all of which are to be proved. *)

(* Data that an observer does not see have no value. *)
SeenProp ==
    [][ /\ step'.event \in { "end", "clock", "load", "delete", "restart",
                            "switch", "hold", "release", "run", "time" }
             => step'.value = 0
        /\ step'.event \in { "clock", "restart", "switch", "hold", "release",
                            "run", "time", "stop", "DIS_AIRT", "EN_AIRT" }
             => step'.ob = 0
        /\ Did("missing") => step'.ob \notin loaded
        /\ ~Did("SET_TINT") => step'.sdt = NoOperand ]_vars

(* [TINT-09] A point that was reached is not watched for any more. *)
PassedProp ==
    [][Did("reached") => ~(tod'[step'.ob].next <= clock.min)]_vars

(* [OBS-07] A start event that waits stays when another starts or is       *)
(* missing, unless nobody knows of it and it was before that in its class. *)
StartKeepsProp ==
    [][ step'.event \in {"start", "missing"} =>
          LET gone == { r \in requests :
                          ~\E q \in requests' : Content(q) = Content(r) }
              left == { r \in gone : r.ob = step'.ob }
          IN  \A r \in requests : r.ob # step'.ob =>
                \/ \E q \in requests' : /\ Content(q) = Content(r)
                                        /\ q.open = r.open
                \/ r.open /\ \E s \in left :
                                s.class = r.class /\ r.rank < s.rank ]_vars

(* [OBS-08] Only an error whose class is taken overflows. Under a delay a  *)
(* time error without OB 80 takes one, too [AMB-49]: 26, or 28 [AMB-13].   *)
TakenClassProp ==
    [][ \A n \in entered' :
          n.of.fault = BufferOverflow /\ n.of.cause \in AsyncErrorObs =>
            LET class == ErrorClass(n.of.cause, 0)
            IN  \/ \E r \in requests : r.class = class
                \/ \E i \in DOMAIN stack : stack[i].class = class
                \/ /\ stopCause = NoTimeErrorOb /\ delay > 0
                   /\ class \in {26, 28} ]_vars

(* [OBS-44] [AMB-53] [AMB-35] A point that the clock skips in STARTUP has  *)
(* one run, later; or there is a STOP.                                     *)
DeferProp ==
    [][ Did("clock") /\ mode = "STARTUP" /\ irt.blocked = {} =>
          \A o \in SkippedNow :
            \/ stopCause' # NoCause
            \/ Cardinality({ r \in requests' : r.ob = o }) = 1 ]_vars

(* [AMB-56] The clock is set back before the point of an active one-shot   *)
(* interrupt for which its OB was not called: the CPU shows whether it is  *)
(* over.                                                                   *)
OnceShownProp ==
    [][ Did("clock") /\ mode = "RUN" /\ cpu.family # "S7-300" =>
          \A o \in TodObs :
            /\ tod[o].active /\ tod[o].period = Once /\ tod[o].next = Never
            /\ tod[o].served \cup tod[o].merged = {} /\ ~tod[o].called
            /\ ~PendingIn(requests, o)
            /\ Before(clock', At(tod[o].start))
            => "AMB-56" \in DOMAIN cpu'.readings ]_vars
=============================================================================

----------------------------- MODULE Properties -----------------------------
(***************************************************************************)
(* What must hold of the system, said without the words of the actions:    *)
(* of states (...Inv) and of steps (...Prop).  A property of steps speaks  *)
(* of `step', what an observer sees, and of the states around it.          *)
(*                                                                         *)
(* Each has its requirement; models/ checks them, and for each guard of an *)
(* action and for each rule there is a negative control that violates one. *)
(* Left out: liveness; properties of single functions are in PropertiesTod, *)
(* PropertiesClock, PropertiesDint and PropertiesIrt.                      *)
(* Source: catalogue sections 4 and 5.                                     *)
(***************************************************************************)
EXTENDS System

Did(event) == step'.event = event

(* The OB of a start event has started in this step. *)
Started(o) == Did("start") /\ step'.ob = o
Dispatched == Did("start") /\ step'.ob \notin StartupObs \cup {CycleOb}

\* @type: Seq($frame) => $frame;
Top(s) == IF s = <<>> THEN NoFrame ELSE s[Len(s)]

-----------------------------------------------------------------------------
(* Types *)

\* @type: $moment => Bool;
IsMoment(t) == t.min \in 0..LastMinute /\ t.ms \in 0..59999

TypeInv ==
    /\ mode \in {"STOP", "STARTUP", "RUN", "HOLD"}
    /\ startup \in {"none", "warm", "cold", "begun"}
    /\ IsMoment(clock)
    /\ DOMAIN tod = TodObs
    /\ \A o \in TodObs :
         /\ tod[o].start \in 0..LastMinute
         /\ tod[o].period \in PeriodCodes
         /\ tod[o].next = Never \/ tod[o].next \in 0..LastMinute
    /\ \A r \in requests : r.rank >= 1 /\ r.class \in 1..29
    /\ delay >= 0

-----------------------------------------------------------------------------
(* Scheduling *)

(* [OBS-01] Every running OB is of a higher class than the one it interrupted. *)
StackInv == \A i \in DOMAIN stack : i > 1 => stack[i-1].class < stack[i].class

(* [OBS-04] Table 7.1 as an order: cycle, time-of-day interrupts, hardware  *)
(* interrupts, program errors, time errors.                                *)
PriorityOrderInv ==
    /\ \A o \in TodObs : DefaultClass(CycleOb) < DefaultClass(o)
    /\ \A o, p \in TodObs : DefaultClass(o) = DefaultClass(p)
    /\ \A o \in TodObs : DefaultClass(o) < DefaultClass(20)
    /\ \A o \in (20..22) \cup (30..37) \cup (40..46) :
         DefaultClass(o) < DefaultClass(o + 1)
    /\ DefaultClass(23) < DefaultClass(30)
    /\ DefaultClass(38) < DefaultClass(40)
    /\ \A o \in 55..57 : DefaultClass(o) = DefaultClass(10)
    /\ DefaultClass(47) < DefaultClass(60)
    /\ DefaultClass(60) <= DefaultClass(ProgramErrorOb)
    /\ cpu.family = "S7-300"
         <=> DefaultClass(ProgramErrorOb) = DefaultClass(TimeErrorOb)
    /\ DefaultClass(ProgramErrorOb) <= DefaultClass(TimeErrorOb)
    /\ DefaultClass(TimeErrorOb) < DefaultClass(100)
    /\ DefaultClass(70) = DefaultClass(60)
    /\ DefaultClass(100) < DefaultClass(72)
    /\ \A o \in 81..87 : DefaultClass(o) = DefaultClass(ProgramErrorOb)

(* [OBS-04] [OBS-31] [OBS-43] The classes of those that run: two real       *)
(* numbers of table 7.1 for each family, what STARTUP changes, and [OBS-05] *)
(* what is set.                                                            *)
ClassInv ==
    \A i \in DOMAIN stack :
      LET o == stack[i].ob
          c == stack[i].class
      IN  /\ o = CycleOb => c = 1
          /\ o \in DOMAIN cpu.priority => c = cpu.priority[o]
          /\ o \in TodObs \ DOMAIN cpu.priority => c = 2
          /\ o \in DintObs => c = o - 17
          /\ o = 40 /\ o \notin DOMAIN cpu.priority => c = 16
          /\ o = TimeErrorOb => c \in {26, 28}
          /\ o \in AsyncErrorObs /\ mode = "STARTUP" => c = 28
          /\ o \in 81..87 /\ c # 28 =>
               c = (IF cpu.family = "S7-300" THEN 26 ELSE 25)
          /\ o \in StartupObs => c = 27

(* [OBS-41] No OB runs in STOP, and nothing is waiting. *)
StopInv == mode = "STOP" => stack = <<>> /\ requests = {} /\ delay = 0

(* [OBS-42] [OBS-43] In STARTUP only the startup OB and asynchronous errors *)
(* run; in RUN the startup OB does not.                                    *)
StartupInv ==
    /\ mode = "STARTUP" => \A i \in DOMAIN stack :
                             stack[i].ob \in StartupObs \cup AsyncErrorObs
    /\ mode = "RUN" => \A o \in StartupObs : ~OnStack(o)
    /\ mode = "STARTUP" <=> startup # "none"

(* [OBS-07] The queue of a class has places 1, 2, ... without gaps. *)
QueueInv ==
    \A r \in requests : r.rank > 1 =>
      \E q \in requests : q.class = r.class /\ q.rank = r.rank - 1

(* [OBS-10] What waits stays as it was when its start event occurred; only   *)
(* its place changes, and what was open may become sure.                   *)
\* @type: $request => $request;
Content(r) == [r EXCEPT !.rank = 0, !.open = FALSE]
Fresh == { r \in requests' : ~\E q \in requests : Content(q) = Content(r) }
ContentProp ==
    [][ step'.event \in {"start", "end", "dropped", "time", "hold", "DIS_AIRT",
                         "EN_AIRT", "SET_TINT", "CAN_TINT", "ACT_TINT", "run"}
          => Fresh = {} ]_vars

(* [OBS-08] A buffer overflows only where something of the class waits or    *)
(* runs already.                                                           *)
OverflowProp ==
    [][ \A e \in Fresh :
          e.ob = TimeErrorOb /\ e.fault = 7 /\ e.cause # 0 =>
            \/ \E r \in requests : r.class = ClassOf(e.cause)
            \/ \E i \in DOMAIN stack : stack[i].class = ClassOf(e.cause)
            \/ /\ e.cause \in AsyncErrorObs
               /\ \/ \E r \in requests : r.ob \in AsyncErrorObs
                  \/ \E i \in DOMAIN stack : stack[i].ob \in AsyncErrorObs ]_vars

(* [OBS-01] Only a strictly higher class interrupts. *)
PreemptProp == [][Dispatched => step'.value > Top(stack).class]_vars

(* [OBS-02] The OBs of one class start in the order of their start events.  *)
(* Not of a clock that is set back.                                        *)
FifoProp ==
    [][ Dispatched /\ step'.ob \in TodObs =>
          \E r \in requests :
            /\ r.ob = step'.ob
            /\ \A q \in requests : q.class = r.class /\ q.ob \in TodObs /\ ~q.open
                                     => ~Before(q.since, r.since) ]_vars

(* [OBS-02] The same by the queue, for start events that have no time. *)
TurnProp ==
    [][ Dispatched =>
          \E r \in requests :
            r.ob = step'.ob /\ ~\E q \in requests : /\ q.class = r.class
                                                    /\ q.rank < r.rank
                                                    /\ ~q.open ]_vars

(* [AIRT-08] The highest class that waits and may start is first. *)
HighestFirstProp ==
    [][ Dispatched => \A q \in requests :
          q.class > step'.value => /\ mode # "RUN"
                                   /\ q.ob \notin AsyncErrorObs ]_vars

(* [TINT-02] (d) [TINT-16] Only loaded OBs start, and [OBS-07] only by a     *)
(* start event.                                                            *)
LoadedProp == [][Dispatched => step'.ob \in loaded]_vars
RequestedProp ==
    [][Dispatched => \E r \in requests : r.ob = step'.ob]_vars

(* [OBS-07] Only what is open may come to nothing. *)
DropProp ==
    [][ Did("dropped") => \A r \in requests : r.open
                            \/ \E q \in requests' : q.ob = r.ob /\ ~q.open ]_vars

(* [OBS-06] An OB of class 0 never waits, so it never runs. *)
ClassZeroInv == \A r \in requests : ClassOf(r.ob) # 0

(* [TINT-13] [OBS-42] *)
RunOnlyProp == [][ Dispatched /\ step'.ob \notin AsyncErrorObs
                     => mode = "RUN" ]_vars

(* Nothing else happens while an OB could start [AIRT-08] [OBS-03]. *)
AtOnceProp ==
    [][ \A r \in requests :
          /\ \/ mode = "RUN"
             \/ mode = "STARTUP" /\ r.ob \in AsyncErrorObs
          /\ delay = 0 /\ r.class > Top(stack).class
          /\ r.follows = 0
          => step'.event \in {"start", "missing", "dropped", "stop", "switch"} ]_vars

(* [OBS-03] An end takes the topmost OB off the stack; all else stays. *)
EndProp ==
    [][ Did("end") => /\ stack # <<>>
                      /\ step'.ob = Top(stack).ob
                      /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
                      /\ UNCHANGED <<mode, clock, tod>>
                      /\ step'.ob # ProgramErrorOb => UNCHANGED requests ]_vars

(* [OBS-01] OB 1 starts where nothing runs. *)
CycleProp == [][Started(CycleOb) => mode = "RUN" /\ stack = <<>>]_vars

-----------------------------------------------------------------------------
(* SFC 41/42 *)

(* [AIRT-12] A delay belongs to a running OB. *)
AirtInv == delay > 0 => stack # <<>>

(* [AIRT-04] The end of an OB ends its delay. *)
AirtEndProp == [][Did("end") => delay' = 0]_vars

(* [AIRT-01] Nothing starts while a delay is on. *)
AirtHoldsProp == [][Dispatched => delay = 0]_vars

(* [AIRT-02] A delay loses nothing: requests leave only by a start, a       *)
(* missing OB, a withdrawal, or the end of all.                            *)
AirtKeepsProp ==
    [][ \/ Did("end") /\ step'.ob # ProgramErrorOb
        \/ step'.event \in {"DIS_AIRT", "EN_AIRT", "time", "interrupt",
                         "QRY_TINT", "ACT_TINT"}
          => { r \in requests : ~r.open } \subseteq requests' ]_vars

(* [AIRT-03] [AIRT-06] [AIRT-07] Counting. *)
AirtCountProp ==
    [][ /\ Did("DIS_AIRT") => delay' = delay + 1 /\ step'.value = delay'
        /\ Did("EN_AIRT") =>
             IF delay = 0 THEN step'.value = \h8080 /\ delay' = 0
             ELSE delay' = delay - 1 /\ step'.value = delay'
        /\ delay' > delay => Did("DIS_AIRT") ]_vars

-----------------------------------------------------------------------------
(* Missing OBs and STOP *)

(* [TINT-16] [OBS-20] [OBS-21] [OBS-23] A missing OB leads to OB 85, or to  *)
(* STOP; the source goes on [AMB-46].  Blocked, OB 85 is lost [IRT-01].     *)
MissingProp ==
    [][ Did("missing") =>
          /\ step'.ob \notin loaded
          /\ delay = 0 /\ step'.value > Top(stack).class
          /\ IF step'.ob \notin AsyncErrorObs
             THEN PendingIn(requests', 85) \/ OnStack(85) \/ Blocked(85)
             ELSE IF step'.ob = 85 THEN stopCause' = \h456D
             ELSE step'.ob \in {82, 83, 86} => stopCause' # NoCause
          /\ \A o \in TodObs : tod[o].period # Once
                                 => tod'[o] = tod[o] ]_vars

(* [OBS-21] [OBS-22] [OBS-23] [OBS-25] The CPU must stop only for a rule:   *)
(* a time error without OB 80, a program error without OB 85, another      *)
(* asynchronous error without its OB, a deselected OB at STARTUP.          *)
StopCauseProp ==
    [][ /\ Did("stop") => stopCause # NoCause
        /\ stopCause = NoCause /\ stopCause' # NoCause =>
          \/ stopCause' = \h4568 /\ 80 \notin loaded
          \/ stopCause' = \h456D /\ 85 \notin loaded
          \/ stopCause' = 0 /\ Did("missing")
          \/ stopCause' = \h454A /\ Did("restart") ]_vars

(* A STOP by rule comes before all else, unless it is delayed [AMB-49]. *)
StopAtOnceProp ==
    [][ stopCause # NoCause /\ delay = 0
          => step'.event \in {"stop", "switch"} ]_vars

(* [OBS-40] STOP is left by a restart alone; STARTUP for RUN when the       *)
(* startup OB has been processed and no STOP is due.                       *)
ModeProp ==
    [][ /\ mode = "STOP" => mode' = "STOP" \/ Did("restart")
        /\ Did("restart") => mode = "STOP" /\ mode' = "STARTUP"
        /\ Did("run") => /\ mode = "STARTUP"
                         /\ stack = <<>>
                         /\ startup = "begun" \/ loaded \cap StartupObs = {}
                              \/ StartupOb(startup) \notin loaded
        /\ mode # "RUN" /\ mode' = "RUN" => Did("run") \/ Did("release")
        /\ Did("hold") => mode = "RUN" /\ mode' = "HOLD"
        /\ Did("release") => mode = "HOLD" /\ mode' = "RUN"
        /\ mode # "HOLD" /\ mode' = "HOLD" => Did("hold")
        /\ step'.event \in {"stop", "switch"} =>
             /\ mode # "STOP" /\ mode' = "STOP"
             /\ UNCHANGED <<loaded, clock>> ]_vars

(* [OBS-45] In HOLD nothing runs, ends or is called; it is left for RUN or  *)
(* STOP.                                                                   *)
HoldProp ==
    [][ mode = "HOLD" =>
          /\ step'.event \in {"release", "switch", "stop", "time", "clock",
                             "interrupt", "load", "delete"}
          /\ mode' # "STOP" => UNCHANGED <<stack, delay>> ]_vars

(* [OBS-42] The startup OB of the restart's kind starts, once, if loaded. *)
StartupProp ==
    [][ \A o \in StartupObs : Started(o) =>
          /\ o \in loaded /\ stack = <<>>
          /\ startup = (IF o = 100 THEN "warm" ELSE "cold") ]_vars

(* [TINT-25] Execution of STEP 7 and PERIOD of SFC 28 are one parameter. *)
PeriodTable ==
    { <<"once", 0>>, <<"minute", \h0201>>, <<"hourly", \h0401>>, <<"daily", \h1001>>,
      <<"weekly", \h1201>>, <<"monthly", \h1401>>, <<"yearly", \h1801>>,
      <<"end_of_month", \h2001>> }

(* [TINT-04] [OBS-50] [OBS-52] [OBS-54] After a restart only what STEP 7     *)
(* sets is set, and only a once of the past waits [OBS-56].                *)
RestartProp ==
    [][ Did("restart") =>
          /\ delay' = 0 /\ stack' = <<>>
          /\ \A o \in TodObs :
               LET s == cpu.step7[o]
               IN  /\ tod'[o].set <=> s.execution # "none"
                   /\ tod'[o].active <=> s.execution # "none" /\ s.active
                   /\ s.execution # "none" =>
                        /\ tod'[o].start = s.start
                        /\ <<s.execution, tod'[o].period>> \in PeriodTable
                   /\ PendingIn(requests', o) <=>
                        /\ s.execution = "once" /\ s.active /\ ~s.deselected
                        /\ Before(At(s.start), clock)
          /\ stopCause' = \h454A <=>
               \E o \in loaded \cap TodObs : cpu.step7[o].deselected ]_vars

(* The CPU itself does not change, and OBs come and go by load and delete. *)
CpuProp ==
    [][ /\ cpu'.family = cpu.family /\ cpu'.priority = cpu.priority
        /\ cpu'.step7 = cpu.step7
        /\ cpu'.readings # cpu.readings => Did("clock") /\ Before(clock', clock)
        /\ loaded' # loaded => step'.event \in {"load", "delete"}
        /\ step'.event \in {"load", "delete"} =>
             UNCHANGED <<mode, clock, tod, requests, stack, delay>> ]_vars
=============================================================================

--------------------------- MODULE PropertiesObs ----------------------------
(***************************************************************************)
(* Priority classes, the order of start events, dispatch (section 5.1).    *)
(*                                                                         *)
(* Left out: liveness (Liveness).                                          *)
(***************************************************************************)
EXTENDS Steps

(* [OBS-01] Every running OB has a higher class than the OB that it        *)
(* interrupted; an error OB has the class of the OB that failed [OBS-61].  *)
StackInv ==
    \A i \in DOMAIN stack : i > 1 =>
      \/ stack[i-1].class < stack[i].class
      \/ /\ stack[i].ob \in SyncErrorObs
         /\ stack[i-1].class = stack[i].class

(* [OBS-04] Table 7.1 as an order: cycle, time-of-day interrupts, hardware *)
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
    /\ Family.errorClass = 26
         <=> DefaultClass(ProgramErrorOb) = DefaultClass(TimeErrorOb)
    /\ DefaultClass(ProgramErrorOb) <= DefaultClass(TimeErrorOb)
    /\ DefaultClass(TimeErrorOb) < DefaultClass(100)
    /\ DefaultClass(70) = DefaultClass(60)
    /\ DefaultClass(100) < DefaultClass(72)
    /\ \A o \in 81..87 : DefaultClass(o) = DefaultClass(ProgramErrorOb)

(* [OBS-04] [OBS-05] The class of a running OB is the one that is set for  *)
(* it, or else that of table 7.1. An asynchronous error may have class 28: *)
(* in STARTUP it has [OBS-43], and OB 80 after an overflow [OBS-31].       *)
ClassInv ==
    \A i \in DOMAIN stack :
      LET o == stack[i].ob
          c == stack[i].class
          isSet == o \in DOMAIN cpu.priority
      IN  /\ o = CycleOb => c = 1
          /\ o \in StartupObs => c = 27
          /\ isSet => c = cpu.priority[o] \/ (o \in AsyncErrorObs /\ c = 28)
          /\ o \in TodObs /\ ~isSet => c = 2
          /\ o \in DintObs /\ ~isSet => c = o - 17
          /\ o = 40 /\ ~isSet => c = 16
          /\ o = TimeErrorOb => c \in {26, 28}
          /\ o \in AsyncErrorObs /\ mode = "STARTUP" => c = 28
          /\ o \in 81..87 /\ ~isSet => c \in {Family.errorClass, 28}

(* [OBS-41] No OB runs in STOP, and nothing is waiting. *)
StopInv == mode = "STOP" => stack = <<>> /\ requests = {} /\ delay = 0

(* [OBS-42] [OBS-43] In STARTUP only the startup OB and asynchronous       *)
(* errors run; in RUN the startup OB does not.                             *)
StartupInv ==
    /\ mode = "STARTUP" =>
         \A i \in DOMAIN stack :
           stack[i].ob \in StartupObs \cup AsyncErrorObs \cup SyncErrorObs
    /\ mode = "RUN" => \A o \in StartupObs : ~OnStack(o)
    /\ mode # "HOLD" => (mode = "STARTUP" <=> startup # "none")
    /\ mode = "HOLD" => startup = "none" \/ Family.holdsStartup

(* [OBS-07] The queue of a class has places 1, 2, ... without gaps. *)
QueueInv ==
    \A r \in requests : r.rank > 1 =>
      \E q \in requests : q.class = r.class /\ q.rank = r.rank - 1

(* [OBS-10] *)
ContentProp ==
    [][ step'.event \in {"start", "end", "dropped", "time", "hold", "DIS_AIRT",
                         "EN_AIRT", "SET_TINT", "CAN_TINT", "ACT_TINT", "run"}
          => Fresh = {} ]_vars

(* [OBS-10] [TINT-25] [DINT-03] The data of a start event: PERIOD or SIGN  *)
(* of its interrupt, also where an OB 80 or OB 85 reports it; the DTIME of *)
(* a delay, and the time at which it ended; at an error the OB that was    *)
(* active.                                                                 *)
WordProp ==
    [][ \A r \in Fresh :
          /\ r.ob \in TodObs =>
               r.word = (IF Did("restart") THEN Once
                         ELSE ShownPeriod(tod[r.ob].period))
          /\ r.ob \in DintObs =>
               /\ r.word = dint[r.ob].sign
               /\ r.dtime = dint[r.ob].dtime \/ DtimeIsElapsedTime
               /\ r.since = clock
          /\ r.ob = TimeErrorOb /\ r.cause \in TodObs =>
               r.word = ShownPeriod(tod[r.cause].period)
          /\ r.ob = TimeErrorOb /\ r.cause \in DintObs =>
               r.word = dint[r.cause].sign
          /\ r.ob = ProgramErrorOb /\ r.cause # 0 =>
               \E q \in requests : q.ob = r.cause /\ q.word = r.word
          /\ r.cause # 0 => /\ r.during = Top(stack).ob
                            /\ r.cause = step'.ob ]_vars

(* [OBS-30] [OBS-20] What an error names. OB 80: the OB whose start event  *)
(* is reached, over or comes from outside; if the cycle takes too long,    *)
(* the OB that ran. OB 85: the missing OB, by fault A1 or A2.              *)
NamedProp ==
    [][ \A r \in Fresh :
          /\ /\ r.ob = TimeErrorOb
             /\ \/ step'.event \in {"reached", "elapsed"}
                \/ Did("interrupt") /\ step'.ob # TimeErrorOb
             => r.cause = step'.ob
          /\ r.ob = TimeErrorOb /\ r.fault = 1 => r.during = Top(stack).ob
          /\ r.ob = ProgramErrorOb /\ ~Did("interrupt") =>
               r.cause = step'.ob /\ r.fault \in {\hA1, \hA2} ]_vars

(* [OBS-07] [OBS-11] [OBS-43] In RUN and STARTUP an asynchronous error     *)
(* from outside that is not blocked leads to one more start event of its   *)
(* OB; or the buffer overflows, which is entered unless OB 80 is silent.   *)
(* OB 80 waits, or the CPU has to stop.                                    *)
ErrorComesProp ==
    [][ /\ Did("interrupt") /\ step'.ob \in AsyncErrorObs
        /\ mode \in {"RUN", "STARTUP"} /\ TakesEvents(step'.ob)
        => \/ Cardinality({ r \in requests' : r.ob = step'.ob })
                = Cardinality({ r \in requests : r.ob = step'.ob }) + 1
           \/ IF step'.ob = TimeErrorOb THEN stopCause' # NoCause
              ELSE \h3507 \in EnteredNow \/ Silenced(TimeErrorOb) ]_vars

(* [OBS-08] [OBS-43] A buffer overflows only if an OB of the class of the  *)
(* start event waits or runs already, or [AMB-49] a time error without OB  *)
(* 80 waits for the end of a delay.                                        *)
OverflowProp ==
    [][ \A e \in Fresh :
          e.ob = TimeErrorOb /\ e.fault = 7 /\ e.cause # 0 =>
            LET class == IF e.cause \in AsyncErrorObs
                         THEN ErrorClass(e.cause, 0) ELSE ClassOf(e.cause)
            IN  \/ \E r \in requests : r.class = class
                \/ \E i \in DOMAIN stack : stack[i].class = class
                \/ /\ class \in {26, 28}
                   /\ stopCause = NoTimeErrorOb /\ delay > 0 ]_vars

(* [OBS-01] Only a strictly higher class interrupts. *)
PreemptProp == [][Dispatched => step'.value > Top(stack).class]_vars

(* [OBS-02] The OBs of one class start in the order of their start events. *)
(* Exceptions: a clock that is set back, or set in STARTUP [AMB-53]; runs  *)
(* that catch up together come in any order [AMB-54].                      *)
FifoProp ==
    [][ Dispatched /\ step'.ob \in TodObs =>
          \E r \in requests :
            /\ r.ob = step'.ob
            /\ \A q \in requests :
                 q.class = r.class /\ q.ob \in TodObs /\ ~q.open =>
                   \/ ~Before(q.since, r.since)
                   \/ {q.follows, r.follows} \subseteq {5, 6} ]_vars

(* [OBS-02] [TINT-12] [OBS-11] The same by the queue, for start events     *)
(* that have no time.                                                      *)
TurnProp ==
    [][ Dispatched =>
          \E r \in requests :
            r.ob = step'.ob /\ ~\E q \in requests : /\ q.class = r.class
                                                    /\ q.rank < r.rank
                                                    /\ ~q.open ]_vars

(* [OBS-02] [OBS-11] An OB starts by the first of its start events in the  *)
(* class in which it starts: its other definite ones stay, but not those   *)
(* of a one-shot interrupt [TINT-08].                                      *)
FirstEventProp ==
    [][ Dispatched =>
          \A r \in requests :
            /\ r.ob = step'.ob /\ ~r.open
            /\ r.ob \in TodObs => ~HasOnePoint(tod[r.ob].period)
            /\ \/ r.class # step'.value
               \/ \E q \in requests : /\ q.ob = r.ob /\ q.class = r.class
                                      /\ q.rank < r.rank /\ ~q.open
            => \E s \in requests' : Content(s) = Content(r) /\ ~s.open ]_vars

(* [OBS-02] The place of a start event is its turn: it enters behind all   *)
(* that wait in its class, or beside one of the same time [AMB-29], and    *)
(* definite ones that stay keep their order. Start events with the same    *)
(* content are not told apart.                                             *)
\* @type: $request => Bool;
Single(r) == \A q \in {requests, requests'} :
               Cardinality({ s \in q : Content(s) = Content(r) }) <= 1
(* [OBS-56] q came by a restart, in the minute of r.                       *)
\* @type: ($request, $request) => Bool;
FromRestart(q, r) == /\ q.ob \in TodObs /\ r.ob \in TodObs
                     /\ q.dtime # 0 /\ q.dtime = r.since.min
ArrivalProp ==
    [][ /\ \A r \in Fresh :
             LET old    == { q \in requests' \ Fresh : q.class = r.class }
                 beside == { q \in old : q.rank = r.rank }
             IN  /\ \A q \in old : Single(q) => q.rank <= r.rank
                 /\ (\E q \in beside : Single(q))
                    => \E q \in beside : q.since = r.since \/ FromRestart(q, r)
        /\ \A q, r \in requests :
             /\ q.class = r.class /\ q.rank < r.rank /\ ~q.open /\ ~r.open
             /\ Single(q) /\ Single(r)
             => \A s, t \in requests' :
                  Content(s) = Content(q) /\ Content(t) = Content(r)
                    => s.rank < t.rank ]_vars

(* [OBS-56] [AMB-29] A point that equals the clock at a restart stands     *)
(* beside the past one-shot interrupts, where nothing else waits and its   *)
(* OB neither waits nor runs.                                              *)
BesideProp ==
    [][ Did("reached") =>
          \A q \in requests, r \in Fresh :
            /\ FromRestart(q, r) /\ q.class = r.class /\ q.ob # r.ob
            /\ q.follows = r.follows /\ q.fault = r.fault
            /\ \A s \in requests :
                 s.class = q.class => s.rank = q.rank /\ s.ob # r.ob
            => r.rank = q.rank ]_vars

(* [AIRT-08] The highest class that waits and may start is first. *)
HighestFirstProp ==
    [][ Dispatched => \A q \in requests :
          q.class > step'.value => /\ mode # "RUN"
                                   /\ q.ob \notin AsyncErrorObs ]_vars

(* [TINT-02] (d) [TINT-16] Only loaded OBs start, and [OBS-07] only by a   *)
(* start event.                                                            *)
LoadedProp == [][Dispatched => step'.ob \in loaded]_vars
RequestedProp ==
    [][Dispatched => \E r \in requests : r.ob = step'.ob]_vars

(* [OBS-07] Only an open request may come to nothing. *)
DropProp ==
    [][ Did("dropped") =>
          \A r \in requests :
            r.open \/ \E q \in requests' : q.ob = r.ob /\ ~q.open ]_vars

(* [OBS-06] An OB of class 0 never waits, so it never runs. *)
ClassZeroInv == \A r \in requests : ClassOf(r.ob) # 0

(* [TINT-13] [OBS-42] *)
RunOnlyProp == [][ Dispatched /\ step'.ob \notin AsyncErrorObs
                     => mode = "RUN" ]_vars

(* No OB that could start is passed over: nothing else happens, no call of *)
(* DIS_AIRT either [AIRT-08] [OBS-03] [AMB-69]. A late run waits for its   *)
(* OB 80.                                                                  *)
AtOnceProp ==
    [][ \A r \in requests :
          /\ \/ mode = "RUN"
             \/ mode = "STARTUP" /\ r.ob \in AsyncErrorObs
          /\ delay = 0 /\ r.class > Top(stack).class
          /\ \/ r.follows = 0
             \/ ~\E q \in requests : /\ q.ob = TimeErrorOb /\ r.ob \in q.late
                                      /\ q.fault = r.follows
          => step'.event \in {"start", "missing", "dropped", "stop",
                             "switch"} ]_vars

(* [OBS-03] An end takes the top OB off the stack. All else stays, also a  *)
(* setting that the OB has made for itself [TINT-65]; OB 85 may have       *)
(* reported start events of missing OBs [AMB-45], of no others.            *)
EndProp ==
    [][ Did("end") => /\ stack # <<>>
                      /\ step'.ob = Top(stack).ob
                      /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
                      /\ UNCHANGED <<mode, clock>>
                      /\ \A o \in TodObs \ {step'.ob} : tod'[o] = tod[o]
                      /\ step'.ob \in TodObs /\ ~tod[step'.ob].called
                         => UNCHANGED tod
                      /\ step'.ob # ProgramErrorOb => UNCHANGED requests
                      /\ \A r \in requests :
                           r.ob \in loaded \cup AsyncErrorObs =>
                             \E q \in requests' : /\ Content(q) = Content(r)
                                                  /\ q.open = r.open ]_vars

(* [AMB-45] [AMB-44] OB 85 has reported no missing OB before which an OB   *)
(* that is loaded has to be called.                                        *)
TogetherProp ==
    [][ /\ Did("end") /\ step'.ob = ProgramErrorOb
        /\ ~MissingNoticedWhenDue
        => \A r \in requests :
            (\E q \in requests :
               /\ q.ob \in loaded \ {ProgramErrorOb} /\ ~q.open
               /\ ModeAllows(q) /\ ~AwaitsLowerOb80(q)
               /\ \/ q.class > r.class
                  \/ q.class = r.class /\ q.rank < r.rank)
            => \E q \in requests' : /\ Content(q) = Content(r)
                                    /\ q.open = r.open ]_vars

-----------------------------------------------------------------------------
(* Synchronous errors *)

(* [OBS-61] [OBS-62] [IRT-05] [IRT-23] [AIRT-10] A failed instruction      *)
(* calls its error OB before anything else, on top of its OB and in the    *)
(* same class, whatever is blocked or delayed.                             *)
SyncCallProp ==
    [][ /\ Top(stack).error # 0 /\ stopCause = NoCause =>
             /\ Did("start") /\ step'.ob = Top(stack).error
             /\ step'.value = Top(stack).class
             /\ Len(stack') = Len(stack) + 1
             /\ stack'[Len(stack)].error = 0
             /\ Top(stack').class = Top(stack).class
             /\ UNCHANGED <<mode, requests, delay, irt, tod, dint>>
        /\ Did("start") /\ step'.ob \in SyncErrorObs =>
             Top(stack).error = step'.ob ]_vars

(* [OBS-61] [OBS-27] [OBS-63] [AMB-85] Without its OB, or the same again   *)
(* in an error OB, a synchronous error stops the CPU; otherwise it calls   *)
(* its OB, unless it comes in the other error OB.                          *)
SyncErrorProp ==
    [][ Did("interrupt") /\ step'.ob \in SyncErrorObs =>
          LET o      == step'.ob
              below  == Top(stack).ob
              calls  == Top(stack').error = o /\ UNCHANGED stopCause
              cause  == IF o = 121 THEN \h4562 ELSE \h4563
              stops  == stopCause' \in {cause, stopCause} \ {NoCause}
          IN  /\ stack # <<>> /\ mode \in {"STARTUP", "RUN"}
              /\ UNCHANGED <<requests, delay, irt>>
              /\ IF o \notin loaded \/ below = o THEN stops
                 ELSE calls \/ (stops /\ below \in SyncErrorObs) ]_vars

(* [OBS-01] OB 1 starts where nothing runs. *)
CycleProp == [][Started(CycleOb) => mode = "RUN" /\ stack = <<>>]_vars
=============================================================================

-------------------------- MODULE PropertiesModes ---------------------------
(***************************************************************************)
(* Missing OBs, STOP by rule, modes and restart (sections 5.2 to 5.5).     *)
(*                                                                         *)
(* Left out: skips in HOLD (PropertiesClock).                              *)
(***************************************************************************)
EXTENDS Steps

(* [TINT-16] [OBS-20] [OBS-21] [OBS-22] [OBS-23] An OB is found missing    *)
(* that is not loaded, has a higher class than the running OB or is OB 85  *)
(* [AMB-87], and is not delayed. If its error has to stop the CPU, it may  *)
(* do so at once under a delay [AMB-49]. Else OB 85 waits, runs or is      *)
(* blocked [IRT-01]. But the CPU has to stop if it is OB 80, OB 85, OB 82, *)
(* OB 83 or OB 86, and goes on if it is OB 81. A time-of-day interrupt     *)
(* that is not a one-shot interrupt stays as it is, unless the OB is its   *)
(* own and makes it inactive [AMB-46]. Of OB 70, 72, 84 and 87 nothing is  *)
(* said [AMB-75].                                                          *)
MissingProp ==
    [][ Did("missing") =>
          /\ step'.ob \notin loaded
          /\ \/ delay = 0
             \/ step'.ob \in AsyncErrorObs /\ stopCause' # NoCause  \* [AMB-49]
          /\ \/ step'.value > Top(stack).class
             \/ step'.ob = 85                                      \* [AMB-87]
             \/ delay > 0                                          \* [AMB-49]
          /\ IF step'.ob \notin AsyncErrorObs \cup {70, 72}
             THEN PendingIn(requests', 85) \/ OnStack(85) \/ Blocked(85)
             ELSE IF step'.ob = 85 THEN stopCause' = \h456D
             ELSE IF step'.ob = 80 THEN stopCause' = \h4568
             ELSE /\ step'.ob \in {82, 83, 86} => stopCause' # NoCause
                  /\ step'.ob = 81 => UNCHANGED stopCause
          /\ \A o \in TodObs :
               tod[o].period # Once =>
                 tod'[o] =
                   IF MissingObEndsItsSource /\ o = step'.ob
                   THEN [tod[o] EXCEPT !.active = FALSE, !.next = Never]
                   ELSE tod[o] ]_vars

(* [OBS-42] [OBS-43] [OBS-54] After a hot restart the errors of before the *)
(* STOP wait for RUN: the OBs that start in STARTUP stand above it.        *)
OldErrorsWaitProp ==
    [][ Did("start") /\ mode = "STARTUP" /\ startup \in {"hot", "resuming"}
          => step'.value > StartupClass \/ step'.ob \in StartupObs ]_vars

(* [OBS-21] [OBS-22] [OBS-23] [OBS-25] The CPU has to stop only by a rule: *)
(* a time error without OB 80, a program error without OB 85, another      *)
(* asynchronous error without its OB, a deselected OB at STARTUP.          *)
StopCauseProp ==
    [][ /\ Did("stop") => stopCause # NoCause
        /\ stopCause = NoCause /\ stopCause' # NoCause =>
          \/ stopCause' = \h4568 /\ 80 \notin loaded
          \/ stopCause' = \h456D /\ 85 \notin loaded
          \/ stopCause' = 0 /\ Did("missing")
          \/ /\ stopCause' = 0 /\ Did("interrupt") /\ mode = "HOLD"  \* AMB-84
             /\ step'.ob \notin loaded /\ step'.ob \in {82, 83, 84, 86}
          \/ stopCause' = \h4562 /\ Did("interrupt") /\ step'.ob = 121
          \/ stopCause' = \h4563 /\ Did("interrupt") /\ step'.ob = 122
          \/ stopCause' = \h454A /\ Did("restart")
          \/ stopCause' = \h454A /\ Did("load") /\ mode = "STARTUP" ]_vars

(* [OBS-25] A deselected OB that is loaded in STARTUP aborts it, no other. *)
LoadedInStartupProp ==
    [][ Did("load") /\ mode = "STARTUP" /\ stopCause = NoCause =>
          stopCause' = \h454A
            <=> step'.ob \notin loaded /\ Deselected(step'.ob) ]_vars

(* [AMB-84] [AMB-67] OB 80, 82, 83, 85 or 86 is missing, and its error     *)
(* comes in HOLD: it stops the CPU; or it waits, perhaps to no effect, and *)
(* stops the CPU later; or it is lost.                                     *)
HeldErrorProp ==
    [][ /\ Did("interrupt") /\ mode = "HOLD" /\ stopCause = NoCause
        /\ step'.ob \in {80, 82, 83, 85, 86} \ loaded
        /\ step'.ob \notin irt.blocked
        => \/ stopCause' # NoCause /\ UNCHANGED requests
           \/ /\ stopCause' = NoCause
              /\ \A r \in requests' \ requests :
                   \/ r.ob = step'.ob
                   \/ r.ob = TimeErrorOb /\ r.open ]_vars

(* A STOP by rule comes before all else, unless it is delayed [AMB-49]. No *)
(* delay holds back that of a synchronous error [OBS-63].                  *)
StopAtOnceProp ==
    [][ /\ stopCause # NoCause
        /\ delay = 0 \/ stopCause \in {\h4562, \h4563}
        => step'.event \in {"stop", "switch"} ]_vars

(* [OBS-40] Only a restart leaves STOP. STARTUP leads to RUN when the      *)
(* startup OB has been processed and no STOP is due.                       *)
ModeProp ==
    [][ /\ mode = "STOP" => mode' = "STOP" \/ Did("restart")
        /\ Did("restart") => mode = "STOP" /\ mode' = "STARTUP"
        /\ Did("run") => /\ mode = "STARTUP"
                         /\ stack = <<>>
                         /\ \/ startup \in {"begun", "resuming"}
                            \/ loaded \cap StartupObs = {}
                            \/ StartupOb(startup) \notin loaded
        /\ mode # "RUN" /\ mode' = "RUN" => Did("run") \/ Did("release")
        /\ Did("hold") => /\ mode' = "HOLD"
                          /\ \/ mode = "RUN"
                             \/ mode = "STARTUP" /\ Family.holdsStartup
        /\ Did("release") => mode = "HOLD" /\ mode' = IF startup = "none"
                                                      THEN "RUN" ELSE "STARTUP"
        /\ mode # "HOLD" /\ mode' = "HOLD" => Did("hold")
        /\ step'.event \in {"stop", "switch"} =>
             /\ mode # "STOP" /\ mode' = "STOP"
             /\ UNCHANGED <<loaded, clock>> ]_vars

(* [OBS-45] In HOLD nothing runs, ends or is called; only RUN or STOP      *)
(* follows.                                                                *)
HoldProp ==
    [][ mode = "HOLD" =>
          /\ step'.event \in {"release", "switch", "stop", "time", "clock",
                             "zone", "interrupt", "load", "delete"}
          /\ mode' # "STOP" => UNCHANGED <<stack, delay>> ]_vars

(* [OBS-42] The startup OB of the restart's kind starts, once, if loaded. *)
StartupProp ==
    [][ \A o \in StartupObs : Started(o) =>
          /\ o \in loaded /\ stack = <<>>
          /\ startup = CASE o = 100 -> "warm"
                         [] o = 101 -> "hot"
                         [] OTHER   -> "cold" ]_vars

(* [TINT-25] Execution of STEP 7 and PERIOD of SFC 28 are one parameter. *)
PeriodTable ==
    { <<"once", 0>>, <<"minute", \h0201>>, <<"hourly", \h0401>>,
      <<"daily", \h1001>>, <<"weekly", \h1201>>,
      <<"monthly", \h1401>>, <<"yearly", \h1801>>,
      <<"end_of_month", \h2001>> }

(* [AMB-86] Monthly on a day that not every month has, as STEP 7 sets it:  *)
(* months are left out; in short months the last day; or no point at all.  *)
\* @type: Int => Bool;
LateMonthly(period) == CASE period = Monthly       -> Step7MayLeaveMonthsOut
                         [] period = MonthlyOrLast -> Step7MayTakeLastDay
                         [] period = NoPeriod      -> Step7MayNeverRun
                         [] OTHER                  -> FALSE

(* [TINT-04] [TINT-06] [TINT-07] [OBS-50] [OBS-52] [OBS-54] [OBS-55]       *)
(* Before the startup OB begins, only the settings of STEP 7 hold, and     *)
(* only a one-shot interrupt of the past waits [OBS-56]. A deselected OB   *)
(* that is loaded, by STEP 7 or by class 0 [OBS-06], aborts the startup    *)
(* [OBS-25].                                                               *)
RestartProp ==
    [][ Did("restart") /\ startup' # "hot" =>
          /\ delay' = 0 /\ stack' = <<>>
          /\ \A o \in TodObs :
               LET s == cpu.step7[o]
               IN  /\ tod'[o].set <=> s.execution # "none"
                   /\ tod'[o].active <=> s.execution # "none" /\ s.active
                   /\ s.execution # "none" =>
                        /\ tod'[o].start = s.start
                        /\ IF s.execution = "monthly"
                              /\ DayOf(s.start \div 1440) > 28
                           THEN LateMonthly(tod'[o].period)
                           ELSE <<s.execution, tod'[o].period>> \in PeriodTable
                   /\ LET past == /\ s.execution = "once" /\ s.active
                                  /\ ~Deselected(o)
                                  /\ Before(At(s.start), clock)
                      IN  IF ~Family.missesInStop
                          THEN PendingIn(requests', o) <=> past
                          ELSE /\ ~PendingIn(requests', o)  \* [T15-120]
                               /\ OpenIn(requests', o) => past
          /\ stopCause' = \h454A <=> \E o \in loaded : Deselected(o) ]_vars

(* [OBS-52] [OBS-53] [IRT-03] [DINT-13] [AMB-26] A hot restart is one of a *)
(* CPU that has it [OBS-57]. It keeps the blocks, the settings, all but    *)
(* the next point, and of each job all that STOP has left of it; no        *)
(* diagnostic interrupt waits.                                             *)
HotRestartProp ==
    [][ Did("restart") /\ startup' = "hot" =>
          /\ HotRestartExists
          /\ stack' = <<>> /\ delay' = 0
          /\ ~OpenIn(requests', 82) /\ ~PendingIn(requests', 82)
          /\ \A r \in requests' : r.ob # 82 =>
               \E q \in resume.requests : Content(q) = Content(r)
          /\ \A q \in resume.requests :
               q.ob \notin TodObs \cup DintObs \cup {82}
               => \E r \in requests' : Content(q) = Content(r)
          /\ HotRestartKeepsSettings =>
               /\ UNCHANGED irt /\ dint' = resume.dint
               /\ \A q \in resume.requests : q.ob # 82 =>
                    \E r \in requests' : Content(q) = Content(r)
               /\ \A o \in TodObs :
                    [tod'[o] EXCEPT !.next = 0, !.held = FALSE]
                      = [tod[o] EXCEPT !.next = 0, !.held = FALSE]
          /\ ~HotRestartKeepsSettings =>
               /\ irt'.blocked = {} /\ \A o \in DintObs : ~dint'[o].started
               /\ \A r \in requests' : r.ob \notin TodObs \cup DintObs ]_vars

(* [OBS-52] [OBS-54] What STOP finds is what a hot restart, and then RUN,  *)
(* bring back: the interrupted OBs with their count, jobs, start events.   *)
(* STOP in STARTUP leaves no OB but those that waited for RUN.             *)
ResumeProp ==
    [][ /\ step'.event \in {"stop", "switch"} /\ HotRestartExists =>
             /\ resume'.dint = dint /\ resume'.requests = requests
             /\ IF mode = "STARTUP"
                THEN /\ resume'.stack = resume.stack
                     /\ resume'.delay = resume.delay
                ELSE resume'.stack = stack /\ resume'.delay = delay
        /\ Did("run") =>
             /\ stack' = resume.stack /\ delay' = resume.delay
             /\ startup \notin {"hot", "resuming"} => stack' = <<>> ]_vars

(* [AMB-26] [CLK-02] A point that passed in STOP is noticed before time    *)
(* goes on in RUN: OB 80 reports it with fault 05, if it is not blocked,   *)
(* or the CPU has to stop; nothing else starts by it.                      *)
PassedInStopProp ==
    [][ /\ mode = "RUN" /\ Did("time") => \A o \in TodObs : ~tod[o].held
        /\ Did("noticed") =>
             /\ \A o \in TodObs : ~tod'[o].held
             /\ \A o \in TodObs : tod[o].held /\ irt.blocked = {} =>
                  \/ stopCause' # NoCause
                  \/ \E r \in requests' : /\ r.ob = 80 /\ r.fault = 5
                                         /\ o \in r.late
        /\ Did("restart") /\ startup' = "hot" /\ HotRestartKeepsSettings =>
             \A o \in TodObs : /\ tod[o].active /\ ~Deselected(o)
                               /\ tod[o].next < clock.min
               => tod'[o].held \/ tod'[o].next >= clock.min ]_vars

(* Family, classes and STEP 7 parameters of the CPU stay, and so does a    *)
(* letter that it has; more letters may come. Load adds its OB, delete     *)
(* takes it away, and they change none of these: mode, clock, settings,    *)
(* requests, stack, delay. Nothing else changes the loaded OBs.            *)
CpuProp ==
    [][ /\ cpu'.family = cpu.family /\ cpu'.priority = cpu.priority
        /\ cpu'.step7 = cpu.step7
        /\ \A a \in DOMAIN cpu.readings : cpu'.readings[a] = cpu.readings[a]
        /\ loaded' # loaded => step'.event \in {"load", "delete"}
        /\ Did("load") => loaded' = loaded \cup {step'.ob}
        /\ Did("delete") => loaded' = loaded \ {step'.ob}
        /\ step'.event \in {"load", "delete"} =>
             UNCHANGED <<mode, clock, tod, requests, stack, delay>> ]_vars
=============================================================================

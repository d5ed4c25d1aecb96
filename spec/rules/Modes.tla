-------------------------------- MODULE Modes -------------------------------
(***************************************************************************)
(* STOP, warm, cold and hot restart, STARTUP, RUN and HOLD (sections 5.4   *)
(* and 5.5).                                                               *)
(*                                                                         *)
(* Left out: memory reset [OBS-58] and power off [OBS-59], which no log    *)
(* shows.                                                                  *)
(***************************************************************************)
EXTENDS StartPoints, TimeDelay

(* [AMB-86] A monthly interrupt on a day that not every month has, and     *)
(* what may become of those that STEP 7 sets.                              *)
\* @type: $step7 => Bool;
OnLateDay(s) == s.execution = "monthly" /\ DayOf(s.start \div MinutesADay) > 28
LateMonthlies ==
    (IF Step7MayLeaveMonthsOut THEN {Monthly} ELSE {})
      \cup (IF Step7MayTakeLastDay THEN {MonthlyOrLast} ELSE {})
      \cup (IF Step7MayNeverRun THEN {NoPeriod} ELSE {})
MonthlyPeriods == IF \E o \in TodObs : OnLateDay(cpu.step7[o])
                  THEN LateMonthlies ELSE {Monthly}

(* The execution of a STEP 7 parameter set as a PERIOD [TINT-25] [AMB-01]; *)
(* monthly: that of a late day.                                            *)
\* @type: ($step7, Int) => Int;
PeriodOf(s, monthly) ==
    CASE s.execution = "minute"  -> Minutely
      [] s.execution = "hourly"  -> Hourly
      [] s.execution = "daily"   -> Daily
      [] s.execution = "weekly"  ->
           IF OnlyPeriod1202IsWeekly THEN \h1202 ELSE \h1201
      [] s.execution = "monthly" -> IF OnLateDay(s) THEN monthly ELSE Monthly
      [] s.execution = "yearly"  -> Yearly
      [] s.execution = "end_of_month" -> EndOfMonth
      [] OTHER                   -> Once

(* [T15-22] The minute from which the points count.                        *)
\* @type: $step7 => Int;
StartByStep7(s) ==
    IF Family.timeAlone /\ s.execution = "end_of_month"
    THEN s.start % MinutesADay ELSE s.start

(* [TINT-06] [TINT-07] The setting by STEP 7. Execution "none" is no       *)
(* setting, or a date without points [AMB-62]. The next point comes later. *)
\* @type: ($step7, Int) => $tod;
Configured(s, monthly) ==
    IF s.execution = "none"
    THEN IF NoneHasItsDate /\ s.start > 0
         THEN [NoSetting EXCEPT !.set = TRUE, !.period = NoPeriod]
         ELSE NoSetting
    ELSE [ NoSetting EXCEPT !.set    = TRUE,
                            !.active = s.active,
                            !.start  = StartByStep7(s),
                            !.local  = s.local,
                            !.zone   = ZoneOf(s.local),  \* [T15-20]
                            !.period = PeriodOf(s, monthly) ]

(* [OBS-56] STEP 7 has set and activated a one-shot interrupt with its     *)
(* start in the past.                                                      *)
\* @type: Int => Bool;
PastOnce(o) ==
    LET s == cpu.step7[o]
    IN  /\ s.execution = "once" /\ s.active
        /\ IsPast(At(s.start - ZoneOf(s.local)), clock)
        /\ ~Deselected(o)

SettingsByStep7 ==
    { [o \in TodObs |-> Configured(cpu.step7[o], monthly)]
      : monthly \in MonthlyPeriods }

(* [T15-120] The interrupts that STEP 7 had set, and sets again, and whose *)
(* next point passed in STOP; OB 80 will report them, or not [A15-12].     *)
\* @type: (Int -> $tod) => Set(Set(Int));
MissedInStop(new) ==
    LET missed == { o \in TodObs :
          /\ new[o].active /\ tod[o].active /\ ~Deselected(o)
          /\ new[o].start = tod[o].start /\ new[o].period = tod[o].period
          /\ ~HasOnePoint(new[o].period) /\ IsPast(NextMoment(tod[o]), clock) }
    IN  IF ~Family.missesInStop THEN {{}}
        ELSE (IF StopPointsAreReported THEN {} ELSE {{}})
               \cup (IF StopPointsAreNothing THEN {} ELSE {missed})

(* [OBS-50] The STEP 7 parameters apply again; `kept' is what else STOP    *)
(* leaves. [AMB-57] A run that STOP has dropped did not serve its point.   *)
\* @type: $resume => Bool;
Reconfigure(kept) ==
    \E set \in SettingsByStep7 :
      LET \* @type: Int => $tod;
          called(o) == NotServed(tod[o], PointsOf(resume.requests, o))
          new    == [o \in TodObs |-> WithMemory(set[o], called(o))]
          active == { o \in TodObs : new[o].active }
      IN  \E c \in CpusThatShow({ new[o] : o \in active }, clock),
             missed \in MissedInStop(new) :
            /\ cpu' = c
            /\ resume' = [kept EXCEPT !.due = missed # {}]
            /\ tod' = [ o \in TodObs |->
                 CASE o \in missed -> [ new[o] EXCEPT !.next = tod[o].next,
                                                     !.held = TRUE ]
                   [] o \in active -> Armed(new[o], clock, c)
                   [] OTHER        -> new[o] ]

RestartRequests ==
    { [ NoRequest EXCEPT !.ob = o, !.class = ClassOf(o), !.rank = 1,
                         !.since = At(cpu.step7[o].start
                                        - ZoneOf(cpu.step7[o].local)),
                         !.word = Once,
                         !.dtime = clock.min,
                         !.open = Family.missesInStop ]
      : o \in { p \in TodObs : /\ PastOnce(p)
                              /\ ~(Family.missesInStop
                                     /\ StopPointsAreNothing) } }

NoneBlocked == [blocked |-> {}, silent |-> {}]
\* @type: $resume;
NothingKept == [ stack |-> <<>>, delay |-> 0, dint |-> NoJobs,
                 requests |-> {}, due |-> FALSE, last |-> 0 ]

(* [OBS-57] [AMB-65] *)
\* @type: Str => Bool;
RestartExists(type) ==
    type \notin Family.restarts => type = "cold" /\ S7300RestartsCold

(* [OBS-25] *)
RestartStop == IF \E o \in loaded : Deselected(o) THEN DeselectedLoaded
                                                  ELSE NoCause

(* [OBS-50] [OBS-52] [OBS-53] [OBS-54] [OBS-55] [OBS-57] [DINT-13]         *)
(* [IRT-03] [AMB-65]                                                       *)
\* @type: Str => Bool;
Resets(type) ==
    /\ RestartExists(type)
    /\ startup' = type
    /\ dint'    = NoJobs
    /\ irt'     = NoneBlocked
    /\ stopCause' = RestartStop
    /\ delay' = 0
    /\ UNCHANGED <<loaded, clock>>

(* [OBS-40] [OBS-50] *)
\* @type: Str => Bool;
ResetsAll(type) ==
    /\ Resets(type)
    /\ requests'  = RestartRequests
    /\ Reconfigure(NothingKept)

(* [OBS-42] STARTUP is over when its startup OBs have been processed. After *)
(* a hot restart the OBs that STOP has interrupted go on, with their delay *)
(* count [OBS-54].                                                         *)
Run ==
    /\ mode = "STARTUP"
    /\ startup \in {"begun", "resuming"} \/ StartupOb(startup) \notin loaded
    /\ LaterStartups \cap loaded = {}
    /\ stack = <<>>
    /\ mode'    = "RUN"
    /\ startup' = "none"
    /\ stack'   = resume.stack
    /\ delay'   = resume.delay
    /\ resume'  = [NothingKept EXCEPT !.due = resume.due]
    /\ requests' \in RequestsInRun(requests)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, clock, settingVars, stopCause>>

(* [OBS-45] Nothing runs in HOLD and delays stand still [DINT-19]; the     *)
(* clock goes on. [T15-121] It may interrupt STARTUP.                      *)
Hold ==
    /\ mode = "RUN" \/ (mode = "STARTUP" /\ Family.holdsStartup)
    /\ mode' = "HOLD"
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, startup, resume, clock, settingVars,
                   outcomeVars, runVars>>

(* HOLD ends: points may have passed meanwhile, those that equal the clock *)
(* only of the OBs `equal'.                                                *)
\* @type: Set(Int) => Bool;
RearmPassed(equal) ==
    LET \* @type: Int => $moment;
        now(o) == IF o \in equal THEN [clock EXCEPT !.ms = @ + 1] ELSE clock
        passed == { o \in DOMAIN tod :
                      tod[o].active /\ IsPast(NextMoment(tod[o]), now(o)) }
    IN  \E c \in CpusThatShow({ tod[o] : o \in passed \cup Held }, clock) :
          /\ cpu' = c
          /\ tod' = [ o \in DOMAIN tod |->
                        IF o \in Held THEN AfterHeld(o, now(o), c)
                        ELSE IF o \in passed THEN Rearmed(o, now(o), c, TRUE)
                        ELSE tod[o] ]

(* [OBS-46] OB 80 reports the points that passed in HOLD. A point that     *)
(* equals the clock may have passed, or is reached after HOLD [AMB-83].    *)
Release ==
    /\ mode = "HOLD"
    /\ mode' = IF startup = "none" THEN "RUN" ELSE "STARTUP"
    /\ \E equal \in SUBSET PointsAtClock :
         LET skipped == SkippedBy(clock) \cup Held \cup equal
         IN  /\ IF skipped = {} THEN Nothing
                ELSE Skip(SkippedInHold, clock, skipped)
             /\ RearmPassed(equal)
    /\ UNCHANGED <<loaded, startup, resume, clock, dint, irt, runVars>>

-----------------------------------------------------------------------------
(* STOP and hot restart *)

(* [OBS-52] [OBS-54] What STOP leaves to a hot restart. STOP in STARTUP    *)
(* ends the startup OB for good. [AMB-57] A CPU that remembers served      *)
(* points notes which runs STOP has dropped: these have served none.       *)
KeptByStop ==
    LET before == IF mode = "STARTUP" THEN resume
                  ELSE [NothingKept EXCEPT !.stack = stack, !.delay = delay]
    IN  IF ~HotRestartExists
        THEN [NothingKept EXCEPT !.requests = { r \in requests :
                                          Remembers /\ r.ob \in TodObs }]
        ELSE [ before EXCEPT !.dint = dint, !.requests = requests,
                             !.due = FALSE ]

(* [OBS-41] [AIRT-11] Nothing waits in STOP, and no delay runs. Settings    *)
(* made by SFCs lose their effect at a warm or cold restart [DINT-13].     *)
Clears ==
    /\ delay'     = 0
    /\ stopCause' = NoCause
    /\ dint' = NoJobs
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, clock, tod, irt>>

\* @type: $resume => Bool;
StopLeaves(kept) ==
    /\ mode # "STOP"
    /\ mode'      = "STOP"
    /\ startup'   = "none"
    /\ stack'     = <<>>
    /\ resume'    = kept
    /\ requests'  = {}
    /\ Clears

(* [OBS-41] [OBS-47] The CPU may be stopped at any time.                   *)
Stop == StopLeaves(KeptByStop)

(* [OBS-26] STOP in the place of OB 80, which no longer waits for the      *)
(* latest excess of the cycle time.                                        *)
StopForCycleTime ==
    \E r \in requests :
      /\ r.ob = TimeErrorOb /\ r.fault = CycleTimeExceeded
      /\ \A q \in requests :
           q.ob = r.ob /\ q.fault = r.fault => q.rank <= r.rank
      /\ StopLeaves([KeptByStop EXCEPT !.requests = Remove(@, r)])

(* [OBS-52] Diagnostic interrupts are discarded; [AMB-26] (b) and so are   *)
(* interrupts that a program sets.                                         *)
\* @type: $request => Bool;
Outlives(r) == /\ r.ob # DiagnosticOb
               /\ HotRestartKeepsSettings \/ r.ob \notin TodObs \cup DintObs

(* [AMB-26] The settings after a hot restart. Points that have passed      *)
(* since STOP will be noticed, or are lost; those that equal the clock     *)
(* have passed only of the OBs `equal'.                                    *)
\* @type: (Set(Int), Bool) => Bool;
PassedInStop(equal, noticed) ==
    LET \* @type: Int => $moment;
        now(o) == IF o \in equal THEN [clock EXCEPT !.ms = @ + 1] ELSE clock
        passed == Held \cup SkippedBy(clock) \cup equal
        \* @type: $cpu => (Int -> $tod);
        armed(c) == [ o \in DOMAIN tod |->
                        IF o \notin passed THEN tod[o]
                        ELSE IF HasOnePoint(tod[o].period)
                        THEN [tod[o] EXCEPT !.held = FALSE, !.next = Never]
                        ELSE Armed([tod[o] EXCEPT !.held = FALSE], now(o), c) ]
    IN  IF noticed
        THEN /\ cpu' = cpu
             /\ tod' = [ o \in DOMAIN tod |->
                           [tod[o] EXCEPT !.held = o \in passed] ]
             /\ resume' = [ resume EXCEPT !.dint = NoJobs, !.requests = {},
                                      !.due = passed # {} ]
        ELSE /\ \E c \in CpusThatShow({ tod[o] : o \in passed }, clock) :
                  cpu' = c /\ tod' = armed(c)
             /\ resume' = [resume EXCEPT !.dint = NoJobs, !.requests = {}]

(* [OBS-52] [OBS-53] [IRT-03] [DINT-13] [AMB-26] *)
Resumes ==
    /\ RestartExists("hot")
    /\ startup'   = "hot"
    /\ requests'  = Close({ r \in resume.requests : Outlives(r) })
    /\ stopCause' = RestartStop
    /\ delay' = 0
    /\ IF HotRestartKeepsSettings
       THEN /\ dint' = resume.dint
            /\ irt' = irt
            /\ \E equal \in SUBSET PointsAtClock, noticed \in BOOLEAN :
                 PassedInStop(equal, noticed)
       ELSE /\ dint' = NoJobs
            /\ irt' = NoneBlocked
            /\ Reconfigure([resume EXCEPT !.dint = NoJobs, !.requests = {}])
    /\ UNCHANGED <<loaded, clock>>

(* [OBS-40] *)
\* @type: Str => Bool;
Restart(type) ==
    /\ mode = "STOP"
    /\ IF type = "hot" THEN Resumes ELSE ResetsAll(type)
    /\ mode'    = "STARTUP"
    /\ entered' = IF RestartStop = NoCause THEN {} ELSE {Entry(RestartStop)}
    /\ stack'   = <<>>
=============================================================================

----------------------------- MODULE LooseModes -----------------------------
(***************************************************************************)
(* Logs that do not tell when an OB has to start (LooseLogs): their other  *)
(* lines, and time that elapses.                                           *)
(*                                                                         *)
(* If changes of the mode may be unseen, `mode' is always RUN and forbids  *)
(* nothing.                                                                *)
(* Source: docs/checking/log-format.md, fine point 9.                      *)
(* Left out: entries of the diagnostic buffer, except that of DIS_IRT.     *)
(***************************************************************************)
EXTENDS LooseLogs

-----------------------------------------------------------------------------
(* OBs start and end *)

(* OB 1 and the startup OB stand first in the stack. *)
\* @type: $event => Bool;
LooseFirstStarts(e) ==
    /\ ModeKnown => mode = IF e.ob = CycleOb THEN "RUN" ELSE "STARTUP"
    /\ e.ob = CycleOb => MayRun
    /\ StackKnown => Len(stack) = 1
    /\ Fits(e.info.priority, IF e.ob = CycleOb THEN 1 ELSE 27)
    /\ e.ob # CycleOb => MayBeLoaded(e.ob)
    /\ stack' = <<stack[1]>>
    /\ delay' = 0

\* @type: $event => Bool;
LooseStart(e) ==
    /\ IF e.ob \in {CycleOb} \cup StartupObs THEN LooseFirstStarts(e)
       ELSE LooseInterruptStarts(e)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars>>

\* @type: $event => Bool;
LooseEnd(e) ==
    /\ ModeKnown => mode \notin {"STOP", "HOLD"}
    /\ \/ Unseen("ob") /\ UNCHANGED stack
       \/ /\ Running.ob = e.ob /\ Len(stack) > 1
          /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
       \/ /\ e.ob \in {CycleOb} \cup StartupObs
          /\ ModeKnown => /\ Len(stack) = 1
                          /\ mode = IF e.ob = CycleOb THEN "RUN" ELSE "STARTUP"
          /\ stack' = <<stack[1]>>
    /\ delay' = 0
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars>>

-----------------------------------------------------------------------------
(* Modes *)

\* @type: $event => Bool;
LooseRestart(e) ==
    /\ ModeKnown => mode = "STOP"
    /\ RestartExists(e.type)
    /\ mode'  = IF ModeKnown THEN "STARTUP" ELSE "RUN"
    /\ startup' = e.type
    /\ tod'   = [o \in TodObs |-> Configured(cpu.step7[o])]
    /\ dint' = NoJobs /\ irt' = NoneBlocked /\ delay' = 0
    /\ requests'  = RestartRequests
    /\ stopCause' = RestartStop
    /\ stack' = <<Frame(StartupOb(e.type), 27)>>
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, clock>>

\* @type: $event => Bool;
LooseRun(e) ==
    /\ ModeKnown => mode = "STARTUP"
    /\ MayRun
    /\ mode' = "RUN" /\ startup' = "none" /\ stack' = <<Frame(CycleOb, 1)>>
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, clock, settingVars, outcomeVars, delay>>

\* @type: $event => Bool;
LooseStop(e) ==
    /\ IF mode = "STOP" THEN UNCHANGED <<mode, stack>>
       ELSE /\ mode' = IF ModeKnown THEN "STOP" ELSE "RUN"
            /\ stack' = IF ModeKnown THEN <<>> ELSE <<Frame(CycleOb, 1)>>
    /\ requests' = {} /\ dint' = NoJobs /\ delay' = 0 /\ stopCause' = NoCause
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, startup, clock, tod, irt>>

\* @type: Str => Bool;
LooseHold(to) ==
    /\ ModeKnown => mode = IF to = "HOLD" THEN "RUN" ELSE "HOLD"
    /\ mode' = IF ModeKnown THEN to ELSE "RUN"
    /\ requests' = IF to = "RUN" /\ Timed \cap TodObs # {}
                   THEN requests \cup {Mark(TimeErrorOb, SkippedInHold)}
                   ELSE requests
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, startup, clock, settingVars, stopCause,
                   runVars>>

-----------------------------------------------------------------------------
(* The clock, start events, entries, the state of an OB *)

(* [TINT-11] Between now and t lies a whole minute: a possible point.      *)
\* @type: $moment => Bool;
PassesMinute(t) ==
    Before(IF SecondsAreKept THEN clock
           ELSE At(IF clock.ms = 0 THEN clock.min ELSE clock.min + 1), t)

(* ... of an interrupt that may be active.                                 *)
\* @type: $moment => Bool;
PassesPoint(t) ==
    /\ PassesMinute(t)
    /\ \E o \in Timed \cap TodObs :
         \/ Unseen("call")
         \/ \E s \in {tod[o], Configured(cpu.step7[o])} :
              s.active /\ ~Before(t, [ min |-> PointFrom(s, clock.min),
                                      ms |-> s.offset ])

(* The marks of OB 80 where the CPU may skip points up to moment t with    *)
(* these faults: by a setting of the clock, or in an unseen HOLD.          *)
\* @type: ($moment, Set(Int)) => Set($request);
SkipMarks(t, faults) == IF faults # {} /\ mode # "STOP" /\ PassesPoint(t)
                        THEN { Mark(TimeErrorOb, f) : f \in faults } ELSE {}

\* @type: Set(Int);
SkipsInHold == IF ModeKnown THEN {} ELSE {SkippedInHold}

\* @type: $event => Bool;
LooseClock(e) ==
    /\ clock' = e.to
    /\ requests' = requests
                     \cup SkipMarks(e.to, {SkippedByClock} \cup SkipsInHold)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, settingVars, stopCause, runVars>>

\* @type: $event => Bool;
LooseEvent(e) ==
    /\ requests' =
         IF mode = "STOP" THEN requests
         ELSE requests \cup {Mark(e.ob, IF e.flt_id = -1 THEN 0 ELSE e.flt_id)}
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                   runVars>>

(* [OBS-26] The cycle time may have been exceeded twice: the entry of that *)
(* STOP is 4568, too, though OB 80 is loaded.                              *)
CycleMayBeExceeded ==
    \/ Unseen("interrupt")
    \/ Mark(TimeErrorOb, CycleTimeExceeded) \in requests

(* An unseen event may have caused this entry.                             *)
\* @type: $event => Bool;
LooseEntry(e) ==
    /\ e.id - ErrorEntry \in ObNotLoaded => MissingMayBeRequested
    /\ e.id = NoTimeErrorOb =>
         MayBeMissing(TimeErrorOb) \/ CycleMayBeExceeded
    /\ e.id = NoProgramErrorOb => MayBeMissing(ProgramErrorOb)
    /\ NothingEntered
    /\ UNCHANGED <<cpuVars, reports>>

\* @type: $event => Bool;
LooseState(e) ==
    LET known == mode # "STOP" /\ ~Unseen("call")
        bit1  == { b \div 2 : b \in LooseBit1(e.ob) }
        bit2  == { b \div 4 : b \in LooseBit2(e.ob) }
    IN  /\ Unseen("load") \/ FitsTruth(e.loaded, e.ob \in loaded)
        /\ known => /\ e.blocked \in {-1} \cup bit1
                    /\ e.entries_off = 1 => Silenced(e.ob)
                    /\ e.entries_off = 0 /\ Silenced(e.ob) => ~ModeKnown
                    /\ e.ob \in TodObs \cup DintObs =>
                         e.active \in {-1} \cup bit2
                    /\ ModeKnown => FitsLeft(e)
        /\ NothingEntered
        /\ UNCHANGED cpuVars

-----------------------------------------------------------------------------
(* Lines *)

\* @type: $event => Bool;
LooseShows(e) ==
    /\ CASE e.event \in CallEvents -> LooseCall(e)
         [] e.event = "start"      -> LooseStart(e)
         [] e.event = "end"        -> LooseEnd(e)
         [] e.event = "interrupt"  -> LooseEvent(e)
         [] e.event = "clock"      -> LooseClock(e)
         [] e.event = "load"       -> LooseLoad(e.ob)
         [] e.event = "delete"     -> LoadedAre(loaded \ {e.ob})
         [] e.event = "restart"    -> LooseRestart(e)
         [] e.event = "run"        -> LooseRun(e)
         [] e.event = "hold"       -> LooseHold("HOLD")
         [] e.event = "release"    -> LooseHold("RUN")
         [] e.event = "stop"       -> LooseStop(e)
         [] e.event = "diag"       -> IF CauseUnseen(e.id) THEN LooseEntry(e)
                                      ELSE IsEntry(e)
         [] e.event = "state"      -> LooseState(e)
    /\ UNCHANGED <<terms, up, waiting, eventVars>>
    /\ IF e.event = "diag" THEN TRUE ELSE Report(0)

-----------------------------------------------------------------------------
(* Time *)

(* Without `up' in a line nobody knows how much time has elapsed if the    *)
(* clock may have been set.                                                *)
\* @type: $event => Bool;
ElapsedKnown(e) == ~Unseen("clock") \/ e.counter # NoMoment

(* A delay ends at the earliest when so many ms have elapsed. An unseen    *)
(* HOLD may have made it longer.                                           *)
\* @type: (Int, Bool) => (Int -> $job);
LooseJobs(d, known) ==
    [ o \in DintObs |->
        IF ~dint[o].started \/ mode = "HOLD" \/ dint[o].left = Gone
        THEN dint[o]
        ELSE [ dint[o] EXCEPT !.left = IF known /\ @ - d > 1 THEN @ - d
                                                             ELSE Gone ] ]

\* @type: $event => Bool;
LooseElapse(e) ==
    LET d     == Span(up, e.up)
        known == ElapsedKnown(e)
    IN  /\ known => EntriesLate(d) = {}
        /\ clock' = e.at
        /\ up' = e.up
        /\ dint' = LooseJobs(d, known)
        /\ requests' = requests
             \cup { Mark(o, 0) : o \in { j \in DintObs :
                                   dint'[j].started /\ dint'[j].left = Gone } }
             \cup SkipMarks(e.at, SkipsInHold)
        /\ reports' = IF known THEN ReportsAfter(d) ELSE reports
        /\ NothingEntered
        /\ UNCHANGED <<deviceVars, modeVars, tod, irt, stopCause, runVars,
                       lineVars, waiting, eventVars>>
=============================================================================

-------------------------------- MODULE Lines -------------------------------
(***************************************************************************)
(* The action that a line of a log stands for.                             *)
(*                                                                         *)
(* Source: docs/log-format.md, events; fine points 6 to 8 and 10.          *)
(* Left out: lines of kinds that the log does not have completely          *)
(* (PartialLogs).                                                          *)
(***************************************************************************)
EXTENDS Modes, CallLines, Elapsing

(* Table 7.5: the first OB 1 after a restart has another event than the    *)
(* following ones.  In a log that begins in RUN it may be any of them.     *)
CycleEvents == CASE first = "warm" -> {1}
                 [] first = "cold" -> {4}
                 [] first = "none" -> {3}
                 [] OTHER          -> 1..4

\* @type: $event => Bool;
IsStart(e) ==
    CASE e.ob = CycleOb ->
           /\ Fits(e.info.priority, 1)
           /\ e.info.strt_info \in {-1} \cup CycleEvents
           /\ ~Before(clock, e.info.time)
           /\ \/ CycleStarts
              \/ /\ ~terms.cycle /\ stack = <<Frame(CycleOb, 1)>>
                 /\ delay' = 0
                 /\ NothingEntered
                 /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint,
                                irt, requests, stack, stopCause>>
      [] e.ob \in StartupObs ->
           /\ Fits(e.info.priority, 27)
           /\ e.info.strt_info \in {-1} \cup (IF e.ob = 100 THEN \h81..\h82
                                                          ELSE \h85..\h86)
           /\ ~Before(clock, e.info.time)
           /\ StartupStarts(e.ob)
      [] OTHER ->
           \E r \in { q \in requests : q.ob = e.ob /\ FitsRequest(q, e.info) } :
             Start(r)

(* A line that sets the clock to its own reading changes nothing.          *)
\* @type: $event => Bool;
IsClock(e) ==
    IF e.to = clock THEN UNCHANGED cpuVars /\ NothingEntered ELSE ClockSet(e.to)

(* The switch may be turned at any time; in STOP it has no effect.  A      *)
(* cause is that of the rule, if a rule stops the CPU.                     *)
\* @type: $event => Bool;
IsStop(e) ==
    /\ IF mode = "STOP" THEN UNCHANGED cpuVars /\ NothingEntered ELSE Stop
    /\ \/ e.cause = -1
       \/ /\ { r \in MissingNow : ~r.open } = {}
          /\ stopCause \in {NoCause, OtherErrorOb, e.cause}
       \/ delay > 0 /\ ~StopIsNotDelayed  \* the rule may come later

\* @type: $event => Bool;
Shows(e) ==
    /\ CASE e.event \in CallEvents -> IsCall(e)
         [] e.event = "start"      -> IsStart(e)
         [] e.event = "end"        -> End(e.ob)
         [] e.event = "interrupt"  ->
              Interrupt(e.ob, IF e.flt_id = -1 THEN 0 ELSE e.flt_id)
         [] e.event = "clock"      -> IsClock(e)
         [] e.event = "load"       -> LoadedAre(loaded \cup {e.ob})
         [] e.event = "delete"     -> LoadedAre(loaded \ {e.ob})
         [] e.event = "restart"    -> Restart(e.type)
         [] e.event = "run"        -> Run /\ stopCause = NoCause  \* [OBS-22] [OBS-25]
         [] e.event = "hold"       -> Hold
         [] e.event = "release"    -> Release
         [] e.event = "stop"       -> IsStop(e)
         [] e.event = "diag"       -> IsEntry(e)
    /\ IF e.event = "diag" THEN UNCHANGED <<waiting, first>> ELSE Rewait
    /\ UNCHANGED <<terms, up>>
=============================================================================

---------------------------- MODULE OutsideEvents ---------------------------
(***************************************************************************)
(* Start events from outside: cyclic and hardware interrupts, asynchronous *)
(* errors (sections 5.1 to 5.3).                                           *)
(*                                                                         *)
(* Left out: cycle time monitoring, OB 80 with fault 01 [OBS-26]; it comes *)
(* as a start event from outside.                                          *)
(***************************************************************************)
EXTENDS StartEvents

(* [AMB-67] In HOLD, and in STARTUP unless it is an error, an event waits  *)
(* for RUN, is lost, or either.                                            *)
\* @type: $request => Bool;
OutsideRun(new) ==
    IF OutsideRunEventsAreLost THEN Nothing
    ELSE LET again == PendingIn(requests, new.ob) \/ OpenIn(requests, new.ob)
             kept  == IF again THEN LeftOpen(new)
                      ELSE {[new EXCEPT !.open = OutsideRunEventsAreOpen]}
             shown == (IF new.fault = 0 THEN {} ELSE {new})
                        \cup (IF again THEN ErrorsOf(new) ELSE {})
         IN  /\ requests' = EnterAll(requests, kept)
             /\ UNCHANGED stopCause
             /\ entered' = OpenEntries(shown)

\* @type: Int => Bool;
KeptFromRunning(o) ==
    mode = "HOLD" \/ (mode = "STARTUP" /\ o \notin AsyncErrorObs)

(* [OBS-07] In STOP nothing happens [OBS-41]. *)
\* @type: $request => Bool;
Comes(new) ==
    IF mode = "STOP" \/ Deselected(new.ob) THEN Nothing
    ELSE IF new.ob = TimeErrorOb /\ mode # "HOLD"
    THEN TimeErrorOccurs(requests, requests, new)
    ELSE IF Blocked(new.ob)
    THEN IF new.fault = 0 THEN Lost(new.ob) ELSE ErrorLost(new)
    ELSE IF KeptFromRunning(new.ob) THEN OutsideRun(new)
    ELSE IF new.ob \in AsyncErrorObs THEN ErrorOccurs(new)
    ELSE Occurs(new)

(* [OBS-07] *)
\* @type: (Int, Int) => Bool;
Interrupt(o, fault) ==
    /\ Comes(ExternalRequest(o, fault))
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, runVars>>
=============================================================================

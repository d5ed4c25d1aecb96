----------------------------- MODULE Scheduler ------------------------------
(***************************************************************************)
(* OBs start and end: start events from outside, dispatch of requests,     *)
(* missing OBs, the cycle of OB 1 (catalogue sections 5.1 and 5.2).        *)
(*                                                                         *)
(* Left out: cycle time monitoring, OB 80 with fault 01 [OBS-26]; it comes *)
(* as a start event from outside.                                          *)
(***************************************************************************)
EXTENDS Clock

(* [OBS-07] [OBS-02] A start event from outside.  While the OB runs or      *)
(* waits already, what happens is open [AMB-77] [AMB-18]; so it is in       *)
(* STARTUP and HOLD [AMB-67].  In STOP nothing happens [OBS-41].           *)
\* @type: (Int, Int) => Bool;
Interrupt(o, fault) ==
    LET new  == ExternalRequest(o, fault)
        open == EnterAll(requests, LeftOpen(new, 0))
    IN  /\ IF mode = "STOP" \/ Deselected(o) THEN Nothing
           ELSE IF mode = "HOLD"
           THEN /\ requests' = Enter(requests, [new EXCEPT !.open = TRUE])
                /\ UNCHANGED stopCause
           ELSE IF o = TimeErrorOb
           THEN /\ requests'  = WithTimeError(requests, new)
                /\ stopCause' = StopOfTimeError
           ELSE IF o \in AsyncErrorObs
           THEN requests' = Enter(requests, new) /\ UNCHANGED stopCause
           ELSE /\ UNCHANGED stopCause
                /\ IF OnStack(o) \/ PendingIn(requests, o)
                   THEN requests' = open
                   ELSE IF mode = "STARTUP"
                   THEN requests' = Enter(requests, [new EXCEPT !.open = TRUE])
                   ELSE IF OpenIn(requests, o)
                   THEN requests' \in EnterAmongOpen(new, 0)
                   ELSE requests' = Enter(requests, new)
        /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, stack,
                       delay>>

(* What is open has no effect: seen when its OB could start. *)
\* @type: $request => Bool;
Drop(r) ==
    /\ MayStart(r)
    /\ r.open
    /\ requests' = Close(requests \ {r})
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, stack, delay,
                   stopCause>>

(* [TINT-08] [AMB-71] A once interrupt is cancelled when its OB starts, also *)
(* where the clock was set back meanwhile and its point is ahead again      *)
(* [AMB-59] [CLK-12]; not one that was set anew.                           *)
\* @type: $request => Bool;
LastCall(r) ==
    /\ r.ob \in TodObs /\ tod[r.ob].active /\ tod[r.ob].period = Once
    /\ tod[r.ob].next = Never \/ r.since = At(tod[r.ob].start)

\* @type: $request => (Int -> $tod);
TodAfterCall(r) ==
    IF LastCall(r) THEN [tod EXCEPT ![r.ob] = UsedUp(@)] ELSE tod

(* What else waits for a cancelled interrupt is withdrawn [AMB-11]. *)
\* @type: $request => Set($request);
RequestsAfterCall(r) ==
    IF LastCall(r) THEN Withdraw(Remove(requests, r), r.ob)
                   ELSE Remove(requests, r)

(* [OBS-01] [OBS-02] [OBS-03] For a request r that waits. *)
\* @type: $request => Bool;
Start(r) ==
    /\ MayStart(r)
    /\ r.ob \in loaded
    /\ stack'    = Append(stack, Frame(r.ob, r.class))
    /\ requests' = RequestsAfterCall(r)
    /\ tod'      = TodAfterCall(r)
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, delay, stopCause>>

(* [AMB-45] An OB 85 may have been for all OBs that are missing when it ends. *)
Excused == { [ r EXCEPT !.open = @ \/ (r.ob \notin loaded \cup AsyncErrorObs) ]
             : r \in requests }

(* [AIRT-04] The delay count falls to 0 when the OB has been processed. *)
\* @type: Int => Bool;
End(o) ==
    /\ Running.ob = o
    /\ mode # "HOLD"
    /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
    /\ delay' = 0
    /\ requests' = IF o = ProgramErrorOb THEN Excused ELSE requests
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, stopCause>>

(* [TINT-16] [OBS-20] [AMB-44] The OB is missing when it would start: OB 85, *)
(* once for all missing OBs or once for each [AMB-45].  The source stays as *)
(* it is [AMB-46].                                                         *)
\* @type: $request => Bool;
ProgramError(r) ==
    LET rest  == Remove(requests, r)
        error == [ ExternalRequest(ProgramErrorOb, \hA2) EXCEPT
                     !.cause = r.ob, !.word = r.word, !.during = Running.ob ]
    IN  /\ \/ requests' = Enter(rest, error)
           \/ /\ OnStack(ProgramErrorOb) \/ PendingIn(rest, ProgramErrorOb)
              /\ requests' = rest
        /\ UNCHANGED stopCause

(* [OBS-23] [AMB-75] Other asynchronous errors without their OB. *)
\* @type: $request => Bool;
ErrorObMissing(r) ==
    /\ requests' = Remove(requests, r)
    /\ \/ r.ob \in {70, 72, 81, 84, 87} /\ UNCHANGED stopCause
       \/ /\ r.ob \in {82, 83, 84, 86}
          /\ stopCause' = OtherErrorOb
       \/ /\ r.ob = ProgramErrorOb  \* [OBS-21]
          /\ stopCause' = NoProgramErrorOb
       \/ /\ r.ob = TimeErrorOb     \* deleted while it was waited for
          /\ stopCause' = NoTimeErrorOb

\* @type: $request => Bool;
Missing(r) ==
    /\ MayStart(r)
    /\ r.ob \notin loaded
    /\ IF r.ob \in AsyncErrorObs \cup {70, 72} THEN ErrorObMissing(r)
                                               ELSE ProgramError(r)
    /\ tod' = TodAfterCall(r)
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, stack, delay>>

(* Blocks are loaded and deleted at any time.  An OB that runs goes on to   *)
(* its end; a deleted one is missing when it would start [AMB-66].         *)
\* @type: Set(Int) => Bool;
LoadedAre(obs) ==
    /\ loaded' = obs
    /\ UNCHANGED <<cpu, mode, startup, clock, tod, requests, stack,
                   delay, stopCause>>

-----------------------------------------------------------------------------
(* OB 1 and the startup OB *)

(* OB 1 is always there; it starts when nothing runs. *)
CycleStarts ==
    /\ mode = "RUN"
    /\ stack = <<>>
    /\ stack' = <<Frame(CycleOb, 1)>>
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, requests,
                   delay, stopCause>>

(* [OBS-42] [OBS-55] *)
\* @type: Int => Bool;
StartupStarts(o) ==
    /\ startup \in {"warm", "cold"}
    /\ o = StartupOb(startup)
    /\ o \in loaded
    /\ stack = <<>>
    /\ stack'   = <<Frame(o, 27)>>
    /\ startup' = "begun"
    /\ UNCHANGED <<cpu, loaded, mode, clock, tod, requests, delay,
                   stopCause>>
=============================================================================

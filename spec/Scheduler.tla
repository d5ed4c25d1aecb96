----------------------------- MODULE Scheduler ------------------------------
(***************************************************************************)
(* OBs start and end: start events from outside, dispatch of requests,     *)
(* missing OBs, the cycle of OB 1 (catalogue sections 5.1 and 5.2).        *)
(*                                                                         *)
(* Left out: cycle time monitoring, OB 80 with fault 01 [OBS-26]; it comes *)
(* as a start event from outside.                                          *)
(***************************************************************************)
EXTENDS Clock

(* [OBS-07] A start event from outside.  In STOP nothing happens [OBS-41];   *)
(* in STARTUP and HOLD it may be kept or lost [AMB-67], but for errors in  *)
(* STARTUP.                                                                *)
\* @type: (Int, Int) => Bool;
Interrupt(o, fault) ==
    LET new == ExternalRequest(o, fault)
    IN  /\ IF mode = "STOP" \/ Deselected(o) THEN Nothing
           ELSE IF o = TimeErrorOb /\ mode # "HOLD"
           THEN TimeErrorOccurs(requests, requests, new)
           ELSE IF Blocked(o)
           THEN /\ UNCHANGED <<requests, stopCause>>
                /\ entered' = IF fault = 0 THEN EntriesOfLost(o) ELSE EntriesOf(new)
           ELSE IF mode = "HOLD" \/ (mode = "STARTUP" /\ o \notin AsyncErrorObs)
           THEN IF OutsideRunEventsAreLost THEN Nothing
                ELSE IF PendingIn(requests, o) \/ OpenIn(requests, o)
                THEN AnyEffect(new)
                ELSE /\ requests' = Enter(requests,
                                  [new EXCEPT !.open = OutsideRunEventsAreOpen])
                     /\ UNCHANGED stopCause
                     /\ entered' = IF fault = 0 THEN {} ELSE OpenEntries({new})
           ELSE IF o \in AsyncErrorObs THEN ErrorOccurs(new)
           ELSE Occurs(new)
        /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, stack,
                       delay>>

(* What is open has no effect: seen when its OB could start. *)
\* @type: $request => Bool;
Drop(r) ==
    /\ MayStart(r)
    /\ r.open
    /\ requests' = Close(requests \ {r})
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, stack,
                   delay, stopCause>>

(* [TINT-08] A once interrupt is cancelled by the call of its OB, also       *)
(* where the clock was set back meanwhile and its point is ahead again     *)
(* [AMB-59] [CLK-12]; not one that was set anew.                           *)
\* @type: $request => Bool;
LastCall(r) ==
    /\ r.ob \in TodObs /\ tod[r.ob].active /\ tod[r.ob].period = Once
    /\ tod[r.ob].next = Never \/ r.since = FirstMoment(tod[r.ob])

(* [AMB-71] At the start of the OB; under (c) at its end. *)
\* @type: $request => (Int -> $tod);
TodAfterCall(r) ==
    IF LastCall(r) /\ ~OnceUsedUpAtItsEnd
    THEN [tod EXCEPT ![r.ob] = UsedUp(@)] ELSE tod

\* @type: Int => (Int -> $tod);
TodAfterEnd(o) ==
    IF /\ o \in TodObs /\ OnceUsedUpAtItsEnd
       /\ tod[o].active /\ tod[o].period = Once /\ tod[o].next = Never
       /\ ~PendingIn(requests, o)
    THEN [tod EXCEPT ![o] = UsedUp(@)] ELSE tod

(* [AMB-46] After a missing OB; under (b) its source is disabled. *)
\* @type: $request => (Int -> $tod);
TodAfterMissing(r) ==
    IF r.ob \in TodObs /\ MissingObEndsItsSource
    THEN [tod EXCEPT ![r.ob].active = FALSE, ![r.ob].next = Never]
    ELSE TodAfterCall(r)

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
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, dint, irt, delay, stopCause>>

(* [AMB-45] An OB 85 may have been for all OBs that are missing when it ends. *)
Excused ==
    LET missing == { r \in requests : r.ob \notin loaded \cup AsyncErrorObs }
    IN  CASE OneOb85ForAll  -> Close(requests \ missing)
          [] OneOb85ForEach -> requests
          [] OTHER -> (requests \ missing)
                        \cup { [r EXCEPT !.open = TRUE] : r \in missing }

(* [AIRT-04] The delay count falls to 0 when the OB has been processed       *)
(* [AMB-25].                                                               *)
\* @type: Int => Bool;
End(o) ==
    /\ Running.ob = o
    /\ mode # "HOLD"
    /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
    /\ delay' = IF o = CycleOb /\ CountOutlivesTheCycle THEN delay ELSE 0
    /\ requests' = IF o = ProgramErrorOb THEN Excused ELSE requests
    /\ tod' = TodAfterEnd(o)
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, dint, irt, stopCause>>

-----------------------------------------------------------------------------
(* Missing OBs *)

(* [TINT-16] [DINT-09] [OBS-20] [AMB-06] The OB is missing when it would     *)
(* start: OB 85.  Where that was noticed when it was activated or its      *)
(* delay started, it may be nothing; under AMB-06 (c) it is OB 80.          *)
\* @type: $request => Bool;
ObMissing(r) ==
    LET known == \/ r.ob \in TodObs /\ MissingNoticedAtActivation
                 \/ r.ob \in DintObs /\ MissingNoticedAtSrtDint
    IN  \/ IF MissingIsTimeError /\ r.ob \in TodObs \cup DintObs
           THEN TimeErrorOccurs(RequestsAfterCall(r), RequestsAfterCall(r),
                                TimeError(UnknownFault, {}, r.ob, r.word))
           ELSE ProgramErrorOccurs(RequestsAfterCall(r), r)
        \/ /\ known
           /\ requests' = RequestsAfterCall(r)
           /\ UNCHANGED stopCause /\ NothingEntered

(* [OBS-23] [AMB-75] Asynchronous errors without their OB. *)
ErrorObsNotMissed ==
    IF ErrorObsAreNotReported THEN {70, 72, 81, 84, 87} ELSE {81}
ErrorObsAs85 ==
    IF ErrorObsAreNotReported THEN {} ELSE {70, 72, 84, 87}
ErrorObsThatStop == {82, 83, 84, 86} \ ErrorObsAs85

\* @type: $request => Bool;
ErrorObMissing(r) ==
    \/ /\ r.ob \in ErrorObsAs85
       /\ ProgramErrorOccurs(Remove(requests, r), r)
    \/ /\ r.ob \in ErrorObsNotMissed
       /\ requests' = Remove(requests, r)
       /\ UNCHANGED stopCause /\ NothingEntered
    \/ /\ r.ob \in ErrorObsThatStop
       /\ requests' = Remove(requests, r)
       /\ stopCause' = StopFor(OtherErrorOb)
       /\ NothingEntered
    \/ /\ r.ob \in {ProgramErrorOb, TimeErrorOb}  \* OB 80: deleted meanwhile
       /\ requests' = Remove(requests, r)
       /\ LET cause == IF r.ob = ProgramErrorOb THEN NoProgramErrorOb  \* [OBS-21]
                                                ELSE NoTimeErrorOb
          IN  stopCause' = StopFor(cause) /\ entered' = EntriesOfStop(cause)

\* @type: $request => Bool;
Missing(r) ==
    /\ MayStart(r)
    /\ r.ob \notin loaded
    /\ IF r.ob \in AsyncErrorObs \cup {70, 72} THEN ErrorObMissing(r)
                                               ELSE ObMissing(r)
    /\ tod' = TodAfterMissing(r)
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, dint, irt, stack, delay>>

(* Blocks are loaded and deleted at any time.  An OB that runs goes on to   *)
(* its end; a deleted one is missing when it would start [AMB-66].         *)
\* @type: Set(Int) => Bool;
LoadedAre(obs) ==
    /\ loaded' = obs
    /\ requests' = IF obs \subseteq loaded /\ obs # loaded /\ DeletedObTakesRequests
                   THEN Close({ r \in requests : r.ob \notin loaded \ obs })
                   ELSE requests
    /\ NothingEntered
    /\ UNCHANGED <<cpu, mode, startup, clock, tod, dint, irt, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------
(* OB 1 and the startup OB *)

(* OB 1 is always there; it starts when nothing runs. *)
CycleStarts ==
    /\ mode = "RUN"
    /\ stack = <<>>
    /\ stack' = <<Frame(CycleOb, 1)>>
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, requests,
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
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, clock, tod, dint, irt, requests, delay,
                   stopCause>>
=============================================================================

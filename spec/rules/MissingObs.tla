----------------------------- MODULE MissingObs -----------------------------
(***************************************************************************)
(* OBs that are missing when they would start; blocks that are loaded and  *)
(* deleted while the CPU is at work (section 5.2).                         *)
(*                                                                         *)
(* Left out: the errors themselves (Errors).                               *)
(***************************************************************************)
EXTENDS StartEvents, Scheduler

(* [AMB-46] A missing OB counts as called; or its interrupt is not active. *)
\* @type: $request => (Int -> $tod);
TodAfterMissing(r) ==
    IF r.ob \in TodObs /\ MissingObEndsItsSource
    THEN [tod EXCEPT ![r.ob].active = FALSE, ![r.ob].next = Never]
    ELSE IF LastCall(r) THEN TodUsedUp(r.ob) ELSE tod

(* [AMB-06] The missing OB was noticed when the program set its interrupt. *)
\* @type: Int => Bool;
NoticedBefore(o) == \/ o \in TodObs /\ MissingNoticedAtActivation
                    \/ o \in DintObs /\ MissingNoticedAtSrtDint

(* [TINT-16] [DINT-09] [OBS-20] The OB is missing when it would start: OB  *)
(* 85, or OB 80 [AMB-06] (c); perhaps nothing if it was noticed before.    *)
\* @type: $request => Bool;
ObMissing(r) ==
    \/ IF MissingIsTimeError /\ r.ob \in TodObs \cup DintObs
       THEN TimeErrorOccurs(RequestsAfterCall(r), RequestsAfterCall(r),
                            TimeError(UnknownFault, {}, r.ob, r.word))
       ELSE ProgramErrorOccurs(RequestsAfterCall(r), r)
    \/ NoticedBefore(r.ob) /\ RequestsBecome(RequestsAfterCall(r))

(* [OBS-21] OB 85 is missing; OB 80 was deleted meanwhile. *)
\* @type: Int => Int;
CauseWithout(o) == IF o = ProgramErrorOb THEN NoProgramErrorOb
                                         ELSE NoTimeErrorOb

(* OB 84 is one of two kinds: a STOP, or nothing. *)
\* @type: $request => Bool;
ErrorObMissing(r) ==
    \/ /\ r.ob \in ErrorObsAs85
       /\ ProgramErrorOccurs(Remove(requests, r), r)
    \/ /\ r.ob \in ErrorObsNotMissed
       /\ RequestsBecome(Remove(requests, r))
    \/ /\ r.ob \in ErrorObsThatStop
       /\ requests' = Remove(requests, r)
       /\ stopCause' = StopFor(OtherErrorOb)
       /\ NothingEntered
    \/ /\ r.ob \in {ProgramErrorOb, TimeErrorOb}
       /\ requests' = Remove(requests, r)
       /\ stopCause' = StopFor(CauseWithout(r.ob))
       /\ entered' = EntriesOfStop(CauseWithout(r.ob))

\* @type: $request => Bool;
Missing(r) ==
    /\ MayStart(r)
    /\ r.ob \notin loaded
    /\ IF r.ob \in AsyncErrorObs \cup {70, 72} THEN ErrorObMissing(r)
                                               ELSE ObMissing(r)
    /\ tod' = TodAfterMissing(r)
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, runVars>>

-----------------------------------------------------------------------------
(* Blocks *)

(* A deleted OB takes its requests along, or is missing when it would      *)
(* start [AMB-66].                                                         *)
\* @type: Set(Int) => Set($request);
RequestsAfterDeletion(gone) ==
    IF gone # {} /\ DeletedObTakesRequests
    THEN Close({ r \in requests : r.ob \notin gone }) ELSE requests

(* Blocks are loaded and deleted at any time.  An OB that runs goes on to  *)
(* its end.                                                                *)
\* @type: Set(Int) => Bool;
LoadedAre(obs) ==
    /\ loaded'   = obs
    /\ requests' = RequestsAfterDeletion(loaded \ obs)
    /\ NothingEntered
    /\ UNCHANGED <<cpu, modeVars, clock, settingVars, stopCause, runVars>>
=============================================================================

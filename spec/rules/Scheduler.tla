------------------------------ MODULE Scheduler -------------------------------
(***************************************************************************)
(* OBs start and end: dispatch of requests, the cycle of OB 1, the startup *)
(* OBs; OBs that are missing when they would start; blocks that are loaded *)
(* and deleted while the CPU is at work (sections 5.1 and 5.2).            *)
(*                                                                         *)
(* Left out: the errors themselves (Errors).                               *)
(***************************************************************************)
EXTENDS StartEvents, TodSettings

(* An open request turns out to have no effect when its OB could start. *)
\* @type: $request => Bool;
Drop(r) ==
    /\ MayStart(r)
    /\ r.open
    /\ requests' = Close(requests \ {r})
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                   runVars>>

-----------------------------------------------------------------------------
(* One-shot interrupts *)

(* [TINT-08] The call of its OB cancels a one-shot interrupt, even if the  *)
(* clock was set back meanwhile and its point is ahead again [AMB-59]      *)
(* [CLK-12]. An interrupt that was set anew stays.                         *)
\* @type: $request => Bool;
LastCall(r) ==
    /\ r.ob \in TodObs /\ tod[r.ob].active /\ HasOnePoint(tod[r.ob].period)
    /\ tod[r.ob].next = Never \/ r.since = FirstMoment(tod[r.ob])

\* @type: Int => (Int -> $tod);
TodUsedUp(o) == [tod EXCEPT ![o] = UsedUp(@)]

(* [AMB-71] A one-shot interrupt is used up when its OB starts, or ends.   *)
(* A merged call has a run of its own after all [AMB-56].                  *)
\* @type: $request => Set(Int -> $tod);
TodsAfterStart(r) ==
    LET t == Confirms(tod[r.ob], r.since.min)
        \* @type: $tod => (Int -> $tod);
        becomes(u) == [tod EXCEPT ![r.ob] = u]
    IN  IF r.ob \notin TodObs THEN {tod}
        ELSE IF ~LastCall(r) THEN {becomes(t)}
        ELSE (IF OnceMayEndAtItsStart THEN {becomes(UsedUp(t))} ELSE {})
               \cup (IF OnceMayEndAtItsEnd
                     THEN {becomes([ t EXCEPT !.next = Never, !.called = TRUE,
                                       !.held = FALSE ])}
                     ELSE {})

\* @type: Int => (Int -> $tod);
TodAfterEnd(o) == IF o \in TodObs /\ tod[o].called THEN TodUsedUp(o) ELSE tod

(* A cancelled interrupt loses its other requests, too [AMB-11].           *)
\* @type: $request => Set($request);
RequestsAfterCall(r) ==
    IF LastCall(r) THEN Withdraw(Remove(requests, r), r.ob)
                   ELSE Remove(requests, r)

-----------------------------------------------------------------------------
(* Start and end *)

\* @type: $request => $frame;
FrameOf(r) == [ Frame(r.ob, r.class) EXCEPT
                  !.told = IF r.ob = TimeErrorOb THEN {} ELSE r.late ]

(* [T15-63] Where OB 121 or 122 stands between two runs of an OB, both     *)
(* know what was told of its overload.                                     *)
\* @type: $request => Seq($frame);
StackBelow(r) ==
    LET same == { i \in DOMAIN stack : stack[i].ob = r.ob }
        low  == CHOOSE i \in same : \A k \in same : i <= k
        high == CHOOSE i \in same : \A k \in same : k <= i
        told == FrameOf(r).told
    IN  IF same = {} THEN stack
        ELSE [ stack EXCEPT ![low].told  = @ \cup told,
                            ![high].told = @ \cup told ]

(* [OBS-01] [OBS-02] [OBS-03] The OB of request r starts. *)
\* @type: $request => Bool;
Start(r) ==
    /\ MayStart(r)
    /\ r.ob \in loaded
    /\ stack'    = Append(StackBelow(r), FrameOf(r))
    /\ requests' = RequestsAfterCall(r)
    /\ tod'      \in TodsAfterStart(r)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, stopCause, delay>>

(* [AMB-45] When OB 85 ends, it may have reported the missing OBs that are *)
(* called together: no call of a loaded OB lies between; all, if they are  *)
(* noticed when they are due [AMB-44].                                     *)
Excused ==
    LET \* @type: $request => Set($request);
        between(r) == { q \in Definite :
                          /\ q.ob \in loaded \ {ProgramErrorOb}
                          /\ \/ q.class > r.class
                             \/ q.class = r.class /\ q.rank < r.rank }
        missing == { r \in requests :
                       /\ r.ob \notin loaded \cup AsyncErrorObs
                       /\ MissingNoticedWhenDue \/ between(r) = {} }
    IN  CASE OneOb85ForAll  -> Close(requests \ missing)
          [] OneOb85ForEach -> requests
          [] OTHER -> (requests \ missing)
                        \cup { [r EXCEPT !.open = TRUE] : r \in missing }

(* [AMB-25] [OBS-62] [AMB-24] The count is not that of this OB alone.      *)
\* @type: Int => Bool;
CountOutlives(o) == \/ Kin(o) = CycleOb /\ CountOutlivesTheCycle
                    \/ o \in SyncErrorObs

(* [T15-79] [T15-116] One of several startup or cycle OBs: the next one of *)
(* its class has its turn.                                                 *)
\* @type: Int => $resume;
TurnPasses(o) == IF Kin(o) \in {CycleOb, 100} /\ Numbered(Kin(o)) # {}
                 THEN [resume EXCEPT !.last = o] ELSE resume

(* [AIRT-04] The delay count falls to 0 when the OB has been processed.    *)
\* @type: Int => Bool;
End(o) ==
    /\ Running.ob = o
    /\ mode # "HOLD"
    /\ ~Failed
    /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
    /\ delay' = IF CountOutlives(o) THEN delay ELSE 0
    /\ requests' = IF o = ProgramErrorOb THEN Excused ELSE requests
    /\ tod' = TodAfterEnd(o)
    /\ resume' = TurnPasses(o)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, mode, startup, clock, dint, irt, stopCause>>

-----------------------------------------------------------------------------
(* Cycle OBs and startup OBs *)

(* [T15-79] The cycle OBs that are to come in a cycle that has begun.      *)
LaterInCycle ==
    IF NumberedObs = {} \/ resume.last = 0 THEN {}
    ELSE { o \in Numbered(CycleOb) \cap loaded : o > resume.last }

(* OB 1 is always there; it starts when nothing runs. [T15-79] The others  *)
(* of its cycle follow by number.                                          *)
\* @type: Int => Bool;
CycleStarts(o) ==
    /\ mode = "RUN"
    /\ stack = <<>>
    /\ IF LaterInCycle = {} THEN o = CycleOb
       ELSE o \in LaterInCycle /\ \A q \in LaterInCycle : o <= q
    /\ stack' = <<Frame(o, 1)>>
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                   delay>>

(* [OBS-42] [OBS-55] [T15-116] By number, in STARTUP and not in a HOLD     *)
(* that interrupts it [T15-121].                                           *)
\* @type: Int => Bool;
StartupStarts(o) ==
    /\ mode = "STARTUP"
    /\ o \in StartupsAhead
    /\ o \in loaded
    /\ \A q \in StartupsAhead \cap loaded : o <= q
    /\ stack = <<>>
    /\ stack'   = <<Frame(o, StartupClass)>>
    /\ startup' = IF startup = "hot" THEN "resuming" ELSE "begun"
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, mode, resume, clock, settingVars, outcomeVars,
                   delay>>

-----------------------------------------------------------------------------
(* Missing OBs *)

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

(* For a missing OB 84 both are allowed: the CPU stops, or nothing happens. *)
\* @type: $request => Bool;
ErrorObMissing(r) ==
    \/ /\ r.ob \in ErrorObsAs85
       /\ ProgramErrorOccurs(Remove(requests, r), r)
    \/ /\ r.ob \in ErrorObsNotMissed
       /\ RequestsBecome(Remove(requests, r))
    \/ /\ r.ob \in ObsThatStop
       /\ requests' = Remove(requests, r)
       /\ stopCause' = StopFor(CauseWithout(r.ob))
       /\ entered' = EntriesWithout(r.ob)

(* [T15-110] [T15-114] OB 80 was deleted before the cycle time called it:  *)
(* no text says whether the CPU stops.                                     *)
\* @type: $request => Bool;
CycleTimeStops(r) ==
    /\ r.ob = TimeErrorOb /\ r.fault = CycleTimeExceeded
    /\ requests' = Remove(requests, r)
    /\ stopCause' = StopFor(NoTimeErrorOb)
    /\ entered' = EntriesOfStop(NoTimeErrorOb)

\* @type: $request => Bool;
Missing(r) ==
    /\ MayBeMissed(r)
    /\ IF ~Family.stops  \* [T15-40] [T15-111] [T15-112] [T15-113]
       THEN RequestsBecome(RequestsAfterCall(r)) \/ CycleTimeStops(r)
       ELSE IF r.ob \in AsyncErrorObs \cup {70, 72} THEN ErrorObMissing(r)
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
(* its end. A deselected OB that is loaded in STARTUP aborts it [OBS-25].  *)
\* @type: Set(Int) => Bool;
LoadedAre(obs) ==
    LET aborts == /\ mode = "STARTUP" /\ stopCause = NoCause
                  /\ \E o \in obs \ loaded : Deselected(o)
    IN  /\ loaded'    = obs
        /\ requests'  = RequestsAfterDeletion(loaded \ obs)
        /\ stopCause' = IF aborts THEN DeselectedLoaded ELSE stopCause
        /\ entered'   = IF aborts THEN {Entry(DeselectedLoaded)} ELSE {}
        /\ UNCHANGED <<cpu, modeVars, clock, settingVars, runVars>>
=============================================================================

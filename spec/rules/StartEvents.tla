----------------------------- MODULE StartEvents ------------------------------
(***************************************************************************)
(* A start event occurs: its effect on an OB that is deselected, blocked,  *)
(* runs or waits, or does nothing yet. Start events from outside are       *)
(* cyclic and hardware interrupts and asynchronous errors (sections 5.1 to *)
(* 5.3).                                                                   *)
(*                                                                         *)
(* The operators set requests', stopCause' and entered'. Errors has the    *)
(* errors themselves.                                                      *)
(* Left out: cycle time monitoring, OB 80 with fault 01 [OBS-26]; it comes *)
(* as a start event from outside.                                          *)
(***************************************************************************)
EXTENDS Errors

-----------------------------------------------------------------------------
(* Effects *)

(* Only the requests change. *)
\* @type: Set($request) => Bool;
RequestsBecome(q) ==
    /\ requests' = q
    /\ UNCHANGED stopCause
    /\ NothingEntered

(* The start event leads to a request. *)
\* @type: $request => Bool;
Ordinary(new) == RequestsBecome(Enter(requests, new))

(* [TINT-14] [DINT-10] The start event leads to a time error; `resume' are   *)
(* the requests after it, with the run that follows it, if there is one.   *)
\* @type: ($request, Int, Set($request)) => Bool;
Overlap(new, fault, kept) ==
    TimeErrorOccurs(kept, requests,
        [ TimeError(fault, {new.ob}, new.ob, new.word) EXCEPT
            !.since = new.since ])

(* The start event has no effect. *)
Nothing == UNCHANGED outcomeVars /\ NothingEntered

(* [IRT-04] *)
\* @type: Int => Bool;
Lost(o) == UNCHANGED outcomeVars /\ entered' = EntriesOfLost(o)
\* @type: $request => Bool;
ErrorLost(error) == UNCHANGED outcomeVars /\ entered' = EntriesOf(error)

-----------------------------------------------------------------------------
(* Start events of an OB that waits or runs already *)

(* [AMB-18] [AMB-77] The time errors that there may be: "still running",   *)
(* or buffer overflow.                                                     *)
\* @type: $request => Set($request);
ErrorsOf(again) ==
    { [TimeError(f, {}, again.ob, again.word) EXCEPT !.open = TRUE]
      : f \in {StillRunning, BufferOverflow} }

(* The errors that OB 80 may run for. *)
\* @type: Set($request) => Set($request);
WithObToRun(errors) ==
    IF TimeErrorOb \notin loaded \/ Blocked(TimeErrorOb) THEN {} ELSE errors

(* [T15-72] [T15-73] What waits of an OB that has a queue tells which      *)
(* faults were reported of its overload.                                   *)
\* @type: (Set($request), Int, Set(Int)) => Set($request);
WithTold(q, o, faults) ==
    IF ~Family.queues \/ (o \notin TodObs /\ ~HasQueue(o)) THEN q
    ELSE { IF r.ob = o THEN [r EXCEPT !.late = @ \cup faults] ELSE r
           : r \in q }

(* There may be a time error, the OB may run again, or nothing happens. *)
\* @type: $request => Set($request);
LeftOpen(again) ==
    { [again EXCEPT !.open = TRUE] } \cup WithObToRun(ErrorsOf(again))

(* The first open request of each of these OBs is confirmed. *)
\* @type: (Set($request), Set(Int)) => Set($request);
Confirmed(q, obs) ==
    { IF /\ r.ob \in obs /\ r.open
         /\ ~\E s \in q : s.ob = r.ob /\ s.open /\ s.rank < r.rank
      THEN [r EXCEPT !.open = FALSE] ELSE r : r \in q }

(* The OB has only open requests, and another start event comes. Now the   *)
(* OB is definitely pending: either its first open request is confirmed,   *)
(* or the open ones had no effect and the new one is pending.              *)
\* @type: $request => Set(Set($request));
EnterAmongOpen(new) ==
    { EnterAll(Confirmed(requests, {new.ob}), LeftOpen(new)),
      Enter(Withdraw(requests, new.ob), new) }

(* [OBS-22] Without OB 80 the time error, if it is one, stops the CPU.     *)
\* @type: Set($request) => Bool;
StopBy(errors) ==
    \E error \in errors :
      /\ TimeErrorStops(error)
      /\ TimeErrorOccurs(requests, requests, [error EXCEPT !.open = FALSE])

\* @type: $request => Bool;
MayStop(new) == StopBy(ErrorsOf(new))

\* @type: $request => Bool;
AnyEffect(new) ==
    \/ /\ requests' = WithTold(EnterAll(requests, LeftOpen(new)),
                              new.ob, {StillRunning})
       /\ UNCHANGED stopCause
       /\ entered' = OpenEntries(ErrorsOf(new))
    \/ MayStop(new)

\* @type: $request => Bool;
AgainWhileOpen(new) ==
    \/ /\ requests' \in EnterAmongOpen(new)
       /\ UNCHANGED stopCause
       /\ entered' = OpenEntries(ErrorsOf(new))
    \/ MayStop(new)

(* [AMB-18] The OB waits already. The size of the buffer is not known:     *)
(* under (b) the run is kept, or the buffer overflows [OBS-08].            *)
\* @type: $request => Bool;
AgainWhilePending(new) ==
    CASE SecondRequestIsTimeError -> Overlap(new, StillRunning, requests)
      [] SecondRequestIsBuffered  -> \/ Ordinary(new)
                                     \/ Overlap(new, BufferOverflow, requests)
      [] SecondRequestIsMerged    -> Nothing
      [] OTHER                    -> AnyEffect(new)

(* [TINT-15] A late run comes after its OB 80. [T15-26] [T15-61] On an     *)
(* S7-1500 by its class; if that is not below the class of OB 80, perhaps. *)
\* @type: $request => Set($request);
LateRuns(new) ==
    LET after == [new EXCEPT !.follows = StillRunning]
    IN  IF ~Family.queues THEN {after}
        ELSE IF new.class < ClassOf(TimeErrorOb) THEN {new} ELSE {new, after}

(* A running OB has at most one later run: the waiting run, or a new one.  *)
(* An open waiting run is confirmed, or the new run replaces it.           *)
\* @type: $request => Set(Set($request));
WithOneLateRun(new) ==
    IF PendingIn(requests, new.ob) THEN {requests}
    ELSE { Enter(Withdraw(requests, new.ob), run) : run \in LateRuns(new) }
           \cup (IF OpenIn(requests, new.ob)
                 THEN { Confirmed(requests, {new.ob}) } ELSE {})

\* @type: $request => Bool;
OverlapWithOneLateRun(new) ==
    \E kept \in WithOneLateRun(new) : Overlap(new, StillRunning, kept)

-----------------------------------------------------------------------------
(* The queues of an S7-1500 *)

(* [T15-74] The parameters of the queue of an OB. If none are known, they  *)
(* are those of a migrated program [T15-26] [A15-14]: one event waits, and *)
(* the second one calls OB 80.                                             *)
\* @type: Int => $queue;
QueueOf(o) == IF o \in DOMAIN cpu.queues THEN cpu.queues[o]
              ELSE [size |-> 1, limit |-> 1, told |-> -1]

\* @type: Int => Set($request);
WaitingOf(o) == { r \in requests : r.ob = o /\ ~r.open }

(* [T15-72] [T15-73] The faults of this overload that were reported, until *)
(* all its events are worked off.                                          *)
\* @type: Int => Set(Int);
ToldOf(o) ==
    LET runs == { i \in DOMAIN stack : stack[i].ob = o }
    IN  UNION { r.late : r \in WaitingOf(o) }
          \cup UNION { stack[i].told : i \in runs }

(* [T15-73] The events of the OB that wait or run.                         *)
\* @type: Int => Int;
EventsOfOb(o) == Cardinality(WaitingOf(o)) + (IF OnStack(o) THEN 1 ELSE 0)

(* [T15-68] [T15-76] [A15-07] Whether the queue is full.                   *)
\* @type: Int => Set(Bool);
QueueIsFull(o) ==
    LET full(events) == {events >= QueueOf(o).size}
    IN  (IF RunningEventCounts THEN {} ELSE full(Cardinality(WaitingOf(o))))
          \cup (IF RunningEventCountsNot THEN {} ELSE full(EventsOfOb(o)))

(* A queue without a place beside the running event: nothing waits that    *)
(* could tell of the overload.                                             *)
\* @type: (Int, Bool) => Bool;
NothingTells(o, full) == full /\ WaitingOf(o) = {}

(* [T15-73] OB 80 was called for this overload, or that is not known.      *)
\* @type: (Int, Bool) => Bool;
MayBeTold(o, full) == StillRunning \in ToldOf(o) \/ NothingTells(o, full)

(* [T15-73] [A15-15] Whether one more event calls OB 80, or may call it.   *)
\* @type: (Int, Bool) => Bool;
ReachesThreshold(o, full) ==
    LET limit == QueueOf(o).limit
    IN  /\ limit # 0 /\ EventsOfOb(o) >= limit
        /\ ~(MayBeTold(o, full) /\ OverloadIsReportedOnce)

(* Whether it matters later that an overflow was entered.                  *)
\* @type: Int => Bool;
AsksForEntry(o) == QueueOf(o).told = 1 \/ OverflowIsEnteredOnce

(* [T15-72] [A15-06] The entry 3507 of an event that is dropped.           *)
\* @type: $request => Set($entry);
EntriesOfDropped(new) ==
    LET told  == QueueOf(new.ob).told
        entry == EntryOf(TimeError(BufferOverflow, {}, new.ob, new.word))
        again == BufferOverflow \in ToldOf(new.ob)
                   \/ NothingTells(new.ob, TRUE)
    IN  IF told = 0 \/ (BufferOverflow \in ToldOf(new.ob)
                          /\ OverflowIsEnteredOnce) THEN {}
        ELSE {[entry EXCEPT !.open = again \/ told # 1]}

(* [T15-27] [A15-03] Where an overflow calls OB 80, it is no entry alone.  *)
\* @type: $request => Set(Bool);
DropsBesideOb80(new) ==
    IF OverflowCallsOb80 /\ new.ob \in TodObs THEN {TRUE} ELSE {}

(* One more event waits. Where one alone has a place, an open request is   *)
(* this event, or it had no effect.                                        *)
\* @type: ($request, Set(Int)) => Set(Set($request));
OneMoreWaits(new, told) ==
    LET runs == { [run EXCEPT !.late = told] : run \in LateRuns(new) }
    IN  IF QueueOf(new.ob).size = 1 /\ OpenIn(requests, new.ob)
        THEN { Enter(Withdraw(requests, new.ob), run) : run \in runs }
               \cup { WithTold(Confirmed(requests, {new.ob}), new.ob, told) }
        ELSE { Enter(requests, run) : run \in runs }

(* [T15-68] [T15-69] [T15-73] One more event of an OB that waits or runs:  *)
(* it waits, or the queue is full and drops it; OB 80 may be called.       *)
\* @type: $request => Bool;
QueuesUp(new) ==
    \E full \in QueueIsFull(new.ob) \ DropsBesideOb80(new) :
      LET calls == ReachesThreshold(new.ob, full)
          again == MayBeTold(new.ob, full) /\ ~OverloadIsReportedAgain
          error == [ TimeError(StillRunning, {new.ob}, new.ob, new.word)
                     EXCEPT !.since = new.since, !.open = again ]
          told  == ToldOf(new.ob) \cup (IF calls THEN {StillRunning} ELSE {})
                     \cup (IF full /\ AsksForEntry(new.ob)
                           THEN {BufferOverflow} ELSE {})
      IN  /\ \E kept \in IF full THEN {WithTold(requests, new.ob, told)}
                                 ELSE OneMoreWaits(new, told) :
               requests' \in IF calls
                             THEN RequestsAfterTimeError(kept, kept, error)
                             ELSE {kept}
          /\ UNCHANGED stopCause
          /\ entered' =
               (IF calls /\ StillRunning \notin ToldOf(new.ob)
                THEN IF NothingTells(new.ob, full) THEN OpenEntries({error})
                     ELSE EntriesOf(error)
                ELSE {})
                 \cup (IF full THEN EntriesOfDropped(new) ELSE {})

(* [T15-27] [A15-03] The queue of a time-of-day OB overflows: OB 80, too.  *)
\* @type: $request => Bool;
DropCallsOb80(new) ==
    /\ new.ob \in TodObs /\ TRUE \in QueueIsFull(new.ob)
    /\ ~OverflowIsEnteredAlone
    /\ Overlap(new, BufferOverflow, requests)

-----------------------------------------------------------------------------

(* [TINT-14] [AMB-19] A time-of-day interrupt whose OB runs. *)
\* @type: $request => Bool;
TodWhileRunning(new) ==
    CASE /\ Family.queues
         /\ QueueIsUnknown \/ new.ob \in DOMAIN cpu.queues -> AnyEffect(new)
      [] Family.queues -> QueuesUp(new) \/ DropCallsOb80(new)
      [] EveryPointRunsLater ->
           \E run \in LateRuns(new) :
             Overlap(new, StillRunning, Enter(requests, run))
      [] OnlyFirstPointIsReported /\ PendingIn(requests, new.ob) -> Nothing
      [] OTHER -> OverlapWithOneLateRun(new)

(* [DINT-10] [AMB-47] *)
\* @type: $request => Bool;
DintWhileRunning(new) ==
    \/ ~OverlappingDelayRunsNot /\ OverlapWithOneLateRun(new)
    \/ ~OverlappingDelayRuns /\ Overlap(new, StillRunning, requests)

(* [AMB-77] *)
\* @type: $request => Bool;
ExternalWhileRunning(new) ==
    CASE ExternalAgainIsTimeError -> OverlapWithOneLateRun(new)
      [] ExternalAgainIsBuffered -> Ordinary(new)
      [] ExternalAgainIsLost     -> Nothing
      [] OTHER                   -> AnyEffect(new)

-----------------------------------------------------------------------------
(* Buffer overflow and asynchronous errors *)

(* [AMB-49] (b) A time error without OB 80 waits for the end of a delay.   *)
\* @type: Int => Bool;
TimeErrorStands(class) ==
    /\ stopCause = NoTimeErrorOb /\ ~StopIsNotDelayed
    /\ class \in { ErrorClass(TimeErrorOb, f)
                   : f \in {StillRunning, BufferOverflow} }

(* Another start event of the class waits, or an OB of the class runs.     *)
\* @type: Int => Bool;
ClassIsTaken(class) == \/ \E r \in requests : r.class = class
                       \/ \E i \in DOMAIN stack : stack[i].class = class
                       \/ TimeErrorStands(class)

(* [OBS-08] [AMB-18] The buffer of a class may be full if it is taken.     *)
(* [T15-68] On an S7-1500 each OB has a queue of its own.                  *)
\* @type: $request => Bool;
MayOverflow(new) ==
    /\ IF Family.queues
       THEN OnStack(new.ob) \/ \E r \in requests : r.ob = new.ob
       ELSE ClassIsTaken(new.class)
    /\ BuffersMayOverflow

\* @type: $request => Bool;
Overflows(new) ==
    /\ MayOverflow(new)
    /\ TimeErrorOccurs(requests, requests,
                       TimeError(BufferOverflow, {}, new.ob, new.word))

(* [OBS-07] [OBS-11] An error whose OB is not OB 80: its OB runs, or the   *)
(* buffer of its class overflows.                                          *)
\* @type: $request => Bool;
ErrorOccurs(new) ==
    \/ /\ requests' = Enter(requests, new)
       /\ UNCHANGED stopCause
       /\ entered' = IF new.fault = 0 THEN {} ELSE {EntryOf(new)}
    \/ Overflows(new)

-----------------------------------------------------------------------------

\* @type: $request => Bool;
AgainWhileRunning(new) ==
    CASE new.ob \in TodObs  -> TodWhileRunning(new)
      [] new.ob \in DintObs -> DintWhileRunning(new)
      [] OTHER              -> ExternalWhileRunning(new)

(* [OBS-07] A start event occurs. *)
\* @type: $request => Bool;
Occurs(new) ==
    IF Deselected(new.ob) THEN Nothing
    ELSE IF Blocked(new.ob) THEN Lost(new.ob)
    ELSE IF HasQueue(new.ob) /\ EventsOfOb(new.ob) > 0
    THEN QueuesUp(new) \/ DropCallsOb80(new)
    ELSE IF OnStack(new.ob) THEN AgainWhileRunning(new)
    ELSE IF PendingIn(requests, new.ob) THEN AgainWhilePending(new)
    ELSE IF OpenIn(requests, new.ob) THEN AgainWhileOpen(new)
    ELSE \/ Ordinary(new)
         \/ new.ob \in ExternalObs /\ ~HasQueue(new.ob) /\ Overflows(new)

-----------------------------------------------------------------------------
(* Start events from outside *)

(* [T15-118] A start event of STARTUP waits for RUN.                       *)
KeptInStartup == mode = "STARTUP" /\ Family.keeps

(* [AMB-67] In HOLD, and in STARTUP unless it is an error, an event waits  *)
(* for RUN, is lost, or either. What waits may fill a buffer [AMB-18].     *)
\* @type: $request => Bool;
OutsideRun(new) ==
    IF OutsideRunEventsAreLost /\ ~KeptInStartup THEN Nothing
    ELSE IF /\ KeptInStartup /\ OpenIn(requests, new.ob)  \* since HOLD
            /\ ~PendingIn(requests, new.ob)
    THEN AgainWhileOpen(new)
    ELSE LET again  == PendingIn(requests, new.ob) \/ OpenIn(requests, new.ob)
             errors == { e \in ErrorsOf(new) :
                           IF e.fault = BufferOverflow THEN MayOverflow(new)
                                                       ELSE again }
             run    == [new EXCEPT !.open =
                         again \/ (OutsideRunEventsAreOpen /\ ~KeptInStartup)]
             shown  == (IF new.fault = 0 THEN {} ELSE {new}) \cup errors
             told   == IF again THEN {StillRunning} ELSE {}
         IN  \/ /\ requests' =
                       WithTold(EnterAll(requests,
                                         {run} \cup WithObToRun(errors)),
                                new.ob, told)
                /\ UNCHANGED stopCause
                /\ entered' = OpenEntries(shown)
             \/ mode = "STARTUP" /\ StopBy(errors)

\* @type: Int => Bool;
KeptFromRunning(o) ==
    mode = "HOLD" \/ (mode = "STARTUP" /\ o \notin AsyncErrorObs)

(* [AMB-84] An error in HOLD whose OB is missing [OBS-22] [OBS-23]. *)
\* @type: $request => Bool;
MissingInHold(new) ==
    mode = "HOLD" /\ new.ob \notin loaded /\ new.ob \in ObsThatStop

(* [AMB-84] (a) The CPU stops at once. A missing OB 84 need not stop it.   *)
\* @type: $request => Bool;
StopsInHold(new) ==
    /\ UNCHANGED requests
    /\ \/ /\ stopCause' = StopFor(CauseWithout(new.ob))
          /\ entered' = OpenEntries(IF new.fault = 0 THEN {} ELSE {new})
                          \cup EntriesWithout(new.ob)
       \/ /\ new.ob \in ErrorObsNotMissed
          /\ UNCHANGED stopCause /\ NothingEntered

(* [AMB-84] (b) The error waits for the release. Its OB is missed then.    *)
\* @type: $request => Bool;
AwaitsTheRelease(new) ==
    /\ requests' = Enter(requests, new)
    /\ UNCHANGED stopCause
    /\ entered' = OpenEntries(IF new.fault = 0 THEN {} ELSE {new})

\* @type: $request => Bool;
ErrorInHold(new) ==
    CASE HeldErrorStopsAtOnce -> StopsInHold(new)
      [] HeldErrorStopsLater  -> AwaitsTheRelease(new)
      [] HeldErrorIsLost      -> Nothing
      [] OTHER                -> StopsInHold(new) \/ OutsideRun(new)

(* [OBS-07] In STOP nothing happens [OBS-41]. *)
\* @type: $request => Bool;
Comes(new) ==
    IF mode = "STOP" \/ Deselected(new.ob) THEN Nothing
    ELSE IF new.ob = TimeErrorOb /\ mode # "HOLD"
    THEN TimeErrorOccurs(requests, requests, new)
    ELSE IF Blocked(new.ob)
    THEN IF new.fault = 0 THEN Lost(new.ob) ELSE ErrorLost(new)
    ELSE IF MissingInHold(new) THEN ErrorInHold(new)
    ELSE IF KeptFromRunning(new.ob) /\ ~(KeptInStartup /\ HasQueue(new.ob))
    THEN OutsideRun(new)
    ELSE IF new.ob \in AsyncErrorObs THEN ErrorOccurs(new)
    ELSE Occurs(new)

(* [OBS-07] *)
\* @type: (Int, Int) => Bool;
Interrupt(o, fault) ==
    /\ Comes(ExternalRequest(o, fault))
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, runVars>>
=============================================================================

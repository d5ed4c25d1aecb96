----------------------------- MODULE StartEvents ----------------------------
(***************************************************************************)
(* A start event or an error occurs: what it leads to where its OB is      *)
(* idle, waits, runs, is blocked or is missing, and what is entered in the *)
(* diagnostic buffer (catalogue sections 5.2, 5.3, table 7.5).             *)
(*                                                                         *)
(* The operators set requests', stopCause' and entered'.                   *)
(* Left out: entries for other events than those of table 7.5 that belong  *)
(* to OB 80, OB 85, STOP by rule and SFC 39.                               *)
(***************************************************************************)
EXTENDS Requests

-----------------------------------------------------------------------------
(* Entries *)

\* @type: Int => $entry;
Entry(id) == [id |-> id, of |-> NoRequest, open |-> FALSE]

\* @type: $request => $entry;
EntryOf(error) == [id |-> ErrorEntry + error.fault, of |-> error, open |-> FALSE]

(* [AMB-41] (b) Under MODE 8x every blocked event shows as 5380. *)
\* @type: Int => Set($entry);
EntriesOfLost(o) ==
    IF Silenced(o) /\ LostEventIsEntered THEN {Entry(EntriesDisabled)} ELSE {}

(* [IRT-09] *)
\* @type: $request => Set($entry);
EntriesOf(error) == IF Silenced(error.ob) THEN EntriesOfLost(error.ob)
                                          ELSE {EntryOf(error)}

\* @type: Set($request) => Set($entry);
OpenEntries(errors) ==
    { [n EXCEPT !.open = TRUE] : n \in UNION { EntriesOf(e) : e \in errors } }

-----------------------------------------------------------------------------
(* STOP by rule *)

(* The first cause counts. *)
\* @type: Int => Int;
StopFor(cause) == IF stopCause = NoCause THEN cause ELSE stopCause

\* @type: Int => Set($entry);
EntriesOfStop(cause) == IF stopCause = NoCause THEN {Entry(cause)} ELSE {}

-----------------------------------------------------------------------------
(* Time errors *)

(* [OBS-22] [CLK-05] [OBS-33] A time error, after which requests are `kept', *)
(* with the runs that follow it.  Without OB 80 it stops the CPU, also     *)
(* while interrupts are delayed [AMB-49].  Blocked, it does not [IRT-01]   *)
(* [AMB-23], and the runs that follow may be `lost' with it [AMB-48].      *)
\* @type: (Set($request), Set($request), $request) => Bool;
TimeErrorOccurs(kept, lost, error) ==
    LET absent == TimeErrorOb \notin loaded
        stops  == absent /\ IF Blocked(TimeErrorOb)
                            THEN BlockedErrorStopsTheCpu
                            ELSE ~(/\ DelaysNeverStopTheCpu
                                   /\ error.cause \in DintObs)
    IN  /\ requests' \in
             IF ~Blocked(TimeErrorOb)
             THEN {IF stops THEN lost  \* what follows OB 80 never comes
                   ELSE IF absent THEN kept ELSE Enter(kept, error)}
             ELSE CASE LateRunOutlivesBlock  -> {kept}
                    [] LateRunIsLostWithOb80 -> {lost}
                    [] OTHER                 -> {kept, lost}
        /\ stopCause' = IF stops THEN StopFor(NoTimeErrorOb) ELSE stopCause
        /\ entered'   = EntriesOf(error)
                          \cup (IF stops THEN EntriesOfStop(NoTimeErrorOb) ELSE {})

-----------------------------------------------------------------------------
(* Missing OBs *)

(* [TINT-16] [DINT-09] [OBS-20] [AMB-28] The OB of a request is missing:    *)
(* OB 85, once for all missing OBs or once for each [AMB-45]; blocked, it  *)
(* is lost [AMB-33] [AMB-23].  Requests are then `rest'.                   *)
\* @type: (Set($request), $request) => Bool;
ProgramErrorOccurs(rest, r) ==
    LET error == [ ExternalRequest(ProgramErrorOb,
                                   IF MissingObIsFaultA1 THEN \hA1 ELSE \hA2)
                   EXCEPT !.cause = r.ob, !.word = r.word, !.during = Running.ob ]
        joins == OnStack(ProgramErrorOb) \/ PendingIn(rest, ProgramErrorOb)
        absent == ProgramErrorOb \notin loaded
        stops == \/ BlockedOb85StopsTheCpu
                 \/ BlockedErrorStopsTheCpu /\ absent
    IN  IF Blocked(ProgramErrorOb)
        THEN /\ requests' = rest
             /\ stopCause' = IF stops THEN StopFor(NoProgramErrorOb) ELSE stopCause
             /\ entered' = EntriesOf(error)
                             \cup (IF stops THEN EntriesOfStop(NoProgramErrorOb)
                                   ELSE {})
        ELSE IF absent /\ DelaysNeverStopTheCpu /\ r.ob \in DintObs
        THEN requests' = rest /\ UNCHANGED stopCause /\ entered' = {EntryOf(error)}
        ELSE /\ UNCHANGED stopCause
             /\ \/ /\ ~(joins /\ OneOb85ForAll)
                   /\ requests' = Enter(rest, error)
                   /\ entered' = {EntryOf(error)}
                \/ /\ joins /\ ~OneOb85ForEach
                   /\ requests' = rest
                   /\ entered' = OpenEntries({error})

-----------------------------------------------------------------------------
(* A start event leads to a request ... *)

\* @type: $request => Bool;
Ordinary(new) ==
    /\ requests' = Enter(requests, new)
    /\ UNCHANGED stopCause
    /\ NothingEntered

(* ... to a time error [TINT-14] [DINT-10], with a run that follows it or    *)
(* without ...                                                             *)
\* @type: ($request, Int, Bool) => Bool;
Overlap(new, fault, again) ==
    LET runs  == IF again THEN Enter(requests, [new EXCEPT !.follows = fault])
                 ELSE requests
        error == [ TimeError(fault, {new.ob}, new.ob, new.word) EXCEPT
                     !.since = new.since ]
    IN  TimeErrorOccurs(runs, requests, error)

(* ... or to nothing. *)
Nothing == UNCHANGED <<requests, stopCause>> /\ NothingEntered

(* [IRT-04] *)
\* @type: Int => Bool;
Lost(o) == UNCHANGED <<requests, stopCause>> /\ entered' = EntriesOfLost(o)

-----------------------------------------------------------------------------
(* Start events of an OB that waits or runs already *)

(* [AMB-18] [AMB-77] There may be a time error, still running or buffer      *)
(* overflow ...                                                            *)
\* @type: $request => Set($request);
ErrorsOf(again) ==
    { [TimeError(f, {}, again.ob, again.word) EXCEPT !.open = TRUE]
      : f \in {StillRunning, BufferOverflow} }

(* ... the OB may run again, or nothing happens. *)
\* @type: $request => Set($request);
LeftOpen(again) ==
    { [again EXCEPT !.open = TRUE] }
      \cup (IF TimeErrorOb \notin loaded \/ Blocked(TimeErrorOb) THEN {}
            ELSE ErrorsOf(again))

(* Where the OB waits, if at all, by what is open, it waits for sure after  *)
(* another start event: by the first of the open ones, or by the new one if *)
(* they had no effect.  The latter shows only where another OB of the class *)
(* stands between.                                                         *)
\* @type: (Set($request), $request) => Set($request);
Confirmed(q, new) ==
    { IF /\ r.ob = new.ob /\ r.open
         /\ ~\E s \in q : s.ob = r.ob /\ s.open /\ s.rank < r.rank
      THEN [r EXCEPT !.open = FALSE] ELSE r : r \in q }

\* @type: $request => Set(Set($request));
EnterAmongOpen(new) ==
    { EnterAll(Confirmed(requests, new), LeftOpen(new)) }
      \cup (IF \E r, s \in requests : /\ r.ob = new.ob /\ s.ob # new.ob
                                     /\ s.class = r.class /\ s.rank > r.rank
            THEN { Enter(Withdraw(requests, new.ob), new) } ELSE {})

\* @type: $request => Bool;
AnyEffect(new) ==
    /\ requests' = EnterAll(requests, LeftOpen(new))
    /\ UNCHANGED stopCause
    /\ entered' = OpenEntries(ErrorsOf(new))

\* @type: $request => Bool;
AgainWhileOpen(new) ==
    /\ requests' \in EnterAmongOpen(new)
    /\ UNCHANGED stopCause
    /\ entered' = OpenEntries(ErrorsOf(new))

(* [AMB-18] The OB waits already.  The size of the buffer is not known, so  *)
(* under (b) the run is kept or the buffer overflows [OBS-08].             *)
\* @type: $request => Bool;
AgainWhilePending(new) ==
    CASE SecondRequestIsTimeError -> Overlap(new, StillRunning, FALSE)
      [] SecondRequestIsBuffered  -> \/ Ordinary(new)
                                     \/ Overlap(new, BufferOverflow, FALSE)
      [] SecondRequestIsMerged    -> Nothing
      [] OTHER                    -> AnyEffect(new)

(* [TINT-14] [AMB-19] A time-of-day interrupt whose OB runs: one run is     *)
(* kept for later.                                                         *)
\* @type: $request => Bool;
TodWhileRunning(new) ==
    LET again == PendingIn(requests, new.ob)
    IN  CASE EveryPointRunsLater -> Overlap(new, StillRunning, TRUE)
          [] OnlyFirstPointIsReported /\ again -> Nothing
          [] OTHER -> Overlap(new, StillRunning, ~again)

(* [DINT-10] [AMB-47] *)
\* @type: $request => Bool;
DintWhileRunning(new) ==
    \E follows \in CASE OverlappingDelayRuns    -> {TRUE}
                     [] OverlappingDelayRunsNot -> {FALSE}
                     [] OTHER                   -> BOOLEAN :
      Overlap(new, StillRunning, follows /\ ~PendingIn(requests, new.ob))

(* [AMB-77] *)
\* @type: $request => Bool;
ExternalWhileRunning(new) ==
    CASE ExternalAgainIsTimeError ->
           Overlap(new, StillRunning, ~PendingIn(requests, new.ob))
      [] ExternalAgainIsBuffered -> Ordinary(new)
      [] ExternalAgainIsLost     -> Nothing
      [] OTHER                   -> AnyEffect(new)

-----------------------------------------------------------------------------
(* Buffer overflow and asynchronous errors *)

(* [OBS-08] [AMB-18] The buffer of a class may be full where something of    *)
(* the class waits or runs.                                                *)
\* @type: $request => Bool;
MayOverflow(new) ==
    /\ \/ \E r \in requests : r.class = new.class
       \/ \E i \in DOMAIN stack : stack[i].class = new.class
    /\ BuffersMayOverflow

\* @type: $request => Bool;
Overflows(new) ==
    /\ MayOverflow(new)
    /\ TimeErrorOccurs(requests, requests,
                       TimeError(BufferOverflow, {}, new.ob, new.word))

(* [OBS-07] [OBS-11] An error whose OB is not OB 80: its OB runs, or the     *)
(* buffer of its class overflows.                                          *)
\* @type: $request => Bool;
ErrorOccurs(new) ==
    \/ /\ requests' = Enter(requests, new)
       /\ UNCHANGED stopCause
       /\ entered' = IF new.fault = 0 THEN {} ELSE {EntryOf(new)}
    \/ Overflows(new)

-----------------------------------------------------------------------------

(* [OBS-07] A start event occurs. *)
\* @type: $request => Bool;
Occurs(new) ==
    IF Deselected(new.ob) THEN Nothing
    ELSE IF Blocked(new.ob) THEN Lost(new.ob)
    ELSE IF OnStack(new.ob)
    THEN IF new.ob \in TodObs THEN TodWhileRunning(new)
         ELSE IF new.ob \in DintObs THEN DintWhileRunning(new)
         ELSE ExternalWhileRunning(new)
    ELSE IF PendingIn(requests, new.ob) THEN AgainWhilePending(new)
    ELSE IF OpenIn(requests, new.ob) THEN AgainWhileOpen(new)
    ELSE \/ Ordinary(new)
         \/ new.ob \in ExternalObs /\ Overflows(new)
=============================================================================

------------------------------- MODULE Errors -------------------------------
(***************************************************************************)
(* Errors: a time error, a missing OB, the STOP that follows by rule, and  *)
(* their entries in the diagnostic buffer (sections 5.2 and 5.3, table     *)
(* 7.5).                                                                   *)
(*                                                                         *)
(* The operators set requests', stopCause' and entered'.                   *)
(* Left out: entries of other events. Table 7.5 has those of OB 80, OB 85, *)
(* STOP by rule and SFC 39.                                                *)
(***************************************************************************)
EXTENDS Requests

-----------------------------------------------------------------------------
(* Entries *)

\* @type: Int => $entry;
Entry(id) == [id |-> id, of |-> NoRequest, open |-> FALSE]

\* @type: $request => $entry;
EntryOf(error) ==
    [id |-> ErrorEntry + error.fault, of |-> error, open |-> FALSE]

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

(* The first cause of a STOP counts. *)
\* @type: Int => Int;
StopFor(cause) == IF stopCause = NoCause THEN cause ELSE stopCause

\* @type: Int => Set($entry);
EntriesOfStop(cause) == IF stopCause = NoCause THEN {Entry(cause)} ELSE {}

(* The error is entered. The CPU may have to stop. *)
\* @type: ($request, Bool, Int) => Bool;
ErrorShows(error, stops, cause) ==
    /\ stopCause' = IF stops THEN StopFor(cause) ELSE stopCause
    /\ entered'   = EntriesOf(error)
                      \cup (IF stops THEN EntriesOfStop(cause) ELSE {})

(* [OBS-21] [OBS-22] [OBS-23] The errors that stop the CPU without their    *)
(* OB, and why.                                                            *)
ObsThatStop == IF ~Family.stops THEN {}  \* [T15-110] [T15-111]
               ELSE ErrorObsThatStop \cup {TimeErrorOb, ProgramErrorOb}
\* @type: Int => Int;
CauseWithout(o) == CASE o = ProgramErrorOb -> NoProgramErrorOb
                     [] o = TimeErrorOb    -> NoTimeErrorOb
                     [] OTHER              -> OtherErrorOb
\* @type: Int => Set($entry);
EntriesWithout(o) == IF CauseWithout(o) = OtherErrorOb THEN {}
                     ELSE EntriesOfStop(CauseWithout(o))

(* [AMB-07] *)
\* @type: Int => Bool;
ErrorsNeverStop(o) == DelaysNeverStopTheCpu /\ o \in DintObs

-----------------------------------------------------------------------------
(* Time errors *)

(* [OBS-22] [CLK-05] Without OB 80 a time error stops the CPU, also while  *)
(* interrupts are delayed [AMB-49]; blocked, it does not [IRT-01]          *)
(* [AMB-23].                                                               *)
\* @type: $request => Bool;
TimeErrorStops(error) ==
    /\ TimeErrorOb \notin loaded
    \* [T15-110] [T15-114]
    /\ Family.stops \/ error.fault = CycleTimeExceeded
    /\ IF Blocked(TimeErrorOb) THEN BlockedErrorStopsTheCpu
                               ELSE ~ErrorsNeverStop(error.cause)

(* [T15-100] The catch-ups of a large jump where OB 80 is missing [A15-11]. *)
\* @type: $request => Bool;
CatchUpsAreOpen(error) ==
    Family.jump > 0 /\ error.fault \in Skips /\ TimeErrorOb \notin loaded

\* @type: (Set($request), Set($request)) => Set(Set($request));
WithoutTimeErrorOb(kept, lost) ==
    CASE CatchUpNeedsNoOb80 -> {kept}
      [] CatchUpNeedsOb80   -> {lost}
      [] OTHER              -> {kept, lost}

(* The requests after a time error: `kept' with the runs that follow it,   *)
(* `lost' without these runs. If OB 80 is blocked, the runs may be lost,   *)
(* too [AMB-48].                                                           *)
\* @type: (Set($request), Set($request), $request) => Set(Set($request));
RequestsAfterTimeError(kept, lost, error) ==
    IF Blocked(TimeErrorOb)
    THEN CASE LateRunOutlivesBlock  -> {kept}
           [] LateRunIsLostWithOb80 -> {lost}
           [] OTHER                 -> {kept, lost}
    ELSE IF CatchUpsAreOpen(error) THEN WithoutTimeErrorOb(kept, lost)
    ELSE IF TimeErrorStops(error) THEN {lost}
    ELSE IF TimeErrorOb \notin loaded THEN {kept} ELSE {Enter(kept, error)}

(* [OBS-22] [OBS-33] *)
\* @type: (Set($request), Set($request), $request) => Bool;
TimeErrorOccurs(kept, lost, error) ==
    /\ requests' \in RequestsAfterTimeError(kept, lost, error)
    /\ ErrorShows(error, TimeErrorStops(error), NoTimeErrorOb)

-----------------------------------------------------------------------------
(* Missing OBs *)

(* [AMB-28] The error that OB 85 reports: the OB of request r is missing.  *)
\* @type: $request => $request;
ProgramError(r) ==
    [ ExternalRequest(ProgramErrorOb,
                      IF MissingObIsFaultA1 THEN \hA1 ELSE \hA2)
      EXCEPT !.cause = r.ob, !.word = r.word, !.during = Running.ob ]

(* [AMB-33] [AMB-23] *)
BlockedOb85Stops ==
    \/ BlockedOb85StopsTheCpu
    \/ BlockedErrorStopsTheCpu /\ ProgramErrorOb \notin loaded

(* [AMB-45] One OB 85 for all missing OBs, or one for each.                *)
\* @type: (Set($request), $request) => Bool;
ProgramErrorWaits(rest, error) ==
    LET joins == OnStack(ProgramErrorOb) \/ PendingIn(rest, ProgramErrorOb)
    IN  /\ UNCHANGED stopCause
        /\ \/ /\ ~(joins /\ OneOb85ForAll)
              /\ requests' = Enter(rest, error)
              /\ entered'  = {EntryOf(error)}
           \/ /\ joins /\ ~OneOb85ForEach
              /\ requests' = rest
              /\ entered'  = OpenEntries({error})

(* [TINT-16] [DINT-09] [OBS-20] The OB of request r is missing. OB 85      *)
(* waits beside `rest', the other requests; blocked, it is lost [AMB-33].  *)
\* @type: (Set($request), $request) => Bool;
ProgramErrorOccurs(rest, r) ==
    IF Blocked(ProgramErrorOb)
    THEN /\ requests' = rest
         /\ ErrorShows(ProgramError(r), BlockedOb85Stops, NoProgramErrorOb)
    ELSE IF ProgramErrorOb \notin loaded /\ ErrorsNeverStop(r.ob)
    THEN /\ requests' = rest
         /\ UNCHANGED stopCause
         /\ entered' = {EntryOf(ProgramError(r))}
    ELSE ProgramErrorWaits(rest, ProgramError(r))
=============================================================================

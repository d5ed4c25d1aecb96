------------------------------ MODULE Latency -------------------------------
(***************************************************************************)
(* In System an OB that may start does so before anything else. In a log   *)
(* it starts up to `latency_ms' later. An OB of a lower class may start    *)
(* first while its start event is no older than that (AMB-69). A STOP by   *)
(* rule and an error OB have the same latency.                             *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, fine point 2; AMB-69.              *)
(* Left out: requests of one class are not timed apart from each other.    *)
(***************************************************************************)
EXTENDS Scheduler, SyncErrors, ReportedData

-----------------------------------------------------------------------------
(* What waits *)

(* The key under which `waiting' holds a STOP that is due. *)
StopDuty == 99
(* The key of an error OB that is called [OBS-61].                         *)
CallDuty == 98

(* Open requests are timed under separate keys, because their OBs need not *)
(* start.                                                                  *)
\* @type: $request => Int;
WaitsAs(r) == IF r.open THEN r.class + 100 ELSE r.class

MayStartNow == { r \in requests : MayStart(r) }

Awaited == { WaitsAs(r) : r \in MayStartNow }
             \cup (IF StopIsDue THEN {StopDuty} ELSE {})
             \cup (IF ErrorObIsDue THEN {CallDuty} ELSE {})

(* [AMB-69] (c) The wait of an OB that could start goes on under a delay.  *)
\* @type: $request => Bool;
MayGoOnWaiting(r) ==
    \/ MayStart(r)
    \/ ~DelayBeginsWaitsAnew /\ ModeAllows(r) /\ Foremost(r)

(* The requests that may. Without a delay what is foremost may start.      *)
MayGoOn == IF Undelayed THEN MayStartNow
           ELSE { r \in requests : MayGoOnWaiting(r) }

(* The waits that go on in this step: those of OBs and of a STOP. The next *)
(* OB of a class begins to wait when the one before it is withdrawn.       *)
WaitsGoOn ==
    LET keys == DOMAIN waiting
        waited == { AsItCame(r) : r \in { q \in MayGoOn :
                                            WaitsAs(q) \in keys } }
    IN  IF keys = {} THEN {}
        ELSE keys \cap
               ( { WaitsAs(r) : r \in { q \in MayGoOn' :
                                          AsItCame(q) \in waited } }
                   \cup (IF stopCause' = NoCause \/ ( DelayBeginsWaitsAnew
                                                       /\ ~StopIsDue' )
                         THEN {} ELSE {StopDuty}) )

(* An open request that stands for several (Merging).                      *)
\* @type: $request => Bool;
IsCrowd(r) == AsItCame(r) \in DOMAIN terms.crowds

-----------------------------------------------------------------------------
(* Data for later lines *)

(* [OBS-26] The cycle and its overruns: OB 1 starts, the last cycle OB     *)
(* ends [T15-79], a restart begins, or the cycle time is exceeded. A       *)
(* blocked OB 80 is not called [IRT-01]. A hot restart goes on with the    *)
(* cycle: no text says whether an overrun before STOP counts [AMB-26].     *)
NextCycle ==
    LET restarts == mode = "STOP" /\ mode' = "STARTUP"
        begins   == mode = "RUN" /\ stack = <<>> /\ OnStack(CycleOb)'
        ends     == /\ stack # <<>> /\ stack[1].ob \in CycleObs
                    /\ mode' # "STOP"
                    /\ stack' = <<>> /\ LaterInCycle' = {}
        exceeded ==
          /\ ~Blocked(TimeErrorOb)
          /\ \E n \in entered' : n.id = ErrorEntry + CycleTimeExceeded
    IN  /\ first' = IF restarts THEN startup'
                    ELSE IF begins \/ (ends /\ first = "unknown") THEN "none"
                    ELSE first
        /\ overruns' = IF startup' = "hot" /\ restarts
                       THEN Earlier(overruns, 1)
                       ELSE IF restarts \/ begins \/ ends THEN 0
                       ELSE IF exceeded THEN Earlier(overruns + 1, 2)
                       ELSE overruns

NextArrivals ==
    arrivals' = IF requests' = requests THEN arrivals
                ELSE [ r \in { AsItCame(q) : q \in requests' } |->
                         IF r \in DOMAIN arrivals THEN arrivals[r] ELSE up ]

(* Changes that are older than the latency are forgotten.                  *)
NextChanges ==
    changes' = IF clock' = clock THEN changes
               ELSE { c \in changes : Span(c.up, up) <= terms.latency }
                      \cup {[from |-> clock, up |-> up]}

NextEvent == NextCycle /\ NextArrivals /\ NextChanges

(* After a step an OB goes on waiting, or begins to wait if it now may     *)
(* start.                                                                  *)
Rewait ==
    /\ NextEvent
    /\ waiting' = IF requests' = {} /\ stopCause' = NoCause /\ ~Failed'
                  THEN [c \in {} |-> 0]
                  ELSE LET old == WaitsGoOn
                       IN  [ c \in Awaited' \cup old |->
                               IF c \in old THEN waiting[c] ELSE 0 ]
    /\ Report(0)

(* OB 85, or the STOP, has waited as long as the missing OB. A delay that  *)
(* began meanwhile does not hold the STOP back [AMB-69] (c).               *)
\* @type: $request => Bool;
RewaitMissing(r) ==
    LET waited == WaitsAs(r) \in DOMAIN waiting
        since  == IF waited THEN waiting[WaitsAs(r)] ELSE 0
        stops  == /\ waited /\ ~NoticedAtOnce(r) /\ MayGoOnWaiting(r)
                  /\ stopCause' # NoCause
        old    == WaitsGoOn \cup (IF stops THEN {StopDuty} ELSE {})
    IN  /\ NextEvent
        /\ waiting' = [ c \in Awaited' \cup old |->
                          LET before == IF c \in old \cap DOMAIN waiting
                                        THEN waiting[c] ELSE 0
                          IN  IF c % 100 >= r.class /\ since > before
                              THEN since ELSE before ]
        /\ Report(since)

-----------------------------------------------------------------------------
(* The order of classes *)

(* [AIRT-08] [OBS-03] [AMB-69] A start event that is older than the        *)
(* latency comes before a start event of a lower class.                    *)
\* @type: ($request, $request) => Bool;
GoesFirst(q, r) ==
    /\ q.class > r.class /\ MayStart(q)
    /\ \/ terms.latency = 0 \/ NothingStandsBefore
       \/ Span(arrivals[AsItCame(q)], up) > terms.latency

\* @type: $request => Bool;
HighestFirst(r) == \A q \in requests : ~q.open => ~GoesFirst(q, r)

-----------------------------------------------------------------------------
(* Waiting too long *)

(* When d ms have elapsed, nothing that has to come is late.               *)
\* @type: Int => Bool;
InTime(d) ==
    /\ { c \in DOMAIN waiting :
           waiting[c] + d > terms.latency /\ c < 100 } = {}
    /\ EntriesLate(d) = {}

(* Open requests whose OB could have started and has not started in time. *)
\* @type: Int => Set($request);
Stale(d) ==
    { r \in requests : /\ r.open
                       /\ WaitsAs(r) \in DOMAIN waiting
                       /\ waiting[WaitsAs(r)] + d > terms.latency
                       /\ MayGoOnWaiting(r) }

\* @type: Set($request) => Bool;
Expire(stale) ==
    /\ requests' = Close(requests \ stale)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                   runVars>>
    /\ Rewait
    /\ UNCHANGED up
=============================================================================

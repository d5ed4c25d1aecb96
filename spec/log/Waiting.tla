------------------------------- MODULE Waiting ------------------------------
(***************************************************************************)
(* Latency. In System an OB that may start starts before anything else. A  *)
(* log shows its start up to `latency_ms' later. An OB of a lower class    *)
(* may start before it only while its start event is no older than that    *)
(* (AMB-69).                                                               *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, fine point 1; AMB-69.              *)
(* Left out: requests of one class are not timed apart from each other.    *)
(***************************************************************************)
EXTENDS Requests, ReportedEntries

(* The key under which `waiting' holds a STOP that is due. *)
StopDuty == 99

(* Open requests have keys of their own: their OBs need not come. *)
\* @type: $request => Int;
WaitsAs(r) == IF r.open THEN r.class + 100 ELSE r.class

Awaited == { WaitsAs(r) : r \in { q \in requests : MayStart(q) } }
             \cup (IF StopIsDue THEN {StopDuty} ELSE {})

(* An open request that stands for any number (Widening).                  *)
\* @type: $request => Bool;
Endless(r) == terms.endless # {} /\ AsItCame(r) \in terms.endless

-----------------------------------------------------------------------------
(* Data for later lines *)

(* [OBS-26] OB 1 starts or ends, a restart begins, OB 80 is called since   *)
(* the cycle time is exceeded. A blocked one is not called [IRT-01].       *)
NextCycle ==
    LET restarts == mode = "STOP" /\ mode' = "STARTUP"
        begins   == stack = <<>> /\ OnStack(CycleOb)'
        ends     == OnStack(CycleOb) /\ stack' = <<>>
        exceeded ==
          /\ ~Blocked(TimeErrorOb)
          /\ \E n \in entered' : n.id = ErrorEntry + CycleTimeExceeded
    IN  /\ first' = IF restarts THEN startup'
                    ELSE IF begins THEN "none" ELSE first
        /\ overruns' = IF restarts \/ begins \/ ends THEN 0
                       ELSE IF exceeded THEN Earlier(overruns + 1, 2)
                       ELSE overruns

NextArrivals ==
    arrivals' = IF requests' = {} THEN [r \in {} |-> up]
                ELSE [ r \in { AsItCame(q) : q \in requests' } |->
                         IF r \in DOMAIN arrivals THEN arrivals[r] ELSE up ]

(* Changes that are older than the latency are forgotten.                  *)
NextChanges ==
    changes' = IF clock' = clock THEN changes
               ELSE { c \in changes : Span(c.up, up) <= terms.latency }
                      \cup {[from |-> clock, up |-> up]}

NextEvent == NextCycle /\ NextArrivals /\ NextChanges

(* After a step an OB goes on waiting if it still may start, and begins to *)
(* wait if it now may.                                                     *)
Rewait ==
    /\ NextEvent
    /\ waiting' = IF requests' = {} /\ stopCause' = NoCause
                  THEN [c \in {} |-> 0]
                  ELSE [ c \in Awaited' |->
                           IF c \in DOMAIN waiting THEN waiting[c] ELSE 0 ]
    /\ Report(0)

(* OB 85, or the STOP, has waited as long as the missing OB. *)
\* @type: $request => Bool;
RewaitMissing(r) ==
    LET since == IF WaitsAs(r) \in DOMAIN waiting THEN waiting[WaitsAs(r)]
                                                  ELSE 0
    IN  /\ NextEvent
        /\ waiting' = [ c \in Awaited' |->
                          LET before == IF c \in DOMAIN waiting THEN waiting[c]
                                                                ELSE 0
                          IN  IF c > r.class /\ since > before THEN since
                                                               ELSE before ]
        /\ Report(since)

-----------------------------------------------------------------------------
(* The order of classes *)

(* [AIRT-08] [OBS-03] [AMB-69] A start event that is older than the        *)
(* latency comes before a start event of a lower class.                    *)
\* @type: $request => Bool;
HighestFirst(r) ==
    \A q \in requests :
      /\ q.class > r.class /\ ~q.open /\ MayStart(q)
      => /\ terms.latency > 0 /\ ~NothingStandsBefore
         /\ Span(arrivals[AsItCame(q)], up) <= terms.latency

-----------------------------------------------------------------------------
(* Waiting too long *)

(* In d ms nothing that has to come is late. *)
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
                       /\ MayStart(r) }

\* @type: Set($request) => Bool;
Expire(stale) ==
    /\ requests' = Close(requests \ stale)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                   runVars>>
    /\ Rewait
    /\ UNCHANGED up
=============================================================================

------------------------------- MODULE Waiting ------------------------------
(***************************************************************************)
(* Latency.  In System an OB that may start starts before anything else.   *)
(* A log shows its start up to `latency_ms' later, and inside this window  *)
(* a lower class may start first (AMB-69).                                 *)
(*                                                                         *)
(* Source: docs/log-format.md, fine point 1; AMB-69.                       *)
(* Left out: requests of one class are not timed apart from each other.    *)
(***************************************************************************)
EXTENDS Requests, ReportedEntries

(* The key under which `waiting' holds a STOP that is due. *)
StopDuty == 99

(* An open request has a key of its own: its OB need not come.             *)
\* @type: $request => Int;
WaitsAs(r) == IF r.open THEN r.class + 100 ELSE r.class

Awaited == { WaitsAs(r) : r \in { q \in requests : MayStart(q) } }
             \cup (IF StopIsDue THEN {StopDuty} ELSE {})

(* Something unseen may hold an OB back, so nothing has to come within the *)
(* latency: calls or changes of mode are not recorded, or neither OBs nor  *)
(* start events.                                                           *)
Unbound == \/ ~({"call", "mode"} \subseteq terms.records)
           \/ {"ob", "interrupt"} \cap terms.records = {}

(* OB 1 starts, or a restart begins.                                       *)
NextFirst ==
    first' = IF mode = "STOP" /\ mode' = "STARTUP" THEN startup'
             ELSE IF stack = <<>> /\ OnStack(CycleOb)' THEN "none" ELSE first

(* After a step an OB goes on waiting if it still may start, and begins to *)
(* wait if it now may.                                                     *)
Rewait ==
    /\ NextFirst
    /\ waiting' = IF Unbound \/ (requests' = {} /\ stopCause' = NoCause)
                  THEN [c \in {} |-> 0]
                  ELSE [ c \in Awaited' |->
                           IF c \in DOMAIN waiting THEN waiting[c] ELSE 0 ]
    /\ Report(0)

(* OB 85 or the STOP has waited as long as the missing OB.                 *)
\* @type: $request => Bool;
RewaitMissing(r) ==
    LET since == IF WaitsAs(r) \in DOMAIN waiting THEN waiting[WaitsAs(r)] ELSE 0
    IN  /\ UNCHANGED first
        /\ waiting' = [ c \in Awaited' |->
                          LET before == IF c \in DOMAIN waiting THEN waiting[c]
                                                                ELSE 0
                          IN  IF c > r.class /\ since > before THEN since
                                                               ELSE before ]
        /\ Report(since)

-----------------------------------------------------------------------------
(* Waiting too long *)

(* In d ms everything that has to come can still be in time.               *)
\* @type: Int => Bool;
InTime(d) ==
    /\ { c \in DOMAIN waiting : waiting[c] + d > terms.latency /\ c < 100 } = {}
    /\ EntriesLate(d) = {}

(* Open requests that could have started and have not in time.             *)
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
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, stack,
                   delay, stopCause>>
    /\ Rewait
    /\ UNCHANGED up
=============================================================================

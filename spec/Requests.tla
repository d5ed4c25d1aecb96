------------------------------ MODULE Requests ------------------------------
(***************************************************************************)
(* Start events on their way from occurring to the start of their OB       *)
(* [OBS-07], and the one place that says which of them may start.          *)
(*                                                                         *)
(* A request holds what the OB's start information will say [OBS-10]:      *)
(*   ob, class   which OB, in which priority class                         *)
(*   rank        its place in the queue of its class [OBS-02]; points that *)
(*               fell due at the same moment share a place [AMB-29]        *)
(*   fault       fault id of OB 80 and OB 85, else 0                       *)
(*   since       the moment of the start event; for the catch-up of a      *)
(*               skipped point the first point skipped [CLK-07]            *)
(*   word        PERIOD of a time-of-day interrupt; for OB 80 and OB 85    *)
(*               that of the OB which caused the error                     *)
(*   late        OB 80: the OBs that it reports [CLK-06]                   *)
(*   cause       OB 80 and OB 85: the OB that was requested, else 0        *)
(*   during      OB 85: the OB that was active at the error                *)
(*   follows     fault id of the OB 80 that reports this run and that comes *)
(*               first [TINT-15] [CLK-03], else 0                          *)
(*   open        where the sources leave open whether the start event has  *)
(*               this effect: the OB may start by it, or nothing happens   *)
(*                                                                         *)
(* Left out: the size of the buffers, which differs between CPUs [OBS-09]; *)
(* where a buffer may be full, both outcomes are allowed [AMB-18].         *)
(***************************************************************************)
EXTENDS Cpu

-----------------------------------------------------------------------------
(* Queues; they are functions of the set of requests, not of the state. *)

(* The OB waits for sure. *)
\* @type: (Set($request), Int) => Bool;
PendingIn(q, o) == \E r \in q : r.ob = o /\ ~r.open

(* The OB waits, if at all, by what is left open. *)
\* @type: (Set($request), Int) => Bool;
OpenIn(q, o) == \E r \in q : r.ob = o /\ r.open

(* Start events of points that are reached together, and the time errors    *)
(* of such points, come in any order [AMB-29].                             *)
\* @type: ($request, $request) => Bool;
OfOnePoint(r, s) ==
    /\ r.since = s.since /\ r.follows = s.follows /\ r.fault = s.fault
    /\ \/ r.ob \in TodObs /\ s.ob \in TodObs /\ r.ob # s.ob
       \/ /\ r.ob = TimeErrorOb /\ s.ob = TimeErrorOb
          /\ r.cause \in TodObs /\ s.cause \in TodObs /\ r.cause # s.cause

(* The place of a start event that occurs now. *)
\* @type: (Set($request), $request) => Int;
PlaceIn(q, new) ==
    LET class == { r \in q : r.class = new.class }
        last  == Cardinality({ r.rank : r \in class })
        same  == { r \in class : /\ r.rank = last
                                 /\ OfOnePoint(r, new) }
    IN  IF same = {} THEN last + 1 ELSE last

(* Start events that occur together share a place. *)
\* @type: (Set($request), Set($request)) => Set($request);
EnterAll(q, new) == q \cup { [r EXCEPT !.rank = PlaceIn(q, r)] : r \in new }

\* @type: (Set($request), $request) => Set($request);
Enter(q, new) == EnterAll(q, {new})

(* Places are counted from 1 without gaps. *)
\* @type: Set($request) => Set($request);
Close(q) ==
    { [r EXCEPT !.rank = Cardinality(
          { s.rank : s \in { t \in q : t.class = r.class /\ t.rank <= r.rank } })]
      : r \in q }

(* The request r, next in its queue, leaves.  What was open and was passed  *)
(* over has had no effect.                                                 *)
\* @type: (Set($request), $request) => Set($request);
Remove(q, r) ==
    LET rest == { s \in q : s # r /\ (s.class = r.class => s.rank >= r.rank) }
        gone == IF \E s \in rest : s.class = r.class /\ s.rank = r.rank
                THEN r.rank - 1 ELSE r.rank
    IN  { IF s.class = r.class THEN [s EXCEPT !.rank = @ - gone] ELSE s
          : s \in rest }

\* @type: (Set($request), Int) => Set($request);
Withdraw(q, o) ==
    IF PendingIn(q, o) \/ OpenIn(q, o)
    THEN Close({ r \in q : r.ob # o }) ELSE q

-----------------------------------------------------------------------------
(* Start events *)

\* @type: (Int, $moment, Int) => $request;
TodRequest(o, since, follows) ==
    [ ob |-> o, class |-> ClassOf(o), rank |-> 0, fault |-> 0,
      since |-> since, word |-> tod[o].period, late |-> {}, cause |-> 0,
      during |-> 0, follows |-> follows, open |-> FALSE ]

(* A start event from outside. *)
\* @type: (Int, Int) => $request;
ExternalRequest(o, fault) ==
    [ ob |-> o,
      class |-> IF o \in AsyncErrorObs THEN ErrorClass(o, fault)
                                       ELSE ClassOf(o),
      rank |-> 0, fault |-> fault, since |-> clock, word |-> 0, late |-> {},
      cause |-> 0, during |-> 0, follows |-> 0, open |-> FALSE ]

(* A time error; `cause' is the OB that was requested [AMB-27]. *)
\* @type: (Int, Set(Int), Int, Int) => $request;
TimeError(fault, obs, cause, word) ==
    [ ExternalRequest(TimeErrorOb, fault) EXCEPT
        !.late = obs, !.cause = cause, !.word = word ]

(* [AMB-18] [AMB-77] Where the OB of a start event waits or runs already:   *)
(* it may run again, there may be a time error, still running or buffer    *)
(* overflow, or nothing.                                                   *)
\* @type: ($request, Int) => Set($request);
LeftOpen(again, word) ==
    { [again EXCEPT !.open = TRUE] }
      \cup (IF TimeErrorOb \notin loaded THEN {}
            ELSE { [TimeError(f, {}, again.ob, word) EXCEPT !.open = TRUE]
                   : f \in {StillRunning, BufferOverflow} })

(* Where the OB waits, if at all, by what is open, it waits for sure after  *)
(* another start event: by the first of the open ones, or by the new one if *)
(* they had no effect.  The latter shows only where another OB of the class *)
(* stands between.                                                         *)
\* @type: (Set($request), $request) => Set($request);
Confirmed(q, new) ==
    { IF /\ r.ob = new.ob /\ r.open
         /\ ~\E s \in q : s.ob = r.ob /\ s.open /\ s.rank < r.rank
      THEN [r EXCEPT !.open = FALSE] ELSE r : r \in q }

\* @type: ($request, Int) => Set(Set($request));
EnterAmongOpen(new, word) ==
    { EnterAll(Confirmed(requests, new), LeftOpen(new, word)) }
      \cup (IF \E r, s \in requests : /\ r.ob = new.ob /\ s.ob # new.ob
                                     /\ s.class = r.class /\ s.rank > r.rank
            THEN { Enter(Withdraw(requests, new.ob), new) } ELSE {})

(* [OBS-22] [CLK-05] Without OB 80 a time error stops the CPU, also while   *)
(* interrupts are delayed; whether at once or when the delay ends is left   *)
(* open by AMB-49.                                                          *)
\* @type: (Set($request), $request) => Set($request);
WithTimeError(q, e) == IF TimeErrorOb \in loaded THEN Enter(q, e) ELSE q

StopOfTimeError == IF TimeErrorOb \in loaded \/ stopCause # NoCause
                   THEN stopCause ELSE NoTimeErrorOb

-----------------------------------------------------------------------------
(* Which requests may start: the only statement of priorities and delays.  *)

(* [OBS-42] [OBS-43] [TINT-13] *)
\* @type: $request => Bool;
ModeAllows(r) == \/ mode = "RUN"
                 \/ mode = "STARTUP" /\ r.ob \in AsyncErrorObs

(* [OBS-01] *)
\* @type: $request => Bool;
Preempts(r) == r.class > Running.class

(* [AIRT-01] [AIRT-09] Whatever may interrupt the running OB is delayed. *)
Undelayed == delay = 0

(* [OBS-02] [TINT-12] *)
\* @type: $request => Bool;
InTurn(r) ==
    { q \in requests : q.class = r.class /\ q.rank < r.rank /\ ~q.open } = {}

(* [TINT-15] [CLK-03] A late run comes after the OB 80 that reports it. *)
\* @type: $request => Bool;
Reported(r) ==
    r.follows # 0 => \A q \in requests : ~(q.ob = TimeErrorOb /\ r.ob \in q.late)

\* @type: $request => Bool;
MayStart(r) == /\ ModeAllows(r)
               /\ Undelayed
               /\ Preempts(r)
               /\ InTurn(r)
               /\ Reported(r)
=============================================================================

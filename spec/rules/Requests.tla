------------------------------ MODULE Requests ------------------------------
(***************************************************************************)
(* Requests: start events that have occurred and whose OB has not started  *)
(* [OBS-07]. MayStart is the only rule that says which may start.          *)
(*                                                                         *)
(* A request holds the data of the OB's start information [OBS-10]:        *)
(*   ob, class   which OB, in which priority class                         *)
(*   rank        its place in the queue of its class [OBS-02]; points that *)
(*               fell due at the same moment share a place [AMB-29]        *)
(*   fault       fault id of OB 80 and OB 85, else 0                       *)
(*   since       the moment of the start event; for the catch-up of a      *)
(*               skipped point the first point skipped [CLK-07]            *)
(*   word        PERIOD of a time-of-day interrupt, SIGN of a time-delay   *)
(*               interrupt; for OB 80 and OB 85 that of the OB which       *)
(*               caused the error                                          *)
(*   dtime       DTIME of a time-delay interrupt; for the run of a past    *)
(*               one-shot interrupt the minute of the restart [OBS-56]     *)
(*   late        OB 80: the OBs that it reports [CLK-06]; else the faults  *)
(*               that were reported of its overload [T15-72] [T15-73]        *)
(*   cause       OB 80 and OB 85: the OB that was requested, else 0        *)
(*   during      OB 80 and OB 85: the OB that was active at the error      *)
(*   follows     fault id of the OB 80 that reports this run and runs      *)
(*               before it [TINT-15] [CLK-03], else 0                      *)
(*   open        the sources leave open whether the start event has this   *)
(*               effect: the OB may start by it, or nothing happens        *)
(*                                                                         *)
(* Module StartEvents has the effects of a start event.                    *)
(* Left out: the size of the buffers, which differs between CPUs [OBS-09]. *)
(* If a buffer may be full, both outcomes are allowed [AMB-18].            *)
(***************************************************************************)
EXTENDS FiniteSets, Codes, Cpu, Readings

-----------------------------------------------------------------------------
(* [OBS-42] [OBS-43] [TINT-13] After a hot restart an error from before    *)
(* the STOP waits for RUN.                                                 *)
\* @type: $request => Bool;
ModeAllows(r) == \/ mode = "RUN"
                 \/ mode = "STARTUP" /\ r.ob \in AsyncErrorObs
                      /\ (startup \in {"hot", "resuming"} => r.class > 27)
                      /\ r.ob \notin Family.heldBack  \* [T15-117]
                 \/ mode = "STARTUP" /\ r.ob \in SyncErrorObs

-----------------------------------------------------------------------------
(* Queues *)

(* The OB is definitely pending. *)
\* @type: (Set($request), Int) => Bool;
PendingIn(q, o) == \E r \in q : r.ob = o /\ ~r.open

(* The OB may wait: it has an open request. *)
\* @type: (Set($request), Int) => Bool;
OpenIn(q, o) == \E r \in q : r.ob = o /\ r.open

(* [AMB-29] A past one-shot interrupt of STEP 7 is due at the restart      *)
(* [OBS-56], together with a point that equals the clock then.             *)
\* @type: ($request, $request) => Bool;
DueAtRestart(r, s) == /\ {r.ob, s.ob} \subseteq TodObs
                      /\ r.dtime # 0 /\ r.dtime = s.since.min

(* Points that are reached together lead to start events, and to time      *)
(* errors, in any order [AMB-29].                                          *)
\* @type: ($request, $request) => Bool;
OfOnePoint(r, s) ==
    /\ r.since = s.since \/ DueAtRestart(r, s)
    /\ r.follows = s.follows /\ r.fault = s.fault
    /\ \/ /\ r.ob \in TodObs \cup DintObs /\ s.ob \in TodObs \cup DintObs
          /\ r.ob # s.ob
       \/ /\ r.ob = TimeErrorOb /\ s.ob = TimeErrorOb
          /\ r.cause \in TodObs /\ s.cause \in TodObs /\ r.cause # s.cause

(* The place of a start event that occurs now. It shares no place with an  *)
(* earlier one of its OB, or of its OB 80 for the same cause.              *)
\* @type: (Set($request), $request) => Int;
PlaceIn(q, new) ==
    LET class  == { r \in q : r.class = new.class }
        last   == Cardinality({ r.rank : r \in class })
        beside == { r \in class : r.rank = last }
    IN  IF /\ \E r \in beside : OfOnePoint(r, new)
           /\ \A r \in beside :
                r.ob = new.ob => r.ob = TimeErrorOb /\ r.cause # new.cause
        THEN last ELSE last + 1

(* Start events that occur together share a place. *)
\* @type: (Set($request), Set($request)) => Set($request);
EnterAll(q, new) == q \cup { [r EXCEPT !.rank = PlaceIn(q, r)] : r \in new }

\* @type: (Set($request), $request) => Set($request);
Enter(q, new) == EnterAll(q, {new})

(* Places are counted from 1 without gaps. A mark of a log that leaves     *)
(* kinds out has no class and no place (LooseLogs).                        *)
\* @type: Set($request) => Set($request);
Close(q) ==
    { IF r.class = 0 THEN r
      ELSE [ r EXCEPT !.rank = Cardinality(
             { s.rank :
               s \in { t \in q : t.class = r.class /\ t.rank <= r.rank } }) ]
      : r \in q }

(* Request r leaves its queue. The open requests before it had no effect:  *)
(* they go as well, unless the mode alone held them back.                  *)
\* @type: (Set($request), $request) => Set($request);
Remove(q, r) ==
    LET \* @type: $request => Bool;
        passed(s) == s.class = r.class /\ s.rank < r.rank
        rest == { s \in q : s # r /\ ~(passed(s) /\ s.open /\ ModeAllows(s)) }
        gone == IF \E s \in rest : s.class = r.class /\ s.rank = r.rank
                THEN r.rank - 1 ELSE r.rank
    IN  IF \E s \in rest : passed(s) THEN Close(rest)
        ELSE { IF s.class = r.class THEN [s EXCEPT !.rank = @ - gone] ELSE s
               : s \in rest }

\* @type: (Set($request), Int) => Set($request);
Withdraw(q, o) ==
    IF PendingIn(q, o) \/ OpenIn(q, o)
    THEN Close({ r \in q : r.ob # o }) ELSE q

-----------------------------------------------------------------------------
(* Requests of each kind *)

(* [TINT-25] The PERIOD that the CPU tells. *)
\* @type: Int => Int;
ShownPeriod(period) == IF period = MonthlyOrLast THEN Monthly ELSE period

NoRequest ==
    [ ob |-> 0, class |-> 0, rank |-> 0, fault |-> 0,
      since |-> [min |-> 0, ms |-> 0], word |-> 0, dtime |-> 0, late |-> {},
      cause |-> 0, during |-> 0, follows |-> 0, open |-> FALSE ]

\* @type: (Int, $moment, Int) => $request;
TodRequest(o, since, follows) ==
    [ NoRequest EXCEPT !.ob = o, !.class = ClassOf(o), !.since = since,
                       !.word = ShownPeriod(tod[o].period),
                       !.follows = follows ]

(* [DINT-03] The start information repeats DTIME and SIGN; under AMB-31    *)
(* (a) it has the delay that has elapsed.                                  *)
\* @type: Int => $request;
DintRequest(o) ==
    [ NoRequest EXCEPT
        !.ob = o, !.class = ClassOf(o), !.since = clock, !.word = dint[o].sign,
        !.dtime = dint[o].dtime
                    - (IF DtimeIsElapsedTime THEN dint[o].left ELSE 0) ]

(* A run for a point that was skipped. *)
\* @type: $request => Bool;
IsCatchUp(r) == r.follows \in Skips \cup LocalSkips

(* [OBS-43] [OBS-31] [AMB-13] The class of the start event of an           *)
(* asynchronous error, in STARTUP or not.                                  *)
\* @type: (Int, Int, Bool) => Int;
ErrorClassIn(o, fault, inStartup) ==
    IF ~Family.raises THEN ClassOf(o)  \* [T15-61] [T15-62]
    ELSE IF o = TimeErrorOb
    THEN IF \/ inStartup /\ Class28InStartup
            \/ fault = BufferOverflow /\ Class28OnOverflow
         THEN 28 ELSE 26
    ELSE IF inStartup THEN 28 ELSE ClassOf(o)

\* @type: (Int, Int) => Int;
ErrorClass(o, fault) == ErrorClassIn(o, fault, mode = "STARTUP")

(* [AMB-88] The class in RUN of an error that came in STARTUP. *)
\* @type: $request => Int;
ClassInRun(r) == ErrorClassIn(r.ob, r.fault, FALSE)

(* These errors join the queues of their classes in RUN, at the end. *)
\* @type: (Set($request), Set($request)) => Set($request);
WithClassInRun(q, errors) ==
    Close((q \ errors)
            \cup { [ r EXCEPT !.class = ClassInRun(r),
                              !.rank = @ + Cardinality(q) ] : r \in errors })

(* [AMB-88] [OBS-31] What waits when STARTUP leads to RUN. *)
\* @type: Set($request) => Set(Set($request));
RequestsInRun(q) ==
    LET errors == { r \in q : /\ r.ob \in AsyncErrorObs
                              /\ r.class # ClassInRun(r) }
    IN  IF errors = {} \/ ErrorKeepsItsClass THEN {q}
        ELSE { WithClassInRun(q, some)
               : some \in IF ErrorTakesClassOfRun THEN {errors}
                          ELSE SUBSET errors }

(* A start event from outside. *)
\* @type: (Int, Int) => $request;
ExternalRequest(o, fault) ==
    [ NoRequest EXCEPT !.ob = o, !.fault = fault, !.since = clock,
                       !.during = IF fault = CycleTimeExceeded
                                  THEN Running.ob ELSE 0,
                       !.class = IF o \in AsyncErrorObs
                                 THEN ErrorClass(o, fault) ELSE ClassOf(o) ]

(* A time error. `cause' is the requested OB [AMB-27]. *)
\* @type: (Int, Set(Int), Int, Int) => $request;
TimeError(fault, obs, cause, word) ==
    [ ExternalRequest(TimeErrorOb, fault) EXCEPT
        !.late = obs, !.cause = cause, !.word = word, !.during = Running.ob ]

-----------------------------------------------------------------------------
(* Which requests may start: the only statement of priorities and delays.  *)

(* [OBS-01] *)
\* @type: $request => Bool;
Preempts(r) == r.class > Running.class

(* [OBS-23] [AMB-75] Asynchronous errors without their OB. *)
ErrorObsNotMissed ==
    IF ErrorObsAreNotReported THEN {70, 72, 81, 84, 87} ELSE {81}
ErrorObsAs85 ==
    IF ErrorObsAreNotReported THEN {} ELSE {70, 72, 84, 87}
ErrorObsThatStop == {82, 83, 84, 86} \ ErrorObsAs85
(* [OBS-20] The OBs of start events from outside for which OB 85 comes.    *)
ExternalObsAs85 == (ExternalObs \ (AsyncErrorObs \cup {70, 72}))
                     \cup ErrorObsAs85

(* [AIRT-01] [AIRT-09] No delay is on. A delay holds back every OB that    *)
(* could interrupt the running OB.                                         *)
Undelayed == delay = 0

(* [OBS-21] [OBS-22] [OBS-23] An error whose missing OB stops the CPU.     *)
\* @type: $request => Bool;
StopsTheCpu(r) ==
    /\ r.ob \notin loaded /\ Family.stops
    /\ r.ob \in ErrorObsThatStop \cup {TimeErrorOb, ProgramErrorOb}

(* [AMB-49] (a) A delay does not hold it back.                             *)
\* @type: $request => Bool;
StopsUndelayed(r) == StopsTheCpu(r) /\ StopIsNotDelayed

(* [AMB-87] (a) Neither does an OB that runs or waits, if it is OB 85.     *)
\* @type: $request => Bool;
StopsUncalled(r) ==
    /\ r.ob = ProgramErrorOb /\ StopsTheCpu(r) /\ MissingOb85StopsAtOnce
    /\ Undelayed \/ StopIsNotDelayed

(* [TINT-15] [CLK-03] [T15-91] A run comes after the OB 80 that reports    *)
(* it. On an S7-1500 the class of the run may be the higher one.           *)
\* @type: $request => Bool;
Reported(r) ==
    r.follows # 0 =>
      /\ \A q \in requests :
           ~(/\ q.ob = TimeErrorOb /\ q.fault = r.follows
             /\ r.ob \in q.late)
      /\ ~InTimeErrorOb

(* [OBS-01] [T15-91] Then it cannot start, and what is not below OB 80     *)
(* must not wait for OB 80 on its account.                                 *)
\* @type: $request => Bool;
AwaitsLowerOb80(r) == ~Reported(r) /\ r.class >= ClassOf(TimeErrorOb)

(* [OBS-02] [TINT-12] The requests that may hold others back: no open ones *)
(* and none that the mode or a lower OB 80 holds back.                     *)
Definite == { q \in requests :
                ~q.open /\ ModeAllows(q) /\ ~AwaitsLowerOb80(q) }

(* [OBS-02] [TINT-12] No request before it holds it back. Within a place   *)
(* the numbers of the OBs may decide [AMB-29].                             *)
\* @type: $request => Bool;
InTurn(r) ==
    { q \in Definite :
        /\ q.class = r.class
        /\ \/ q.rank < r.rank
           \/ q.rank = r.rank /\ q.ob < r.ob /\ PointsComeByNumber } = {}

(* [AMB-44] (a) A missing OB is noticed although it could not start; not   *)
(* OB 85 itself [AMB-87].                                                  *)
\* @type: $request => Bool;
NoticedAtOnce(r) == /\ r.ob \notin loaded \cup {ProgramErrorOb}
                    /\ MissingNoticedWhenDue

(* Nothing but the mode or a delay holds the OB back. *)
\* @type: $request => Bool;
Foremost(r) == /\ Preempts(r)
               /\ InTurn(r)
               /\ Reported(r)

\* @type: $request => Bool;
MayStart(r) == /\ ModeAllows(r)
               /\ \/ /\ Undelayed \/ StopsUndelayed(r)
                     /\ Foremost(r)
                  \/ StopsUncalled(r) \/ NoticedAtOnce(r)

(* A missing OB is noticed when it would start. If it stops the CPU,       *)
(* perhaps before that: [AMB-49] at once under a delay, whatever runs or   *)
(* waits; [AMB-87] OB 85 at any time.                                      *)
\* @type: $request => Bool;
MayBeMissed(r) ==
    LET atAnyTime == r.ob = ProgramErrorOb /\ ~MissingOb85StopsInTurn
    IN  /\ r.ob \notin loaded
        /\ \/ MayStart(r)
           \/ /\ StopsTheCpu(r) /\ ModeAllows(r)
              /\ IF Undelayed THEN atAnyTime
                 ELSE /\ ~StopAwaitsTheDelay
                      /\ atAnyTime \/ Foremost(r) \/ r.ob # ProgramErrorOb

(* [AMB-49] A STOP by rule may wait for the end of a delay, but not that   *)
(* of a synchronous error [OBS-63].                                        *)
StopIsDue == /\ stopCause # NoCause
             /\ \/ Undelayed \/ StopIsNotDelayed
                \/ stopCause \in CausesOfSyncErrors
=============================================================================

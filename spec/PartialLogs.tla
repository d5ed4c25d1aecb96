----------------------------- MODULE PartialLogs ----------------------------
(***************************************************************************)
(* Logs that leave kinds of event out (`records' of the header): an event  *)
(* of such a kind may happen unseen at any point.                          *)
(*                                                                         *)
(* Unseen OBs and modes are the actions of the specification, tried at     *)
(* every point.  Unseen loading is tried just before a line that it may    *)
(* explain.  Unseen calls and start events cannot be enumerated: whatever  *)
(* they may have led to is accepted.                                       *)
(*                                                                         *)
(* The trace checker's engine evaluates Elapse, Silent and Observe, of     *)
(* complete logs as well.                                                  *)
(* Source: docs/checking/log-format.md, fine point 9.                      *)
(* Left out: several changes of the clock between two lines; a block that  *)
(* is loaded or deleted without effect on the next line; an unseen start   *)
(* event whose OB was blocked afterwards.                                  *)
(***************************************************************************)
EXTENDS UnseenCalls

-----------------------------------------------------------------------------
(* OBs and modes *)

UnseenOb == \/ \E r \in requests : Start(r)
            \/ stack # <<>> /\ End(Running.ob)

UnseenMode == \/ \E type \in {"warm", "cold"} : Restart(type)
              \/ Run /\ stopCause = NoCause
              \/ Stop \/ Hold \/ Release

-----------------------------------------------------------------------------
(* Blocks that are loaded or deleted *)

(* The OBs on which the line depends. *)
\* @type: $event => Set(Int);
DependsOn(e) ==
    CASE e.event = "start"  ->
           {e.ob} \cup (IF e.ob = ProgramErrorOb THEN { r.ob : r \in requests }
                        ELSE {})
      [] e.event \in {"QRY_TINT", "QRY_DINT", "state"} -> {e.ob}
      [] e.event \in {"stop", "diag"} ->
           { r.ob : r \in requests } \cup {TimeErrorOb, ProgramErrorOb}
      [] e.event = "run"    -> StartupObs
      [] OTHER              -> {}

\* @type: $event => Bool;
UnseenLoad(e) ==
    \E o \in DependsOn(e) :
      LoadedAre(IF o \in loaded THEN loaded \ {o} ELSE loaded \cup {o})

-----------------------------------------------------------------------------
(* Start events that no line shows *)

(* The fault that a start of OB 80 or OB 85 tells, or the unknown one. *)
\* @type: $event => Int;
ToldFault(e) == IF e.info.flt_id # -1 THEN e.info.flt_id ELSE UnknownFault

(* The requests by which the OB of a start line may start: a call, a start *)
(* event from outside, or an error that follows one.  Their unknown fields *)
(* fit every line.                                                         *)
\* @type: $event => Set($request);
MayHaveOccurred(e) ==
    LET f == ToldFault(e)
        known == [ NoRequest EXCEPT !.ob = e.ob, !.word = -1, !.dtime = -1,
                                    !.during = -1, !.class = ClassOf(e.ob) ]
        error == [known EXCEPT !.fault = f, !.class = ErrorClass(e.ob, f)]
        overlap == f \in {UnknownFault, StillRunning, BufferOverflow}
        missing == f \in {UnknownFault} \cup ObNotLoaded
    IN  CASE e.ob \in {TimeErrorOb, ProgramErrorOb} ->
               (IF Unseen("interrupt") /\ f \notin Skips THEN {error} ELSE {})
                 \cup (IF ~Unseen("call") THEN {}
                       ELSE { [error EXCEPT !.cause = o]
                              : o \in IF e.ob = TimeErrorOb
                                      THEN IF overlap THEN SetByCalls ELSE {}
                                      ELSE IF missing THEN SetAndAbsent ELSE {} })
          [] e.ob \in AsyncErrorObs ->
               IF Unseen("interrupt") THEN {[known EXCEPT !.class = error.class]} ELSE {}
          [] e.ob \in ExternalObs -> IF Unseen("interrupt") THEN {known} ELSE {}
          [] e.ob \in SetByCalls  -> IF Unseen("call") THEN {known} ELSE {}
          [] OTHER                -> {}

\* @type: $event => Bool;
StartsUnseen(e) ==
    \E r \in { q \in MayHaveOccurred(e) : FitsRequest(q, e) } :
      /\ ModeAllows(r) /\ Undelayed /\ Preempts(r)
      /\ r.ob \in loaded /\ ~Idle(r.ob)
      /\ e.ob \in TodObs => e.info.period \in {-1} \cup PeriodCodes
      /\ e.ob \in DintObs => e.info.dtime \in {-1} \cup DelayTimes
      /\ stack' = Append(stack, Frame(r.ob, r.class))
      /\ NothingEntered
      /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, requests,
                     delay, stopCause>>

(* An unseen event may have caused this entry.                             *)
\* @type: $event => Bool;
EntersUnseen(e) ==
    /\ e.id - ErrorEntry \in ObNotLoaded =>
         Unseen("interrupt") \/ SetAndAbsent # {}
    /\ e.id = NoTimeErrorOb => TimeErrorOb \notin loaded \/ Unseen("load")
    /\ e.id = NoProgramErrorOb => ProgramErrorOb \notin loaded \/ Unseen("load")
    /\ NothingEntered
    /\ UNCHANGED <<cpuVars, waiting, eventVars, reports>>

\* @type: $event => Bool;
ShowsPartly(e) ==
    \/ IF Unseen("call") /\ e.event \in CallEvents THEN FALSE
       ELSE Shows(e)
    \/ /\ Unseen("call")
       /\ IF e.event \in CallEvents THEN SomeCall(e) ELSE SkipsByCall(e)
       /\ Rewait
       /\ UNCHANGED <<terms, up>>
    \/ /\ e.event = "start"
       /\ StartsUnseen(e)
       /\ Rewait
       /\ UNCHANGED <<terms, up>>
    \/ /\ e.event = "diag" /\ CauseUnseen(e.id)
       /\ EntersUnseen(e)
       /\ UNCHANGED <<terms, up>>

-----------------------------------------------------------------------------
(* The clock *)

(* The clock at the line, if nobody has set it.                            *)
\* @type: $event => $moment;
Undisturbed(e) == Shifted(clock, up, e.up)

(* Two clocks may differ by a millisecond. *)
\* @type: $event => Bool;
Jumps(e) == /\ Unseen("clock")
            /\ e.at # Undisturbed(e)
            /\ After(e.at, 1) # Undisturbed(e) /\ After(Undisturbed(e), 1) # e.at

\* @type: $event => Bool;
UnseenClock(e) == ClockSet(Shifted(e.at, e.up, up))

-----------------------------------------------------------------------------
(* The operators of the trace checker's engine *)

\* @type: $event => Bool;
Elapse(e) ==
    IF ~Partial THEN Towards(e)
    ELSE \/ IF ~Jumps(e) THEN Towards(e)
            ELSE up # e.up /\ Towards([e EXCEPT !.at = Undisturbed(e)])
         \/ /\ \/ Jumps(e) /\ UnseenClock(e)
               \/ Unseen("ob") /\ UnseenOb
               \/ Unseen("mode") /\ UnseenMode
            /\ Rewait
            /\ UNCHANGED <<lineVars, up>>

\* @type: $event => Bool;
Silent(e) ==
    \/ HiddenBefore(e)
    \/ /\ Partial
       /\ \/ Unseen("ob") /\ UnseenOb
          \/ Unseen("mode") /\ UnseenMode
          \/ Unseen("load") /\ UnseenLoad(e)
          \/ Unseen("call") /\ UnseenCall(e)
       /\ Rewait
       /\ UNCHANGED <<lineVars, up>>

(* Cheap to evaluate: may a silent step be possible? *)
\* @type: $event => Bool;
Stirs(e) == HidesBefore(e) \/ Partial

\* @type: $event => Bool;
Observe(e) == /\ KeepsPace(e)
              /\ IF Partial THEN ShowsPartly(e) ELSE Shows(e)
              /\ NextPace(e)

Next == Silent(NoEvent)
=============================================================================

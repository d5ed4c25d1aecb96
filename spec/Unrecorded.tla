----------------------------- MODULE Unrecorded -----------------------------
(***************************************************************************)
(* Logs that leave kinds of event out (`records' of the header): what is   *)
(* not recorded may happen unseen at any point.                            *)
(*                                                                         *)
(* OBs and modes that change unseen are the actions of the specification,  *)
(* tried at every point; blocks that are loaded or deleted are tried just  *)
(* before a line that they may explain.  Where calls are not recorded,     *)
(* what the program has set is unknown, as start events are where those    *)
(* from outside are not; then what holds whatever it was is judged: modes, *)
(* classes, loaded OBs, fault ids and their causes.                        *)
(*                                                                         *)
(* Left out: several changes of the clock between two lines; a block that  *)
(* is loaded or deleted without effect on the next line; a start event     *)
(* from outside that came unseen before its OB was blocked.                *)
(* Source: docs/log-format.md, `records'.                                  *)
(***************************************************************************)
EXTENDS Trace

(* Whether lines of this kind may be missing. *)
\* @type: Str => Bool;
Unseen(kind) == kind \notin terms.records

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
      [] e.event \in {"QRY_TINT", "QRY_DINT"} -> {e.ob}
      [] e.event \in {"stop", "diag"} ->
           { r.ob : r \in requests } \cup {TimeErrorOb, ProgramErrorOb}
      [] e.event = "run"    -> StartupObs
      [] OTHER              -> {}

\* @type: $event => Bool;
UnseenLoad(e) ==
    \E o \in DependsOn(e) :
      LoadedAre(IF o \in loaded THEN loaded \ {o} ELSE loaded \cup {o})

-----------------------------------------------------------------------------
(* Calls *)

(* What waits may have been cancelled, and a STOP blocked. *)
\* @type: $event => Bool;
UnseenCall(e) ==
    /\ e.event \in {"start", "run", "stop"}
    /\ \/ \E r \in requests : /\ requests' = Close(requests \ {r})
                              /\ UNCHANGED stopCause
       \/ /\ stopCause \notin {NoCause, DeselectedLoaded}
          /\ stopCause' = NoCause
          /\ UNCHANGED requests
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, stack, delay>>

(* Interrupts that the program may have set or started, and those of them   *)
(* whose OB is missing.                                                    *)
SetByCalls == { o \in TodObs \cup DintObs : ~Deselected(o) }
SetAndAbsent == IF Unseen("load") THEN SetByCalls ELSE SetByCalls \ loaded

(* [TINT-11] A point, a whole minute, from now on and before t.             *)
\* @type: $moment => Bool;
PassesMinute(t) ==
    Before(IF SecondsAreKept THEN clock
           ELSE At(IF clock.ms = 0 THEN clock.min ELSE clock.min + 1), t)

(* A clock set forward, or a HOLD, may have passed points that a call set.   *)
\* @type: $event => Bool;
SkipsByCall(e) ==
    LET held  == e.event = "release"
        to    == IF held THEN clock ELSE e.to
        fault == IF held THEN SkippedInHold ELSE SkippedByClock
        error == [TimeError(fault, {}, 0, 0) EXCEPT !.since = to, !.open = TRUE]
    IN  /\ \/ held /\ mode = "HOLD"
           \/ e.event = "clock" /\ PassesMinute(to) /\ mode # "STOP"
        /\ mode'  = IF held THEN "RUN" ELSE mode
        /\ clock' = to
        /\ tod'   = Rearmed(to, FALSE)
        /\ requests'  = IF TimeErrorOb \in loaded THEN Enter(requests, error)
                        ELSE requests
        /\ stopCause' = IF TimeErrorOb \in loaded THEN stopCause
                        ELSE StopFor(NoTimeErrorOb)
        /\ entered'   = OpenEntries({error})
        /\ UNCHANGED <<cpu, loaded, startup, dint, irt, stack, delay>>

(* The answers that some setting allows; wrong operands are wrong whatever   *)
(* is set.                                                                 *)
\* @type: $event => Set(Int);
PossibleAnswers(e) ==
    LET tod1  == Answers(e.ob, ObErrors(e.ob))
        dint1 == Answers(e.ob, DintErrors(e.ob))
        ifSet(answers, more) == IF OK \in answers THEN answers \cup more ELSE answers
    IN  CASE e.event = "SET_TINT" -> Answers(e.ob, SetErrors(e.ob, e.sdt, e.period))
          [] e.event = "CAN_TINT" -> ifSet(tod1, {NotSet})
          [] e.event = "ACT_TINT" -> ifSet(tod1, {NotSet, PastStart})
          [] e.event = "QRY_TINT" -> tod1
          [] e.event = "SRT_DINT" -> Answers(e.ob, SrtErrors(e.ob, e.dtime))
          [] e.event = "CAN_DINT" -> ifSet(dint1, {NotStarted})
          [] e.event = "QRY_DINT" -> dint1
          [] e.event = "DIS_IRT"  -> Usual(IrtErrors(e.mode, e.ob, DisModes))
          [] e.event = "EN_IRT"   -> Usual(IrtErrors(e.mode, e.ob, EnModes))
          [] e.event = "DIS_AIRT" -> 1..32767
          [] OTHER                -> (0..32767) \cup {NotDelayed}

(* Bits 1 and 2 of STATUS depend on calls. *)
\* @type: Int => Set(Int);
PossibleStatuses(o) ==
    { s + blocked : s \in StatusWithBit2(o, {0, 4}), blocked \in {0, 2} }

CallEvents == {"SET_TINT", "CAN_TINT", "ACT_TINT", "QRY_TINT", "SRT_DINT",
               "CAN_DINT", "QRY_DINT", "DIS_IRT", "EN_IRT", "DIS_AIRT", "EN_AIRT"}

(* What a call sets is not noted: another may have changed it unseen. *)
\* @type: $event => Bool;
SomeCall(e) ==
    /\ Called
    /\ e.ret = -1 \/ e.ret \in PossibleAnswers(e)
    /\ e.ret = OK /\ e.status # -1 => e.status \in PossibleStatuses(e.ob)
    /\ NothingEntered
    /\ UNCHANGED cpuVars

-----------------------------------------------------------------------------
(* Start events that no line shows *)

(* The fault that a start of OB 80 or OB 85 tells, or the unknown one. *)
\* @type: $event => Int;
ToldFault(e) == IF e.info.flt_id # -1 THEN e.info.flt_id ELSE UnknownFault

(* What may have led to the start of an OB: a call, a start event from       *)
(* outside, or an error that follows one.  What is not known of it fits    *)
(* whatever the line says.                                                 *)
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
    \E r \in { q \in MayHaveOccurred(e) : FitsRequest(q, e.info) } :
      /\ ModeAllows(r) /\ Undelayed /\ Preempts(r)
      /\ r.ob \in loaded /\ ~Idle(r.ob)
      /\ e.ob \in TodObs => e.info.period \in {-1} \cup PeriodCodes
      /\ e.ob \in DintObs => e.info.dtime \in {-1} \cup DelayTimes
      /\ stack' = Append(stack, Frame(r.ob, r.class))
      /\ NothingEntered
      /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, requests,
                     delay, stopCause>>

(* An entry whose cause may be unseen. *)
\* @type: $event => Bool;
EntersUnseen(e) ==
    /\ e.id - ErrorEntry \in ObNotLoaded =>
         Unseen("interrupt") \/ SetAndAbsent # {}
    /\ e.id = NoTimeErrorOb => TimeErrorOb \notin loaded \/ Unseen("load")
    /\ e.id = NoProgramErrorOb => ProgramErrorOb \notin loaded \/ Unseen("load")
    /\ NothingEntered
    /\ UNCHANGED <<cpuVars, waiting, first, reports>>

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

(* What the clock would show at the line, had it not been set.  Readings of  *)
(* two clocks may differ by a millisecond.                                 *)
\* @type: $event => $moment;
Undisturbed(e) == Shifted(clock, up, e.up)

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
            /\ UNCHANGED <<terms, up>>

\* @type: $event => Bool;
Silent(e) ==
    \/ HiddenBefore(e)
    \/ /\ Partial
       /\ \/ Unseen("ob") /\ UnseenOb
          \/ Unseen("mode") /\ UnseenMode
          \/ Unseen("load") /\ UnseenLoad(e)
          \/ Unseen("call") /\ UnseenCall(e)
       /\ Rewait
       /\ UNCHANGED <<terms, up>>

(* Cheap to evaluate: may a silent step be possible? *)
\* @type: $event => Bool;
Stirs(e) == HidesBefore(e) \/ Partial

\* @type: $event => Bool;
Observe(e) == IF Partial THEN ShowsPartly(e) ELSE Shows(e)

Next == Silent(NoEvent)
=============================================================================
